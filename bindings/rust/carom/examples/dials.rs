//! Dials: a pendulum of a preset for crowds, and the same with one dial turned.
use carom::{raw, BodyDesc, Engine, JointDesc, Result};

/// m, after 2 s; where the ball should be follows from the equation of motion.
fn error(dials: &[(u32, f64)]) -> Result<f64> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.set_preset(raw::CAROM_PRESET_FAST)?;
    for &(dial, value) in dials {
        world.set_dial(dial, value)?;
    }
    let sphere = engine.shape("sphere", &[0.1])?;
    let ball = world.body(sphere, &BodyDesc { position: [1.0, 0.0, 0.0], ..Default::default() })?;
    let fields = raw::CAROM_JOINT_WORLD_FRAME; // at the origin
    world.joint(&JointDesc { kind: raw::CAROM_JOINT_BALL, fields, body_b: ball, ..Default::default() })?;
    for _ in 0..120 {
        world.step(1.0 / 60.0)?;
    }
    Ok((world.position(ball)?[0] - 0.7850683).abs())
}

fn main() -> Result<()> {
    let (substeps, order) = ((raw::CAROM_DIAL_SUBSTEPS, 8.0), (raw::CAROM_DIAL_JOINT_ORDER, 4.0));
    let (fast, finer, exact) = (error(&[])?, error(&[substeps])?, error(&[substeps, order])?);
    let word = if exact < 1e-6 { "yes" } else { "no" };
    let (rough, better) = (1e3 * fast, 1e3 * finer);
    println!("off by {rough:.2} mm; with 8 substeps by {better:.3} mm; of order 4 by less than 1 um: {word}");
    assert!(fast > 1e-3 && 1e-3 > 10.0 * finer && exact < 1e-6);
    Ok(())
}

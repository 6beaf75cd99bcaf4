//! An accuracy that is asked for: a pendulum is off by no more than a micrometre per second of motion.
use carom::{raw, BodyDesc, Engine, JointDesc, Result};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let sphere = engine.shape("sphere", &[0.1])?;
    let ball = world.body(sphere, &BodyDesc { position: [1.0, 0.0, 0.0], ..Default::default() })?;
    world.joint(&JointDesc {
        kind: raw::CAROM_JOINT_BALL,
        fields: raw::CAROM_JOINT_WORLD_FRAME, // at the origin
        body_b: ball,
        ..Default::default()
    })?;
    let asked = raw::carom_accuracy { place: 1e-6, turn: 1e-6, ..Default::default() }; // m and rad per second
    world.set_accuracy(Some(&asked))?;
    for _ in 0..120 {
        world.step(1.0 / 60.0)?;
    }
    let islands = world.islands()?;
    let x = world.position(ball)?[0];
    let within = islands.len() == 1 && islands[0].share <= 1.0;
    let word = if within { "yes" } else { "no" };
    println!("after 2 s at x = {x:.5} m; the error is within what was asked: {word}");
    assert!(within && (x - 0.785070).abs() < 5e-6); // by its equation of motion
    Ok(())
}

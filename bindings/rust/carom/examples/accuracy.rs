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
    world.call(|p, e| unsafe { raw::carom_world_set_accuracy(p, &asked, e) })?;
    for _ in 0..120 {
        world.step(1.0 / 60.0)?;
    }
    let (mut worst, mut islands): (raw::carom_island, u64) = unsafe { std::mem::zeroed() };
    let stride = std::mem::size_of_val(&worst) as u64;
    world.call(|p, e| unsafe { raw::carom_world_get_islands(p, &mut worst, stride, 1, &mut islands, e) })?;
    let x = world.position(ball)?[0];
    let within = islands == 1 && worst.share <= 1.0;
    let word = if within { "yes" } else { "no" };
    println!("after 2 s at x = {x:.5} m; the error is within what was asked: {word}");
    assert!(within && (x - 0.785070).abs() < 5e-6); // by its equation of motion
    Ok(())
}

//! Joints and a motor: a motor turns a hinge at 1 rad/s, and a limit stops it at 1 rad.
use carom::{raw, BodyDesc, Engine, JointDesc, Result};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let shape = engine.shape("box", &[0.5, 0.05, 0.05])?;
    let rod = world.body(shape, &BodyDesc { position: [0.5, 0.0, 0.0], ..Default::default() })?;
    let half = 0.5_f64.sqrt();
    let hinge = world.joint(&JointDesc {
        kind: raw::CAROM_JOINT_HINGE,
        fields: raw::CAROM_JOINT_WORLD_FRAME, // at the origin
        body_b: rod,
        orientation_a: [0.0, -half, 0.0, half], // its x axis is the world's z axis
        ..Default::default()
    })?;
    let twist = raw::CAROM_COORDINATE_TWIST;
    let motor = raw::carom_joint_motor { enabled: 1, speed: 1.0, max_force: 200.0, ..Default::default() }; // rad/s, N m
    world.joint_set_motor(hinge, twist, &motor)?;
    let limit = raw::carom_joint_limit { enabled: 1, lower: -1.0, upper: 1.0, ..Default::default() }; // rad
    world.joint_set_limit(hinge, twist, &limit)?;
    let mut angle = Vec::new();
    for steps in [30, 120] {
        for _ in 0..steps {
            world.step(1.0 / 60.0)?;
        }
        angle.push(world.joint_state(hinge)?.coordinate[twist as usize]);
    }
    println!("{:.2} rad after 0.5 s, {:.2} rad after 2.5 s, at the limit", angle[0], angle[1]);
    assert!((angle[0] - 0.5).abs() < 0.02 && (angle[1] - 1.0).abs() < 0.01);
    Ok(())
}

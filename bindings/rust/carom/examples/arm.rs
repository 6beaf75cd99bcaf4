//! A robot's arm by inverse dynamics: two links of 2 kg move to a pose and stay there, against gravity.
use carom::{raw, Body, BodyDesc, Engine, Joint, JointDesc, Result, World};

/// A number for each joint.
fn read(world: &World, field: u32, joints: &[Joint]) -> Result<[f64; 2]> {
    let mut out = [[0.0]; 2];
    world.read_joints(field, Some(joints), &mut out)?;
    Ok(out.map(|[number]| number))
}

/// Inverse dynamics, against gravity.
fn forces(world: &World, arm: Body, speeds: [f64; 2], accelerations: [f64; 2]) -> Result<[f64; 2]> {
    let mut out = [0.0; 2];
    world.tree_forces(arm, Some(&speeds), Some(&accelerations), &mut out)?;
    Ok(out)
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let (rod, half) = (engine.shape("box", &[0.5, 0.05, 0.05])?, 0.5_f64.sqrt());
    let (mut link, mut joints) = (Body::default(), Vec::new());
    for i in 0..2 {
        // Links along x, hinges about z.
        let mut desc = BodyDesc { position: [f64::from(i) + 0.5, 0.0, 0.0], mass: 2.0, ..Default::default() };
        desc.fields = raw::CAROM_BODY_FIELD_MASS | raw::CAROM_BODY_FIELD_CENTER | raw::CAROM_BODY_FIELD_INERTIA;
        desc.inertia = [0.01, 0.0, 0.0, 0.0, 0.17, 0.0, 0.0, 0.0, 0.17];
        let next = world.body(rod, &desc)?;
        let mut hinge = JointDesc { kind: raw::CAROM_JOINT_HINGE, body_a: link, body_b: next, ..Default::default() };
        hinge.fields = raw::CAROM_JOINT_WORLD_FRAME;
        (hinge.position_a[0], hinge.orientation_a) = (f64::from(i), [0.0, -half, 0.0, half]);
        joints.push(world.joint(&hinge)?);
        link = next;
    }
    let level = forces(&world, link, [0.0; 2], [0.0; 2])?; // what bears the weight in the first pose
    let (goal, mut angle) = ([0.5, -0.5], [0.0; 2]); // rad
    for _ in 0..120 {
        angle = read(&world, raw::CAROM_JOINT_BULK_POSITION, &joints)?;
        let speed = read(&world, raw::CAROM_JOINT_BULK_VELOCITY, &joints)?;
        let wanted = [0, 1].map(|i| 400.0 * (goal[i] - angle[i]) - 40.0 * speed[i]); // rad/s^2
        let torque = forces(&world, link, speed, wanted)?;
        world.write_joints(raw::CAROM_JOINT_BULK_TARGET_EFFORT, Some(&joints), &torque.map(|number| [number]))?;
        world.step(1.0 / 60.0)?;
    }
    let ([a, b], [x, y]) = (level, angle);
    println!("{a:.2} and {b:.2} N m hold it level; after 2 s it is at {x:.2} and {y:.2} rad");
    assert!(
        (a - 4.0 * 9.81).abs() < 1e-9 && (b - 9.81).abs() < 1e-9 && (x - 0.5).abs() < 0.005 && (y + 0.5).abs() < 0.005
    );
    Ok(())
}

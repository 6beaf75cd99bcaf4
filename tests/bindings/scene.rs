//! The scene of scene.c by way of the crate; prints its hashes, then those of it with a double cone that is a closure.
use carom::{raw, BodyDesc, ColliderDesc, Engine, JointDesc, MaterialDesc, Param, Result, Shape};

/// plugins/template/template.c, operation by operation.
fn top_support(params: &[f64], [mut x, y, mut z]: [f64; 3]) -> [f64; 3] {
    let (r, h) = (params[0], params[1]);
    let side = x.abs().max(z.abs());
    let largest = side.max(y.abs());
    let mut length = 0.0;
    if side > 0.0 {
        x /= side;
        z /= side;
        length = (x * x + z * z).sqrt();
        x /= length;
        z /= length;
    }
    if h * (y.abs() / largest) > r * (length * (side / largest)) {
        [0.0, if y >= 0.0 { h } else { -h }, 0.0]
    } else {
        [r * x, 0.0, r * z]
    }
}

fn hashes(engine: &Engine, top: Shape) -> Result<()> {
    let shapes = [engine.shape("sphere", &[0.3])?, engine.shape("box", &[0.4, 0.25, 0.3])?, top];
    let mut world = engine.world()?;
    world.set_dial(raw::CAROM_DIAL_SUBSTEPS, 5.0)?;
    world.set_wind([1.5, 0.0, 0.5])?;
    let material = world.material(&MaterialDesc { friction: 0.6, restitution: 0.3, ..Default::default() })?;
    let ground = engine.shape("half_space", &[0.0, 1.0, 0.0, 0.0])?;
    let still = BodyDesc { r#type: raw::CAROM_BODY_STATIC, ..Default::default() };
    world.body_of(&still, &[ColliderDesc { shape: ground, material, ..Default::default() }])?;
    for i in 1..19 {
        let n = i as f64;
        let thing = BodyDesc {
            position: [(i % 3) as f64 * 0.5, 0.6 + n * 0.55, (i % 2) as f64 * 0.4],
            angular_velocity: [0.5 * n, 0.0, 1.0],
            ..Default::default()
        };
        let part = ColliderDesc { shape: shapes[i % 3], density: 400.0 + 50.0 * n, material, ..Default::default() };
        let body = world.body_of(&thing, &[part])?;
        world.set_drag(body, 0.1, 0.02)?;
    }
    let door = world.body(shapes[1], &BodyDesc { position: [4.5, 3.0, 0.0], ..Default::default() })?;
    world.joint(&JointDesc {
        kind: raw::CAROM_JOINT_HINGE,
        fields: raw::CAROM_JOINT_WORLD_FRAME,
        body_b: door,
        position_a: [4.0, 3.0, 0.0],
        orientation_a: [0.0, -0.6, 0.0, 0.8],
        ..Default::default()
    })?;
    for _ in 0..3 {
        for _ in 0..60 {
            world.step(1.0 / 60.0)?;
        }
        println!("{:016x}", world.hash()?);
    }
    Ok(())
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let size = |name| Param { name, unit: "m", min: 1e-9, max: 1e8 };
    let kind = engine.plugin("test.top", &[size("radius"), size("half_height")], top_support)?;
    hashes(&engine, engine.shape("template", &[0.35, 0.4])?)?;
    hashes(&engine, engine.shape_of(kind, &[0.35, 0.4])?)
}

//! A shape of your own: a support function is all of it. An elliptic cylinder, its axis upright.
use carom::{raw, BodyDesc, Engine, Param, Result};

/// The farthest point of the shape along a direction.
fn support(p: &[f64], d: [f64; 3]) -> [f64; 3] {
    let length = (p[0] * d[0]).hypot(p[2] * d[2]);
    let across = |a: f64, d: f64| if length > 0.0 { a * a * d / length } else { 0.0 };
    [across(p[0], d[0]), p[1].copysign(d[1]), across(p[2], d[2])]
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let half = ["a", "h", "b"].map(|name| Param { name, unit: "m", min: 1e-6, max: 1e3 });
    let kind = engine.plugin("example.elliptic_cylinder", &half, support)?;
    let shape = engine.shape_of(kind, &[0.6, 0.2, 0.3])?;
    let body = world.body(shape, &BodyDesc { position: [0.0, 1.0, 0.0], ..Default::default() })?; // 1000 kg/m^3
    for _ in 0..120 {
        world.step(1.0 / 60.0)?;
    }
    let mut mass = [[0.0]];
    world.read(raw::CAROM_FIELD_MASS, Some(&[body]), &mut mass)?;
    let (mass, y) = (mass[0][0], world.position(body)?[1]);
    println!("it weighs {mass:.0} kg and lies at y = {y:.2} m");
    let volume = std::f64::consts::PI * 0.6 * 0.3 * 0.4;
    assert!((mass / (1000.0 * volume) - 1.0).abs() < 0.005 && (y - 0.2).abs() < 0.005);
    Ok(())
}

//! Rays: what is below a point, how far, and that beside it lies the ground.
use carom::{raw, BodyDesc, Engine, Result, World};

/// What lies along a direction; time counts in lengths of it.
fn cast(world: &World, from: [f64; 3], way: [f64; 3]) -> Result<raw::carom_world_hit> {
    world.cast_ray(from, way, f64::INFINITY, None)
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let ground = world.ground(0.0)?;
    let sphere = engine.shape("sphere", &[0.5])?;
    let ball = world.body(sphere, &BodyDesc { position: [0.0, 2.0, 0.0], ..Default::default() })?;
    for _ in 0..120 {
        world.step(1.0 / 60.0)?;
    }
    let hit = cast(&world, [0.0, 5.0, 0.0], [0.0, -1.0, 0.0])?;
    let beside = cast(&world, [3.0, 5.0, 0.0], [0.0, -1.0, 0.0])?;
    let above = cast(&world, [0.0, 5.0, 0.0], [0.0, 1.0, 0.0])?;
    println!("{:.2} m down lies the ball, beside it {:.2} m down the ground, above it nothing", hit.time, beside.time);
    assert!(hit.body == ball && (hit.time - 4.0).abs() < 0.01);
    assert!(beside.body == ground && (beside.time - 5.0).abs() < 1e-6 && above.outcome == raw::CAROM_CAST_MISS);
    Ok(())
}

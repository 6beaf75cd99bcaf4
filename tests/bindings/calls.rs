//! calls.c by way of the crate.
use carom::{BodyDesc, Engine, Result};
use std::time::Instant;

fn timed(n: usize, mut each: impl FnMut(usize) -> Result<()>) -> Result<f64> {
    let start = Instant::now();
    for i in 0..n {
        each(i)?;
    }
    Ok(start.elapsed().as_nanos() as f64 / n as f64)
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let shape = engine.shape("sphere", &[0.5])?;
    let mut bodies = Vec::new();
    for i in 0..10_000 {
        bodies.push(world.body(shape, &BodyDesc { position: [2.0 * i as f64, 0.0, 0.0], ..Default::default() })?);
    }
    let mut positions = vec![[0.0; 3]; bodies.len()];
    let (mut single, mut bulk, mut sum) = (f64::MAX, f64::MAX, 0.0);
    for _ in 0..7 {
        single = single.min(timed(200_000, |i| {
            sum += world.position(bodies[i % bodies.len()])?[0];
            Ok(())
        })?);
        bulk = bulk.min(timed(100, |_| world.positions(&mut positions))?);
    }
    assert!(sum > 0.0 && positions[1][0] == 2.0);
    println!("{single:.1} {bulk:.0}");
    Ok(())
}

//! Saving and loading: a world as bytes, for a file, goes on in another engine with the same bits.
use carom::{raw, BodyDesc, Engine, Result};

fn main() -> Result<()> {
    let (engine, other) = (Engine::new()?, Engine::new()?);
    let (mut world, mut copy) = (engine.world()?, other.world()?);
    world.ground(0.0)?;
    let shape = engine.shape("box", &[0.5; 3])?;
    for i in 0..5 {
        let position = [0.1 * f64::from(i), 0.5 + 1.1 * f64::from(i), 0.0];
        world.body(shape, &BodyDesc { position, ..Default::default() })?;
    }
    for _ in 0..60 {
        world.step(1.0 / 60.0)?;
    }
    let saved = world.save(raw::CAROM_SNAPSHOT_WHOLE)?; // with bodies and shapes: std::fs::write("five.world", &saved)
    other.shape("box", &[0.5; 3])?; // finds the plugin of what is loaded
    copy.restore(&saved)?; // into a world in which nothing was made yet
    for _ in 0..60 {
        world.step(1.0 / 60.0)?;
        copy.step(1.0 / 60.0)?;
    }
    let same = world.hash()? == copy.hash()?;
    let bodies = copy.bodies()?;
    let (n, top, word) = (bodies.len(), copy.position(bodies[5])?[1], if same { "yes" } else { "no" });
    println!("{n} bodies went on, the last one is at y = {top:.2} m; the same bits: {word}");
    assert!(same && (top - 4.5).abs() < 0.01);
    Ok(())
}

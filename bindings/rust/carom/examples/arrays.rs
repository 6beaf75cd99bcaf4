//! Bulk arrays: velocities of 1000 balls are set in one call, their positions read in one.
use carom::{raw, BodyDesc, Engine, Result};

fn mean_height(positions: &[[f64; 3]]) -> f64 {
    positions.iter().map(|position| position[1]).sum::<f64>() / positions.len() as f64
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let sphere = engine.shape("sphere", &[0.5])?;
    let (mut balls, mut positions) = (Vec::new(), Vec::new());
    for i in 0..1000 {
        let position = [2 * (i / 100), 5 + 2 * (i / 10 % 10), 2 * (i % 10)].map(f64::from);
        positions.push(position);
        balls.push(world.body(sphere, &BodyDesc { position, ..Default::default() })?);
    }
    world.write(raw::CAROM_FIELD_LINEAR_VELOCITY, Some(&balls), &[[0.0, 9.81 / 2.0, 0.0]; 1000])?;
    let mut height = vec![mean_height(&positions)];
    for _ in 0..2 {
        for _ in 0..30 {
            world.step(1.0 / 60.0)?;
        }
        world.read(raw::CAROM_FIELD_POSITION, Some(&balls), &mut positions)?;
        height.push(mean_height(&positions));
    }
    let (rise, off) = (height[1] - height[0], (height[2] - height[0]).abs());
    println!("{} balls rise by {rise:.3} m and are back after 1 s, {off:.3} m off", balls.len());
    assert!((rise - 9.81 / 8.0).abs() < 1e-9 && off < 1e-9);
    Ok(())
}

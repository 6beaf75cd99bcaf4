//! Bodies and stacks: ten boxes stand on each other, to a millimetre a box.
use carom::{raw, BodyDesc, Engine, Result};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let shape = engine.shape("box", &[0.5, 0.5, 0.5])?; // half extents, m; of 1000 kg/m^3, where nothing else is said
    let mut boxes = Vec::new();
    for i in 0..10 {
        let position = [0.0, 0.52 + 1.02 * f64::from(i), 0.0];
        boxes.push(world.body(shape, &BodyDesc { position, ..Default::default() })?);
    }
    for _ in 0..180 {
        world.step(1.0 / 60.0)?;
    }
    let [x, y, z] = world.position(boxes[9])?;
    let mut mass = [[0.0]];
    world.read(raw::CAROM_FIELD_MASS, Some(&boxes[..1]), &mut mass)?;
    println!("10 boxes of {:.0} kg stand for 3 s, the top one at y = {y:.2} m", mass[0][0]);
    assert!((y - 9.5).abs() < 0.01 && x.abs() < 0.01 && z.abs() < 0.01);
    Ok(())
}

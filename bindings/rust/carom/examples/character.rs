//! A character walks over three steps of 0.2 m, and pushes a crate that stands there.
use carom::{raw, BodyDesc, Engine, Result};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let slab = engine.shape("box", &[2.0, 0.1, 2.0])?;
    for i in 0..3 {
        let position = [3.0 + 0.5 * f64::from(i), 0.1 + 0.2 * f64::from(i), 0.0];
        world.body(slab, &BodyDesc { r#type: raw::CAROM_BODY_STATIC, position, ..Default::default() })?;
    }
    let cube = engine.shape("box", &[0.2, 0.2, 0.2])?;
    let load = world.body(cube, &BodyDesc { position: [3.0, 0.8, 0.0], ..Default::default() })?;
    let capsule = engine.shape("capsule", &[0.3, 0.6])?;
    let desc = raw::carom_character_desc { step_up: 0.25, ..Default::default() };
    let mut walker = raw::carom_character { position: [0.0, 1.0, 0.0], ..Default::default() };
    let (mut owner, fits) = (std::ptr::null_mut(), std::ptr::null_mut());
    engine.call(|p, _| {
        owner = p;
        raw::CAROM_OK
    })?;
    world.call(|p, e| unsafe { raw::carom_character_set_shape(owner, p, &desc, &mut walker, capsule, fits, e) })?;
    let (walk, dt) = ([1.5, 0.0, 0.0], 1.0 / 60.0);
    for _ in 0..180 {
        world.step(dt)?;
        world.character_move(Some(&desc), &mut walker, walk, 0.0, dt)?;
        world.character_push(Some(&desc), &walker, dt)?;
    }
    let (pushed, feet) = (world.position(load)?[0] - 3.0, walker.position[1] - walker.foot);
    let firm = walker.ground == raw::CAROM_GROUND_FIRM;
    let word = if firm { "firm" } else { "no firm" };
    println!("after 3 s it stands on {word} ground, {feet:.2} m up, and has pushed a crate by {pushed:.1} m");
    assert!(firm && (feet - 0.6 - 0.0102).abs() < 1e-4); // a skin of 0.01 m and 2 % lies between
    assert!(pushed > 1.0 && pushed < 2.0 && walker.contact_count == 1 && walker.contact_bodies[0] == load);
    Ok(())
}

//! Casts and overlaps: how far a crate can be moved before it touches, and what a blast of 2 m reaches.
use carom::{raw, BodyDesc, Engine, Result};
use std::ptr::null;

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let thick = engine.shape("box", &[0.5, 2.0, 2.0])?;
    let about = BodyDesc { r#type: raw::CAROM_BODY_STATIC, position: [5.0, 2.0, 0.0], ..Default::default() };
    let wall = world.body(thick, &about)?;
    let sphere = engine.shape("sphere", &[0.5])?;
    let mut balls = Vec::new();
    for z in [1.0, -2.0, 4.0] {
        balls.push(world.body(sphere, &BodyDesc { position: [0.0, 6.0, z], ..Default::default() })?);
    }
    for _ in 0..120 {
        world.step(1.0 / 60.0)?; // they fall to the ground
    }
    let (crate_shape, blast) = (engine.shape("box", &[0.5; 3])?, engine.shape("sphere", &[2.0])?); // of no body
    let (from, way, middle) = ([0.0, 1.0, 0.0], [8.0, 0.0, 0.0], [0.0, 0.5, 0.0]);
    let mut ask = raw::carom_query_shapes { scalar: raw::CAROM_SCALAR_F64, count: 1, ..Default::default() };
    let (mut hit, mut found): (raw::carom_world_hit, [raw::carom_world_hit; 8]) = unsafe { std::mem::zeroed() };
    let (size, mut count) = (std::mem::size_of_val(&hit) as u64, 0);
    (ask.shapes, ask.positions, ask.motions) = (&crate_shape, from.as_ptr().cast(), way.as_ptr().cast());
    let want = raw::CAROM_WANT_FIRST;
    world.call(|p, e| unsafe { raw::carom_world_cast_shapes(p, &ask, want, null(), &mut hit, size, e) })?;
    (ask.shapes, ask.positions, ask.motions) = (&blast, middle.as_ptr().cast(), null());
    let to = found.as_mut_ptr();
    world.call(|p, e| unsafe { raw::carom_world_overlap_shapes(p, &ask, null(), to, size, 8, &mut count, e) })?;
    let reached = found.iter().take(count as usize).filter(|one| balls.contains(&one.body)).count();
    // Time is a fraction of the way.
    println!("{:.2} m to the wall, and {reached} of {} balls lie within 2 m", 8.0 * hit.time, balls.len());
    assert!(hit.body == wall && (8.0 * hit.time - 4.0).abs() < 1e-4 && reached == 2);
    Ok(())
}

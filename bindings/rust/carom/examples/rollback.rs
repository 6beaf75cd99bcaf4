//! Snapshots and rollback: a guess about a player was wrong, so 30 steps are made again with what was really done.
use carom::{raw, Body, BodyDesc, Engine, Result, World};

fn play(world: &mut World, ball: Body, pushed: bool, steps: std::ops::Range<u32>) -> Result<()> {
    for step in steps {
        if pushed && step == 70 {
            world.set_velocity(ball, [2.0, 0.0, 0.0], [0.0; 3])?;
        }
        world.step(1.0 / 60.0)?;
    }
    Ok(())
}

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let sphere = engine.shape("sphere", &[0.5])?;
    let ball = world.body(sphere, &BodyDesc { position: [0.0, 0.5, 0.0], ..Default::default() })?;
    play(&mut world, ball, false, 0..60)?;
    let mut truth = world.fork()?; // a world in which nothing is guessed
    let twin = truth.bodies()?[1]; // bodies have the same order there
    let saved = world.save(raw::CAROM_SNAPSHOT_STATE)?;
    play(&mut world, ball, false, 60..90)?; // the guess: no push
    let guess = world.position(ball)?[0];
    world.restore(&saved)?;
    play(&mut world, ball, true, 60..90)?;
    play(&mut truth, twin, true, 60..90)?;
    let (x, same) = (world.position(ball)?[0], world.hash()? == truth.hash()?);
    let word = if same { "yes" } else { "no" };
    println!("guessed x = {guess:.2} m, it was {x:.2} m; the same bits as without a guess: {word}");
    assert!(same && guess.abs() < 1e-6 && x > 0.4);
    Ok(())
}

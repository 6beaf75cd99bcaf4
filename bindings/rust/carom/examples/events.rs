//! Events of contacts: when a ball that falls 2 m hits the ground, and how fast.
use carom::{raw, BodyDesc, Engine, Result};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let sphere = engine.shape("sphere", &[0.5])?;
    let ball = world.body(sphere, &BodyDesc { position: [0.0, 2.5, 0.0], ..Default::default() })?;
    world.collect_events(raw::CAROM_EVENTS_CONTACT, 1.0)?;
    let mut found = Vec::new();
    for step in 0..60 {
        world.step(1.0 / 60.0)?; // events are those of the last step
        let events = world.contact_events()?;
        let hits = events.iter().filter(|event| event.kind == raw::CAROM_CONTACT_HIT);
        found.extend(hits.map(|event| (f64::from(step + 1) / 60.0, *event)));
    }
    let (at, hit) = found[0];
    println!("{} hit, after {at:.2} s, at {:.2} m/s", found.len(), hit.approach_speed);
    let fall = (2.0 * 2.0 / 9.81_f64).sqrt(); // s
    assert!(found.len() == 1 && (hit.body_a == ball || hit.body_b == ball));
    assert!((at - fall).abs() < 2.0 / 60.0 && (hit.approach_speed - 9.81 * fall).abs() < 9.81 / 60.0);
    Ok(())
}

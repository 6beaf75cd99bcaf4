//! A car brakes: from 20 m/s on tyres of grip 1 it needs v^2 / (2 g) = 20.4 m.
use carom::{raw, BodyDesc, ColliderDesc, Engine, Result};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    world.ground(0.0)?;
    let mut about = BodyDesc { mass: 1200.0, position: [0.0, 0.6, 0.0], ..Default::default() };
    about.fields = raw::CAROM_BODY_FIELD_MASS | raw::CAROM_BODY_FIELD_CENTER | raw::CAROM_BODY_FIELD_INERTIA;
    about.inertia = [1600.0, 0.0, 0.0, 0.0, 1800.0, 0.0, 0.0, 0.0, 500.0];
    let shape = engine.shape("box", &[0.85, 0.3, 2.0])?;
    let part = ColliderDesc { shape, position: [0.0, 0.15, 0.0], ..Default::default() };
    let body = world.body_of(&about, &[part])?;
    let desc = raw::carom_vehicle_desc { chassis: body, ..Default::default() };
    let mut input = raw::carom_vehicle_input { gear: 0, ..Default::default() };
    let (mut car, mut states) = (raw::carom_vehicle::default(), [raw::carom_wheel::default(); 4]);
    let wheels = [(0.75, 1.3), (-0.75, 1.3), (0.75, -1.3), (-0.75, -1.3)].map(|(x, z)| raw::carom_wheel_desc {
        position: [x, -0.32, z],
        brake: 1e5,
        slide: 1.0,
        ..Default::default()
    });
    let mut begin = 0.0;
    for step in 0..330 {
        if step == 120 {
            // Until then it settles on its springs.
            world.set_velocity(body, [0.0, 0.0, 20.0], [0.0; 3])?;
            (begin, input.brake) = (world.position(body)?[2], 1.0);
            states.iter_mut().for_each(|state| state.spin = 20.0 / 0.33);
        }
        let (from, to, dt) = (wheels.as_ptr(), states.as_mut_ptr(), 1.0 / 60.0);
        world.call(|p, e| unsafe { raw::carom_vehicle_drive(p, &desc, from, 4, &input, &mut car, to, dt, e) })?;
        world.step(dt)?;
    }
    let way = world.position(body)?[2] - begin;
    println!("it brakes from 20 m/s in {way:.1} m and stands: {:.2} m/s", car.speed.abs());
    assert!((way - 400.0 / (2.0 * 9.81)).abs() < 0.5 && car.speed.abs() < 1e-3);
    Ok(())
}

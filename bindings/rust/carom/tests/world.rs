//! Failures, arrays, copies, and nothing that is not given back.
use carom::{raw, BodyDesc, ColliderDesc, Engine, Error, World};

fn at(x: f64, y: f64) -> BodyDesc {
    BodyDesc { position: [x, y, 0.0], ..Default::default() }
}

fn failure<T>(result: carom::Result<T>) -> Error {
    let error = result.err().expect("it did not fail");
    assert!(!error.remedy.is_empty() && error.to_string().contains(". Remedy: "));
    error
}

#[test]
fn failures_have_a_remedy() {
    let engine = Engine::new().unwrap();
    let mut world = engine.world().unwrap();
    assert_eq!(failure(engine.shape("no_such_shape", &[])).code, raw::CAROM_E_NOT_FOUND);
    assert_eq!(failure(engine.shape("sphere\0", &[1.0])).code, raw::CAROM_E_OUT_OF_RANGE);
    assert_eq!(failure(engine.shape("sphere", &[-1.0])).code, raw::CAROM_E_OUT_OF_RANGE);
    assert_eq!(failure(world.step(2.0)).argument, 2);
    let ball = world.body(engine.shape("sphere", &[0.5]).unwrap(), &at(0.0, 0.0)).unwrap();
    world.destroy(ball).unwrap();
    assert_eq!(failure(world.position(ball)).code, raw::CAROM_E_STALE_HANDLE);
    assert_eq!(failure(world.body_of(&at(0.0, 0.0), &[ColliderDesc::default()])).code, raw::CAROM_E_INVALID_HANDLE);
    assert!(world.bodies().unwrap().is_empty()); // the body without its collider is gone, too
    assert_eq!(failure(engine.plugin("test.panics", &[], |_, _| panic!("no"))).code, raw::CAROM_E_PLUGIN_INVALID);
    let dent = failure(engine.plugin("test.dent", &[], |_, d| [-d[0], d[1], d[2]]));
    assert!(dent.code == raw::CAROM_E_PLUGIN_INVALID && dent.witness.is_some());
}

#[test]
fn arrays_of_bodies() {
    let engine = Engine::new().unwrap();
    let mut world = engine.world().unwrap();
    let shape = engine.shape("sphere", &[0.5]).unwrap();
    let made: Vec<_> = (0..100).map(|i| world.body(shape, &at(2.0 * i as f64, 1.0)).unwrap()).collect();
    assert_eq!(world.bodies().unwrap(), made);
    let (mut positions, mut poses) = (vec![[0.0; 3]; 100], vec![[0.0; 7]; 100]);
    let mut floats = vec![[0f32; 3]; 100];
    world.positions(&mut positions).unwrap();
    world.poses(&mut poses).unwrap();
    world.read(raw::CAROM_FIELD_POSITION, None, &mut floats).unwrap();
    for i in 0..100 {
        let (position, orientation) = world.pose(made[i]).unwrap();
        assert_eq!((positions[i], position), (world.position(made[i]).unwrap(), positions[i]));
        assert_eq!((&poses[i][..3], &poses[i][3..]), (&position[..], &orientation[..]));
        assert_eq!(floats[i], [2.0 * i as f32, 1.0, 0.0]);
    }
    world.write(raw::CAROM_FIELD_POSITION, Some(&made[..1]), &[[0.0, 9.0, 0.0]]).unwrap();
    assert_eq!(world.position(made[0]).unwrap(), [0.0, 9.0, 0.0]);
    assert_eq!(failure(world.positions(&mut positions[..99])).code, raw::CAROM_E_OUT_OF_RANGE);
    let two = world.read(raw::CAROM_FIELD_POSITION, Some(&made[..2]), &mut positions);
    assert_eq!(failure(two).code, raw::CAROM_E_OUT_OF_RANGE);
    let thin = world.read(raw::CAROM_FIELD_POSITION, None, &mut [[0.0; 2]; 100]);
    assert_eq!(failure(thin).code, raw::CAROM_E_BUFFER_TOO_SMALL);
}

#[test]
fn every_kind_of_argument() {
    let engine = Engine::new().unwrap();
    let mut world = engine.world().unwrap();
    let parts = [engine.shape("sphere", &[0.2]).unwrap(); 2];
    let (places, turns) = ([[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]], [[0.0, 0.0, 0.0, 1.0]; 2]);
    let capsule = engine.shape_create_hull_of(&parts, Some(&places), None, None, 0.0).unwrap();
    assert_eq!(
        failure(engine.shape_create_hull_of(&parts, None, Some(&turns[..1]), None, 0.0)).code,
        raw::CAROM_E_OUT_OF_RANGE
    );
    let mut farthest = [[0.0; 3]; 2];
    engine.shape_support(capsule, &[[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]], &mut farthest).unwrap();
    assert!((farthest[0][0] - 0.7).abs() < 1e-12 && (farthest[1][1] - 0.2).abs() < 1e-12);
    assert_eq!(
        failure(engine.shape_support(capsule, &[[1.0, 0.0, 0.0]], &mut farthest)).code,
        raw::CAROM_E_OUT_OF_RANGE
    );
    let body = world.body(capsule, &at(0.0, 2.0)).unwrap();
    let before = world.mass(body).unwrap().1;
    world.set_mass(body, 3.0, None, Some([1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.5])).unwrap();
    let (mass, center, inertia) = world.mass(body).unwrap();
    assert_eq!((mass, center, inertia[4], inertia[8]), (3.0, before, 2.0, 2.5));
    let hit = world.cast_ray([0.0, 5.0, 0.0], [0.0, -1.0, 0.0], 10.0, None).unwrap();
    assert!(hit.body == body && (hit.time - 2.8).abs() < 1e-6);
    let asked = raw::carom_query_desc { struct_size: u32::MAX, ..Default::default() }; // the crate knows the size better
    assert_eq!(world.cast_ray([0.0, 5.0, 0.0], [0.0, -1.0, 0.0], 10.0, Some(&asked)).unwrap().body, body);
    world.set_accuracy(Some(&raw::carom_accuracy { place: 1e-3, turn: 1e-3, ..Default::default() })).unwrap();
    assert_eq!(world.accuracy().unwrap().1, 1);
    world.set_accuracy(None).unwrap();
    assert_eq!(world.accuracy().unwrap().1, 0);
    assert_eq!(world.colliders(body).unwrap().len(), 1);
    let mut same = [0];
    world.translate_handles(&[body.0], &mut same).unwrap();
    assert_eq!(same, [body.0]);
}

#[test]
fn a_copy_and_saved_bytes_go_on_alike() {
    let engine = Engine::new().unwrap();
    let mut world = engine.world().unwrap();
    world.ground(0.0).unwrap();
    let spins = BodyDesc { angular_velocity: [1.0, 2.0, 3.0], ..at(0.0, 0.7) };
    world.body(engine.shape("box", &[0.5; 3]).unwrap(), &spins).unwrap();
    let saved = world.save(raw::CAROM_SNAPSHOT_STATE).unwrap();
    let mut copy = world.fork().unwrap();
    let run = |world: &mut World| {
        (0..30).for_each(|_| world.step(1.0 / 60.0).unwrap());
        world.hash().unwrap()
    };
    let after = run(&mut world);
    assert!(!world.contacts().unwrap().is_empty() && world.report().unwrap().steps == 30);
    assert_eq!(run(&mut copy), after);
    world.restore(&saved).unwrap();
    assert_eq!(run(&mut world), after);
    assert_eq!(failure(world.restore(b"nonsense")).code, raw::CAROM_E_CORRUPT);
}

#[test]
fn worlds_step_on_other_threads() {
    let engine = Engine::new().unwrap();
    let run = |engine: &Engine| {
        let mut world = engine.world().unwrap();
        world.ground(0.0).unwrap();
        let support = |p: &[f64], d: [f64; 3]| [p[0].copysign(d[0]), p[0].copysign(d[1]), p[0].copysign(d[2])];
        let id = format!("test.box{:?}", std::thread::current().id());
        let kind =
            engine.plugin(&id, &[carom::Param { name: "half", unit: "m", min: 1e-6, max: 1e3 }], support).unwrap();
        world.body(engine.shape_of(kind, &[0.5]).unwrap(), &at(0.0, 2.0)).unwrap();
        (0..90).for_each(|_| world.step(1.0 / 60.0).unwrap());
        world.hash().unwrap()
    };
    let here = run(&engine);
    std::thread::scope(|scope| {
        let others: Vec<_> = (0..2).map(|_| scope.spawn(|| run(&engine))).collect();
        others.into_iter().for_each(|other| assert_eq!(other.join().unwrap(), here));
    });
}

/// 65,535 engines and worlds may be alive in a process: more than that are made here, and given back.
#[test]
fn nothing_is_left_alive() {
    for _ in 0..33_000 {
        let world = Engine::new().unwrap().world().unwrap(); // the world keeps what it stands on
        assert_eq!(world.bodies().unwrap(), []);
    }
}

//! Ground of a height field, in whose valley a ball comes to rest, and of triangles, down which a crate slides.
use carom::{raw, BodyDesc, ColliderDesc, Engine, MaterialDesc, Result, Shape};

fn main() -> Result<()> {
    let engine = Engine::new()?;
    let mut world = engine.world()?;
    let over = |i: i32| 0.25 * (f64::from(i % 9 - 4).hypot(f64::from(i / 9 - 4)) - 1.0).max(0.0);
    let heights: Vec<f64> = (0..81).map(over).collect(); // m, rows along z
    let valley = raw::carom_height_field_desc { columns: 9, rows: 9, heights: heights.as_ptr(), ..Default::default() };
    let (mut field, mut mesh) = (Shape::default(), Shape::default());
    engine.call(|p, e| unsafe { raw::carom_shape_create_height_field(p, &valley, &mut field, e) })?;
    let tilt = std::f64::consts::PI / 6.0;
    let (s, c) = tilt.sin_cos();
    let (x, y, up) = (6.0 + 9.0 * c, 4.0 - 9.0 * s, 7.0 - 9.0 * s); // a wall at its end
    let corners = [6.0, 4.0, -2.0, 6.0, 4.0, 2.0, x, y, -2.0, x, y, 2.0, x, up, -2.0, x, up, 2.0];
    let triangles = [0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5];
    let ramp = raw::carom_mesh_desc {
        vertices: corners.as_ptr(),
        vertex_count: 6,
        triangles: triangles.as_ptr(),
        triangle_count: 4,
        ..Default::default()
    };
    engine.call(|p, e| unsafe { raw::carom_shape_create_mesh(p, &ramp, &mut mesh, e) })?;
    let still = BodyDesc { r#type: raw::CAROM_BODY_STATIC, ..Default::default() };
    world.body(field, &BodyDesc { position: [-4.0, 0.0, -4.0], ..still })?; // of its corner
    world.body(mesh, &still)?;
    let material = world.material(&MaterialDesc { friction: 0.0, ..Default::default() })?;
    let mut about = BodyDesc { position: [6.0 + c + 0.5 * s, 4.0 - s + 0.5 * c, 0.0], ..Default::default() }; // 1 m down
    about.orientation = [0.0, 0.0, -(tilt / 2.0).sin(), (tilt / 2.0).cos()];
    let shape = engine.shape("box", &[0.5; 3])?;
    let sliding = world.body_of(&about, &[ColliderDesc { shape, material, ..Default::default() }])?;
    let sphere = engine.shape("sphere", &[0.5])?;
    let slowed = BodyDesc { linear_damping: 0.5, angular_damping: 0.5, ..Default::default() };
    let ball = world.body(sphere, &BodyDesc { position: [3.0, 2.0, 1.0], ..slowed })?;
    for _ in 0..60 {
        world.step(1.0 / 60.0)?;
    }
    let slid = world.position(sliding)?;
    let way = (slid[0] - about.position[0]).hypot(slid[1] - about.position[1]);
    for _ in 0..600 {
        world.step(1.0 / 60.0)?;
    }
    let [x, y, _] = world.position(ball)?;
    println!("the crate slides by {way:.2} m in 1 s, and the ball lies at y = {y:.2} m");
    assert!((way - 9.81 * s / 2.0).abs() < 0.01 && (y - 0.5).abs() < 0.005 && x.abs() < 2.0);
    Ok(())
}

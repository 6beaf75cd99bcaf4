//! Casts and pairs of parry; `../queries.cpp` is what calls.

use crate::vector;
use rapier3d::math::{Pose, Real, Rotation, Vector};
use rapier3d::na;
use rapier3d::parry::query::{
    cast_shapes, cast_shapes_nonlinear, contact, NonlinearRigidMotion, Ray, ShapeCastOptions,
};
use rapier3d::parry::shape::SharedShape;
use std::collections::HashMap;
use std::ffi::{c_char, c_void, CStr};

const NAME: &CStr = if cfg!(feature = "double") { c"parry 0.31.1 f64" } else { c"parry 0.31.1 f32" };

#[repr(C)]
struct RustSolid {
    id: *const c_void,
    kind: i32,
    radius: f64,
    half_height: f64,
    half: [f64; 3],
    vertices: usize,
    xyz: *const f64,
}

#[repr(C)]
struct Placement {
    r: [f64; 9],
    p: [f64; 3],
}

#[repr(C)]
struct RustAnswer {
    overlap: bool,
    separation: f64,
    normal: [f64; 3],
}

struct Query {
    ray: bool,
    a: Option<SharedShape>, // none: a ray, or parry makes no such hull
    b: Option<SharedShape>,
    from_a: Pose,
    from_b: Pose,
    way: Vector, // of a, while b stays
    spin_a: Vector,
    spin_b: Vector,
}

#[derive(Default)]
struct Queries {
    shapes: HashMap<*const c_void, Option<SharedShape>>,
    all: Vec<Query>,
}

fn shape(s: &RustSolid) -> Option<SharedShape> {
    let (radius, half_height) = (s.radius as Real, s.half_height as Real);
    Some(match s.kind {
        0 => SharedShape::ball(radius),
        1 => SharedShape::capsule_y(half_height, radius),
        2 => SharedShape::cuboid(s.half[0] as Real, s.half[1] as Real, s.half[2] as Real),
        4 => SharedShape::cylinder(half_height, radius),
        5 => SharedShape::cone(half_height, radius),
        _ => {
            let xyz = unsafe { std::slice::from_raw_parts(s.xyz, 3 * s.vertices) };
            let points: Vec<Vector> = xyz.chunks_exact(3).map(vector).collect();
            return SharedShape::convex_hull(&points);
        }
    })
}

fn rotation(at: &Placement) -> Rotation {
    let matrix = na::Matrix3::from_row_slice(&at.r);
    let q = na::UnitQuaternion::from_matrix(&matrix).into_inner().coords;
    Rotation::from_xyzw(q.x as Real, q.y as Real, q.z as Real, q.w as Real)
}

fn pose(at: &Placement) -> Pose {
    Pose::from_parts(vector(&at.p), rotation(at))
}

fn spin(from: &Placement, to: &Placement) -> Vector {
    (rotation(to) * rotation(from).inverse()).to_scaled_axis()
}

impl Queries {
    fn shape(&mut self, solid: &RustSolid) -> Option<SharedShape> {
        self.shapes.entry(solid.id).or_insert_with(|| shape(solid)).clone()
    }

    fn cast(&self, task: i32, i: usize) -> Option<Real> {
        let q = &self.all[i];
        let b = q.b.as_ref()?;
        if q.ray {
            return b.cast_ray(&q.from_b, &Ray::new(q.from_a.translation, q.way), 1.0, true);
        }
        let a = q.a.as_ref()?;
        let hit = if task == 1 {
            let options = ShapeCastOptions::with_max_time_of_impact(1.0);
            cast_shapes(&q.from_a, q.way, &**a, &q.from_b, Vector::ZERO, &**b, options)
        } else {
            let motion_a = NonlinearRigidMotion::new(q.from_a, Vector::ZERO, q.way, q.spin_a);
            let motion_b = NonlinearRigidMotion::new(q.from_b, Vector::ZERO, Vector::ZERO, q.spin_b);
            cast_shapes_nonlinear(&motion_a, &**a, &motion_b, &**b, 0.0, 1.0, true)
        };
        hit.ok().flatten().map(|hit| hit.time_of_impact)
    }

    fn pair(&self, i: usize) -> RustAnswer {
        let nothing = RustAnswer { overlap: false, separation: f64::INFINITY, normal: [f64::NAN; 3] };
        let q = &self.all[i];
        let (Some(a), Some(b)) = (&q.a, &q.b) else { return nothing };
        let Ok(Some(found)) = contact(&q.from_a, &**a, &q.from_b, &**b, Real::MAX) else { return nothing };
        let normal = found.normal1;
        RustAnswer {
            overlap: found.dist <= 0.0,
            separation: found.dist as f64,
            normal: [normal.x as f64, normal.y as f64, normal.z as f64],
        }
    }
}

#[no_mangle]
extern "C" fn carom_rust_queries() -> *mut c_void {
    Box::into_raw(Box::<Queries>::default()).cast()
}

#[no_mangle]
unsafe extern "C" fn carom_rust_queries_free(queries: *mut c_void) {
    drop(Box::from_raw(queries.cast::<Queries>()));
}

#[no_mangle]
unsafe extern "C" fn carom_rust_queries_clear(queries: *mut c_void) {
    *queries.cast::<Queries>() = Queries::default();
}

#[no_mangle]
unsafe extern "C" fn carom_rust_queries_add(
    queries: *mut c_void,
    a: *const RustSolid,
    b: *const RustSolid,
    poses: *const Placement,
) {
    let queries = &mut *queries.cast::<Queries>();
    let at = std::slice::from_raw_parts(poses, 4);
    let ray = a.is_null();
    let a = a.as_ref().and_then(|a| queries.shape(a));
    let b = queries.shape(&*b);
    queries.all.push(Query {
        ray,
        a,
        b,
        from_a: pose(&at[0]),
        from_b: pose(&at[2]),
        way: (vector(&at[1].p) - vector(&at[0].p)) - (vector(&at[3].p) - vector(&at[2].p)),
        spin_a: spin(&at[0], &at[1]),
        spin_b: spin(&at[2], &at[3]),
    });
}

#[no_mangle]
unsafe extern "C" fn carom_rust_cast(queries: *const c_void, task: i32, i: usize) -> f64 {
    (*queries.cast::<Queries>()).cast(task, i).map_or(-1.0, |time| time as f64)
}

#[no_mangle]
unsafe extern "C" fn carom_rust_pair(queries: *const c_void, i: usize, answer: *mut RustAnswer) {
    *answer = (*queries.cast::<Queries>()).pair(i);
}

#[no_mangle]
extern "C" fn carom_rust_shapes_name() -> *const c_char {
    NAME.as_ptr()
}

//! Rapier in a module: the world's defaults, except for what the comparison asks of every engine. Its threads are a feature,
//! which its steps of one thread do without: their pool would wait in the time that is measured. A box that is wide and thick
//! enough takes the place of a half-space, as in Rapier's own examples: one without bounds would be in every pair and ray.
//! Dials: iterations (of its solver, each a substep; 4 by default), frequency (Hz, of soft contacts; 30 by default).

mod counted;
mod queries;

use plan::{BodyPlan, BodyState, JointPlan, WorldPlan, GROUND_HALF_DEPTH};
use rapier3d::math::{Pose, Real, Rotation, Vector};
use rapier3d::prelude::*;
use std::collections::HashMap;
use std::ffi::{c_char, c_void};

plan::export_engine!();

const NAME: &std::ffi::CStr = if cfg!(feature = "double") {
    c"Rapier 0.36.1 (double)"
} else if cfg!(feature = "threads") {
    c"Rapier 0.36.1 (float, with threads)"
} else {
    c"Rapier 0.36.1 (float)"
};

struct World {
    physics: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    rays_ready: bool,
    pushed: Vec<usize>,
}

fn vector(v: &[f64]) -> Vector {
    Vector::new(v[0] as Real, v[1] as Real, v[2] as Real)
}

fn wide(v: Vector) -> [f64; 3] {
    [v.x as f64, v.y as f64, v.z as f64]
}

fn shape(body: &BodyPlan, ground_half_width: f64) -> Option<SharedShape> {
    let p = body.params();
    match body.solid {
        plan::HALF_SPACE => {
            let (width, depth) = (ground_half_width as Real, GROUND_HALF_DEPTH as Real);
            Some(SharedShape::cuboid(width, depth, width))
        }
        plan::SPHERE => Some(SharedShape::ball(p[0] as Real)),
        plan::BOX => Some(SharedShape::cuboid(p[0] as Real, p[1] as Real, p[2] as Real)),
        plan::HULL => {
            let points: Vec<Vector> = p.chunks_exact(3).map(vector).collect();
            SharedShape::convex_hull(&points)
        }
        plan::CAPSULE => Some(SharedShape::capsule_y(p[1] as Real, p[0] as Real)),
        plan::CYLINDER => Some(SharedShape::cylinder(p[1] as Real, p[0] as Real)),
        plan::CONE => Some(SharedShape::cone(p[1] as Real, p[0] as Real)),
        _ => None,
    }
}

/// Density 0: a body's mass is told, not made of its shapes.
fn collider(body: &BodyPlan, shape: SharedShape) -> ColliderBuilder {
    let made = ColliderBuilder::new(shape)
        .density(0.0)
        .friction(body.friction as Real)
        .restitution(body.restitution as Real)
        .friction_combine_rule(CoefficientCombineRule::GeometricMean)
        .restitution_combine_rule(CoefficientCombineRule::Max);
    match body.solid {
        plan::HALF_SPACE => {
            let p = body.params();
            let normal = vector(p);
            let turn = Rotation::from_rotation_arc(Vector::Y, normal);
            made.position(Pose::from_parts(normal * (p[3] - GROUND_HALF_DEPTH) as Real, turn))
        }
        _ => made.translation(vector(&body.shape_at)),
    }
}

fn frame(on: &[f64; 3], axes: &[f64; 4]) -> Pose {
    let q = axes.map(|x| x as Real);
    Pose::from_parts(vector(on), Rotation::from_xyzw(q[0], q[1], q[2], q[3]))
}

/// Motors are as hard as floats bear: up to their greatest force they hold their speed.
fn slider(plan: &JointPlan) -> GenericJoint {
    const HARDNESS: f64 = 1e3; // the share of its speed at which a motor gives all it has is one over it
    let axis = JointAxis::LinX;
    let mut joint = GenericJointBuilder::new(JointAxesMask::LOCKED_PRISMATIC_AXES)
        .local_frame1(frame(&plan.on_a, &plan.axes_on_a))
        .local_frame2(frame(&plan.on_b, &plan.axes_on_b))
        .contacts_enabled(false)
        .motor_model(axis, MotorModel::ForceBased);
    if plan.motor_force > 0.0 {
        let factor = HARDNESS * plan.motor_force / plan.motor_speed.abs();
        joint = joint.motor_velocity(axis, plan.motor_speed as Real, factor as Real);
        joint = joint.motor_max_force(axis, plan.motor_force as Real);
    }
    if plan.stiffness > 0.0 {
        joint = joint.motor_position(axis, plan.target as Real, plan.stiffness as Real, plan.damping as Real);
    }
    joint.build()
}

fn rigid_body(body: &BodyPlan, sleeping: bool) -> RigidBodyBuilder {
    let q = body.start.orientation.map(|x| x as Real);
    let pose = Pose::from_parts(vector(&body.start.position), Rotation::from_xyzw(q[0], q[1], q[2], q[3]));
    if body.is_static {
        return RigidBodyBuilder::fixed().pose(pose);
    }
    RigidBodyBuilder::dynamic()
        .pose(pose)
        .linvel(vector(&body.start.velocity))
        .angvel(vector(&body.start.omega))
        .additional_mass_properties(MassProperties::new(Vector::ZERO, body.mass as Real, vector(&body.inertia)))
        .can_sleep(sleeping)
}

impl World {
    fn new(plan: &WorldPlan) -> World {
        let mut physics = PhysicsWorld::default();
        physics.gravity = vector(&plan.gravity);
        #[cfg(feature = "threads")]
        physics.physics_pipeline.configure_thread_pool(plan.threads).expect("the machine has threads");
        if let Some(n) = plan.dial(c"iterations") {
            physics.integration_parameters.num_solver_iterations = n as usize;
        }
        if let Some(hz) = plan.dial(c"frequency") {
            physics.integration_parameters.contact_softness.natural_frequency = hz as Real;
        }
        let ground_half_width = plan.ground_half_width();
        let mut shapes: HashMap<*const f64, Option<SharedShape>> = HashMap::new();
        let mut bodies = Vec::new();
        for body in plan.bodies() {
            let handle = physics.insert_body(rigid_body(body, plan.sleeping));
            let shape = shapes.entry(body.params().as_ptr()).or_insert_with(|| shape(body, ground_half_width)).clone();
            if let Some(shape) = shape {
                physics.insert_collider(collider(body, shape), Some(handle));
            }
            bodies.push(handle);
        }
        let mut ground = None;
        for joint in plan.joints() {
            let mut end = |i: usize| match i {
                plan::WORLD_BODY => *ground.get_or_insert_with(|| physics.insert_body(RigidBodyBuilder::fixed())),
                _ => bodies[i],
            };
            let (a, b) = (end(joint.a), end(joint.b));
            if joint.kind == plan::SLIDER {
                physics.insert_impulse_joint(a, b, slider(joint));
                continue;
            }
            let ball = SphericalJointBuilder::new()
                .local_anchor1(vector(&joint.on_a))
                .local_anchor2(vector(&joint.on_b))
                .contacts_enabled(false);
            physics.insert_impulse_joint(a, b, ball);
        }
        World { physics, bodies, rays_ready: false, pushed: Vec::new() }
    }

    /// A world that was never stepped has no tree yet.
    fn prepare_rays(&mut self) {
        if !self.rays_ready {
            self.physics.detect_collisions(&(), &());
        }
        self.rays_ready = true;
    }

    fn cast(&self, ends: &[f64]) -> f64 {
        let ray = Ray::new(vector(ends), vector(&ends[3..]) - vector(ends));
        let hit = self.physics.cast_ray(&ray, 1.0, true, QueryFilter::default());
        hit.map_or(2.0, |(_, fraction)| fraction as f64)
    }
}

unsafe fn world<'a>(world: *mut c_void) -> &'a mut World {
    &mut *world.cast::<World>()
}

#[no_mangle]
unsafe extern "C" fn carom_rust_make(plan: *const WorldPlan) -> *mut c_void {
    Box::into_raw(Box::new(World::new(&*plan))).cast()
}

#[no_mangle]
unsafe extern "C" fn carom_rust_free(world: *mut c_void) {
    drop(Box::from_raw(world.cast::<World>()));
}

#[no_mangle]
unsafe extern "C" fn carom_rust_step(handle: *mut c_void, dt: f64) {
    let world = world(handle);
    world.physics.integration_parameters.dt = dt as Real;
    world.physics.step();
    for i in world.pushed.drain(..) {
        world.physics.bodies[world.bodies[i]].reset_forces(true);
    }
    world.rays_ready = true;
}

/// For the next step alone.
#[no_mangle]
unsafe extern "C" fn carom_rust_push(handle: *mut c_void, body: usize, force: *const f64) {
    let world = world(handle);
    let force = vector(std::slice::from_raw_parts(force, 3));
    world.physics.bodies[world.bodies[body]].add_force(force, true);
    world.pushed.push(body);
}

#[no_mangle]
unsafe extern "C" fn carom_rust_read(handle: *mut c_void, states: *mut BodyState) {
    let world = world(handle);
    for (i, &handle) in world.bodies.iter().enumerate() {
        let body = &world.physics.bodies[handle];
        let q = body.rotation();
        *states.add(i) = BodyState {
            position: wide(body.translation()),
            orientation: [q.x as f64, q.y as f64, q.z as f64, q.w as f64],
            velocity: wide(body.linvel()),
            omega: wide(body.angvel()),
        };
    }
}

#[no_mangle]
unsafe extern "C" fn carom_rust_contact_points(handle: *mut c_void) -> usize {
    let pairs = world(handle).physics.contact_pairs();
    pairs.flat_map(|pair| pair.manifolds()).map(|manifold| manifold.points.len()).sum()
}

#[no_mangle]
unsafe extern "C" fn carom_rust_cast_rays(handle: *mut c_void, ends: *const f64, n: usize, fractions: *mut f64) {
    let world = world(handle);
    world.prepare_rays();
    for i in 0..n {
        *fractions.add(i) = world.cast(std::slice::from_raw_parts(ends.add(6 * i), 6));
    }
}

#[no_mangle]
extern "C" fn carom_rust_live_bytes() -> usize {
    counted::live()
}

#[no_mangle]
extern "C" fn carom_rust_name() -> *const c_char {
    NAME.as_ptr()
}

#[no_mangle]
extern "C" fn carom_rust_threads() -> usize {
    if cfg!(feature = "threads") {
        usize::MAX
    } else {
        1
    }
}

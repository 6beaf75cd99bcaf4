//! s_table's peer.h as Rust sees it. `rapier/adapter.cpp` checks that both have the same layout.

use std::ffi::{c_char, c_void};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct BodyState {
    pub position: [f64; 3],
    pub orientation: [f64; 4],
    pub velocity: [f64; 3],
    pub omega: [f64; 3],
}

pub const NONE: i32 = 0;
pub const HALF_SPACE: i32 = 1;
pub const SPHERE: i32 = 2;
pub const BOX: i32 = 3;
pub const HULL: i32 = 4;
pub const CAPSULE: i32 = 5;
pub const CYLINDER: i32 = 6;
pub const CONE: i32 = 7;

pub const SLIDER: i32 = 1;

#[repr(C)]
pub struct BodyPlan {
    pub solid: i32,
    params: *const f64,
    param_count: usize,
    _triangles: *const u32,
    _triangle_count: usize,
    pub is_static: bool,
    pub mass: f64,
    pub inertia: [f64; 3],
    pub friction: f64,
    pub restitution: f64,
    pub shape_at: [f64; 3],
    pub start: BodyState,
}

impl BodyPlan {
    /// Bodies of one shape share the address.
    pub fn params(&self) -> &[f64] {
        if self.params.is_null() {
            return &[];
        }
        unsafe { std::slice::from_raw_parts(self.params, self.param_count) }
    }
}

/// m: of a box in the place of a half-space.
pub const GROUND_HALF_DEPTH: f64 = 10.0;

pub const WORLD_BODY: usize = usize::MAX;

#[repr(C)]
pub struct JointPlan {
    pub a: usize,
    pub b: usize,
    pub on_a: [f64; 3],
    pub on_b: [f64; 3],
    pub kind: i32,
    pub axes_on_a: [f64; 4],
    pub axes_on_b: [f64; 4],
    pub motor_speed: f64,
    pub motor_force: f64,
    pub stiffness: f64,
    pub damping: f64,
    pub target: f64,
}

#[repr(C)]
pub struct PeerDial {
    name: *const c_char,
    value: f64,
}

#[repr(C)]
pub struct WorldPlan {
    bodies: *const BodyPlan,
    count: usize,
    joints: *const JointPlan,
    joint_count: usize,
    pub gravity: [f64; 3],
    dials: *const PeerDial,
    dial_count: usize,
    pub sleeping: bool,
    pub threads: usize,
}

impl WorldPlan {
    pub fn bodies(&self) -> &[BodyPlan] {
        unsafe { slice(self.bodies, self.count) }
    }
    pub fn joints(&self) -> &[JointPlan] {
        unsafe { slice(self.joints, self.joint_count) }
    }
    /// What the engine is asked to do otherwise than by default; which names it has, its module says.
    pub fn dial(&self, name: &std::ffi::CStr) -> Option<f64> {
        let dials = unsafe { slice(self.dials, self.dial_count) };
        dials.iter().find(|dial| unsafe { std::ffi::CStr::from_ptr(dial.name) } == name).map(|dial| dial.value)
    }
    /// As `ground.h` has it.
    pub fn ground_half_width(&self) -> f64 {
        let dynamic = self.bodies().iter().filter(|body| !body.is_static);
        let reach = dynamic.flat_map(|body| body.start.position).fold(0.0, |far: f64, x| far.max(x.abs()));
        reach + 30.0
    }
}

unsafe fn slice<'a, T>(start: *const T, count: usize) -> &'a [T] {
    if count == 0 {
        &[]
    } else {
        std::slice::from_raw_parts(start, count)
    }
}

/// What a module exports as `carom_bench_engine`: C++ makes it, Rust hands it on, for a shared object made by cargo
/// exports what is written in Rust alone.
#[repr(C)]
pub struct PeerEngine {
    name: *const c_char,
    make: *const c_void,
    live_bytes: *const c_void,
    threads: usize,
}

/// The three questions that a module answers: s_table's, casts_vs_peers', convex_vs_peers'.
#[macro_export]
macro_rules! export_engine {
    () => {
        extern "C" {
            fn carom_peer_engine() -> $crate::PeerEngine;
            fn carom_peer_casts(i: i32) -> *const std::ffi::c_void;
            fn carom_peer_pairs(i: i32) -> *const std::ffi::c_void;
        }
        #[no_mangle]
        pub extern "C" fn carom_bench_engine() -> $crate::PeerEngine {
            unsafe { carom_peer_engine() }
        }
        #[no_mangle]
        pub extern "C" fn carom_bench_cast_peer(i: i32) -> *const std::ffi::c_void {
            unsafe { carom_peer_casts(i) }
        }
        #[no_mangle]
        pub extern "C" fn carom_bench_peer(i: i32) -> *const std::ffi::c_void {
            unsafe { carom_peer_pairs(i) }
        }
    };
}

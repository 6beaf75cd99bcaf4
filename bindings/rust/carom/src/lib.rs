//! Carom, a rigid-body physics engine: the same bits on every machine, shapes of your own. SI units, radians, quaternions x, y, z, w.
//!
//! Methods have the names of C's functions without the noun: [`World::set_velocity`] is `carom_body_set_velocity()`. [`raw`] is all of
//! the C interface; [`Engine::call`] and [`World::call`] make the calls that have no method.

#[rustfmt::skip]
mod calls;
mod error;
mod support;
#[cfg(test)]
mod tests;

pub use calls::Scalar;
pub use carom_sys as raw;
pub use error::{Error, Result};
pub use raw::{
    carom_body as Body, carom_body_desc as BodyDesc, carom_collider_desc as ColliderDesc, carom_contact as Contact,
    carom_joint as Joint, carom_joint_desc as JointDesc, carom_material as Material,
    carom_material_desc as MaterialDesc, carom_plugin as Plugin, carom_shape as Shape, carom_step_report as StepReport,
    carom_world_desc as WorldDesc,
};
pub use support::Param;

use error::{check, check_library};
use std::ptr::{null, null_mut};
use std::sync::{Arc, Mutex};

/// Owns plugins and shapes, makes worlds. A clone is the same engine; it lives as long as one of them, or a world of it.
#[derive(Clone)]
pub struct Engine(Arc<Owner>);

struct Owner {
    pointer: *mut raw::carom_engine,
    #[allow(clippy::vec_box)]
    supports: Mutex<Vec<Box<support::Kept>>>, // what C has pointers to, until the engine is gone
}

// Any thread may use an engine, at any time; so it is of a world, which says Busy to a second writer.
unsafe impl Send for Owner {}
unsafe impl Sync for Owner {}
unsafe impl Send for World {}
unsafe impl Sync for World {}

impl Drop for Owner {
    fn drop(&mut self) {
        unsafe { raw::carom_engine_destroy(self.pointer, null_mut()) };
    }
}

impl Engine {
    pub fn new() -> Result<Engine> {
        check_library()?;
        let mut pointer = null_mut();
        check(|e| unsafe { raw::carom_engine_create(null(), &mut pointer, e) })?;
        let engine = Engine(Arc::new(Owner { pointer, supports: Mutex::default() }));
        // Where shapes are linked in (feature vendored) they are there; else they are files.
        match engine.register_standard() {
            Err(error) if error.code != raw::CAROM_E_UNSUPPORTED => Err(error),
            _ => Ok(engine),
        }
    }

    /// Any call of the C interface on this engine.
    pub fn call(&self, call: impl FnOnce(*mut raw::carom_engine, *mut raw::carom_error) -> i32) -> Result<()> {
        check(|e| call(self.0.pointer, e))
    }

    /// How many threads share the work of a step, before the first world is made; the outcome is the same to the bit.
    pub fn set_threads(&self, threads: u32) -> Result<()> {
        let jobs = raw::carom_jobs_desc { threads, ..Default::default() };
        self.call(|p, e| unsafe { raw::carom_engine_set_jobs(p, &jobs, e) })
    }

    pub fn world(&self) -> Result<World> {
        self.world_with(&WorldDesc::default())
    }

    pub fn world_with(&self, desc: &WorldDesc) -> Result<World> {
        let mut pointer = null_mut();
        self.call(|p, e| unsafe { raw::carom_world_create(p, desc, &mut pointer, e) })?;
        Ok(World { pointer, engine: self.clone() })
    }
}

/// Bodies and what acts on them. Handles of bodies, joints and materials are numbers, which the library validates in every call.
pub struct World {
    pointer: *mut raw::carom_world,
    engine: Engine,
}

impl Drop for World {
    fn drop(&mut self) {
        unsafe { raw::carom_world_destroy(self.pointer, null_mut()) };
    }
}

impl World {
    /// Any call of the C interface on this world: `world.call(|p, e| unsafe { raw::carom_world_cast_rays(p, &rays, want, null(), &hits, e) })`.
    #[inline]
    pub fn call(&self, call: impl FnOnce(*mut raw::carom_world, *mut raw::carom_error) -> i32) -> Result<()> {
        check(|e| call(self.pointer, e))
    }

    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// A body of one shape, of density 1000.
    pub fn body(&mut self, shape: Shape, desc: &BodyDesc) -> Result<Body> {
        self.body_of(desc, &[ColliderDesc { shape, ..Default::default() }])
    }

    /// A body of any number of shapes.
    pub fn body_of(&mut self, desc: &BodyDesc, parts: &[ColliderDesc]) -> Result<Body> {
        let mut body = Body::default();
        self.call(|p, e| unsafe { raw::carom_body_create(p, desc, &mut body, e) })?;
        let made = parts.iter().try_for_each(|part| self.collider(body, part).map(drop));
        made.or_else(|error| self.destroy(body).and(Err(error)))?;
        Ok(body)
    }

    /// A static half-space below `height`.
    pub fn ground(&mut self, height: f64) -> Result<Body> {
        let shape = self.engine.shape("half_space", &[0.0, 1.0, 0.0, height])?;
        self.body(shape, &BodyDesc { r#type: raw::CAROM_BODY_STATIC, ..Default::default() })
    }

    pub fn position(&self, body: Body) -> Result<[f64; 3]> {
        Ok(self.pose(body)?.0)
    }

    /// Of all bodies, in the order of [`World::bodies`].
    pub fn positions(&self, dst: &mut [[f64; 3]]) -> Result<()> {
        self.read(raw::CAROM_FIELD_POSITION, None, dst)
    }

    /// Position and quaternion of all bodies, in the order of [`World::bodies`].
    pub fn poses(&self, dst: &mut [[f64; 7]]) -> Result<()> {
        self.read(raw::CAROM_FIELD_POSE, None, dst)
    }

    /// A copy that goes on bit for bit as this world does.
    pub fn fork(&self) -> Result<World> {
        let mut pointer = null_mut();
        self.call(|p, e| unsafe { raw::carom_world_fork(p, &mut pointer, e) })?;
        Ok(World { pointer, engine: self.engine.clone() })
    }
}

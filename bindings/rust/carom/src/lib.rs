//! Carom, a rigid-body physics engine: the same bits on every machine, shapes of your own. SI units, radians, quaternions x, y, z, w.
//!
//! [`raw`] is all of the C interface; [`Engine::call`] and [`World::call`] make the calls that have no method here.

mod bulk;
mod error;
mod support;

pub use bulk::{Pose, Scalar};
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
use std::ffi::{c_void, CString};
use std::mem::size_of;
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
        match engine.call(|p, e| unsafe { raw::carom_plugins_register_standard(p, e) }) {
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

    /// A shape by the name of its plugin: "sphere", "box", "half_space", or one on `$CAROM_PLUGIN_PATH`.
    pub fn shape(&self, name: &str, params: &[f64]) -> Result<Shape> {
        let (name, mut shape) = (text(name)?, Shape::default());
        self.call(|p, e| unsafe {
            raw::carom_shape_create_named(p, name.as_ptr(), params.as_ptr(), params.len() as u64, &mut shape, e)
        })?;
        Ok(shape)
    }

    pub fn shape_of(&self, plugin: Plugin, params: &[f64]) -> Result<Shape> {
        let mut shape = Shape::default();
        self.call(|p, e| unsafe {
            raw::carom_shape_create(p, plugin, params.as_ptr(), params.len() as u64, &mut shape, e)
        })?;
        Ok(shape)
    }

    /// A kind of shape whose support function is a closure, from parameters and a direction to the farthest point
    /// ([`raw::carom_support_fn`]). It is called on any thread. A panic in it is a fault of the shape.
    pub fn plugin<F>(&self, id: &str, params: &[Param], support: F) -> Result<Plugin>
    where
        F: Fn(&[f64], [f64; 3]) -> [f64; 3] + Send + Sync + 'static,
    {
        let kept = support::Kept::new(id, params, Box::new(support))?;
        let mut plugin = Plugin::default();
        let description = kept.description();
        let registered = self.call(|p, e| unsafe { raw::carom_plugin_register(p, &description, &mut plugin, e) });
        self.0.supports.lock().unwrap().push(kept);
        registered.map(|()| plugin)
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

fn text(text: &str) -> Result<CString> {
    let refused = |_| Error::new(raw::CAROM_E_OUT_OF_RANGE, format!("{text:?} has a zero byte"), "leave it out");
    CString::new(text).map_err(refused)
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
    /// Any call of the C interface on this world: `world.call(|p, e| unsafe { raw::carom_body_wake(p, body, e) })`.
    #[inline]
    pub fn call(&self, call: impl FnOnce(*mut raw::carom_world, *mut raw::carom_error) -> i32) -> Result<()> {
        check(|e| call(self.pointer, e))
    }

    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Advance by `dt`, s.
    pub fn step(&mut self, dt: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_step(p, dt, e) })
    }

    /// @param dial  `raw::CAROM_DIAL_*`
    pub fn set_dial(&mut self, dial: u32, value: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_dial(p, dial, value, e) })
    }

    pub fn hash(&self) -> Result<u64> {
        let mut hash = 0;
        self.call(|p, e| unsafe { raw::carom_world_hash(p, &mut hash, e) })?;
        Ok(hash)
    }

    pub fn report(&self) -> Result<StepReport> {
        let mut report = StepReport::default();
        self.call(|p, e| unsafe { raw::carom_world_get_report(p, &mut report, e) })?;
        Ok(report)
    }

    pub fn material(&mut self, desc: &MaterialDesc) -> Result<Material> {
        let mut material = Material::default();
        self.call(|p, e| unsafe { raw::carom_material_create(p, desc, &mut material, e) })?;
        Ok(material)
    }

    /// A body of one shape, of density 1000.
    pub fn body(&mut self, shape: Shape, desc: &BodyDesc) -> Result<Body> {
        self.body_of(desc, &[ColliderDesc { shape, ..Default::default() }])
    }

    /// A body of any number of shapes.
    pub fn body_of(&mut self, desc: &BodyDesc, parts: &[ColliderDesc]) -> Result<Body> {
        let (mut body, mut collider) = (Body::default(), raw::carom_collider::default());
        self.call(|p, e| unsafe { raw::carom_body_create(p, desc, &mut body, e) })?;
        for part in parts {
            if let Err(error) = self.call(|p, e| unsafe { raw::carom_collider_create(p, body, part, &mut collider, e) })
            {
                self.destroy(body)?;
                return Err(error);
            }
        }
        Ok(body)
    }

    /// A static half-space below `height`.
    pub fn ground(&mut self, height: f64) -> Result<Body> {
        let shape = self.engine.shape("half_space", &[0.0, 1.0, 0.0, height])?;
        self.body(shape, &BodyDesc { r#type: raw::CAROM_BODY_STATIC, ..Default::default() })
    }

    pub fn destroy(&mut self, body: Body) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_destroy(p, body, e) })
    }

    pub fn joint(&mut self, desc: &JointDesc) -> Result<Joint> {
        let mut joint = Joint::default();
        self.call(|p, e| unsafe { raw::carom_joint_create(p, desc, &mut joint, e) })?;
        Ok(joint)
    }

    pub fn position(&self, body: Body) -> Result<[f64; 3]> {
        let mut position = [0.0; 3];
        self.call(|p, e| unsafe { raw::carom_body_get_pose(p, body, position.as_mut_ptr(), null_mut(), e) })?;
        Ok(position)
    }

    pub fn pose(&self, body: Body) -> Result<Pose> {
        let mut pose = Pose::default();
        let (position, orientation) = (pose.position.as_mut_ptr(), pose.orientation.as_mut_ptr());
        self.call(|p, e| unsafe { raw::carom_body_get_pose(p, body, position, orientation, e) })?;
        Ok(pose)
    }

    pub fn set_pose(&mut self, body: Body, pose: &Pose) -> Result<()> {
        self.call(|p, e| unsafe {
            raw::carom_body_set_pose(p, body, pose.position.as_ptr(), pose.orientation.as_ptr(), e)
        })
    }

    pub fn set_velocity(&mut self, body: Body, linear: [f64; 3], angular: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_velocity(p, body, linear.as_ptr(), angular.as_ptr(), e) })
    }

    /// For the next step. @param force  N   @param torque  N m
    pub fn add_force(&mut self, body: Body, force: [f64; 3], torque: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_add_force(p, body, force.as_ptr(), torque.as_ptr(), e) })
    }

    pub fn contacts(&self) -> Result<Vec<Contact>> {
        let stride = size_of::<Contact>() as u64;
        self.list(|p, dst, capacity, count, e| unsafe {
            raw::carom_world_get_contacts(p, dst, stride, capacity, count, e)
        })
    }

    /// @param flags  `raw::CAROM_SNAPSHOT_*`
    pub fn save(&self, flags: u32) -> Result<Vec<u8>> {
        self.list(|p, dst: *mut u8, capacity, count, e| {
            match unsafe { raw::carom_world_save(p, flags, dst.cast::<c_void>(), capacity, count, e) } {
                raw::CAROM_E_BUFFER_TOO_SMALL => raw::CAROM_OK, // list() asks again
                result => result,
            }
        })
    }

    pub fn restore(&mut self, bytes: &[u8]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_restore(p, bytes.as_ptr().cast(), bytes.len() as u64, e) })
    }

    /// A copy that goes on bit for bit as this world does.
    pub fn fork(&self) -> Result<World> {
        let mut pointer = null_mut();
        self.call(|p, e| unsafe { raw::carom_world_fork(p, &mut pointer, e) })?;
        Ok(World { pointer, engine: self.engine.clone() })
    }

    /// All of a list that says how many there are: asked for none first, then for all.
    fn list<T>(
        &self,
        ask: impl Fn(*mut raw::carom_world, *mut T, u64, *mut u64, *mut raw::carom_error) -> i32,
    ) -> Result<Vec<T>> {
        let (mut all, mut count) = (Vec::new(), 0);
        self.call(|p, e| ask(p, null_mut(), 0, &mut count, e))?;
        while count > all.capacity() as u64 {
            all.reserve(count as usize);
            let capacity = all.capacity() as u64;
            self.call(|p, e| ask(p, all.as_mut_ptr(), capacity, &mut count, e))?;
        }
        unsafe { all.set_len(count as usize) }; // as many were written: it was at most the capacity
        Ok(all)
    }
}

//! A closure as the support function of a plugin.
use crate::{calls::text, raw, Engine, Plugin, Result};
use std::ffi::{c_void, CString};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// A parameter of a kind of shape: a value outside [min, max] is refused when a shape is made.
pub struct Param<'a> {
    pub name: &'a str,
    /// "m"; "1" of a number without a dimension
    pub unit: &'a str,
    pub min: f64,
    pub max: f64,
}

impl Engine {
    /// A kind of shape whose support function is a closure, from parameters and a direction to the farthest point
    /// ([`raw::carom_support_fn`]). It is called on any thread. A panic in it is a fault of the shape.
    pub fn plugin<F>(&self, id: &str, params: &[Param], support: F) -> Result<Plugin>
    where
        F: Fn(&[f64], [f64; 3]) -> [f64; 3] + Send + Sync + 'static,
    {
        let kept = Kept::new(id, params, Box::new(support))?;
        let mut plugin = Plugin::default();
        let description = kept.description();
        let registered = self.call(|p, e| unsafe { raw::carom_plugin_register(p, &description, &mut plugin, e) });
        self.0.supports.lock().unwrap().push(kept);
        registered.map(|()| plugin)
    }
}

type Support = dyn Fn(&[f64], [f64; 3]) -> [f64; 3] + Send + Sync;

/// What the library has pointers to as long as the engine lives. In a Box: it does not move.
pub(crate) struct Kept {
    id: CString,
    _texts: Vec<CString>,
    params: Vec<raw::carom_param>,
    support: Box<Support>,
}

impl Kept {
    pub fn new(id: &str, params: &[Param], support: Box<Support>) -> Result<Box<Kept>> {
        let mut texts = Vec::new();
        let mut table = Vec::new();
        for p in params {
            let (name, unit) = (text(p.name)?, text(p.unit)?);
            table.push(raw::carom_param { name: name.as_ptr(), unit: unit.as_ptr(), min: p.min, max: p.max });
            texts.extend([name, unit]); // what they point to stays where it is
        }
        Ok(Box::new(Kept { id: text(id)?, _texts: texts, params: table, support }))
    }

    pub fn description(&self) -> raw::carom_shape_plugin {
        raw::carom_shape_plugin {
            abi_major: raw::CAROM_PLUGIN_ABI_MAJOR,
            abi_minor: raw::CAROM_PLUGIN_ABI_MINOR,
            id: self.id.as_ptr(),
            version: 1,
            param_count: self.params.len() as u32,
            params: self.params.as_ptr(),
            support: Some(call),
            user: (self as *const Kept).cast_mut().cast(),
            ..Default::default()
        }
    }
}

unsafe extern "C" fn call(user: *mut c_void, params: *const f64, n: u64, direction: *const f64, out: *mut f64) -> i32 {
    let kept = unsafe { &*user.cast::<Kept>() };
    let params = if n == 0 { &[] } else { unsafe { std::slice::from_raw_parts(params, n as usize) } };
    let direction = unsafe { *direction.cast::<[f64; 3]>() };
    match catch_unwind(AssertUnwindSafe(|| (kept.support)(params, direction))) {
        Ok(point) => {
            unsafe { *out.cast::<[f64; 3]>() = point };
            0
        }
        Err(_) => 1,
    }
}

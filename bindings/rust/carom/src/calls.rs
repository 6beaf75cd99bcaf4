//! Calls of the interface as methods. Written by bindings/gen/generate from include/carom; do not edit.
#![allow(rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items, clippy::too_many_arguments, clippy::type_complexity)]
use crate::{raw, Engine, Error, Result, World};
use std::ffi::CString;
use std::mem::size_of;
use std::ptr::null;

/// Numbers of arrays: f32 or f64.
/// # Safety
/// `SCALAR` says what the type is.
pub unsafe trait Scalar: Copy {
    const SCALAR: u32;
}
unsafe impl Scalar for f32 {
    const SCALAR: u32 = raw::CAROM_SCALAR_F32;
}
unsafe impl Scalar for f64 {
    const SCALAR: u32 = raw::CAROM_SCALAR_F64;
}

fn refused(message: String, remedy: &str) -> Error {
    Error { code: raw::CAROM_E_OUT_OF_RANGE, argument: 0, message, remedy: remedy.into(), witness: None }
}

/// What C takes as a text.
pub(crate) fn text(text: &str) -> Result<CString> {
    CString::new(text).map_err(|_| refused(format!("{text:?} has a zero byte"), "leave it out"))
}

/// Whether slices that go together are of one length.
fn fits(n: usize, wanted: u64) -> Result<()> {
    let unlike = || refused(format!("{n} where {wanted} are wanted"), "pass slices of one length");
    (n as u64 == wanted).then_some(()).ok_or_else(unlike)
}

impl World {
    /// All of a list that says how many there are: asked for none first, then for all.
    fn list<T>(
        &self,
        ask: impl Fn(*mut raw::carom_world, *mut T, u64, *mut u64, *mut raw::carom_error) -> i32,
    ) -> Result<Vec<T>> {
        let (mut all, mut count) = (Vec::new(), 0);
        loop {
            let room = all.capacity() as u64;
            match self.call(|p, e| ask(p, all.as_mut_ptr(), room, &mut count, e)) {
                Err(error) if error.code != raw::CAROM_E_BUFFER_TOO_SMALL || count <= room => return Err(error),
                _ if count > room => all.reserve(count as usize), // some say so by that error
                _ => break,
            }
        }
        unsafe { all.set_len(count as usize) }; // as many were written: it was at most the capacity
        Ok(all)
    }
}

impl Engine {
    /// Cast the ray origin + t direction, 0 <= t <= max, against a shape.
    /// @param position, orientation  of the shape: [3] m, [4] x, y, z, w
    /// @param origin [3] m   @param direction [3] m per unit of t, any length; zero asks whether the origin is inside
    /// @param max    >= 0, may be infinite
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED
    pub fn ray_cast(&self, shape: raw::carom_shape, position: [f64; 3], orientation: [f64; 4], origin: [f64; 3], direction: [f64; 3], max: f64, desc: Option<&raw::carom_cast_desc>) -> Result<raw::carom_cast> {
        let desc = desc.map(|it| raw::carom_cast_desc { struct_size: size_of::<raw::carom_cast_desc>() as u32, ..*it });
        let mut result = <raw::carom_cast>::default();
        self.call(|p, e| unsafe { raw::carom_ray_cast(p, shape, position.as_ptr(), orientation.as_ptr(), origin.as_ptr(), direction.as_ptr(), max, desc.as_ref().map_or(null(), |it| it), &mut result, e) })?;
        Ok(result)
    }

    /// Move shape A along a straight line, without turning it, until it touches B.
    /// @param motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller
    /// @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
    ///         half-spaces)
    pub fn shape_cast(&self, shape_a: raw::carom_shape, position_a: [f64; 3], orientation_a: [f64; 4], motion: [f64; 3], shape_b: raw::carom_shape, position_b: [f64; 3], orientation_b: [f64; 4], desc: Option<&raw::carom_cast_desc>) -> Result<raw::carom_cast> {
        let desc = desc.map(|it| raw::carom_cast_desc { struct_size: size_of::<raw::carom_cast_desc>() as u32, ..*it });
        let mut result = <raw::carom_cast>::default();
        self.call(|p, e| unsafe { raw::carom_shape_cast(p, shape_a, position_a.as_ptr(), orientation_a.as_ptr(), motion.as_ptr(), shape_b, position_b.as_ptr(), orientation_b.as_ptr(), desc.as_ref().map_or(null(), |it| it), &mut result, e) })?;
        Ok(result)
    }

    /// First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
    /// touches before `lower`.
    /// @param motion_*  struct_size set by carom_motion_init()   @param duration s, 0 to 1e9
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller; times in s
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
    ///         UNSUPPORTED (two half-spaces, or one that turns)
    pub fn shape_time_of_impact(&self, shape_a: raw::carom_shape, motion_a: &raw::carom_motion, shape_b: raw::carom_shape, motion_b: &raw::carom_motion, duration: f64, desc: Option<&raw::carom_cast_desc>) -> Result<raw::carom_cast> {
        let motion_a = raw::carom_motion { struct_size: size_of::<raw::carom_motion>() as u32, ..*motion_a };
        let motion_b = raw::carom_motion { struct_size: size_of::<raw::carom_motion>() as u32, ..*motion_b };
        let desc = desc.map(|it| raw::carom_cast_desc { struct_size: size_of::<raw::carom_cast_desc>() as u32, ..*it });
        let mut result = <raw::carom_cast>::default();
        self.call(|p, e| unsafe { raw::carom_shape_time_of_impact(p, shape_a, &motion_a, shape_b, &motion_b, duration, desc.as_ref().map_or(null(), |it| it), &mut result, e) })?;
        Ok(result)
    }

    /// Do two shapes overlap (or come nearer than desc->target)? Cheaper than their distance, with a proof of yes or no.
    /// @param desc   may be NULL: defaults; tolerance is not used   @param result struct_size set by the caller
    /// @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
    ///         half-spaces)
    pub fn shape_overlap(&self, shape_a: raw::carom_shape, position_a: [f64; 3], orientation_a: [f64; 4], shape_b: raw::carom_shape, position_b: [f64; 3], orientation_b: [f64; 4], desc: Option<&raw::carom_cast_desc>) -> Result<raw::carom_overlap> {
        let desc = desc.map(|it| raw::carom_cast_desc { struct_size: size_of::<raw::carom_cast_desc>() as u32, ..*it });
        let mut result = <raw::carom_overlap>::default();
        self.call(|p, e| unsafe { raw::carom_shape_overlap(p, shape_a, position_a.as_ptr(), orientation_a.as_ptr(), shape_b, position_b.as_ptr(), orientation_b.as_ptr(), desc.as_ref().map_or(null(), |it| it), &mut result, e) })?;
        Ok(result)
    }

    /// Load a shape plugin from a shared object. @param path absolute.
    /// The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
    /// the bounds allow. Loading the same path twice is ALREADY_EXISTS.
    /// @status OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY
    pub fn plugin_load(&self, path: &str) -> Result<raw::carom_plugin> {
        let path = text(path)?;
        let mut plugin = <raw::carom_plugin>::default();
        self.call(|p, e| unsafe { raw::carom_plugin_load(p, path.as_ptr(), &mut plugin, e) })?;
        Ok(plugin)
    }

    /// Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
    /// WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY
    pub fn register_standard(&self) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_plugins_register_standard(p, e) })
    }

    /// Forget a plugin (logically: the code stays mapped).   @status OK; NULL_ARGUMENT; IN_USE (shapes of it live);
    /// *_HANDLE; REENTRANT
    pub fn plugin_unload(&self, plugin: raw::carom_plugin) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_plugin_unload(p, plugin, e) })
    }

    /// Find a loaded plugin by its id.
    /// @param id as in carom_shape_plugin.id
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (load it first)
    pub fn plugin_find(&self, id: &str) -> Result<raw::carom_plugin> {
        let id = text(id)?;
        let mut plugin = <raw::carom_plugin>::default();
        self.call(|p, e| unsafe { raw::carom_plugin_find(p, id.as_ptr(), &mut plugin, e) })?;
        Ok(plugin)
    }

    /// Signed distance of two shapes.
    /// @param position_*     [3] m     @param orientation_* [4] x, y, z, w
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
    ///         UNSUPPORTED (two half-spaces)
    pub fn shape_distance(&self, shape_a: raw::carom_shape, position_a: [f64; 3], orientation_a: [f64; 4], shape_b: raw::carom_shape, position_b: [f64; 3], orientation_b: [f64; 4], desc: Option<&raw::carom_distance_desc>) -> Result<raw::carom_distance> {
        let desc = desc.map(|it| raw::carom_distance_desc { struct_size: size_of::<raw::carom_distance_desc>() as u32, ..*it });
        let mut result = <raw::carom_distance>::default();
        self.call(|p, e| unsafe { raw::carom_shape_distance(p, shape_a, position_a.as_ptr(), orientation_a.as_ptr(), shape_b, position_b.as_ptr(), orientation_b.as_ptr(), desc.as_ref().map_or(null(), |it| it), &mut result, e) })?;
        Ok(result)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE; UNSUPPORTED (a convex shape)
    pub fn shape_scenery_info(&self, shape: raw::carom_shape) -> Result<raw::carom_scenery_info> {
        let mut info = <raw::carom_scenery_info>::default();
        self.call(|p, e| unsafe { raw::carom_shape_get_scenery_info(p, shape, &mut info, e) })?;
        Ok(info)
    }

    /// Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
    /// scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
    /// @param params [count] doubles, meaning as the plugin documents
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
    ///         PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY
    pub fn shape_of(&self, plugin: raw::carom_plugin, params: &[f64]) -> Result<raw::carom_shape> {
        let mut shape = <raw::carom_shape>::default();
        let count = params.len() as u64;
        self.call(|p, e| unsafe { raw::carom_shape_create(p, plugin, params.as_ptr(), count, &mut shape, e) })?;
        Ok(shape)
    }

    /// Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
    /// engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
    /// and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
    /// privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
    /// z, offset.
    /// @param name 1 to 64 letters, digits, _, - and dots   @param params [count] as carom_shape_create()
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
    ///         PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY
    pub fn shape(&self, name: &str, params: &[f64]) -> Result<raw::carom_shape> {
        let name = text(name)?;
        let mut shape = <raw::carom_shape>::default();
        let count = params.len() as u64;
        self.call(|p, e| unsafe { raw::carom_shape_create_named(p, name.as_ptr(), params.as_ptr(), count, &mut shape, e) })?;
        Ok(shape)
    }

    /// The built-in half-space { x : normal . x <= offset } in the shape's own frame; unbounded, so static bodies only.
    /// @param normal [3] unit (within 1e-6)   @param offset m
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY
    pub fn shape_create_half_space(&self, normal: [f64; 3], offset: f64) -> Result<raw::carom_shape> {
        let mut shape = <raw::carom_shape>::default();
        self.call(|p, e| unsafe { raw::carom_shape_create_half_space(p, normal.as_ptr(), offset, &mut shape, e) })?;
        Ok(shape)
    }

    /// Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
    /// same call makes
    /// - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
    ///   of both ends leaves out what bulges between them: add poses in between;
    /// - a scaled shape: one part with a scale. A negative scale mirrors it;
    /// - a rounded shape: one part and a radius, by which it grows on all sides.
    /// Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
    /// corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
    /// the hull.
    /// @param parts         [count] handles of convex shapes, the same one as often as wanted
    /// @param count         1 to 4096
    /// @param positions     [3 * count] m, frame of the hull; NULL: 0
    /// @param orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
    /// @param scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
    /// @param radius        m, 0 or more
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
    ///         PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
    /// @since 0.9
    pub fn shape_create_hull_of(&self, parts: &[raw::carom_shape], positions: Option<&[[f64; 3]]>, orientations: Option<&[[f64; 4]]>, scales: Option<&[[f64; 3]]>, radius: f64) -> Result<raw::carom_shape> {
        let mut shape = <raw::carom_shape>::default();
        let count = parts.len() as u64;
        positions.map_or(Ok(()), |it| fits(it.len(), count))?;
        orientations.map_or(Ok(()), |it| fits(it.len(), count))?;
        scales.map_or(Ok(()), |it| fits(it.len(), count))?;
        self.call(|p, e| unsafe { raw::carom_shape_create_hull_of(p, parts.as_ptr(), count, positions.map_or(null(), |it| it.as_ptr().cast()), orientations.map_or(null(), |it| it.as_ptr().cast()), scales.map_or(null(), |it| it.as_ptr().cast()), radius, &mut shape, e) })?;
        Ok(shape)
    }

    /// @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
    ///         it); REENTRANT
    pub fn shape_destroy(&self, shape: raw::carom_shape) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_shape_destroy(p, shape, e) })
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE
    pub fn shape_info(&self, shape: raw::carom_shape) -> Result<raw::carom_shape_info> {
        let mut info = <raw::carom_shape_info>::default();
        self.call(|p, e| unsafe { raw::carom_shape_get_info(p, shape, &mut info, e) })?;
        Ok(info)
    }

    /// Support points of the whole shape, core radius included, for n directions at once.
    /// @param dirs [3n] nonzero, any length, shape frame   @param points [3n] m, shape frame
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
    ///         scenery); PLUGIN_INVALID (the support function failed; the points before are written)
    pub fn shape_support(&self, shape: raw::carom_shape, dirs: &[[f64; 3]], points: &mut [[f64; 3]]) -> Result<()> {
        let n = dirs.len() as u64;
        fits(points.len(), n)?;
        self.call(|p, e| unsafe { raw::carom_shape_support(p, shape, dirs.as_ptr().cast(), n, points.as_mut_ptr().cast(), e) })
    }
}

impl World {
    /// Set an error tolerance from the next step on.
    /// @param accuracy NULL: none, as a world is created
    /// @status OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
    /// 0);
    ///         BUSY; REENTRANT
    pub fn set_accuracy(&mut self, accuracy: Option<&raw::carom_accuracy>) -> Result<()> {
        let accuracy = accuracy.map(|it| raw::carom_accuracy { struct_size: size_of::<raw::carom_accuracy>() as u32, ..*it });
        self.call(|p, e| unsafe { raw::carom_world_set_accuracy(p, accuracy.as_ref().map_or(null(), |it| it), e) })
    }

    /// @param accuracy out   @param present out: 1 or 0; if 0, accuracy is filled with defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn accuracy(&self) -> Result<(raw::carom_accuracy, u32)> {
        let mut accuracy = <raw::carom_accuracy>::default();
        let mut present = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_accuracy(p, &mut accuracy, &mut present, e) })?;
        Ok((accuracy, present))
    }

    /// Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
    /// Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_island) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn islands(&self) -> Result<Vec<raw::carom_island>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_islands(p, dst, size_of::<raw::carom_island>() as u64, capacity, count, e) })
    }

    /// Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
    /// little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
    /// Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
    /// until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
    /// @param dt      s, of a step: as for carom_world_step()
    /// @param steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
    /// @param growth  out, its struct_size set
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
    /// @thread reader
    pub fn measure_growth(&self, dt: f64, steps: u32) -> Result<raw::carom_growth> {
        let mut growth = <raw::carom_growth>::default();
        self.call(|p, e| unsafe { raw::carom_world_measure_growth(p, dt, steps, &mut growth, e) })?;
        Ok(growth)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY
    pub fn material(&mut self, desc: &raw::carom_material_desc) -> Result<raw::carom_material> {
        let desc = raw::carom_material_desc { struct_size: size_of::<raw::carom_material_desc>() as u32, ..*desc };
        let mut material = <raw::carom_material>::default();
        self.call(|p, e| unsafe { raw::carom_material_create(p, &desc, &mut material, e) })?;
        Ok(material)
    }

    /// Change a material in place; every collider that uses it follows.   @status as carom_material_create(); *_HANDLE
    pub fn material_update(&mut self, material: raw::carom_material, desc: &raw::carom_material_desc) -> Result<()> {
        let desc = raw::carom_material_desc { struct_size: size_of::<raw::carom_material_desc>() as u32, ..*desc };
        self.call(|p, e| unsafe { raw::carom_material_update(p, material, &desc, e) })
    }

    /// Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
    /// with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
    /// friction is; carom_material_update() leaves it alone.
    /// @param rolling, spinning m, [0, 1e3]
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY
    pub fn material_set_resistance(&mut self, material: raw::carom_material, rolling: f64, spinning: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_material_set_resistance(p, material, rolling, spinning, e) })
    }

    /// @param rolling, spinning out: m   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn material_resistance(&self, material: raw::carom_material) -> Result<(f64, f64)> {
        let mut rolling = <f64>::default();
        let mut spinning = <f64>::default();
        self.call(|p, e| unsafe { raw::carom_material_get_resistance(p, material, &mut rolling, &mut spinning, e) })?;
        Ok((rolling, spinning))
    }

    /// Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
    /// @param material_a, material_b  in any order; the same twice: colliders of that material among themselves
    /// @param surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
    ///                NULL: they mix again
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   @since 0.9
    pub fn material_set_pair(&mut self, material_a: raw::carom_material, material_b: raw::carom_material, surface: Option<[f64; 4]>) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_material_set_pair(p, material_a, material_b, surface.as_ref().map_or(null(), |it| it.as_ptr()), e) })
    }

    /// What two materials are to each other: what was said of them, or else what they mix to.
    /// @param surface out, [4]: as carom_material_set_pair() takes it
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY   @since 0.9
    pub fn material_pair(&self, material_a: raw::carom_material, material_b: raw::carom_material) -> Result<[f64; 4]> {
        let mut surface = <[f64; 4]>::default();
        self.call(|p, e| unsafe { raw::carom_material_get_pair(p, material_a, material_b, surface.as_mut_ptr(), e) })?;
        Ok(surface)
    }

    /// @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY
    pub fn material_destroy(&mut self, material: raw::carom_material) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_material_destroy(p, material, e) })
    }

    /// Destroys its colliders too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn destroy(&mut self, body: raw::carom_body) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_destroy(p, body, e) })
    }

    /// Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
    /// body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn body_desc(&self, body: raw::carom_body) -> Result<raw::carom_body_desc> {
        let mut desc = <raw::carom_body_desc>::default();
        self.call(|p, e| unsafe { raw::carom_body_get(p, body, &mut desc, e) })?;
        Ok(desc)
    }

    /// @param position [3] m   @param orientation [4] x, y, z, w   @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
    /// NOT_UNIT; BUSY; REENTRANT
    pub fn set_pose(&mut self, body: raw::carom_body, position: [f64; 3], orientation: [f64; 4]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_pose(p, body, position.as_ptr(), orientation.as_ptr(), e) })
    }

    /// @param linear [3] m/s of the centre of mass   @param angular [3] rad/s, both world frame
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT
    pub fn set_velocity(&mut self, body: raw::carom_body, linear: [f64; 3], angular: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_velocity(p, body, linear.as_ptr(), angular.as_ptr(), e) })
    }

    /// @param position [3] out, or NULL: m, world, origin of the body frame   @param orientation [4] out, or NULL: x, y, z,
    /// w, body to world   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn pose(&self, body: raw::carom_body) -> Result<([f64; 3], [f64; 4])> {
        let mut position = <[f64; 3]>::default();
        let mut orientation = <[f64; 4]>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_pose(p, body, position.as_mut_ptr(), orientation.as_mut_ptr(), e) })?;
        Ok((position, orientation))
    }

    /// @param linear [3] out, or NULL: m/s, world, of the centre of mass   @param angular [3] out, or NULL: rad/s, world
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn velocity(&self, body: raw::carom_body) -> Result<([f64; 3], [f64; 3])> {
        let mut linear = <[f64; 3]>::default();
        let mut angular = <[f64; 3]>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_velocity(p, body, linear.as_mut_ptr(), angular.as_mut_ptr(), e) })?;
        Ok((linear, angular))
    }

    /// Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
    /// as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
    /// @param mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
    /// @param center [3] m, body frame, or NULL: from its colliders
    /// @param inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
    /// or NULL:
    ///                from its colliders, scaled to the mass
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
    ///         and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_mass(&mut self, body: raw::carom_body, mass: f64, center: Option<[f64; 3]>, inertia: Option<[f64; 9]>) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_mass(p, body, mass, center.as_ref().map_or(null(), |it| it.as_ptr()), inertia.as_ref().map_or(null(), |it| it.as_ptr()), e) })
    }

    /// As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
    /// @param mass out, or NULL: kg   @param center [3] out, or NULL: m, body frame   @param inertia [9] out, or NULL: kg
    /// m^2, body frame axes, about the centre, row-major   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn mass(&self, body: raw::carom_body) -> Result<(f64, [f64; 3], [f64; 9])> {
        let mut mass = <f64>::default();
        let mut center = <[f64; 3]>::default();
        let mut inertia = <[f64; 9]>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_mass(p, body, &mut mass, center.as_mut_ptr(), inertia.as_mut_ptr(), e) })?;
        Ok((mass, center, inertia))
    }

    /// Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
    /// no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
    /// (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
    /// @param type CAROM_BODY_*
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
    ///         is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_type(&mut self, body: raw::carom_body, r#type: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_type(p, body, r#type, e) })
    }

    /// @param type out: CAROM_BODY_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn r#type(&self, body: raw::carom_body) -> Result<u32> {
        let mut r#type = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_type(p, body, &mut r#type, e) })?;
        Ok(r#type)
    }

    /// @param linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   @status OK; NULL_ARGUMENT; *_HANDLE;
    /// NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn set_damping(&mut self, body: raw::carom_body, linear: f64, angular: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_damping(p, body, linear, angular, e) })
    }

    /// @param linear, angular out: 1/s; either may be NULL   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn damping(&self, body: raw::carom_body) -> Result<(f64, f64)> {
        let mut linear = <f64>::default();
        let mut angular = <f64>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_damping(p, body, &mut linear, &mut angular, e) })?;
        Ok((linear, angular))
    }

    /// @param user anything; the engine does not look   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn set_user(&mut self, body: raw::carom_body, user: u64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_user(p, body, user, e) })
    }

    /// @param user out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn user(&self, body: raw::carom_body) -> Result<u64> {
        let mut user = <u64>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_user(p, body, &mut user, e) })?;
        Ok(user)
    }

    /// Number of a body's colliders, and their handles in the order of the slots.
    /// @param colliders [capacity] or NULL   @param count out: how many there are (may exceed capacity; capacity are
    /// written)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn colliders(&self, body: raw::carom_body) -> Result<Vec<raw::carom_collider>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_body_get_colliders(p, body, dst, capacity, count, e) })
    }

    /// Add a force and a torque about the centre of mass, for the next step only.
    /// @param force [3] N, world   @param torque [3] N m, world
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT
    pub fn add_force(&mut self, body: raw::carom_body, force: [f64; 3], torque: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_add_force(p, body, force.as_ptr(), torque.as_ptr(), e) })
    }

    /// Change velocities at once. @param impulse [3] N s, world   @param point [3] m, world: where it acts
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT
    pub fn add_impulse(&mut self, body: raw::carom_body, impulse: [f64; 3], point: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_add_impulse(p, body, impulse.as_ptr(), point.as_ptr(), e) })
    }

    /// How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
    /// rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
    /// @param factor any finite number; 1 when a body is created
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_gravity_factor(&mut self, body: raw::carom_body, factor: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_gravity_factor(p, body, factor, e) })
    }

    /// @param factor out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn gravity_factor(&self, body: raw::carom_body) -> Result<f64> {
        let mut factor = <f64>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_gravity_factor(p, body, &mut factor, e) })?;
        Ok(factor)
    }

    /// Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
    /// it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
    /// it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
    ///
    /// Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
    /// body refuses that dial.
    /// @param locks CAROM_LOCK_* bits, 0 when a body is created
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
    ///         first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn set_locks(&mut self, body: raw::carom_body, locks: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_locks(p, body, locks, e) })
    }

    /// @param locks out: CAROM_LOCK_* bits   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn locks(&self, body: raw::carom_body) -> Result<u32> {
        let mut locks = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_locks(p, body, &mut locks, e) })?;
        Ok(locks)
    }

    /// Set an attribute. Another value than it has wakes the body and its island.
    /// @param value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
    /// whole; a
    ///         body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_attribute(&mut self, body: raw::carom_body, attribute: u32, value: [f64; 4]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_attribute(p, body, attribute, value.as_ptr(), e) })
    }

    /// @param value [4] out: numbers that the attribute does not have are 0
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY
    pub fn attribute(&self, body: raw::carom_body, attribute: u32) -> Result<[f64; 4]> {
        let mut value = <[f64; 4]>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_attribute(p, body, attribute, value.as_mut_ptr(), e) })?;
        Ok(value)
    }

    /// @param asleep out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn is_asleep(&self, body: raw::carom_body) -> Result<u32> {
        let mut asleep = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_is_asleep(p, body, &mut asleep, e) })?;
        Ok(asleep)
    }

    /// Wake a body and its island; if it is awake, its time of rest starts anew.   @status OK; NULL_ARGUMENT; *_HANDLE;
    /// BUSY; REENTRANT
    pub fn wake(&mut self, body: raw::carom_body) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_wake(p, body, e) })
    }

    /// Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
    /// says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
    /// @param mode CAROM_CONTINUOUS_*
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT
    pub fn set_continuous(&mut self, body: raw::carom_body, mode: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_continuous(p, body, mode, e) })
    }

    /// @param mode out: CAROM_CONTINUOUS_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn continuous(&self, body: raw::carom_body) -> Result<u32> {
        let mut mode = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_continuous(p, body, &mut mode, e) })?;
        Ok(mode)
    }

    /// Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
    /// moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
    /// it wake. It costs a step nothing. A host may still read and write it.
    /// @param enabled 1 or 0
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_enabled(&mut self, body: raw::carom_body, enabled: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_enabled(p, body, enabled, e) })
    }

    /// @param enabled out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn is_enabled(&self, body: raw::carom_body) -> Result<u32> {
        let mut enabled = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_is_enabled(p, body, &mut enabled, e) })?;
        Ok(enabled)
    }

    /// Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
    /// centre.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
    /// half-space on a
    ///         body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn collider(&mut self, body: raw::carom_body, desc: &raw::carom_collider_desc) -> Result<raw::carom_collider> {
        let desc = raw::carom_collider_desc { struct_size: size_of::<raw::carom_collider_desc>() as u32, ..*desc };
        let mut collider = <raw::carom_collider>::default();
        self.call(|p, e| unsafe { raw::carom_collider_create(p, body, &desc, &mut collider, e) })?;
        Ok(collider)
    }

    /// The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
    /// same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
    /// Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
    /// friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
    /// @param type CAROM_BODY_*   @param name as carom_shape_create_named()   @param position [3] m, world
    /// @param params [count] as carom_shape_create_named()   @param count number of params
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
    ///         PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn body_named(&mut self, r#type: u32, name: &str, params: &[f64], position: [f64; 3]) -> Result<raw::carom_body> {
        let name = text(name)?;
        let mut body = <raw::carom_body>::default();
        let count = params.len() as u64;
        self.call(|p, e| unsafe { raw::carom_body_create_named(p, r#type, name.as_ptr(), params.as_ptr(), count, position.as_ptr(), &mut body, e) })?;
        Ok(body)
    }

    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn collider_destroy(&mut self, collider: raw::carom_collider) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_destroy(p, collider, e) })
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn collider_desc(&self, collider: raw::carom_collider) -> Result<(raw::carom_collider_desc, raw::carom_body)> {
        let mut desc = <raw::carom_collider_desc>::default();
        let mut body = <raw::carom_body>::default();
        self.call(|p, e| unsafe { raw::carom_collider_get(p, collider, &mut desc, &mut body, e) })?;
        Ok((desc, body))
    }

    /// Give a collider another material. Wakes what its body touches.   @param material or CAROM_NULL_HANDLE: friction 0.5,
    /// restitution 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn collider_set_material(&mut self, collider: raw::carom_collider, material: raw::carom_material) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_set_material(p, collider, material, e) })
    }

    /// The body's mass follows, unless it was given. Wakes the body and its island.   @param density kg/m^3, [0, 1e9]
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn collider_set_density(&mut self, collider: raw::carom_collider, density: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_set_density(p, collider, density, e) })
    }

    /// Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
    /// @param position [3] m, body frame: origin of the shape; each within 1e15   @param orientation [4] x, y, z, w, shape
    /// to body
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn collider_set_pose(&mut self, collider: raw::carom_collider, position: [f64; 3], orientation: [f64; 4]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_set_pose(p, collider, position.as_ptr(), orientation.as_ptr(), e) })
    }

    /// Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
    /// what touches it to the velocity of the surface,
    ///   v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
    /// with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
    /// belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
    /// moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
    /// does not fall asleep.
    /// @param linear  [3] m/s, axes of the shape; 0 when a collider is created
    /// @param angular [3] rad/s, axes of the shape, about its origin
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn collider_set_surface_velocity(&mut self, collider: raw::carom_collider, linear: [f64; 3], angular: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_set_surface_velocity(p, collider, linear.as_ptr(), angular.as_ptr(), e) })
    }

    /// @param linear, angular out: [3], as they were set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn collider_surface_velocity(&self, collider: raw::carom_collider) -> Result<([f64; 3], [f64; 3])> {
        let mut linear = <[f64; 3]>::default();
        let mut angular = <[f64; 3]>::default();
        self.call(|p, e| unsafe { raw::carom_collider_get_surface_velocity(p, collider, linear.as_mut_ptr(), angular.as_mut_ptr(), e) })?;
        Ok((linear, angular))
    }

    /// Number of bodies, and their handles in creation order of the slots.
    /// @param handles [capacity] or NULL   @param count out: how many there are
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn bodies(&self) -> Result<Vec<raw::carom_body>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_bodies(p, dst, capacity, count, e) })
    }

    /// Read one field of n bodies.
    /// @param handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
    /// @param dst     n records of the field's scalars, `stride` bytes apart
    /// @param stride  bytes from one record to the next; 0: tightly packed
    /// @param field   CAROM_FIELD_*
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
    /// BUSY
    pub fn read<T: Scalar, const N: usize>(&self, field: u32, handles: Option<&[raw::carom_body]>, dst: &mut [[T; N]]) -> Result<()> {
        let n = dst.len() as u64;
        handles.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_world_read(p, field, T::SCALAR, handles.map_or(null(), |it| it.as_ptr()), n, dst.as_mut_ptr().cast(), size_of::<[T; N]>() as u64, e) })
    }

    /// Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
    /// @param src n records of the field's scalars, `stride` bytes apart
    /// @status as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT
    pub fn write<T: Scalar, const N: usize>(&mut self, field: u32, handles: Option<&[raw::carom_body]>, src: &[[T; N]]) -> Result<()> {
        let n = src.len() as u64;
        handles.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_world_write(p, field, T::SCALAR, handles.map_or(null(), |it| it.as_ptr()), n, src.as_ptr().cast(), size_of::<[T; N]>() as u64, e) })
    }

    /// Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
    /// jumps or falls.
    ///
    /// On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
    /// follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
    /// does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
    /// allocates nothing but what queries do.
    /// @param desc may be NULL: defaults
    /// @param character all but shape, foot, head and reach may change
    /// @param walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
    ///        counts only with CAROM_CHARACTER_FLIES
    /// @param jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
    ///        ground with it; else, and with 0, it does not
    /// @param dt s, [0, 1]
    /// @accuracy stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc->body;
    ///         character->shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
    ///         REENTRANT; OUT_OF_MEMORY
    /// @thread reader
    pub fn character_move(&self, desc: Option<&raw::carom_character_desc>, character: &mut raw::carom_character, walk: [f64; 3], jump: f64, dt: f64) -> Result<()> {
        let desc = desc.map(|it| raw::carom_character_desc { struct_size: size_of::<raw::carom_character_desc>() as u32, ..*it });
        character.struct_size = size_of::<raw::carom_character>() as u32;
        self.call(|p, e| unsafe { raw::carom_character_move(p, desc.as_ref().map_or(null(), |it| it), character, walk.as_ptr(), jump, dt, e) })
    }

    /// Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
    /// in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
    /// firm feet gets mass * gravity. Bodies that are gone are left out.
    /// @param desc may be NULL: defaults   @param character as the last move left it   @param dt s, [1e-9, 1], of the next
    /// step
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
    ///         BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn character_push(&mut self, desc: Option<&raw::carom_character_desc>, character: &raw::carom_character, dt: f64) -> Result<()> {
        let desc = desc.map(|it| raw::carom_character_desc { struct_size: size_of::<raw::carom_character_desc>() as u32, ..*it });
        let character = raw::carom_character { struct_size: size_of::<raw::carom_character>() as u32, ..*character };
        self.call(|p, e| unsafe { raw::carom_character_push(p, desc.as_ref().map_or(null(), |it| it), &character, dt, e) })
    }

    /// Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
    /// velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
    /// character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
    /// desc->body.
    /// @param desc with a body   @param dt s, [1e-9, 1], of the next step
    /// @param character as the last move left it
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
    ///         (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn character_move_body(&mut self, desc: &raw::carom_character_desc, character: &raw::carom_character, dt: f64) -> Result<()> {
        let desc = raw::carom_character_desc { struct_size: size_of::<raw::carom_character_desc>() as u32, ..*desc };
        let character = raw::carom_character { struct_size: size_of::<raw::carom_character>() as u32, ..*character };
        self.call(|p, e| unsafe { raw::carom_character_move_body(p, &desc, &character, dt, e) })
    }

    /// All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
    /// are left out, and so are bodies in quarantine. The same world gives the same lines.
    /// @param desc     NULL: defaults
    /// @param dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
    /// @param count    out: lines there are; more than capacity: the first `capacity` of them were written
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
    ///         OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
    /// @thread reader
    pub fn draw(&self, desc: Option<&raw::carom_draw_desc>) -> Result<Vec<raw::carom_draw_line>> {
        let desc = desc.map(|it| raw::carom_draw_desc { struct_size: size_of::<raw::carom_draw_desc>() as u32, ..*it });
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_draw(p, desc.as_ref().map_or(null(), |it| it), dst, size_of::<raw::carom_draw_line>() as u64, capacity, count, e) })
    }

    /// Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
    /// that step.
    /// @param kinds     CAROM_EVENTS_* bits; 0: nothing
    /// @param hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn collect_events(&mut self, kinds: u32, hit_speed: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_collect_events(p, kinds, hit_speed, e) })
    }

    /// Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_contact_event) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn contact_events(&self) -> Result<Vec<raw::carom_contact_event>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_contact_events(p, dst, size_of::<raw::carom_contact_event>() as u64, capacity, count, e) })
    }

    /// Arguments as carom_world_get_contact_events().
    pub fn sensor_events(&self) -> Result<Vec<raw::carom_sensor_event>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_sensor_events(p, dst, size_of::<raw::carom_sensor_event>() as u64, capacity, count, e) })
    }

    /// By the slots of the bodies; arguments as carom_world_get_contact_events().
    pub fn sleep_events(&self) -> Result<Vec<raw::carom_sleep_event>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_sleep_events(p, dst, size_of::<raw::carom_sleep_event>() as u64, capacity, count, e) })
    }

    /// By the slots of the joints; arguments as carom_world_get_contact_events().
    pub fn joint_events(&self) -> Result<Vec<raw::carom_joint_event>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_joint_events(p, dst, size_of::<raw::carom_joint_event>() as u64, capacity, count, e) })
    }

    /// As they happened; arguments as carom_world_get_contact_events().
    pub fn fault_events(&self) -> Result<Vec<raw::carom_fault_event>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_fault_events(p, dst, size_of::<raw::carom_fault_event>() as u64, capacity, count, e) })
    }

    /// Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
    /// group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
    /// @param category, mask  any bits   @param group 0: none
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn collider_set_filter(&mut self, collider: raw::carom_collider, category: u64, mask: u64, group: i32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_set_filter(p, collider, category, mask, group, e) })
    }

    /// @param category, mask, group  out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn collider_filter(&self, collider: raw::carom_collider) -> Result<(u64, u64, i32)> {
        let mut category = <u64>::default();
        let mut mask = <u64>::default();
        let mut group = <i32>::default();
        self.call(|p, e| unsafe { raw::carom_collider_get_filter(p, collider, &mut category, &mut mask, &mut group, e) })?;
        Ok((category, mask, group))
    }

    /// The same for all colliders that a body has now.   @status as carom_collider_set_filter()
    pub fn set_filter(&mut self, body: raw::carom_body, category: u64, mask: u64, group: i32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_filter(p, body, category, mask, group, e) })
    }

    /// Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
    /// counted: undo each one. Undoing more does nothing.
    /// @param ignored 1 or 0
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn ignore_collision(&mut self, body_a: raw::carom_body, body_b: raw::carom_body, ignored: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_ignore_collision(p, body_a, body_b, ignored, e) })
    }

    /// Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
    /// It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
    /// as before.
    /// @param sensor 1 or 0
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn collider_set_sensor(&mut self, collider: raw::carom_collider, sensor: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_collider_set_sensor(p, collider, sensor, e) })
    }

    /// @param sensor out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn collider_is_sensor(&self, collider: raw::carom_collider) -> Result<u32> {
        let mut sensor = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_collider_is_sensor(p, collider, &mut sensor, e) })?;
        Ok(sensor)
    }

    /// Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
    /// mass as the body stands now.
    /// @param force [3] N, world   @param point [3] m, world
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT
    pub fn add_force_at(&mut self, body: raw::carom_body, force: [f64; 3], point: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_add_force_at(p, body, force.as_ptr(), point.as_ptr(), e) })
    }

    /// How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
    /// other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
    /// not to the air, and to mass.)
    /// @param linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
    /// @param quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_drag(&mut self, body: raw::carom_body, linear: f64, quadratic: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_drag(p, body, linear, quadratic, e) })
    }

    /// @param linear, quadratic out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn drag(&self, body: raw::carom_body) -> Result<(f64, f64)> {
        let mut linear = <f64>::default();
        let mut quadratic = <f64>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_drag(p, body, &mut linear, &mut quadratic, e) })?;
        Ok((linear, quadratic))
    }

    /// How the air moves; it reaches bodies through their drag alone.
    /// @param velocity [3] m/s, |each| <= 1e6; 0 when a world is created
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn set_wind(&mut self, velocity: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_wind(p, velocity.as_ptr(), e) })
    }

    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn wind(&self) -> Result<[f64; 3]> {
        let mut velocity = <[f64; 3]>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_wind(p, velocity.as_mut_ptr(), e) })?;
        Ok(velocity)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
    ///         REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn force_field(&mut self, desc: &raw::carom_force_field_desc) -> Result<raw::carom_force_field> {
        let desc = raw::carom_force_field_desc { struct_size: size_of::<raw::carom_force_field_desc>() as u32, ..*desc };
        let mut field = <raw::carom_force_field>::default();
        self.call(|p, e| unsafe { raw::carom_force_field_create(p, &desc, &mut field, e) })?;
        Ok(field)
    }

    /// Change a field in place: move it, turn it up.   @status as carom_force_field_create(); *_HANDLE
    pub fn force_field_update(&mut self, field: raw::carom_force_field, desc: &raw::carom_force_field_desc) -> Result<()> {
        let desc = raw::carom_force_field_desc { struct_size: size_of::<raw::carom_force_field_desc>() as u32, ..*desc };
        self.call(|p, e| unsafe { raw::carom_force_field_update(p, field, &desc, e) })
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn force_field_desc(&self, field: raw::carom_force_field) -> Result<raw::carom_force_field_desc> {
        let mut desc = <raw::carom_force_field_desc>::default();
        self.call(|p, e| unsafe { raw::carom_force_field_get(p, field, &mut desc, e) })?;
        Ok(desc)
    }

    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn force_field_destroy(&mut self, field: raw::carom_force_field) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_force_field_destroy(p, field, e) })
    }

    /// Which fields a body feels. A field with a bit that few bodies have costs those few.
    /// @param mask 1 when a body is created; 0: none
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_force_field_mask(&mut self, body: raw::carom_body, mask: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_force_field_mask(p, body, mask, e) })
    }

    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn force_field_mask(&self, body: raw::carom_body) -> Result<u32> {
        let mut mask = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_force_field_mask(p, body, &mut mask, e) })?;
        Ok(mask)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
    ///         OUT_OF_MEMORY
    pub fn spring(&mut self, desc: &raw::carom_spring_desc) -> Result<raw::carom_spring> {
        let desc = raw::carom_spring_desc { struct_size: size_of::<raw::carom_spring_desc>() as u32, ..*desc };
        let mut spring = <raw::carom_spring>::default();
        self.call(|p, e| unsafe { raw::carom_spring_create(p, &desc, &mut spring, e) })?;
        Ok(spring)
    }

    /// Change what a spring is like; its ends stay.
    /// @param rest m   @param stiffness N/m   @param damping N s/m; ranges as in carom_spring_desc
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn spring_update(&mut self, spring: raw::carom_spring, rest: f64, stiffness: f64, damping: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_spring_update(p, spring, rest, stiffness, damping, e) })
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn spring_desc(&self, spring: raw::carom_spring) -> Result<raw::carom_spring_desc> {
        let mut desc = <raw::carom_spring_desc>::default();
        self.call(|p, e| unsafe { raw::carom_spring_get(p, spring, &mut desc, e) })?;
        Ok(desc)
    }

    /// @param length out: m, as its ends stand   @param force out: N, above 0 it pulls them together, as it is set
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn spring_state(&self, spring: raw::carom_spring) -> Result<(f64, f64)> {
        let mut length = <f64>::default();
        let mut force = <f64>::default();
        self.call(|p, e| unsafe { raw::carom_spring_get_state(p, spring, &mut length, &mut force, e) })?;
        Ok((length, force))
    }

    /// Goes with its bodies, too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn spring_destroy(&mut self, spring: raw::carom_spring) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_spring_destroy(p, spring, e) })
    }

    /// @param water NULL: none, as a world is created
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn set_water(&mut self, water: Option<&raw::carom_water>) -> Result<()> {
        let water = water.map(|it| raw::carom_water { struct_size: size_of::<raw::carom_water>() as u32, ..*it });
        self.call(|p, e| unsafe { raw::carom_world_set_water(p, water.as_ref().map_or(null(), |it| it), e) })
    }

    /// @param water out   @param present out: 1 or 0; if 0, water is filled with defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn water(&self) -> Result<(raw::carom_water, u32)> {
        let mut water = <raw::carom_water>::default();
        let mut present = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_water(p, &mut water, &mut present, e) })?;
        Ok((water, present))
    }

    /// Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
    ///         carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
    ///         NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
    ///         body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
    ///         LIMIT; OUT_OF_MEMORY
    pub fn joint(&mut self, desc: &raw::carom_joint_desc) -> Result<raw::carom_joint> {
        let desc = raw::carom_joint_desc { struct_size: size_of::<raw::carom_joint_desc>() as u32, ..*desc };
        let mut joint = <raw::carom_joint>::default();
        self.call(|p, e| unsafe { raw::carom_joint_create(p, &desc, &mut joint, e) })?;
        Ok(joint)
    }

    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn joint_destroy(&mut self, joint: raw::carom_joint) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_joint_destroy(p, joint, e) })
    }

    /// @param desc out: as it was made, with frames in body coordinates
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn joint_desc(&self, joint: raw::carom_joint) -> Result<raw::carom_joint_desc> {
        let mut desc = <raw::carom_joint_desc>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get(p, joint, &mut desc, e) })?;
        Ok(desc)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn joint_state(&self, joint: raw::carom_joint) -> Result<raw::carom_joint_state> {
        let mut state = <raw::carom_joint_state>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_state(p, joint, &mut state, e) })?;
        Ok(state)
    }

    /// Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    /// @param coordinate CAROM_COORDINATE_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
    ///         limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn joint_set_limit(&mut self, joint: raw::carom_joint, coordinate: u32, limit: &raw::carom_joint_limit) -> Result<()> {
        let limit = raw::carom_joint_limit { struct_size: size_of::<raw::carom_joint_limit>() as u32, ..*limit };
        self.call(|p, e| unsafe { raw::carom_joint_set_limit(p, joint, coordinate, &limit, e) })
    }

    /// Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    /// @param coordinate CAROM_COORDINATE_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
    ///         limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn joint_set_motor(&mut self, joint: raw::carom_joint, coordinate: u32, motor: &raw::carom_joint_motor) -> Result<()> {
        let motor = raw::carom_joint_motor { struct_size: size_of::<raw::carom_joint_motor>() as u32, ..*motor };
        self.call(|p, e| unsafe { raw::carom_joint_set_motor(p, joint, coordinate, &motor, e) })
    }

    /// Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    /// @param coordinate CAROM_COORDINATE_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
    ///         limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn joint_set_spring(&mut self, joint: raw::carom_joint, coordinate: u32, spring: &raw::carom_joint_spring) -> Result<()> {
        let spring = raw::carom_joint_spring { struct_size: size_of::<raw::carom_joint_spring>() as u32, ..*spring };
        self.call(|p, e| unsafe { raw::carom_joint_set_spring(p, joint, coordinate, &spring, e) })
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_limit(&self, joint: raw::carom_joint, coordinate: u32) -> Result<raw::carom_joint_limit> {
        let mut limit = <raw::carom_joint_limit>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_limit(p, joint, coordinate, &mut limit, e) })?;
        Ok(limit)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_motor(&self, joint: raw::carom_joint, coordinate: u32) -> Result<raw::carom_joint_motor> {
        let mut motor = <raw::carom_joint_motor>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_motor(p, joint, coordinate, &mut motor, e) })?;
        Ok(motor)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_spring(&self, joint: raw::carom_joint, coordinate: u32) -> Result<raw::carom_joint_spring> {
        let mut spring = <raw::carom_joint_spring>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_spring(p, joint, coordinate, &mut spring, e) })?;
        Ok(spring)
    }

    /// Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
    /// pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
    /// may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
    /// one; a pose that the host sets between steps is no turn.
    /// Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
    /// under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
    /// tests/oracle/test_pulley_gear.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
    ///         NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT
    pub fn joint_set_transmission(&mut self, joint: raw::carom_joint, transmission: &raw::carom_joint_transmission) -> Result<()> {
        let transmission = raw::carom_joint_transmission { struct_size: size_of::<raw::carom_joint_transmission>() as u32, ..*transmission };
        self.call(|p, e| unsafe { raw::carom_joint_set_transmission(p, joint, &transmission, e) })
    }

    /// @param transmission out: as it was set, with its length; ratio 0: not yet
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_transmission(&self, joint: raw::carom_joint) -> Result<raw::carom_joint_transmission> {
        let mut transmission = <raw::carom_joint_transmission>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_transmission(p, joint, &mut transmission, e) })?;
        Ok(transmission)
    }

    /// Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
    /// wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
    /// as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
    /// carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
    /// follower's coordinate that it pushes with, mean over the last step.
    /// Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
    /// joint_order moves it. Oracle: tests/oracle/test_couplings.
    /// @param joint out: the coupling
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
    ///         reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
    ///         REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn joint_couple(&mut self, coupling: &raw::carom_joint_coupling) -> Result<raw::carom_joint> {
        let coupling = raw::carom_joint_coupling { struct_size: size_of::<raw::carom_joint_coupling>() as u32, ..*coupling };
        let mut joint = <raw::carom_joint>::default();
        self.call(|p, e| unsafe { raw::carom_joint_couple(p, &coupling, &mut joint, e) })?;
        Ok(joint)
    }

    /// Give a coupling another polynomial; its bodies wake.
    /// @param coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
    ///         field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn joint_set_coupling(&mut self, joint: raw::carom_joint, coupling: &raw::carom_joint_coupling) -> Result<()> {
        let coupling = raw::carom_joint_coupling { struct_size: size_of::<raw::carom_joint_coupling>() as u32, ..*coupling };
        self.call(|p, e| unsafe { raw::carom_joint_set_coupling(p, joint, &coupling, e) })
    }

    /// @param coupling out: as it was made
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_coupling(&self, joint: raw::carom_joint) -> Result<raw::carom_joint_coupling> {
        let mut coupling = <raw::carom_joint_coupling>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_coupling(p, joint, &mut coupling, e) })?;
        Ok(coupling)
    }

    /// Say what one axis of a six-axis joint, a hinge or a slider does; the bodies wake. Effect joint_limits has its limits, joint_motors its
    /// drives; springs and locks are of the joint. A target, a lock's place or a limit may be set anew before each step.
    /// Accuracy: what is locked errs in second order of the substep h, under the direct solver by 1e-9 m or rad. With w the
    /// frequency and b half the damping per mass: springs, stops and drives to a position swing late by w h / 2 of their
    /// amplitude and fade slower by b h of their rate; at rest they sag by load / stiffness, to rounding where one joint
    /// bears all, in first order where soft_step sweeps over several. A drive to a velocity holds that of the middle of a
    /// substep under the direct solver, and one with a damping alone does under any: what a step ends with differs by what
    /// the load does in h / 2. Forces of drives are met to rounding. A speed limit holds to 1e-9 under the
    /// direct solver, where one joint bears all to rounding under others. Oracle: tests/oracle/test_six_axis, test_six_axis_scenes, test_armature,
    /// test_axis_limits.
    /// @param axis CAROM_AXIS_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
    ///         *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn joint_set_axis(&mut self, joint: raw::carom_joint, axis: u32, desc: &raw::carom_joint_axis) -> Result<()> {
        let desc = raw::carom_joint_axis { struct_size: size_of::<raw::carom_joint_axis>() as u32, ..*desc };
        self.call(|p, e| unsafe { raw::carom_joint_set_axis(p, joint, axis, &desc, e) })
    }

    /// @param axis CAROM_AXIS_*   @param desc out: as it was set
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_axis(&self, joint: raw::carom_joint, axis: u32) -> Result<raw::carom_joint_axis> {
        let mut desc = <raw::carom_joint_axis>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_axis(p, joint, axis, &mut desc, e) })?;
        Ok(desc)
    }

    /// Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
    /// joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
    /// it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
    ///         field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn joint_set_orientation_drive(&mut self, joint: raw::carom_joint, drive: &raw::carom_joint_orientation_drive) -> Result<()> {
        let drive = raw::carom_joint_orientation_drive { struct_size: size_of::<raw::carom_joint_orientation_drive>() as u32, ..*drive };
        self.call(|p, e| unsafe { raw::carom_joint_set_orientation_drive(p, joint, &drive, e) })
    }

    /// @param drive out: as it was set
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY
    pub fn joint_orientation_drive(&self, joint: raw::carom_joint) -> Result<raw::carom_joint_orientation_drive> {
        let mut drive = <raw::carom_joint_orientation_drive>::default();
        self.call(|p, e| unsafe { raw::carom_joint_get_orientation_drive(p, joint, &mut drive, e) })?;
        Ok(drive)
    }

    /// Read one field of n joints, as carom_world_read() does of bodies.
    /// A rate of what has no direction (points or axes that agree) is the one at which it begins to grow.
    /// Accuracy: rounding of poses and velocities; of a twist times 1 / cos(swing / 2). An effort errs in first order of the
    /// step, by how far the axis turned in it. Oracle: tests/abi/test_joint_bulk.
    /// @param field   CAROM_JOINT_BULK_*   @param scalar CAROM_SCALAR_*
    /// @param joints  [n], or NULL for all in the order of carom_world_get_joints() (n must be their number)
    /// @param dst     n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); UNSUPPORTED (a kind without the field);
    /// OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride); BUSY
    pub fn read_joints<T: Scalar, const N: usize>(&self, field: u32, joints: Option<&[raw::carom_joint]>, dst: &mut [[T; N]]) -> Result<()> {
        let n = dst.len() as u64;
        joints.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_world_read_joints(p, field, T::SCALAR, joints.map_or(null(), |it| it.as_ptr()), n, dst.as_mut_ptr().cast(), size_of::<[T; N]>() as u64, e) })
    }

    /// Write one field of n joints; all values are validated before the first is written, joints of a tree are moved as one.
    /// Accuracy of places: rounding of poses, to 1e-15 of a chain's length a joint. Oracle: tests/oracle/test_joint_moves. Modes, units of gains and what is
    /// enabled stay as they are, where the record does not have them. Bodies of joints that this changes wake. Arguments as carom_world_read_joints().
    /// @param src n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
    /// @status as carom_world_read_joints(); UNSUPPORTED (also: a field that is read only; a joint of a loop, a broken one,
    /// one between bodies that forces do not move); NOT_FINITE; NOT_UNIT;
    /// OUT_OF_RANGE; REENTRANT
    pub fn write_joints<T: Scalar, const N: usize>(&mut self, field: u32, joints: Option<&[raw::carom_joint]>, src: &[[T; N]]) -> Result<()> {
        let n = src.len() as u64;
        joints.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_world_write_joints(p, field, T::SCALAR, joints.map_or(null(), |it| it.as_ptr()), n, src.as_ptr().cast(), size_of::<[T; N]>() as u64, e) })
    }

    /// Number of joints, and their handles in creation order of the slots.
    /// @param joints [capacity] or NULL   @param count out: how many there are
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn joints(&self) -> Result<Vec<raw::carom_joint>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_joints(p, dst, capacity, count, e) })
    }

    /// Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
    /// @param on  0 or 1
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was
    pub fn enable_ledger(&mut self, on: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_enable_ledger(p, on, e) })
    }

    /// Copy out all causes, in the order above; none of a world that keeps no ledger.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_ledger_entry) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn ledger(&self) -> Result<Vec<raw::carom_ledger_entry>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_ledger(p, dst, size_of::<raw::carom_ledger_entry>() as u64, capacity, count, e) })
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn ledger_state(&self) -> Result<raw::carom_ledger_state> {
        let mut state = <raw::carom_ledger_state>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_ledger_state(p, &mut state, e) })?;
        Ok(state)
    }

    /// Make an empty set.
    /// @param desc may be NULL: defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn particles(&mut self, desc: Option<&raw::carom_particles_desc>) -> Result<raw::carom_particles> {
        let desc = desc.map(|it| raw::carom_particles_desc { struct_size: size_of::<raw::carom_particles_desc>() as u32, ..*it });
        let mut set = <raw::carom_particles>::default();
        self.call(|p, e| unsafe { raw::carom_particles_create(p, desc.as_ref().map_or(null(), |it| it), &mut set, e) })?;
        Ok(set)
    }

    /// Its particles too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn particles_destroy(&mut self, set: raw::carom_particles) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_particles_destroy(p, set, e) })
    }

    /// @param desc out: as it was made or updated; capacity: particles there is memory for
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn particles_desc(&self, set: raw::carom_particles) -> Result<raw::carom_particles_desc> {
        let mut desc = <raw::carom_particles_desc>::default();
        self.call(|p, e| unsafe { raw::carom_particles_get(p, set, &mut desc, e) })?;
        Ok(desc)
    }

    /// Change what they have in common; particles that are there keep their mass.
    /// @param desc may be NULL: defaults; capacity: memory for so many in all
    /// @status as carom_particles_create(); *_HANDLE
    pub fn particles_update(&mut self, set: raw::carom_particles, desc: Option<&raw::carom_particles_desc>) -> Result<()> {
        let desc = desc.map(|it| raw::carom_particles_desc { struct_size: size_of::<raw::carom_particles_desc>() as u32, ..*it });
        self.call(|p, e| unsafe { raw::carom_particles_update(p, set, desc.as_ref().map_or(null(), |it| it), e) })
    }

    /// @param count out: particles in the set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn particles_count(&self, set: raw::carom_particles) -> Result<u64> {
        let mut count = <u64>::default();
        self.call(|p, e| unsafe { raw::carom_particles_get_count(p, set, &mut count, e) })?;
        Ok(count)
    }

    /// Remove n particles. The others keep their order, so each moves up by as many as went before it.
    /// @param indices [n] ascending, each once; NULL: all of them (n must be their number)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT
    pub fn particles_remove(&mut self, set: raw::carom_particles, indices: Option<&[u32]>) -> Result<()> {
        let n = indices.map_or(0, |it| it.len()) as u64;
        self.call(|p, e| unsafe { raw::carom_particles_remove(p, set, indices.map_or(null(), |it| it.as_ptr()), n, e) })
    }

    /// Read one field of n particles.
    /// @param field   CAROM_FIELD_POSITION, LINEAR_VELOCITY or MASS
    /// @param indices [n] in any order, or NULL: all of them (n must be their number)
    /// @param dst     n records of the field's scalars, `stride` bytes apart
    /// @param stride  bytes from one record to the next; 0: tightly packed
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; UNSUPPORTED (a field that particles do not have); *_HANDLE; OUT_OF_RANGE
    ///         (an index, n); BUFFER_TOO_SMALL (stride); BUSY
    pub fn particles_read<T: Scalar, const N: usize>(&self, set: raw::carom_particles, field: u32, indices: Option<&[u32]>, dst: &mut [[T; N]]) -> Result<()> {
        let n = dst.len() as u64;
        indices.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_particles_read(p, set, field, T::SCALAR, indices.map_or(null(), |it| it.as_ptr()), n, dst.as_mut_ptr().cast(), size_of::<[T; N]>() as u64, e) })
    }

    /// Write one field of n particles; all values are checked before the first is written, bounds as carom_particles_add(),
    /// masses as carom_particles_desc. Arguments as carom_particles_read(); where an index comes twice, the last counts.
    /// @param src n records of the field's scalars, `stride` bytes apart
    /// @status as carom_particles_read(); NOT_FINITE; OUT_OF_RANGE; REENTRANT; OUT_OF_MEMORY
    pub fn particles_write<T: Scalar, const N: usize>(&mut self, set: raw::carom_particles, field: u32, indices: Option<&[u32]>, src: &[[T; N]]) -> Result<()> {
        let n = src.len() as u64;
        indices.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_particles_write(p, set, field, T::SCALAR, indices.map_or(null(), |it| it.as_ptr()), n, src.as_ptr().cast(), size_of::<[T; N]>() as u64, e) })
    }

    /// A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
    /// where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
    /// reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
    /// @param indices [capacity] out; may be NULL if capacity is 0
    /// @param count   out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn particles_quarantined(&self, set: raw::carom_particles) -> Result<Vec<u32>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_particles_get_quarantined(p, set, dst, capacity, count, e) })
    }

    /// Number of sets, and their handles in creation order of the slots.
    /// @param sets [capacity] or NULL   @param count out: how many there are
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn particle_sets(&self) -> Result<Vec<raw::carom_particles>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_particles(p, dst, capacity, count, e) })
    }

    /// Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
    /// needs is allowed, and carom_world_get_plan() says so.
    /// @param effect CAROM_EFFECT_*   @param mode CAROM_MODE_*
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT
    pub fn set_effect(&mut self, effect: u32, mode: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_effect(p, effect, mode, e) })
    }

    /// @param mode out   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY
    pub fn effect(&self, effect: u32) -> Result<u32> {
        let mut mode = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_effect(p, effect, &mut mode, e) })?;
        Ok(mode)
    }

    /// The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
    /// the world is forbidden for it. Particles, events and the ledger are not a body's.
    /// @param mode CAROM_MODE_*
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
    ///         carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn body_set_effect(&mut self, body: raw::carom_body, effect: u32, mode: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_body_set_effect(p, body, effect, mode, e) })
    }

    /// @param mode out: of the body itself   @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY
    pub fn body_effect(&self, body: raw::carom_body, effect: u32) -> Result<u32> {
        let mut mode = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_body_get_effect(p, body, effect, &mut mode, e) })?;
        Ok(mode)
    }

    /// Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
    /// @param on 1 or 0 (as a world is created)
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn time_effects(&mut self, on: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_time_effects(p, on, e) })
    }

    /// Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_plan_line) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn plan(&self) -> Result<Vec<raw::carom_plan_line>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_plan(p, dst, size_of::<raw::carom_plan_line>() as u64, capacity, count, e) })
    }

    /// Stop recording.
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
    ///         recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT
    pub fn record_end(&mut self) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_record_end(p, e) })
    }

    /// Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
    /// @param difference its struct_size set by the caller
    /// @param bytes [size] of carom_world_save()   @param size number of bytes
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY   @thread reader
    pub fn compare(&self, bytes: &[u8]) -> Result<raw::carom_difference> {
        let mut difference = <raw::carom_difference>::default();
        let size = bytes.len() as u64;
        self.call(|p, e| unsafe { raw::carom_world_compare(p, bytes.as_ptr().cast(), size, &mut difference, e) })?;
        Ok(difference)
    }

    /// @param residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
    ///                  concerns them is 0.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    /// @accuracy rounding; effective masses are those along the normal
    /// @cost linear in contact points, joints and bodies
    pub fn residuals(&self) -> Result<raw::carom_residuals> {
        let mut residuals = <raw::carom_residuals>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_residuals(p, &mut residuals, e) })?;
        Ok(residuals)
    }

    /// Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
    /// the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
    /// Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
    /// for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
    /// host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
    /// chose.
    /// @param seconds  s of wall clock a step, 0 < seconds <= 10; 0: off, the dial keeps its value
    /// @param fewest, most  substeps, 1 <= fewest <= most <= the dial's bound; ignored when off
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn set_budget(&mut self, seconds: f64, fewest: u32, most: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_budget(p, seconds, fewest, most, e) })
    }

    /// @param seconds, fewest, most  out: as set; 0 when off   @status OK; NULL_ARGUMENT; BUSY
    pub fn budget(&self) -> Result<(f64, u32, u32)> {
        let mut seconds = <f64>::default();
        let mut fewest = <u32>::default();
        let mut most = <u32>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_budget(p, &mut seconds, &mut fewest, &mut most, e) })?;
        Ok((seconds, fewest, most))
    }

    /// Write a snapshot, between steps. Reads only: other readers may be at work.
    /// @param flags    CAROM_SNAPSHOT_*
    /// @param buffer   [capacity] bytes, or NULL to get the size alone
    /// @param capacity bytes; 0 if buffer is NULL
    /// @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader
    pub fn save(&self, flags: u32) -> Result<Vec<u8>> {
        self.list(|p, dst: *mut u8, capacity, count, e| unsafe { raw::carom_world_save(p, flags, dst.cast(), capacity, count, e) })
    }

    /// Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
    /// anything of the world changes.
    /// An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
    /// begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
    /// as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
    /// that is not whole.
    /// @param bytes [size], of any alignment   @param size as carom_world_save() gave it
    /// @status OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
    /// newer
    ///         format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
    ///         that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
    ///         says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn restore(&mut self, bytes: &[u8]) -> Result<()> {
        let size = bytes.len() as u64;
        self.call(|p, e| unsafe { raw::carom_world_restore(p, bytes.as_ptr().cast(), size, e) })
    }

    /// Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
    /// that it has forked, or of one that was saved whole, in another process too.
    /// @param handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
    /// @param translated [n] out; may be `handles`. All of them or, where one is refused, none
    /// @status OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
    ///         worlds); BUSY; REENTRANT   @thread reader
    pub fn translate_handles(&self, handles: &[u64], translated: &mut [u64]) -> Result<()> {
        let n = handles.len() as u64;
        fits(translated.len(), n)?;
        self.call(|p, e| unsafe { raw::carom_world_translate_handles(p, handles.as_ptr(), n, translated.as_mut_ptr(), e) })
    }

    /// Copy out what the coordinates of a tree are.
    /// @param body     any dynamic body of the tree; its base, where nothing holds the tree
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_tree_coordinate) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
    ///         BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY
    pub fn tree_coordinates(&self, body: raw::carom_body) -> Result<Vec<raw::carom_tree_coordinate>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_tree_get_coordinates(p, body, dst, size_of::<raw::carom_tree_coordinate>() as u64, capacity, count, e) })
    }

    /// The speeds that a tree has now.
    /// Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
    /// @param speeds out, [n]   @param n how many coordinates there are
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
    ///         OUT_OF_MEMORY
    pub fn tree_speeds(&self, body: raw::carom_body, speeds: &mut [f64]) -> Result<()> {
        let n = speeds.len() as u64;
        self.call(|p, e| unsafe { raw::carom_tree_get_speeds(p, body, speeds.as_mut_ptr(), n, e) })
    }

    /// Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
    ///     forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
    /// With speeds of 0 and no accelerations these hold the tree against gravity.
    /// Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
    /// @param speeds        [n] m/s and rad/s, or NULL: those of now
    /// @param accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
    /// @param forces        out, [n] N and N m
    /// @param n             how many coordinates there are
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
    ///         OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY
    pub fn tree_forces(&self, body: raw::carom_body, speeds: Option<&[f64]>, accelerations: Option<&[f64]>, forces: &mut [f64]) -> Result<()> {
        let n = forces.len() as u64;
        speeds.map_or(Ok(()), |it| fits(it.len(), n))?;
        accelerations.map_or(Ok(()), |it| fits(it.len(), n))?;
        self.call(|p, e| unsafe { raw::carom_tree_get_forces(p, body, speeds.map_or(null(), |it| it.as_ptr()), accelerations.map_or(null(), |it| it.as_ptr()), forces.as_mut_ptr(), n, e) })
    }

    /// Advance by dt.
    /// @param dt s, in [1e-9, 1]
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    /// Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
    /// A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it.
    pub fn step(&mut self, dt: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_step(p, dt, e) })
    }

    /// @param value within the dial's bounds; whole for choices and integers
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn set_dial(&mut self, dial: u32, value: f64) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_dial(p, dial, value, e) })
    }

    /// @param value as carom_world_set_dial() takes it   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY
    pub fn dial(&self, dial: u32) -> Result<f64> {
        let mut value = <f64>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_dial(p, dial, &mut value, e) })?;
        Ok(value)
    }

    /// Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
    /// carom_world_set_dial() change them one by one.   @param preset CAROM_PRESET_*
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT
    pub fn set_preset(&mut self, preset: u32) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_preset(p, preset, e) })
    }

    /// @param gravity [3] m/s^2, |each| <= 1e6   @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<()> {
        self.call(|p, e| unsafe { raw::carom_world_set_gravity(p, gravity.as_ptr(), e) })
    }

    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn gravity(&self) -> Result<[f64; 3]> {
        let mut gravity = <[f64; 3]>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_gravity(p, gravity.as_mut_ptr(), e) })?;
        Ok(gravity)
    }

    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn report(&self) -> Result<raw::carom_step_report> {
        let mut report = <raw::carom_step_report>::default();
        self.call(|p, e| unsafe { raw::carom_world_get_report(p, &mut report, e) })?;
        Ok(report)
    }

    /// Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_contact) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn contacts(&self) -> Result<Vec<raw::carom_contact>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_contacts(p, dst, size_of::<raw::carom_contact>() as u64, capacity, count, e) })
    }

    /// Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
    /// all groups alike: then there are none.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_group) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn groups(&self) -> Result<Vec<raw::carom_group>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_groups(p, dst, size_of::<raw::carom_group>() as u64, capacity, count, e) })
    }

    /// Copy out the faults of the last step; arguments as carom_world_get_contacts().
    pub fn faults(&self) -> Result<Vec<raw::carom_fault>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_faults(p, dst, size_of::<raw::carom_fault>() as u64, capacity, count, e) })
    }

    /// 64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
    /// has the same bits, and every particle's position and velocity.
    /// @param hash of the state
    /// @status OK; NULL_ARGUMENT; BUSY   @thread reader
    pub fn hash(&self) -> Result<u64> {
        let mut hash = <u64>::default();
        self.call(|p, e| unsafe { raw::carom_world_hash(p, &mut hash, e) })?;
        Ok(hash)
    }

    /// What one ray meets first: origin + t direction, 0 <= t <= max.
    /// @param origin [3] m   @param direction [3] m per unit of t, any length   @param max >= 0, may be infinite
    /// @param desc   may be NULL: defaults   @param size sizeof(carom_world_hit) as the caller knows it
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc->ignore); NOT_FINITE; OUT_OF_RANGE;
    ///         BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   @thread reader
    pub fn cast_ray(&self, origin: [f64; 3], direction: [f64; 3], max: f64, desc: Option<&raw::carom_query_desc>) -> Result<raw::carom_world_hit> {
        let desc = desc.map(|it| raw::carom_query_desc { struct_size: size_of::<raw::carom_query_desc>() as u32, ..*it });
        let mut hit = <raw::carom_world_hit>::default();
        self.call(|p, e| unsafe { raw::carom_world_cast_ray(p, origin.as_ptr(), direction.as_ptr(), max, desc.as_ref().map_or(null(), |it| it), &mut hit, size_of::<raw::carom_world_hit>() as u64, e) })?;
        Ok(hit)
    }
}

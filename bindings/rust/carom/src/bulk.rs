//! One call for n bodies: their handles, and one field of each, as slices of the caller's.
use crate::{raw, Body, Error, Result, World};
use std::mem::size_of;
use std::ptr::null;

/// A body's place. Orientation: x, y, z, w.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    pub position: [f64; 3],
    pub orientation: [f64; 4],
}

impl Default for Pose {
    fn default() -> Self {
        Pose { position: [0.0; 3], orientation: [0.0, 0.0, 0.0, 1.0] }
    }
}

/// Numbers of arrays: f32 or f64.
pub trait Scalar: Copy + private::Sealed {
    const SCALAR: u32;
}
impl Scalar for f32 {
    const SCALAR: u32 = raw::CAROM_SCALAR_F32;
}
impl Scalar for f64 {
    const SCALAR: u32 = raw::CAROM_SCALAR_F64;
}
mod private {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

impl World {
    pub fn bodies(&self) -> Result<Vec<Body>> {
        self.list(|p, dst, capacity, count, e| unsafe { raw::carom_world_get_bodies(p, dst, capacity, count, e) })
    }

    /// One field (`raw::CAROM_FIELD_*`) of some bodies, or of all in the order of [`World::bodies`].
    pub fn read<T: Scalar, const N: usize>(&self, field: u32, of: Option<&[Body]>, dst: &mut [[T; N]]) -> Result<()> {
        let (bodies, n) = selected(of, dst.len())?;
        self.call(|p, e| unsafe {
            raw::carom_world_read(
                p,
                field,
                T::SCALAR,
                bodies,
                n,
                dst.as_mut_ptr().cast(),
                size_of::<[T; N]>() as u64,
                e,
            )
        })
    }

    pub fn write<T: Scalar, const N: usize>(&mut self, field: u32, of: Option<&[Body]>, src: &[[T; N]]) -> Result<()> {
        let (bodies, n) = selected(of, src.len())?;
        self.call(|p, e| unsafe {
            raw::carom_world_write(p, field, T::SCALAR, bodies, n, src.as_ptr().cast(), size_of::<[T; N]>() as u64, e)
        })
    }

    /// Of all bodies, in the order of [`World::bodies`].
    pub fn positions(&self, dst: &mut [[f64; 3]]) -> Result<()> {
        self.read(raw::CAROM_FIELD_POSITION, None, dst)
    }

    pub fn poses(&self, dst: &mut [Pose]) -> Result<()> {
        // A Pose is seven doubles, as a record of this field.
        let numbers = unsafe { std::slice::from_raw_parts_mut(dst.as_mut_ptr().cast::<[f64; 7]>(), dst.len()) };
        self.read(raw::CAROM_FIELD_POSE, None, numbers)
    }
}

fn selected(of: Option<&[Body]>, n: usize) -> Result<(*const Body, u64)> {
    match of {
        Some(bodies) if bodies.len() != n => {
            let message = format!("{n} records for {} bodies", bodies.len());
            Err(Error::new(raw::CAROM_E_OUT_OF_RANGE, message, "pass as many records as bodies"))
        }
        Some(bodies) => Ok((bodies.as_ptr(), n as u64)),
        None => Ok((null(), n as u64)),
    }
}

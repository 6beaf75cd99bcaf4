//! Failures, and whether the library that was loaded fits this crate.
use crate::{calls::text, raw};
use std::ffi::{c_char, CStr};
use std::sync::OnceLock;

/// What was wrong, and what to do. Nothing has changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    /// `raw::CAROM_E_*`
    pub code: i32,
    /// 1-based position of the argument at fault in the C signature, 0: none in particular
    pub argument: i32,
    pub message: String,
    pub remedy: String,
    /// Direction and point that prove a support function false
    pub witness: Option<([f64; 3], [f64; 3])>,
}

pub type Result<T> = std::result::Result<T, Error>;

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}. Remedy: {}", self.message, self.remedy)
    }
}

impl std::error::Error for Error {}

/// Make a call, whose last argument is a `carom_error*`.
#[inline]
pub(crate) fn check(call: impl FnOnce(*mut raw::carom_error) -> i32) -> Result<()> {
    // Written on failure only: nothing but its size is set, or read.
    let mut details = std::mem::MaybeUninit::<raw::carom_error>::uninit();
    let pointer = details.as_mut_ptr();
    unsafe { (*pointer).struct_size = std::mem::size_of::<raw::carom_error>() as u32 };
    match call(pointer) {
        raw::CAROM_OK => Ok(()),
        code => Err(failure(code, pointer)),
    }
}

#[cold]
fn failure(code: i32, details: *const raw::carom_error) -> Error {
    let text = |words: *const c_char| unsafe { CStr::from_ptr(words) }.to_string_lossy().into_owned();
    let e = unsafe { &*details };
    Error {
        code,
        argument: e.argument,
        message: text(e.message.as_ptr()),
        remedy: text(e.remedy.as_ptr()),
        witness: (e.has_witness == 1).then_some((e.witness_dir, e.witness_out)),
    }
}

/// Is the library that was loaded one that this crate can call? Asked once: version, and the layout of every struct.
pub(crate) fn check_library() -> Result<()> {
    static CHECKED: OnceLock<Result<()>> = OnceLock::new();
    CHECKED.get_or_init(|| check_layout(&layout())).clone()
}

pub(crate) fn layout() -> String {
    let row = |(name, offset, size, kind): &_| format!("{name} {offset} {size} {kind}\n");
    format!("carom {}\n", raw::VERSION) + &raw::LAYOUT.iter().map(row).collect::<String>()
}

pub(crate) fn check_layout(layout: &str) -> Result<()> {
    let layout = text(layout)?;
    check(|e| unsafe { raw::carom_abi_check(layout.as_ptr(), e) })
}

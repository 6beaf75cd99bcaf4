//! Failures, and whether the library that was loaded fits this crate.
use crate::raw;
use std::collections::HashMap;
use std::ffi::{c_char, c_void, CStr, CString};
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

impl Error {
    pub(crate) fn new(code: i32, message: String, remedy: &str) -> Self {
        Error { code, argument: 0, message, remedy: remedy.into(), witness: None }
    }
}

/// What C takes as a text.
pub(crate) fn text(text: &str) -> Result<CString> {
    let refused = |_| Error::new(raw::CAROM_E_OUT_OF_RANGE, format!("{text:?} has a zero byte"), "leave it out");
    CString::new(text).map_err(refused)
}

/// Whether slices that go together are of one length.
pub(crate) fn fits(n: usize, wanted: u64) -> Result<()> {
    let refused =
        || Error::new(raw::CAROM_E_OUT_OF_RANGE, format!("{n} where {wanted} are wanted"), "pass slices of one length");
    (n as u64 == wanted).then_some(()).ok_or_else(refused)
}

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

/// Is the library that was loaded one that this crate can call? Compared once: version, and the layout of every struct.
pub(crate) fn check_library() -> Result<()> {
    static CHECKED: OnceLock<Result<()>> = OnceLock::new();
    let of_library = || {
        let manifest = unsafe { CStr::from_ptr(raw::carom_abi_manifest()) };
        check_manifest(&manifest.to_string_lossy(), &file_of(manifest.as_ptr().cast()))
    };
    CHECKED.get_or_init(of_library).clone()
}

#[cfg(not(unix))]
fn file_of(_: *const c_void) -> String {
    "libcarom".into()
}

/// The file that an address belongs to.
#[cfg(unix)]
fn file_of(address: *const c_void) -> String {
    #[repr(C)]
    struct Info(*const c_char, *const c_void, *const c_char, *const c_void);
    extern "C" {
        fn dladdr(address: *const c_void, info: *mut Info) -> i32;
    }
    let mut info = Info(std::ptr::null(), std::ptr::null(), std::ptr::null(), std::ptr::null());
    match unsafe { dladdr(address, &mut info) } {
        0 => "libcarom".into(),
        _ => unsafe { CStr::from_ptr(info.0) }.to_string_lossy().into_owned(),
    }
}

pub(crate) fn check_manifest(manifest: &str, file: &str) -> Result<()> {
    let remedy = "install a libcarom and a crate of one version, or build the crate against that library anew";
    let refuse = |what: String| Err(Error::new(raw::CAROM_E_UNSUPPORTED, format!("{file} {what}"), remedy));
    let (first, rows) = manifest.split_once('\n').unwrap_or_default();
    let version = first.strip_prefix("carom ").unwrap_or("?");
    let numbers = |text: &str| text.split('.').map(|n| n.parse().ok()).collect::<Option<Vec<u32>>>();
    let (there, here) = (numbers(version).unwrap_or_default(), numbers(raw::VERSION).unwrap_or_default());
    // Before 1.0 a minor version may break clients.
    if there < here || there[0] != here[0] || here[0] == 0 && there[1] != here[1] {
        return refuse(format!("is of version {version}, this crate of {}", raw::VERSION));
    }
    let rows: HashMap<_, _> = rows.lines().filter_map(|line| line.split_once(' ')).collect();
    for &(name, offset, size, kind) in raw::LAYOUT {
        let ours = format!("{offset} {size} {kind}");
        let Some(&theirs) = rows.get(name) else { return refuse(format!("has no {name}")) };
        let more = theirs.split(' ').nth(1).and_then(|n| n.parse().ok()) > Some(size); // what a newer one has more is not ours
        if theirs != ours && !(more && kind == "struct" && theirs.ends_with(" struct")) {
            return refuse(format!("has {name} as {theirs} (offset, bytes, kind), this crate as {ours}"));
        }
    }
    Ok(())
}

//! Failures, and whether the library that was loaded fits this crate.
use crate::raw;
use std::collections::HashMap;
use std::ffi::{c_char, c_void, CStr};
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

fn check_manifest(manifest: &str, file: &str) -> Result<()> {
    let here = raw::VERSION;
    let remedy = "install a libcarom and a crate of one version, or build the crate against that library anew";
    let refuse = |what: String| Err(Error::new(raw::CAROM_E_UNSUPPORTED, format!("{file} {what}"), remedy));
    let mut lines = manifest.lines();
    let version = lines.next().and_then(|line| line.strip_prefix("carom ")).unwrap_or("?");
    let numbers = |text: &str| text.split('.').map(|n| n.parse().ok()).collect::<Option<Vec<u32>>>();
    let fits = match (numbers(version), numbers(here)) {
        // Before 1.0 a minor version may break clients.
        (Some(there), Some(here)) => {
            there[0] == here[0] && (there[0] > 0 || there.get(1) == here.get(1)) && there >= here
        }
        _ => false,
    };
    if !fits {
        return refuse(format!("is of version {version}, this crate of {here}"));
    }
    let mut rows = HashMap::new();
    for line in lines {
        if let [name, offset, size, kind] = line.split(' ').collect::<Vec<_>>()[..] {
            rows.insert(name, (offset.parse().unwrap_or(usize::MAX), size.parse().unwrap_or(0), kind));
        }
    }
    for &(name, offset, size, kind) in raw::LAYOUT {
        match rows.get(name) {
            Some(&there) if there == (offset, size, kind) => {}
            Some(&(_, longer, "struct")) if kind == "struct" && longer > size => {} // what a newer one has more is not ours
            Some(&(at, bytes, other)) => {
                return refuse(format!(
                    "has {name} as {other} of {bytes} bytes at {at}, this crate as {kind} of {size} bytes at {offset}"
                ))
            }
            None => return refuse(format!("has no {name}")),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_library_is_refused() {
        let ours = unsafe { CStr::from_ptr(raw::carom_abi_manifest()) }.to_str().unwrap();
        assert_eq!(check_manifest(ours, "x"), Ok(()));
        let said = |other: &str| check_manifest(&ours.replacen(raw::VERSION, other, 1), "/lib/x.so").unwrap_err();
        for other in ["0.0.1", "0.99.0", "99.0.0", "?"] {
            assert!(said(other).message.starts_with("/lib/x.so is of version "), "{}", said(other));
        }
        let patched = ours.replacen(raw::VERSION, &format!("{}1", raw::VERSION), 1);
        assert_eq!(check_manifest(&patched, "x"), Ok(()));
        let (_, row) = ours.split_once("carom_contact.separation ").unwrap();
        let row = row.lines().next().unwrap();
        let moved = ours.replace(&format!("separation {row}"), "separation 4 8 f64");
        assert!(check_manifest(&moved, "x")
            .unwrap_err()
            .message
            .contains("carom_contact.separation as f64 of 8 bytes at 4"));
        let gone = ours.replace(&format!("carom_contact.separation {row}\n"), "");
        assert!(check_manifest(&gone, "x").unwrap_err().message.contains("has no carom_contact.separation"));
    }
}

//! What is refused of a library that does not fit.
use crate::error::check_manifest;
use crate::raw;
use std::ffi::CStr;

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
    assert!(check_manifest(&moved, "x").unwrap_err().message.contains("carom_contact.separation as 4 8 f64 "));
    let gone = ours.replace(&format!("carom_contact.separation {row}\n"), "");
    assert!(check_manifest(&gone, "x").unwrap_err().message.contains("has no carom_contact.separation"));
}

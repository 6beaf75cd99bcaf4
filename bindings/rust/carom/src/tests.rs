//! What is refused of a library that does not fit.
use crate::error::{check_layout, layout};
use crate::raw;

#[test]
fn another_library_is_refused() {
    let ours = layout();
    assert_eq!(check_layout(&ours), Ok(()));
    let said = |other: &str| check_layout(&ours.replacen(raw::VERSION, other, 1)).unwrap_err();
    for other in ["0.0.1", "0.99.0", "99.0.0"] {
        assert!(said(other).message.contains(" is of version "), "{}", said(other));
    }
    let (_, row) = ours.split_once("carom_contact.separation ").unwrap();
    let row = row.lines().next().unwrap();
    let moved = ours.replace(&format!("separation {row}"), "separation 4 8 f64");
    assert!(check_layout(&moved).unwrap_err().message.contains(&format!("carom_contact.separation as {row} ")));
    let more = format!("{ours}carom_contact.mood 0 8 f64\n");
    assert!(check_layout(&more).unwrap_err().message.contains("has no carom_contact.mood"));
}

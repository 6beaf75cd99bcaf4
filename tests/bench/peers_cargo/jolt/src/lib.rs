//! Jolt in a module: `../peer_jolt.cpp`, and what the crate builds beneath it.

use joltc_sys as _;

plan::export_engine!();

//! PhysX in a module: `../peer_physx.cpp`, and what the crate builds beneath it.

use physx_sys as _;

plan::export_engine!();

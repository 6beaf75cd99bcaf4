//! Box3D in a module: `../peer_box3d.cpp`, and what the crate builds beneath it.

use boxddd_sys as _;

plan::export_engine!();

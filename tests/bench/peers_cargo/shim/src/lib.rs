//! For build scripts: compiles a C++ file that implements s_table's peer.h, beside the headers of a crate from the registry.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where cargo keeps the sources of a package that this crate depends on.
pub fn source_of(package: &str) -> PathBuf {
    let cargo = env::var("CARGO").expect("cargo says which cargo runs");
    let told = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--locked", "--offline"])
        .current_dir(here())
        .output()
        .expect("cargo metadata runs");
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    let text = String::from_utf8(told.stdout).expect("cargo writes UTF-8");
    // Of each package its name and version come before its manifest; where others ask for it, no version follows its name.
    let from = text.find(&format!("{{\"name\":\"{package}\",\"version\"")).expect("the package is a dependency");
    let key = "\"manifest_path\":\"";
    let start = from + text[from..].find(key).expect("a package has a manifest") + key.len();
    let end = start + text[start..].find('"').expect("the string ends");
    Path::new(&text[start..end]).parent().expect("a manifest is in a folder").to_path_buf()
}

/// The compiler as every shim wants it; warnings in an engine's headers are its own.
pub fn compiler(sources: [&str; 2]) -> cc::Build {
    let s_table = here().join("../../s_table");
    for source in sources {
        println!("cargo:rerun-if-changed={source}");
    }
    for header in ["peer.h", "counted_memory.h", "ground.h", "../casts/peer.h", "../convex/peer.h"] {
        println!("cargo:rerun-if-changed={}", s_table.join(header).display());
    }
    let mut build = cc::Build::new();
    build.cpp(true).std("c++20").opt_level(3).define("NDEBUG", None).include(s_table).files(sources).warnings(false);
    build
}

fn here() -> PathBuf {
    PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo says where the crate is"))
}

//! Where the library is: built here (feature vendored), in $CAROM_LIBRARY_DIR, or where pkg-config says.
use std::path::{Path, PathBuf};
use std::process::{exit, Command};
use std::{env, io};

fn refuse(why: &str) -> ! {
    eprintln!("carom-sys: {why}");
    exit(1)
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=CAROM_LIBRARY_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    if env::var_os("CARGO_FEATURE_VENDORED").is_some() {
        return vendored();
    }
    let folder = match env::var_os("CAROM_LIBRARY_DIR") {
        Some(given) => PathBuf::from(given),
        None => installed(),
    };
    let name = library_name();
    let file = folder.join(name);
    if !file.exists() {
        refuse(&format!(
            "{} does not exist. Set CAROM_LIBRARY_DIR to the folder that holds {name}: \
             PREFIX/lib after `cmake --install`, or the `lib` of a build",
            file.display()
        ));
    }
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rustc-link-lib=dylib=carom");
}

fn target() -> String {
    env::var("CARGO_CFG_TARGET_OS").unwrap()
}

/// What is linked with.
fn library_name() -> &'static str {
    match target().as_str() {
        "windows" => "libcarom.dll.a",
        "macos" => "libcarom.dylib",
        _ => "libcarom.so",
    }
}

fn installed() -> PathBuf {
    let at_least = format!("carom >= {}", env!("CARGO_PKG_VERSION"));
    let cure = "Install Carom (`cmake --install`), set PKG_CONFIG_PATH to the folder that holds carom.pc, or \
                CAROM_LIBRARY_DIR to the folder with the library; or take the feature `vendored`";
    match Command::new("pkg-config").args(["--print-errors", "--variable=libdir", &at_least]).output() {
        Ok(done) if done.status.success() => PathBuf::from(String::from_utf8_lossy(&done.stdout).trim()),
        Ok(done) => refuse(&format!("pkg-config says: {}\n{cure}", String::from_utf8_lossy(&done.stderr).trim())),
        Err(problem) => refuse(&format!("pkg-config cannot be run ({problem}). {cure}")),
    }
}

/// The archive with all shapes in it, from the sources in this crate, or those that it lies among.
fn vendored() {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let (own, around) = (here.join("vendor"), here.join("../../.."));
    let root = if own.exists() { own } else { around }; // as a package has them, or a checkout
    if !root.join("src/abi/carom.map").exists() {
        refuse(&format!(
            "feature vendored builds the sources of Carom, which are not at {}: take the crate from a checkout",
            root.display()
        ));
    }
    for part in ["src", "plugins", "include", "CMakeLists.txt"] {
        println!("cargo:rerun-if-changed={}", root.join(part).display());
    }
    let build = Path::new(&env::var("OUT_DIR").unwrap()).join("build");
    let cmake = |command: &mut Command| match command.status() {
        Ok(status) if status.success() => {}
        Ok(_) => refuse("cmake failed, see above. Debian's packages for it: cmake g++ libeigen3-dev"),
        Err(problem) if problem.kind() == io::ErrorKind::NotFound => {
            refuse("feature vendored takes cmake, which is not installed")
        }
        Err(problem) => refuse(&format!("cmake cannot be run: {problem}")),
    };
    let switches = ["BUILD_TOOLS", "BUILD_TESTS", "INSTALL"].map(|what| format!("-DCAROM_{what}=OFF"));
    let archive = build.join("archive");
    cmake(
        Command::new("cmake")
            .arg("-S")
            .arg(&root)
            .arg("-B")
            .arg(&build)
            .args(switches)
            .args(["-DCMAKE_BUILD_TYPE=Release", "-DCAROM_UNITY=ON", "-DCAROM_BUILD_STATIC=ON"])
            .arg(format!("-DCMAKE_ARCHIVE_OUTPUT_DIRECTORY={}", archive.display())),
    );
    let jobs = env::var("NUM_JOBS").unwrap_or_else(|_| "1".into());
    cmake(Command::new("cmake").arg("--build").arg(&build).args(["--target", "carom_static", "-j", &jobs]));
    println!("cargo:rustc-link-search=native={}", archive.display());
    println!("cargo:rustc-link-lib=static=carom");
    println!("cargo:rustc-link-lib=dylib={}", if target() == "macos" { "c++" } else { "stdc++" });
}

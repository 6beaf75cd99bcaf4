/// As the crate has CMake compile Jolt: its headers must mean the same here.
const DEFINES: [&str; 9] = [
    "DEBUG_RENDERER", "USE_AVX", "USE_AVX2", "USE_F16C", "USE_FMADD", "USE_LZCNT", "USE_SSE4_1", "USE_SSE4_2", "USE_TZCNT",
];
const FLAGS: [&str; 7] = ["-mavx2", "-mbmi", "-mpopcnt", "-mlzcnt", "-mf16c", "-mfma", "-ffp-contract=off"];

fn main() {
    let mut build = shim::compiler(["peer_jolt.cpp", "queries_jolt.cpp"]);
    build.include(shim::source_of("joltc-sys").join("JoltC/JoltPhysics"));
    for name in DEFINES {
        build.define(&format!("JPH_{name}"), None);
    }
    for flag in FLAGS {
        build.flag(flag);
    }
    build.compile("peer_jolt");
}

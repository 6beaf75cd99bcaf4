fn main() {
    println!("cargo:rerun-if-changed=sdk.h");
    let include = shim::source_of("physx-sys").join("physx/physx/include");
    let mut build = shim::compiler(["peer_physx.cpp", "queries_physx.cpp"]);
    build.include(include).define("PX_PHYSX_STATIC_LIB", None).compile("peer_physx");
}

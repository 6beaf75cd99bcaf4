fn main() {
    let include = shim::source_of("physx-sys").join("physx/physx/include");
    shim::compiler("peer_physx.cpp").include(include).define("PX_PHYSX_STATIC_LIB", None).compile("peer_physx");
}

fn main() {
    let include = shim::source_of("boxddd-sys").join("third-party/box3d/include");
    shim::compiler(["peer_box3d.cpp", "queries_box3d.cpp"]).include(include).compile("peer_box3d");
}

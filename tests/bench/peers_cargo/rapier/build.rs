fn main() {
    shim::compiler(["../rapier/adapter.cpp", "../rapier/queries.cpp"]).compile("adapter");
}

fn main() {
    shim::compiler("../rapier/adapter.cpp").compile("adapter");
}

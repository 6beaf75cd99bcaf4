package carom;

import java.lang.foreign.*;
import java.lang.invoke.MethodHandle;

/** Finds libcarom, once: $CAROM_LIBRARY or the property carom.library, else the system's loader by its name. */
final class Library {
    private record Found(String file, SymbolLookup symbols, CaromException refusal) {}

    private static final Found FOUND = find();

    private static Found find() {
        String given = System.getProperty("carom.library", System.getenv("CAROM_LIBRARY"));
        String system = System.getProperty("os.name");
        String usual = system.startsWith("Windows") ? "carom.dll" : system.startsWith("Mac") ? Raw.SONAME.replace(".so", "") + ".dylib" : Raw.SONAME;
        String file = given == null ? usual : given;
        try {
            return new Found(file, SymbolLookup.libraryLookup(file, Arena.global()), null);
        } catch (IllegalArgumentException problem) {
            String remedy = "install libcarom " + Raw.VERSION + ", or set CAROM_LIBRARY to the path of " + usual;
            return new Found(file, null, new CaromException(Raw.CAROM_E_NOT_FOUND, "cannot load " + file, remedy));
        }
    }

    static MethodHandle call(String name, FunctionDescriptor descriptor) {
        if (FOUND.refusal != null) throw FOUND.refusal;
        // These read a few numbers and call nothing of the host's: the thread need not leave Java for them.
        boolean brief = name.startsWith("carom_body_get_") || name.startsWith("carom_body_is_");
        Linker.Option[] options = brief ? new Linker.Option[] {Linker.Option.critical(false)} : new Linker.Option[0];
        return FOUND.symbols.find(name).map(at -> Linker.nativeLinker().downcallHandle(at, descriptor, options))
            .orElseThrow(() -> new CaromException(Raw.CAROM_E_UNSUPPORTED, FOUND.file + " has no " + name, "install a libcarom and a carom.jar of one version"));
    }

    static RuntimeException thrown(Throwable problem) {
        if (problem instanceof ExceptionInInitializerError e && e.getCause() instanceof CaromException cause) return cause;
        if (problem instanceof RuntimeException e) return e;
        if (problem instanceof Error e) throw e;
        return new IllegalStateException(problem);
    }

    private static boolean checked;

    /** Is it one that Raw can call? Version, and the layout of every struct. */
    static synchronized void check() {
        if (!checked) check(Raw.LAYOUT);
        checked = true;
    }

    static void check(String layout) {
        try (Arena local = Arena.ofConfined()) {
            var scratch = Scratch.get();
            scratch.check(Raw.carom_abi_check(local.allocateFrom(layout), scratch.error.segment));
        }
    }

    /** Memory of one thread, used in each of its calls: the error that C writes on failure, and room for what it reads. */
    static final class Scratch {
        private static final ThreadLocal<Scratch> OF_THREAD = ThreadLocal.withInitial(Scratch::new);
        final Raw.Error error = new Raw.Error(Arena.ofAuto());
        final MemorySegment out = Arena.ofAuto().allocate(64, 8);
        private MemorySegment buffer = out;

        static Scratch get() { return OF_THREAD.get(); }

        /** For an array on its way, kept for the next one: fresh pages would cost more than the copy. */
        MemorySegment buffer(long bytes) {
            if (buffer.byteSize() < bytes) buffer = Arena.ofAuto().allocate(bytes, 8);
            return buffer;
        }

        void check(int result) {
            if (result != Raw.CAROM_OK) throw new CaromException(result, error);
        }
    }
}

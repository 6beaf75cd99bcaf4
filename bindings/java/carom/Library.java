package carom;

import java.lang.foreign.*;
import java.lang.invoke.MethodHandle;
import java.util.HashMap;
import java.util.function.Consumer;

/** Finds libcarom, once: $CAROM_LIBRARY or the property carom.library, else the system's loader by its name. */
final class Library {
    private Library() {}

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
            .orElseThrow(() -> unfit(FOUND.file, "has no " + name));
    }

    static RuntimeException thrown(Throwable problem) {
        if (problem instanceof ExceptionInInitializerError e && e.getCause() instanceof CaromException cause) return cause;
        if (problem instanceof RuntimeException e) return e;
        if (problem instanceof Error e) throw e;
        return new IllegalStateException(problem);
    }

    private static CaromException unfit(String file, String what) {
        return new CaromException(Raw.CAROM_E_UNSUPPORTED, file + " " + what, "install a libcarom and a carom.jar of one version");
    }

    private static boolean checked;

    /** Is it one that Raw can call? Version, and the layout of every struct. */
    static synchronized void check() {
        if (!checked) check(Raw.carom_abi_manifest(), FOUND.file);
        checked = true;
    }

    static void check(String manifest, String file) {
        String version = manifest.lines().findFirst().orElse("").replaceFirst("^carom ", "");
        int[] here = numbers(Raw.VERSION), there = numbers(version);
        boolean same = there[0] == here[0] && (here[0] > 0 || there[1] == here[1]); // 0.10 differs from 0.9
        if (!same || there[1] < here[1] || there[1] == here[1] && there[2] < here[2])
            throw unfit(file, "is of version " + version + ", this package of " + Raw.VERSION);
        var rows = new HashMap<String, String[]>();
        manifest.lines().map(line -> line.split(" ")).forEach(words -> rows.put(words[0], words));
        for (String line : Raw.LAYOUT.split("\n")) {
            String[] ours = line.split(" "), theirs = rows.get(ours[0]);
            if (theirs == null) throw unfit(file, "has no " + ours[0]);
            // A struct of a newer library may be longer: the tail is not ours.
            boolean longer = ours[3].equals("struct") && theirs[3].equals("struct") && Integer.parseInt(theirs[2]) > Integer.parseInt(ours[2]);
            if (!line.equals(String.join(" ", theirs)) && !longer)
                throw unfit(file, "has %s as %s of %s bytes at %s, this package as %s of %s bytes at %s"
                    .formatted(ours[0], theirs[3], theirs[2], theirs[1], ours[3], ours[2], ours[1]));
        }
    }

    private static int[] numbers(String version) {
        try {
            String[] parts = version.split("\\.");
            return new int[] {Integer.parseInt(parts[0]), Integer.parseInt(parts[1]), Integer.parseInt(parts[2])};
        } catch (RuntimeException none) {
            return new int[] {-1, -1, -1};
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

    // What C is given of Java's: NULL for null, and never an empty block, since a shape may have no parameters.
    static MemorySegment in(Arena arena, double... it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(ValueLayout.JAVA_DOUBLE, it); }
    static MemorySegment in(Arena arena, long[] it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(ValueLayout.JAVA_LONG, it); }
    static MemorySegment in(Arena arena, int[] it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(ValueLayout.JAVA_INT, it); }
    static MemorySegment in(Arena arena, byte[] it) { return it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(ValueLayout.JAVA_BYTE, it); }
    static MemorySegment in(Arena arena, Vec3 v) { return v == null ? MemorySegment.NULL : in(arena, v.x(), v.y(), v.z()); }
    static MemorySegment in(Arena arena, Quat q) { return q == null ? MemorySegment.NULL : in(arena, q.x(), q.y(), q.z(), q.w()); }
    static MemorySegment in(Arena arena, String text) { return arena.allocateFrom(text); }

    static void fits(int n, int wanted) {
        if (n != wanted) throw new CaromException(Raw.CAROM_E_OUT_OF_RANGE, n + " where " + wanted + " are wanted", "pass arrays of one length");
    }

    interface Ask {
        int of(MemorySegment pointer, MemorySegment dst, long capacity, MemorySegment count, MemorySegment error);
    }

    /** All of a list that says how many there are: asked for none first, then for all. */
    static MemorySegment list(Consumer<Engine.Call> call, Arena arena, long size, Ask ask) {
        MemorySegment count = Arena.ofAuto().allocate(8, 8);
        for (long room = 0;; room = count.get(ValueLayout.JAVA_LONG, 0)) {
            MemorySegment dst = room == 0 ? MemorySegment.NULL : arena.allocate(size * room, 8);
            long fits = room;
            call.accept((p, e) -> {
                int result = ask.of(p, dst, fits, count, e);
                return result == Raw.CAROM_E_BUFFER_TOO_SMALL && count.get(ValueLayout.JAVA_LONG, 0) > fits ? Raw.CAROM_OK : result; // so do some say how many
            });
            if (count.get(ValueLayout.JAVA_LONG, 0) <= room) return dst.asSlice(0, size * count.get(ValueLayout.JAVA_LONG, 0));
        }
    }
}

package carom;

import static java.lang.foreign.ValueLayout.*;

import java.lang.foreign.*;
import java.lang.invoke.*;

/** Owns plugins and shapes, makes worlds. Close it after its worlds. Any thread may use it. */
public final class Engine extends EngineCalls {
    private final Arena arena = Arena.ofAuto(); // what C has pointers to; a world has the engine, so they outlive both

    public Engine() { this(1); }

    /** @param threads that share the work of a step; the outcome is the same to the bit */
    public Engine(int threads) {
        super(create());
        if (threads <= 1) return;
        try {
            var jobs = new Raw.JobsDesc(arena).threads(threads);
            call((p, e) -> Raw.carom_engine_set_jobs(p, jobs.segment, e));
        } catch (RuntimeException refused) {
            close();
            throw refused;
        }
    }

    private static MemorySegment create() {
        Library.check();
        var scratch = Library.Scratch.get();
        scratch.check(Raw.carom_engine_create(MemorySegment.NULL, scratch.out, scratch.error.segment));
        return scratch.out.get(ADDRESS, 0);
    }

    /** An empty world, with gravity along -y. */
    public World world() {
        var out = Library.Scratch.get().out;
        call((p, e) -> Raw.carom_world_create(p, MemorySegment.NULL, out, e));
        return new World(this, out.get(ADDRESS, 0));
    }

    /** A kind of shape whose support function is Java, called on the thread that makes the call. @return a plugin, for shape() */
    public synchronized long plugin(String id, Support support, Support.Param... params) {
        MemorySegment table = arena.allocate(32L * (params.length + 1), 8);
        for (int i = 0; i < params.length; i++)
            new Raw.Param(table.asSlice(32L * i, 32)).name(arena.allocateFrom(params[i].name())).unit(arena.allocateFrom(params[i].unit()))
                .min(params[i].min()).max(params[i].max());
        var description = new Raw.ShapePlugin(arena).abiMajor(Raw.CAROM_PLUGIN_ABI_MAJOR).abiMinor(Raw.CAROM_PLUGIN_ABI_MINOR)
            .flags(Raw.CAROM_PLUGIN_HOST_THREAD).id(arena.allocateFrom(id)).version(1).params(table).paramCount(params.length)
            .support(Linker.nativeLinker().upcallStub(ASK.bindTo(support), Raw.carom_support_fn, arena));
        var out = Library.Scratch.get().out;
        call((p, e) -> Raw.carom_plugin_register(p, description.segment, out, e));
        return out.get(JAVA_LONG, 0);
    }

    private static final MethodHandle ASK;

    static {
        try {
            ASK = MethodHandles.lookup().findStatic(Engine.class, "ask", MethodType.methodType(int.class, Support.class,
                MemorySegment.class, MemorySegment.class, long.class, MemorySegment.class, MemorySegment.class));
        } catch (ReflectiveOperationException problem) {
            throw new AssertionError(problem);
        }
    }

    private static int ask(Support support, MemorySegment user, MemorySegment params, long n, MemorySegment direction, MemorySegment out) {
        try { // nothing may be thrown through C
            Vec3 point = support.farthest(params.reinterpret(8 * n).toArray(JAVA_DOUBLE), Vec3.of(direction.reinterpret(24).toArray(JAVA_DOUBLE)));
            MemorySegment.copy(new double[] {point.x(), point.y(), point.z()}, 0, out.reinterpret(24), JAVA_DOUBLE, 0, 3);
            return 0;
        } catch (Throwable fault) {
            return 1;
        }
    }
}

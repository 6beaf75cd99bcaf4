package carom;

import static java.lang.foreign.ValueLayout.*;

import java.lang.foreign.*;

/** Bodies and what acts on them. Any number of threads may read it; beside one that changes it others get CAROM_E_BUSY. */
public final class World extends WorldCalls implements AutoCloseable {
    private final Engine engine;
    private MemorySegment pointer;

    World(Engine engine, MemorySegment pointer) {
        this.engine = engine;
        this.pointer = pointer;
    }

    public Engine engine() { return engine; }

    /** What calls of Raw take; NULL once it is closed, which they refuse. */
    public MemorySegment pointer() { return pointer; }

    /** Give back all memory; closing twice does nothing. */
    @Override
    public void close() {
        if (pointer.equals(MemorySegment.NULL)) return;
        call(Raw::carom_world_destroy);
        pointer = MemorySegment.NULL;
    }

    /** Any call of Raw on this world: world.call((w, e) -> Raw.carom_world_cast_rays(w, rays, want, desc, hits, e)). */
    @Override
    public void call(Engine.Call call) {
        var scratch = Library.Scratch.get();
        scratch.check(call.of(pointer, scratch.error.segment));
    }

    /** A dynamic body of one shape, of density 1000 kg/m^3. */
    public Body body(long shape, Vec3 position) {
        try (Arena local = Arena.ofConfined()) {
            return body(new Raw.BodyDesc(local).position(position.x(), position.y(), position.z()), new Raw.ColliderDesc(local).shape(shape));
        }
    }

    /** A body of any number of shapes. */
    public Body body(Raw.BodyDesc desc, Raw.ColliderDesc... parts) {
        var out = Library.Scratch.get().out;
        call((w, e) -> Raw.carom_body_create(w, desc.segment, out, e));
        Body body = new Body(this, out.get(JAVA_LONG, 0));
        try {
            for (var part : parts) collider(body.handle(), part);
            return body;
        } catch (CaromException refused) {
            body.destroy();
            throw refused;
        }
    }

    /** A static half-space below height, m. */
    public Body ground(double height) {
        try (Arena local = Arena.ofConfined()) {
            var part = new Raw.ColliderDesc(local).shape(engine.shape("half_space", 0, 1, 0, height));
            return body(new Raw.BodyDesc(local).type(Raw.CAROM_BODY_STATIC), part);
        }
    }

    /** One field (Raw.CAROM_FIELD_*) of some bodies, or, where these are null, of all in the order of bodies(). */
    public void read(int field, long[] bodies, double[] dst) {
        long n = dst.length / width(field, bodies, dst.length);
        MemorySegment memory = Library.Scratch.get().buffer(8L * dst.length);
        read(field, bodies, memory, n, 0);
        MemorySegment.copy(memory, JAVA_DOUBLE, 0, dst, 0, dst.length);
    }

    /** As doubles into memory outside Java's heap, without a copy: n records, stride bytes apart, 0: tightly. */
    public void read(int field, long[] bodies, MemorySegment dst, long n, long stride) {
        if (dst.byteSize() < n * Math.max(stride, 8L * width(field, null, 0))) throw unfit(n + " records do not fit into " + dst.byteSize() + " bytes");
        try (Arena local = Arena.ofConfined()) {
            MemorySegment handles = Library.in(local, bodies);
            call((w, e) -> Raw.carom_world_read(w, field, Raw.CAROM_SCALAR_F64, handles, n, dst, stride, e));
        }
    }

    public void write(int field, long[] bodies, double[] src) {
        long n = src.length / width(field, bodies, src.length);
        try (Arena local = Arena.ofConfined()) {
            MemorySegment handles = Library.in(local, bodies), numbers = Library.in(local, src);
            call((w, e) -> Raw.carom_world_write(w, field, Raw.CAROM_SCALAR_F64, handles, n, numbers, 0, e));
        }
    }

    /** x, y, z of all bodies, in the order of bodies(). */
    public void positions(double[] dst) { read(Raw.CAROM_FIELD_POSITION, null, dst); }

    /** x, y, z and the quaternion's x, y, z, w of all bodies. */
    public void poses(double[] dst) { read(Raw.CAROM_FIELD_POSE, null, dst); }

    /** A copy that goes on bit for bit as this world does. Close it, too. */
    public World fork() {
        var out = Library.Scratch.get().out;
        call((w, e) -> Raw.carom_world_fork(w, out, e));
        return new World(engine, out.get(ADDRESS, 0));
    }

    private static final int[] WIDTH = {3, 4, 7, 3, 3, 6, 6, 3, 1}; // numbers a body, by field: carom/body_bulk.h

    private static int width(int field, long[] bodies, int numbers) {
        if (field < 0 || field >= WIDTH.length) throw unfit("there is no field " + field);
        int width = WIDTH[field];
        if (numbers % width != 0 || bodies != null && numbers / width != bodies.length)
            throw unfit(numbers + " numbers, " + width + " a body" + (bodies == null ? "" : ", for " + bodies.length + " bodies"));
        return width;
    }

    private static CaromException unfit(String what) {
        return new CaromException(Raw.CAROM_E_OUT_OF_RANGE, what, "pass as many numbers as the field has for as many bodies");
    }
}

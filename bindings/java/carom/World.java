package carom;

import static java.lang.foreign.ValueLayout.*;

import java.lang.foreign.*;

/** Bodies and what acts on them. Any number of threads may read it; beside one that changes it others get CAROM_E_BUSY. */
public final class World extends WorldCalls {
    private final Engine engine;

    World(Engine engine, MemorySegment pointer) {
        super(pointer);
        this.engine = engine;
    }

    public Engine engine() { return engine; }

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

    /** read(), but into memory outside Java's heap, without a copy: n records, stride bytes apart, 0: tightly. */
    public void read(int field, long[] bodies, MemorySegment dst, long n, long stride) {
        if (dst.byteSize() < n * Math.max(stride, 8L * width(field, null, 0))) throw unfit(n + " records do not fit into " + dst.byteSize() + " bytes");
        try (Arena local = Arena.ofConfined()) {
            MemorySegment handles = Raw.in(local, bodies);
            call((w, e) -> Raw.carom_world_read(w, field, Raw.CAROM_SCALAR_F64, handles, n, dst, stride, e));
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
}

package carom;

import static java.lang.foreign.ValueLayout.JAVA_DOUBLE;

import java.lang.foreign.MemorySegment;

/** A body of a world, by its handle, which the library validates in every call; forgetting one destroys nothing. */
public record Body(World world, long handle) {
    /** A call of Raw that takes a world and a body, then what it takes besides, then the error. */
    @FunctionalInterface
    public interface Call {
        int of(MemorySegment world, long body, MemorySegment error);
    }

    /** Any call of Raw on this body: body.call((w, b, e) -> Raw.carom_body_set_drag(w, b, 0.1, 0.02, e)). */
    public void call(Call call) {
        var scratch = Library.Scratch.get();
        scratch.check(call.of(world.pointer(), handle, scratch.error.segment));
    }

    public Vec3 position() {
        var scratch = Library.Scratch.get();
        scratch.check(Raw.carom_body_get_pose(world.pointer(), handle, scratch.out, MemorySegment.NULL, scratch.error.segment));
        return vec3(scratch.out);
    }

    public Pose pose() {
        var scratch = Library.Scratch.get();
        MemorySegment out = scratch.out, turn = out.asSlice(24);
        scratch.check(Raw.carom_body_get_pose(world.pointer(), handle, out, turn, scratch.error.segment));
        return new Pose(vec3(out), new Quat(turn.get(JAVA_DOUBLE, 0), turn.get(JAVA_DOUBLE, 8), turn.get(JAVA_DOUBLE, 16), turn.get(JAVA_DOUBLE, 24)));
    }

    /** m/s, of the centre of mass */
    public Vec3 linearVelocity() {
        var scratch = Library.Scratch.get();
        scratch.check(Raw.carom_body_get_velocity(world.pointer(), handle, scratch.out, MemorySegment.NULL, scratch.error.segment));
        return vec3(scratch.out);
    }

    public void setPose(Pose pose) {
        MemorySegment in = put(pose.position(), 0), turn = in.asSlice(24);
        Quat q = pose.orientation();
        MemorySegment.copy(new double[] {q.x(), q.y(), q.z(), q.w()}, 0, turn, JAVA_DOUBLE, 0, 4);
        call((w, b, e) -> Raw.carom_body_set_pose(w, b, in, turn, e));
    }

    /** @param linear m/s, of the centre of mass  @param angular rad/s */
    public void setVelocity(Vec3 linear, Vec3 angular) {
        MemorySegment in = put(linear, 0), turn = put(angular, 24).asSlice(24);
        call((w, b, e) -> Raw.carom_body_set_velocity(w, b, in, turn, e));
    }

    /** For the next step. @param force N  @param torque N m */
    public void addForce(Vec3 force, Vec3 torque) {
        MemorySegment in = put(force, 0), turn = put(torque, 24).asSlice(24);
        call((w, b, e) -> Raw.carom_body_add_force(w, b, in, turn, e));
    }

    public void destroy() { call(Raw::carom_body_destroy); }

    private static Vec3 vec3(MemorySegment at) { return new Vec3(at.get(JAVA_DOUBLE, 0), at.get(JAVA_DOUBLE, 8), at.get(JAVA_DOUBLE, 16)); }

    private static MemorySegment put(Vec3 v, long at) {
        MemorySegment out = Library.Scratch.get().out;
        out.set(JAVA_DOUBLE, at, v.x());
        out.set(JAVA_DOUBLE, at + 8, v.y());
        out.set(JAVA_DOUBLE, at + 16, v.z());
        return out;
    }
}

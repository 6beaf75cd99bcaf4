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
        return new Vec3(scratch.out.get(JAVA_DOUBLE, 0), scratch.out.get(JAVA_DOUBLE, 8), scratch.out.get(JAVA_DOUBLE, 16));
    }

    public Pose pose() { return world.pose(handle); }

    /** m/s, of the centre of mass */
    public Vec3 linearVelocity() { return world.velocity(handle).linear(); }

    public void setPose(Pose pose) { world.setPose(handle, pose.position(), pose.orientation()); }

    /** @param linear m/s, of the centre of mass  @param angular rad/s */
    public void setVelocity(Vec3 linear, Vec3 angular) { world.setVelocity(handle, linear, angular); }

    /** For the next step. @param force N  @param torque N m */
    public void addForce(Vec3 force, Vec3 torque) { world.addForce(handle, force, torque); }

    public void destroy() { world.destroy(handle); }
}

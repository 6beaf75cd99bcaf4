// Written by bindings/gen/generate from include/carom; do not edit.
package carom;

import static java.lang.foreign.ValueLayout.*;

import java.lang.foreign.*;

/** Calls on a world that need no pointer of the caller's. A handle is a long. */
public abstract sealed class WorldCalls implements AutoCloseable permits World {
    private MemorySegment pointer;

    WorldCalls(MemorySegment pointer) { this.pointer = pointer; }

    /** What calls of Raw take; NULL once it is closed, which they refuse. */
    public MemorySegment pointer() { return pointer; }

    /** Any call of Raw on this world: world.call((p, e) -> Raw.carom_world_cast_rays(p, rays, want, desc, hits, e)). */
    public void call(EngineCalls.Call call) {
        var scratch = Library.Scratch.get();
        scratch.check(call.of(pointer, scratch.error.segment));
    }

    /** Give back all memory; closing twice does nothing. */
    @Override
    public void close() {
        if (pointer.equals(MemorySegment.NULL)) return;
        call(Raw::carom_world_destroy);
        pointer = MemorySegment.NULL;
    }

    /** Set an error tolerance from the next step on.
     *  param: accuracy NULL: none, as a world is created
     *  status: OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
     *  0);
     *          BUSY; REENTRANT */
    public void setAccuracy(Raw.Accuracy accuracy) {
        call((p, e) -> Raw.carom_world_set_accuracy(p, accuracy == null ? MemorySegment.NULL : accuracy.segment, e));
    }

    public record Accuracy(Raw.Accuracy accuracy, int present) {}

    /** param: accuracy out   param: present out: 1 or 0; if 0, accuracy is filled with defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public Accuracy accuracy() {
        try (Arena local = Arena.ofConfined()) {
            var accuracy_out = new Raw.Accuracy(Arena.ofAuto());
            var present_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_world_get_accuracy(p, accuracy_out.segment, present_out, e));
            return new Accuracy(accuracy_out, present_out.get(JAVA_INT, 0));
        }
    }

    /** Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
     *  Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_island) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public Raw.Island[] islands() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.Island.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_islands(p, dst, Raw.Island.SIZE, capacity, count, e));
        var each = new Raw.Island[(int) (all.byteSize() / Raw.Island.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.Island(all.asSlice((long) i * Raw.Island.SIZE, Raw.Island.SIZE));
        return each;
    }

    /** Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
     *  little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
     *  Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
     *  until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
     *  param: dt      s, of a step: as for carom_world_step()
     *  param: steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
     *  param: growth  out, its struct_size set
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
     *  thread: reader */
    public Raw.Growth measureGrowth(double dt, int steps) {
        var growth_out = new Raw.Growth(Arena.ofAuto());
        call((p, e) -> Raw.carom_world_measure_growth(p, dt, steps, growth_out.segment, e));
        return growth_out;
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY */
    public long material(Raw.MaterialDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var material_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_material_create(p, desc.segment, material_out, e));
            return material_out.get(JAVA_LONG, 0);
        }
    }

    /** Change a material in place; every collider that uses it follows.   status: as carom_material_create(); *_HANDLE */
    public void materialUpdate(long material, Raw.MaterialDesc desc) {
        call((p, e) -> Raw.carom_material_update(p, material, desc.segment, e));
    }

    /** Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
     *  with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
     *  friction is; carom_material_update() leaves it alone.
     *  param: rolling, spinning m, [0, 1e3]
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY */
    public void materialSetResistance(long material, double rolling, double spinning) {
        call((p, e) -> Raw.carom_material_set_resistance(p, material, rolling, spinning, e));
    }

    public record MaterialResistance(double rolling, double spinning) {}

    /** param: rolling, spinning out: m   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public MaterialResistance materialResistance(long material) {
        try (Arena local = Arena.ofConfined()) {
            var rolling_out = local.allocate(8, 8);
            var spinning_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_material_get_resistance(p, material, rolling_out, spinning_out, e));
            return new MaterialResistance(rolling_out.get(JAVA_DOUBLE, 0), spinning_out.get(JAVA_DOUBLE, 0));
        }
    }

    /** Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
     *  param: material_a, material_b  in any order; the same twice: colliders of that material among themselves
     *  param: surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
     *                 NULL: they mix again
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   since: 0.9 */
    public void materialSetPair(long materialA, long materialB, double[] surface) {
        try (Arena local = Arena.ofConfined()) {
            var surface_in = Raw.in(local, surface);
            call((p, e) -> Raw.carom_material_set_pair(p, materialA, materialB, surface_in, e));
        }
    }

    /** What two materials are to each other: what was said of them, or else what they mix to.
     *  param: surface out, [4]: as carom_material_set_pair() takes it
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY   since: 0.9 */
    public double[] materialPair(long materialA, long materialB) {
        try (Arena local = Arena.ofConfined()) {
            var surface_out = local.allocate(32, 8);
            call((p, e) -> Raw.carom_material_get_pair(p, materialA, materialB, surface_out, e));
            return surface_out.toArray(JAVA_DOUBLE);
        }
    }

    /** status: OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY */
    public void materialDestroy(long material) {
        call((p, e) -> Raw.carom_material_destroy(p, material, e));
    }

    /** Destroys its colliders too.   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void destroy(long body) {
        call((p, e) -> Raw.carom_body_destroy(p, body, e));
    }

    /** Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
     *  body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public Raw.BodyDesc bodyDesc(long body) {
        var desc_out = new Raw.BodyDesc(Arena.ofAuto());
        call((p, e) -> Raw.carom_body_get(p, body, desc_out.segment, e));
        return desc_out;
    }

    /** param: position [3] m   param: orientation [4] x, y, z, w   status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
     *  NOT_UNIT; BUSY; REENTRANT */
    public void setPose(long body, Vec3 position, Quat orientation) {
        try (Arena local = Arena.ofConfined()) {
            var position_in = Raw.in(local, position);
            var orientation_in = Raw.in(local, orientation);
            call((p, e) -> Raw.carom_body_set_pose(p, body, position_in, orientation_in, e));
        }
    }

    /** param: linear [3] m/s of the centre of mass   param: angular [3] rad/s, both world frame
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT */
    public void setVelocity(long body, Vec3 linear, Vec3 angular) {
        try (Arena local = Arena.ofConfined()) {
            var linear_in = Raw.in(local, linear);
            var angular_in = Raw.in(local, angular);
            call((p, e) -> Raw.carom_body_set_velocity(p, body, linear_in, angular_in, e));
        }
    }

    /** param: position [3] out, or NULL: m, world, origin of the body frame   param: orientation [4] out, or NULL: x, y, z,
     *  w, body to world   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public Pose pose(long body) {
        try (Arena local = Arena.ofConfined()) {
            var position_out = local.allocate(24, 8);
            var orientation_out = local.allocate(32, 8);
            call((p, e) -> Raw.carom_body_get_pose(p, body, position_out, orientation_out, e));
            return new Pose(Vec3.of(position_out.toArray(JAVA_DOUBLE)), Quat.of(orientation_out.toArray(JAVA_DOUBLE)));
        }
    }

    public record Velocity(Vec3 linear, Vec3 angular) {}

    /** param: linear [3] out, or NULL: m/s, world, of the centre of mass   param: angular [3] out, or NULL: rad/s, world
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public Velocity velocity(long body) {
        try (Arena local = Arena.ofConfined()) {
            var linear_out = local.allocate(24, 8);
            var angular_out = local.allocate(24, 8);
            call((p, e) -> Raw.carom_body_get_velocity(p, body, linear_out, angular_out, e));
            return new Velocity(Vec3.of(linear_out.toArray(JAVA_DOUBLE)), Vec3.of(angular_out.toArray(JAVA_DOUBLE)));
        }
    }

    /** Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
     *  as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
     *  param: mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
     *  param: center [3] m, body frame, or NULL: from its colliders
     *  param: inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
     *  or NULL:
     *                 from its colliders, scaled to the mass
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
     *          and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setMass(long body, double mass, Vec3 center, double[] inertia) {
        try (Arena local = Arena.ofConfined()) {
            var center_in = Raw.in(local, center);
            var inertia_in = Raw.in(local, inertia);
            call((p, e) -> Raw.carom_body_set_mass(p, body, mass, center_in, inertia_in, e));
        }
    }

    public record Mass(double mass, Vec3 center, double[] inertia) {}

    /** As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
     *  param: mass out, or NULL: kg   param: center [3] out, or NULL: m, body frame   param: inertia [9] out, or NULL: kg
     *  m^2, body frame axes, about the centre, row-major   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public Mass mass(long body) {
        try (Arena local = Arena.ofConfined()) {
            var mass_out = local.allocate(8, 8);
            var center_out = local.allocate(24, 8);
            var inertia_out = local.allocate(72, 8);
            call((p, e) -> Raw.carom_body_get_mass(p, body, mass_out, center_out, inertia_out, e));
            return new Mass(mass_out.get(JAVA_DOUBLE, 0), Vec3.of(center_out.toArray(JAVA_DOUBLE)), inertia_out.toArray(JAVA_DOUBLE));
        }
    }

    /** Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
     *  no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
     *  (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
     *  param: type CAROM_BODY_*
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
     *          is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setType(long body, int type) {
        call((p, e) -> Raw.carom_body_set_type(p, body, type, e));
    }

    /** param: type out: CAROM_BODY_*   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int type(long body) {
        try (Arena local = Arena.ofConfined()) {
            var type_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_type(p, body, type_out, e));
            return type_out.get(JAVA_INT, 0);
        }
    }

    /** param: linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   status: OK; NULL_ARGUMENT; *_HANDLE;
     *  NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void setDamping(long body, double linear, double angular) {
        call((p, e) -> Raw.carom_body_set_damping(p, body, linear, angular, e));
    }

    public record Damping(double linear, double angular) {}

    /** param: linear, angular out: 1/s; either may be NULL   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public Damping damping(long body) {
        try (Arena local = Arena.ofConfined()) {
            var linear_out = local.allocate(8, 8);
            var angular_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_damping(p, body, linear_out, angular_out, e));
            return new Damping(linear_out.get(JAVA_DOUBLE, 0), angular_out.get(JAVA_DOUBLE, 0));
        }
    }

    /** param: user anything; the engine does not look   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void setUser(long body, long user) {
        call((p, e) -> Raw.carom_body_set_user(p, body, user, e));
    }

    /** param: user out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public long user(long body) {
        try (Arena local = Arena.ofConfined()) {
            var user_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_user(p, body, user_out, e));
            return user_out.get(JAVA_LONG, 0);
        }
    }

    /** Number of a body's colliders, and their handles in the order of the slots.
     *  param: colliders [capacity] or NULL   param: count out: how many there are (may exceed capacity; capacity are
     *  written)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public long[] colliders(long body) {
        try (Arena local = Arena.ofConfined()) {
            return Raw.list(this::call, local, 8, (p, dst, capacity, count, e) -> Raw.carom_body_get_colliders(p, body, dst, capacity, count, e)).toArray(JAVA_LONG);
        }
    }

    /** Add a force and a torque about the centre of mass, for the next step only.
     *  param: force [3] N, world   param: torque [3] N m, world
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
    public void addForce(long body, Vec3 force, Vec3 torque) {
        try (Arena local = Arena.ofConfined()) {
            var force_in = Raw.in(local, force);
            var torque_in = Raw.in(local, torque);
            call((p, e) -> Raw.carom_body_add_force(p, body, force_in, torque_in, e));
        }
    }

    /** Change velocities at once. param: impulse [3] N s, world   param: point [3] m, world: where it acts
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT */
    public void addImpulse(long body, Vec3 impulse, Vec3 point) {
        try (Arena local = Arena.ofConfined()) {
            var impulse_in = Raw.in(local, impulse);
            var point_in = Raw.in(local, point);
            call((p, e) -> Raw.carom_body_add_impulse(p, body, impulse_in, point_in, e));
        }
    }

    /** How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
     *  rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
     *  param: factor any finite number; 1 when a body is created
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setGravityFactor(long body, double factor) {
        call((p, e) -> Raw.carom_body_set_gravity_factor(p, body, factor, e));
    }

    /** param: factor out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public double gravityFactor(long body) {
        try (Arena local = Arena.ofConfined()) {
            var factor_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_gravity_factor(p, body, factor_out, e));
            return factor_out.get(JAVA_DOUBLE, 0);
        }
    }

    /** Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
     *  it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
     *  it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
     *  
     *  Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
     *  body refuses that dial.
     *  param: locks CAROM_LOCK_* bits, 0 when a body is created
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
     *          first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public void setLocks(long body, int locks) {
        call((p, e) -> Raw.carom_body_set_locks(p, body, locks, e));
    }

    /** param: locks out: CAROM_LOCK_* bits   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int locks(long body) {
        try (Arena local = Arena.ofConfined()) {
            var locks_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_locks(p, body, locks_out, e));
            return locks_out.get(JAVA_INT, 0);
        }
    }

    /** Set an attribute. Another value than it has wakes the body and its island.
     *  param: value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
     *  whole; a
     *          body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setAttribute(long body, int attribute, double[] value) {
        try (Arena local = Arena.ofConfined()) {
            var value_in = Raw.in(local, value);
            call((p, e) -> Raw.carom_body_set_attribute(p, body, attribute, value_in, e));
        }
    }

    /** param: value [4] out: numbers that the attribute does not have are 0
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY */
    public double[] attribute(long body, int attribute) {
        try (Arena local = Arena.ofConfined()) {
            var value_out = local.allocate(32, 8);
            call((p, e) -> Raw.carom_body_get_attribute(p, body, attribute, value_out, e));
            return value_out.toArray(JAVA_DOUBLE);
        }
    }

    /** param: asleep out: 1 or 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int isAsleep(long body) {
        try (Arena local = Arena.ofConfined()) {
            var asleep_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_is_asleep(p, body, asleep_out, e));
            return asleep_out.get(JAVA_INT, 0);
        }
    }

    /** Wake a body and its island; if it is awake, its time of rest starts anew.   status: OK; NULL_ARGUMENT; *_HANDLE;
     *  BUSY; REENTRANT */
    public void wake(long body) {
        call((p, e) -> Raw.carom_body_wake(p, body, e));
    }

    /** Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
     *  says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
     *  param: mode CAROM_CONTINUOUS_*
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT */
    public void setContinuous(long body, int mode) {
        call((p, e) -> Raw.carom_body_set_continuous(p, body, mode, e));
    }

    /** param: mode out: CAROM_CONTINUOUS_*   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int continuous(long body) {
        try (Arena local = Arena.ofConfined()) {
            var mode_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_continuous(p, body, mode_out, e));
            return mode_out.get(JAVA_INT, 0);
        }
    }

    /** Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
     *  moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
     *  it wake. It costs a step nothing. A host may still read and write it.
     *  param: enabled 1 or 0
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setEnabled(long body, int enabled) {
        call((p, e) -> Raw.carom_body_set_enabled(p, body, enabled, e));
    }

    /** param: enabled out: 1 or 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int isEnabled(long body) {
        try (Arena local = Arena.ofConfined()) {
            var enabled_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_is_enabled(p, body, enabled_out, e));
            return enabled_out.get(JAVA_INT, 0);
        }
    }

    /** Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
     *  centre.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
     *  half-space on a
     *          body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public long collider(long body, Raw.ColliderDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var collider_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_collider_create(p, body, desc.segment, collider_out, e));
            return collider_out.get(JAVA_LONG, 0);
        }
    }

    /** The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
     *  same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
     *  Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
     *  friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
     *  param: type CAROM_BODY_*   param: name as carom_shape_create_named()   param: position [3] m, world
     *  param: params [count] as carom_shape_create_named()   param: count number of params
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
     *          PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
    public long bodyNamed(int type, String name, double[] params, Vec3 position) {
        try (Arena local = Arena.ofConfined()) {
            var name_in = Raw.in(local, name);
            var params_in = Raw.in(local, params);
            var position_in = Raw.in(local, position);
            var body_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_create_named(p, type, name_in, params_in, params.length, position_in, body_out, e));
            return body_out.get(JAVA_LONG, 0);
        }
    }

    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void colliderDestroy(long collider) {
        call((p, e) -> Raw.carom_collider_destroy(p, collider, e));
    }

    public record ColliderDesc(Raw.ColliderDesc desc, long body) {}

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public ColliderDesc colliderDesc(long collider) {
        try (Arena local = Arena.ofConfined()) {
            var desc_out = new Raw.ColliderDesc(Arena.ofAuto());
            var body_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_collider_get(p, collider, desc_out.segment, body_out, e));
            return new ColliderDesc(desc_out, body_out.get(JAVA_LONG, 0));
        }
    }

    /** Give a collider another material. Wakes what its body touches.   param: material or CAROM_NULL_HANDLE: friction 0.5,
     *  restitution 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void colliderSetMaterial(long collider, long material) {
        call((p, e) -> Raw.carom_collider_set_material(p, collider, material, e));
    }

    /** The body's mass follows, unless it was given. Wakes the body and its island.   param: density kg/m^3, [0, 1e9]
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void colliderSetDensity(long collider, double density) {
        call((p, e) -> Raw.carom_collider_set_density(p, collider, density, e));
    }

    /** Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
     *  param: position [3] m, body frame: origin of the shape; each within 1e15   param: orientation [4] x, y, z, w, shape
     *  to body
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void colliderSetPose(long collider, Vec3 position, Quat orientation) {
        try (Arena local = Arena.ofConfined()) {
            var position_in = Raw.in(local, position);
            var orientation_in = Raw.in(local, orientation);
            call((p, e) -> Raw.carom_collider_set_pose(p, collider, position_in, orientation_in, e));
        }
    }

    /** Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
     *  what touches it to the velocity of the surface,
     *    v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
     *  with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
     *  belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
     *  moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
     *  does not fall asleep.
     *  param: linear  [3] m/s, axes of the shape; 0 when a collider is created
     *  param: angular [3] rad/s, axes of the shape, about its origin
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public void colliderSetSurfaceVelocity(long collider, Vec3 linear, Vec3 angular) {
        try (Arena local = Arena.ofConfined()) {
            var linear_in = Raw.in(local, linear);
            var angular_in = Raw.in(local, angular);
            call((p, e) -> Raw.carom_collider_set_surface_velocity(p, collider, linear_in, angular_in, e));
        }
    }

    public record ColliderSurfaceVelocity(Vec3 linear, Vec3 angular) {}

    /** param: linear, angular out: [3], as they were set   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public ColliderSurfaceVelocity colliderSurfaceVelocity(long collider) {
        try (Arena local = Arena.ofConfined()) {
            var linear_out = local.allocate(24, 8);
            var angular_out = local.allocate(24, 8);
            call((p, e) -> Raw.carom_collider_get_surface_velocity(p, collider, linear_out, angular_out, e));
            return new ColliderSurfaceVelocity(Vec3.of(linear_out.toArray(JAVA_DOUBLE)), Vec3.of(angular_out.toArray(JAVA_DOUBLE)));
        }
    }

    /** Number of bodies, and their handles in creation order of the slots.
     *  param: handles [capacity] or NULL   param: count out: how many there are
     *  status: OK; NULL_ARGUMENT; BUSY */
    public long[] bodies() {
        try (Arena local = Arena.ofConfined()) {
            return Raw.list(this::call, local, 8, (p, dst, capacity, count, e) -> Raw.carom_world_get_bodies(p, dst, capacity, count, e)).toArray(JAVA_LONG);
        }
    }

    /** Read one field of n bodies.
     *  param: handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
     *  param: dst     n records of the field's scalars, `stride` bytes apart
     *  param: stride  bytes from one record to the next; 0: tightly packed
     *  param: field   CAROM_FIELD_*
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
     *  BUSY */
    public void read(int field, long[] bodies, double[] dst) {
        long n = dst.length / width(field, bodies, dst.length);
        MemorySegment memory = Library.Scratch.get().buffer(8L * dst.length);
        try (Arena local = Arena.ofConfined()) {
            MemorySegment handles = Raw.in(local, bodies);
            call((p, e) -> Raw.carom_world_read(p, field, Raw.CAROM_SCALAR_F64, handles, n, memory, 0, e));
        }
        MemorySegment.copy(memory, JAVA_DOUBLE, 0, dst, 0, dst.length);
    }

    /** Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
     *  param: src n records of the field's scalars, `stride` bytes apart
     *  status: as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT */
    public void write(int field, long[] bodies, double[] src) {
        long n = src.length / width(field, bodies, src.length);
        MemorySegment memory = Library.Scratch.get().buffer(8L * src.length);
        MemorySegment.copy(src, 0, memory, JAVA_DOUBLE, 0, src.length);
        try (Arena local = Arena.ofConfined()) {
            MemorySegment handles = Raw.in(local, bodies);
            call((p, e) -> Raw.carom_world_write(p, field, Raw.CAROM_SCALAR_F64, handles, n, memory, 0, e));
        }
    }

    /** Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
     *  jumps or falls.
     *  
     *  On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
     *  follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
     *  does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
     *  allocates nothing but what queries do.
     *  param: desc may be NULL: defaults
     *  param: character all but shape, foot, head and reach may change
     *  param: walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
     *         counts only with CAROM_CHARACTER_FLIES
     *  param: jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
     *         ground with it; else, and with 0, it does not
     *  param: dt s, [0, 1]
     *  accuracy: stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc-&gt;body;
     *          character-&gt;shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
     *          REENTRANT; OUT_OF_MEMORY
     *  thread: reader */
    public void characterMove(Raw.CharacterDesc desc, Raw.Character character, Vec3 walk, double jump, double dt) {
        try (Arena local = Arena.ofConfined()) {
            var walk_in = Raw.in(local, walk);
            call((p, e) -> Raw.carom_character_move(p, desc == null ? MemorySegment.NULL : desc.segment, character.segment, walk_in, jump, dt, e));
        }
    }

    /** Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
     *  in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
     *  firm feet gets mass * gravity. Bodies that are gone are left out.
     *  param: desc may be NULL: defaults   param: character as the last move left it   param: dt s, [1e-9, 1], of the next
     *  step
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
     *          BUSY; REENTRANT; OUT_OF_MEMORY */
    public void characterPush(Raw.CharacterDesc desc, Raw.Character character, double dt) {
        call((p, e) -> Raw.carom_character_push(p, desc == null ? MemorySegment.NULL : desc.segment, character.segment, dt, e));
    }

    /** Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
     *  velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
     *  character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
     *  desc-&gt;body.
     *  param: desc with a body   param: dt s, [1e-9, 1], of the next step
     *  param: character as the last move left it
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
     *          (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void characterMoveBody(Raw.CharacterDesc desc, Raw.Character character, double dt) {
        call((p, e) -> Raw.carom_character_move_body(p, desc.segment, character.segment, dt, e));
    }

    /** All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
     *  are left out, and so are bodies in quarantine. The same world gives the same lines.
     *  param: desc     NULL: defaults
     *  param: dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
     *  param: count    out: lines there are; more than capacity: the first `capacity` of them were written
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
     *          OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
     *  thread: reader */
    public Raw.DrawLine[] draw(Raw.DrawDesc desc) {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.DrawLine.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_draw(p, desc == null ? MemorySegment.NULL : desc.segment, dst, Raw.DrawLine.SIZE, capacity, count, e));
        var each = new Raw.DrawLine[(int) (all.byteSize() / Raw.DrawLine.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.DrawLine(all.asSlice((long) i * Raw.DrawLine.SIZE, Raw.DrawLine.SIZE));
        return each;
    }

    /** Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
     *  that step.
     *  param: kinds     CAROM_EVENTS_* bits; 0: nothing
     *  param: hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void collectEvents(int kinds, double hitSpeed) {
        call((p, e) -> Raw.carom_world_collect_events(p, kinds, hitSpeed, e));
    }

    /** Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_contact_event) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public Raw.ContactEvent[] contactEvents() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.ContactEvent.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_contact_events(p, dst, Raw.ContactEvent.SIZE, capacity, count, e));
        var each = new Raw.ContactEvent[(int) (all.byteSize() / Raw.ContactEvent.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.ContactEvent(all.asSlice((long) i * Raw.ContactEvent.SIZE, Raw.ContactEvent.SIZE));
        return each;
    }

    /** Arguments as carom_world_get_contact_events(). */
    public Raw.SensorEvent[] sensorEvents() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.SensorEvent.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_sensor_events(p, dst, Raw.SensorEvent.SIZE, capacity, count, e));
        var each = new Raw.SensorEvent[(int) (all.byteSize() / Raw.SensorEvent.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.SensorEvent(all.asSlice((long) i * Raw.SensorEvent.SIZE, Raw.SensorEvent.SIZE));
        return each;
    }

    /** By the slots of the bodies; arguments as carom_world_get_contact_events(). */
    public Raw.SleepEvent[] sleepEvents() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.SleepEvent.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_sleep_events(p, dst, Raw.SleepEvent.SIZE, capacity, count, e));
        var each = new Raw.SleepEvent[(int) (all.byteSize() / Raw.SleepEvent.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.SleepEvent(all.asSlice((long) i * Raw.SleepEvent.SIZE, Raw.SleepEvent.SIZE));
        return each;
    }

    /** By the slots of the joints; arguments as carom_world_get_contact_events(). */
    public Raw.JointEvent[] jointEvents() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.JointEvent.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_joint_events(p, dst, Raw.JointEvent.SIZE, capacity, count, e));
        var each = new Raw.JointEvent[(int) (all.byteSize() / Raw.JointEvent.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.JointEvent(all.asSlice((long) i * Raw.JointEvent.SIZE, Raw.JointEvent.SIZE));
        return each;
    }

    /** As they happened; arguments as carom_world_get_contact_events(). */
    public Raw.FaultEvent[] faultEvents() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.FaultEvent.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_fault_events(p, dst, Raw.FaultEvent.SIZE, capacity, count, e));
        var each = new Raw.FaultEvent[(int) (all.byteSize() / Raw.FaultEvent.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.FaultEvent(all.asSlice((long) i * Raw.FaultEvent.SIZE, Raw.FaultEvent.SIZE));
        return each;
    }

    /** Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
     *  group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
     *  param: category, mask  any bits   param: group 0: none
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void colliderSetFilter(long collider, long category, long mask, int group) {
        call((p, e) -> Raw.carom_collider_set_filter(p, collider, category, mask, group, e));
    }

    public record ColliderFilter(long category, long mask, int group) {}

    /** param: category, mask, group  out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public ColliderFilter colliderFilter(long collider) {
        try (Arena local = Arena.ofConfined()) {
            var category_out = local.allocate(8, 8);
            var mask_out = local.allocate(8, 8);
            var group_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_collider_get_filter(p, collider, category_out, mask_out, group_out, e));
            return new ColliderFilter(category_out.get(JAVA_LONG, 0), mask_out.get(JAVA_LONG, 0), group_out.get(JAVA_INT, 0));
        }
    }

    /** The same for all colliders that a body has now.   status: as carom_collider_set_filter() */
    public void setFilter(long body, long category, long mask, int group) {
        call((p, e) -> Raw.carom_body_set_filter(p, body, category, mask, group, e));
    }

    /** Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
     *  counted: undo each one. Undoing more does nothing.
     *  param: ignored 1 or 0
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void ignoreCollision(long bodyA, long bodyB, int ignored) {
        call((p, e) -> Raw.carom_body_ignore_collision(p, bodyA, bodyB, ignored, e));
    }

    /** Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
     *  It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
     *  as before.
     *  param: sensor 1 or 0
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void colliderSetSensor(long collider, int sensor) {
        call((p, e) -> Raw.carom_collider_set_sensor(p, collider, sensor, e));
    }

    /** param: sensor out: 1 or 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int colliderIsSensor(long collider) {
        try (Arena local = Arena.ofConfined()) {
            var sensor_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_collider_is_sensor(p, collider, sensor_out, e));
            return sensor_out.get(JAVA_INT, 0);
        }
    }

    /** Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
     *  mass as the body stands now.
     *  param: force [3] N, world   param: point [3] m, world
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
    public void addForceAt(long body, Vec3 force, Vec3 point) {
        try (Arena local = Arena.ofConfined()) {
            var force_in = Raw.in(local, force);
            var point_in = Raw.in(local, point);
            call((p, e) -> Raw.carom_body_add_force_at(p, body, force_in, point_in, e));
        }
    }

    /** How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
     *  other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
     *  not to the air, and to mass.)
     *  param: linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
     *  param: quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setDrag(long body, double linear, double quadratic) {
        call((p, e) -> Raw.carom_body_set_drag(p, body, linear, quadratic, e));
    }

    public record Drag(double linear, double quadratic) {}

    /** param: linear, quadratic out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public Drag drag(long body) {
        try (Arena local = Arena.ofConfined()) {
            var linear_out = local.allocate(8, 8);
            var quadratic_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_drag(p, body, linear_out, quadratic_out, e));
            return new Drag(linear_out.get(JAVA_DOUBLE, 0), quadratic_out.get(JAVA_DOUBLE, 0));
        }
    }

    /** How the air moves; it reaches bodies through their drag alone.
     *  param: velocity [3] m/s, |each| &lt;= 1e6; 0 when a world is created
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void setWind(Vec3 velocity) {
        try (Arena local = Arena.ofConfined()) {
            var velocity_in = Raw.in(local, velocity);
            call((p, e) -> Raw.carom_world_set_wind(p, velocity_in, e));
        }
    }

    /** status: OK; NULL_ARGUMENT; BUSY */
    public Vec3 wind() {
        try (Arena local = Arena.ofConfined()) {
            var velocity_out = local.allocate(24, 8);
            call((p, e) -> Raw.carom_world_get_wind(p, velocity_out, e));
            return Vec3.of(velocity_out.toArray(JAVA_DOUBLE));
        }
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
     *          REENTRANT; LIMIT; OUT_OF_MEMORY */
    public long forceField(Raw.ForceFieldDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var field_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_force_field_create(p, desc.segment, field_out, e));
            return field_out.get(JAVA_LONG, 0);
        }
    }

    /** Change a field in place: move it, turn it up.   status: as carom_force_field_create(); *_HANDLE */
    public void forceFieldUpdate(long field, Raw.ForceFieldDesc desc) {
        call((p, e) -> Raw.carom_force_field_update(p, field, desc.segment, e));
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public Raw.ForceFieldDesc forceFieldDesc(long field) {
        var desc_out = new Raw.ForceFieldDesc(Arena.ofAuto());
        call((p, e) -> Raw.carom_force_field_get(p, field, desc_out.segment, e));
        return desc_out;
    }

    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void forceFieldDestroy(long field) {
        call((p, e) -> Raw.carom_force_field_destroy(p, field, e));
    }

    /** Which fields a body feels. A field with a bit that few bodies have costs those few.
     *  param: mask 1 when a body is created; 0: none
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setForceFieldMask(long body, int mask) {
        call((p, e) -> Raw.carom_body_set_force_field_mask(p, body, mask, e));
    }

    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int forceFieldMask(long body) {
        try (Arena local = Arena.ofConfined()) {
            var mask_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_force_field_mask(p, body, mask_out, e));
            return mask_out.get(JAVA_INT, 0);
        }
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
     *          OUT_OF_MEMORY */
    public long spring(Raw.SpringDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var spring_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_spring_create(p, desc.segment, spring_out, e));
            return spring_out.get(JAVA_LONG, 0);
        }
    }

    /** Change what a spring is like; its ends stay.
     *  param: rest m   param: stiffness N/m   param: damping N s/m; ranges as in carom_spring_desc
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void springUpdate(long spring, double rest, double stiffness, double damping) {
        call((p, e) -> Raw.carom_spring_update(p, spring, rest, stiffness, damping, e));
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public Raw.SpringDesc springDesc(long spring) {
        var desc_out = new Raw.SpringDesc(Arena.ofAuto());
        call((p, e) -> Raw.carom_spring_get(p, spring, desc_out.segment, e));
        return desc_out;
    }

    public record SpringState(double length, double force) {}

    /** param: length out: m, as its ends stand   param: force out: N, above 0 it pulls them together, as it is set
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public SpringState springState(long spring) {
        try (Arena local = Arena.ofConfined()) {
            var length_out = local.allocate(8, 8);
            var force_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_spring_get_state(p, spring, length_out, force_out, e));
            return new SpringState(length_out.get(JAVA_DOUBLE, 0), force_out.get(JAVA_DOUBLE, 0));
        }
    }

    /** Goes with its bodies, too.   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void springDestroy(long spring) {
        call((p, e) -> Raw.carom_spring_destroy(p, spring, e));
    }

    /** param: water NULL: none, as a world is created
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
    public void setWater(Raw.Water water) {
        call((p, e) -> Raw.carom_world_set_water(p, water == null ? MemorySegment.NULL : water.segment, e));
    }

    public record Water(Raw.Water water, int present) {}

    /** param: water out   param: present out: 1 or 0; if 0, water is filled with defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public Water water() {
        try (Arena local = Arena.ofConfined()) {
            var water_out = new Raw.Water(Arena.ofAuto());
            var present_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_world_get_water(p, water_out.segment, present_out, e));
            return new Water(water_out, present_out.get(JAVA_INT, 0));
        }
    }

    /** Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
     *          carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
     *          NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
     *          body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
     *          LIMIT; OUT_OF_MEMORY */
    public long joint(Raw.JointDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var joint_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_joint_create(p, desc.segment, joint_out, e));
            return joint_out.get(JAVA_LONG, 0);
        }
    }

    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void jointDestroy(long joint) {
        call((p, e) -> Raw.carom_joint_destroy(p, joint, e));
    }

    /** param: desc out: as it was made, with frames in body coordinates
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public Raw.JointDesc jointDesc(long joint) {
        var desc_out = new Raw.JointDesc(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get(p, joint, desc_out.segment, e));
        return desc_out;
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public Raw.JointState jointState(long joint) {
        var state_out = new Raw.JointState(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_state(p, joint, state_out.segment, e));
        return state_out;
    }

    /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
     *  param: coordinate CAROM_COORDINATE_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
     *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void jointSetLimit(long joint, int coordinate, Raw.JointLimit limit) {
        call((p, e) -> Raw.carom_joint_set_limit(p, joint, coordinate, limit.segment, e));
    }

    /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
     *  param: coordinate CAROM_COORDINATE_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
     *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void jointSetMotor(long joint, int coordinate, Raw.JointMotor motor) {
        call((p, e) -> Raw.carom_joint_set_motor(p, joint, coordinate, motor.segment, e));
    }

    /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
     *  param: coordinate CAROM_COORDINATE_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
     *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void jointSetSpring(long joint, int coordinate, Raw.JointSpring spring) {
        call((p, e) -> Raw.carom_joint_set_spring(p, joint, coordinate, spring.segment, e));
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointLimit jointLimit(long joint, int coordinate) {
        var limit_out = new Raw.JointLimit(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_limit(p, joint, coordinate, limit_out.segment, e));
        return limit_out;
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointMotor jointMotor(long joint, int coordinate) {
        var motor_out = new Raw.JointMotor(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_motor(p, joint, coordinate, motor_out.segment, e));
        return motor_out;
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointSpring jointSpring(long joint, int coordinate) {
        var spring_out = new Raw.JointSpring(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_spring(p, joint, coordinate, spring_out.segment, e));
        return spring_out;
    }

    /** Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
     *  pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
     *  may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
     *  one; a pose that the host sets between steps is no turn.
     *  Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
     *  under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
     *  tests/oracle/test_pulley_gear.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
     *          NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT */
    public void jointSetTransmission(long joint, Raw.JointTransmission transmission) {
        call((p, e) -> Raw.carom_joint_set_transmission(p, joint, transmission.segment, e));
    }

    /** param: transmission out: as it was set, with its length; ratio 0: not yet
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointTransmission jointTransmission(long joint) {
        var transmission_out = new Raw.JointTransmission(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_transmission(p, joint, transmission_out.segment, e));
        return transmission_out;
    }

    /** Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
     *  wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
     *  as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
     *  carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
     *  follower's coordinate that it pushes with, mean over the last step.
     *  Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
     *  joint_order moves it. Oracle: tests/oracle/test_couplings.
     *  param: joint out: the coupling
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
     *          reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
     *          REENTRANT; LIMIT; OUT_OF_MEMORY */
    public long jointCouple(Raw.JointCoupling coupling) {
        try (Arena local = Arena.ofConfined()) {
            var joint_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_joint_couple(p, coupling.segment, joint_out, e));
            return joint_out.get(JAVA_LONG, 0);
        }
    }

    /** Give a coupling another polynomial; its bodies wake.
     *  param: coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
     *          field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void jointSetCoupling(long joint, Raw.JointCoupling coupling) {
        call((p, e) -> Raw.carom_joint_set_coupling(p, joint, coupling.segment, e));
    }

    /** param: coupling out: as it was made
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointCoupling jointCoupling(long joint) {
        var coupling_out = new Raw.JointCoupling(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_coupling(p, joint, coupling_out.segment, e));
        return coupling_out;
    }

    /** Say what one axis of a six-axis joint, a hinge or a slider does; the bodies wake. Effect joint_limits has its limits, joint_motors its
     *  drives; springs and locks are of the joint. A target, a lock's place or a limit may be set anew before each step.
     *  Accuracy: what is locked errs in second order of the substep h, under the direct solver by 1e-9 m or rad. With w the
     *  frequency and b half the damping per mass: springs, stops and drives to a position swing late by w h / 2 of their
     *  amplitude and fade slower by b h of their rate; at rest they sag by load / stiffness, to rounding where one joint
     *  bears all, in first order where soft_step sweeps over several. A drive to a velocity holds that of the middle of a
     *  substep under the direct solver, and one with a damping alone does under any: what a step ends with differs by what
     *  the load does in h / 2. Forces of drives are met to rounding. A speed limit holds to 1e-9 under the
     *  direct solver, where one joint bears all to rounding under others. Oracle: tests/oracle/test_six_axis, test_six_axis_scenes, test_armature,
     *  test_axis_limits.
     *  param: axis CAROM_AXIS_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
     *          *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void jointSetAxis(long joint, int axis, Raw.JointAxis desc) {
        call((p, e) -> Raw.carom_joint_set_axis(p, joint, axis, desc.segment, e));
    }

    /** param: axis CAROM_AXIS_*   param: desc out: as it was set
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointAxis jointAxis(long joint, int axis) {
        var desc_out = new Raw.JointAxis(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_axis(p, joint, axis, desc_out.segment, e));
        return desc_out;
    }

    /** Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
     *  joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
     *  it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
     *          field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
    public void jointSetOrientationDrive(long joint, Raw.JointOrientationDrive drive) {
        call((p, e) -> Raw.carom_joint_set_orientation_drive(p, joint, drive.segment, e));
    }

    /** param: drive out: as it was set
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
    public Raw.JointOrientationDrive jointOrientationDrive(long joint) {
        var drive_out = new Raw.JointOrientationDrive(Arena.ofAuto());
        call((p, e) -> Raw.carom_joint_get_orientation_drive(p, joint, drive_out.segment, e));
        return drive_out;
    }

    /** Number of joints, and their handles in creation order of the slots.
     *  param: joints [capacity] or NULL   param: count out: how many there are
     *  status: OK; NULL_ARGUMENT; BUSY */
    public long[] joints() {
        try (Arena local = Arena.ofConfined()) {
            return Raw.list(this::call, local, 8, (p, dst, capacity, count, e) -> Raw.carom_world_get_joints(p, dst, capacity, count, e)).toArray(JAVA_LONG);
        }
    }

    /** Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
     *  param: on  0 or 1
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was */
    public void enableLedger(int on) {
        call((p, e) -> Raw.carom_world_enable_ledger(p, on, e));
    }

    /** Copy out all causes, in the order above; none of a world that keeps no ledger.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_ledger_entry) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public Raw.LedgerEntry[] ledger() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.LedgerEntry.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_ledger(p, dst, Raw.LedgerEntry.SIZE, capacity, count, e));
        var each = new Raw.LedgerEntry[(int) (all.byteSize() / Raw.LedgerEntry.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.LedgerEntry(all.asSlice((long) i * Raw.LedgerEntry.SIZE, Raw.LedgerEntry.SIZE));
        return each;
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public Raw.LedgerState ledgerState() {
        var state_out = new Raw.LedgerState(Arena.ofAuto());
        call((p, e) -> Raw.carom_world_get_ledger_state(p, state_out.segment, e));
        return state_out;
    }

    /** Make an empty set.
     *  param: desc may be NULL: defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
    public long particles(Raw.ParticlesDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var set_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_particles_create(p, desc == null ? MemorySegment.NULL : desc.segment, set_out, e));
            return set_out.get(JAVA_LONG, 0);
        }
    }

    /** Its particles too.   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public void particlesDestroy(long set) {
        call((p, e) -> Raw.carom_particles_destroy(p, set, e));
    }

    /** param: desc out: as it was made or updated; capacity: particles there is memory for
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public Raw.ParticlesDesc particlesDesc(long set) {
        var desc_out = new Raw.ParticlesDesc(Arena.ofAuto());
        call((p, e) -> Raw.carom_particles_get(p, set, desc_out.segment, e));
        return desc_out;
    }

    /** Change what they have in common; particles that are there keep their mass.
     *  param: desc may be NULL: defaults; capacity: memory for so many in all
     *  status: as carom_particles_create(); *_HANDLE */
    public void particlesUpdate(long set, Raw.ParticlesDesc desc) {
        call((p, e) -> Raw.carom_particles_update(p, set, desc == null ? MemorySegment.NULL : desc.segment, e));
    }

    /** param: count out: particles in the set   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public long particlesCount(long set) {
        try (Arena local = Arena.ofConfined()) {
            var count_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_particles_get_count(p, set, count_out, e));
            return count_out.get(JAVA_LONG, 0);
        }
    }

    /** Remove n particles. The others keep their order, so each moves up by as many as went before it.
     *  param: indices [n] ascending, each once; NULL: all of them (n must be their number)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT */
    public void particlesRemove(long set, int[] indices) {
        try (Arena local = Arena.ofConfined()) {
            var indices_in = Raw.in(local, indices);
            call((p, e) -> Raw.carom_particles_remove(p, set, indices_in, indices.length, e));
        }
    }

    /** A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
     *  where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
     *  reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
     *  param: indices [capacity] out; may be NULL if capacity is 0
     *  param: count   out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public int[] particlesQuarantined(long set) {
        try (Arena local = Arena.ofConfined()) {
            return Raw.list(this::call, local, 4, (p, dst, capacity, count, e) -> Raw.carom_particles_get_quarantined(p, set, dst, capacity, count, e)).toArray(JAVA_INT);
        }
    }

    /** Number of sets, and their handles in creation order of the slots.
     *  param: sets [capacity] or NULL   param: count out: how many there are
     *  status: OK; NULL_ARGUMENT; BUSY */
    public long[] particleSets() {
        try (Arena local = Arena.ofConfined()) {
            return Raw.list(this::call, local, 8, (p, dst, capacity, count, e) -> Raw.carom_world_get_particles(p, dst, capacity, count, e)).toArray(JAVA_LONG);
        }
    }

    /** Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
     *  needs is allowed, and carom_world_get_plan() says so.
     *  param: effect CAROM_EFFECT_*   param: mode CAROM_MODE_*
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
    public void setEffect(int effect, int mode) {
        call((p, e) -> Raw.carom_world_set_effect(p, effect, mode, e));
    }

    /** param: mode out   status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
    public int effect(int effect) {
        try (Arena local = Arena.ofConfined()) {
            var mode_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_world_get_effect(p, effect, mode_out, e));
            return mode_out.get(JAVA_INT, 0);
        }
    }

    /** The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
     *  the world is forbidden for it. Particles, events and the ledger are not a body's.
     *  param: mode CAROM_MODE_*
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
     *          carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY */
    public void bodySetEffect(long body, int effect, int mode) {
        call((p, e) -> Raw.carom_body_set_effect(p, body, effect, mode, e));
    }

    /** param: mode out: of the body itself   status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY */
    public int bodyEffect(long body, int effect) {
        try (Arena local = Arena.ofConfined()) {
            var mode_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_body_get_effect(p, body, effect, mode_out, e));
            return mode_out.get(JAVA_INT, 0);
        }
    }

    /** Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
     *  param: on 1 or 0 (as a world is created)
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT */
    public void timeEffects(int on) {
        call((p, e) -> Raw.carom_world_time_effects(p, on, e));
    }

    /** Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_plan_line) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public Raw.PlanLine[] plan() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.PlanLine.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_plan(p, dst, Raw.PlanLine.SIZE, capacity, count, e));
        var each = new Raw.PlanLine[(int) (all.byteSize() / Raw.PlanLine.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.PlanLine(all.asSlice((long) i * Raw.PlanLine.SIZE, Raw.PlanLine.SIZE));
        return each;
    }

    /** Stop recording.
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
     *          recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT */
    public void recordEnd() {
        call((p, e) -> Raw.carom_world_record_end(p, e));
    }

    /** Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
     *  param: difference its struct_size set by the caller
     *  param: bytes [size] of carom_world_save()   param: size number of bytes
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
     *          OUT_OF_MEMORY   thread: reader */
    public Raw.Difference compare(byte[] bytes) {
        try (Arena local = Arena.ofConfined()) {
            var bytes_in = Raw.in(local, bytes);
            var difference_out = new Raw.Difference(Arena.ofAuto());
            call((p, e) -> Raw.carom_world_compare(p, bytes_in, bytes.length, difference_out.segment, e));
            return difference_out;
        }
    }

    /** param: residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
     *                   concerns them is 0.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
     *  accuracy: rounding; effective masses are those along the normal
     *  cost: linear in contact points, joints and bodies */
    public Raw.Residuals residuals() {
        var residuals_out = new Raw.Residuals(Arena.ofAuto());
        call((p, e) -> Raw.carom_world_get_residuals(p, residuals_out.segment, e));
        return residuals_out;
    }

    /** Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
     *  the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
     *  Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
     *  for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
     *  host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
     *  chose.
     *  param: seconds  s of wall clock a step, 0 &lt; seconds &lt;= 10; 0: off, the dial keeps its value
     *  param: fewest, most  substeps, 1 &lt;= fewest &lt;= most &lt;= the dial's bound; ignored when off
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void setBudget(double seconds, int fewest, int most) {
        call((p, e) -> Raw.carom_world_set_budget(p, seconds, fewest, most, e));
    }

    public record Budget(double seconds, int fewest, int most) {}

    /** param: seconds, fewest, most  out: as set; 0 when off   status: OK; NULL_ARGUMENT; BUSY */
    public Budget budget() {
        try (Arena local = Arena.ofConfined()) {
            var seconds_out = local.allocate(8, 8);
            var fewest_out = local.allocate(8, 8);
            var most_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_world_get_budget(p, seconds_out, fewest_out, most_out, e));
            return new Budget(seconds_out.get(JAVA_DOUBLE, 0), fewest_out.get(JAVA_INT, 0), most_out.get(JAVA_INT, 0));
        }
    }

    /** Write a snapshot, between steps. Reads only: other readers may be at work.
     *  param: flags    CAROM_SNAPSHOT_*
     *  param: buffer   [capacity] bytes, or NULL to get the size alone
     *  param: capacity bytes; 0 if buffer is NULL
     *  param: needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   thread: reader */
    public byte[] save(int flags) {
        try (Arena local = Arena.ofConfined()) {
            return Raw.list(this::call, local, 1, (p, dst, capacity, count, e) -> Raw.carom_world_save(p, flags, dst, capacity, count, e)).toArray(JAVA_BYTE);
        }
    }

    /** Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
     *  anything of the world changes.
     *  An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
     *  begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
     *  as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
     *  that is not whole.
     *  param: bytes [size], of any alignment   param: size as carom_world_save() gave it
     *  status: OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
     *  newer
     *          format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
     *          that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
     *          says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY */
    public void restore(byte[] bytes) {
        try (Arena local = Arena.ofConfined()) {
            var bytes_in = Raw.in(local, bytes);
            call((p, e) -> Raw.carom_world_restore(p, bytes_in, bytes.length, e));
        }
    }

    /** Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
     *  that it has forked, or of one that was saved whole, in another process too.
     *  param: handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
     *  param: translated [n] out; may be `handles`. All of them or, where one is refused, none
     *  status: OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
     *          worlds); BUSY; REENTRANT   thread: reader */
    public void translateHandles(long[] handles, long[] translated) {
        try (Arena local = Arena.ofConfined()) {
            var handles_in = Raw.in(local, handles);
            var translated_in = Raw.in(local, translated);
            Raw.fits(translated.length, handles.length);
            call((p, e) -> Raw.carom_world_translate_handles(p, handles_in, handles.length, translated_in, e));
            MemorySegment.copy(translated_in, JAVA_LONG, 0, translated, 0, translated.length);
        }
    }

    /** Copy out what the coordinates of a tree are.
     *  param: body     any dynamic body of the tree; its base, where nothing holds the tree
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_tree_coordinate) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
     *          BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY */
    public Raw.TreeCoordinate[] treeCoordinates(long body) {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.TreeCoordinate.SIZE, (p, dst, capacity, count, e) -> Raw.carom_tree_get_coordinates(p, body, dst, Raw.TreeCoordinate.SIZE, capacity, count, e));
        var each = new Raw.TreeCoordinate[(int) (all.byteSize() / Raw.TreeCoordinate.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.TreeCoordinate(all.asSlice((long) i * Raw.TreeCoordinate.SIZE, Raw.TreeCoordinate.SIZE));
        return each;
    }

    /** The speeds that a tree has now.
     *  Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
     *  param: speeds out, [n]   param: n how many coordinates there are
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
     *          OUT_OF_MEMORY */
    public void treeSpeeds(long body, double[] speeds) {
        try (Arena local = Arena.ofConfined()) {
            var speeds_in = Raw.in(local, speeds);
            call((p, e) -> Raw.carom_tree_get_speeds(p, body, speeds_in, speeds.length, e));
            MemorySegment.copy(speeds_in, JAVA_DOUBLE, 0, speeds, 0, speeds.length);
        }
    }

    /** Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
     *      forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
     *  With speeds of 0 and no accelerations these hold the tree against gravity.
     *  Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
     *  param: speeds        [n] m/s and rad/s, or NULL: those of now
     *  param: accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
     *  param: forces        out, [n] N and N m
     *  param: n             how many coordinates there are
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
     *          OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY */
    public void treeForces(long body, double[] speeds, double[] accelerations, double[] forces) {
        try (Arena local = Arena.ofConfined()) {
            var speeds_in = Raw.in(local, speeds);
            var accelerations_in = Raw.in(local, accelerations);
            var forces_in = Raw.in(local, forces);
            Raw.fits(speeds == null ? forces.length : speeds.length, forces.length);
            Raw.fits(accelerations == null ? forces.length : accelerations.length, forces.length);
            call((p, e) -> Raw.carom_tree_get_forces(p, body, speeds_in, accelerations_in, forces_in, forces.length, e));
            MemorySegment.copy(forces_in, JAVA_DOUBLE, 0, forces, 0, forces.length);
        }
    }

    /** Advance by dt.
     *  param: dt s, in [1e-9, 1]
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
     *  Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
     *  A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it. */
    public void step(double dt) {
        call((p, e) -> Raw.carom_world_step(p, dt, e));
    }

    /** param: value within the dial's bounds; whole for choices and integers
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void setDial(int dial, double value) {
        call((p, e) -> Raw.carom_world_set_dial(p, dial, value, e));
    }

    /** param: value as carom_world_set_dial() takes it   status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
    public double dial(int dial) {
        try (Arena local = Arena.ofConfined()) {
            var value_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_world_get_dial(p, dial, value_out, e));
            return value_out.get(JAVA_DOUBLE, 0);
        }
    }

    /** Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
     *  carom_world_set_dial() change them one by one.   param: preset CAROM_PRESET_*
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
    public void setPreset(int preset) {
        call((p, e) -> Raw.carom_world_set_preset(p, preset, e));
    }

    /** param: gravity [3] m/s^2, |each| &lt;= 1e6   status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public void setGravity(Vec3 gravity) {
        try (Arena local = Arena.ofConfined()) {
            var gravity_in = Raw.in(local, gravity);
            call((p, e) -> Raw.carom_world_set_gravity(p, gravity_in, e));
        }
    }

    /** status: OK; NULL_ARGUMENT; BUSY */
    public Vec3 gravity() {
        try (Arena local = Arena.ofConfined()) {
            var gravity_out = local.allocate(24, 8);
            call((p, e) -> Raw.carom_world_get_gravity(p, gravity_out, e));
            return Vec3.of(gravity_out.toArray(JAVA_DOUBLE));
        }
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public Raw.StepReport report() {
        var report_out = new Raw.StepReport(Arena.ofAuto());
        call((p, e) -> Raw.carom_world_get_report(p, report_out.segment, e));
        return report_out;
    }

    /** Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_contact) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public Raw.Contact[] contacts() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.Contact.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_contacts(p, dst, Raw.Contact.SIZE, capacity, count, e));
        var each = new Raw.Contact[(int) (all.byteSize() / Raw.Contact.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.Contact(all.asSlice((long) i * Raw.Contact.SIZE, Raw.Contact.SIZE));
        return each;
    }

    /** Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
     *  all groups alike: then there are none.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_group) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public Raw.Group[] groups() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.Group.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_groups(p, dst, Raw.Group.SIZE, capacity, count, e));
        var each = new Raw.Group[(int) (all.byteSize() / Raw.Group.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.Group(all.asSlice((long) i * Raw.Group.SIZE, Raw.Group.SIZE));
        return each;
    }

    /** Copy out the faults of the last step; arguments as carom_world_get_contacts(). */
    public Raw.Fault[] faults() {
        var all = Raw.list(this::call, Arena.ofAuto(), Raw.Fault.SIZE, (p, dst, capacity, count, e) -> Raw.carom_world_get_faults(p, dst, Raw.Fault.SIZE, capacity, count, e));
        var each = new Raw.Fault[(int) (all.byteSize() / Raw.Fault.SIZE)];
        for (int i = 0; i < each.length; i++) each[i] = new Raw.Fault(all.asSlice((long) i * Raw.Fault.SIZE, Raw.Fault.SIZE));
        return each;
    }

    /** 64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
     *  has the same bits, and every particle's position and velocity.
     *  param: hash of the state
     *  status: OK; NULL_ARGUMENT; BUSY   thread: reader */
    public long hash() {
        try (Arena local = Arena.ofConfined()) {
            var hash_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_world_hash(p, hash_out, e));
            return hash_out.get(JAVA_LONG, 0);
        }
    }

    /** What one ray meets first: origin + t direction, 0 &lt;= t &lt;= max.
     *  param: origin [3] m   param: direction [3] m per unit of t, any length   param: max &gt;= 0, may be infinite
     *  param: desc   may be NULL: defaults   param: size sizeof(carom_world_hit) as the caller knows it
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc-&gt;ignore); NOT_FINITE; OUT_OF_RANGE;
     *          BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   thread: reader */
    public Raw.WorldHit castRay(Vec3 origin, Vec3 direction, double max, Raw.QueryDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var origin_in = Raw.in(local, origin);
            var direction_in = Raw.in(local, direction);
            var hit_out = new Raw.WorldHit(Arena.ofAuto());
            call((p, e) -> Raw.carom_world_cast_ray(p, origin_in, direction_in, max, desc == null ? MemorySegment.NULL : desc.segment, hit_out.segment, Raw.WorldHit.SIZE, e));
            return hit_out;
        }
    }

    private static final int[] WIDTH = {3, 4, 7, 3, 3, 6, 6, 3, 1}; // numbers a body, by field

    static int width(int field, long[] bodies, int numbers) {
        if (field < 0 || field >= WIDTH.length) throw unfit("there is no field " + field);
        int width = WIDTH[field];
        if (numbers % width != 0 || bodies != null && numbers / width != bodies.length)
            throw unfit(numbers + " numbers, " + width + " a body" + (bodies == null ? "" : ", for " + bodies.length + " bodies"));
        return width;
    }

    static CaromException unfit(String what) {
        return new CaromException(Raw.CAROM_E_OUT_OF_RANGE, what, "pass as many numbers as the field has for as many bodies");
    }
}

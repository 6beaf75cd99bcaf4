// Written by bindings/gen/generate from include/carom; do not edit.
package carom;

import static java.lang.foreign.ValueLayout.*;

import java.lang.foreign.*;

/** Calls on an engine that need no pointer of the caller's. A handle is a long. */
public abstract sealed class EngineCalls implements AutoCloseable permits Engine {
    /** A call of Raw that takes an engine or a world, then what it takes besides, then the error. */
    @FunctionalInterface
    public interface Call {
        int of(MemorySegment pointer, MemorySegment error);
    }

    private MemorySegment pointer;

    EngineCalls(MemorySegment pointer) { this.pointer = pointer; }

    /** What calls of Raw take; NULL once it is closed, which they refuse. */
    public MemorySegment pointer() { return pointer; }

    /** Any call of Raw on this engine: engine.call((p, e) -> Raw.carom_engine_set_jobs(p, jobs, e)). */
    public void call(EngineCalls.Call call) {
        var scratch = Library.Scratch.get();
        scratch.check(call.of(pointer, scratch.error.segment));
    }

    /** Give back all memory; closing twice does nothing. Fails while worlds are open. */
    @Override
    public void close() {
        if (pointer.equals(MemorySegment.NULL)) return;
        call(Raw::carom_engine_destroy);
        pointer = MemorySegment.NULL;
    }

    /** Cast the ray origin + t direction, 0 &lt;= t &lt;= max, against a shape.
     *  param: position, orientation  of the shape: [3] m, [4] x, y, z, w
     *  param: origin [3] m   param: direction [3] m per unit of t, any length; zero asks whether the origin is inside
     *  param: max    &gt;= 0, may be infinite
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED */
    public Raw.Cast rayCast(long shape, Vec3 position, Quat orientation, Vec3 origin, Vec3 direction, double max, Raw.CastDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var position_in = Raw.in(local, position);
            var orientation_in = Raw.in(local, orientation);
            var origin_in = Raw.in(local, origin);
            var direction_in = Raw.in(local, direction);
            var result_out = new Raw.Cast(Arena.ofAuto());
            call((p, e) -> Raw.carom_ray_cast(p, shape, position_in, orientation_in, origin_in, direction_in, max, desc == null ? MemorySegment.NULL : desc.segment, result_out.segment, e));
            return result_out;
        }
    }

    /** Move shape A along a straight line, without turning it, until it touches B.
     *  param: motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller
     *  param: position_* [3] m, world   param: orientation_* [4] x, y, z, w
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
     *          half-spaces) */
    public Raw.Cast shapeCast(long shapeA, Vec3 positionA, Quat orientationA, Vec3 motion, long shapeB, Vec3 positionB, Quat orientationB, Raw.CastDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var positionA_in = Raw.in(local, positionA);
            var orientationA_in = Raw.in(local, orientationA);
            var motion_in = Raw.in(local, motion);
            var positionB_in = Raw.in(local, positionB);
            var orientationB_in = Raw.in(local, orientationB);
            var result_out = new Raw.Cast(Arena.ofAuto());
            call((p, e) -> Raw.carom_shape_cast(p, shapeA, positionA_in, orientationA_in, motion_in, shapeB, positionB_in, orientationB_in, desc == null ? MemorySegment.NULL : desc.segment, result_out.segment, e));
            return result_out;
        }
    }

    /** First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
     *  touches before `lower`.
     *  param: motion_*  struct_size set by carom_motion_init()   param: duration s, 0 to 1e9
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller; times in s
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
     *          UNSUPPORTED (two half-spaces, or one that turns) */
    public Raw.Cast shapeTimeOfImpact(long shapeA, Raw.Motion motionA, long shapeB, Raw.Motion motionB, double duration, Raw.CastDesc desc) {
        var result_out = new Raw.Cast(Arena.ofAuto());
        call((p, e) -> Raw.carom_shape_time_of_impact(p, shapeA, motionA.segment, shapeB, motionB.segment, duration, desc == null ? MemorySegment.NULL : desc.segment, result_out.segment, e));
        return result_out;
    }

    /** Do two shapes overlap (or come nearer than desc-&gt;target)? Cheaper than their distance, with a proof of yes or no.
     *  param: desc   may be NULL: defaults; tolerance is not used   param: result struct_size set by the caller
     *  param: position_* [3] m, world   param: orientation_* [4] x, y, z, w
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
     *          half-spaces) */
    public Raw.Overlap shapeOverlap(long shapeA, Vec3 positionA, Quat orientationA, long shapeB, Vec3 positionB, Quat orientationB, Raw.CastDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var positionA_in = Raw.in(local, positionA);
            var orientationA_in = Raw.in(local, orientationA);
            var positionB_in = Raw.in(local, positionB);
            var orientationB_in = Raw.in(local, orientationB);
            var result_out = new Raw.Overlap(Arena.ofAuto());
            call((p, e) -> Raw.carom_shape_overlap(p, shapeA, positionA_in, orientationA_in, shapeB, positionB_in, orientationB_in, desc == null ? MemorySegment.NULL : desc.segment, result_out.segment, e));
            return result_out;
        }
    }

    /** Load a shape plugin from a shared object. param: path absolute.
     *  The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
     *  the bounds allow. Loading the same path twice is ALREADY_EXISTS.
     *  status: OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY */
    public long pluginLoad(String path) {
        try (Arena local = Arena.ofConfined()) {
            var path_in = Raw.in(local, path);
            var plugin_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_plugin_load(p, path_in, plugin_out, e));
            return plugin_out.get(JAVA_LONG, 0);
        }
    }

    /** Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
     *  WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY */
    public void registerStandard() {
        call((p, e) -> Raw.carom_plugins_register_standard(p, e));
    }

    /** Forget a plugin (logically: the code stays mapped).   status: OK; NULL_ARGUMENT; IN_USE (shapes of it live);
     *  *_HANDLE; REENTRANT */
    public void pluginUnload(long plugin) {
        call((p, e) -> Raw.carom_plugin_unload(p, plugin, e));
    }

    /** Find a loaded plugin by its id.
     *  param: id as in carom_shape_plugin.id
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (load it first) */
    public long pluginFind(String id) {
        try (Arena local = Arena.ofConfined()) {
            var id_in = Raw.in(local, id);
            var plugin_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_plugin_find(p, id_in, plugin_out, e));
            return plugin_out.get(JAVA_LONG, 0);
        }
    }

    /** Signed distance of two shapes.
     *  param: position_*     [3] m     param: orientation_* [4] x, y, z, w
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
     *          UNSUPPORTED (two half-spaces) */
    public Raw.Distance shapeDistance(long shapeA, Vec3 positionA, Quat orientationA, long shapeB, Vec3 positionB, Quat orientationB, Raw.DistanceDesc desc) {
        try (Arena local = Arena.ofConfined()) {
            var positionA_in = Raw.in(local, positionA);
            var orientationA_in = Raw.in(local, orientationA);
            var positionB_in = Raw.in(local, positionB);
            var orientationB_in = Raw.in(local, orientationB);
            var result_out = new Raw.Distance(Arena.ofAuto());
            call((p, e) -> Raw.carom_shape_distance(p, shapeA, positionA_in, orientationA_in, shapeB, positionB_in, orientationB_in, desc == null ? MemorySegment.NULL : desc.segment, result_out.segment, e));
            return result_out;
        }
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE (set info-&gt;struct_size); *_HANDLE; UNSUPPORTED (a convex shape) */
    public Raw.SceneryInfo shapeSceneryInfo(long shape) {
        var info_out = new Raw.SceneryInfo(Arena.ofAuto());
        call((p, e) -> Raw.carom_shape_get_scenery_info(p, shape, info_out.segment, e));
        return info_out;
    }

    /** Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
     *  scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
     *  param: params [count] doubles, meaning as the plugin documents
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
     *          PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY */
    public long shapeOf(long plugin, double... params) {
        try (Arena local = Arena.ofConfined()) {
            var params_in = Raw.in(local, params);
            var shape_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_shape_create(p, plugin, params_in, params.length, shape_out, e));
            return shape_out.get(JAVA_LONG, 0);
        }
    }

    /** Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
     *  engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
     *  and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
     *  privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
     *  z, offset.
     *  param: name 1 to 64 letters, digits, _, - and dots   param: params [count] as carom_shape_create()
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
     *          PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY */
    public long shape(String name, double... params) {
        try (Arena local = Arena.ofConfined()) {
            var name_in = Raw.in(local, name);
            var params_in = Raw.in(local, params);
            var shape_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_shape_create_named(p, name_in, params_in, params.length, shape_out, e));
            return shape_out.get(JAVA_LONG, 0);
        }
    }

    /** The built-in half-space { x : normal . x &lt;= offset } in the shape's own frame; unbounded, so static bodies only.
     *  param: normal [3] unit (within 1e-6)   param: offset m
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY */
    public long shapeCreateHalfSpace(Vec3 normal, double offset) {
        try (Arena local = Arena.ofConfined()) {
            var normal_in = Raw.in(local, normal);
            var shape_out = local.allocate(8, 8);
            call((p, e) -> Raw.carom_shape_create_half_space(p, normal_in, offset, shape_out, e));
            return shape_out.get(JAVA_LONG, 0);
        }
    }

    /** Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
     *  same call makes
     *  - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
     *    of both ends leaves out what bulges between them: add poses in between;
     *  - a scaled shape: one part with a scale. A negative scale mirrors it;
     *  - a rounded shape: one part and a radius, by which it grows on all sides.
     *  Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
     *  corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
     *  the hull.
     *  param: parts         [count] handles of convex shapes, the same one as often as wanted
     *  param: count         1 to 4096
     *  param: positions     [3 * count] m, frame of the hull; NULL: 0
     *  param: orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
     *  param: scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
     *  param: radius        m, 0 or more
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
     *          PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
     *  since: 0.9 */
    public long shapeCreateHullOf(long[] parts, double[] positions, double[] orientations, double[] scales, double radius) {
        try (Arena local = Arena.ofConfined()) {
            var parts_in = Raw.in(local, parts);
            var positions_in = Raw.in(local, positions);
            var orientations_in = Raw.in(local, orientations);
            var scales_in = Raw.in(local, scales);
            var shape_out = local.allocate(8, 8);
            Raw.fits(positions == null ? parts.length : positions.length / 3, parts.length);
            Raw.fits(orientations == null ? parts.length : orientations.length / 4, parts.length);
            Raw.fits(scales == null ? parts.length : scales.length / 3, parts.length);
            call((p, e) -> Raw.carom_shape_create_hull_of(p, parts_in, parts.length, positions_in, orientations_in, scales_in, radius, shape_out, e));
            return shape_out.get(JAVA_LONG, 0);
        }
    }

    /** status: OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
     *          it); REENTRANT */
    public void shapeDestroy(long shape) {
        call((p, e) -> Raw.carom_shape_destroy(p, shape, e));
    }

    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE (set info-&gt;struct_size); *_HANDLE */
    public Raw.ShapeInfo shapeInfo(long shape) {
        var info_out = new Raw.ShapeInfo(Arena.ofAuto());
        call((p, e) -> Raw.carom_shape_get_info(p, shape, info_out.segment, e));
        return info_out;
    }

    /** Support points of the whole shape, core radius included, for n directions at once.
     *  param: dirs [3n] nonzero, any length, shape frame   param: points [3n] m, shape frame
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
     *          scenery); PLUGIN_INVALID (the support function failed; the points before are written) */
    public void shapeSupport(long shape, double[] dirs, double[] points) {
        try (Arena local = Arena.ofConfined()) {
            var dirs_in = Raw.in(local, dirs);
            var points_in = Raw.in(local, points);
            Raw.fits(points.length / 3, dirs.length / 3);
            call((p, e) -> Raw.carom_shape_support(p, shape, dirs_in, dirs.length / 3, points_in, e));
            MemorySegment.copy(points_in, JAVA_DOUBLE, 0, points, 0, points.length);
        }
    }
}

package carom;

import java.lang.foreign.Arena;
import java.util.ArrayList;
import java.util.Arrays;

/** Failures, arrays, copies, and nothing that is not given back. Runs all methods that begin with test. */
public final class CaromTest {
    static final double DT = 1.0 / 60;

    public static void main(String[] arguments) throws Exception {
        int passed = 0, failed = 0;
        for (var method : CaromTest.class.getDeclaredMethods()) {
            if (!method.getName().startsWith("test")) continue;
            try {
                method.invoke(null);
                passed++;
            } catch (java.lang.reflect.InvocationTargetException problem) {
                failed++;
                System.err.println(method.getName() + ": " + problem.getCause());
                problem.getCause().printStackTrace();
            }
        }
        System.out.println(passed + " passed, " + failed + " failed");
        if (failed > 0) System.exit(1);
    }

    static void same(Object found, Object wanted) {
        if (!found.equals(wanted)) throw new AssertionError(found + " is not " + wanted);
    }

    static CaromException fails(int code, Runnable what) {
        try {
            what.run();
        } catch (CaromException e) {
            same(e.code, code);
            same(e.getMessage().endsWith(". Remedy: " + e.remedy) && !e.remedy.isEmpty(), true);
            return e;
        }
        throw new AssertionError("it did not fail");
    }

    static void testFailuresHaveARemedy() {
        try (Engine engine = new Engine(); World world = engine.world()) {
            fails(Raw.CAROM_E_NOT_FOUND, () -> engine.shape("no_such_shape"));
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> engine.shape("sphere", -1));
            same(fails(Raw.CAROM_E_OUT_OF_RANGE, () -> world.step(2)).argument, 2);
            Body ball = world.body(engine.shape("sphere", 0.5), new Vec3(0, 0, 0));
            ball.destroy();
            fails(Raw.CAROM_E_STALE_HANDLE, ball::position);
            fails(Raw.CAROM_E_INVALID_HANDLE, () -> world.body(0, new Vec3(0, 0, 0)));
            same(world.bodies().length, 0); // the body without its collider is gone, too
            fails(Raw.CAROM_E_PLUGIN_INVALID, () -> engine.plugin("test.throws", (p, d) -> { throw new IllegalStateException("no"); }));
            same(fails(Raw.CAROM_E_PLUGIN_INVALID, () -> engine.plugin("test.dent", (p, d) -> new Vec3(-d.x(), d.y(), d.z()))).witness.length, 2);
            fails(Raw.CAROM_E_IN_USE, engine::close);
            World closed = engine.world();
            closed.close();
            closed.close();
            fails(Raw.CAROM_E_NULL_ARGUMENT, () -> closed.step(DT));
        }
    }

    static void testEveryKindOfArgument() {
        try (Engine engine = new Engine(); World world = engine.world(); Arena arena = Arena.ofConfined()) {
            long small = engine.shape("sphere", 0.2);
            long[] parts = {small, small};
            double[] places = {-0.5, 0, 0, 0.5, 0, 0}, turns = {0, 0, 0, 1}, farthest = new double[6];
            long capsule = engine.shapeCreateHullOf(parts, places, null, null, 0);
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> engine.shapeCreateHullOf(parts, null, turns, null, 0));
            engine.shapeSupport(capsule, new double[] {1, 0, 0, 0, 2, 0}, farthest);
            same(Math.abs(farthest[0] - 0.7) < 1e-12 && Math.abs(farthest[4] - 0.2) < 1e-12, true);
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> engine.shapeSupport(capsule, new double[3], farthest));
            long body = world.body(capsule, new Vec3(0, 2, 0)).handle();
            Vec3 before = world.mass(body).center();
            world.setMass(body, 3, null, new double[] {1, 0, 0, 0, 2, 0, 0, 0, 2.5});
            var mass = world.mass(body);
            same(mass.mass() == 3 && mass.center().equals(before) && mass.inertia()[4] == 2 && mass.inertia()[8] == 2.5, true);
            var hit = world.castRay(new Vec3(0, 5, 0), new Vec3(0, -1, 0), 10, null);
            same(hit.body() == body && Math.abs(hit.time() - 2.8) < 1e-6, true);
            world.setAccuracy(new Raw.Accuracy(arena).place(1e-3).turn(1e-3));
            same(world.accuracy().present(), 1);
            world.setAccuracy(null);
            same(world.accuracy().present(), 0);
            same(world.colliders(body).length, 1);
            long[] found = new long[1];
            world.translateHandles(new long[] {body}, found);
            same(found[0], body);
        }
    }

    static void testArraysOfBodies() {
        try (Engine engine = new Engine(); World world = engine.world(); Arena arena = Arena.ofConfined()) {
            long shape = engine.shape("sphere", 0.5);
            var made = new ArrayList<Body>();
            for (int i = 0; i < 100; i++) made.add(world.body(shape, new Vec3(2.0 * i, 1, 0)));
            double[] positions = new double[300], poses = new double[700];
            var outside = arena.allocate(8 * 400, 8);
            world.positions(positions);
            world.poses(poses);
            world.read(Raw.CAROM_FIELD_POSITION, null, outside, 100, 32);
            long[] handles = world.bodies();
            for (int i = 0; i < 100; i++) {
                same(handles[i], made.get(i).handle());
                same(new Vec3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]), new Vec3(2.0 * i, 1, 0));
                same(made.get(i).pose(), new Pose(made.get(i).position(), Quat.IDENTITY));
                same(poses[7 * i], 2.0 * i);
                same(poses[7 * i + 6], 1.0);
                same(outside.getAtIndex(java.lang.foreign.ValueLayout.JAVA_DOUBLE, 4 * i), 2.0 * i);
            }
            world.write(Raw.CAROM_FIELD_POSITION, Arrays.copyOf(handles, 1), new double[] {0, 9, 0});
            same(made.get(0).position(), new Vec3(0, 9, 0));
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> world.positions(new double[297]));
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> world.positions(new double[299]));
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> world.read(Raw.CAROM_FIELD_POSITION, Arrays.copyOf(handles, 2), positions));
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> world.read(99, null, positions));
            fails(Raw.CAROM_E_OUT_OF_RANGE, () -> world.read(Raw.CAROM_FIELD_POSITION, null, outside, 100, 40));
        }
    }

    static long run(World world) {
        for (int i = 0; i < 30; i++) world.step(DT);
        return world.hash();
    }

    static void testACopyAndSavedBytesGoOnAlike() {
        try (Engine engine = new Engine(); World world = engine.world(); Arena arena = Arena.ofConfined()) {
            world.ground(0);
            Body box = world.body(engine.shape("box", 0.5, 0.5, 0.5), new Vec3(0, 0.7, 0));
            box.setPose(new Pose(box.position(), new Quat(0, 0.6, 0, 0.8)));
            box.setVelocity(new Vec3(0.1, 0, 0), new Vec3(1, 2, 3));
            same(box.linearVelocity(), new Vec3(0.1, 0, 0));
            box.addForce(new Vec3(1, 0, 0), new Vec3(0, 1, 0));
            same(box.pose().orientation(), new Quat(0, 0.6, 0, 0.8));
            byte[] saved = world.save(Raw.CAROM_SNAPSHOT_STATE);
            try (World copy = world.fork()) {
                long after = run(world);
                same(run(copy), after);
                same(world.contacts().length > 0 && world.contacts()[0].normal().length == 3, true);
                world.restore(saved);
                same(run(world), after);
            }
            fails(Raw.CAROM_E_CORRUPT, () -> world.restore("nonsense".getBytes()));
        }
    }

    static void testWorldsStepOnManyThreads() throws InterruptedException {
        try (Engine engine = new Engine()) {
            long box = engine.plugin("test.box", (p, d) -> new Vec3(Math.copySign(p[0], d.x()), Math.copySign(p[0], d.y()), Math.copySign(p[0], d.z())),
                new Support.Param("half", "m", 1e-6, 1e3));
            long[] hashes = new long[4];
            var threads = new Thread[hashes.length];
            for (int i = 0; i < threads.length; i++) {
                int mine = i;
                threads[i] = Thread.ofPlatform().start(() -> {
                    try (World world = engine.world()) {
                        world.ground(0);
                        world.body(engine.shapeOf(box, 0.5), new Vec3(0, 0.6, 0));
                        hashes[mine] = run(world);
                    }
                });
            }
            for (Thread thread : threads) thread.join();
            for (long hash : hashes) same(hash == hashes[0] && hash != 0, true);
        }
    }

    /** All functions are in the library, and refuse NULL. */
    static void testEveryFunctionIsThere() throws ReflectiveOperationException {
        int called = 0;
        for (var method : Raw.class.getMethods()) {
            if (!method.getName().startsWith("carom_")) continue;
            Object[] arguments = Arrays.stream(method.getParameterTypes()).map(type -> type == int.class ? (Object) 0 : type == long.class ? 0L
                : type == double.class ? 0.0 : java.lang.foreign.MemorySegment.NULL).toArray();
            Object result = method.invoke(null, arguments);
            same(result instanceof String text ? !text.isEmpty() : (int) result < 0, true);
            called++;
        }
        same(called > 200, true);
    }

    static void testAnotherLibraryIsRefused() {
        String ours = Raw.LAYOUT;
        Library.check(ours);
        for (String other : new String[] {"0.0.1", "0.99.0", "99.0.0"}) {
            var e = fails(Raw.CAROM_E_UNSUPPORTED, () -> Library.check(ours.replaceFirst(Raw.VERSION, other)));
            same(e.getMessage().contains(" is of version " + Raw.VERSION + ", its caller of " + other), true);
        }
        String row = ours.lines().filter(line -> line.startsWith("carom_contact.separation ")).findFirst().get();
        var moved = fails(Raw.CAROM_E_UNSUPPORTED, () -> Library.check(ours.replace(row, "carom_contact.separation 4 8 f64")));
        same(moved.getMessage().contains(row.replaceFirst(" ", " as ")), true);
        var more = fails(Raw.CAROM_E_UNSUPPORTED, () -> Library.check(ours + "carom_contact.mood 0 8 f64\n"));
        same(more.getMessage().contains("has no carom_contact.mood"), true);
    }

    /** 65,535 engines and worlds may be alive in a process: more than that are made here, and given back. */
    static void testNothingIsLeftAlive() {
        for (int i = 0; i < 33_000; i++)
            try (Engine engine = new Engine(); World world = engine.world()) {
                same(world.bodies().length, 0);
            }
    }
}

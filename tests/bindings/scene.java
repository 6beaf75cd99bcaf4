import carom.*;
import java.lang.foreign.Arena;

/** The scene of scene.c by way of the package; prints its hashes, then those of it with a double cone whose function is Java. */
final class scene {
    /** plugins/template/template.c, operation by operation. */
    static Vec3 topSupport(double[] params, Vec3 d) {
        double r = params[0], h = params[1], x = d.x(), y = d.y(), z = d.z();
        double side = Math.max(Math.abs(x), Math.abs(z)), largest = Math.max(side, Math.abs(y)), length = 0;
        if (side > 0) {
            x /= side;
            z /= side;
            length = Math.sqrt(x * x + z * z);
            x /= length;
            z /= length;
        }
        if (h * (Math.abs(y) / largest) > r * (length * (side / largest))) return new Vec3(0, y >= 0 ? h : -h, 0);
        return new Vec3(r * x, 0, r * z);
    }

    static void hashes(Engine engine, long top) {
        long[] shapes = {engine.shape("sphere", 0.3), engine.shape("box", 0.4, 0.25, 0.3), top};
        try (World world = engine.world(); Arena arena = Arena.ofConfined()) {
            world.setDial(Raw.CAROM_DIAL_SUBSTEPS, 5);
            world.setWind(new Vec3(1.5, 0, 0.5));
            long material = world.material(new Raw.MaterialDesc(arena).friction(0.6).restitution(0.3));
            for (int i = 0; i < 19; i++) {
                var desc = new Raw.BodyDesc(arena);
                var part = new Raw.ColliderDesc(arena).material(material);
                if (i == 0) {
                    desc.type(Raw.CAROM_BODY_STATIC);
                    part.shape(engine.shape("half_space", 0, 1, 0, 0));
                } else {
                    desc.position(i % 3 * 0.5, 0.6 + i * 0.55, i % 2 * 0.4).angularVelocity(0.5 * i, 0, 1);
                    part.shape(shapes[i % 3]).density(400 + 50 * i);
                }
                Body body = world.body(desc, part);
                if (i > 0) world.setDrag(body.handle(), 0.1, 0.02);
            }
            Body door = world.body(shapes[1], new Vec3(4.5, 3, 0));
            world.joint(new Raw.JointDesc(arena).kind(Raw.CAROM_JOINT_HINGE).fields(Raw.CAROM_JOINT_WORLD_FRAME).bodyB(door.handle())
                .positionA(4, 3, 0).orientationA(0, -0.6, 0, 0.8));
            for (int second = 0; second < 3; second++) {
                for (int i = 0; i < 60; i++) world.step(1.0 / 60);
                System.out.printf("%016x%n", world.hash());
            }
        }
    }

    public static void main(String[] arguments) {
        try (Engine engine = new Engine()) {
            long kind = engine.plugin("test.top", scene::topSupport, new Support.Param("radius", "m", 1e-9, 1e8),
                new Support.Param("half_height", "m", 1e-9, 1e8));
            hashes(engine, engine.shape("template", 0.35, 0.4));
            hashes(engine, engine.shapeOf(kind, 0.35, 0.4));
        }
    }
}

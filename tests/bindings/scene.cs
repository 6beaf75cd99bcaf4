using System;
using Carom;

/// <summary>The scene of scene.c by way of the package; prints its hashes, then those of it with a double cone whose function is C#.</summary>
internal static class Scene
{
    /// <summary>plugins/template/template.c, operation by operation.</summary>
    private static Vec3 TopSupport(ReadOnlySpan<double> p, Vec3 d)
    {
        double r = p[0], h = p[1], x = d.X, y = d.Y, z = d.Z;
        double side = Math.Max(Math.Abs(x), Math.Abs(z)), largest = Math.Max(side, Math.Abs(y)), length = 0;
        if (side > 0)
        {
            x /= side;
            z /= side;
            length = Math.Sqrt(x * x + z * z);
            x /= length;
            z /= length;
        }
        if (h * (Math.Abs(y) / largest) > r * (length * (side / largest))) return new Vec3(0, y >= 0 ? h : -h, 0);
        return new Vec3(r * x, 0, r * z);
    }

    private static void Hashes(Engine engine, ulong top)
    {
        ulong[] shapes = { engine.Shape("sphere", 0.3), engine.Shape("box", 0.4, 0.25, 0.3), top };
        using (World world = engine.World())
        {
            world.SetDial(Raw.CAROM_DIAL_SUBSTEPS, 5);
            Raw.carom_world_set_wind(world, new Vec3(1.5, 0, 0.5));
            ulong material = world.Material(0.6, 0.3);
            for (int i = 0; i < 19; i++)
            {
                BodyDesc desc = BodyDesc.New();
                ColliderDesc part = ColliderDesc.New();
                part.Material = material;
                if (i == 0)
                {
                    desc.Type = Raw.CAROM_BODY_STATIC;
                    part.Shape = engine.Shape("half_space", 0, 1, 0, 0);
                }
                else
                {
                    desc.Position = new Vec3(i % 3 * 0.5, 0.6 + i * 0.55, i % 2 * 0.4);
                    desc.AngularVelocity = new Vec3(0.5 * i, 0, 1);
                    part.Shape = shapes[i % 3];
                    part.Density = 400 + 50 * i;
                }
                Body body = world.Body(desc, part);
                if (i > 0) Raw.carom_body_set_drag(world, body.Handle, 0.1, 0.02);
            }
            JointDesc hinge = JointDesc.New();
            hinge.Kind = Raw.CAROM_JOINT_HINGE;
            hinge.Fields = Raw.CAROM_JOINT_WORLD_FRAME;
            hinge.BodyB = world.Body(shapes[1], new Vec3(4.5, 3, 0)).Handle;
            hinge.PositionA = new Vec3(4, 3, 0);
            hinge.OrientationA = new Quat(0, -0.6, 0, 0.8);
            world.Joint(hinge);
            for (int second = 0; second < 3; second++)
            {
                for (int i = 0; i < 60; i++) world.Step(1.0 / 60);
                Console.WriteLine(world.Hash().ToString("x16"));
            }
        }
    }

    private static void Main()
    {
        using (var engine = new Engine())
        {
            ulong kind = engine.Plugin("test.top", TopSupport, ("radius", "m", 1e-9, 1e8), ("half_height", "m", 1e-9, 1e8));
            Hashes(engine, engine.Shape("template", 0.35, 0.4));
            Hashes(engine, engine.Shape(kind, 0.35, 0.4));
        }
    }
}

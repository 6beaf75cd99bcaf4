using System;
using System.Linq;
using System.Reflection;
using System.Threading;

namespace Carom
{
    /// <summary>Failures, arrays, copies, and nothing that is not given back. Runs all methods that begin with Test.</summary>
    internal static class CaromTest
    {
        private const double Dt = 1.0 / 60;

        private static int Main()
        {
            int passed = 0, failed = 0;
            foreach (MethodInfo method in typeof(CaromTest).GetMethods(BindingFlags.Static | BindingFlags.NonPublic))
            {
                if (!method.Name.StartsWith("Test")) continue;
                try
                {
                    method.Invoke(null, null);
                    passed++;
                }
                catch (TargetInvocationException problem)
                {
                    failed++;
                    Console.Error.WriteLine(method.Name + ": " + problem.InnerException);
                }
            }
            Console.WriteLine($"{passed} passed, {failed} failed");
            return failed;
        }

        private static void Same<T>(T found, T wanted)
        {
            if (!Equals(found, wanted)) throw new InvalidOperationException($"{found} is not {wanted}");
        }

        private static CaromException Fails(int code, Action what)
        {
            try
            {
                what();
            }
            catch (CaromException e)
            {
                Same(e.Code, code);
                Same(e.Message.EndsWith(". Remedy: " + e.Remedy) && e.Remedy.Length > 0, true);
                return e;
            }
            throw new InvalidOperationException("it did not fail");
        }

        private static void TestFailuresHaveARemedy()
        {
            using (var engine = new Engine())
            using (World world = engine.World())
            {
                Fails(Raw.CAROM_E_NOT_FOUND, () => engine.Shape("no_such_shape"));
                Fails(Raw.CAROM_E_OUT_OF_RANGE, () => engine.Shape("sphere", -1));
                Same(Fails(Raw.CAROM_E_OUT_OF_RANGE, () => world.Step(2)).Argument, 2);
                Body ball = world.Body(engine.Shape("sphere", 0.5), new Vec3(0, 0, 0));
                ball.Destroy();
                Fails(Raw.CAROM_E_STALE_HANDLE, () => { Vec3 p = ball.Position; });
                Fails(Raw.CAROM_E_INVALID_HANDLE, () => world.Body(0, new Vec3(0, 0, 0)));
                Same(world.Bodies().Length, 0);  // the body without its collider is gone, too
                Support throws = (p, d) => { throw new InvalidOperationException("no"); };
                Fails(Raw.CAROM_E_PLUGIN_INVALID, () => engine.Plugin("test.throws", throws));
                Same(Fails(Raw.CAROM_E_PLUGIN_INVALID, () => engine.Plugin("test.dent", (p, d) => new Vec3(-d.X, d.Y, d.Z))).Witness.Length, 2);
            }
        }

        private static void TestWhatIsDisposedIsRefused()
        {
            var engine = new Engine(2);
            World world = engine.World();
            world.Ground(0);
            engine.Dispose();  // the world keeps it
            world.Step(Dt);
            Same(world.Bodies().Length, 1);
            world.Dispose();
            world.Dispose();
            try
            {
                world.Step(Dt);
            }
            catch (ObjectDisposedException)
            {
                return;
            }
            throw new InvalidOperationException("a disposed world stepped");
        }

        private static void TestArraysOfBodies()
        {
            using (var engine = new Engine())
            using (World world = engine.World())
            {
                ulong shape = engine.Shape("sphere", 0.5);
                Body[] made = Enumerable.Range(0, 100).Select(i => world.Body(shape, new Vec3(2.0 * i, 1, 0))).ToArray();
                var positions = new Vec3[100];
                var poses = new Pose[100];
                world.Positions(positions);
                world.Poses(poses);
                ulong[] handles = world.Bodies();
                for (int i = 0; i < 100; i++)
                {
                    Same(handles[i], made[i].Handle);
                    Same(positions[i], new Vec3(2.0 * i, 1, 0));
                    Same(made[i].Pose.Position, made[i].Position);
                    Same(poses[i].Position, positions[i]);
                    Same(poses[i].Orientation, Quat.Identity);
                }
                world.Write<Vec3>(Raw.CAROM_FIELD_POSITION, new[] { handles[0] }, new[] { new Vec3(0, 9, 0) });
                Same(made[0].Position, new Vec3(0, 9, 0));
                var turns = new Quat[2];
                world.Read<Quat>(Raw.CAROM_FIELD_ORIENTATION, new[] { handles[5], handles[3] }, turns);
                Same(turns[1], Quat.Identity);
                Fails(Raw.CAROM_E_OUT_OF_RANGE, () => world.Positions(new Vec3[99]));
                Fails(Raw.CAROM_E_OUT_OF_RANGE, () => world.Read<Vec3>(Raw.CAROM_FIELD_POSITION, new[] { handles[0] }, new Vec3[2]));
                Fails(Raw.CAROM_E_BUFFER_TOO_SMALL, () => world.Read<double>(Raw.CAROM_FIELD_POSITION, default(ReadOnlySpan<ulong>), new double[100]));
                Fails(Raw.CAROM_E_BUFFER_TOO_SMALL, () => world.Write<Vec3>(Raw.CAROM_FIELD_POSE, new[] { handles[0] }, new Vec3[1]));
                Fails(Raw.CAROM_E_UNKNOWN_ENUM, () => world.Read<double>(99, default(ReadOnlySpan<ulong>), new double[100]));
            }
        }

        private static ulong Run(World world)
        {
            for (int i = 0; i < 30; i++) world.Step(Dt);
            return world.Hash();
        }

        private static void TestACopyAndSavedBytesGoOnAlike()
        {
            using (var engine = new Engine())
            using (World world = engine.World())
            {
                world.Ground(0);
                Body box = world.Body(engine.Shape("box", 0.5, 0.5, 0.5), new Vec3(0, 0.7, 0));
                box.Pose = new Pose(box.Position, new Quat(0, 0.6, 0, 0.8));
                box.SetVelocity(new Vec3(0.1, 0, 0), new Vec3(1, 2, 3));
                Same(box.LinearVelocity, new Vec3(0.1, 0, 0));
                box.AddForce(new Vec3(1, 0, 0), new Vec3(0, 1, 0));
                Same(box.Pose.Orientation, new Quat(0, 0.6, 0, 0.8));
                byte[] saved = world.Save(Raw.CAROM_SNAPSHOT_STATE);
                using (World copy = world.Fork())
                {
                    ulong after = Run(world);
                    Same(Run(copy), after);
                    Same(world.Contacts().Length > 0 && Math.Abs(world.Contacts()[0].Normal.Y) > 0.9, true);
                    world.Restore(saved);
                    Same(Run(world), after);
                }
                Fails(Raw.CAROM_E_CORRUPT, () => world.Restore(new byte[] { 1, 2, 3 }));
            }
        }

        private static void TestAHullOfShapes()
        {
            using (var engine = new Engine())
            using (World world = engine.World())
            {
                ulong ball = engine.Shape("sphere", 0.25);
                ulong sweep = engine.HullOf(new[] { ball, ball }, new[] { new Vec3(0, -1, 0), new Vec3(0, 1, 0) });
                ShapeInfo info = ShapeInfo.New();
                Raw.carom_shape_get_info(engine, sweep, ref info);
                double capsule = Math.PI * 0.0625 * (2 + 4.0 / 3 * 0.25);
                Same(info.VolumeMin <= capsule && capsule <= info.VolumeMax, true);
                Fails(Raw.CAROM_E_OUT_OF_RANGE, () => engine.HullOf(new[] { ball }, new Vec3[2]));
                Fails(Raw.CAROM_E_INVALID_HANDLE, () => engine.HullOf(new ulong[] { 1 }, new Vec3[1]));
            }
        }

        private static void TestWorldsStepOnManyThreads()
        {
            using (var engine = new Engine())
            {
                ulong box = engine.Plugin("test.box", (p, d) => new Vec3(d.X < 0 ? -p[0] : p[0], d.Y < 0 ? -p[0] : p[0], d.Z < 0 ? -p[0] : p[0]),
                    ("half", "m", 1e-6, 1e3));
                var hashes = new ulong[4];
                Thread[] threads = Enumerable.Range(0, hashes.Length).Select(mine => new Thread(() =>
                {
                    using (World world = engine.World())
                    {
                        world.Ground(0);
                        world.Body(engine.Shape(box, 0.5), new Vec3(0, 0.6, 0));
                        hashes[mine] = Run(world);
                    }
                })).ToArray();
                foreach (Thread thread in threads) thread.Start();
                foreach (Thread thread in threads) thread.Join();
                foreach (ulong hash in hashes) Same(hash == hashes[0] && hash != 0, true);
            }
        }

        /// <summary>Each function is in the library, and refuses NULL.</summary>
        private static void TestEveryFunctionIsThere()
        {
            int called = 0;
            using (var engine = new Engine())
            using (World world = engine.World())
                foreach (MethodInfo method in typeof(Raw).GetMethods(BindingFlags.Static | BindingFlags.Public))
                {
                    if (!method.Name.StartsWith("carom_") || method.Name == "carom_engine_destroy" || method.Name == "carom_world_destroy") continue;
                    if ((method.Attributes & MethodAttributes.PinvokeImpl) == 0 && method.ReturnType != typeof(string)) continue;  // over one that is
                    object[] arguments = method.GetParameters().Select(p => p.ParameterType == typeof(Engine) ? engine
                        : p.ParameterType == typeof(World) ? (object)world : p.ParameterType.IsValueType ? Activator.CreateInstance(p.ParameterType) : null).ToArray();
                    try
                    {
                        method.Invoke(null, arguments);
                    }
                    catch (TargetInvocationException e) when (e.InnerException is ArgumentNullException)
                    {
                    }
                    called++;
                }
            Same(called > 200, true);
        }

        private static void TestAnotherLibraryIsRefused()
        {
            const string ours = Raw.Layout;
            Raw.carom_abi_check(ours);
            foreach (string other in new[] { "0.0.1", "0.99.0", "99.0.0" })
                Same(Fails(Raw.CAROM_E_UNSUPPORTED, () => Raw.carom_abi_check(ours.Replace("carom " + Raw.Version, "carom " + other)))
                    .Message.Contains($" is of version {Raw.Version}, its caller of {other}"), true);
            string row = ours.Split('\n').First(line => line.StartsWith("carom_contact.separation "));
            Same(Fails(Raw.CAROM_E_UNSUPPORTED, () => Raw.carom_abi_check(ours.Replace(row, "carom_contact.separation 4 8 f64")))
                .Message.Contains(row.Replace("separation ", "separation as ")), true);
            Same(Fails(Raw.CAROM_E_UNSUPPORTED, () => Raw.carom_abi_check(ours + "carom_contact.mood 0 8 f64\n")).Message.Contains("has no carom_contact.mood"), true);
        }

        /// <summary>65,535 engines and worlds may be alive in a process: more than that are made here, and given back.</summary>
        private static void TestNothingIsLeftAlive()
        {
            for (int i = 0; i < 33000; i++)
                using (var engine = new Engine())
                using (World world = engine.World())
                    Same(world.Bodies().Length, 0);
            for (int i = 0; i < 2000; i++) new Engine().World();  // forgotten: the collector gives them back
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }
}

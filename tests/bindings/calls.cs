using System;
using System.Diagnostics;
using Carom;

/// <summary>calls.c by way of the package.</summary>
internal static class Calls
{
    private static double Timed(int n, Action<int> each)
    {
        Stopwatch watch = Stopwatch.StartNew();
        for (int i = 0; i < n; i++) each(i);
        return watch.Elapsed.TotalMilliseconds * 1e6 / n;
    }

    private static void Main()
    {
        using (var engine = new Engine())
        using (World world = engine.World())
        {
            ulong shape = engine.Shape("sphere", 0.5);
            var bodies = new Body[10000];
            for (int i = 0; i < bodies.Length; i++) bodies[i] = world.Body(shape, new Vec3(2.0 * i, 0, 0));
            var positions = new Vec3[bodies.Length];
            double single = double.MaxValue, bulk = double.MaxValue, sum = 0;
            for (int round = 0; round < 7; round++)  // the first rounds are compiled as they run
            {
                single = Math.Min(single, Timed(200000, i => sum += bodies[i % bodies.Length].Position.X));
                bulk = Math.Min(bulk, Timed(100, i => world.Positions(positions)));
            }
            if (sum <= 0 || positions[1].X != 2) throw new InvalidOperationException("it did not read");
            Console.WriteLine(FormattableString.Invariant($"{single:F1} {bulk:F0}"));
        }
    }
}

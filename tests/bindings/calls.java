import carom.*;
import java.util.function.IntConsumer;

/** calls.c by way of the package. */
final class calls {
    static double timed(int n, IntConsumer each) {
        long start = System.nanoTime();
        for (int i = 0; i < n; i++) each.accept(i);
        return (double) (System.nanoTime() - start) / n;
    }

    static double sum;

    public static void main(String[] arguments) {
        try (Engine engine = new Engine(); World world = engine.world()) {
            long shape = engine.shape("sphere", 0.5);
            var bodies = new Body[10000];
            for (int i = 0; i < bodies.length; i++) bodies[i] = world.body(shape, new Vec3(2.0 * i, 0, 0));
            double[] positions = new double[3 * bodies.length];
            double single = Double.MAX_VALUE, bulk = Double.MAX_VALUE;
            for (int round = 0; round < 7; round++) { // the first rounds are compiled as they run
                single = Math.min(single, timed(200000, i -> sum += bodies[i % bodies.length].position().x()));
                bulk = Math.min(bulk, timed(100, i -> world.positions(positions)));
            }
            if (sum <= 0 || positions[3] != 2) throw new AssertionError("it did not read");
            System.out.printf(java.util.Locale.ROOT, "%.1f %.0f%n", single, bulk);
        }
    }
}

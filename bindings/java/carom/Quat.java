// Written by bindings/gen/generate from include/carom; do not edit.
package carom;

/** A rotation, of unit length. */
public record Quat(double x, double y, double z, double w) {
    public static final Quat IDENTITY = new Quat(0, 0, 0, 1);

    static Quat of(double[] numbers) { return new Quat(numbers[0], numbers[1], numbers[2], numbers[3]); }
}

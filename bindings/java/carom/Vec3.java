// Written by bindings/gen/generate from include/carom; do not edit.
package carom;

public record Vec3(double x, double y, double z) {
    static Vec3 of(double[] numbers) { return new Vec3(numbers[0], numbers[1], numbers[2]); }
}

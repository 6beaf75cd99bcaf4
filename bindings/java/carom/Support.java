package carom;

/** A shape written in Java: the farthest point along a direction. Raw.carom_support_fn says what it must keep to. */
@FunctionalInterface
public interface Support {
    /** @param params of the shape  @param direction of any positive length  @return m, in the shape's frame. What it throws is a fault of the shape */
    Vec3 farthest(double[] params, Vec3 direction);

    /** A parameter: a value outside [min, max] is refused when a shape is made. Unit: "m", or "1" of a number without a dimension. */
    record Param(String name, String unit, double min, double max) {}
}

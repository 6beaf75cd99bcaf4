// Written by bindings/gen/generate from include/carom; do not edit.
package carom;

/** A body's place, m, and its orientation. */
public record Pose(Vec3 position, Quat orientation) {}

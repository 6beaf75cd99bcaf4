using System;

namespace Carom
{
    public struct Vec3 : IEquatable<Vec3>
    {
        public double X, Y, Z;
        public Vec3(double x, double y, double z) { X = x; Y = y; Z = z; }
        public bool Equals(Vec3 o) => X == o.X && Y == o.Y && Z == o.Z;
        public override bool Equals(object o) => o is Vec3 && Equals((Vec3)o);
        public override int GetHashCode() => (X, Y, Z).GetHashCode();
        public override string ToString() => $"({X}, {Y}, {Z})";
    }

    public struct Quat : IEquatable<Quat>
    {
        public double X, Y, Z, W;
        public static readonly Quat Identity = new Quat(0, 0, 0, 1);
        public Quat(double x, double y, double z, double w) { X = x; Y = y; Z = z; W = w; }
        public bool Equals(Quat o) => X == o.X && Y == o.Y && Z == o.Z && W == o.W;
        public override bool Equals(object o) => o is Quat && Equals((Quat)o);
        public override int GetHashCode() => (X, Y, Z, W).GetHashCode();
        public override string ToString() => $"({X}, {Y}, {Z}, {W})";
    }

    /// <summary>A record of Raw.CAROM_FIELD_POSE.</summary>
    public struct Pose
    {
        public Vec3 Position;
        public Quat Orientation;
        public Pose(Vec3 position, Quat orientation) { Position = position; Orientation = orientation; }
    }

    /// <summary>A parameter of a kind of shape: a value outside [Min, Max] is refused when a shape is made. Unit: "m", or "1".</summary>
    public struct ShapeParam
    {
        public string Name, Unit;
        public double Min, Max;
        public ShapeParam(string name, string unit, double min, double max) { Name = name; Unit = unit; Min = min; Max = max; }
    }

    /// <summary>A shape written in C#: its farthest point along a direction of any length. Carom.carom_support_fn says what it must keep to.
    /// What it throws is a fault of the shape.</summary>
    public delegate Vec3 Support(ReadOnlySpan<double> parameters, Vec3 direction);
}

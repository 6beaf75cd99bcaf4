// Equations of motion that mechanisms of accuracy scenes are judged by: Bricard's, the governor, the heavy top, a wheel
// that leans, a cone on a slope, a ladder.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace carom::tools::accuracy {

/// One step of the classical fourth-order method.   @param rate  state -> its derivative
template <typename State, typename Rate>
State runge_kutta(const State& x, double h, const Rate& rate) {
  const State k1 = rate(x), k2 = rate(x + h / 2 * k1), k3 = rate(x + h / 2 * k2), k4 = rate(x + h * k3);
  return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

/// Bricard's mechanism of six bars of 1 m along edges of a cube, the last held: bars meet in hinges square to both, the
/// hinges at a bar's ends are square to each other. It has one way to move, though Gruebler's count leaves none: turns
/// at its corners are theta and phi in turn, and (1 + cos theta) (1 + cos phi) = 1, the closure of Bricard's trihedral
/// linkage. So cos theta = 2^(sin s) - 1 and cos phi = 2^(-sin s) - 1 go all the way round as s does.
struct BricardPose {
  struct Bar {
    Eigen::Vector3d middle, middle_rate;  ///< m, and m per unit of s
    Eigen::Matrix3d axes;                 ///< along, hinge at its beginning, square to both
    Eigen::Vector3d turn_rate;            ///< rad per unit of s, world
  };
  std::array<Bar, 5> bars;
  Eigen::Vector3d end;       ///< m, where the last of them ends: (0, 0, 1)
  Eigen::Vector3d end_axis;  ///< of the hinge that would be at the beginning of the held bar
};
BricardPose bricard(double s);

/// Square bars of 1 kg under gravity along -y, let go at s = 0: (s, ds/dt).
struct BricardMotion {
  static constexpr double kThick = 0.1;  ///< m
  static Eigen::Vector3d inertia();      ///< kg m^2, along the bar and across
  static double mass_of(double s);       ///< kg m^2: twice the kinetic energy over (ds/dt)^2
  static double height_of(double s);     ///< m: potential energy over g
  static Eigen::Vector2d rate(const Eigen::Vector2d& state);
};

/// Watt's governor with sprung couplers, A05 of the IFToMM library: a shaft that spins freely, two arms of 1 m hinged
/// to its head with balls at their ends, a slider on the shaft that springs and dampers hold to the middles of the
/// arms.
struct Governor {
  static constexpr double kHead = 1, kOff = 0.05;        ///< m: hinges above the foot, and from the axis
  static constexpr double kRod = 0.3, kBall = 5;         ///< kg, of an arm
  static constexpr double kSlider = 3, kShaft = 0.3;     ///< kg
  static constexpr double kStiff = 8e5, kDamp = 4e4;     ///< N/m, N s/m
  static constexpr double kRest = 0.5;                   ///< m
  static constexpr double kAngle = 0.52359877559829887;  ///< rad, of the arms below the horizontal at first
  static constexpr double kSpin = 6.283185307179586;     ///< rad/s at first
  static Eigen::Vector3d rod_inertia();                  ///< kg m^2 about its middle, along and across
  static double around(double angle);                    ///< kg m^2: of all about the axis
  /// angle, its rate, the slider's height, its rate
  static Eigen::Vector4d start() { return {kAngle, 0, 0.5, 0}; }
  static Eigen::Vector4d rate(const Eigen::Vector4d& state);
};

/// A disk of 1 kg whose middle is l from a point of its axis that stays, under gravity along -y: (theta, theta', phi),
/// theta between the axis and the upright, phi how far it has gone round. What spins about the axis and about the
/// upright stays, so that one equation is left.
struct HeavyTop {
  static constexpr double kRadius = 0.5, kThick = 0.1, kArm = 0.5;   ///< m
  static constexpr double kSpin = 40;                                ///< rad/s, about its axis, at first all there is
  static constexpr double axial() { return kRadius * kRadius / 2; }  ///< kg m^2, of the disk about its axis
  static constexpr double across() {                                 ///< likewise, about its middle
    return (3 * kRadius * kRadius + kThick * kThick) / 12;
  }
  /// The axis level, along x.
  static Eigen::Vector3d start();
  static Eigen::Vector3d rate(const Eigen::Vector3d& state);
  static Eigen::Vector3d middle(const Eigen::Vector3d& state);  ///< m, of the disk, from the point that stays
};

/// An arm of two links in an upright plane that carries a load, let go level and straight. At its shoulder and its elbow
/// drives of fixed gains pull it to where, sagging under gravity along -y, its hand is at a mark. (shoulder, elbow and their
/// rates): angles of the links above the level.
struct ReachingArm {
  static constexpr double kUpper = 1, kFore = 0.9;        ///< m
  static constexpr double kUpperMass = 8, kForeMass = 4;  ///< kg, of thin rods
  static constexpr double kShoulder = 0.9;                ///< m, above the ground
  static constexpr double kStiff[2] = {2000, 800};        ///< N m/rad: shoulder, elbow
  static constexpr double kDamp[2] = {300, 80};           ///< N m s/rad
  static constexpr double kRadius = 0.1;                  ///< m, of the load, a ball about the hand
  static constexpr double kAtMark[2] = {1.0, -0.6};       ///< rad, at the mark

  double load;                                                 ///< kg
  std::array<double, 2> targets() const;                       ///< rad: of the drives, the elbow's from the upper arm
  Eigen::Vector4d rate(const Eigen::Vector4d& state) const;    ///< @oracle its energy, and where it rests
  static Eigen::Vector3d elbow(double shoulder);               ///< m, world
  static Eigen::Vector3d hand(double shoulder, double elbow);  ///< m, world
};

/// A wheel that rolls round on level ground and leans, its axis at a constant angle to the vertical; a uniform disk.
struct TurningWheel {
  double radius, half;                ///< m; half its thickness
  double lean, round;                 ///< rad, of its axis from the vertical, in (0, pi/2); rad/s about the vertical
  Eigen::Vector3d axis() const;       ///< as it begins: it leans towards +x
  Eigen::Vector3d to_ground() const;  ///< m, from its middle to the point that touches
  Eigen::Vector3d spin(
      double g) const;  ///< rad/s, as it begins: the one with which it goes on so   @oracle its laws of motion
  Eigen::Vector3d velocity(double g) const { return -spin(g).cross(to_ground()); }
};

/// A uniform cone of 1 kg that lies on a slope and rolls about its apex. (angle, rate): of its axis, from straight down.
struct SlopeCone {
  double height, half_angle, slope;  ///< m, rad, rad
  double inertia() const;  ///< kg m^2, about its apex for its rate about the slope's normal   @oracle its energy
  Eigen::Vector2d rate(const Eigen::Vector2d& state, double g) const;
};

/// A uniform rod of 1 kg with round ends that slides down a smooth wall, the plane x = 0, and a smooth floor, y = 0.
struct Ladder {
  double half, radius;  ///< m
  double inertia() const { return half * half / 3; }

  /// On both, x = radius + half cos a and y = radius + half sin a; the wall bears x'', and comes off when that is 0.
  /// Then x' stays, and the floor alone turns it.   @oracle its energy
  class Motion {
   public:
    explicit Motion(double from) : state_(from, 0) {}
    void step(const Ladder& ladder, double h, double g);
    double angle() const { return state_.x(); }
    double rate() const { return state_.y(); }
    bool is_off() const { return is_off_; }
    Eigen::Vector3d middle(const Ladder& ladder) const;    ///< m
    Eigen::Vector3d velocity(const Ladder& ladder) const;  ///< m/s

   private:
    Eigen::Vector2d state_;
    bool is_off_ = false;
    double x_ = 0, x_rate_ = 0;
  };
};

}  // namespace carom::tools::accuracy

// Closed forms that accuracy scenes are judged by. SI units; heights are of a ball's lowest point above the ground.
#pragma once

namespace carom::tools::accuracy {

inline constexpr double kGravity = 9.81;  ///< m/s^2, that of a new world

/// Where something is along one axis, and how fast.
struct Course {
  double way, speed;  ///< m from the start, m/s
};
/// Thrown with a speed into still air whose drag is `rate` times it, pulled by g along the axis.
/// @param rate  1/s: kg/s over kg
Course thrown_into_air(double t, double speed, double rate, double g);
/// Fallen from rest through air whose drag is `rate` times the square of the speed: v_t tanh(g t / v_t).
/// @param rate  1/m: kg/m over kg
Course fallen_through_air(double t, double rate, double g);

/// Height of a ball that was let go at `drop` and bounces with restitution e: below 1 until it lies, as the sum of
/// flights is finite; at 1 for ever.
/// @param t s, >= 0   @param drop m   @return m
double bounce_height(double t, double drop, double e, double g);
/// When bounce_height() is above `level` for the last time, s.   @param level m, in (0, drop)
double bounce_last_above(double level, double drop, double e, double g);

/// How far a block slides on level ground: v^2 / (2 mu g).
double stopping_distance(double speed, double mu, double g);
/// How far a block that starts at rest has slid down a slope after t: g (sin - mu cos) t^2 / 2; mu below tan.
double slope_distance(double t, double mu, double sine, double cosine, double g);

/// Accelerations of a plate that is pulled over rough ground and of the solid balls that roll on it, m/s^2, along the
/// pull. The ground takes mu (M + n m) g; each ball is driven by friction f alone: m a = f, and because it rolls,
/// the plate moves at 7/2 f/m.
struct RollingPlate {
  double plate, ball;
};
/// @param pull N   @param mu of plate on ground   @param plate_mass, ball_mass kg
RollingPlate rolling_plate(double pull, double mu, double plate_mass, double ball_mass, int balls, double g);

/// A solid ball that lands without spin and slides until it rolls.
struct Skid {
  double onset;        ///< s, when it begins to roll: 2 v0 / (7 mu g)
  double final_speed;  ///< m/s: 5/7 v0
};
Skid skid(double speed, double mu, double g);

/// Speeds (up is positive) just after a light ball that lies on a heavy one has hit the ground with it at `speed`, all
/// impacts elastic and one after the other: heavy with ground, then heavy with light.
struct Rebound {
  double heavy, light;
};
Rebound cannon(double speed, double mass_ratio);

/// How far something is from the place where it turns round, on either side of that moment the same side: it comes from
/// `way` with `speed`, and leaves with e times as much.   @param t s, >= 0   @param way m   @return m
double turned_back(double t, double way, double speed, double e);

/// A rod that spins freely about its middle and meets a post with the face of one arm, without loss or friction.
struct HitRod {
  double stop;  ///< rad, of its axis from the post: sin = (half thickness + post's radius) / distance
  double spin;  ///< rad/s, afterwards, of a uniform bar with square ends
};
/// @param spin rad/s   @param half, thin m, half extents   @param post m, its radius   @param away m, from the middle
HitRod hit_rod(double spin, double half, double thin, double post, double away);

/// A coin on its rim (Euler's disk) whose middle stays: it rolls round on a circle as large as itself, ever faster.
/// @param tilt  rad, between its face and the ground, in (0, pi/2)
struct Coin {
  double radius, half;  ///< m; half its thickness
  /// rad/s: how fast the point that touches goes round.
  double round(double tilt, double g) const;
  /// J, per kg: what it has above lying flat.
  double energy(double tilt, double g) const;
  /// m^2/s^2 per s and kg: what a moment of `rolling` m times its weight takes.
  double loss(double tilt, double rolling, double g) const;
  /// s, from one tilt to a smaller one, both slow against going round.
  double time_between(double tilt, double smaller, double rolling, double g) const;
  double tilt_of(double energy, double g) const;  ///< rad
};

/// How thick the thinnest half circle of equal stones is that stands on level ground, over its mean radius: a line of
/// thrust just fits into it. Stones are straight between joints that point at the middle; thrust leaves a joint within
/// its cone of friction.   @param mu  at least 0.5: with less it slides before it is thin   @oracle its collapse by hinges
double least_arch(int stones, double mu);

/// rad/s: a uniform ball that rolls on a level table which turns at `rate` goes round at this, on a circle.
constexpr double turntable_round(double rate) { return 2.0 / 7 * rate; }

/// A thin rod, 1 kg, that stands on its lower end and leans by `angle` from the ground, while that end slides over
/// ground of friction mu away from where the rod leans to.
struct LeaningRod {
  double half, thin;  ///< m, half extents
  double angle;       ///< rad
  double x() const;   ///< m, of the end from the middle; y likewise
  double y() const;
  double inertia() const;  ///< kg m^2
  /// What a normal force of 1 N gives the end along the normal while it slides and drags friction with it, 1/kg. Below
  /// 0 no force holds it (Painleve): the one solution of a step, however short, is that the end stops.
  double yields(double mu) const;
  /// rad/s: once the end has stopped from `speed`, m/s.
  double spin_after(double speed) const;
};

}  // namespace carom::tools::accuracy

// Angles of joints that count whole turns.
#include "dynamics/joint/turns.h"

#include <algorithm>

#include "core/wide_angle.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"

namespace carom::dynamics {
namespace {

/// rad: what a host moves no farther beyond a limit has been pushed there, and is led back. What it moves farther has
/// been put somewhere else. Larger: a body that is reset is turned back by the stop; smaller: rounding of a pose that a
/// host reads and sets again may count as a turn.
constexpr Real kPushedBeyond = 0.1;
constexpr Real kTold = 1e-5;          // rad: a swing that is less than that off whole turns has no direction of its own
constexpr Real kNoDirection = 1e-12;  // sine of an angle between axes below which a swing has no direction
/// rad: what turns by less in a substep is nearest to where it was, whatever its velocity.

Real beyond(Real x, Real lower, Real upper) { return std::max({lower - x, x - upper, Real(0)}); }

/// Of the same pose, the nearest angle within limits, or the one that is least beyond them.
Real within(Real angle, Real lower, Real upper) {
  const bool above = angle > upper;
  const Real turns = above ? -std::ceil((angle - upper) / kWholeTurn) : std::ceil((lower - angle) / kWholeTurn);
  const Real near = angle + kWholeTurn * turns, far = near + (above ? kWholeTurn : -kWholeTurn);
  return beyond(far, lower, upper) < beyond(near, lower, upper) ? far : near;
}

struct Bounds {
  Vec3 lower = Vec3::constant(-kInfinity), upper = Vec3::constant(kInfinity);
};
/// Between what the angles of a joint are held.
Bounds bounds_of(const World& world, const Joint& joint) {
  Bounds b;
  const JointLimit& limit = joint.drive[static_cast<std::size_t>(Coordinate::twist)].limit;
  if (limit.on) b.lower.x() = limit.lower, b.upper.x() = limit.upper;
  const JointAxes& axes = world.joints.axes_of(joint);
  for (int k = 0; k < 3; ++k) {
    const JointAxis& a = axes.axis[kPlaces + static_cast<std::uint32_t>(k)];
    if (a.mode == AxisMode::free) continue;
    b.lower[k] = std::max(b.lower[k], a.lower), b.upper[k] = std::min(b.upper[k], a.is_locked() ? a.lower : a.upper);
  }
  return b;
}

SwingPlane plane_of(const World& world, const Joint& joint) {
  return joint.axes ? swing_plane(world.joints.axes_of(joint)) : SwingPlane::none;
}

Quat apart(const JointEnds& ends) { return ends.a.q.conjugate() * ends.b.q; }

/// Angles of the same pose within limits, where others are farther beyond them than is allowed.
Vec3 led_within(const Vec3& told, Vec3 at, const Bounds& b, SwingPlane plane, const Vec3& allowed) {
  const auto one = [&](int k) {
    if (beyond(at[k], b.lower[k], b.upper[k]) > allowed[k]) at[k] = within(at[k], b.lower[k], b.upper[k]);
  };
  one(0);
  if (plane == SwingPlane::about_y) one(1);
  if (plane == SwingPlane::about_z) one(2);
  if (plane != SwingPlane::none) return at;
  const auto most = [&](const Vec3& x) {
    return std::max(beyond(x[1], b.lower[1], b.upper[1]) - allowed[1],
                    beyond(x[2], b.lower[2], b.upper[2]) - allowed[2]);
  };
  if (most(at) > 0 && most(told) < most(at)) at[1] = told[1], at[2] = told[2];
  return at;
}

Vec3 spin_of_body(const World& world, std::uint32_t body) {
  return body == kInvalid ? Vec3(Vec3::zero()) : world.state.omega[body];
}

Vec3 spin_apart(const World& world, const Joint& joint) {
  return spin_of_body(world, joint.def.body_b) - spin_of_body(world, joint.def.body_a);
}

/// rad: by how much the angles of a joint change in a time, where that may be too much to be seen by poses.
Vec3 ahead_of(const JointEnds& ends, SwingPlane plane, const Vec3& at, const Vec3& w, Real t) {
  if (!(t * t * w.squared_norm() > kNearby * kNearby)) return Vec3::zero();
  return t * rates_of_angles(apart(ends), plane, at, ends.a.q.conjugate() * w);
}

}  // namespace

SwingPlane swing_plane(const JointAxes& axes) {
  const auto at_zero = [&](std::uint32_t k) {
    return axes.axis[k].is_locked() && nearest_turn(axes.axis[k].lower, 0) == 0;
  };
  const bool y = axes.axis[4].is_locked(), z = axes.axis[5].is_locked();
  if (!y && at_zero(5)) return SwingPlane::about_y;
  return !z && at_zero(4) ? SwingPlane::about_z : SwingPlane::none;
}

Vec3 told_angles(const Quat& q, SwingPlane plane) {
  const Vec3 n = q * Vec3::unit_x();
  if (plane == SwingPlane::none) {
    const Real sign = q.w() < 0 ? -1 : 1, twist = 2 * angle_of<double>(sign * q.x(), sign * q.w());
    const Real sine = std::sqrt(n.y() * n.y() + n.z() * n.z()), angle = angle_of<double>(sine, n.x());
    Real y = -n.z(), z = n.y();
    if (sine > kNoDirection)
      y *= angle / sine, z *= angle / sine;
    else if (n.x() < 0)
      y = angle, z = 0;
    return {twist, y, z};
  }
  // q = r twist, with r the turn by the swing about its axis e: c + s e
  const bool y = plane == SwingPlane::about_y;
  const Real sine = y ? -n.z() : n.y(), swing = angle_of<double>(sine, n.x());
  const Real c = std::sqrt(std::max((1 + n.x()) / 2, Real(0))),
             s = std::copysign(std::sqrt(std::max((1 - n.x()) / 2, Real(0))), sine);
  const Real twist_x = y ? c * q.x() - s * q.z() : c * q.x() + s * q.y();
  const Real twist_w = y ? c * q.w() + s * q.y() : c * q.w() + s * q.z(), sign = twist_w < 0 ? -1 : 1;
  const Real off = y ? n.y() : -n.z(), out = angle_of<double>(off, std::sqrt(n.x() * n.x() + sine * sine));
  const Real twist = 2 * angle_of<double>(sign * twist_x, sign * twist_w);
  return y ? Vec3(twist, swing, out) : Vec3(twist, out, swing);
}

Vec3 nearest_angles(const Vec3& told, const Vec3& near, SwingPlane plane) {
  Vec3 at = told;
  at.x() = nearest_turn(told.x(), near.x());
  if (plane == SwingPlane::about_y) at.y() = nearest_turn(told.y(), near.y());
  if (plane == SwingPlane::about_z) at.z() = nearest_turn(told.z(), near.z());
  if (plane != SwingPlane::none) return at;
  // All rotation vectors along one line whose lengths differ by whole turns are one swing. A turn that is whole has any
  // direction.
  const Real angle = std::sqrt(told.y() * told.y() + told.z() * told.z()), whole = angle > kTold ? angle : 0;
  const Vec3 along = angle > kTold ? Vec3(0, told.y(), told.z()) : Vec3(0, near.y(), near.z());
  const Real length = along.norm();
  if (!(length > kTold)) return at;
  const Real counted = nearest_turn(whole, along.dot(near) / length);
  if (counted == whole) return at;
  at.y() = counted * along.y() / length, at.z() = counted * along.z() / length;
  return at;
}

Vec3 rates_of_angles(const Quat& q, SwingPlane plane, const Vec3& at, const Vec3& w) {
  const Vec3 n = q * Vec3::unit_x();
  if (plane != SwingPlane::none) {
    const bool y = plane == SwingPlane::about_y;
    const Vec3 out = n.cross(y ? Vec3::unit_y() : -Vec3::unit_z());
    const Real twist = w.dot(n), off = w.dot(out);
    return y ? Vec3(twist, w.y(), off) : Vec3(twist, off, w.z());
  }
  Real twist = 0;
  const Real turned = q.x() * q.x() + q.w() * q.w();
  if (turned > 0) {
    const Real x = q.w() * w.x() + w.y() * q.z() - w.z() * q.y();          // 2 x'
    const Real scalar = -(w.x() * q.x() + w.y() * q.y() + w.z() * q.z());  // 2 w'
    twist = (q.w() * x - q.x() * scalar) / turned;
  }
  const Vec3 n_rate = w.cross(n);
  const Real sine = std::sqrt(n.y() * n.y() + n.z() * n.z());
  Real grows = 1, grows_rate = 0;  // angle over sine
  if (sine > kNoDirection) {
    const Real sine_rate = (n.y() * n_rate.y() + n.z() * n_rate.z()) / sine;
    const Real angle = (n.y() * at.z() - n.z() * at.y()) / sine, rate = n.x() * sine_rate - sine * n_rate.x();
    grows = angle / sine, grows_rate = (rate - grows * sine_rate) / sine;
  }
  return {twist, -(grows_rate * n.z() + grows * n_rate.z()), grows_rate * n.y() + grows * n_rate.y()};
}

Vec3 counted_angles(const World& world, const Joint& joint, const JointEnds& ends) {
  const SwingPlane plane = plane_of(world, joint);
  const Vec3 told = told_angles(apart(ends), plane), at = nearest_angles(told, joint.turned, plane);
  if (!counts_turns(joint.def.kind)) return told;
  const Bounds b = bounds_of(world, joint);
  Vec3 allowed;
  for (int k = 0; k < 3; ++k) allowed[k] = beyond(joint.turned[k], b.lower[k], b.upper[k]) + kPushedBeyond;
  return led_within(told, at, b, plane, allowed);
}

Vec3 led_angles(const World& world, const Joint& joint, const JointEnds& ends, const Vec3& from, const Vec3& w,
                Real t) {
  const SwingPlane plane = plane_of(world, joint);
  const Vec3 told = told_angles(apart(ends), plane), near = from + ahead_of(ends, plane, from, w, t);
  return near.squared_norm() < kMostCounted * kMostCounted ? nearest_angles(told, near, plane) : told;
}

void count_angles(const World& world, Joint& joint, const Vec3* near, Real dt) {
  if (!counts_turns(joint.def.kind)) return;
  joint.turned = led_angles(world, joint, ends_of(world, joint.def), near ? *near : joint.turned,
                            spin_apart(world, joint), near ? 0 : dt);
}

Vec3 told_angles(const World& world, const Joint& joint) {
  return told_angles(apart(ends_of(world, joint.def)), plane_of(world, joint));
}

void start_count(const World& world, Joint& joint) { joint.turned = told_angles(world, joint); }

void recount(const World& world, Joint& joint) {
  if (!counts_turns(joint.def.kind)) return;
  const SwingPlane plane = plane_of(world, joint);
  const JointEnds ends = ends_of(world, joint.def);
  joint.turned = led_within(told_angles(apart(ends), plane), counted_angles(world, joint, ends),
                            bounds_of(world, joint), plane, Vec3::constant(kWholeTurn / 2));
}

Vec3 turns_ahead(const World& world, const Joint& joint, const Vec3& at, Real t) {
  return ahead_of(ends_of(world, joint.def), plane_of(world, joint), at, spin_apart(world, joint), t);
}

}  // namespace carom::dynamics

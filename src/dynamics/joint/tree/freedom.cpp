// What a joint leaves free, as speeds.
#include "dynamics/joint/tree/freedom.h"

#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/turns.h"

namespace carom::dynamics {
namespace {

/// Of a rotation vector s whose rate is s': omega = s' + a s x s' + b s x (s x s'), in the outer frame, where
///   a = (1 - cos t) / t^2,   b = (t - sin t) / t^3,   t = |s|
/// and their derivatives by z = t^2.
struct SwingTerms {
  Real a, b, a_z, b_z;
};
/// @accuracy  1e-15; derivatives 1e-14
SwingTerms swing_terms(Real z) {
  if (z >= 1) {
    const Real t = std::sqrt(z), sine = sin_cos(t).sin, versine = 2 * sin_cos(t / 2).sin * sin_cos(t / 2).sin;
    return {versine / z, (t - sine) / (z * t), (t * sine - 2 * versine) / (2 * z * z),
            (t * versine - 3 * (t - sine)) / (2 * z * z * t)};
  }
  // a = sum of (-z)^k / (2k + 2)!, b = sum of (-z)^k / (2k + 3)!; by Horner's rule from a term below 1e-20
  SwingTerms s = {0, 0, 0, 0};
  for (int k = 10; k >= 0; --k) {
    const Real next_a = Real((2 * k + 3) * (2 * k + 4)), next_b = Real((2 * k + 4) * (2 * k + 5));
    s.a_z = -(s.a + z * s.a_z) / next_a, s.b_z = -(s.b + z * s.b_z) / next_b;
    s.a = 1 - z * s.a / next_a, s.b = 1 - z * s.b / next_b;
  }
  return {s.a / 2, s.b / 6, s.a_z / 2, s.b_z / 6};
}

/// The same as a map of a rate.
Vec3 turn_of_swing(const SwingTerms& t, const Vec3& s, const Vec3& rate) {
  const Vec3 across = s.cross(rate);
  return rate + t.a * across + t.b * s.cross(across);
}

/// How often a way is in what is left of a vector at right angles to it.
Real along(const Vec3& way, const Vec3& v) {
  const Real squared = way.squared_norm();
  return squared > 0 ? way.dot(v) / squared : 0;
}

}  // namespace

Vec3 omega_of_angles(const Vec3& swing, const Vec3& rates) {
  const Vec3 swings = turn_of_swing(swing_terms(swing.squared_norm()), swing, {0, rates.y(), rates.z()});
  return swings + rates.x() * (exp_map(swing) * Vec3::unit_x());
}

void Freedom::add_swings(const JointAxes& axes, const JointEnds& ends, const Vec3& turned) {
  swings_ = true, to_world_ = ends.a.q, swing_ = {0, turned.y(), turned.z()};
  const SwingTerms terms = swing_terms(swing_.squared_norm());
  const auto is_free = [&](int k) { return !axes.axis[static_cast<std::size_t>(3 + k)].is_locked(); };
  if (is_free(0)) add(3, ends.a.q * (exp_map(swing_) * Vec3::unit_x()));
  for (int k = 1; k < 3; ++k)
    if (is_free(k)) add(3 + k, ends.a.q * turn_of_swing(terms, swing_, Vec3::unit(k)));
}

Vec3 Freedom::turning_bias(const Vec3& omega_a, const Vec3& omega_b, const Real* speeds) const {
  if (last_is_of_b_)
    return speeds[count - 2] * omega_a.cross(way[count - 2]) + speeds[count - 1] * omega_b.cross(way[count - 1]);
  const Vec3 with_a = omega_a.cross(turn(speeds));
  if (!swings_) return with_a;
  Vec3 rate = Vec3::zero();
  Real twist = 0;
  for (int k = places; k < count; ++k) (axis[k] == 3 ? twist : rate[axis[k] - 3]) = speeds[k];
  const SwingTerms terms = swing_terms(swing_.squared_norm());
  const Vec3 across = swing_.cross(rate);
  const Real z_rate = 2 * swing_.dot(rate);
  const Vec3 turns = turn_of_swing(terms, swing_, rate), x = exp_map(swing_) * Vec3::unit_x();
  const Vec3 bends = (z_rate * terms.a_z) * across + (z_rate * terms.b_z) * swing_.cross(across) +
                     terms.b * rate.cross(across) + twist * turns.cross(x);
  return with_a + to_world_ * bends;
}

void Freedom::measure(const Vec3& parting, const Vec3& omega, Real* speeds) const {
  for (int k = 0; k < places; ++k) speeds[k] = way[k].dot(parting);
  if (count - places != 2) {  // none, one, or three at right angles
    for (int k = places; k < count; ++k) speeds[k] = along(way[k], omega);
    return;
  }
  const Vec3 &u = way[places], &v = way[places + 1];
  const Real uu = u.squared_norm(), vv = v.squared_norm(), uv = u.dot(v), det = uu * vv - uv * uv;
  const bool agree = !(det > kEpsilon * uu * vv);
  speeds[places + 1] = agree ? 0 : (uu * v.dot(omega) - uv * u.dot(omega)) / det;
  speeds[places] = along(u, omega - speeds[places + 1] * v);
}

Freedom freedom_of(const World& world, const Joint& joint) {
  const JointEnds ends = ends_of(world, joint.def);
  Freedom f;
  f.from_a = ends.arm_a + ends.apart, f.from_b = ends.arm_b;
  const auto axis_of_a = [&](int k) { return ends.a.q * Vec3::unit(k % 3); };
  const auto add_places = [&](const auto& is_free) {
    for (int k = 0; k < 3; ++k)
      if (is_free(k)) f.add(k, axis_of_a(k)), ++f.places;
  };
  switch (joint.axes ? JointKind::six_axis : joint.def.kind) {
    case JointKind::hinge:
      f.add(3, axis_of_a(3));
      break;
    case JointKind::slider:
      add_places([](int k) { return k == 0; });
      break;
    case JointKind::ball:
      for (int k = 3; k < 6; ++k) f.add(k, axis_of_a(k));
      break;
    case JointKind::universal:
      f.add(4, axis_of_a(4)), f.add(5, ends.b.q * Vec3::unit_z()), f.last_is_of_b_ = true;
      break;
    case JointKind::six_axis: {
      const JointAxes& axes = world.joints.axes_of(joint);
      add_places([&](int k) { return !axes.axis[static_cast<std::size_t>(k)].is_locked(); });
      if (axes.turns_are_free())
        for (int k = 3; k < 6; ++k) f.add(k, axis_of_a(k));
      else
        f.add_swings(axes, ends, counted_angles(world, joint, ends));
      break;
    }
    default:
      break;
  }
  return f;
}

}  // namespace carom::dynamics

// Rows of joints at poses: errors, and their rates.
#pragma once

#include <algorithm>

#include "core/wide_angle.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/turns.h"

namespace carom::dynamics::rattle {

/// Where a body stands, or may stand.
struct Stand {
  const Vec3& x;
  const Quat& q;
  const Mat3& r;
};
inline Stand now(const RattleBody& b) { return {b.x, b.q, b.r}; }
inline Stand next(const RattleBody& b) { return {b.x1, b.q1, b.r1}; }

/// B's frame in A's.
inline Quat apart_of(const RattleJoint& j, const Stand& a, const Stand& b) {
  return (a.q * j.frame_a).conjugate() * (b.q * j.frame_b);
}
/// rad, of the shortest turn.
inline Vec3 turn_of(const Quat& q) {
  const Real sign = q.w() < 0 ? -1 : 1, sine = q.vec().norm();
  return sign * (sine > 1e-12 ? 2 * angle_of<double>(sine, sign * q.w()) / sine : Real(2)) * q.vec();
}

/// A joint between two poses.
struct Placed {
  const RattleJoint& joint;
  const Stand a, b;
  Vec3 r_a, r_b, gap;               // m, world
  Real turned_a = 0, turned_b = 0;  // rad: of a gear, about its axes, since the stage began
  Vec3 near = joint.turned;         // rad: to which its angles are the nearest that the poses tell

  Placed(const RattleJoint& j, const Stand& at_a, const Stand& at_b)
      : joint(j), a(at_a), b(at_b), r_a(a.r * j.arm_a), r_b(b.r * j.arm_b), gap((b.x - a.x) + (r_b - r_a)) {}

  Vec3 axis_a(int k) const { return a.r * joint.axes_a.col(k); }
  Vec3 axis_b(int k) const { return b.r * joint.axes_b.col(k); }

  /// A coordinate that is sprung: what it is, and its rate, as of a row.
  struct Along {
    Real at;  // m or rad
    Vec3 d, w_a, w_b;
  };
  Along coordinate(Coordinate which) const {
    if (joint.two_ways) return ropes();
    const Vec3 x_a = axis_a(0), x_b = axis_b(0);
    switch (which) {
      case Coordinate::twist: {  // as JointPlacing::coordinate() has it
        const Quat t = (a.q * joint.frame_a).conjugate() * (b.q * joint.frame_b);
        const Real sign = t.w() < 0 ? -1 : 1, angle = 2 * angle_of<double>(sign * t.x(), sign * t.w());
        const Vec3 axis = (x_a + x_b) / std::max(1 + x_a.dot(x_b), Real(1e-3));
        return {nearest_turn(angle, near.x()), Vec3::zero(), axis, axis};
      }
      case Coordinate::swing: {
        const Vec3 c = x_a.cross(x_b);
        const Real sine = c.norm();
        const Vec3 axis = sine > 1e-12 ? c / sine : axis_a(1);
        return {angle_of<double>(sine, x_a.dot(x_b)), Vec3::zero(), axis, axis};
      }
      case Coordinate::slide:
        return {x_a.dot(gap), x_a, (r_a + gap).cross(x_a), r_b.cross(x_a)};
      default: {
        const Real far = gap.norm();
        const Vec3 d = far > 1e-12 ? gap / far : x_a;
        return {far, d, (r_a + gap).cross(d), r_b.cross(d)};
      }
    }
  }

  /// The same, its angles with the digits of one turn, not of all that were counted.
  Placed without_whole_turns() const {
    Placed placed = *this;
    placed.near.x() = nearest_turn(near.x(), 0);
    if (joint.plane != SwingPlane::none)
      placed.near.y() = nearest_turn(near.y(), 0), placed.near.z() = nearest_turn(near.z(), 0);
    return placed;
  }

  /// Along both ropes of a pulley. One of no length pulls nowhere.
  Along ropes() const {
    const Vec3 over_b = rope_b();
    const Real far_b = over_b.norm();
    const Vec3 d = far_b > 1e-12 ? (joint.over.ratio / far_b) * over_b : Vec3(Vec3::zero()), d_a = way_at_a();
    return {rope_a().norm() + joint.over.ratio * far_b, d, r_a.cross(d_a), r_b.cross(d)};
  }
  Vec3 rope_a() const { return (a.x - joint.over.anchor_a) + r_a; }
  Vec3 rope_b() const { return (b.x - joint.over.anchor_b) + r_b; }
  /// Where B is pulled along d, A is so along this.
  Vec3 way_at_a() const {
    const Vec3 over = rope_a();
    const Real far = over.norm();
    return far > 1e-12 ? Vec3((-1 / far) * over) : Vec3(Vec3::zero());
  }

  /// Of an axis of six, as JointPlacing::axis() has it.
  Along axis(int k) const {
    if (k < static_cast<int>(kPlaces)) {
      const Vec3 d = axis_a(k);
      return {d.dot(gap), d, (r_a + gap).cross(d), r_b.cross(d)};
    }
    k -= static_cast<int>(kPlaces);
    const Quat q = apart_of(joint, a, b);
    const Vec3 at = nearest_angles(told_angles(q, joint.plane), near, joint.plane);
    Vec3 w;
    for (int i = 0; i < 3; ++i) w[i] = rates_of_angles(q, joint.plane, at, Vec3::unit(i))[k];
    w = a.r * (joint.axes_a * w);
    return {at[k], Vec3::zero(), w, w};
  }
  /// Of what a drive acts along.   @param target  of a turn to an orientation
  Along along(const DriveRow& row, const Quat& target) const {
    if (row.coordinate < kFirstAxis) return coordinate(static_cast<Coordinate>(row.coordinate));
    if (row.coordinate < kFirstTurn) return axis(row.coordinate - kFirstAxis);
    const int k = row.coordinate - kFirstTurn;
    const Vec3 x = axis_a(k);
    return {turn_of(apart_of(joint, a, b) * target.conjugate())[k], Vec3::zero(), x, x};
  }

  /// f(error, d, w_a, w_b) for each row; the three are worked out where f wants them.
  /// @param want_rates  else they are zero
  template <bool want_rates, class F>
  void each(F&& f) const {
    const Vec3 none = Vec3::zero();
    const auto along = [&](const Vec3& d, Real error) {
      if constexpr (want_rates)
        f(error, d, (r_a + gap).cross(d), r_b.cross(d));
      else
        f(error, none, none, none);
    };
    const auto about = [&](const Vec3& axis, Real error) { f(error, none, axis, axis); };
    for (std::uint32_t k = 0; k < joint.parts; ++k) switch (joint.part[k]) {
        case JointPart::point:
          for (int i = 0; i < 3; ++i) {
            const Vec3 e = Vec3::unit(i);
            if constexpr (want_rates)
              f(gap[i], e, (r_a + 0.5 * gap).cross(e), (r_b - 0.5 * gap).cross(e));
            else
              f(gap[i], none, none, none);
          }
          break;
        case JointPart::line:
          for (int i = 1; i < 3; ++i) {
            const Vec3 d = axis_a(i);
            along(d, d.dot(gap));
          }
          break;
        case JointPart::place_x:
        case JointPart::place_y:
        case JointPart::place_z: {
          const Vec3 d = axis_a(static_cast<int>(joint.part[k]) - static_cast<int>(JointPart::place_x));
          along(d, d.dot(gap));
          break;
        }
        case JointPart::rod: {
          const Real far = gap.norm();
          along(far > 1e-12 ? gap / far : axis_a(0), far - joint.length);
          break;
        }
        case JointPart::orientation: {
          const Quat t = (b.q * joint.frame_b) * (a.q * joint.frame_a).conjugate();
          const Real two = t.w() < 0 ? -2 : 2;
          for (int i = 0; i < 3; ++i) about(Vec3::unit(i), two * t.vec()[i]);
          break;
        }
        case JointPart::direction: {
          const Vec3 turn = axis_a(0).cross(axis_b(0));
          for (int i = 1; i < 3; ++i) {
            const Vec3 axis = axis_a(i);
            about(axis, axis.dot(turn));
          }
          break;
        }
        case JointPart::pins: {
          const Vec3 y = axis_a(1), z = axis_b(2);
          about(z.cross(y), y.dot(z));
          break;
        }
        case JointPart::ropes: {
          const Along over = ropes();
          f(over.at - joint.over.length, over.d, over.w_a, over.w_b);
          break;
        }
        case JointPart::gears:
          f(joint.over.phase + turned_a + joint.over.ratio * turned_b, none, -1 * axis_a(0),
            joint.over.ratio * axis_b(0));
          break;
        case JointPart::turn_x: {
          const Along twist = axis(static_cast<int>(kPlaces));
          about(twist.w_b, nearest_turn(twist.at - joint.twist, 0));
          break;
        }
        case JointPart::across_y:
        case JointPart::across_z: {
          const Vec3 across = axis_a(joint.part[k] == JointPart::across_y ? 1 : 2), x = axis_b(0);
          about(x.cross(across), across.dot(x));
          break;
        }
        default:
          break;  // swings that are locked one by one are not held here
      }
  }
};

}  // namespace carom::dynamics::rattle

// The table of kinds, and what follows from it.
#include "dynamics/joint/parts.h"

#include <algorithm>
#include <numbers>

#include "core/wide_angle.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/coupling.h"
#include "dynamics/joint/turns.h"

namespace carom::dynamics {
namespace {

constexpr std::uint32_t bit(Coordinate c) { return 1u << static_cast<std::uint32_t>(c); }

constexpr std::array<KindRow, static_cast<std::size_t>(JointKind::count)> kKinds = {{
    {"ball", 1, {JointPart::point, {}}, bit(Coordinate::twist) | bit(Coordinate::swing)},
    {"hinge", 2, {JointPart::point, JointPart::direction}, bit(Coordinate::twist)},
    {"slider", 2, {JointPart::line, JointPart::orientation}, bit(Coordinate::slide)},
    {"weld", 2, {JointPart::point, JointPart::orientation}, 0},
    {"distance", 1, {JointPart::rod, {}}, bit(Coordinate::distance)},
    {"universal", 2, {JointPart::point, JointPart::pins}, bit(Coordinate::swing)},
    {"pulley", 1, {JointPart::ropes, {}}, bit(Coordinate::distance)},
    {"gear", 1, {JointPart::gears, {}}, 0},
    {"six_axis", 0, {}, 0},  // @see axis_parts.h
    {"coupling", 0, {}, 0},  // @see coupling.h
}};

/// Whether a drive is told by an angle that counts turns. A motor knows of no angle.
bool counts_turns(const DriveRow& row) {
  const std::uint32_t first = kFirstAxis + kPlaces;
  return row.kind != DriveKind::motor && row.kind != DriveKind::pace &&
         (row.coordinate == static_cast<std::uint32_t>(Coordinate::twist) ||
          (row.coordinate >= first && row.coordinate < kFirstTurn));
}

constexpr Real kNoLength = 1e-9;  // m: a rod that has none has no direction; its points just stay together
bool is_point(const Joint& joint) { return joint.def.kind == JointKind::distance && joint.def.length < kNoLength; }

/// A pulley whose anchors are not given holds nothing.
bool is_unstrung(const Joint& joint) { return joint.def.kind == JointKind::pulley && !(joint.transmission.ratio > 0); }

/// What is limited or sprung is no rod, nor are its ropes taut.
bool is_rod(const Joint& joint) {
  const JointDrive& d = joint.drive[static_cast<std::size_t>(Coordinate::distance)];
  return !d.limit.on && !d.spring.on;
}

/// f(coordinate, kind of drive) for all that is on, in the order of rows.
template <class F>
void each_drive(const Joint& joint, F&& f) {
  for (std::uint32_t c = 0; c < kCoordinates; ++c) {
    if (!has(joint.def.kind, static_cast<Coordinate>(c))) continue;
    const JointDrive& d = joint.drive[c];
    if (d.motor.on && !joint.without_motors) f(c, DriveKind::motor);
    if (d.spring.on) f(c, DriveKind::spring);
    if (d.limit.on && !joint.without_limits) f(c, DriveKind::limit);
  }
}

}  // namespace

const KindRow& row_of(JointKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

JointLayout layout_of(const Joints& joints, const Joint& joint) {
  JointLayout layout;
  const KindRow& row = row_of(joint.def.kind);
  layout.two_ways = joint.def.kind == JointKind::pulley;
  if (is_unstrung(joint)) return layout;
  for (std::uint32_t k = 0; k < row.part_count && !joint.axes; ++k) {
    if ((row.part[k] == JointPart::rod || row.part[k] == JointPart::ropes) && !is_rod(joint)) continue;
    const JointPart part = is_point(joint) ? JointPart::point : row.part[k];
    layout.part[layout.parts++] = part;
    layout.equalities += rows_of(part);
  }
  if (joint.axes)
    for (const JointPart part : locked_parts(joints.axes_of(joint)))
      layout.part[layout.parts++] = part, layout.equalities += rows_of(part);
  each_drive(joint, [&](std::uint32_t c, DriveKind kind) {
    layout.drive[layout.drives++] = {static_cast<std::uint8_t>(c), kind};
  });
  add_axis_drives(joints, joint, layout);
  for (std::uint32_t k = 0; k < layout.drives; ++k) layout.counts |= counts_turns(layout.drive[k]);
  return layout;
}

std::uint64_t layout_key(const Joints& joints, const Joint& joint) {
  if (joint.axes) {
    std::uint64_t key = axes_key(joints, joint);
    each_drive(joint, [&](std::uint32_t, DriveKind kind) { key |= kOwnDrive << static_cast<std::uint32_t>(kind); });
    return key;
  }
  std::uint32_t key = static_cast<std::uint32_t>(joint.def.kind) | (is_point(joint) ? 1u << 31 : 0u) |
                      (is_unstrung(joint) ? 1u << 30 : 0u) | (is_coupling(joint.def.kind) ? 1u << 29 : 0u);
  each_drive(joint, [&](std::uint32_t c, DriveKind kind) { key |= 8u << (3 * c + static_cast<std::uint32_t>(kind)); });
  return key | turn_key(joint, kFreeAxes);
}

Spring spring_of(Real frequency, Real damping, Real h) {
  const Real w = 2 * std::numbers::pi * std::min(frequency, 0.25 / h), b = 2 * damping * w * h;
  return {h * w * w / (1 + b), b / (1 + b)};
}

JointEnds ends_of(const World& world, const JointDef& def) {
  const State& s = world.state;
  JointEnds place;
  Vec3 x_a, x_b;
  const auto find = [&](std::uint32_t body, const Pose& frame, Pose& to, Vec3& x, Vec3& arm) {
    if (body == kInvalid) {
      to = frame;
      x = frame.p, arm = Vec3::zero();
      return;
    }
    x = s.x[body], arm = s.q[body] * (frame.p - world.scene.center[body]);
    to = {s.q[body] * frame.q, x + arm};
  };
  find(def.body_a, def.frame_a, place.a, x_a, place.arm_a);
  find(def.body_b, def.frame_b, place.b, x_b, place.arm_b);
  place.apart = (x_b - x_a) + (place.arm_b - place.arm_a);
  return place;
}

Ropes ropes_of(const World& world, const Joint& joint, const JointEnds& ends) {
  const auto from = [&](std::uint32_t body, const Pose& frame) {
    return body == kInvalid ? frame.p : world.state.x[body];
  };
  const JointDef& def = joint.def;
  return {(from(def.body_a, def.frame_a) - joint.transmission.anchor_a) + ends.arm_a,
          (from(def.body_b, def.frame_b) - joint.transmission.anchor_b) + ends.arm_b};
}

std::array<Real, kCoordinates> coordinates_of(const JointEnds& ends) {
  const Quat t = ends.a.q.conjugate() * ends.b.q;
  const Vec3 a = ends.a.q.matrix().col(0), b = ends.b.q.matrix().col(0);
  const Real sign = t.w() < 0 ? -1 : 1, swing = angle_of<double>(a.cross(b).norm(), a.dot(b));
  return {2 * angle_of<double>(sign * t.x(), sign * t.w()), swing, a.dot(ends.apart), ends.apart.norm()};
}

Real coupled_coordinate(const World& world, std::uint32_t slot) {
  const Joint& joint = world.joints.joint[slot];
  const JointEnds ends = ends_of(world, joint.def);
  return is_slide(world, slot) ? coordinates_of(ends)[static_cast<std::size_t>(Coordinate::slide)]
                               : counted_angles(world, joint, ends).x();
}

JointPlace place_of(const World& world, const Joint& joint) {
  JointPlace place{ends_of(world, joint.def), {}};
  const Quat t = place.a.q.conjugate() * place.b.q;
  const Mat3 a = place.a.q.matrix(), b = place.b.q.matrix();
  place.at = coordinates_of(place);
  place.turned = counted_angles(world, joint, place);
  place.at[0] = place.turned.x();
  if (joint.def.kind == JointKind::pulley) {
    const Ropes ropes = ropes_of(world, joint, place);
    place.at[3] = ropes.a.norm() + joint.transmission.ratio * ropes.b.norm();
  }
  if (joint.coupling) {
    const Coupling& coupling = world.joints.coupling_of(joint);
    const Real asked = polynomial_at(coupling, coupled_coordinate(world, coupling.leader)).value;
    const Real off = std::fabs(coupled_coordinate(world, coupling.follower) - asked);
    (is_slide(world, coupling.follower) ? place.gap : place.angle) = off;
  }
  if (joint.axes) place = judge_axes(world.joints.axes_of(joint), place);
  const JointLayout layout = joint.axes ? JointLayout() : layout_of(world.joints, joint);
  for (std::uint32_t k = 0; k < layout.parts; ++k) switch (layout.part[k]) {
      case JointPart::point:
        place.gap = place.apart.norm();
        break;
      case JointPart::line:
        place.gap = (place.apart - place.at[2] * a.col(0)).norm();
        break;
      case JointPart::ropes:
        place.gap = std::fabs(place.at[3] - joint.transmission.length);
        break;
      case JointPart::gears:
        place.angle = std::fabs(joint.transmission.phase);
        break;
      case JointPart::rod:
        place.gap = std::fabs(place.at[3] - joint.def.length);
        break;
      case JointPart::orientation:
        place.angle = 2 * angle_of<double>(t.vec().norm(), std::fabs(t.w()));
        break;
      case JointPart::direction:
        place.angle = place.at[1];
        break;
      case JointPart::pins:
        place.angle = std::fabs(angle_of<double>(a.col(1).dot(b.col(2)), a.col(1).cross(b.col(2)).norm()));
        break;
      case JointPart::place_x:
      case JointPart::place_y:
      case JointPart::place_z:
      case JointPart::turn_x:
      case JointPart::turn_y:
      case JointPart::turn_z:
      case JointPart::across_y:
      case JointPart::across_z:
        break;  // of six-axis joints alone, judged above
    }
  for (std::size_t c = 0; c < kCoordinates; ++c) {
    const JointLimit& limit = joint.drive[c].limit;
    if (!limit.on || !has(joint.def.kind, static_cast<Coordinate>(c))) continue;
    const Real beyond = std::max(limit.lower - place.at[c], place.at[c] - limit.upper);
    Real& error = c < 2 ? place.angle : place.gap;
    error = std::max(error, beyond);
  }
  return place;
}

}  // namespace carom::dynamics

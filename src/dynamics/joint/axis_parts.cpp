// What the axes of a six-axis joint come to in rows, and where they are.
#include "dynamics/joint/axis_parts.h"

#include <algorithm>

#include "core/wide_angle.h"
#include "dynamics/joint/turns.h"

namespace carom::dynamics {
namespace {

constexpr JointPart kAxisAlone[kAxes] = {JointPart::place_x, JointPart::place_y, JointPart::place_z,
                                         JointPart::turn_x,  JointPart::turn_y,  JointPart::turn_z};

/// What stands for the two axes across x, and for all three.
struct AxisParts {
  JointPart two, three;
};
constexpr AxisParts kAxisParts[2] = {{JointPart::line, JointPart::point},
                                     {JointPart::direction, JointPart::orientation}};

/// Of places, at any offset: A's point is moved there. Of turns: all three at any offset, for B's frame is turned; the two
/// across x where x axes stay parallel. One of those two alone, at no offset, keeps the other in a plane.
void add_parts(const JointAxes& axes, std::uint32_t first, LockedParts& parts) {
  const std::array<JointAxis, kAxes>& axis = axes.axis;
  const SwingPlane plane = swing_plane(axes);
  const AxisParts& together = kAxisParts[first / kPlaces];
  const bool x = axis[first].is_locked(), y = axis[first + 1].is_locked(), z = axis[first + 2].is_locked();
  if (x && y && z) return parts.add(together.three);
  const bool parallel = first < kPlaces || (nearest_turn(axis[4].lower, 0) == 0 && nearest_turn(axis[5].lower, 0) == 0);
  if (!x && y && z && parallel) return parts.add(together.two);
  for (std::uint32_t k = first; k < first + kPlaces; ++k)
    if (axis[k].is_locked())
      parts.add(k == 4 && plane == SwingPlane::about_z   ? JointPart::across_z
                : k == 5 && plane == SwingPlane::about_y ? JointPart::across_y
                                                         : kAxisAlone[k]);
}

/// f(source, kind of row) for all that acts along an axis, in the order of rows.
template <class F>
void each_row_of(const JointAxis& a, const Joint& joint, F&& f) {
  if (a.is_locked()) return;
  const bool pulls = a.drive == AxisDrive::position;
  if (a.drive != AxisDrive::none && !joint.without_motors && (!pulls || a.gains.on()))
    f(kOfDrive, pulls ? DriveKind::spring : DriveKind::motor);
  if (a.spring.on()) f(kOfSpring, DriveKind::spring);
  if (a.is_limited() && !joint.without_limits) f(kOfLimit, a.stop.on() ? DriveKind::stop : DriveKind::limit);
  if (a.friction > 0) f(kOfFriction, DriveKind::motor);
  if (a.armature > 0) f(kOfRotor, DriveKind::rotor);
  if (a.is_paced() && !joint.without_limits) f(kOfSpeed, DriveKind::pace);
}

bool turns_as_one(const Joint& joint, const JointAxes& axes) {
  return (joint.def.kind == JointKind::ball || joint.def.kind == JointKind::six_axis) && acts(joint.turn) &&
         axes.turns_are_free();
}

Real root_of_squares(const Real (&v)[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

LockedParts locked_parts(const JointAxes& axes) {
  LockedParts parts;
  add_parts(axes, 0, parts);
  add_parts(axes, kPlaces, parts);
  return parts;
}

AxisOffsets offsets_of(const JointAxes& axes) {
  AxisOffsets off;
  off.all_turns = true;
  for (std::uint32_t k = 0; k < kPlaces; ++k) {
    const JointAxis &place = axes.axis[k], &turn = axes.axis[kPlaces + k];
    if (place.is_locked()) off.place[static_cast<int>(k)] = place.lower;
    if (turn.is_locked())
      off.turn[static_cast<int>(k)] = nearest_turn(turn.lower, 0);
    else
      off.all_turns = false;
  }
  if (off.all_turns) off.orientation = exp_map(Vec3(0, off.turn.y(), off.turn.z())) * exp_map(Vec3(off.turn.x(), 0, 0));
  return off;
}

static_assert(kMostDriveRows == kAxes * kAllAxisSources + 3, "all that acts along axes, and a drive to an orientation");

void add_axis_drives(const Joints& joints, const Joint& joint, JointLayout& layout) {
  const JointAxes& axes = joints.axes_of(joint);
  layout.axed = joint.axes != 0;
  const auto add = [&](std::uint32_t coordinate, DriveKind kind, std::uint8_t source) {
    layout.drive[layout.drives++] = {static_cast<std::uint8_t>(coordinate), kind, source};
  };
  if (layout.axed)
    for (std::uint32_t k = 0; k < kAxes; ++k)
      each_row_of(axes.axis[k], joint, [&](AxisSource source, DriveKind kind) { add(kFirstAxis + k, kind, source); });
  if (!turns_as_one(joint, axes) || joint.without_motors) return;
  layout.axed = true;
  const DriveKind kind = joint.turn.mode == AxisDrive::position ? DriveKind::spring : DriveKind::motor;
  for (std::uint32_t k = 0; k < 3; ++k) add(kFirstTurn + k, kind, kOfDrive);
}

std::uint64_t turn_key(const Joint& joint, const JointAxes& axes) {
  if (!turns_as_one(joint, axes) || joint.without_motors) return 0;
  return std::uint64_t(joint.turn.mode == AxisDrive::position ? 1 : 2) << 60;
}

std::uint64_t axes_key(const Joints& joints, const Joint& joint) {
  constexpr std::uint32_t kBits =
      9;  // of an axis: locked; drive of two kinds; spring; speed; limit of two kinds; friction; rotor
  const JointAxes& axes = joints.axes_of(joint);
  std::uint64_t key = std::uint64_t(1) << 63 | turn_key(joint, axes);
  for (std::uint32_t k = 0; k < kAxes; ++k) {
    const JointAxis& a = axes.axis[k];
    if (a.is_locked()) key |= std::uint64_t(1) << (kBits * k);
    each_row_of(a, joint, [&](AxisSource source, DriveKind kind) {
      const bool is_other = kind == DriveKind::motor || kind == DriveKind::stop;
      const std::uint32_t bit = source == kOfFriction ? 7
                                : source == kOfRotor  ? 8
                                : source == kOfSpeed  ? 4
                                                      : 1 + 2 * source + is_other;
      key |= std::uint64_t(1) << (kBits * k + bit);
    });
  }
  for (const JointPart part : locked_parts(axes)) {
    if (part == JointPart::direction) key |= std::uint64_t(1) << 58;
    if (part == JointPart::across_y || part == JointPart::across_z) key |= std::uint64_t(1) << 59;
  }
  return key;
}

DrivenAxes driven_axes(const Joints& joints, const Joint& joint) {
  const JointAxes& axes = joints.axes_of(joint);
  DrivenAxes any = {false, turns_as_one(joint, axes)};
  for (const JointAxis& a : axes.axis) {
    any.limited |= a.is_limited() || a.is_paced();
    any.driven |= !a.is_locked() && (a.drive != AxisDrive::none || a.friction > 0 || a.armature > 0);
  }
  return any;
}

std::array<Real, kAxes> axes_at(const JointEnds& ends, const Vec3& turned) {
  const Vec3 place = ends.a.q.conjugate() * ends.apart;
  return {place.x(), place.y(), place.z(), turned.x(), turned.y(), turned.z()};
}

JointPlace judge_axes(const JointAxes& axes, JointPlace place) {
  const std::array<Real, kAxes> at = axes_at(place, place.turned);
  Real off[2][3] = {}, beyond[2] = {};
  for (std::uint32_t k = 0; k < kAxes; ++k) {
    const JointAxis& a = axes.axis[k];
    const std::uint32_t group = k / kPlaces;
    if (a.is_locked())
      off[group][k % kPlaces] = k < kPlaces ? at[k] - a.lower : nearest_turn(at[k] - a.lower, 0);
    else if (a.is_limited() && !a.stop.on())
      beyond[group] = std::max({beyond[group], a.lower - at[k], at[k] - a.upper});
  }
  const AxisOffsets offsets = offsets_of(axes);
  place.gap = std::max(root_of_squares(off[0]), beyond[0]);
  Real angle = root_of_squares(off[1]);
  if (offsets.all_turns) {
    const Quat t = (place.a.q.conjugate() * place.b.q) * offsets.orientation.conjugate();
    angle = 2 * angle_of<double>(t.vec().norm(), std::fabs(t.w()));
  }
  place.angle = std::max(angle, beyond[1]);
  return place;
}

}  // namespace carom::dynamics

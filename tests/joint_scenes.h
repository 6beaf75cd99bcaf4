// Scenes of joints for tests of the inside.
#pragma once

#include <vector>

#include "dynamics/joint/parts.h"
#include "dynamics/joint/wide_joints.h"
#include "world_builder.h"

namespace carom::test {

inline constexpr Real kG = 9.81;

/// The solver's own answer to joints: islands that joints alone hold are left to it, too.
inline void leave_joints_to_solver(TestWorld& t) { t.world.set_dial(Dial::joint_order, 0); }

inline void choose(TestWorld& t, int solver, int substeps = 4) {
  t.world.set_dial(Dial::solver, solver);
  t.world.set_dial(Dial::substeps, substeps);
}

/// A body with mass and inertia of its own and no shape.
inline std::uint32_t add_body(TestWorld& t, const Vec3& at, Real mass, const Vec3& inertia,
                              BodyType type = BodyType::dynamic, const Quat& q = Quat::identity()) {
  BodyDef def;
  def.type = type;
  def.pose = {q, at};
  def.has_mass = def.has_inertia = true;
  def.mass = mass;
  def.inertia = Mat3::diagonal(inertia);
  return handle_slot(t.world.add_body(def));
}

/// What joins two bodies as they stand, with its frames at one place of the world.
inline JointDef joint_at(const TestWorld& t, JointKind kind, std::uint32_t a, std::uint32_t b, const Vec3& at,
                         const Quat& axes = Quat::identity()) {
  JointDef def;
  def.kind = kind;
  def.body_a = a, def.body_b = b;
  const Pose frame = {axes, at};
  const auto in = [&](std::uint32_t body) { return body == kInvalid ? frame : t.world.pose(body).inverse() * frame; };
  def.frame_a = in(a), def.frame_b = in(b);
  def.length = 0.25;
  return def;
}
inline std::uint32_t join(TestWorld& t, JointKind kind, std::uint32_t a, std::uint32_t b, const Vec3& at,
                          const Quat& axes = Quat::identity()) {
  return handle_slot(t.world.add_joint(joint_at(t, kind, a, b, at, axes)));
}

inline const Joint& joint(const TestWorld& t, std::uint32_t slot) { return t.world.joints.joint[slot]; }
inline Real coordinate(const TestWorld& t, std::uint32_t slot, Coordinate c) {
  return place_of(t.world, joint(t, slot)).at[static_cast<std::size_t>(c)];
}
inline void set_spring(TestWorld& t, std::uint32_t slot, Coordinate c, Real target, Real frequency, Real damping) {
  JointDrive drive = joint(t, slot).drive[static_cast<std::size_t>(c)];
  drive.spring = {true, target, frequency, damping, kInfinity};
  t.world.set_joint_drive(slot, c, drive);
}
inline void set_limit(TestWorld& t, std::uint32_t slot, Coordinate c, Real lower, Real upper) {
  JointDrive drive = joint(t, slot).drive[static_cast<std::size_t>(c)];
  drive.limit = {true, lower, upper};
  t.world.set_joint_drive(slot, c, drive);
}
inline void set_motor(TestWorld& t, std::uint32_t slot, Coordinate c, Real speed, Real most) {
  JointDrive drive = joint(t, slot).drive[static_cast<std::size_t>(c)];
  drive.motor = {true, speed, most};
  t.world.set_joint_drive(slot, c, drive);
}

/// The x axis of a frame, laid along another axis of the world.
inline Quat x_along(const Vec3& axis) { return turn_between(Vec3(1, 0, 0), axis); }

/// Steps of Newton's method in the last step. Soft contacts count each point twice a substep in the same number.
inline std::uint64_t newton_steps(const TestWorld& t) {
  const bool by_lanes_too = t.world.scene.dials.whole(Dial::solver) == kAutoChoice;
  const auto substeps = static_cast<std::uint64_t>(t.world.scene.dials.whole(Dial::substeps));
  return t.world.report.velocity_impulses - (by_lanes_too ? 2 * substeps * t.world.wide->rows : 0);
}

inline Real energy_of(const TestWorld& t) {
  const Scene& scene = t.world.scene;
  const State& s = t.world.state;
  Real e = 0;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i) {
    const Vec3 w = s.q[i].conjugate() * s.omega[i];
    e += scene.mass[i] * (0.5 * s.v[i].squared_norm() - scene.gravity.dot(s.x[i])) + 0.5 * w.dot(scene.inertia[i] * w);
  }
  return e;
}

inline Real gap_of(const TestWorld& t, std::uint32_t slot) { return place_of(t.world, joint(t, slot)).gap; }
inline Real worst_gap(const TestWorld& t) {
  Real worst = 0;
  for (std::uint32_t j = 0; j < t.world.joints.slots.slots(); ++j) {
    const JointPlace place = place_of(t.world, joint(t, j));
    worst = std::max({worst, place.gap, place.angle});
  }
  return worst;
}

/// Rods in a row along x, hung at the origin, and a ball at the end. @return bodies, the ball last
inline std::vector<std::uint32_t> chain(TestWorld& t, int rods, Real length, Real mass, Real end_mass,
                                        JointKind kind = JointKind::ball) {
  std::vector<std::uint32_t> bodies;
  std::uint32_t before = kInvalid;
  const Real across = mass * length * length / 12, radius = 0.1;
  for (int i = 0; i < rods; ++i) {
    bodies.push_back(add_body(t, Vec3((i + 0.5) * length, 0, 0), mass, Vec3(mass * 1e-3, across, across)));
    join(t, kind, before, bodies.back(), Vec3(i * length, 0, 0));
    before = bodies.back();
  }
  bodies.push_back(
      add_body(t, Vec3(rods * length + radius, 0, 0), end_mass, Vec3::constant(0.4 * end_mass * radius * radius)));
  join(t, kind, before, bodies.back(), Vec3(rods * length, 0, 0));
  return bodies;
}

}  // namespace carom::test

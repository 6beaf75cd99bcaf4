// Every effect with a way to give it one participant and to take that away again, in a world that otherwise calls for
// nothing: the subjects of the proofs in this folder.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/events/events.h"
#include "dynamics/force/force.h"
#include "scenery_builder.h"
#include "world_builder.h"

namespace carom::test {

/// A world of mass points that fly straight on, far from each other, and one body to become a participant.
struct Stage0 {
  static constexpr Real kStep = 1.0 / 64;  // s, so that times are exact

  explicit Stage0(int crowd = 20) : t(Vec3::zero()) {
    World& w = t.world;
    for (int i = 0; i < crowd; ++i) {
      BodyDef def;
      def.pose.p = Vec3(100 + 3 * i, 50, 0);
      def.velocity = Vec3(0, 0, 0.25);
      w.add_body(def);
    }
    BodyDef def;
    def.has_mass = def.has_inertia = true;
    def.mass = 2, def.inertia = Mat3::diagonal(Vec3::constant(0.3));  // isotropic: nothing gyroscopic
    def.velocity = Vec3(0.5, 0, 0), def.omega = Vec3(0, 0, 1);
    one = handle_slot(w.add_body(def));
  }
  /// Things to touch: a ball on the participant, and another that it touches.
  void touching(std::uint32_t material = Colliders::kNoMaterial) {
    ball = t.keep(sphere(0.5));
    t.world.add_collider(one, ball, Pose{}, 1000, material);
    other = t.add(ball, Vec3(0.99, 0, 0), BodyType::dynamic, Quat::identity(), material);
  }
  void apart() {
    while (t.world.scene.first_collider[one] != kInvalid) t.world.remove_collider(t.world.scene.first_collider[one]);
    if (other != kInvalid) t.world.remove_body(std::exchange(other, kInvalid));
  }
  void steps(int n) { t.run(n, kStep); }
  std::uint64_t evaluations(std::size_t row) const { return t.world.plan->effects[row].evaluations; }

  TestWorld t;
  std::uint32_t one, other = kInvalid, other_floor = kInvalid;
  const Shape* ball = nullptr;
  Handle thing = 0;
};

struct Subject {
  std::size_t row;
  std::function<void(Stage0&)> call;     // give it a participant
  std::function<void(Stage0&)> dismiss;  // take it away
  bool flies = true;                     // it acts on bodies in flight, each for itself
  bool spares = flies;                   // who is no participant costs nothing and keeps its bits
};

inline std::vector<Subject> subjects() {
  const auto field = [] {
    FieldDef f;
    f.vector = Vec3(0, 1, 0), f.mask = 2;
    return f;
  };
  const auto hinge = [](Stage0& s) {
    JointDef def;
    def.kind = JointKind::hinge;
    def.body_a = s.one;
    def.frame_b.p = s.t.world.pose(s.one).p;
    s.thing = s.t.world.add_joint(def);
  };
  const auto unhinge = [](Stage0& s) { s.t.world.remove_joint(handle_slot(s.thing)); };
  const auto touch_with = [](const Material& m) {
    return [m](Stage0& s) { s.touching(handle_slot(s.t.world.add_material(m))); };
  };
  const auto part = [](Stage0& s) { s.apart(); };
  Material smooth, bouncy, rolling, spinning;
  smooth.friction = 0;
  bouncy.friction = 0, bouncy.restitution = 1;
  rolling.friction = 0, rolling.rolling = 0.1;
  spinning.friction = 0, spinning.spinning = 0.1;
  const auto set_drag = [](Stage0& s) { s.t.world.set_attribute(s.one, AttributeId::drag, {0.1, 0.1}); };
  const auto unset_drag = [](Stage0& s) { s.t.world.set_attribute(s.one, AttributeId::drag, {}); };
  const auto damp = [](Real BodySettings::*which, Real rate) {
    return [=](Stage0& s) { s.t.world.scene.def[s.one].*which = rate, ++s.t.world.scene.revision; };
  };
  const auto drive = [hinge](Stage0& s, bool limit) {
    hinge(s);
    JointDrive d;
    d.limit.on = limit, d.limit.lower = -0.5, d.limit.upper = 0.5;
    d.motor.on = !limit, d.motor.speed = 1, d.motor.max_force = 5;
    s.t.world.set_joint_drive(handle_slot(s.thing), Coordinate::twist, d);
  };
  return {
      {+EffectId::gyroscopic,
       [](Stage0& s) {
         s.t.world.add_collider(s.one, s.t.keep(box(Vec3(0.1, 0.2, 0.3))), Pose{}, 1000, Colliders::kNoMaterial);
         s.t.world.scene.inertia[s.one] = Mat3::diagonal(Vec3(0.1, 0.2, 0.3));
         s.t.world.scene.inv_inertia[s.one] = s.t.world.scene.inertia[s.one].inverse();
         s.t.world.set_velocity(s.one, Vec3::zero(), Vec3(1, 2, 3));
       },
       [](Stage0& s) {
         s.apart();
         s.t.world.scene.inertia[s.one] = Mat3::identity(), s.t.world.scene.inv_inertia[s.one] = Mat3::identity();
         ++s.t.world.scene.revision;
       }},
      {+EffectId::linear_damping, damp(&BodySettings::linear_damping, 0.5), damp(&BodySettings::linear_damping, 0)},
      {+EffectId::angular_damping, damp(&BodySettings::angular_damping, 0.5), damp(&BodySettings::angular_damping, 0)},
      {+EffectId::scenery,
       [](Stage0& s) {
         s.touching();
         s.other_floor = s.t.add(s.t.keep(mesh(box_surface(Vec3(5, 1, 5)))), Vec3(0, -20, 0), BodyType::fixed);
       },
       [](Stage0& s) { s.t.world.remove_body(s.other_floor); }, false, true},
      {+EffectId::gravity,
       [](Stage0& s) {
         for (std::uint32_t i = 0; i < s.t.world.scene.bodies.slots(); ++i)
           if (i != s.one) s.t.world.set_attribute(i, AttributeId::gravity_factor, {0});
         s.t.world.set_gravity(Vec3(0, -9.81, 0));
       },
       [](Stage0& s) { s.t.world.set_gravity(Vec3::zero()); }},
      {+EffectId::drag, set_drag, unset_drag},
      {+EffectId::wind, [set_drag](Stage0& s) { set_drag(s), s.t.world.set_wind(Vec3(3, 0, 0)); },
       [](Stage0& s) { s.t.world.set_wind(Vec3::zero()); }},
      {+EffectId::fields,
       [field](Stage0& s) {
         s.t.world.set_attribute(s.one, AttributeId::force_field_mask, {Real(2)});
         s.thing = s.t.world.add_field(field());
       },
       [](Stage0& s) { s.t.world.remove_field(handle_slot(s.thing)); }},
      {+EffectId::magnetism,
       [](Stage0& s) {
         FieldDef f;
         f.kind = FieldKind::magnetic, f.vector = Vec3(0, 2, 0), f.mask = 3;
         s.t.world.set_attribute(s.one, AttributeId::magnetic_moment, {3, 0, 1});
         s.thing = s.t.world.add_field(f);
       },
       [](Stage0& s) { s.t.world.remove_field(handle_slot(s.thing)); }},
      {+EffectId::springs,
       [](Stage0& s) {
         SpringDef d;
         d.body_a = s.one, d.anchor_b = Vec3(1, 2, 3), d.rest = 1, d.stiffness = 10;
         s.thing = s.t.world.add_spring(d);
       },
       [](Stage0& s) { s.t.world.remove_spring(handle_slot(s.thing)); }},
      {+EffectId::buoyancy,
       [](Stage0& s) {
         s.t.world.add_collider(s.one, s.t.keep(sphere(0.5)), Pose{}, 1000, Colliders::kNoMaterial);
         s.t.world.set_gravity(Vec3::zero());
         WaterDef water;
         water.drag = 1;
         s.t.world.set_water(&water);
       },
       [](Stage0& s) { s.t.world.set_water(nullptr); }},
      {+EffectId::continuous,
       [](Stage0& s) {
         s.touching();
         s.t.world.set_continuous(s.one, SweepMode::always);
       },
       [](Stage0& s) { s.t.world.set_continuous(s.one, SweepMode::automatic); }, false, true},
      {+EffectId::collision, touch_with(smooth), part, false, true},
      {+EffectId::response, touch_with(smooth), part, false, true},
      {+EffectId::friction, [](Stage0& s) { s.touching(); }, part, false, true},
      {+EffectId::restitution, touch_with(bouncy), part, false, true},
      {+EffectId::rolling_resistance, touch_with(rolling), part, false, true},
      {+EffectId::spinning_resistance, touch_with(spinning), part, false, true},
      {+EffectId::surface_velocity,
       [](Stage0& s) {
         s.touching();
         s.t.world.set_surface_velocity(s.t.world.scene.first_collider[s.one], {Vec3(0, 0, 1), Vec3::zero()});
       },
       part, false, true},
      {+EffectId::filter,
       [](Stage0& s) {
         s.touching();
         Filter f;
         f.category = 2;
         s.t.world.set_filter(s.t.world.scene.first_collider[s.one], f);
       },
       [](Stage0& s) { s.t.world.set_filter(s.t.world.scene.first_collider[s.one], Filter()); }, false, true},
      {+EffectId::sensor,
       [](Stage0& s) {
         s.touching();
         s.t.world.set_sensor(s.t.world.scene.first_collider[s.one], true);
       },
       [](Stage0& s) { s.t.world.set_sensor(s.t.world.scene.first_collider[s.one], false); }, false, true},
      {+EffectId::joints, hinge, unhinge, false, true},
      {+EffectId::joint_limits, [drive](Stage0& s) { drive(s, true); }, unhinge, false, true},
      {+EffectId::joint_motors, [drive](Stage0& s) { drive(s, false); }, unhinge, false, true},
      {+EffectId::axis_locks, [](Stage0& s) { s.t.world.set_attribute(s.one, AttributeId::locks, {Real(1)}); },
       [](Stage0& s) { s.t.world.set_attribute(s.one, AttributeId::locks, {}); }},
      {+EffectId::particles,
       [](Stage0& s) {
         s.thing = s.t.world.particles.create({}, 1);
         s.t.world.particles.extend(handle_slot(s.thing), 1);
       },
       [](Stage0& s) { s.t.world.particles.destroy(handle_slot(s.thing)); }, false, true},
      {+EffectId::events, [](Stage0& s) { collect(s.t.world, Events::contact, 1); },
       [](Stage0& s) { collect(s.t.world, 0, 1); }, false, true},
      {+EffectId::ledger, [](Stage0& s) { s.t.world.keep_ledger(true); },
       [](Stage0& s) { s.t.world.keep_ledger(false); }, false},
      {+EffectId::sleep, [](Stage0& s) { s.t.world.set_dial(Dial::sleep, 1); },
       [](Stage0& s) { s.t.world.set_dial(Dial::sleep, 0); }, false},
  };
}

}  // namespace carom::test

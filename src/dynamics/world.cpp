// A world: made, read, hashed.
#include "dynamics/world.h"

#include "core/hash.h"
#include "dynamics/accuracy/accuracy.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/contact/mean_motion.h"
#include "dynamics/contact_views.h"
#include "dynamics/effects.h"
#include "dynamics/events/events.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/direct.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

const char* stage_name(Stage stage) {
  static constexpr const char* kNames[kStageCount] = {"refresh",   "broad", "narrow", "group",
                                                      "integrate", "solve", "relax",  "observe"};
  const auto s = static_cast<std::size_t>(stage);
  return s < kStageCount ? kNames[s] : "?";
}

World::World(std::uint32_t tag, const Vec3& gravity, std::size_t body_capacity, Memory* m)
    : scene(tag, m),
      state(m),
      particles(tag, m),
      joints(tag, m),
      views(make_owned<ContactViews>(m, m)),
      group_views(m),
      fault_views(m),
      pairs(m),
      impulses(m),
      plan(make_owned<Plan>(m, m)),
      contacts(make_owned<Contacts>(m, m)),
      wide(make_owned<WideContacts>(m, m)),
      wide_joints(make_owned<WideJoints>(m, m)),
      direct(make_owned<DirectGroups>(m, m)),
      sleep(make_owned<Sleep>(m, m)),
      events(make_owned<Events>(m, m)),
      continuous(make_owned<Continuous>(m, m)),
      queries(make_owned<QueryIndex>(m, m)),
      memory(m) {
  scene.gravity = gravity;
  const auto reserve = [&](auto&... arrays) { (arrays.reserve(body_capacity), ...); };
  reserve(scene.bodies, scene.def, scene.type, scene.inv_mass, scene.mass, scene.center, scene.inertia,
          scene.inv_inertia, state.x, state.q, state.held_q, state.placed_x, state.placed_q, state.v, state.omega,
          state.momentum, state.force, state.torque, state.held_out, state.loaded_steps, state.cooldown_steps,
          state.accuracy, state.written, state.is_written);
}

World::~World() { structure.forget(memory); }

Pose World::pose(std::uint32_t body) const {
  return {state.q[body], state.x[body] - state.q[body] * scene.center[body]};
}

std::uint64_t World::hash() const {
  Hash h;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i) {
    if (!scene.bodies.alive(i)) continue;
    h.add(std::uint64_t(i));
    h.add_coefficients(state.x[i]);
    h.add_coefficients(state.q[i]);
    h.add_coefficients(state.v[i]);
    h.add_coefficients(state.omega[i]);
    h.add_coefficients(state.momentum[i]);
    h.add_coefficients(state.force[i]);
    h.add_coefficients(state.torque[i]);
    h.add(std::uint64_t(state.held_out[i]));
    const std::uint32_t solver_memory = state.loaded_steps[i] + (256u * state.cooldown_steps[i]);
    if (solver_memory) h.add(std::uint64_t(solver_memory));
    if (const AccuracyMemory& note = state.accuracy[i]; note != AccuracyMemory()) {
      h.add(note.level + (std::uint64_t(note.wait) << 8) + (std::uint64_t(note.met) << 16) +
            (std::uint64_t(note.softly) << 24) + (std::uint64_t(note.stalled) << 25));
      h.add(double(note.place)), h.add(double(note.turn));
    }
    if (state.held_q[i] != state.q[i]) h.add_coefficients(state.held_q[i]);
  }
  const auto add_record = [&](const Pair& pair, const PairRecord& r) {
    h.add(pair.key());
    h.add_coefficients(r.memory.direction);
    for (int k = 0; k < r.manifold.count; ++k) {
      const ContactPoint& p = r.manifold.point[k];
      h.add_coefficients(p.on_a);
      h.add_coefficients(p.on_b);
      h.add_coefficients(p.normal);
      h.add(double(p.separation));
      h.add((std::uint64_t(p.feature) << 32) | p.age);
    }
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) add_record(pairs.place(i).pair, pairs[i]);
  const auto add_impulse = [&](const OldImpulse& o) {
    h.add(o.pair.key());
    h.add_coefficients(o.place);
    h.add_coefficients(o.p);
  };
  for (const OldImpulse& o : impulses.old) add_impulse(o);
  particles.add_to(h);
  for (std::uint32_t j = 0; j < joints.slots.slots(); ++j) {
    if (!joints.alive(j)) continue;
    const Joint& joint = joints.joint[j];
    h.add((std::uint64_t(j) << 1) | joint.broken);
    for (const Real p : joint.p) h.add(p);
    for (const Real p : joint.drive_p) h.add(p);
    for (const auto& of_axis : joints.axes_of(joint).p)
      for (const Real p : of_axis)
        if (joint.axes) h.add(p);
    if (joint.turn.mode != AxisDrive::none) h.add_coefficients(joint.turn.p);
  }
  if (sleep->count > 0) {
    for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i) h.add(std::uint64_t(state.sleeps(i)));
    pairs.each_inactive(add_record);
    for (const std::uint32_t first : sleep->kept_first)
      for (std::uint32_t k = first; k != kInvalid; k = sleep->kept[k].next) add_impulse(sleep->kept[k].impulse);
  }
  return h.value();
}

bool World::asleep(std::uint32_t body) const { return state.sleeps(body); }

}  // namespace carom::dynamics

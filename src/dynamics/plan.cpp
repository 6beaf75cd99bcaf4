// The plan of a step, made from the table: the participants of each effect, and what serves them.
#include <algorithm>
#include <atomic>
#include <cstring>

#include "collision/volume.h"
#include "core/float_guard.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/effects.h"
#include "dynamics/force/floats.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/integrate/free_flight.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

// As CAROM_ROTATION_*; those after them are rotation methods.
enum RotationChoice : std::uint32_t { kNoGyroscopicTerm, kExplicitTorque, kImplicitStep };

/// Rows, their participants, and whether each is a force or a flow: the one place where these dials are switched.
void plan_rows(const World& world, Plan& plan) {
  const Dials& dials = world.scene.dials;
  const Integrator* integrators[] = {&kExplicitEuler, &kSemiImplicitEuler, &kRungeKutta4, &kVelocityVerlet};
  plan.integrator = integrators[dials.choice(Dial::integrator)];
  const Solver* solvers[] = {&kSeverity, &kSoftStep, &kDirect, &kAuto};
  plan.solver = solvers[dials.choice(Dial::solver)];
  plan.watches_speed =
      dials.choice(Dial::continuous) == kSweepFast && !world.scene.modes.forbids(+EffectId::continuous);
  const std::uint32_t rotation = dials.choice(Dial::rotation);
  plan.rotation_method = plan.integrator->forces_only ? nullptr : rotation_method(rotation);
  for (PlannedEffect& row : plan.effects) {
    const bool gyro = row.effect->force == gyroscopic::force;
    if (!gyro || rotation != kNoGyroscopicTerm)
      find_candidates(world, row);
    else
      row.candidates.clear(), row.wanted = 0;
    const bool as_flow = row.effect->flow && !plan.integrator->forces_only && !(gyro && rotation == kExplicitTorque);
    row.served = as_flow ? Served::flow : row.effect->force ? Served::force : Served::stage;
    if (gyro && row.candidates.count == 0) plan.rotation_method = nullptr;
    if (gyro && plan.rotation_method) row.served = Served::stage;
    row.participants.clear();
    row.participants.runs.reserve(row.candidates.count);
    if (!row.effect->wakes) row.participants = row.candidates;
  }
}

void plan_principal(const World& world, Plan& plan, std::uint32_t slots) {
  plan.turns_by_method.assign(slots, 0);
  plan.principal.resize(slots);
  plan.predicted.omega.resize(slots, Vec3::zero());
  if (plan.rotation_method)
    plan.effects[+EffectId::gyroscopic].candidates.each(
        [&](std::uint32_t i) { plan.principal[i] = principal_axes(world.scene.inertia[i]); });
}

void plan_bodies(const World& world, Plan& plan) {
  const Scene& scene = world.scene;
  plan.linear.clear(), plan.rotating.clear(), plan.kinematic.clear();
  const std::uint32_t slots = scene.bodies.slots();
  for (std::uint32_t i = 0; i < slots; ++i) {
    if (!scene.bodies.alive(i) || world.state.held_out[i]) continue;
    if (scene.type[i] == BodyType::kinematic) plan.kinematic.add(i);
    if (scene.inv_mass[i] > 0) (rotates(scene, i) ? plan.rotating : plan.linear).add(i);
  }
  plan.touched.assign(slots, 0);
  plan.predicted.x.resize(plan.integrator->proposes ? slots : 0, Vec3::zero());
  plan.predicted.q.resize(plan.integrator->proposes || plan.rotation_method ? slots : 0, Quat::identity());
  plan_principal(world, plan, plan.rotation_method ? slots : 0);
  const PlannedEffect& gyro = plan.effects[+EffectId::gyroscopic];
  plan.reads_velocities = !plan.integrator->forces_only &&
                          ((gyro.served == Served::force && gyro.candidates.count > 0) ||
                           std::ranges::any_of(plan.effects,
                                               [](const PlannedEffect& row) {
                                                 return row.effect->reads_velocities && row.candidates.count > 0;
                                               }) ||
                           scene.springs.slots.alive_count() > 0);
  plan.read_v.resize(plan.reads_velocities ? slots : 0, Vec3::zero());
  plan.read_omega.resize(plan.read_v.size(), Vec3::zero());
  plan.scratch_vectors.resize(plan.integrator->vectors * slots, Vec3::zero());
  plan.scratch_rotations.resize(plan.integrator->rotations * slots, Quat::identity());
}

/// Which bodies can be touched, and for which a step needs the axes in the world's frame.
void plan_solid(const World& world, Plan& plan) {
  plan.solid.clear(), plan.oriented.clear();
  const auto wears = [&](std::uint32_t i) { return world.scene.first_collider[i] != kInvalid; };
  each_of_both(plan.linear, plan.rotating, [&](std::uint32_t i) {
    if (wears(i)) plan.solid.add(i);
  });
  const Array<std::uint8_t>& linked = world.wide_joints->linked;
  plan.rotating.each([&](std::uint32_t i) {
    if (wears(i) || (!linked.empty() && linked[i])) plan.oriented.add(i);
  });
}

/// In every step: a host may add and remove particles in each, and a plan made anew costs as much as all bodies.
void plan_particles(const World& world, Plan& plan) {
  PlannedEffect& row = plan.effects[+EffectId::particles];
  row.wanted = world.particles.count() - world.particles.held_count();
  row.participants.count = world.scene.modes.forbids(+EffectId::particles) ? 0 : row.wanted;
  plan.runs[static_cast<std::size_t>(Stage::integrate)] =
      plan.linear.count + plan.rotating.count + plan.kinematic.count + world.particles.count() > 0;
}

void plan_colliders(const World& world, Colliders& c, Plan& plan) {
  plan.colliders.clear();
  c.active.clear();
  c.active.reserve(c.live.size());
  plan.local.resize(c.slots());
  const bool oriented = c.slots() || world.joints.slots.alive_count();
  plan.rotation.resize(oriented ? world.scene.bodies.slots() : 0, Mat3::identity());
  for (const std::uint32_t slot : c.live) {
    const std::uint32_t body = c.body[slot];
    const bool faulty = std::find(plan.faulty.begin(), plan.faulty.end(), c.shape[slot]) != plan.faulty.end();
    const EffectModes& modes = world.scene.modes;
    const bool forbidden = modes.forbids(+EffectId::collision, body) ||
                           (is_scenery(*c.shape[slot]) && modes.forbids(+EffectId::scenery, body)) ||
                           (c.is_sensor(slot) && modes.forbids(+EffectId::sensor, body));
    c.disabled[slot] = static_cast<std::uint8_t>((faulty || world.state.held_out[body] ? Colliders::kFaulty : 0) |
                                                 (forbidden ? Colliders::kForbidden : 0));
    plan.local[slot] = Frame(c.local[slot].q.matrix(), c.local[slot].p - world.scene.center[body]);
    if (world.state.sleeps(body)) continue;
    c.active.push_back(slot);
    if (c.movable[slot]) plan.colliders.push_back(slot);
  }
  plan.faults.reserve(c.slots());
}

}  // namespace

void find_candidates(const World& world, PlannedEffect& row) {
  const Effect& effect = *row.effect;
  const Scene& scene = world.scene;
  const EffectModes& modes = scene.modes;
  const auto k = static_cast<std::size_t>(&row - world.plan->effects.data());
  row.candidates.clear();
  if (effect.find) effect.find(scene, world.state, row.candidates);
  row.wanted = row.candidates.count;
  row.is_forced = effect.everyone && (modes.of_world(k) == EffectMode::force || !modes.forced_of.empty());
  if (modes.forbids(k)) return row.candidates.clear();
  if (row.is_forced) {
    if (!row.calling) row.calling = make_owned<Participants>(world.memory, world.memory);
    *row.calling = row.candidates;
  }
  const bool by_body = k != +EffectId::sleep && (effect.participants == ParticipantKind::bodies ||
                                                 effect.participants == ParticipantKind::colliders);
  if (row.is_forced && modes.of_world(k) == EffectMode::force) {
    row.candidates.clear();
    effect.everyone(scene, world.state, row.candidates);
  } else if (row.is_forced) {
    Participants all(world.memory), both(world.memory);
    effect.everyone(scene, world.state, all);
    all.each([&](std::uint32_t i) {
      if (modes.forces(k, i) || row.candidates.has(i)) both.add(i);
    });
    row.candidates = std::move(both);
  }
  if (!by_body || !(modes.forbidden_anywhere & row_bit(k))) return;
  Participants allowed(world.memory);
  row.candidates.each([&](std::uint32_t i) {
    if (!modes.forbids(k, effect.participants == ParticipantKind::colliders ? scene.colliders.body[i] : i))
      allowed.add(i);
  });
  row.candidates = std::move(allowed);
}

Plan::Plan(Memory* m)
    : effects(m),
      linear(m),
      rotating(m),
      kinematic(m),
      solid(m),
      oriented(m),
      colliders(m),
      local(m),
      principal(m),
      turns_by_method(m),
      predicted(m),
      led(m),
      driven(m),
      begun(m),
      touched(m),
      rotation(m),
      sprung(m),
      readers(m),
      reader_list(m),
      read_v(m),
      read_omega(m),
      scratch_vectors(m),
      scratch_rotations(m),
      faulty(m),
      faults(m),
      pairs(m) {
  effects.reserve(kEffectCount);
  for (const Effect& row : effect_table()) effects.emplace_back(&row, m);
}

Plan::~Plan() = default;

PlannedEffect* Plan::find(const char* name) {
  for (PlannedEffect& row : effects)
    if (std::strcmp(row.effect->name, name) == 0) return &row;
  return nullptr;
}

bool from_host(const Effect& effect) { return effect.force == user_force::force || effect.force == user_torque::force; }

void plan_stages(const World& world, Plan& plan) {
  const auto on = [&](Stage s) -> bool& { return plan.runs[static_cast<std::size_t>(s)]; };
  const Colliders& c = world.scene.colliders;
  const std::size_t asleep = c.live.size() - c.active.size(),
                    awake = plan.effects[+EffectId::collision].candidates.count;
  const bool forced = world.scene.modes.of_world(+EffectId::collision) == EffectMode::force && !c.active.empty();
  const bool pairs = (awake > 0 && awake + asleep >= 2) || forced;
  const bool joints = world.wide_joints->any();
  count_participants(world, EffectId::joints, world.wide_joints->active.size());
  on(Stage::refresh) = on(Stage::observe) = true;
  plan_solid(world, plan);
  plan_particles(world, plan);
  on(Stage::broad) = on(Stage::narrow) = pairs || (joints && !c.live.empty());  // rows are made of the pairs there are
  on(Stage::group) = on(Stage::solve) = pairs || joints;
  plan.substeps = world.scene.dials.whole(Dial::substeps);  // whoever is in it: @see integrate/free_flight.h
  on(Stage::relax) =
      joints || (pairs && (!plan.solver->counts_positions || world.scene.dials.whole(Dial::position_iterations) > 0));
}

namespace {

/// m, that a collider crosses within a step.
Real motion_of(const World& world, const Colliders& c, const Plan& plan, std::uint32_t slot, Real dt) {
  const std::uint32_t body = c.body[slot];
  const Real arm = c.shape[slot]->bounding_radius + plan.local[slot].p.norm();
  return dt * (world.state.v[body].norm() + arm * world.state.omega[body].norm());
}

/// World frame and bounds of a collider. Bounds are grown by half the contact distance, and where a body crosses more
/// than that within the step by its motion too, so that it meets what it is about to hit. That reach ends at the size
/// of the shape: beyond, a contact would stop bodies that merely pass by. Writes what is the collider's alone.
SupportFault find_bounds(const World& world, Colliders& c, const Plan& plan, std::uint32_t slot, Real dt) {
  const std::uint32_t body = c.body[slot];
  const Shape& shape = *c.shape[slot];
  c.place(slot, Frame(plan.rotation[body], world.state.x[body]) * plan.local[slot]);
  const Real half_gap = world.scene.dials[Dial::contact_distance] / 2;
  c.reach[slot] = 0;
  if (const Real motion = c.movable[slot] ? motion_of(world, c, plan, slot, dt) : 0; motion > half_gap)
    c.reach[slot] = std::min(motion, shape.bounding_radius);
  SupportFault fault;
  const FloatGuard guard;
  if ((c.disabled[slot] & Colliders::kFaulty) && finite(shape.bounding_radius)) {  // a disabled shape is not queried
    const Vec3 all = Vec3::constant(shape.bounding_radius);
    c.bounds[slot] = {c.frame[slot].p - all, c.frame[slot].p + all};
  } else {
    c.bounds[slot] = world_bounds(shape, c.frame[slot].r, c.frame[slot].p, fault);
  }
  const Vec3 grow = Vec3::constant(half_gap + c.reach[slot]);
  c.bounds[slot].lo -= grow;
  c.bounds[slot].hi += grow;
  return fault;
}

/// What a world has to know of a collider that was placed.
void save_placed(const World& world, const Colliders& c, PlacedPoses& placed, const Plan& plan, std::uint32_t slot,
                 Real dt) {
  const std::uint32_t body = c.body[slot];
  placed.placed_x[body] = world.state.x[body], placed.placed_q[body] = world.state.q[body];
  if (!plan.watches_speed || !c.movable[slot]) return;
  const Real radius = c.shape[slot]->bounding_radius;
  const bool is_fast =
      motion_of(world, c, plan, slot, dt) > (radius > 0 ? radius / 4 : world.scene.dials[Dial::contact_distance] / 2);
  if (is_fast || (world.scene.type[body] == BodyType::kinematic && comes_far(world, slot, dt)))
    world.continuous->see(body);
}

}  // namespace

void place_collider(const World& world, Colliders& c, PlacedPoses& placed, Plan& plan, std::uint32_t slot, Real dt) {
  const SupportFault fault = find_bounds(world, c, plan, slot, dt);
  if (fault.kind != SupportFault::none) plan.faults.push_back(fault);
  save_placed(world, c, placed, plan, slot, dt);
}

Real radius_of_body(const World& world, std::uint32_t body) {
  const Colliders& c = world.scene.colliders;
  Real radius = 0;
  for (std::uint32_t slot = world.scene.first_collider[body]; slot != kInvalid; slot = c.next[slot])
    radius = std::max(radius, world.plan->local[slot].p.norm() + c.shape[slot]->bounding_radius);
  return radius;
}

namespace {

/// Likewise of many, by all threads; shapes that only the stepping one may ask, by that. Faults, which are rare, are asked
/// for again, so that they come in the order of slots.
void place_colliders(const World& world, Colliders& c, PlacedPoses& placed, Plan& plan,
                     const Array<std::uint32_t>& slots, Real dt) {
  constexpr std::size_t kCollidersAPart = 64;
  std::atomic<bool> any_fault{false}, any_waits{false};
  const auto find = [&](std::uint32_t slot) {
    if (find_bounds(world, c, plan, slot, dt).kind != SupportFault::none)
      any_fault.store(true, std::memory_order_relaxed);
  };
  const auto waits = [&](std::uint32_t slot) { return world.jobs && c.shape[slot]->host_thread; };
  in_parallel(world.jobs, slots.size(), kCollidersAPart, [&](std::uint32_t i) {
    if (!waits(slots[i])) return find(slots[i]);
    any_waits.store(true, std::memory_order_relaxed);
  });
  const bool some_wait = any_waits.load(std::memory_order_relaxed);
  for (const std::uint32_t slot : slots) {
    if (some_wait && waits(slot)) find(slot);
    save_placed(world, c, placed, plan, slot, dt);
  }
  if (!any_fault.load(std::memory_order_relaxed)) return;
  for (const std::uint32_t slot : slots)
    if (const SupportFault fault = find_bounds(world, c, plan, slot, dt); fault.kind != SupportFault::none)
      plan.faults.push_back(fault);
}

/// An explicit method is stable only for rate * h below a small number (2 for Euler, 2.8 for RK4); well before, decay
/// is exact. Each body's own rate decides: other bodies of the row change nothing.
void part_with_stiff(const World& world, PlannedEffect& row, Real h) {
  const Effect& effect = *row.effect;
  if (row.decays) row.decays->stiff.clear();
  if (!effect.rate || !world.plan->integrator->forces_only) return;
  row.participants.each([&](std::uint32_t i) {
    if (!(effect.rate(world.scene, world.state, i) * h > 1)) return;
    if (!row.decays) {
      auto& free =
          *std::find_if(world.plan->decays.begin(), world.plan->decays.end(), [](const auto& d) { return !d; });
      free = make_owned<Decays>(world.memory, world.memory);
      row.decays = free.get();
    }
    row.decays->stiff.add(i);
  });
  if (row.has_stiff()) take_out(row.participants, row.decays->stiff, row.decays->gentle);
}

/// Bodies, once each.
void list(Array<std::uint32_t>& bodies, Participants& once) {
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  for (const std::uint32_t i : bodies) once.add(i);
}

void find_readers(const World& world) {
  Plan& plan = *world.plan;
  Array<std::uint32_t>& bodies = plan.reader_list;
  plan.sprung.clear(), plan.readers.clear(), bodies.clear();
  const auto add = [&](std::uint32_t i) {
    if (i != kInvalid && responds(world.scene, world.state, i)) bodies.push_back(i);
  };
  plan.effects[+EffectId::springs].participants.each([&](std::uint32_t k) {
    const SpringDef& def = world.scene.springs.def[k];
    add(def.body_a), add(def.body_b);
  });
  list(bodies, plan.sprung);
  if (!plan.reads_velocities) return;
  if (const PlannedEffect& gyro = plan.effects[+EffectId::gyroscopic]; gyro.served == Served::force)
    gyro.participants.each(add);
  for (const PlannedEffect& row : plan.effects)
    if (row.effect->reads_velocities) row.participants.each(add);
  list(bodies, plan.readers);
}

}  // namespace

void part_stiff(const World& world, Real h) {
  each_acting(*world.plan, [&](PlannedEffect& row) { part_with_stiff(world, row, h); });
}

void find_participants(const World& world, Real h) {
  Plan& plan = *world.plan;
  plan.acting = 0;
  for (std::size_t at = 0; at < plan.effects.size(); ++at) {
    PlannedEffect& row = plan.effects[at];
    const Effect& effect = *row.effect;
    if (row.served != Served::stage && (row.wanted > 0 || row.is_forced || row.candidates.count > 0 || row.decays))
      plan.acting |= row_bit(at);
    if (!effect.wakes) continue;
    row.participants.clear();
    row.candidates.each([&](std::uint32_t i) {
      if (effect.wakes(world.scene, world.state, i)) row.participants.add(i);
    });
  }
  part_stiff(world, h);
  find_readers(world);
  if (!plan.rotation_method) return;
  plan.effects[+EffectId::gyroscopic].candidates.each([&](std::uint32_t i) { plan.turns_by_method[i] = 0; });
  plan.effects[+EffectId::gyroscopic].participants.each([&](std::uint32_t i) { plan.turns_by_method[i] = 1; });
}

void refresh(const World& world, Settling to, SpringLoads& springs, Floats& floats, const StepTime& time) {
  PairTable& pairs = to;
  Plan& plan = *world.plan;
  const bool changed = plan.revision != world.scene.revision;
  plan.idle = false;
  rattle::come_back(world);
  plan.host_wrote = !world.state.written.empty();
  plan.faults.clear();
  if (changed) {
    if (world.scene.revision != plan.restored) pairs.ask_all();  // how pairs are asked may have changed
    plan_colliders(world, to, plan);
    plan_rows(world, plan);
    plan_bodies(world, plan);
    plan_joints(world, to);
    plan_springs(world);
    if (plan.effects[+EffectId::buoyancy].candidates.count) make_floats(world.scene.colliders, floats, world.memory);
    plan_stages(world, plan);
    plan_sleep(world, to, plan);
    plan.revision = world.scene.revision;
  }
  wake_sprung(world, to);
  settle_sleepers(world, to);
  plan_particles(world, plan);
  for (PlannedEffect& row : plan.effects) {
    const Effect& effect = *row.effect;
    row.seconds = 0;
    if (effect.participants == ParticipantKind::contact_points || effect.participants == ParticipantKind::contact_pairs)
      row.participants.count = 0;
    if (from_host(effect) && !changed) {
      if (plan.host_wrote)
        find_candidates(world, row);
      else
        row.candidates.clear(), row.wanted = 0;
      row.participants = row.candidates;
    }
  }
  plan.effects[+EffectId::ledger].wanted = world.ledger ? plan.linear.count + plan.rotating.count : 0;
  const Real h = time.dt / plan.substeps;  // time.h is of the last step's plan
  carry_springs(world, springs, h);
  floats.most_rate = 1 / h;
  find_participants(world, h);
  if (!world.scene.colliders.live.empty() || world.joints.slots.alive_count()) {
    const State& s = world.state;
    const auto orient = [&](std::uint32_t i) { plan.rotation[i] = s.q[i].matrix(); };
    if (changed)
      for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) orient(i);
    plan.oriented.each(world.jobs, orient);
    plan.kinematic.each(orient);
    for (const std::uint32_t i : s.written) orient(i);  // also those that turn by a host's hand alone
    Colliders& table = to;
    place_colliders(world, table, to, plan, changed ? table.active : plan.colliders, time.dt);
  }
  find_swept(world, to, time.dt);
}

}  // namespace carom::dynamics

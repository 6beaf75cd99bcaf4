// THE TABLE: every effect of a step, who its customers are, and what serves them; and the plan made from it.
#include "dynamics/effects.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <string_view>

#include "collision/volume.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/events/events.h"
#include "dynamics/filter.h"
#include "dynamics/force/floats.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/solver.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

void find_colliders(const Scene& scene, const State&, Customers& customers) {
  const Colliders& c = scene.colliders;
  const auto movable = [&](std::uint32_t slot) { return c.movable[slot] != 0; };
  if (c.live.size() < 2 || std::none_of(c.active.begin(), c.active.end(), movable)) return;
  for (const std::uint32_t slot : c.active)
    if (!(c.muted[slot] & Colliders::kFaulty)) customers.add(slot);
}
// Counted elsewhere: contacts where they are built, particles by plan_particles(), joints and springs where they are
// planned, hosts that want events by begin_events(). Who moves far for its size joins the flagged customers of
// `continuous` in find_swept().
void find_elsewhere(const Scene&, const State&, Customers&) {}

void everyone(const Scene& scene, const State& state, Customers& customers) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i)) customers.add(i);
}
void everyone_that_turns(const Scene& scene, const State& state, Customers& customers) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i) && rotates(scene, i)) customers.add(i);
}

using enum CustomerKind;
// clang-format off
constexpr std::array<Effect, kEffectCount> kTable = {{
    // stage, name, customers are
    //     who may be one, who is in this step | force, flow, its decay rate | whom it can be forced on
    //     called by | missing
    {Stage::integrate, "gyroscopic", bodies,
     gyroscopic::find, gyroscopic::wakes, gyroscopic::force, gyroscopic::flow, nullptr, everyone_that_turns,
     "bodies with unlike moments of inertia that spin", "no body with unlike moments of inertia, or dial rotation is none"},
    {Stage::integrate, "linear_damping", bodies,
     linear_damping::find, nullptr, linear_damping::force, linear_damping::flow, linear_damping::rate, everyone,
     "bodies with linear damping", "no body has linear damping"},
    {Stage::integrate, "angular_damping", bodies,
     angular_damping::find, nullptr, angular_damping::force, angular_damping::flow, angular_damping::rate, everyone_that_turns,
     "bodies with angular damping that turn", "no body that turns has angular damping"},
    {Stage::integrate, "gravity", bodies,
     gravity::find, nullptr, gravity::force, nullptr, nullptr, everyone,
     "bodies with weight", "gravity is zero, or no body feels it"},
    {Stage::integrate, "user_force", bodies,
     user_force::find, nullptr, user_force::force, nullptr, nullptr, nullptr,
     "bodies with a force from the host for this step", "the host asked for no force in this step"},
    {Stage::integrate, "user_torque", bodies,
     user_torque::find, nullptr, user_torque::force, nullptr, nullptr, nullptr,
     "bodies with a torque from the host for this step", "the host asked for no torque in this step"},
    {Stage::broad, "collision", colliders,
     find_colliders, nullptr, nullptr, nullptr, nullptr, nullptr,
     "colliders of which two can touch", "no two colliders of which one can move"},
    {Stage::solve, "friction", contact_points,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "contact points with friction", "no pair that touches mixes to a friction above 0"},
    {Stage::solve, "restitution", contact_points,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "contact points with a restitution", "no pair that touches mixes to a restitution above 0"},
    {Stage::solve, "rolling_resistance", contact_pairs,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "pairs that resist rolling", "no pair that touches resists rolling"},
    {Stage::solve, "spinning_resistance", contact_pairs,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "pairs that resist spinning", "no pair that touches resists spinning"},
    {Stage::observe, "sleep", bodies,
     sleeping::find, nullptr, nullptr, nullptr, nullptr, nullptr,
     "bodies that are awake and may fall asleep", "dial sleep is off, or all sleep"},
    {Stage::integrate, "particles", particles,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "particles", "no particles"},
    {Stage::broad, "filter", colliders,
     filtering::find, nullptr, nullptr, nullptr, nullptr, nullptr,
     "colliders with a filter", "no collider has a filter"},
    {Stage::broad, "sensor", colliders,
     sensing::find, nullptr, nullptr, nullptr, nullptr, nullptr,
     "sensors", "no collider is a sensor"},
    {Stage::solve, "joints", joints,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "joints that hold a body which is awake", "no joint holds a body that is awake"},
    {Stage::narrow, "scenery", colliders,
     scenery::find, nullptr, nullptr, nullptr, nullptr, nullptr,
     "meshes and height fields", "no collider is a mesh or height field"},
    {Stage::solve, "continuous", bodies,
     continuous::find, nullptr, nullptr, nullptr, nullptr, everyone,
     "bodies that are flagged, or fast for their size", "no body is flagged, and none was fast for its size"},
    {Stage::solve, "surface_velocity", contact_points,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "contact points on surfaces that move", "nothing touches a surface that moves"},
    {Stage::integrate, "axis_locks", bodies,
     axis_locks::find, nullptr, nullptr, nullptr, nullptr, nullptr,
     "bodies with locked axes", "no body has a locked axis"},
    {Stage::integrate, "drag", bodies,
     drag::find, nullptr, drag::force, drag::flow, drag::rate, everyone,
     "bodies that air resists", "no body has drag"},
    {Stage::integrate, "wind", bodies,
     wind::find, nullptr, nullptr, nullptr, nullptr, nullptr,
     "bodies with drag, in a wind", "no wind, or no body has drag"},
    {Stage::integrate, "fields", bodies,
     fields::find, nullptr, fields::force, nullptr, nullptr, everyone,
     "bodies that feel a field", "no field, or no body feels one"},
    {Stage::integrate, "springs", springs,
     springs::find, nullptr, springs::force, nullptr, nullptr, nullptr,
     "springs with an end that moves", "no spring, or all its bodies sleep"},
    {Stage::integrate, "buoyancy", bodies,
     buoyancy::find, buoyancy::wakes, buoyancy::force, nullptr, nullptr, nullptr,
     "bodies in the water", "no water, or no body with a volume in it"},
    {Stage::solve, "response", contact_pairs,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "pairs that touch", "nothing touches"},
    {Stage::solve, "joint_limits", joints,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "joints with a limit", "no joint with a limit holds a body that is awake"},
    {Stage::solve, "joint_motors", joints,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "joints with a motor", "no joint with a motor holds a body that is awake"},
    {Stage::observe, "events", hosts,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "a host that collects events", "no host collects events"},
    {Stage::observe, "ledger", bodies,
     find_elsewhere, nullptr, nullptr, nullptr, nullptr, nullptr,
     "bodies and particles whose energy and momentum are booked", "no host keeps a ledger"},
}};
// clang-format on

constexpr bool is_row(std::size_t row, const char* name) { return std::string_view(kTable[row].name) == name; }
static_assert(is_row(kGyroscopicRow, "gyroscopic") && is_row(kLinearDampingRow, "linear_damping") &&
              is_row(kAngularDampingRow, "angular_damping") && is_row(kGravityRow, "gravity") &&
              is_row(kUserForceRow, "user_force") && is_row(kUserTorqueRow, "user_torque") &&
              is_row(kCollisionRow, "collision") && is_row(kFrictionRow, "friction") &&
              is_row(kRestitutionRow, "restitution") && is_row(kRollingRow, "rolling_resistance") &&
              is_row(kSpinningRow, "spinning_resistance") && is_row(kSleepRow, "sleep") &&
              is_row(kParticlesRow, "particles") && is_row(kFilterRow, "filter") && is_row(kSensorRow, "sensor") &&
              is_row(kJointsRow, "joints") && is_row(kSceneryRow, "scenery") &&
              is_row(kContinuousRow, "continuous") && is_row(kSurfaceRow, "surface_velocity") &&
              is_row(kLocksRow, "axis_locks") && is_row(kDragRow, "drag") && is_row(kWindRow, "wind") &&
              is_row(kFieldsRow, "fields") && is_row(kSpringsRow, "springs") && is_row(kBuoyancyRow, "buoyancy") &&
              is_row(kResponseRow, "response") && is_row(kLimitsRow, "joint_limits") &&
              is_row(kMotorsRow, "joint_motors") && is_row(kEventsRow, "events") && is_row(kLedgerRow, "ledger"));

// As CAROM_ROTATION_*; those after them are rotation methods.
enum RotationChoice : std::uint32_t { kNoGyroscopicTerm, kExplicitTorque, kImplicitStep };

/// Rows, their customers, and whether each is a force or a flow: the one place where these dials are switched.
void plan_rows(World& world, Plan& plan) {
  const Dials& dials = world.scene.dials;
  const Integrator* integrators[] = {&kExplicitEuler, &kSemiImplicitEuler, &kRungeKutta4, &kVelocityVerlet};
  plan.integrator = integrators[dials.choice(Dial::integrator)];
  const Solver* solvers[] = {&kSeverity, &kSequential, &kSoftStep, &kDirect, &kAuto};
  plan.solver = solvers[dials.choice(Dial::solver)];
  plan.watches_speed = dials.choice(Dial::continuous) == kSweepFast && !world.scene.modes.forbids(kContinuousRow);
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
    row.customers.clear();
    row.customers.runs.reserve(row.candidates.count);
    if (!row.effect->wakes) row.customers = row.candidates;
  }
}

void plan_principal(World& world, Plan& plan, std::uint32_t slots) {
  plan.carried.assign(slots, 0);
  plan.principal.resize(slots);
  plan.proposal.omega.resize(slots, Vec3::Zero());
  if (plan.rotation_method)
    plan.effects[kGyroscopicRow].candidates.each(
        [&](std::uint32_t i) { plan.principal[i] = principal_axes(world.scene.inertia[i]); });
}

void plan_bodies(World& world, Plan& plan) {
  const Scene& scene = world.scene;
  plan.linear.clear(), plan.rotating.clear(), plan.kinematic.clear();
  const std::uint32_t slots = scene.bodies.slots();
  for (std::uint32_t i = 0; i < slots; ++i) {
    if (!scene.bodies.alive(i) || world.state.quarantined[i]) continue;
    if (scene.type[i] == BodyType::kinematic) plan.kinematic.add(i);
    if (scene.inv_mass[i] > 0) (rotates(scene, i) ? plan.rotating : plan.linear).add(i);
  }
  plan.touched.assign(slots, 0);
  plan.proposal.x.resize(plan.integrator->proposes ? slots : 0, Vec3::Zero());
  plan.proposal.q.resize(plan.integrator->proposes || plan.rotation_method ? slots : 0, Quat::Identity());
  plan_principal(world, plan, plan.rotation_method ? slots : 0);
  const PlannedEffect& gyro = plan.effects[kGyroscopicRow];
  plan.reads_velocities = !plan.integrator->forces_only &&
                          ((gyro.served == Served::force && gyro.candidates.count > 0) ||
                           plan.effects[kBuoyancyRow].candidates.count > 0 || scene.springs.slots.alive_count() > 0);
  plan.read_v.resize(plan.reads_velocities ? slots : 0, Vec3::Zero());
  plan.read_omega.resize(plan.read_v.size(), Vec3::Zero());
  plan.scratch_vectors.resize(plan.integrator->vectors * slots, Vec3::Zero());
  plan.scratch_rotations.resize(plan.integrator->rotations * slots, Quat::Identity());
}

/// In every step: a host may add and remove particles in each, and a plan made anew costs as much as all bodies.
void plan_particles(const World& world, Plan& plan) {
  PlannedEffect& row = plan.effects[kParticlesRow];
  row.wanted = world.particles.count() - world.particles.held_count();
  row.customers.count = world.scene.modes.forbids(kParticlesRow) ? 0 : row.wanted;
  plan.runs[static_cast<std::size_t>(Stage::integrate)] =
      plan.linear.count + plan.rotating.count + plan.kinematic.count + world.particles.count() > 0;
}

void plan_colliders(World& world, Plan& plan) {
  Colliders& c = world.scene.colliders;
  plan.colliders.clear();
  c.active.clear();
  c.active.reserve(c.live.size());
  plan.local.resize(c.slots());
  const bool oriented = c.slots() || world.joints.slots.alive_count();
  plan.rotation.resize(oriented ? world.scene.bodies.slots() : 0, Mat3::Identity());
  for (const std::uint32_t slot : c.live) {
    const std::uint32_t body = c.body[slot];
    const bool faulty = std::find(plan.faulty.begin(), plan.faulty.end(), c.shape[slot]) != plan.faulty.end();
    const EffectModes& modes = world.scene.modes;
    const bool forbidden = modes.forbids(kCollisionRow, body) ||
                           (is_scenery(*c.shape[slot]) && modes.forbids(kSceneryRow, body)) ||
                           (c.is_sensor(slot) && modes.forbids(kSensorRow, body));
    c.muted[slot] = static_cast<std::uint8_t>((faulty || world.state.quarantined[body] ? Colliders::kFaulty : 0) |
                                              (forbidden ? Colliders::kForbidden : 0));
    plan.local[slot] = Frame(c.local[slot].q.toRotationMatrix(), c.local[slot].p - world.scene.center[body]);
    if (world.sleep->sleeps(body)) continue;
    c.active.push_back(slot);
    if (c.movable[slot]) plan.colliders.push_back(slot);
  }
  plan.faults.reserve(c.slots());
}

}  // namespace

const std::array<Effect, kEffectCount>& effect_table() { return kTable; }

void find_candidates(World& world, PlannedEffect& row) {
  const Effect& effect = *row.effect;
  const Scene& scene = world.scene;
  const EffectModes& modes = scene.modes;
  const auto k = static_cast<std::size_t>(&row - world.plan->effects.data());
  row.candidates.clear();
  effect.find(scene, world.state, row.candidates);
  row.wanted = row.candidates.count;
  if (modes.forbids(k)) return row.candidates.clear();
  const bool by_body = k != kSleepRow && (effect.customers == bodies || effect.customers == colliders);
  if (modes.of_world(k) == EffectMode::force && effect.everyone) {
    row.candidates.clear();
    effect.everyone(scene, world.state, row.candidates);
  } else if (!modes.forced_of.empty() && effect.everyone) {
    Customers all(world.memory), both(world.memory);
    effect.everyone(scene, world.state, all);
    const auto forced = [&](std::uint32_t i) { return modes.of_body(k, i) == EffectMode::force; };
    const auto called = [&](std::uint32_t i) {
      const auto r = std::partition_point(row.candidates.runs.begin(), row.candidates.runs.end(),
                                          [i](const Customers::Run& run) { return run.end <= i; });
      return r != row.candidates.runs.end() && r->begin <= i;
    };
    all.each([&](std::uint32_t i) {
      if (forced(i) || called(i)) both.add(i);
    });
    row.candidates = std::move(both);
  }
  if (!by_body || !(modes.forbidden_anywhere & row_bit(k))) return;
  Customers allowed(world.memory);
  row.candidates.each([&](std::uint32_t i) {
    if (!modes.forbids(k, effect.customers == colliders ? scene.colliders.body[i] : i)) allowed.add(i);
  });
  row.candidates = std::move(allowed);
}

Plan::Plan(Memory* m)
    : effects(m),
      linear(m),
      rotating(m),
      kinematic(m),
      colliders(m),
      local(m),
      principal(m),
      carried(m),
      proposal(m),
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
  for (const Effect& row : kTable) effects.emplace_back(&row, m);
}

Plan::~Plan() = default;

PlannedEffect* Plan::find(const char* name) {
  for (PlannedEffect& row : effects)
    if (std::strcmp(row.effect->name, name) == 0) return &row;
  return nullptr;
}

bool from_host(const Effect& effect) { return effect.force == user_force::force || effect.force == user_torque::force; }

void plan_stages(World& world, Plan& plan) {
  const auto on = [&](Stage s) -> bool& { return plan.runs[static_cast<std::size_t>(s)]; };
  const Colliders& c = world.scene.colliders;
  const std::size_t asleep = c.live.size() - c.active.size(), awake = plan.effects[kCollisionRow].candidates.count;
  const bool forced = world.scene.modes.of_world(kCollisionRow) == EffectMode::force && !c.active.empty();
  const bool pairs = (awake > 0 && awake + asleep >= 2) || forced;
  const bool joints = world.wide_joints->any();
  plan.effects[kJointsRow].customers.count = world.wide_joints->active.size();
  on(Stage::refresh) = on(Stage::observe) = true;
  plan_particles(world, plan);
  on(Stage::broad) = on(Stage::narrow) = pairs || (joints && !c.live.empty());  // rows are made of the pairs there are
  on(Stage::group) = on(Stage::solve) = pairs || joints;
  plan.substeps = pairs || joints ? world.scene.dials.whole(Dial::substeps) : 1;
  on(Stage::relax) =
      joints || (pairs && (!plan.solver->counts_positions || world.scene.dials.whole(Dial::position_iterations) > 0));
}

/// World frame and bounds of a collider. Bounds are grown by half the contact distance, and where a body crosses more
/// than that within the step by its motion too, so that it meets what it is about to hit. That reach ends at the size
/// of the shape: beyond, a contact would stop bodies that merely pass by.
void place_collider(World& world, Plan& plan, std::uint32_t slot, Real dt) {
  Colliders& c = world.scene.colliders;
  const std::uint32_t body = c.body[slot];
  const Shape& shape = *c.shape[slot];
  c.place(slot, Frame(plan.rotation[body], world.state.x[body]) * plan.local[slot]);
  const Real half_gap = world.scene.dials[Dial::contact_distance] / 2;
  c.reach[slot] = 0;
  if (c.movable[slot]) {
    const Real arm = shape.bounding_radius + plan.local[slot].p.norm();
    const Real motion = dt * (world.state.v[body].norm() + arm * world.state.omega[body].norm());
    if (motion > half_gap) {
      c.reach[slot] = std::min(motion, shape.bounding_radius);
      if (plan.watches_speed && 4 * motion > shape.bounding_radius) world.continuous->see(body);
    }
  }
  SupportFault fault;
  c.bounds[slot] = world_bounds(shape, c.frame[slot].r, c.frame[slot].p, fault);
  const Vec3 grow = Vec3::Constant(half_gap + c.reach[slot]);
  c.bounds[slot].lo -= grow;
  c.bounds[slot].hi += grow;
  if (fault.kind != SupportFault::none) plan.faults.push_back(fault);
}

Real radius_of_body(const World& world, std::uint32_t body) {
  const Colliders& c = world.scene.colliders;
  Real radius = 0;
  for (std::uint32_t slot = world.scene.first_collider[body]; slot != Colliders::kNone; slot = c.next[slot])
    radius = std::max(radius, world.plan->local[slot].p.norm() + c.shape[slot]->bounding_radius);
  return radius;
}

namespace {

/// Bodies, once each.
void list(Array<std::uint32_t>& bodies, Customers& once) {
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  for (const std::uint32_t i : bodies) once.add(i);
}

void find_readers(World& world) {
  Plan& plan = *world.plan;
  Array<std::uint32_t>& bodies = plan.reader_list;
  plan.sprung.clear(), plan.readers.clear(), bodies.clear();
  const auto add = [&](std::uint32_t i) {
    if (i != kTheWorld && responds(world.scene, world.state, i)) bodies.push_back(i);
  };
  plan.effects[kSpringsRow].customers.each([&](std::uint32_t k) {
    const SpringDef& def = world.scene.springs.def[k];
    add(def.body_a), add(def.body_b);
  });
  list(bodies, plan.sprung);
  if (!plan.reads_velocities) return;
  if (const PlannedEffect& gyro = plan.effects[kGyroscopicRow]; gyro.served == Served::force) gyro.customers.each(add);
  plan.effects[kBuoyancyRow].customers.each(add);
  list(bodies, plan.readers);
}

}  // namespace

void find_customers(World& world) {
  Plan& plan = *world.plan;
  for (PlannedEffect& row : plan.effects) {
    const Effect& effect = *row.effect;
    if (!effect.wakes) continue;
    row.customers.clear();
    row.candidates.each([&](std::uint32_t i) {
      if (effect.wakes(world.scene, world.state, i)) row.customers.add(i);
    });
  }
  find_readers(world);
  if (!plan.rotation_method) return;
  std::fill(plan.carried.begin(), plan.carried.end(), std::uint8_t(0));
  plan.effects[kGyroscopicRow].customers.each([&](std::uint32_t i) { plan.carried[i] = 1; });
}

void refresh(World& world, const StepTime& time) {
  Plan& plan = *world.plan;
  const bool changed = plan.revision != world.scene.revision;
  plan.host_wrote = !world.state.written.empty();
  plan.faults.clear();
  if (changed) {
    world.pairs.ask_all();  // how pairs are asked may have changed
    plan_colliders(world, plan);
    plan_rows(world, plan);
    plan_bodies(world, plan);
    plan_joints(world);
    plan_springs(world);
    if (plan.effects[kBuoyancyRow].candidates.count) make_floats(world.scene, world.memory);
    plan_stages(world, plan);
    plan_sleep(world, plan);
    plan.revision = world.scene.revision;
  }
  wake_sprung(world);
  settle_sleepers(world);
  plan_particles(world, plan);
  for (PlannedEffect& row : plan.effects) {
    const Effect& effect = *row.effect;
    row.seconds = 0;
    if (effect.customers == contact_points || effect.customers == contact_pairs) row.customers.count = 0;
    if (from_host(effect) && !changed) {
      if (plan.host_wrote)
        find_candidates(world, row);
      else
        row.candidates.clear(), row.wanted = 0;
      row.customers = row.candidates;
    }
    // An explicit method is stable only for rate * h below a small number (2 for Euler, 2.8 for RK4); well before,
    // decay is exact.
    if (effect.rate && plan.integrator->forces_only) {
      row.rate = effect.rate(world.scene, world.state, row.candidates);
      row.served = row.rate * time.dt > plan.substeps ? Served::flow : Served::force;
    }
  }
  plan.effects[kLedgerRow].wanted = world.ledger ? plan.linear.count + plan.rotating.count : 0;
  carry_springs(world, time.h);
  world.scene.water.most_rate = 1 / time.h;
  find_customers(world);
  if (!world.scene.colliders.live.empty() || world.joints.slots.alive_count()) {
    const State& s = world.state;
    const auto orient = [&](std::uint32_t i) { plan.rotation[i] = s.q[i].toRotationMatrix(); };
    if (changed)
      for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) orient(i);
    plan.rotating.each(orient);
    plan.kinematic.each(orient);
    for (const std::uint32_t i : s.written) orient(i);  // also those that turn by a host's hand alone
    for (const std::uint32_t slot : changed ? world.scene.colliders.active : plan.colliders)
      place_collider(world, plan, slot, time.dt);
  }
  find_swept(world, time.dt);
}

namespace {

/// Books what a row does, and its time if somebody wants to know.
template <class F>
void serve(World& world, PlannedEffect& row, F&& work) {
  const auto start = world.times_effects ? Clock::now() : Clock::time_point();
  work();
  if (world.times_effects) row.seconds += std::chrono::duration<double>(Clock::now() - start).count();
  row.evaluations += row.customers.count;
  if (row.effect->force == drag::force) {
    PlannedEffect& wind = world.plan->effects[kWindRow];
    wind.evaluations += wind.customers.count;
  }
}

}  // namespace

void evaluate_forces(World& world, const Motion& given, const Accelerate& out) {
  Motion at = given;
  if (world.plan->reads_velocities && at.v == out.v) {
    Plan& plan = *world.plan;
    plan.readers.each([&](std::uint32_t i) { plan.read_v[i] = at.v[i], plan.read_omega[i] = at.omega[i]; });
    at.v = plan.read_v.data(), at.omega = plan.read_omega.data();
  }
  for (PlannedEffect& row : world.plan->effects) {
    if (row.served != Served::force || row.customers.count == 0) continue;
    const BookRow book(world, row, out.v, out.omega, out.share);
    serve(world, row, [&] { row.effect->force(world.scene, world.state, row.customers, at, out); });
  }
}

Motion extrapolated(World& world, const Vec3* x, const Quat* q) {
  Plan& plan = *world.plan;
  const State& s = world.state;
  if (!plan.reads_velocities) return {x, q, s.v.data(), s.omega.data()};
  plan.readers.each([&](std::uint32_t i) {
    plan.read_v[i] = 2 * s.v[i] - plan.read_v[i];
    plan.read_omega[i] = 2 * s.omega[i] - plan.read_omega[i];
  });
  return {x, q, plan.read_v.data(), plan.read_omega.data()};
}

void evaluate_flows(World& world, Real h, const Quat* q) {
  State& s = world.state;
  for (PlannedEffect& row : world.plan->effects) {
    if (row.served != Served::flow || row.customers.count == 0) continue;
    const BookRow book(world, row, s.v.data(), s.omega.data(), 1);
    serve(world, row, [&] { row.effect->flow(world.scene, row.customers, h, q, s.v.data(), s.omega.data()); });
  }
}

}  // namespace carom

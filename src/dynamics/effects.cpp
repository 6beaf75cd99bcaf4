// THE TABLE: every effect of a step, who its customers are, and what serves them; and the plan made from it.
#include "dynamics/effects.h"

#include <algorithm>
#include <cstring>

#include "collision/volume.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/events/events.h"
#include "dynamics/filter.h"
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

void find_colliders(const Scene& scene, const State&, Customers& customers) {
  const Colliders& c = scene.colliders;
  const auto movable = [&](std::uint32_t slot) { return c.movable[slot] != 0; };
  if (c.live.size() < 2 || std::none_of(c.active.begin(), c.active.end(), movable)) return;
  for (const std::uint32_t slot : c.active)
    if (!c.muted[slot]) customers.add(slot);
}
// Counted elsewhere: contacts where they are built, particles by plan_particles(), joints by plan_stages(). Who moves
// far for its size joins the flagged customers of `continuous` in find_swept().
void find_in_contacts(const Scene&, const State&, Customers&) {}
void find_particles(const Scene&, const State&, Customers&) {}
void find_joints(const Scene&, const State&, Customers&) {}
void find_booked(const Scene&, const State&, Customers&) {}  // by the ledger itself, as it is no part of the scene

// clang-format off
constexpr std::array<Effect, kEffectCount> kTable = {{
    // stage           name               customers              awake in this step  force                   flow                   decay rate
    {Stage::integrate, "gyroscopic",      gyroscopic::find,      gyroscopic::wakes,  gyroscopic::force,      gyroscopic::flow,      nullptr},
    {Stage::integrate, "linear_damping",  linear_damping::find,  nullptr,            linear_damping::force,  linear_damping::flow,  linear_damping::rate},
    {Stage::integrate, "angular_damping", angular_damping::find, nullptr,            angular_damping::force, angular_damping::flow, angular_damping::rate},
    {Stage::integrate, "gravity",         gravity::find,         nullptr,            gravity::force,         nullptr,               nullptr},
    {Stage::integrate, "user_force",      user_force::find,      nullptr,            user_force::force,      nullptr,               nullptr},
    {Stage::integrate, "user_torque",     user_torque::find,     nullptr,            user_torque::force,     nullptr,               nullptr},
    {Stage::broad,     "collision",       find_colliders,        nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "friction",        find_in_contacts,      nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "restitution",     find_in_contacts,      nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "rolling_resistance",  find_in_contacts,  nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "spinning_resistance", find_in_contacts,  nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::observe,   "sleep",           sleeping::find,        nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::integrate, "particles",       find_particles,        nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::broad,     "filter",          filtering::find,       nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::broad,     "sensor",          sensing::find,         nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "joints",          find_joints,           nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::narrow,    "scenery",         scenery::find,         nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "continuous",      continuous::find,      nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::solve,     "surface_velocity", find_in_contacts,     nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::integrate, "axis_locks",      axis_locks::find,      nullptr,            nullptr,                nullptr,               nullptr},
    {Stage::observe,   "ledger",          find_booked,           nullptr,            nullptr,                nullptr,               nullptr},
}};
// clang-format on

static_assert(kTable[kGyroscopicRow].find == gyroscopic::find && kTable[kSleepRow].find == sleeping::find &&
              kTable[kParticlesRow].find == find_particles && kTable[kFilterRow].find == filtering::find &&
              kTable[kSensorRow].find == sensing::find && kTable[kJointsRow].find == find_joints &&
              kTable[kSceneryRow].find == scenery::find &&
              kTable[kContinuousRow].find == continuous::find &&
              kTable[kSurfaceRow].find == find_in_contacts && kTable[kLocksRow].find == axis_locks::find &&
              kTable[kLinearDampingRow].find == linear_damping::find && kTable[kLedgerRow].find == find_booked);

// As CAROM_ROTATION_*; those after them are rotation methods.
enum RotationChoice : std::uint32_t { kNoGyroscopicTerm, kExplicitTorque, kImplicitStep };

/// Rows, their customers, and whether each is a force or a flow: the one place where these dials are switched.
void plan_rows(World& world, Plan& plan) {
  const Dials& dials = world.scene.dials;
  const Integrator* integrators[] = {&kExplicitEuler, &kSemiImplicitEuler, &kRungeKutta4, &kVelocityVerlet};
  plan.integrator = integrators[dials.choice(Dial::integrator)];
  const Solver* solvers[] = {&kSeverity, &kSequential, &kSoftStep, &kDirect, &kAuto};
  plan.solver = solvers[dials.choice(Dial::solver)];
  plan.watches_speed = dials.choice(Dial::continuous) == kSweepFast;
  const std::uint32_t rotation = dials.choice(Dial::rotation);
  plan.rotation_method = plan.integrator->forces_only ? nullptr : rotation_method(rotation);
  for (PlannedEffect& row : plan.effects) {
    row.candidates.clear();
    const bool gyro = row.effect->force == gyroscopic::force;
    if (!gyro || rotation != kNoGyroscopicTerm) row.effect->find(world.scene, world.state, row.candidates);
    row.rate = row.effect->rate ? row.effect->rate(world.scene, row.candidates) : 0;
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
  plan.scratch_vectors.resize(plan.integrator->vectors * slots, Vec3::Zero());
  plan.scratch_rotations.resize(plan.integrator->rotations * slots, Quat::Identity());
}

/// In every step: a host may add and remove particles in each, and a plan made anew costs as much as all bodies.
void plan_particles(const World& world, Plan& plan) {
  plan.effects[kParticlesRow].customers.count = world.particles.count() - world.particles.held_count();
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
    c.muted[slot] = faulty || world.state.quarantined[body];
    plan.local[slot] = Frame(c.local[slot].q.toRotationMatrix(), c.local[slot].p - world.scene.center[body]);
    if (world.sleep->sleeps(body)) continue;
    c.active.push_back(slot);
    if (c.movable[slot]) plan.colliders.push_back(slot);
  }
  plan.faults.reserve(c.slots());
}

}  // namespace

const std::array<Effect, kEffectCount>& effect_table() { return kTable; }

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
  const std::size_t asleep = c.live.size() - c.active.size(), awake = plan.find("collision")->candidates.count;
  const bool pairs = awake > 0 && awake + asleep >= 2;
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
    plan_stages(world, plan);
    plan_sleep(world, plan);
    plan.revision = world.scene.revision;
  }
  settle_sleepers(world);
  plan_particles(world, plan);
  for (PlannedEffect& row : plan.effects) {
    const Effect& effect = *row.effect;
    if (from_host(effect) && plan.host_wrote && !changed) {
      row.candidates.clear();
      effect.find(world.scene, world.state, row.candidates);
      row.customers = row.candidates;
    }
    // An explicit method is stable only for rate * h below a small number (2 for Euler, 2.8 for RK4); well before,
    // decay is exact.
    if (effect.rate && plan.integrator->forces_only)
      row.served = row.rate * time.dt > plan.substeps ? Served::flow : Served::force;
  }
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

void evaluate_forces(World& world, const Motion& at, const Accelerate& out) {
  for (PlannedEffect& row : world.plan->effects) {
    if (row.served != Served::force || row.customers.count == 0) continue;
    const BookRow book(world, row, out.v, out.omega, out.share);
    row.effect->force(world.scene, world.state, row.customers, at, out);
    row.evaluations += row.customers.count;
  }
}

void evaluate_flows(World& world, Real h, const Quat* q) {
  State& s = world.state;
  for (PlannedEffect& row : world.plan->effects) {
    if (row.served != Served::flow || row.customers.count == 0) continue;
    const BookRow book(world, row, s.v.data(), s.omega.data(), 1);
    row.effect->flow(world.scene, row.customers, h, q, s.v.data(), s.omega.data());
    row.evaluations += row.customers.count;
  }
}

}  // namespace carom

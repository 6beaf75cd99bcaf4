// THE TABLE: every effect of a step, who its customers are, and what serves them. plan.cpp makes the plan from it.
#include "dynamics/effects.h"

#include <algorithm>
#include <string_view>

#include "dynamics/ccd/continuous.h"
#include "dynamics/events/events.h"
#include "dynamics/filter.h"
#include "dynamics/force/force.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

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
constexpr std::array<Effect, kEffectCount> kEffectTable = {{
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

constexpr bool is_row(std::size_t row, const char* name) { return std::string_view(kEffectTable[row].name) == name; }
static_assert(is_row(kGyroscopicRow, "gyroscopic") && is_row(kLinearDampingRow, "linear_damping") &&
              is_row(kAngularDampingRow, "angular_damping") && is_row(kGravityRow, "gravity") &&
              is_row(kUserForceRow, "user_force") && is_row(kUserTorqueRow, "user_torque") &&
              is_row(kCollisionRow, "collision") && is_row(kFrictionRow, "friction") &&
              is_row(kRestitutionRow, "restitution") && is_row(kRollingRow, "rolling_resistance") &&
              is_row(kSpinningRow, "spinning_resistance") && is_row(kSleepRow, "sleep") &&
              is_row(kParticlesRow, "particles") && is_row(kFilterRow, "filter") && is_row(kSensorRow, "sensor") &&
              is_row(kJointsRow, "joints") && is_row(kSceneryRow, "scenery") && is_row(kContinuousRow, "continuous") &&
              is_row(kSurfaceRow, "surface_velocity") && is_row(kLocksRow, "axis_locks") && is_row(kDragRow, "drag") &&
              is_row(kWindRow, "wind") && is_row(kFieldsRow, "fields") && is_row(kSpringsRow, "springs") &&
              is_row(kBuoyancyRow, "buoyancy") && is_row(kResponseRow, "response") &&
              is_row(kLimitsRow, "joint_limits") && is_row(kMotorsRow, "joint_motors") &&
              is_row(kEventsRow, "events") && is_row(kLedgerRow, "ledger"));

}  // namespace

const std::array<Effect, kEffectCount>& effect_table() { return kEffectTable; }

}  // namespace carom::dynamics

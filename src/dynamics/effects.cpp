// THE TABLE: every effect of a step, its participants, and what serves them. plan.cpp makes the plan from it.
#include "dynamics/effects.h"

#include <algorithm>
#include <iterator>

#include "dynamics/ccd/continuous.h"
#include "dynamics/events/events.h"
#include "dynamics/filter.h"
#include "dynamics/force/force.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

void find_colliders(const Scene& scene, const State&, Participants& participants) {
  const Colliders& c = scene.colliders;
  const auto movable = [&](std::uint32_t slot) { return c.movable[slot] != 0; };
  const auto noticing = [&](std::uint32_t slot) { return notices(c, slot); };
  if (c.live.size() < 2 || std::none_of(c.active.begin(), c.active.end(), movable)) return;
  if (std::none_of(c.live.begin(), c.live.end(), noticing)) return;
  for (const std::uint32_t slot : c.active)
    if (!(c.disabled[slot] & Colliders::kFaulty)) participants.add(slot);
}
void everyone(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i)) participants.add(i);
}
void everyone_that_turns(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i) && rotates(scene, i)) participants.add(i);
}

using enum ParticipantKind;

/// Fields that a row leaves out are null; participants that `find` does not find are counted by the stage that makes them
/// (contacts, joints, springs, particles, hosts): count_participants().
// clang-format off
constexpr Effect kEffectRows[] = {
    {.id = EffectId::gyroscopic, .name = "gyroscopic", .stage = Stage::integrate, .participants = bodies,
     .find = gyroscopic::find, .wakes = gyroscopic::wakes, .force = gyroscopic::force, .flow = gyroscopic::flow,
     .everyone = everyone_that_turns,
     .called_by = "bodies with unlike moments of inertia that spin",
     .missing = "no body with unlike moments of inertia, or dial rotation is none"},
    {.id = EffectId::linear_damping, .name = "linear_damping", .stage = Stage::integrate, .participants = bodies,
     .find = linear_damping::find, .force = linear_damping::force, .flow = linear_damping::flow,
     .rate = linear_damping::rate, .everyone = everyone,
     .called_by = "bodies with linear damping",
     .missing = "no body has linear damping"},
    {.id = EffectId::angular_damping, .name = "angular_damping", .stage = Stage::integrate, .participants = bodies,
     .find = angular_damping::find, .force = angular_damping::force, .flow = angular_damping::flow,
     .rate = angular_damping::rate, .everyone = everyone_that_turns,
     .called_by = "bodies with angular damping that turn",
     .missing = "no body that turns has angular damping"},
    {.id = EffectId::gravity, .name = "gravity", .stage = Stage::integrate, .participants = bodies,
     .find = gravity::find, .force = gravity::force, .everyone = everyone,
     .called_by = "bodies with weight",
     .missing = "gravity is zero, or acts on no body"},
    {.id = EffectId::user_force, .name = "user_force", .stage = Stage::integrate, .participants = bodies,
     .find = user_force::find, .force = user_force::force,
     .called_by = "bodies with a force from the host for this step",
     .missing = "the host applied no force in this step"},
    {.id = EffectId::user_torque, .name = "user_torque", .stage = Stage::integrate, .participants = bodies,
     .find = user_torque::find, .force = user_torque::force,
     .called_by = "bodies with a torque from the host for this step",
     .missing = "the host applied no torque in this step"},
    {.id = EffectId::collision, .name = "collision", .stage = Stage::broad, .participants = colliders,
     .find = find_colliders,
     .called_by = "colliders of which two can touch",
     .missing = "no two colliders of which one can move and that their filters let touch"},
    {.id = EffectId::friction, .name = "friction", .stage = Stage::solve, .participants = contact_points,
     .called_by = "contact points with friction",
     .missing = "no pair that touches mixes to a friction above 0"},
    {.id = EffectId::restitution, .name = "restitution", .stage = Stage::solve, .participants = contact_points,
     .called_by = "contact points with a restitution",
     .missing = "no pair that touches mixes to a restitution above 0"},
    {.id = EffectId::rolling_resistance, .name = "rolling_resistance", .stage = Stage::solve, .participants = contact_pairs,
     .called_by = "pairs that resist rolling",
     .missing = "no pair that touches resists rolling"},
    {.id = EffectId::spinning_resistance, .name = "spinning_resistance", .stage = Stage::solve, .participants = contact_pairs,
     .called_by = "pairs that resist spinning",
     .missing = "no pair that touches resists spinning"},
    {.id = EffectId::sleep, .name = "sleep", .stage = Stage::observe, .participants = bodies,
     .find = sleeping::find,
     .called_by = "bodies that are awake and may fall asleep",
     .missing = "dial sleep is off, or all bodies sleep"},
    {.id = EffectId::particles, .name = "particles", .stage = Stage::integrate, .participants = particles,
     .called_by = "particles",
     .missing = "no particles"},
    {.id = EffectId::filter, .name = "filter", .stage = Stage::broad, .participants = colliders,
     .find = filtering::find,
     .called_by = "colliders with a filter",
     .missing = "no collider has a filter"},
    {.id = EffectId::sensor, .name = "sensor", .stage = Stage::broad, .participants = colliders,
     .find = sensing::find,
     .called_by = "sensors",
     .missing = "no collider is a sensor"},
    {.id = EffectId::joints, .name = "joints", .stage = Stage::solve, .participants = joints,
     .called_by = "joints that hold a body which is awake",
     .missing = "no joint holds a body that is awake"},
    {.id = EffectId::scenery, .name = "scenery", .stage = Stage::narrow, .participants = colliders,
     .find = scenery::find,
     .called_by = "meshes and height fields",
     .missing = "no collider is a mesh or height field"},
    {.id = EffectId::continuous, .name = "continuous", .stage = Stage::solve, .participants = bodies,
     .find = continuous::find, .everyone = everyone,
     .called_by = "bodies that are flagged, or fast for their size",
     .missing = "no body is flagged, and none was fast for its size"},
    {.id = EffectId::surface_velocity, .name = "surface_velocity", .stage = Stage::solve, .participants = contact_points,
     .called_by = "contact points on surfaces with a surface velocity",
     .missing = "nothing touches a surface with a surface velocity"},
    {.id = EffectId::axis_locks, .name = "axis_locks", .stage = Stage::integrate, .participants = bodies,
     .find = axis_locks::find,
     .called_by = "bodies with locked axes",
     .missing = "no body has a locked axis"},
    {.id = EffectId::drag, .name = "drag", .stage = Stage::integrate, .participants = bodies,
     .find = drag::find, .force = drag::force, .flow = drag::flow, .rate = drag::rate, .everyone = everyone,
     .called_by = "bodies with drag",
     .missing = "no body has drag"},
    {.id = EffectId::wind, .name = "wind", .stage = Stage::integrate, .participants = bodies,
     .find = wind::find,
     .called_by = "bodies with drag, in a wind",
     .missing = "no wind, or no body has drag"},
    {.id = EffectId::fields, .name = "fields", .stage = Stage::integrate, .participants = bodies,
     .find = fields::find, .force = fields::force, .everyone = everyone,
     .called_by = "bodies in a force field that acts on them",
     .missing = "no force field, or none acts on a body"},
    {.id = EffectId::springs, .name = "springs", .stage = Stage::integrate, .participants = springs,
     .find = springs::find, .force = springs::force,
     .called_by = "springs with an end that moves",
     .missing = "no spring, or all its bodies sleep"},
    {.id = EffectId::buoyancy, .name = "buoyancy", .stage = Stage::integrate, .participants = bodies,
     .find = buoyancy::find, .wakes = buoyancy::wakes, .force = buoyancy::force, .reads_velocities = true,
     .called_by = "bodies in the water",
     .missing = "no water, or no body with a volume in it"},
    {.id = EffectId::response, .name = "response", .stage = Stage::solve, .participants = contact_pairs,
     .called_by = "pairs that touch",
     .missing = "nothing touches"},
    {.id = EffectId::joint_limits, .name = "joint_limits", .stage = Stage::solve, .participants = joints,
     .called_by = "joints with a limit",
     .missing = "no joint with a limit holds a body that is awake"},
    {.id = EffectId::joint_motors, .name = "joint_motors", .stage = Stage::solve, .participants = joints,
     .called_by = "joints with a motor",
     .missing = "no joint with a motor holds a body that is awake"},
    {.id = EffectId::events, .name = "events", .stage = Stage::observe, .participants = hosts,
     .called_by = "a host that collects events",
     .missing = "no host collects events"},
    {.id = EffectId::ledger, .name = "ledger", .stage = Stage::observe, .participants = bodies,
     .called_by = "bodies and particles of which the ledger counts energy and momentum",
     .missing = "no host keeps a ledger"},
    {.id = EffectId::magnetism, .name = "magnetism", .stage = Stage::integrate, .participants = bodies,
     .find = magnetism::find, .force = magnetism::force,
     .called_by = "bodies with a magnetic moment in a magnetic field",
     .missing = "no magnetic field, or no body that turns has a moment"},
};
// clang-format on

/// By number. What has no row, or two, does not compile.
constexpr std::array<Effect, kEffectCount> kEffectTable = [] {
  std::array<Effect, kEffectCount> table{};
  for (const Effect& row : kEffectRows) table[+row.id] = row;
  return table;
}();
static_assert(std::size(kEffectRows) == kEffectCount);
static_assert(std::all_of(kEffectTable.begin(), kEffectTable.end(),
                          [](const Effect& row) { return row.name != nullptr; }));

}  // namespace

const std::array<Effect, kEffectCount>& effect_table() { return kEffectTable; }

void count_participants(const World& world, EffectId id, std::uint64_t count) {
  world.plan->effects[+id].participants.count = count;
}

}  // namespace carom::dynamics

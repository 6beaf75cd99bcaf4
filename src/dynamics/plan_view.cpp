// Reasons in words, and the memory of each effect.
#include "dynamics/plan_view.h"

#include <algorithm>
#include <cstdio>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/events/events.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

template <class... A>
std::uint64_t bytes_of(const A&... arrays) {
  return (std::uint64_t(0) + ... + (arrays.capacity() * sizeof(arrays[0])));
}

/// Held for an effect alone, beside the list of its participants and the attributes of bodies.
std::uint64_t own_bytes(const World& world, std::size_t row) {
  const Scene& s = world.scene;
  const Sleep& z = *world.sleep;
  const Events& e = *world.events;
  switch (row) {
    case +EffectId::gyroscopic:
      return bytes_of(world.plan->principal, world.plan->turns_by_method);
    case +EffectId::restitution:
      return bytes_of(world.contacts->bouncing, world.contacts->impacts);
    case +EffectId::rolling_resistance:
      return bytes_of(world.contacts->resisting);
    case +EffectId::surface_velocity:
      return bytes_of(s.surface, world.contacts->driven, world.contacts->surface);
    case +EffectId::filter:
      return bytes_of(s.colliders.filter);
    case +EffectId::sensor:
      return bytes_of(s.colliders.sensor);
    case +EffectId::sleep:
      return bytes_of(world.state.asleep, z.inactive, z.ring, z.sleep_timer, z.anchor_x, z.anchor_q, z.radius, z.rows,
                      z.kept_first, z.root, z.restless, z.in_tree, z.kept);
    case +EffectId::particles: {
      std::uint64_t sum = 0;
      for (const ParticleSet& set : world.particles.set)
        sum += bytes_of(set.x[0], set.x[1], set.x[2], set.v[0], set.v[1], set.v[2], set.mass, set.held, set.sums);
      return sum;
    }
    case +EffectId::joints:
      return bytes_of(world.joints.joint, world.joints.axes, world.joints.couplings, world.joints.first,
                      world.wide_joints->joints, world.wide_joints->pulls, world.wide_joints->gears,
                      world.wide_joints->axes, world.wide_joints->active, world.wide_joints->linked);
    case +EffectId::continuous:
      return bytes_of(world.continuous->bodies, world.continuous->index, world.continuous->hits);
    case +EffectId::axis_locks:
      return bytes_of(s.locks);
    case +EffectId::fields:
      return bytes_of(s.fields.def);
    case +EffectId::springs:
      return bytes_of(s.springs.def, s.springs.stiffness, s.springs.damping, s.springs.ends, s.springs.load);
    case +EffectId::buoyancy: {
      std::uint64_t sum = bytes_of(s.water.float_of, s.water.floats);
      for (const Float& f : s.water.floats) sum += bytes_of(f.corner);
      return sum;
    }
    case +EffectId::events:
      return bytes_of(e.contacts, e.sensors, e.sleep, e.joints, e.faults, e.touching, e.within, e.spare, e.approach,
                      e.sensor_pairs, e.slept);
    case +EffectId::ledger:
      if (!world.ledger) return 0;
      return sizeof(Ledger) + bytes_of(world.ledger->body, world.ledger->kicks, world.ledger->probe,
                                       world.ledger->body_amount, world.ledger->set_amount, world.ledger->old_points,
                                       world.ledger->old_pairs, world.ledger->old_rows, world.ledger->old_drives);
    default:
      return 0;
  }
}

const char* unit_of(ParticipantKind kind) {
  static constexpr const char* kUnits[] = {"bodies",  "colliders", "contact points", "contact pairs",
                                           "springs", "joints",    "particles",      "hosts"};
  return kUnits[static_cast<std::size_t>(kind)];
}

/// Effects within the loops of a stage: their time is part of the stage's.
bool is_in_stage(std::size_t row) {
  for (const std::size_t inside :
       {+EffectId::friction, +EffectId::spinning_resistance, +EffectId::surface_velocity, +EffectId::response,
        +EffectId::joints, +EffectId::joint_limits, +EffectId::joint_motors, +EffectId::filter, +EffectId::sensor,
        +EffectId::scenery, +EffectId::axis_locks, +EffectId::wind, +EffectId::ledger})
    if (row == inside) return true;
  return false;
}

Timing timing_of(const World& world, std::size_t row, const PlannedEffect& effect) {
  if (is_in_stage(row)) return Timing::in_stage;
  if (effect.served == Served::stage && effect.effect->force) return Timing::in_stage;  // by a rotation method
  return effect.effect->force && !world.times_effects ? Timing::off : Timing::own;
}

/// Whether two colliders could touch if all were awake.
bool could_touch(const World& world) {
  const Colliders& c = world.scene.colliders;
  return c.live.size() >= 2 &&
         std::any_of(c.live.begin(), c.live.end(), [&](std::uint32_t i) { return notices(c, i); });
}

/// Whether it is but for sleep that a stage has nothing to do, or an effect no participant.
bool all_asleep(const World& world, Stage stage) {
  if (world.sleep->count == 0) return false;
  switch (stage) {
    case Stage::broad:
    case Stage::narrow:
      return could_touch(world);
    case Stage::group:
    case Stage::solve:
    case Stage::relax:
      return could_touch(world) || world.joints.slots.alive_count() > 0;
    default:
      return true;
  }
}
bool all_asleep(const World& world, std::size_t row, const PlannedEffect& effect) {
  const Sleep& z = *world.sleep;
  if (z.count == 0) return false;
  switch (effect.effect->participants) {
    case ParticipantKind::bodies:
      for (std::uint32_t i = 0; i < z.rows.size(); ++i)
        if (world.state.sleeps(i) && (z.rows[i] & row_bit(row))) return true;
      return false;
    case ParticipantKind::springs:
      return world.scene.springs.slots.alive_count() > 0;
    case ParticipantKind::joints:
      return row == +EffectId::joints && world.joints.slots.alive_count() > 0;
    case ParticipantKind::colliders:
      return row == +EffectId::collision && could_touch(world);
    default:
      return false;
  }
}

constexpr const char* kAllAsleep = "all asleep";

/// Whether an effect ran in the last step.
bool ran(const World& world, const PlannedEffect& effect) {
  if (effect.participants.count == 0) return false;
  return world.plan->runs[static_cast<std::size_t>(effect.effect->stage)];
}

void explain(const World& world, std::size_t row, const PlannedEffect& effect, PlanLine& line) {
  const Effect& e = *effect.effect;
  const auto say = [&](const char* text) { std::snprintf(line.reason, sizeof line.reason, "%s", text); };
  const auto count = [&](const char* form, auto first, auto... values) {
    std::snprintf(line.reason, sizeof line.reason, form, first, values...);
  };
  const auto participants = static_cast<unsigned long long>(effect.participants.count);
  const auto wanted = static_cast<unsigned long long>(line.wanted);
  const bool of_bodies = world.scene.modes.forbidden_anywhere & row_bit(row);
  if (line.mode == EffectMode::forbid && wanted > 0)
    return count("forbidden by the host, though the scene calls for it: %llu %s", wanted, line.unit);
  if (line.mode == EffectMode::forbid) return say("forbidden by the host");
  if (line.mode == EffectMode::force && line.runs)
    return count("forced by the host on %llu %s; the scene calls for %llu", participants, line.unit, wanted);
  if (line.mode == EffectMode::force)
    return count("forced by the host, but there is nothing it can act on: %s", e.missing);
  if (row == +EffectId::springs && line.runs && world.scene.springs.softened > 0)
    return count("%llu springs, %llu stiffer than a substep resolves: softened; more substeps, or joints", participants,
                 static_cast<unsigned long long>(world.scene.springs.softened));
  if (line.runs && of_bodies && wanted > participants)
    return count("%s: %llu of %llu, the host forbids it to the others", e.called_by, participants, wanted);
  if (line.runs) return say(e.called_by);
  if (of_bodies && wanted > 0) return count("the host forbids it to all %llu %s that call for it", wanted, line.unit);
  if (wanted > 0 && e.wakes) return count("%llu %s may call for it, none did in this step", wanted, line.unit);
  say(all_asleep(world, row, effect) ? kAllAsleep : e.missing);
}

PlanLine stage_line(const World& world, std::size_t index) {
  static constexpr const char* kNoTwo = "no two colliders of which one can move and that their filters let touch";
  static constexpr const char* kWhy[kStageCount][2] = {
      {"every step: what takes part in which effect", ""},
      {"colliders of which two can touch", kNoTwo},
      {"pairs that may touch", kNoTwo},
      {"contacts and joints form islands", "nothing can touch, and no joint holds a body that is awake"},
      {"bodies and particles that move", "nothing moves"},
      {"contacts or joints to be solved", "nothing can touch, and no joint holds a body that is awake"},
      {"position errors at contacts and joints", "no position errors"},
      {"every step: what happened", ""}};
  PlanLine line;
  line.stage = static_cast<Stage>(index);
  line.runs = world.plan->runs[index] && world.report.steps > 0;
  line.seconds = world.report.stage_seconds[index];
  line.name = stage_name(line.stage);
  const bool fresh = world.report.steps == 0;
  const char* const why = !line.runs && all_asleep(world, line.stage) ? kAllAsleep : kWhy[index][line.runs ? 0 : 1];
  std::snprintf(line.reason, sizeof line.reason, "%s", fresh ? "no step yet" : why);
  return line;
}

}  // namespace

PlanLine plan_line(const World& world, std::size_t index) {
  if (index < kStageCount) return stage_line(world, index);
  const std::size_t row = index - kStageCount;
  const PlannedEffect& effect = world.plan->effects[row];
  PlanLine line;
  line.effect = static_cast<std::uint32_t>(row);
  line.stage = effect.effect->stage;
  line.mode = world.scene.modes.of_world(row);
  line.name = effect.effect->name;
  line.unit = unit_of(effect.effect->participants);
  line.bytes = own_bytes(world, row) + world.scene.attributes.bytes_of(effect.effect->id) +
               bytes_of(effect.candidates.runs, effect.participants.runs);
  line.timing = timing_of(world, row, effect);
  if (world.report.steps == 0) {
    std::snprintf(line.reason, sizeof line.reason, "no step yet");
    return line;
  }
  line.runs = ran(world, effect);
  line.participants = line.runs ? effect.participants.count : 0;
  // What is found in contacts, or is fast for its size, was not counted before.
  line.wanted =
      line.mode == EffectMode::force ? effect.wanted : std::max<std::uint64_t>(effect.wanted, line.participants);
  line.evaluations = effect.evaluations;
  line.seconds = line.timing == Timing::own ? effect.seconds : 0;
  explain(world, row, effect, line);
  return line;
}

}  // namespace carom::dynamics

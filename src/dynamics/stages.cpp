#include "dynamics/stages.h"

#include <algorithm>

#include "core/hash.h"
#include "dynamics/accuracy/accuracy.h"
#include "dynamics/begin_substep.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/asked_again.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact/impact.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/contact/resistance.h"
#include "dynamics/contact/seams.h"
#include "dynamics/contact/surface.h"
#include "dynamics/detect.h"
#include "dynamics/events/events.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/integrate/free_flight.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/island.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/observe.h"
#include "dynamics/particles/flight.h"
#include "dynamics/quarantine.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/direct.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

constexpr Parts kMotion = Part::poses | Part::velocities;
constexpr Parts kContactsRead = Part::pairs | Part::colliders | kMotion;

// clang-format off
constexpr StageEntry kStageTable[] = {
    // ---- once: what takes part in which effect, and the contacts. All that allocates stands here. ----
    stage<admit>({.name = "admit",
     .what = "bodies with a state out of range go into quarantine; only after a host wrote to them",
     .stage = Stage::refresh, .reads = kMotion | Part::forces, .account = LedgerAccount::with_host}),
    stage<refresh>({.name = "refresh",
     .what = "participants of each effect, if the scene changed; frames and bounds of colliders",
     .stage = Stage::refresh, .reads = kMotion | Part::sleep | Part::quarantine}),
    stage<find_led>({.name = "find led",
     .what = "kinematic bodies whose velocity goes on changing, to be led evenly",
     .stage = Stage::refresh, .reads = kMotion | Part::memory}),
    stage<wake_touched>({.name = "wake touched",
     .what = "islands asleep that something touches, or will within the step",
     .stage = Stage::refresh, .reads = kContactsRead | Part::sleep, .account = LedgerAccount::opens}),
    stage<find_pairs>({.name = "find pairs",
     .what = "colliders whose bounds overlap",
     .stage = Stage::broad, .effect = +EffectId::collision,
     .reads = Part::colliders | Part::sleep}),
    stage<find_contacts>({.name = "find contacts",
     .what = "contact points of those pairs",
     .stage = Stage::narrow, .effect = +EffectId::collision,
     .reads = kContactsRead}),
    stage<leave_to_sweep>({.name = "leave to sweep",
     .what = "contacts that the sweep of a fast body finds more exactly are left out",
     .stage = Stage::narrow, .effect = +EffectId::continuous,
     .reads = kContactsRead}),
    stage<leave_out_ghosts>({.name = "leave out ghosts",
     .what = "contacts at seams of flush colliders that other contacts of the body take the place of",
     .stage = Stage::narrow, .effect = +EffectId::collision,
     .reads = kContactsRead | Part::sleep}),
    stage<make_rows>({.name = "make rows",
     .what = "a row of the solver for each contact point, with the impulse of the last step",
     .stage = Stage::group, .reads = kContactsRead | Part::impulses}),
    stage<find_resistance>({.name = "find resistance",
     .what = "pairs that resist rolling or spinning",
     .stage = Stage::group, .reads = Part::pairs | Part::impulses}),
    stage<find_surfaces>({.name = "find surfaces",
     .what = "pairs with a surface velocity",
     .stage = Stage::group, .reads = kContactsRead}),
    stage<try_rattle>({.name = "try rattle",
     .what = "islands of joints and forces alone take their step by RATTLE, if joint_order or an accuracy is set",
     .stage = Stage::integrate, .reads = kContactsRead | Part::joints | Part::forces,
     .account = LedgerAccount::by_itself}),
    stage<link_joints>({.name = "link joints",
     .what = "joints of awake bodies",
     .stage = Stage::group, .reads = Part::joints, .by_island = ByIsland::too}),
    stage<list_moved_bodies>({.name = "list moved bodies",
     .what = "bodies that rows or joints move",
     .stage = Stage::group, .reads = Part::sleep, .by_island = ByIsland::too}),
    stage<find_groups>({.name = "find groups",
     .what = "islands: contacts and joints that bodies connect",
     .stage = Stage::group, .by_island = ByIsland::too}),
    stage<begin_leading>({.name = "begin leading",
     .what = "they get the velocity of the first substep",
     .stage = Stage::integrate, .account = LedgerAccount::by_itself, .by_island = ByIsland::too}),
    stage<begin_contacts>({.name = "begin contacts",
     .what = "arrays of the solver for a step",
     .stage = Stage::solve, .reads = kMotion | Part::joints,
     .account = LedgerAccount::reserves, .by_island = ByIsland::alone}),
    stage<begin_sweeps>({.name = "begin sweeps",
     .what = "which bodies are swept, and what stands in their way",
     .stage = Stage::solve, .effect = +EffectId::continuous,
     .reads = kContactsRead}),
    stage<find_lone_rollers>({.name = "find lone rollers",
     .what = "bodies that touch flat surfaces and nothing else, as they are",
     .stage = Stage::solve, .reads = kContactsRead | Part::forces}),
    stage<begin_events>({.name = "begin events",
     .what = "approach speeds of bodies, if a host collects contact events",
     .stage = Stage::observe, .effect = +EffectId::events,
     .reads = kContactsRead}),
    stage<reserve_begun>({.name = "reserve",
     .what = "memory for what substeps save",
     .stage = Stage::solve, .by_island = ByIsland::alone}),
    stage<defer_free_bodies>({.name = "defer free bodies",
     .what = "bodies in free flight wait until the others had their substeps",
     .stage = Stage::integrate}),
    // ---- each substep ----
    stage<begin_substep>({.name = "begin substep",
     .what = "kinematic bodies are led; velocities and gaps before the forces are saved for all that need them",
     .stage = Stage::solve, .reads = kMotion, .account = LedgerAccount::by_itself, .each_substep = true}),
    stage<ask_again>({.name = "ask again",
     .what = "contacts of what turns far within a step, where they are by now",
     .stage = Stage::narrow, .effect = +EffectId::collision, .reads = kContactsRead, .each_substep = true}),
    stage<integrate_velocity>({.name = "integrate velocity",
     .what = "forces change velocities",
     .stage = Stage::integrate,
     .reads = kMotion | Part::forces, .account = LedgerAccount::forces, .each_substep = true}),
    stage<save_accelerations>({.name = "save accelerations",
     .what = "accelerations of swept bodies, for their paths",
     .stage = Stage::solve, .effect = +EffectId::continuous,
     .reads = Part::velocities, .each_substep = true}),
    stage<solve_impacts>({.name = "solve impacts",
     .what = "impacts: restitution, each contact at its moment",
     .stage = Stage::solve, .effect = +EffectId::restitution,
     .reads = kMotion, .account = LedgerAccount::impacts, .each_substep = true}),
    stage<hold_moments>({.name = "hold moments",
     .what = "warm start of resistance to rolling and spinning",
     .stage = Stage::solve, .effect = +EffectId::rolling_resistance,
     .reads = kMotion | Part::impulses, .account = LedgerAccount::moments, .each_substep = true}),
    stage<solve_velocities>({.name = "solve velocities",
     .what = "joints and contacts change velocities",
     .stage = Stage::solve,
     .reads = kMotion | Part::joints | Part::impulses, .account = LedgerAccount::solver,
     .each_substep = true}),
    stage<integrate_position>({.name = "integrate position",
     .what = "bodies move",
     .stage = Stage::integrate, .reads = kMotion,
     .account = LedgerAccount::moves, .each_substep = true}),
    stage<solve_positions>({.name = "solve positions",
     .what = "penetration is pushed apart, or the velocity that did so is removed",
     .stage = Stage::relax, .reads = kMotion | Part::joints,
     .account = LedgerAccount::relaxation, .each_substep = true}),
    stage<resist>({.name = "resist",
     .what = "resistance to rolling and spinning by the loads that are known now",
     .stage = Stage::solve, .effect = +EffectId::rolling_resistance, .reads = kMotion,
     .account = LedgerAccount::resistance, .each_substep = true}),
    stage<sweep>({.name = "sweep",
     .what = "a fast body stops at what is in its way, bounces there and continues",
     .stage = Stage::solve, .effect = +EffectId::continuous, .reads = kContactsRead,
     .account = LedgerAccount::sweeps, .each_substep = true}),
    stage<close_joints>({.name = "close joints",
     .what = "what hangs by joints on a body that a sweep has stopped follows it",
     .stage = Stage::solve, .effect = +EffectId::continuous, .reads = kMotion | Part::joints,
     .account = LedgerAccount::sweeps, .each_substep = true}),
    // ---- once: what is left of the step, and its reports ----
    stage<stop_leading>({.name = "stop leading",
     .what = "kinematic bodies have the velocity that the host said",
     .stage = Stage::integrate, .account = LedgerAccount::by_itself}),
    stage<quarantine_outliers>({.name = "quarantine outliers",
     .what = "bodies with a state out of range go into quarantine",
     .stage = Stage::solve, .reads = kMotion, .account = LedgerAccount::lost_bodies}),
    stage<integrate_free_bodies>({.name = "move free bodies",
     .what = "bodies in free flight take the whole step at once",
     .stage = Stage::integrate, .reads = kMotion | Part::forces, .account = LedgerAccount::by_itself}),
    stage<integrate_particles>({.name = "integrate particles",
     .what = "all substeps at once",
     .stage = Stage::integrate, .effect = +EffectId::particles, .reads = Part::particles,
     .account = LedgerAccount::particles}),
    stage<end_contacts>({.name = "end contacts",
     .what = "impulses are copied from lanes to rows; overloaded joints break",
     .stage = Stage::solve, .reads = kMotion | Part::joints,
     .account = LedgerAccount::corrections, .by_island = ByIsland::alone}),
    stage<roll_alone>({.name = "roll alone",
     .what = "lone bodies that stick all step long move by their equation of motion instead",
     .stage = Stage::solve, .reads = kMotion, .account = LedgerAccount::corrections}),
    stage<take_rattle>({.name = "take rattle",
     .what = "poses and velocities of islands that took RATTLE; overloaded joints break",
     .stage = Stage::integrate, .reads = kMotion | Part::joints, .account = LedgerAccount::by_itself}),
    stage<save_accuracy>({.name = "save accuracy",
     .what = "error estimates of bodies, if an accuracy is set",
     .stage = Stage::observe}),
    stage<end_sweeps>({.name = "end sweeps",
     .what = "shapes whose support function failed are disabled",
     .stage = Stage::solve, .effect = +EffectId::continuous}),
    stage<observe>({.name = "observe",
     .what = "penetration and energies; impulses for the next step",
     .stage = Stage::observe, .reads = kContactsRead | Part::joints}),
    stage<fall_asleep>({.name = "fall asleep",
     .what = "islands that came to rest",
     .stage = Stage::observe, .effect = +EffectId::sleep,
     .reads = kMotion | Part::pairs | Part::sleep,
     .account = LedgerAccount::sleepers}),
    stage<end_events>({.name = "end events",
     .what = "contacts that began, ended or were hit; sensors; sleep",
     .stage = Stage::observe, .effect = +EffectId::events,
     .reads = kContactsRead | Part::sleep}),
    stage<save_moved_bodies>({.name = "save moved bodies",
     .what = "bounds for queries between steps",
     .stage = Stage::observe, .reads = kMotion,
     .account = LedgerAccount::closes}),
};
// clang-format on

/// What the ledger accounts for: what changes it says which account that enters.
constexpr bool all_writers_have_accounts() {
  for (const StageEntry& entry : kStageTable)
    if (entry.writes.meets(kMotion | Part::particles) && entry.account == LedgerAccount::none) return false;
  return true;
}
static_assert(all_writers_have_accounts(), "a stage moves bodies or particles, and the ledger does not know of it");

constexpr bool substeps_stand_together() {
  int changes = 0;
  for (std::size_t i = 1; i < std::size(kStageTable); ++i)
    changes += kStageTable[i].each_substep != kStageTable[i - 1].each_substep;
  return changes == 2 && !kStageTable[0].each_substep;
}
static_assert(substeps_stand_together());

template <class T>
void add_all(Hash& h, const Array<T>& of) {
  h.add(std::uint64_t(of.size()));
  for (const T& x : of) {
    if constexpr (requires { x.at; })
      h.add_coefficients(x);
    else if constexpr (std::is_floating_point_v<T>)
      h.add(double(x));
    else
      h.add(std::uint64_t(x));
  }
}

void add_colliders(Hash& h, const World& world) {
  const Colliders& c = world.scene.colliders;
  for (const Frame& f : c.frame) h.add_coefficients(f.r), h.add_coefficients(f.p);
  for (const Aabb& b : c.bounds) h.add_coefficients(b.lo), h.add_coefficients(b.hi);
  add_all(h, c.disabled), add_all(h, c.active);
  add_all(h, world.state.placed_x), add_all(h, world.state.placed_q);
}

void add_particles(Hash& h, const World& world) {
  for (const ParticleSet& set : world.particles.set)
    for (int axis = 0; axis < 3; ++axis) {
      for (const Real x : set.x[static_cast<std::size_t>(axis)]) h.add(double(x));
      for (const Real v : set.v[static_cast<std::size_t>(axis)]) h.add(double(v));
    }
}

void add_joints(Hash& h, const World& world) {
  for (const Joint& joint : world.joints.joint) {
    for (const Real p : joint.p) h.add(double(p));
    for (const Real p : joint.drive_p) h.add(double(p));
    h.add_coefficients(joint.turn.p);
    h.add(double(joint.p_h)), h.add(std::uint64_t(joint.broken));
    h.add_coefficients(joint.force), h.add_coefficients(joint.torque);
  }
  for (const JointAxes& axes : world.joints.axes)
    for (const auto& of_axis : axes.p)
      for (const Real p : of_axis) h.add(double(p));
  h.add(std::uint64_t(world.scene.joined.size()));
}

void add_pairs(Hash& h, const World& world) {
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    const PairRecord& record = world.pairs[i];
    h.add(world.pairs.place(i).pair.key());
    for (int k = 0; k < record.manifold.count; ++k) h.add_coefficients(record.manifold.point[k].on_a);
  }
}

void add_impulses(Hash& h, const World& world) {
  for (const OldImpulse& old : world.impulses.old) {
    h.add(std::uint64_t(old.pair.a) << 32 | old.pair.b);
    h.add_coefficients(old.p), h.add_coefficients(old.moment), h.add_coefficients(old.place);
  }
}

void add_sleep(Hash& h, const World& world) {
  const Sleep& z = *world.sleep;
  add_all(h, world.state.asleep), add_all(h, z.inactive), add_all(h, z.sleep_timer), add_all(h, z.woken),
      add_all(h, z.fallen);
  h.add(z.count), h.add(z.woke), h.add(std::uint64_t(z.kept.size()));
}

void add_events(Hash& h, const Events& e) {
  add_all(h, e.slept), add_all(h, e.approach);
  h.add(std::uint64_t(e.sensor_pairs.size())), h.add(std::uint64_t(e.joints.size()));
  for (const auto* list : {&e.touching, &e.within})
    for (const Together& t : *list) h.add(std::uint64_t(t.pair.a) << 32 | t.pair.b);
}

}  // namespace

const char* part_name(Part part) {
  static constexpr const char* kNames[] = {"colliders", "poses",  "velocities", "forces", "quarantine",
                                           "sleep",     "memory", "particles",  "joints", "pairs",
                                           "impulses",  "events", "revisions"};
  static_assert(std::size(kNames) == kPartCount);
  const auto i = static_cast<std::size_t>(part);
  return i < kPartCount ? kNames[i] : "?";
}

std::span<const StageEntry> stage_table() { return kStageTable; }

std::array<std::uint64_t, kPartCount> prints_of(const World& world) {
  std::array<Hash, kPartCount> hash;
  const auto of = [&](Part part) -> Hash& { return hash[static_cast<std::size_t>(part)]; };
  const State& s = world.state;
  add_colliders(of(Part::colliders), world);
  add_all(of(Part::poses), s.x), add_all(of(Part::poses), s.q);
  add_all(of(Part::velocities), s.v), add_all(of(Part::velocities), s.omega), add_all(of(Part::velocities), s.momentum);
  add_all(of(Part::forces), s.force), add_all(of(Part::forces), s.torque);
  add_all(of(Part::quarantine), s.held_out);
  add_sleep(of(Part::sleep), world);
  add_all(of(Part::memory), s.held_q), add_all(of(Part::memory), s.loaded_steps),
      add_all(of(Part::memory), s.cooldown_steps);
  for (const DrivenMemory& d : s.driven) {
    of(Part::memory).add(std::uint64_t(handle_slot(d.body))), of(Part::memory).add(double(d.dt));
    for (const Vec3& of_body : {d.v, d.omega, d.a, d.alpha}) of(Part::memory).add_coefficients(of_body);
  }
  for (const AccuracyMemory& note : s.accuracy)
    of(Part::memory).add(std::uint64_t(note.level + 256u * note.wait)), of(Part::memory).add(double(note.place));
  add_particles(of(Part::particles), world);
  add_joints(of(Part::joints), world);
  add_pairs(of(Part::pairs), world);
  add_impulses(of(Part::impulses), world);
  add_events(of(Part::events), *world.events);
  of(Part::revisions).add(world.scene.revision), of(Part::revisions).add(world.scene.collider_revision);
  of(Part::revisions).add(std::uint64_t(world.scene.alarm));
  std::array<std::uint64_t, kPartCount> prints;
  std::transform(hash.begin(), hash.end(), prints.begin(), [](const Hash& h) { return h.value(); });
  return prints;
}

Parts run_watched(const StageEntry& entry, World& world, const StepTime& time) {
  const auto before = prints_of(world);
  entry.run(world, time);
  const auto after = prints_of(world);
  Parts changed;
  for (std::size_t i = 0; i < kPartCount; ++i)
    if (before[i] != after[i]) changed |= static_cast<Part>(i);
  return changed.without(entry.writes);
}

}  // namespace carom::dynamics

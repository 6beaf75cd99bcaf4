// Passes: set up, judged, and put in place.
#include "dynamics/accuracy/passes.h"

#include <algorithm>
#include <utility>

#include "dynamics/accuracy/accuracy.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/contact/turning_ground.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/free_flight.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/island.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/solver/table.h"

namespace carom::dynamics {

Passes::Passes(Memory* m)
    : islands(m),
      movers(m),
      members(m),
      island_of(m),
      parent(m),
      begun(m),
      ended(m),
      coarse(m),
      driven_begun(m),
      joint_begun(m),
      joint_ended(m),
      all_active(m),
      active(m),
      packed_active(m),
      rows(m),
      geometry(m),
      contact_pairs(m),
      bouncing(m),
      resisting(m),
      resisting_ended(m),
      driven(m),
      turning_pairs(m),
      group_views(m),
      those(m),
      scratch(m),
      lists(m) {}

namespace accuracy {
namespace {

bool runs_joint(const World& world, const Passes& p, std::uint32_t slot) {
  const JointDef& def = world.joints.joint[slot].def;
  return (def.body_a != kInvalid && runs(p, def.body_a)) || (def.body_b != kInvalid && runs(p, def.body_b));
}

/// The substeps of the next pass, and whose it is: of all that run, the fewest first.
int choose(Passes& p) {
  int fewest = 0;
  for (const Passes::Island& island : p.islands)
    if (island.trial.run > 0 && (fewest == 0 || island.trial.run < fewest)) fewest = island.trial.run;
  for (Passes::Island& island : p.islands) island.runs = fewest > 0 && island.trial.run == fewest;
  return fewest;
}

/// All that a sweep may change, at once, by the dial's substeps: a hit has no half a substep to be compared with.
bool choose_swept(const World& world, Passes& p) {
  p.is_sweeping = std::exchange(p.is_to_sweep, false);
  world.continuous->waits = !p.is_sweeping;
  if (p.is_sweeping)
    for (Passes::Island& island : p.islands) island.runs = island.is_swept;
  return p.is_sweeping;
}

/// What the ledger is told of: the accepted runs alone, each once more.
bool choose_to_account(Passes& p) {
  if (!p.is_accounted || p.is_accounting) return false;
  p.is_accounting = true;
  for (Passes::Island& island : p.islands) island.trial.run = island.trial.taken;
  return true;
}

bool runs_pair(const Passes& p, bool moves_a, std::uint32_t a, std::uint32_t b) { return runs(p, moves_a ? a : b); }

/// Rows as they were made, for substeps of another length; lists of those that run.
/// @param scale  of impulses
void set_contacts(const World& world, const Passes& p, Real scale) {
  Contacts& c = *world.contacts;
  c.contact_pairs.clear(), c.bouncing.clear(), c.impacts.clear(), c.resisting.clear(), c.driven.clear(),
      c.turning_pairs.clear();
  for (const ContactPair& m : p.contact_pairs) {
    if (!runs_pair(p, m.moves_a, m.a, m.b)) continue;
    c.contact_pairs.push_back(m);
    for (std::uint32_t k = m.row; k < m.row + m.count; ++k) {
      c.rows[k] = p.rows[k], c.geometry[k] = p.geometry[k];
      if (scale != 1) c.rows[k].set_impulse(scale * p.rows[k].p);
    }
  }
  const auto is_in = [&](std::uint32_t row) { return runs_pair(p, p.rows[row].moves_a, p.rows[row].a, p.rows[row].b); };
  for (const std::uint32_t k : p.bouncing) {
    if (!is_in(k)) continue;
    c.geometry[k].impact = static_cast<std::uint32_t>(c.impacts.size());
    c.bouncing.push_back(k);
    c.impacts.emplace_back().row = k;
  }
  for (const Resistance& r : p.resisting) {
    if (!is_in(r.row)) continue;
    c.resisting.push_back(r);
    if (scale != 1) c.resisting.back().moment *= scale;
  }
  for (const Driven& d : p.driven)
    if (is_in(d.row)) c.driven.push_back(d);
  for (const TurningPair& t : p.turning_pairs)
    if (is_in(t.row)) c.turning_pairs.push_back(t);
  number_turning_pairs(c);
}

/// Of the pass that ended, into the lists of all: impulses for substeps of the plan's length.
void keep_contacts(const World& world, Passes& p, Real scale) {
  Contacts& c = *world.contacts;
  const auto is_accepted = [&](std::uint32_t row) {
    const Row& r = c.rows[row];
    return p.islands[p.island_of[r.moves_a ? r.a : r.b]].trial.run == 0;
  };
  for (const ContactPair& m : c.contact_pairs) {
    if (!is_accepted(m.row)) continue;
    for (std::uint32_t k = m.row; scale != 1 && k < m.row + m.count; ++k) c.rows[k].set_impulse(scale * c.rows[k].p);
  }
  auto to = p.resisting_ended.begin();
  for (const Resistance& r : c.resisting) {
    to = std::lower_bound(to, p.resisting_ended.end(), r.row,
                          [](const Resistance& a, std::uint32_t row) { return a.row < row; });
    if (!is_accepted(r.row)) continue;
    *to = r;
    to->moment *= scale;
  }
}

void set_joints(const World& world, Passes& p) {
  WideJoints& w = *world.wide_joints;
  p.active.clear();
  for (const std::uint32_t j : p.all_active)
    if (runs_joint(world, p, j)) p.active.push_back(j);
  if (p.active != p.packed_active) w.is_packed = false, p.packed_active = p.active;
  w.active = p.active;
}

void orient(const World& world, const Passes& p) {
  Plan& plan = *world.plan;
  if (plan.rotation.empty()) return;
  const auto turn = [&](std::uint32_t i) { plan.rotation[i] = world.state.q[i].matrix(); };
  for (const std::uint32_t i : p.movers)
    if (runs(p, i) && rotates(world.scene, i)) turn(i);
  plan.kinematic.each(turn);
}

/// Whose contacts were springs in this pass.
void find_soft(const World& world, Passes& p) {
  const Solver* const solver = world.plan->solver;
  for (Passes::Island& island : p.islands) island.is_soft = island.runs && solver == &kSoftStep && island.rows > 0;
  for (const GroupView& view : world.group_views)
    if (!view.direct && view.points > 0 && runs(p, view.body)) p.islands[p.island_of[view.body]].is_soft = true;
}

/// What rolls alone ends elsewhere than the solver leaves it. Alone it is alone in its island, too.
BodyEnd end_of(const World& world, std::uint32_t i, Real dt) {
  TouchingMotion::At at;
  if (ends_alone(world, i, dt, at)) return {at.x, at.v, at.omega, at.q};
  const State& s = world.state;
  return {s.x[i], s.v[i], s.omega[i], s.q[i]};
}

/// Whether something of an island in contact would come to rest within another step, of as much change of velocity.
/// Where it does lies within that step, so it is estimated: by one substep it is off by half of that change times dt.
bool may_stop(const World& world, const Passes& p, const Passes::Island& island) {
  const Dials& dials = world.scene.dials;
  const auto stops = [](const Vec3& now, const Vec3& before, Real borne) {
    const Real change = (now - before).norm();
    return borne > 0 && change > borne && now.norm() < kAccuracyStop * change;
  };
  if (island.rows == 0 || island.bodies > kAccuracyFew) return false;
  bool any = false;
  each_member(p, island, [&](std::uint32_t k, std::uint32_t) {
    any |= stops(p.ended[k].v, p.begun[k].v, dials[Dial::accuracy_place]) ||
           stops(p.ended[k].omega, p.begun[k].omega, dials[Dial::accuracy_turn]);
  });
  return any;
}

/// An island's run has ended.
void judge(const World& world, Passes& p, Passes::Island& island, const Borne& borne, Real dt) {
  const State& s = world.state;
  bool went_well = true;
  const Real horizon = island.rows > 0 ? kAccuracyHorizonTouching.value : kAccuracyHorizon.value;
  Shares apart;
  each_member(p, island, [&](std::uint32_t k, std::uint32_t i) {
    const BodyEnd end = end_of(world, i, dt);
    went_well &= is_finite(end) && (!s.held_out[i] || p.begun[k].held_out);
    if (island.trial.coarse > 0)
      add_apart(apart, p.coarse[k], end, world.scene.inertia[i], world.scene.inv_inertia[i], horizon, borne);
  });
  if (p.is_accounting || p.is_sweeping) {
    island.trial.run = 0;
    return keep_ended(world, island);
  }
  island.memory.softly = island.is_soft;
  if (island.is_soft && island.trial.run < borne.least_soft && island.trial.least < island.trial.highest_least())
    return island.trial.raise_least(borne.least_soft);
  switch (island.trial.end_run(went_well, apart)) {
    case End::accepted:
      return keep_ended(world, island);
    case End::compared:
      return each_member(p, island, [&](std::uint32_t k, std::uint32_t i) { p.coarse[k] = end_of(world, i, dt); });
    case End::dropped:
      return;
  }
}

/// The plan has all of its bodies again, and its substeps.
void put_back_lists(const World& world, Passes& p) {
  exchange_lists(*world.plan, p.lists);
  world.plan->substeps = p.substeps;
  world.plan->in_pass = p.is_running = false;
  if (p.is_accounted) world.ledger->is_paused = false;
}

/// All that stages after the passes read.
void put_back_contacts(const World& world, Passes& p, const StepTime& time) {
  Contacts& c = *world.contacts;
  c.contact_pairs = p.contact_pairs, c.bouncing = p.bouncing, c.resisting = p.resisting_ended, c.driven = p.driven,
  c.turning_pairs = p.turning_pairs;
  number_turning_pairs(c);
  world.wide_joints->active = p.all_active;
  if (p.packed_active != p.all_active) world.wide_joints->is_packed = false, p.packed_active.clear();
  link_joints(world, time);
  c.direct.clear();
  partition_rows(c, world.scene.bodies.slots(), world.scene.dials.choice(Dial::groups) != 0, world.jobs);
  for (const std::uint32_t i : c.bodies) c.is_bound[i] = 0;
  c.bodies.clear();
  for (const std::uint32_t i : p.movers) {
    if (p.islands[p.island_of[i]].rows + p.islands[p.island_of[i]].links == 0) continue;
    c.is_bound[i] = 1;
    c.bodies.push_back(i);
  }
}

}  // namespace

void begin(const World& world, Owned<Accuracy>& a) {
  if (!is_on(world.scene.dials)) return a.reset();
  if (!a) a = make_owned<Accuracy>(world.memory, world.memory);
  a->views.clear(), a->decided.clear();
}

bool goes_by_island(const World& world) { return bool(world.accuracy); }

void plan_passes(const World& world, const StepTime& time) {
  Passes& p = world.accuracy->passes;
  p.is_accounting = p.is_sweeping = false;
  p.is_to_sweep = !world.continuous->bodies.empty();
  world.continuous->waits = true;
  p.substeps = world.plan->substeps;
  find_islands(world, p, time.dt);
  keep_begun(world, p);
  p.group_views.clear();
  world.accuracy->decided.reserve(world.scene.bodies.slots());
  p.is_accounted = keeps_ledger(world);
  p.is_planned = true;
}

bool begin_pass(const World& world, SpringLoads& springs, Floats& floats, Passing, const StepTime& time) {
  Passes& p = world.accuracy->passes;
  int substeps = choose(p);
  if (substeps == 0 && choose_swept(world, p)) substeps = p.substeps;
  if (substeps == 0 && choose_to_account(p)) substeps = choose(p);
  if (substeps == 0) return false;
  Plan& plan = *world.plan;
  p.those.clear();
  for (const std::uint32_t i : p.movers)
    if (runs(p, i)) p.those.add(i);
  list_part(world, p.those, p.scratch, p.lists);
  part_springs(world, p.those, p.lists, nullptr);
  exchange_lists(plan, p.lists);
  plan.in_pass = p.is_running = true;
  plan.substeps = substeps;
  const Real h = time.dt / substeps;
  set_contacts(world, p, Real(p.substeps) / substeps);
  set_joints(world, p);
  orient(world, p);
  carry_springs(world, springs, h);
  floats.most_rate = 1 / h;
  part_stiff(world, h);
  if (p.is_accounted) world.ledger->is_paused = !p.is_accounting && !p.is_sweeping;
  return true;
}

void end_pass(const World& world, Passing to, const StepTime& time) {
  Passes& p = world.accuracy->passes;
  const Borne borne(world.scene.dials, time.dt);
  const int substeps = world.plan->substeps;
  find_soft(world, p);
  for (Passes::Island& island : p.islands)
    if (island.runs) judge(world, p, island, borne, time.dt);
  keep_contacts(world, p, Real(substeps) / p.substeps);
  const Joints& joints = world.joints;
  for (std::size_t j = 0; j < p.all_active.size(); ++j) {
    const JointDef& def = joints.joint[p.all_active[j]].def;
    const std::uint32_t body = def.body_a != kInvalid && runs(p, def.body_a) ? def.body_a : def.body_b;
    if (!runs_joint(world, p, p.all_active[j]) || p.islands[p.island_of[body]].trial.run > 0) continue;
    keep_joint(world, j);
  }
  GroupViews& views = to;
  const auto is_told = [&](const GroupView& view) {
    return runs(p, view.body) && p.islands[p.island_of[view.body]].trial.run == 0 &&
           (p.is_sweeping || p.is_accounting == p.is_accounted);
  };
  for (const GroupView& view : views)
    if (is_told(view)) p.group_views.push_back(view);
  go_back(world, to);
  put_back_lists(world, p);
}

void end_passes(const World& world, Passing to, Events& events, const StepTime& time) {
  Accuracy& a = *world.accuracy;
  Passes& p = a.passes;
  if (!std::exchange(p.is_planned, false)) return;
  world.continuous->waits = false;
  StepReport& report = to;
  GroupViews& views = to;
  put_back_contacts(world, p, time);
  for (Passes::Island& island : p.islands) island.runs = true;
  put_ended(world, to);
  drive_kinematics(world, to, to, {time.dt, time.dt / p.substeps});
  report.groups = p.groups, report.largest_group = p.largest_group, report.direct_groups = 0;
  std::ranges::sort(p.group_views, {}, &GroupView::body);
  for (const GroupView& view : p.group_views) report.direct_groups += view.direct;
  views = p.group_views;
  for (const Passes::Island& island : p.islands) {
    if (island.is_swept) continue;
    AccuracyMemory memory = island.trial.memory_after(island.memory, island.met);
    if (may_stop(world, p, island)) memory.wait = 0;
    decide(a, island.trial, memory, 0,
           [&](const auto& f) { each_member(p, island, [&](std::uint32_t, std::uint32_t i) { f(i); }); });
  }
  break_overloaded(world, to, events);
}

void drop_passes(const World& world, Passing to) {
  Passes& p = world.accuracy->passes;
  Plan& plan = *world.plan;
  plan.revision = 0;  // what else the step had under way is planned anew
  if (plan.flight) plan.flight->any = false;
  if (!std::exchange(p.is_planned, false)) return;
  world.continuous->waits = false;
  for (Passes::Island& island : p.islands) island.runs = true;
  go_back(world, to);
  if (p.is_running) put_back_lists(world, p);
  world.wide_joints->active = p.all_active;
  world.wide_joints->is_packed = false;
}

}  // namespace accuracy

void save_accuracy(const World& world, SolverMemory& memory, const StepTime&) {
  if (!world.accuracy) return;
  Accuracy& a = *world.accuracy;
  for (const Accuracy::Decided& d : a.decided) memory.accuracy[d.body] = d.memory;
  std::ranges::sort(a.views, [](const AccuracyView& one, const AccuracyView& other) {
    return one.share() != other.share() ? one.share() > other.share() : one.body < other.body;
  });
}

}  // namespace carom::dynamics

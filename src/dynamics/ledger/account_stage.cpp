// What each stage did, and which cause's account it enters.
#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/impact.h"
#include "dynamics/contact/resistance.h"
#include "dynamics/events/events.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/accounts.h"
#include "dynamics/observe.h"
#include "dynamics/particles/flight.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

/// Columns for what acts in this step.
void lay_columns(const World& world) {
  Ledger& l = ledger_of(world);
  const Plan& plan = *world.plan;
  l.cause_of[Ledger::kTurn] = static_cast<std::uint8_t>(index_of(Cause::integrator));
  l.cause_of[Ledger::kLock] = static_cast<std::uint8_t>(index_of(Cause::axis_locks));
  l.cause_of[Ledger::kResist] = static_cast<std::uint8_t>(index_of(Cause::resistance));
  l.cause_of[Ledger::kSolve] = static_cast<std::uint8_t>(index_of(Cause::unassigned));
  std::size_t columns = Ledger::kFixedColumns;
  for (std::size_t r = 0; r < plan.effects.size(); ++r) {
    const PlannedEffect& row = plan.effects[r];
    if (row.effect->force == gravity::force) l.gravity = cause_of_row(r);
    if (row.served == Served::stage || row.participants.count == 0) continue;
    // No torque: how omega turns with its body.
    const bool gyro = row.effect->force == gyroscopic::force;
    l.column_of[r] = static_cast<std::uint8_t>(columns);
    l.cause_of[columns++] = static_cast<std::uint8_t>(gyro ? index_of(Cause::integrator) : cause_of_row(r));
  }
  const std::size_t slots = world.scene.bodies.slots();
  if (columns == l.columns && l.kicks.size() == slots * columns) return;
  l.kicks.assign(slots * columns, {Vec3::zero(), Vec3::zero()});
  l.columns = columns;
}

/// What a host did since the last step.
void account_host(const World& world) {
  Ledger& l = ledger_of(world);
  const auto look = [&](std::uint32_t i) {
    if (is_dynamic(world, i) && is_lost(world, i)) return;
    const Amount a = is_dynamic(world, i) ? amount_now(world, i) : Amount();
    l.account(Cause::host, a - l.body_amount[i]);
    l.body_amount[i] = a;
    open_phase(world, i);
  };
  if (l.revision != world.scene.revision)
    for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) look(i);
  else
    for (const std::uint32_t i : world.state.written) look(i);
  l.revision = world.scene.revision;
  for (std::uint32_t s = 0; s < l.set_amount.size(); ++s) take_set(world, s, true);
}

void open_accounts(const World& world) {
  Ledger& l = ledger_of(world);
  const std::size_t slots = world.scene.bodies.slots(), sets = world.particles.set.size();
  l.body.resize(slots), l.body_amount.resize(slots), l.probe.resize(slots);
  l.set_amount.reserve(sets), l.set_moment.reserve(sets), l.set_held.reserve(sets);
  lay_columns(world);
  l.set_amount.resize(sets), l.set_moment.resize(sets, Vec3::zero()), l.set_held.resize(sets, 0);
  if (!l.is_open) {  // else the step before this was not to be: what the host did until then is accounted for
    for (Account& account : l.step) account = Account();
    l.step_rounding = {};
    l.before = l.now;
  }
  l.is_open = true;
  account_host(world);
  count_participants(world, EffectId::ledger, world.plan->linear.count + world.plan->rotating.count);
}

void account_kicks(const World& world, const StepTime&) {
  each_awake(world, [&](std::uint32_t i) {
    if (!was_lost(world, i)) see_kick(world, i, Ledger::kLock);
  });
  save_impacts(world);
}

/// A body that was hit within the substep, at moment t (of several: on average): the velocities that are stored are
/// those of another moment, and it stands where its motion of now would have begun, -t dv from where it was. Of the
/// work of the forces, over the velocity after the hit,
///   F.dv (lag - t)      lag: the moment of stored velocities
/// is in the change of what is stored; and the way of the body to where it stands is gravity's.
void share_hit(const World& world, std::uint32_t i, Real h) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  const Ledger::Body& b = l.body[i];
  const Real m = world.scene.mass[i];
  const Vec3 shift = s.x[i] - b.x, late = world.plan->integrator->lag * (s.v[i] - b.seen_v) + shift / h;
  const auto kicks = l.kicks_of(i);
  for (std::size_t c = Ledger::kFixedColumns; c < l.columns; ++c) {
    const Real work = m * kicks[c].v.dot(late);
    const std::size_t cause = l.cause_of[c] == l.gravity ? index_of(Cause::integrator) : l.cause_of[c];
    l.step[cause].add({work, 0, Vec3::zero(), Vec3::zero()});
    l.account(Cause::restitution, {-work, 0, Vec3::zero(), Vec3::zero()});
  }
  const Real fallen = m * pull_on(world, i).dot(shift);
  l.step[l.gravity].add({fallen, -fallen, Vec3::zero(), Vec3::zero()});
  l.account(Cause::restitution, {0, fallen, Vec3::zero(), Vec3::zero()});
  l.account(Cause::integrator, {-fallen, 0, Vec3::zero(), Vec3::zero()});
}

void account_impacts(const World& world, const StepTime& time) {
  if (world.contacts->impacts.empty()) return;
  share_impacts(world);
  each_accounted(world, [&](std::uint32_t i) {
    if (is_as_seen(world, i)) return;
    close_phase(world, i);
    share_hit(world, i, time.h);
    clear_kicks(ledger_of(world), i);
    account_change(world, i, Cause::restitution);
  });
}

void account_moments(const World& world, const StepTime&) {
  if (world.contacts->resisting.empty()) return;
  each_awake(world, [&](std::uint32_t i) { see_kick(world, i, Ledger::kResist); });
}

/// Half of the kicks, which take_half_kicks() took off and give_half_kicks() gives back after the move.
void account_solved(const World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  const WideJoints& w = *world.wide_joints;
  for (const WideJoints::Kicked& k : w.kicked) {
    l.body[k.body].kicked = true;
    l.body[k.body].seen_v -= k.half;
    for (Ledger::Kick& kick : l.kicks_of(k.body)) kick.v *= 0.5;
  }
  each_awake(world, [&](std::uint32_t i) { see_kick(world, i, Ledger::kSolve); });
  share_solved(world);
  save_impulses(world);
}

void account_move(const World& world, std::uint32_t i) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  const Ledger::Body& b = l.body[i];
  const Real m = world.scene.mass[i];
  const Vec3 way = s.x[i] - b.x;
  const Real work = m * pull_on(world, i).dot(way);
  l.step[l.gravity].add({work, -work, Vec3::zero(), Vec3::zero()});
  Amount moved{-work, 0, Vec3::zero(), way.cross(m * s.v[i])};
  if (rotates(world.scene, i) && s.q[i] != b.q) {
    const Vec3 omega = s.omega[i],
               gained = inertia_at(world.scene, i, s.q[i]) * omega - inertia_at(world.scene, i, b.q) * omega;
    moved.kinetic += 0.5 * omega.dot(gained);
    moved.angular += gained;
  }
  if (world.plan->integrator->proposes && !world.plan->touched[i]) {  // forces act at the middle of the way
    const auto kicks = l.kicks_of(i);
    for (std::size_t c = Ledger::kFixedColumns; c < l.columns; ++c) {
      const Vec3 moment = (0.5 * m) * way.cross(kicks[c].v);
      l.step[l.cause_of[c]].add({0, 0, Vec3::zero(), moment});
      moved.angular -= moment;
    }
  }
  l.account(Cause::integrator, moved);
}

void account_moves(const World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  each_awake(world, [&](std::uint32_t i) {
    if (was_lost(world, i) || is_lost(world, i)) return;
    close_phase(world, i);
    account_move(world, i);
    Ledger::Body& b = l.body[i];
    if (b.kicked)
      for (Ledger::Kick& kick : l.kicks_of(i)) kick.omega.set_zero();
    else
      clear_kicks(l, i);
    if (b.kicked) l.kicks_of(i)[Ledger::kSolve].v.set_zero();
    open_phase(world, i);
  });
}

/// Who has turned keeps the momentum, and not the omega.
void account_spun(const World& world, const WideJoints::Kicked& k) {
  Ledger::Body& b = ledger_of(world).body[k.body];
  if (k.spun == Vec3::zero()) return;
  const Vec3 omega = b.seen_omega + k.spun;
  ledger_of(world).account(Cause::integrator, amount_of(world, k.body, b.x, b.q, b.seen_v, omega) -
                                                  amount_of(world, k.body, b.x, b.q, b.seen_v, b.seen_omega));
  may_round(world, k.body, b.seen_v.norm(), omega.norm());
  b.omega = b.seen_omega = omega;
}

/// Poses first, where a solver parts what overlaps; then velocities, where bodies stand now.
void account_relaxed(const World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  const WideJoints& w = *world.wide_joints;
  for (const WideJoints::Kicked& k : w.kicked) account_spun(world, k);
  each_accounted(world, [&](std::uint32_t i) {
    Ledger::Body& b = l.body[i];
    if (s.x[i] == b.x && s.q[i] == b.q) return;
    l.account(Cause::correction, amount_of(world, i, s.x[i], s.q[i], b.seen_v, b.seen_omega) -
                                     amount_of(world, i, b.x, b.q, b.seen_v, b.seen_omega));
    may_round(world, i, b.seen_v.norm(), b.seen_omega.norm());
    b.x = s.x[i], b.q = s.q[i];
  });
  for (const WideJoints::Kicked& k : w.kicked) l.body[k.body].seen_v += k.half;
  each_accounted(world, [&](std::uint32_t i) { see_kick(world, i, Ledger::kSolve); });
  share_relaxed(world);
  each_accounted(world, [&](std::uint32_t i) {
    close_phase(world, i);
    clear_kicks(l, i);
  });
}

template <Cause cause>
void account_changed(const World& world, const StepTime&) {
  each_accounted(world, [&](std::uint32_t i) {
    if (!is_as_seen(world, i)) account_change(world, i, cause);
  });
}

void account_resisted(const World& world, const StepTime& time) {
  if (!world.contacts->resisting.empty()) account_changed<Cause::resistance>(world, time);
}

/// Also sleepers that were hit.
void account_swept(const World& world, const StepTime&) {
  if (world.continuous->bodies.empty() || world.continuous->waits) return;
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i)
    if (is_dynamic(world, i) && !is_lost(world, i) && !is_as_seen(world, i))
      account_change(world, i, Cause::continuous);
}

void account_lost(const World& world, const StepTime&) {
  each_awake(world, [&](std::uint32_t i) { was_lost(world, i); });
}

void account_sleep(const World& world, const StepTime& time) {
  if (world.plan->effects[+EffectId::sleep].participants.count > 0) account_changed<Cause::sleep>(world, time);
}

/// The state itself, apart from all accounts.
void sum_state(const World& world, Amount& to) {
  Ledger& l = ledger_of(world);
  Account account;
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) {
    if (!is_dynamic(world, i)) continue;
    const Ledger::Body& b = l.body[i];
    if (is_lost(world, i))
      l.body_amount[i] = amount_of(world, i, b.x, b.q, b.v, b.omega);
    else if (!world.state.sleeps(i) || !world.sleep->inactive[i])
      l.body_amount[i] = amount_now(world, i);
    account.add(l.body_amount[i]);
    const Amount& a = l.body_amount[i];
    const Real m = world.scene.mass[i];
    Rounding& r = l.step_rounding;
    r.energy += kRoundings * (a.kinetic + m * pull_on(world, i).norm() * world.state.x[i].norm());
    r.linear += kRoundings * a.linear.norm();
    r.angular += kRoundings * (a.linear.norm() * world.state.x[i].norm() +
                               std::sqrt(2 * a.kinetic * world.scene.inertia[i].trace()));
  }
  for (const Amount& a : l.set_amount) account.add(a);
  to = account.value();
}

void close_accounts(const World& world) {
  Ledger& l = ledger_of(world);
  sum_state(world, l.now);
  for (std::size_t c = 0; c < kCauses; ++c) l.since[c].add(l.step[c].value());
  l.since_rounding.energy += l.step_rounding.energy;
  l.since_rounding.linear += l.step_rounding.linear;
  l.since_rounding.angular += l.step_rounding.angular;
  PlannedEffect& row = world.plan->effects[+EffectId::ledger];
  row.evaluations += row.participants.count;
  ++l.steps;
  l.is_open = false;
}

}  // namespace

void account_stage(const World& world, LedgerAccount account, const StepTime& time) {
  switch (account) {
    case LedgerAccount::none:
    case LedgerAccount::with_host:
    case LedgerAccount::by_itself:
      return;
    case LedgerAccount::opens:
      return open_accounts(world);
    case LedgerAccount::reserves:
      return reserve_shares(world);
    case LedgerAccount::forces:
      return account_kicks(world, time);
    case LedgerAccount::impacts:
      return account_impacts(world, time);
    case LedgerAccount::moments:
      return account_moments(world, time);
    case LedgerAccount::solver:
      return account_solved(world, time);
    case LedgerAccount::moves:
      return account_moves(world, time);
    case LedgerAccount::relaxation:
      return account_relaxed(world, time);
    case LedgerAccount::resistance:
      return account_resisted(world, time);
    case LedgerAccount::sweeps:
      return account_swept(world, time);
    case LedgerAccount::particles:
      return account_flight(world, time);
    case LedgerAccount::corrections:
      return account_changed<Cause::correction>(world, time);
    case LedgerAccount::lost_bodies:
      return account_lost(world, time);
    case LedgerAccount::sleepers:
      return account_sleep(world, time);
    case LedgerAccount::closes:
      return close_accounts(world);
  }
}

}  // namespace carom::dynamics

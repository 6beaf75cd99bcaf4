// Phases: what each room of the page did to bodies and particles, and under which cause it is booked.
#include "dynamics/ledger/ledger.h"

#include <algorithm>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/impact.h"
#include "dynamics/contact/resistance.h"
#include "dynamics/events/events.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/observe.h"
#include "dynamics/particles/flight.h"
#include "dynamics/quarantine.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/solver.h"

namespace carom {
namespace {

/// Roundings that a booking may add up, of the magnitude of its terms: some ten columns, each a difference of
/// velocities that is multiplied and added a few times.
constexpr Real kRoundings = 64 * kUnitRoundoff;

Ledger& ledger_of(World& world) { return *world.ledger; }

bool is_dynamic(const World& world, std::uint32_t i) { return world.scene.inv_mass[i] > 0; }

/// m/s^2
Vec3 pull_on(const World& world, std::uint32_t i) { return world.scene.gravity_factor_of(i) * world.scene.gravity; }

/// kg m^2, world.
Mat3 inertia_at(const World& world, std::uint32_t i, const Quat& q) {
  const Mat3 r = q.toRotationMatrix();
  return r * world.scene.inertia[i] * r.transpose();
}

Amount present(const World& world, std::uint32_t i) {
  const State& s = world.state;
  return amount_of(world, i, s.x[i], s.q[i], s.v[i], s.omega[i]);
}

bool is_sane(const Vec3& v, const Vec3& omega) {
  return v.squaredNorm() <= kMaxSpeed * kMaxSpeed && omega.squaredNorm() <= kMaxSpin * kMaxSpin;
}
/// What a solver drove out of the finite world just now, and the next kick will find. Until then nothing is booked: the
/// ledger has it as its phase began.
bool is_lost(const World& world, std::uint32_t i) { return !is_sane(world.state.v[i], world.state.omega[i]); }

/// Those of each_awake() whose numbers make sense.
template <class F>
void each_booked(const World& world, F&& f) {
  each_awake(world, [&](std::uint32_t i) {
    if (!is_lost(world, i)) f(i);
  });
}

/// A body's phase begins with the state as it is.
void open(World& world, std::uint32_t i) {
  const State& s = world.state;
  Ledger::Body& b = ledger_of(world).body[i];
  b.x = s.x[i], b.q = s.q[i];
  b.v = b.seen_v = s.v[i], b.omega = b.seen_omega = s.omega[i];
  b.kicked = false;
  b.held = s.quarantined[i] != 0;
}

/// Terms of a booking, for the bound of its rounding.
/// @param speed, spin  m/s, rad/s: sums of magnitudes
void may_round(World& world, std::uint32_t i, Real speed, Real spin) {
  Rounding& r = ledger_of(world).step_rounding;
  const Real m = world.scene.mass[i], inertia = world.scene.inertia[i].trace(),
             reach = ledger_of(world).body[i].x.norm();
  r.energy += kRoundings * (m * speed * speed + inertia * spin * spin);
  r.linear += kRoundings * (m * speed);
  r.angular += kRoundings * (reach * m * speed + inertia * spin);
}

/// The phase of a body ends with the velocities that were seen last: book its kicks.
void close(World& world, std::uint32_t i) {
  Ledger& l = ledger_of(world);
  Ledger::Body& b = l.body[i];
  const Real m = world.scene.mass[i];
  const bool turns = rotates(world.scene, i);
  const Mat3 inertia = turns ? inertia_at(world, i, b.q) : Mat3(Mat3::Zero());
  const Vec3 v = 0.5 * (b.v + b.seen_v), omega = 0.5 * (b.omega + b.seen_omega);
  Real speed = b.v.norm() + b.seen_v.norm(), spin = b.omega.norm() + b.seen_omega.norm();
  const auto kicks = l.kicks_of(i);
  for (std::size_t c = 0; c < l.columns; ++c) {
    const Ledger::Kick& kick = kicks[c];
    if (kick.v == Vec3::Zero() && kick.omega == Vec3::Zero()) continue;
    const Vec3 p = m * kick.v, spun = inertia * kick.omega;
    Amount a{p.dot(v) + spun.dot(omega), 0, p, b.x.cross(p) + spun};
    if (l.cause_of[c] == l.gravity) {  // it gives what the way is worth, @see book_move()
      l.book(Cause::integrator, {a.kinetic, 0, Vec3::Zero(), Vec3::Zero()});
      a.kinetic = 0;
    }
    l.step[l.cause_of[c]].add(a);
    speed += kick.v.norm(), spin += kick.omega.norm();
  }
  may_round(world, i, speed, spin);
  b.v = b.seen_v, b.omega = b.seen_omega;
}

void forget_kicks(Ledger& l, std::uint32_t i) {
  for (Ledger::Kick& kick : l.kicks_of(i)) kick = {Vec3::Zero(), Vec3::Zero()};
}

/// All that changed since the last booking, poses with it, under one cause; a new phase begins.
void lump(World& world, std::uint32_t i, Cause cause) {
  Ledger& l = ledger_of(world);
  const Ledger::Body b = l.body[i];
  l.book(cause, present(world, i) - amount_of(world, i, b.x, b.q, b.seen_v, b.seen_omega));
  const State& s = world.state;
  may_round(world, i, b.seen_v.norm() + s.v[i].norm(), b.seen_omega.norm() + s.omega[i].norm());
  open(world, i);
}

bool is_as_seen(const World& world, std::uint32_t i) {
  const State& s = world.state;
  const Ledger::Body& b = world.ledger->body[i];
  return s.v[i] == b.seen_v && s.omega[i] == b.seen_omega && s.x[i] == b.x && s.q[i].coeffs() == b.q.coeffs();
}

/// Whose state left the finite world in this room: what its phase had booked so far makes no sense.
bool was_lost(World& world, std::uint32_t i) {
  Ledger& l = ledger_of(world);
  Ledger::Body& b = l.body[i];
  if (!world.state.quarantined[i] || b.held) return false;
  forget_kicks(l, i);
  b.seen_v = b.v, b.seen_omega = b.omega;
  lump(world, i, Cause::quarantine);
  return true;
}

/// What velocities changed since the last booking, into a column.
void see(World& world, std::uint32_t i, std::size_t column) {
  Ledger& l = ledger_of(world);
  Ledger::Body& b = l.body[i];
  Ledger::Kick& kick = l.kicks_of(i)[column];
  const State& s = world.state;
  kick.v += s.v[i] - b.seen_v, kick.omega += s.omega[i] - b.seen_omega;
  b.seen_v = s.v[i], b.seen_omega = s.omega[i];
}

// ---- particles ----

struct SetSums {
  Amount amount;
  Vec3 moment;       // kg m, of m x, of those who are not held
  Real linear = 0;   // N s, of m |v|
  Real angular = 0;  // N m s, of m |x| |v|
};

SetSums sums_of(const World& world, std::uint32_t s) {
  constexpr std::size_t kPlain = 32;  // terms added up plainly, which leaves fewer roundings than kRoundings
  const ParticleSet& set = world.particles.set[s];
  SetSums sums{{}, Vec3::Zero()};
  Account account;
  Sum<Vec3> moment{Vec3(Vec3::Zero())};
  const Vec3 pull = set.def.gravity_factor * world.scene.gravity;
  for (std::size_t begin = 0; begin < set.size(); begin += kPlain) {
    Amount some;
    Vec3 some_moment = Vec3::Zero();
    for (std::size_t i = begin; i < std::min(set.size(), begin + kPlain); ++i) {
      const Vec3 x = set.position(i), v = set.velocity(i);
      const Real m = set.mass_of(i);
      some += {0.5 * m * v.squaredNorm(), -m * pull.dot(x), m * v, m * x.cross(v)};
      if (!set.is_held(i)) some_moment += m * x;
      sums.linear += m * v.norm(), sums.angular += m * x.norm() * v.norm();
    }
    account.add(some), moment.add(some_moment);
  }
  sums.amount = account.value(), sums.moment = moment.value();
  return sums;
}

void keep_sums(World& world, std::uint32_t s, const SetSums& sums) {
  Ledger& l = ledger_of(world);
  l.set_amount[s] = sums.amount, l.set_moment[s] = sums.moment;
  l.set_held[s] = world.particles.set[s].held_count;
  Rounding& r = l.step_rounding;  // a particle's terms, added up by compensated sums
  r.energy += kRoundings * (sums.amount.kinetic + std::fabs(sums.amount.potential));
  r.linear += kRoundings * sums.linear, r.angular += kRoundings * sums.angular;
}

/// Gravity's impulse is the step's, at the middle of the way; damping has the rest, and where there is none the
/// integrator.
void book_flight(World& world, const StepTime& time) {
  Ledger& l = ledger_of(world);
  for (std::uint32_t s = 0; s < world.particles.set.size(); ++s) {
    const ParticleSet& set = world.particles.set[s];
    const SetSums sums = sums_of(world, s);
    const Amount change = sums.amount - l.set_amount[s];
    const bool lost = set.held_count != l.set_held[s];
    Real mass = 0;
    if (set.mass.empty())
      mass = static_cast<Real>(set.size() - set.held_count) * set.def.mass;
    else
      for (std::size_t i = 0; i < set.size(); ++i) mass += set.is_held(i) ? 0 : set.mass[i];
    const Vec3 pull = set.def.gravity_factor * world.scene.gravity;
    Amount by_gravity;
    if (!lost)
      by_gravity = {-change.potential, change.potential, time.dt * mass * pull,
                    (0.5 * time.dt) * (sums.moment + l.set_moment[s]).cross(pull)};
    l.step[l.gravity].add(by_gravity);
    const Amount rest = change - by_gravity;
    if (lost)
      l.book(Cause::quarantine, rest);
    else if (set.def.linear_damping > 0)
      l.step[cause_of_row(kLinearDampingRow)].add(rest);
    else
      l.book(Cause::integrator, rest);
    keep_sums(world, s, sums);
  }
}

// ---- rooms of the page, in its order ----

/// Columns for what acts in this step.
void lay_columns(World& world) {
  Ledger& l = ledger_of(world);
  const Plan& plan = *world.plan;
  l.cause_of[Ledger::kTurn] = static_cast<std::uint8_t>(index_of(Cause::integrator));
  l.cause_of[Ledger::kLock] = static_cast<std::uint8_t>(index_of(Cause::axis_locks));
  l.cause_of[Ledger::kResist] = static_cast<std::uint8_t>(index_of(Cause::resistance));
  l.cause_of[Ledger::kSolve] = static_cast<std::uint8_t>(index_of(Cause::unassigned));
  std::size_t columns = Ledger::kRows;
  for (std::size_t r = 0; r < plan.effects.size(); ++r) {
    const PlannedEffect& row = plan.effects[r];
    if (row.effect->force == gravity::force) l.gravity = cause_of_row(r);
    if (row.served == Served::stage || row.customers.count == 0) continue;
    // No torque: how omega turns with its body.
    const bool gyro = row.effect->force == gyroscopic::force;
    l.column_of[r] = static_cast<std::uint8_t>(columns);
    l.cause_of[columns++] = static_cast<std::uint8_t>(gyro ? index_of(Cause::integrator) : cause_of_row(r));
  }
  const std::size_t slots = world.scene.bodies.slots();
  if (columns == l.columns && l.kicks.size() == slots * columns) return;
  l.kicks.assign(slots * columns, {Vec3::Zero(), Vec3::Zero()});
  l.columns = columns;
}

/// What a host did since the last step.
void book_host(World& world) {
  Ledger& l = ledger_of(world);
  const auto look = [&](std::uint32_t i) {
    if (is_dynamic(world, i) && is_lost(world, i)) return;
    const Amount a = is_dynamic(world, i) ? present(world, i) : Amount();
    l.book(Cause::host, a - l.body_amount[i]);
    l.body_amount[i] = a;
    open(world, i);
  };
  if (l.revision != world.scene.revision)
    for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) look(i);
  else
    for (const std::uint32_t i : world.state.written) look(i);
  l.revision = world.scene.revision;
  for (std::uint32_t s = 0; s < l.set_amount.size(); ++s) {
    const bool there = s < world.particles.set.size();
    const SetSums sums = there ? sums_of(world, s) : SetSums{{}, Vec3::Zero()};
    l.book(Cause::host, sums.amount - l.set_amount[s]);
    if (there) keep_sums(world, s, sums);
  }
}

void begin(World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  const std::size_t slots = world.scene.bodies.slots(), sets = world.particles.set.size();
  l.body.resize(slots), l.body_amount.resize(slots), l.probe.resize(slots);
  l.set_amount.reserve(sets), l.set_moment.reserve(sets), l.set_held.reserve(sets);
  lay_columns(world);
  l.set_amount.resize(sets), l.set_moment.resize(sets, Vec3::Zero()), l.set_held.resize(sets, 0);
  if (!l.is_open) {  // else the step before this was not to be: what the host did until then is booked
    for (Account& account : l.step) account = Account();
    l.step_rounding = {};
    l.before = l.now;
  }
  l.is_open = true;
  book_host(world);
  world.plan->effects[kLedgerRow].customers.count = world.plan->linear.count + world.plan->rotating.count;
}

void book_kicks(World& world, const StepTime&) {
  each_awake(world, [&](std::uint32_t i) {
    if (!was_lost(world, i)) see(world, i, Ledger::kLock);
  });
  note_impacts(world);
}

/// A body that was hit within the substep, at moment t (of several: on average): the velocities that are stored are
/// those of another moment, and it stands where its motion of now would have begun, -t dv from where it was. Of the
/// work of the forces, over the velocity after the hit,
///   F.dv (lag - t)      lag: the moment of stored velocities
/// is in the change of what is stored; and the way of the body to where it stands is gravity's.
void share_hit(World& world, std::uint32_t i, Real h) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  const Ledger::Body& b = l.body[i];
  const Real m = world.scene.mass[i];
  const Vec3 shift = s.x[i] - b.x, late = world.plan->integrator->lag * (s.v[i] - b.seen_v) + shift / h;
  const auto kicks = l.kicks_of(i);
  for (std::size_t c = Ledger::kRows; c < l.columns; ++c) {
    const Real work = m * kicks[c].v.dot(late);
    const std::size_t cause = l.cause_of[c] == l.gravity ? index_of(Cause::integrator) : l.cause_of[c];
    l.step[cause].add({work, 0, Vec3::Zero(), Vec3::Zero()});
    l.book(Cause::restitution, {-work, 0, Vec3::Zero(), Vec3::Zero()});
  }
  const Real fallen = m * pull_on(world, i).dot(shift);
  l.step[l.gravity].add({fallen, -fallen, Vec3::Zero(), Vec3::Zero()});
  l.book(Cause::restitution, {0, fallen, Vec3::Zero(), Vec3::Zero()});
  l.book(Cause::integrator, {-fallen, 0, Vec3::Zero(), Vec3::Zero()});
}

void book_impacts(World& world, const StepTime& time) {
  if (world.contacts->impacts.empty()) return;
  share_impacts(world);
  each_booked(world, [&](std::uint32_t i) {
    if (is_as_seen(world, i)) return;
    close(world, i);
    share_hit(world, i, time.h);
    forget_kicks(ledger_of(world), i);
    lump(world, i, Cause::restitution);
  });
}

void book_moments(World& world, const StepTime&) {
  if (world.contacts->resisting.empty()) return;
  each_awake(world, [&](std::uint32_t i) { see(world, i, Ledger::kResist); });
}

/// Half of the kicks, which take_half_kicks() took off and give_half_kicks() gives back after the move.
void book_solved(World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  const WideJoints& w = *world.wide_joints;
  for (std::size_t k = 0; k < w.kicked.size(); ++k) {
    const std::uint32_t i = w.kicked[k];
    l.body[i].kicked = true;
    l.body[i].seen_v -= w.before[k];
    for (Ledger::Kick& kick : l.kicks_of(i)) kick.v *= 0.5;
  }
  each_awake(world, [&](std::uint32_t i) { see(world, i, Ledger::kSolve); });
  share_solved(world);
  note_impulses(world);
}

void book_move(World& world, std::uint32_t i) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  const Ledger::Body& b = l.body[i];
  const Real m = world.scene.mass[i];
  const Vec3 way = s.x[i] - b.x;
  const Real work = m * pull_on(world, i).dot(way);
  l.step[l.gravity].add({work, -work, Vec3::Zero(), Vec3::Zero()});
  Amount moved{-work, 0, Vec3::Zero(), way.cross(m * s.v[i])};
  if (rotates(world.scene, i) && s.q[i].coeffs() != b.q.coeffs()) {
    const Vec3 omega = s.omega[i], gained = inertia_at(world, i, s.q[i]) * omega - inertia_at(world, i, b.q) * omega;
    moved.kinetic += 0.5 * omega.dot(gained);
    moved.angular += gained;
  }
  if (world.plan->integrator->proposes && !world.plan->touched[i]) {  // forces act at the middle of the way
    const auto kicks = l.kicks_of(i);
    for (std::size_t c = Ledger::kRows; c < l.columns; ++c) {
      const Vec3 moment = (0.5 * m) * way.cross(kicks[c].v);
      l.step[l.cause_of[c]].add({0, 0, Vec3::Zero(), moment});
      moved.angular -= moment;
    }
  }
  l.book(Cause::integrator, moved);
}

void book_moves(World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  each_awake(world, [&](std::uint32_t i) {
    if (was_lost(world, i) || is_lost(world, i)) return;
    close(world, i);
    book_move(world, i);
    Ledger::Body& b = l.body[i];
    if (b.kicked)
      for (Ledger::Kick& kick : l.kicks_of(i)) kick.omega.setZero();
    else
      forget_kicks(l, i);
    if (b.kicked) l.kicks_of(i)[Ledger::kSolve].v.setZero();
    open(world, i);
  });
}

/// Poses first, where a solver parts what overlaps; then velocities, where bodies stand now.
void book_relaxed(World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  const WideJoints& w = *world.wide_joints;
  each_booked(world, [&](std::uint32_t i) {
    Ledger::Body& b = l.body[i];
    if (s.x[i] == b.x && s.q[i].coeffs() == b.q.coeffs()) return;
    l.book(Cause::correction, amount_of(world, i, s.x[i], s.q[i], b.seen_v, b.seen_omega) -
                                  amount_of(world, i, b.x, b.q, b.seen_v, b.seen_omega));
    may_round(world, i, b.seen_v.norm(), b.seen_omega.norm());
    b.x = s.x[i], b.q = s.q[i];
  });
  for (std::size_t k = 0; k < w.kicked.size(); ++k) l.body[w.kicked[k]].seen_v += w.before[k];
  each_booked(world, [&](std::uint32_t i) { see(world, i, Ledger::kSolve); });
  share_relaxed(world);
  each_booked(world, [&](std::uint32_t i) {
    close(world, i);
    forget_kicks(l, i);
  });
}

template <Cause cause>
void book_changed(World& world, const StepTime&) {
  each_booked(world, [&](std::uint32_t i) {
    if (!is_as_seen(world, i)) lump(world, i, cause);
  });
}

void book_resisted(World& world, const StepTime& time) {
  if (!world.contacts->resisting.empty()) book_changed<Cause::resistance>(world, time);
}

/// Also sleepers that were hit.
void book_swept(World& world, const StepTime&) {
  if (world.continuous->bodies.empty()) return;
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i)
    if (is_dynamic(world, i) && !is_lost(world, i) && !is_as_seen(world, i)) lump(world, i, Cause::continuous);
}

void book_sleep(World& world, const StepTime& time) {
  if (world.plan->effects[kSleepRow].customers.count > 0) book_changed<Cause::sleep>(world, time);
}

/// The state itself, apart from all bookings.
void sum_state(World& world, Amount& to) {
  Ledger& l = ledger_of(world);
  Account account;
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) {
    if (!is_dynamic(world, i)) continue;
    const Ledger::Body& b = l.body[i];
    if (is_lost(world, i))
      l.body_amount[i] = amount_of(world, i, b.x, b.q, b.v, b.omega);
    else if (!world.sleep->sleeps(i) || !world.sleep->parked[i])
      l.body_amount[i] = present(world, i);
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

void end(World& world, const StepTime&) {
  Ledger& l = ledger_of(world);
  sum_state(world, l.now);
  for (std::size_t c = 0; c < kCauses; ++c) l.since[c].add(l.step[c].value());
  l.since_rounding.energy += l.step_rounding.energy;
  l.since_rounding.linear += l.step_rounding.linear;
  l.since_rounding.angular += l.step_rounding.angular;
  PlannedEffect& row = world.plan->effects[kLedgerRow];
  row.evaluations += row.customers.count;
  ++l.steps;
  l.is_open = false;
}

}  // namespace

const char* cause_name(std::size_t cause) {
  static constexpr const char* kNames[kFixedCauses] = {
      "host",       "contact",    "friction",   "restitution", "resistance", "joints",     "drives",
      "continuous", "axis_locks", "correction", "sleep",       "quarantine", "integrator", "unassigned"};
  if (cause < kFixedCauses) return kNames[cause];
  const Effect& row = effect_table()[cause - kFixedCauses];
  const bool acts = row.force || row.flow;
  return acts && row.force != gyroscopic::force ? row.name : nullptr;
}

Amount amount_of(const World& world, std::uint32_t i, const Vec3& x, const Quat& q, const Vec3& v, const Vec3& omega) {
  const Real m = world.scene.mass[i];
  const Vec3 p = m * v;
  Amount a{0.5 * m * v.squaredNorm(), -m * pull_on(world, i).dot(x), p, x.cross(p)};
  if (!rotates(world.scene, i)) return a;
  const Vec3 spin = inertia_at(world, i, q) * omega;
  a.kinetic += 0.5 * omega.dot(spin);
  a.angular += spin;
  return a;
}

Ledger::Ledger(World& world)
    : body(world.memory),
      kicks(world.memory),
      probe(world.memory),
      body_amount(world.memory),
      set_amount(world.memory),
      set_moment(world.memory),
      set_held(world.memory),
      old_points(world.memory),
      old_pairs(world.memory),
      old_rows(world.memory),
      old_drives(world.memory),
      old_impacts(world.memory) {
  const std::size_t slots = world.scene.bodies.slots(), sets = world.particles.set.size();
  body.resize(slots), body_amount.resize(slots);
  set_amount.resize(sets), set_moment.resize(sets, Vec3::Zero()), set_held.resize(sets, 0);
  revision = world.scene.revision;
}

void World::keep_ledger(bool on) {
  if (!on) {
    ledger.reset();
    plan->effects[kLedgerRow].customers.count = 0;
    return;
  }
  Owned<Ledger> fresh = make_owned<Ledger>(memory, *this);
  ledger = std::move(fresh);
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (is_dynamic(*this, i)) open(*this, i), ledger->body_amount[i] = present(*this, i);
  for (std::uint32_t s = 0; s < particles.set.size(); ++s) keep_sums(*this, s, sums_of(*this, s));
  Ledger& l = *ledger;
  Account account;
  for (const Amount& a : l.body_amount) account.add(a);
  for (const Amount& a : l.set_amount) account.add(a);
  l.start = l.before = l.now = account.value();
  l.step_rounding = {};
}

void before_row(World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega) {
  Ledger& l = ledger_of(world);
  row.customers.each([&](std::uint32_t i) { l.probe[i] = {v[i], omega[i]}; });
}

void after_row(World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega, Real share) {
  Ledger& l = ledger_of(world);
  const std::size_t column = l.column_of[static_cast<std::size_t>(&row - world.plan->effects.data())];
  row.customers.each([&](std::uint32_t i) {
    const Vec3 dv = v[i] - l.probe[i].v, domega = omega[i] - l.probe[i].omega;
    Ledger::Kick& kick = l.kicks_of(i)[column];
    kick.v += share * dv, kick.omega += share * domega;
  });
}

void book_turns(World& world) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  each_awake(world, [&](std::uint32_t i) {
    Ledger::Body& b = l.body[i];
    const auto kicks = l.kicks_of(i);
    Ledger::Kick rest{s.v[i] - b.seen_v, s.omega[i] - b.seen_omega};
    for (std::size_t c = Ledger::kRows; c < l.columns; ++c) rest.v -= kicks[c].v, rest.omega -= kicks[c].omega;
    kicks[Ledger::kTurn] = rest;
    b.seen_v = s.v[i], b.seen_omega = s.omega[i];
  });
}

void book_room(World& world, void (*room)(World&, const StepTime&), const StepTime& time) {
  using Room = void (*)(World&, const StepTime&);
  static constexpr struct {
    Room room, book;
  } kBookings[] = {
      {wake_touched, begin},
      {begin_contacts, [](World& w, const StepTime&) { make_room_for_shares(w); }},
      {integrate_velocity, book_kicks},
      {answer_impacts, book_impacts},
      {hold_moments, book_moments},
      {solve_velocities, book_solved},
      {integrate_position, book_moves},
      {solve_positions, book_relaxed},
      {resist, book_resisted},
      {sweep, book_swept},
      {fly, book_flight},
      {end_contacts, book_changed<Cause::correction>},
      {fall_asleep, book_sleep},
      {note_who_moved, end},
  };
  for (const auto& booking : kBookings)
    if (booking.room == room) return booking.book(world, time);
}

}  // namespace carom

// The ledger itself: made and dropped, its causes, what a body has; what rows of the table do.
#include "dynamics/ledger/ledger.h"

#include "dynamics/force/force.h"
#include "dynamics/ledger/accounts.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {

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
  Amount a{0.5 * m * v.squared_norm(), -m * pull_on(world, i).dot(x), p, x.cross(p)};
  if (!rotates(world.scene, i)) return a;
  const Vec3 spin = inertia_at(world.scene, i, q) * omega;
  a.kinetic += 0.5 * omega.dot(spin);
  a.angular += spin;
  return a;
}

Ledger::Ledger(const World& world)
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
  set_amount.resize(sets), set_moment.resize(sets, Vec3::zero()), set_held.resize(sets, 0);
  revision = world.scene.revision;
}

void World::keep_ledger(bool on) {
  if (!on) {
    ledger.reset();
    plan->effects[+EffectId::ledger].participants.count = 0;
    return;
  }
  Owned<Ledger> fresh = make_owned<Ledger>(memory, *this);
  ledger = std::move(fresh);
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i) {
    // What a host wrote that makes no sense is put in quarantine as the next step begins, and is not there until then.
    if (!is_dynamic(*this, i) || is_lost(*this, i) || !sane_position(state.x[i])) continue;
    open_phase(*this, i);
    ledger->body_amount[i] = amount_now(*this, i);
  }
  for (std::uint32_t s = 0; s < particles.set.size(); ++s) take_set(*this, s, false);
  Ledger& l = *ledger;
  Account account;
  for (const Amount& a : l.body_amount) account.add(a);
  for (const Amount& a : l.set_amount) account.add(a);
  l.start = l.before = l.now = account.value();
  l.step_rounding = {};
}

namespace {

/// Bodies whose velocities a row writes.
const Participants& written_by(const World& world, const PlannedEffect& row) {
  return row.effect->participants == ParticipantKind::springs ? world.plan->sprung : row.participants;
}

}  // namespace

void before_row(const World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega) {
  Ledger& l = ledger_of(world);
  written_by(world, row).each([&](std::uint32_t i) { l.probe[i] = {v[i], omega[i]}; });
}

void after_row(const World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega, Real share) {
  Ledger& l = ledger_of(world);
  const std::size_t column = l.column_of[static_cast<std::size_t>(&row - world.plan->effects.data())];
  written_by(world, row).each([&](std::uint32_t i) {
    const Vec3 dv = v[i] - l.probe[i].v, domega = omega[i] - l.probe[i].omega;
    Ledger::Kick& kick = l.kicks_of(i)[column];
    kick.v += share * dv, kick.omega += share * domega;
  });
}

void account_turns(const World& world) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  each_awake(world, [&](std::uint32_t i) {
    Ledger::Body& b = l.body[i];
    const auto kicks = l.kicks_of(i);
    Ledger::Kick rest{s.v[i] - b.seen_v, s.omega[i] - b.seen_omega};
    for (std::size_t c = Ledger::kFixedColumns; c < l.columns; ++c) rest.v -= kicks[c].v, rest.omega -= kicks[c].omega;
    kicks[Ledger::kTurn] = rest;
    b.seen_v = s.v[i], b.seen_omega = s.omega[i];
  });
}

}  // namespace carom::dynamics

// The account of one body: its phases.
#include "dynamics/ledger/accounts.h"

#include "dynamics/quarantine.h"

namespace carom::dynamics {

Amount amount_now(const World& world, std::uint32_t i) {
  const State& s = world.state;
  return amount_of(world, i, s.x[i], s.q[i], s.v[i], s.omega[i]);
}

bool is_lost(const World& world, std::uint32_t i) {
  return !sane_velocity(world.state, i) || !sane_spin(world.state, i);
}

void open_phase(const World& world, std::uint32_t i) {
  const State& s = world.state;
  Ledger::Body& b = ledger_of(world).body[i];
  b.x = s.x[i], b.q = s.q[i];
  b.v = b.seen_v = s.v[i], b.omega = b.seen_omega = s.omega[i];
  b.kicked = false;
  b.held = s.held_out[i] != 0;
}

void may_round(const World& world, std::uint32_t i, Real speed, Real spin) {
  Rounding& r = ledger_of(world).step_rounding;
  const Real m = world.scene.mass[i], inertia = world.scene.inertia[i].trace(),
             reach = ledger_of(world).body[i].x.norm();
  r.energy += kRoundings * (m * speed * speed + inertia * spin * spin);
  r.linear += kRoundings * (m * speed);
  r.angular += kRoundings * (reach * m * speed + inertia * spin);
}

void close_phase(const World& world, std::uint32_t i) {
  Ledger& l = ledger_of(world);
  Ledger::Body& b = l.body[i];
  const Real m = world.scene.mass[i];
  const bool turns = rotates(world.scene, i);
  const Mat3 inertia = turns ? inertia_at(world.scene, i, b.q) : Mat3(Mat3::zero());
  const Vec3 v = 0.5 * (b.v + b.seen_v), omega = 0.5 * (b.omega + b.seen_omega);
  Real speed = b.v.norm() + b.seen_v.norm(), spin = b.omega.norm() + b.seen_omega.norm();
  const auto kicks = l.kicks_of(i);
  for (std::size_t c = 0; c < l.columns; ++c) {
    const Ledger::Kick& kick = kicks[c];
    if (kick.v == Vec3::zero() && kick.omega == Vec3::zero()) continue;
    const Vec3 p = m * kick.v, spun = inertia * kick.omega;
    Amount a{p.dot(v) + spun.dot(omega), 0, p, b.x.cross(p) + spun};
    if (l.cause_of[c] == l.gravity) {  // it gives what the way is worth, @see account_move()
      l.account(Cause::integrator, {a.kinetic, 0, Vec3::zero(), Vec3::zero()});
      a.kinetic = 0;
    }
    l.step[l.cause_of[c]].add(a);
    speed += kick.v.norm(), spin += kick.omega.norm();
  }
  may_round(world, i, speed, spin);
  b.v = b.seen_v, b.omega = b.seen_omega;
}

void clear_kicks(Ledger& l, std::uint32_t i) {
  for (Ledger::Kick& kick : l.kicks_of(i)) kick = {Vec3::zero(), Vec3::zero()};
}

void account_change(const World& world, std::uint32_t i, Cause cause) {
  Ledger& l = ledger_of(world);
  const Ledger::Body b = l.body[i];
  l.account(cause, amount_now(world, i) - amount_of(world, i, b.x, b.q, b.seen_v, b.seen_omega));
  const State& s = world.state;
  may_round(world, i, b.seen_v.norm() + s.v[i].norm(), b.seen_omega.norm() + s.omega[i].norm());
  open_phase(world, i);
}

bool is_as_seen(const World& world, std::uint32_t i) {
  const State& s = world.state;
  const Ledger::Body& b = world.ledger->body[i];
  return s.v[i] == b.seen_v && s.omega[i] == b.seen_omega && s.x[i] == b.x && s.q[i] == b.q;
}

bool was_lost(const World& world, std::uint32_t i) {
  Ledger& l = ledger_of(world);
  Ledger::Body& b = l.body[i];
  if (!world.state.held_out[i] || b.held) return false;
  clear_kicks(l, i);
  b.seen_v = b.v, b.seen_omega = b.omega;
  account_change(world, i, Cause::quarantine);
  return true;
}

void see_kick(const World& world, std::uint32_t i, std::size_t column) {
  Ledger& l = ledger_of(world);
  Ledger::Body& b = l.body[i];
  Ledger::Kick& kick = l.kicks_of(i)[column];
  const State& s = world.state;
  kick.v += s.v[i] - b.seen_v, kick.omega += s.omega[i] - b.seen_omega;
  b.seen_v = s.v[i], b.seen_omega = s.omega[i];
}

}  // namespace carom::dynamics

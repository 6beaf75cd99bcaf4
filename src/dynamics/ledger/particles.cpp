// Particles in the ledger: sums over a set before and after its flight.
#include <algorithm>

#include "dynamics/ledger/accounts.h"

namespace carom::dynamics {
namespace {

struct SetSums {
  Amount amount;
  Vec3 moment;       // kg m, of m x, of those who are not held
  Real linear = 0;   // N s, of m |v|
  Real angular = 0;  // N m s, of m |x| |v|
};

SetSums sums_of(const World& world, std::uint32_t s) {
  constexpr std::size_t kPlain = 32;  // terms added up plainly, which leaves fewer roundings than kRoundings
  const ParticleSet& set = world.particles.set[s];
  SetSums sums{{}, Vec3::zero()};
  Account account;
  Sum<Vec3> moment{Vec3(Vec3::zero())};
  const Vec3 pull = set.def.gravity_factor * world.scene.gravity;
  for (std::size_t begin = 0; begin < set.size(); begin += kPlain) {
    Amount some;
    Vec3 some_moment = Vec3::zero();
    for (std::size_t i = begin; i < std::min(set.size(), begin + kPlain); ++i) {
      const Vec3 x = set.position(i), v = set.velocity(i);
      const Real m = set.mass_of(i);
      some += {0.5 * m * v.squared_norm(), -m * pull.dot(x), m * v, m * x.cross(v)};
      if (!set.is_held(i)) some_moment += m * x;
      sums.linear += m * v.norm(), sums.angular += m * x.norm() * v.norm();
    }
    account.add(some), moment.add(some_moment);
  }
  sums.amount = account.value(), sums.moment = moment.value();
  return sums;
}

void keep_sums(const World& world, std::uint32_t s, const SetSums& sums) {
  Ledger& l = ledger_of(world);
  l.set_amount[s] = sums.amount, l.set_moment[s] = sums.moment;
  l.set_held[s] = world.particles.set[s].held_count;
  Rounding& r = l.step_rounding;  // a particle's terms, added up by compensated sums
  r.energy += kRoundings * (sums.amount.kinetic + std::fabs(sums.amount.potential));
  r.linear += kRoundings * sums.linear, r.angular += kRoundings * sums.angular;
}

}  // namespace

void take_set(const World& world, std::uint32_t s, bool host) {
  Ledger& l = ledger_of(world);
  const bool there = s < world.particles.set.size();
  const SetSums sums = there ? sums_of(world, s) : SetSums{{}, Vec3::zero()};
  if (host) l.account(Cause::host, sums.amount - l.set_amount[s]);
  if (there) keep_sums(world, s, sums);
}

/// Gravity's impulse is the step's, at the middle of the way; damping has the rest, and where there is none the
/// integrator.
void account_flight(const World& world, const StepTime& time) {
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
      l.account(Cause::quarantine, rest);
    else if (set.def.linear_damping > 0)
      l.step[cause_of_row(+EffectId::linear_damping)].add(rest);
    else
      l.account(Cause::integrator, rest);
    keep_sums(world, s, sums);
  }
}

}  // namespace carom::dynamics

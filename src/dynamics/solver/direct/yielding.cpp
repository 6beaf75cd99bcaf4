// The problem in which contacts yield, and what may not stand beside it: what wedges, throws, or gives energy.
#include "dynamics/solver/direct/yielding.h"

#include <algorithm>
#include <utility>

#include "dynamics/joint/energy_bound.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/round.h"
#include "dynamics/solver/direct/yielding_constants.h"

namespace carom::dynamics {
namespace {

/// Of a sum over rows, each of twelve products, in a velocity that was put together in some hundred additions.
constexpr Real kRoundingsOfEnergy = 100;

/// Velocities at contacts and joints, from the bodies'.
void measure(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
  for (ConeLink& c : problem.links) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
}

/// J, at most, that a drive gives. Joints give none.
Real given_by_drive(const ConeProblem& problem, const ConeLink& c) {
  if (c.bends) return 0;
  if (c.is_lock()) return std::fabs(c.p * c.low);  // a motor without bound
  const Real before = c.surface + relative<&ConeBody::before>(problem.bodies, c);
  return std::max(Real(0), c.p * (before + c.u) / 2);
}

/// J, kinetic: with loads alone, with all that rows did, and what of that surfaces gave, which impulses do not move.
struct Energies {
  Real before = 0, after = 0, by_surfaces = 0;
  Real gained() const { return after - before - by_surfaces; }
};
Energies energies_of(const ConeProblem& problem) {
  Energies e;
  for (const ConeBody& b : bodies_of(problem)) {
    e.before += b.unheld.dot(momentum_of(b, b.unheld)) / 2;
    e.after += b.v.dot(momentum_of(b, b.v)) / 2;
  }
  for (const ConeContact& c : problem.contacts) e.by_surfaces -= c.p.dot(c.surface);
  for (const ConeLink& c : problem.joint_rows()) e.by_surfaces -= c.p * c.surface;
  return e;
}

/// (J)^1/2: bounds what impulses that cancel each other may leave in velocities, by the metric of the masses.
Real borne_by_rows(const ConeProblem& problem) {
  const auto response = [&](std::uint32_t body, const Vec3& d, const Vec3& w) {
    return body == kInvalid ? Real(0) : response_of(problem.bodies[body], d, w);
  };
  Real sum = 0;
  for (const ConeContact& c : problem.contacts) sum += std::sqrt(c.k) * (c.p.norm() + c.start_p.norm());
  for (const ConeLink& c : problem.joint_rows())
    sum +=
        std::sqrt(response(c.a, c.d_a, c.w_a) + response(c.b, c.d_b, c.w_b)) * (std::fabs(c.p) + std::fabs(c.start_p));
  return sum;
}

}  // namespace

Real borne(const ConeProblem& problem) {
  Real sum = 0;
  for (const ConeContact& c : problem.contacts) sum += c.k * c.p.squared_norm();
  return sum;
}

bool is_wedged(const ConeProblem& problem) {
  const Real bears = borne(problem);
  if (!(bears > 0)) return false;
  Real needed = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    const Vec6 change = b.v - b.before;
    needed += change.dot(momentum_of(b, change));
  }
  return needed < kWedged * bears;
}

bool is_driven(const ConeProblem& problem) {
  return std::ranges::any_of(problem.contacts, [](const ConeContact& c) { return c.surface != c.curve; });
}

void bound_friction(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) {
    const Real closing = (c.want - c.u.dot(c.n)) / c.k;  // N s; what begins to bear: as alone
    c.most_friction = c.friction * (c.borne > 0 ? c.borne : std::max(Real(0), closing));
  }
}

std::uint32_t solve_yielding(ConeProblem& problem, Real give, Real forgets, Real tolerance) {
  for (ConeContact& c : problem.contacts) c.give = forgets * give * c.k, c.slip = 0;
  bound_friction(problem);
  problem.factored = problem.locked_softness = 0;
  const std::uint32_t steps = Round(problem, give, Round::Friction::known).minimise(tolerance);
  for (ConeContact& c : problem.contacts) c.give = 0;
  return steps;
}

void bound_by_cones(ConeProblem& problem) {
  save_impulses<&ConeContact::best, &ConeLink::best>(problem);
  for (ConeContact& c : problem.contacts) {
    const Real p_n = std::max(Real(0), c.p.dot(c.n));
    c.best = project_on_cylinder(c.p, c.n, c.friction * p_n);
  }
  return_to_impulses<&ConeContact::best, &ConeLink::best>(problem);
}

ConeSolution solve_closer(ConeProblem& problem, Real give, Real tolerance, Real tolerable) {
  constexpr Real kSlow = 0.3, kShare = 0.05, kHardest = 1e-10;
  ConeSolution solution;
  Real last = kInfinity;
  bool is_harder = false;
  for (std::uint32_t counted = 0;; last = solution.residual, ++solution.rounds) {
    for (ConeContact& c : problem.contacts)
      if (c.borne == 0) c.most_friction = c.friction * std::max(Real(0), c.p.dot(c.n));
    solution.residual = residual_of_known_friction(problem);
    solution.reached = solution.residual <= tolerance;
    const Real left = solution.residual / last;
    const bool is_slow = left >= kSlow && solution.residual > tolerable;
    counted += solution.rounds > 0 && !is_slow;
    if (solution.reached || counted == kRoundsCloser || !problem.may_go_on()) return solution;
    if (is_slow) {
      // A round leaves give / (give + response) of the error: of what bears far more than itself next to all. What contradicts
      // itself responds to nothing, and no round helps.
      give *= kShare * (1 - left) / left, is_harder = true;
      if (!(give > kHardest)) return solution;
    }
    const Real may_give = problem.may_give;
    const bool was_proven = problem.is_proven;
    Round round(problem, give, Round::Friction::known);
    solution.factorisations += round.minimise(tolerance);
    if (!is_harder || problem.is_proven) continue;
    round.take_back();  // cut short: what was before is better known
    problem.may_give = may_give, problem.is_proven = was_proven;
    return solution;
  }
}

bool throws(const ConeProblem& problem) {
  if (problem.contacts.empty()) return false;
  Real surface2 = 0;
  for (const ConeContact& c : problem.contacts) surface2 = std::max(surface2, c.surface.squared_norm());
  for (const ConeLink& c : problem.links) surface2 = std::max(surface2, c.surface * c.surface);
  if (!(surface2 > 0)) return false;
  Real before = 0, after = 0, mass = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    before += b.before.dot(momentum_of(b, b.before)) / 2;
    after += b.v.dot(momentum_of(b, b.v)) / 2;
    mass += b.inv_mass > 0 ? 1 / b.inv_mass : 0;
  }
  for (const ConeLink& c : problem.links) before += given_by_drive(problem, c);
  return after > before + kThrow * kThrow * surface2 * mass / 2;
}

// Over a share s they take -(s p.u + s^2 p.A p / 2) of the energy of relative motion: least at s = -p.u / p.A p, and
// more at 1 than at 0 where that is below a half. A spring's u counts from what it asks for, and its give is in A: it
// may give energy.
Real share_that_helps(ConeProblem& problem) {
  if (problem.contacts.empty()) return 1;
  respond(problem);
  Real along = 0, size2 = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    along += b.gradient.dot(b.before);
    size2 += b.gradient.dot(b.step);
  }
  for (const ConeContact& c : problem.contacts) along += c.p.dot(c.surface);
  for (const ConeLink& c : problem.links) {
    along += c.p * c.surface;
    if (c.is_spring()) along -= c.p * c.low, size2 += c.give * c.p * c.p;
  }
  const Real best = size2 > 0 ? -along / size2 : 1;
  return best < 0.5 ? std::max(best, Real(0)) : 1;
}

// What bodies gain, less what surfaces give, which is -p.surface. Contacts and joints are taken together: what a joint
// pulls into a contact would else have its energy from there. What a drive gives is its business. What bends give by a
// turn t of an arm in a substep is t^2/4 of the energy, and comes back after the move.
bool gives_energy(ConeProblem& problem, Real residual) {
  const auto moves = [](const ConeLink& c) { return c.surface != 0 || c.bends; };
  if (std::ranges::any_of(problem.locks, moves)) find_lock_impulses(problem);  // else nothing asks for them
  const Energies energy = energies_of(problem);
  Real inexact = 0, driven = 0;  // J
  for (const ConeContact& c : problem.contacts) inexact += c.p.norm() * residual;
  for (const ConeLink& c : problem.links) {
    inexact += std::fabs(c.p) * residual, driven += given_by_drive(problem, c);
  }
  const bool bends = std::ranges::any_of(problem.joint_rows(), &ConeLink::bends);
  const Real turns = bends ? kBends * kBends / 2 : 0;
  // Loads without bound, as of a taut chain, would let any residual give any energy.
  return energy.gained() >
         driven + std::min(inexact, energy.before) + (turns + 2e3 * kEpsilon) * (energy.before + energy.after);
}

Real excess_energy(const ConeProblem& problem) {
  const Energies energy = energies_of(problem);
  Real driven = 0;  // J: what asks for a velocity gives what it gives
  for (const ConeLink& c : problem.links)
    if (c.low > 0 || c.high < 0) driven += std::max(Real(0), c.p * c.u);
  const Real most = std::max(energy.before, energy.after);
  const Real rounding = energy.before + energy.after + std::sqrt(2 * most) * borne_by_rows(problem);
  return energy.gained() - driven - problem.may_give - kRoundingsOfEnergy * kEpsilon * rounding;
}

bool drop_bends(ConeProblem& problem) {
  bool any = false;
  for (ConeLink& c : problem.joint_rows())
    if (std::exchange(c.bends, false)) c.low = c.high = 0, any = true;
  return any;
}

void drop_impulses(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.p.set_zero();
  for (ConeLink& c : problem.links) c.p = 0;
  for (ConeBody& b : bodies_of(problem)) b.v = b.before;
  measure(problem);
}

}  // namespace carom::dynamics

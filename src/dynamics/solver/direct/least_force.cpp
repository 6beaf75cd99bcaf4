#include "dynamics/solver/direct/least_force.h"

#include <algorithm>
#include <utility>

#include "dynamics/joint/energy_bound.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/least_force_constants.h"

namespace carom::dynamics {
namespace {

void give_way(ConeProblem& problem, Real share) {
  for (ConeContact& c : problem.contacts) c.give = share * c.k;
}

/// Sum of k p^2, kg m^2/s^2.
Real borne(const ConeProblem& problem) {
  Real sum = 0;
  for (const ConeContact& c : problem.contacts) sum += c.k * c.p.squared_norm();
  return sum;
}

void push(ConeProblem& problem, const ConeContact& c, const Vec3& p) {
  const auto act = [&](std::uint32_t body, const Vec3& r, const Vec3& moment, Real sign) {
    if (body == kInvalid) return;
    ConeBody& b = problem.bodies[body];
    const Vec3 turn = c.is_spread ? Vec3(r.cross(p) + p.dot(c.n) * moment) : r.cross(p);
    b.v += velocity_of(b, {sign * p, sign * turn});
  };
  act(c.a, c.r_a, c.n_a, -1), act(c.b, c.r_b, c.n_b, 1);
}

void push(ConeProblem& problem, const ConeLink& c, Real p) {
  if (c.a != kInvalid) problem.bodies[c.a].v -= velocity_of(problem.bodies[c.a], {p * c.d_a, p * c.w_a});
  if (c.b != kInvalid) problem.bodies[c.b].v += velocity_of(problem.bodies[c.b], {p * c.d_b, p * c.w_b});
}

/// 1/kg, along the normal; and what no direction exceeds.
struct Responses {
  Real normal = 0, any = 0;
  Responses(const ConeProblem& problem, const ConeContact& c) {
    const auto add = [&](std::uint32_t body, const Vec3& r, const Vec3& moment) {
      if (body == kInvalid) return;
      const ConeBody& b = problem.bodies[body];
      const Vec3 turn = c.is_spread ? Vec3(r.cross(c.n) + moment) : r.cross(c.n);
      normal += b.inv_mass + turn.dot(b.inv_inertia * turn);
      any += b.inv_mass + b.inv_inertia.trace() * r.squared_norm();
    };
    add(c.a, c.r_a, c.n_a), add(c.b, c.r_b, c.n_b);
  }
};

/// Velocities at contacts and joints, from the bodies'.
void measure(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
  for (ConeLink& c : problem.links) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
}

void visit(ConeProblem& problem, ConeContact& c) {
  const Responses response(problem, c);
  if (!(response.normal > 0)) return;
  const Real give = kGiveOfSweeps * response.normal;
  const auto velocity = [&] { return Vec3(c.surface + relative<&ConeBody::v>(problem.bodies, c)); };
  const Real p_n = c.p.dot(c.n);
  const Real next_n = std::max(Real(0), p_n - (velocity().dot(c.n) - c.want + give * p_n) / (response.normal + give));
  push(problem, c, (next_n - p_n) * c.n);
  const Vec3 u = velocity(), p_t = c.p - p_n * c.n;
  Vec3 next_t = p_t - (u - u.dot(c.n) * c.n) / response.any;
  const Real size = next_t.norm(), most = c.friction * next_n;
  if (size > most) next_t *= most / size;
  push(problem, c, next_t - p_t);
  c.p = next_n * c.n + next_t;
}

void visit(ConeProblem& problem, ConeLink& c) {
  if (!(c.k > 0)) return;
  const Real u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
  const Real next = c.pulled(u, c.k, c.p);
  push(problem, c, next - c.p);
  c.p = next;
}

/// J, at most, that a drive gives. Joints give none.
Real given_by_drive(const ConeProblem& problem, const ConeLink& c) {
  if (c.bends) return 0;
  if (c.is_lock()) return std::fabs(c.p * c.low);  // a motor without bound
  const Real before = c.surface + relative<&ConeBody::before>(problem.bodies, c);
  return std::max(Real(0), c.p * (before + c.u) / 2);
}

}  // namespace

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

ConeSolution solve_yielding(ConeProblem& problem, Real share, Real tolerance, std::uint32_t most_steps) {
  give_way(problem, share);
  const ConeSolution solution = solve_cones(problem, tolerance, most_steps);
  give_way(problem, 0);
  return solution;
}

ConeSolution solve_with_least_force(ConeProblem& problem, Real tolerance, std::uint32_t most_steps) {
  ConeSolution solution;
  const Real first = residual(problem);
  problem.goes_on = first < kGoesOn * kGiveOfContacts * most_borne(problem);
  if (first > tolerance) {
    solution = solve_yielding(problem, kGiveOfContacts, tolerance, most_steps);
    save_impulses<&ConeContact::least_p, &ConeLink::least_p>(problem);
  }
  const Real bears = borne(problem);
  const std::uint32_t taken = solution.factorisations, rounds = solution.rounds;
  solution = solve_cones(problem, tolerance, most_steps > taken ? most_steps - taken : 0);
  solution.factorisations += taken, solution.rounds += rounds;
  problem.goes_on = false;
  if (taken > 0 && !solution.reached && borne(problem) > kFarMore * bears) {
    return_to_impulses<&ConeContact::least_p, &ConeLink::least_p>(problem);
    solution.is_wedged = true;
    solution.residual = residual(problem);
    solution.reached = solution.residual <= tolerance;
  }
  return solution;
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
Real share_that_helps(const ConeProblem& problem) {
  if (problem.contacts.empty()) return 1;
  Real along = 0, size2 = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    along += b.gradient.dot(b.before);
    size2 += b.gradient.dot(velocity_of(b, b.gradient));
  }
  for (const ConeContact& c : problem.contacts) along += c.p.dot(c.surface);
  for (const ConeLink& c : problem.links) {
    along += c.p * c.surface;
    if (c.is_spring()) along -= c.p * c.low, size2 += c.give * c.p * c.p;
  }
  const Real best = size2 > 0 ? -along / size2 : 1;
  return best < 0.5 ? std::max(best, Real(0)) : 1;
}

// Bodies gain G.(v + v')/2 by a momentum G, of which surfaces give -p.surface. Contacts and joints are
// taken together: what a joint pulls into a contact would else have its energy from there. What a drive gives is its
// business. What bends give by a turn t of an arm in a substep is t^2/4 of the energy, and comes back after the move.
bool gives_energy(ConeProblem& problem, Real residual) {
  find_momentum(problem);
  Real gained = 0, before = 0, after = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    const Vec6 mean = 0.5 * (b.before + b.v);
    gained += b.gradient.dot(mean);
    before += b.before.dot(momentum_of(b, b.before)) / 2;
    after += b.v.dot(momentum_of(b, b.v)) / 2;
  }
  Real inexact = 0, driven = 0;  // J
  for (const ConeContact& c : problem.contacts) {
    gained += c.p.dot(c.surface);
    inexact += c.p.norm() * residual;
  }
  bool bends = false;
  for (const ConeLink& c : problem.links) {
    gained += c.p * c.surface;
    inexact += std::fabs(c.p) * residual, driven += given_by_drive(problem, c);
    bends |= c.bends;
  }
  const Real turns = bends ? kBends * kBends / 2 : 0;
  // Loads without bound, as of a taut chain, would let any residual give any energy.
  return gained > driven + std::min(inexact, before) + (turns + 2e3 * kEpsilon) * (before + after);
}

bool drop_bends(ConeProblem& problem) {
  bool any = false;
  for (ConeLink& c : problem.links)
    if (std::exchange(c.bends, false)) c.low = c.high = 0, any = true;
  return any;
}

void drop_impulses(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.p.set_zero();
  for (ConeLink& c : problem.links) c.p = 0;
  for (ConeBody& b : bodies_of(problem)) b.v = b.before;
  measure(problem);
}

void sweep(ConeProblem& problem, int times) {
  for (int i = 0; i < times; ++i) {
    for (ConeLink& c : problem.links) visit(problem, c);
    for (ConeContact& c : problem.contacts) visit(problem, c);
  }
  measure(problem);
}

void hold_joints(ConeProblem& problem) {
  if (problem.links.empty()) return;
  ConeProblem joints = problem;
  joints.contacts = {};
  solve_cones(joints, kHeldByJoints * residual(joints), kMostStepsOfJoints);
  measure(problem);
}

void solve_by_sweeps(ConeProblem& problem) {
  drop_impulses(problem);
  hold_joints(problem);
  for (int left = kLastSweeps; left > 0; left -= kSweepsBetweenJoints) {
    sweep(problem, std::min(left, kSweepsBetweenJoints.value));
    hold_joints(problem);
  }
}

}  // namespace carom::dynamics

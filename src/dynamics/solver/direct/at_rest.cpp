// One factor, a few solutions with it: velocities to nothing, impulses that balance the loads.
#include "dynamics/solver/direct/at_rest.h"

#include <algorithm>
#include <utility>

#include "dynamics/solver/direct/cone.h"
#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {
namespace {

/// Contacts that are taken to stick. Of those that bear something: where velocities are next to nothing, most do that
/// are at the edge of their cones too, but not where neighbours press on each other. Of those that bear nothing: what
/// closes.
class Sticking {
 public:
  /// @param at_edges  those that have no friction to spare, too   @param closes  m/s, faster than it should
  Sticking(bool at_edges, Real closes) : at_edges_(at_edges), closes_(closes) {}
  bool has(const ConeContact& c) const {
    constexpr Real kShare = 0.99;
    if (c.p == Vec3::zero()) return c.want - c.u.dot(c.n) > closes_;
    return at_edges_ || project_on_cone(c.p, c.n, kShare * c.friction) == c.p;
  }

 private:
  bool at_edges_;
  Real closes_;
};

constexpr Real kLasting = 0.1;          // tolerances: what may be off and still lasts
constexpr Real kSoftnessAtRest = 1e-7;  // leaves 1e-11 m/s of 1e-5 m/s in a pyramid of base 10

Real resistance_at_rest(const ConeContact& c) { return kSoftnessAtRest * c.k; }

bool find_factor_at_rest(ConeProblem& problem, const Sticking& sticking) {
  problem.factored = 0;
  assemble_masses(problem, problem.factor->all());
  for (const ConeContact& c : problem.contacts)
    if (sticking.has(c)) add_sticking(problem, c, 1 / resistance_at_rest(c));
  hold_locked(problem);
  return factor(*problem.elimination, problem.first, problem.last, problem.tree, *problem.factor) > 0;
}

/// Each refinement leaves of a mode that contacts hardly feel, as the sway of a tall stack, R / (R + its share) of what
/// the last left: a tenth or so.
constexpr int kRefinements = 4;

/// Undo velocities at contacts that stick: into next_p, u0 and change.
void stop(ConeProblem& problem, const Sticking& sticking) {
  for (ConeContact& c : problem.contacts) c.next_p = c.p, c.u0 = c.u;
  for (ConeBody& b : bodies_of(problem)) b.change.set_zero();
  for (int i = 0; i < kRefinements; ++i) {
    for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
    for (const ConeContact& c : problem.contacts)
      if (sticking.has(c)) add_impulse<&ConeBody::gradient>(problem, c, c.u0 / resistance_at_rest(c));
    solve_for_steps(problem, -1);
    for (ConeBody& b : bodies_of(problem)) b.change += b.step;
    for (ConeContact& c : problem.contacts) {
      c.u0 += relative<&ConeBody::step>(problem.bodies, c);
      if (sticking.has(c)) c.next_p -= c.u0 / resistance_at_rest(c);
    }
  }
}

/// Velocities of the impulses next_p: into u0 and change.
void follow_impulses(ConeProblem& problem) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  for (const ConeContact& c : problem.contacts) add_impulse<&ConeBody::gradient>(problem, c, c.next_p - c.p);
  for (ConeBody& b : bodies_of(problem)) b.change = velocity_of(b, b.gradient);
  for (ConeContact& c : problem.contacts) c.u0 = c.u + relative<&ConeBody::change>(problem.bodies, c);
}

/// Take the solution of stop(), within the cones, where it is no worse than a tolerance.
void take_stop(ConeProblem& problem, Real tolerance) {
  Real outside = 0;  // m/s
  for (ConeContact& c : problem.contacts) {
    const Vec3 within = project_on_cone(c.next_p, c.n, c.friction);
    outside = std::max(outside, c.k * (c.next_p - within).norm());
    c.next_p = within;
  }
  constexpr Real kRounding = 1e-6;
  const bool is_led_back = outside > kRounding * tolerance;
  if (is_led_back) follow_impulses(problem);
  const auto swap = [&] {
    for (ConeContact& c : problem.contacts) std::swap(c.p, c.next_p), std::swap(c.u, c.u0);
  };
  swap();
  if (residual(problem) > (is_led_back ? kLasting : 1) * tolerance) return swap();
  for (ConeBody& b : bodies_of(problem)) b.v += b.change;
}

// With momentum g to be taken away, p' = p - J y / R and (M + J^T J / R) y = g: what is left is M y.
void balance_loads(ConeProblem& problem, const Sticking& sticking) {
  for (ConeContact& c : problem.contacts) c.next_p = c.p;
  for (ConeBody& b : bodies_of(problem)) b.gradient = momentum_of(b, b.gained + b.v - b.start);
  for (int i = 0; i < kRefinements; ++i) {
    solve_for_steps(problem, 1);
    for (ConeContact& c : problem.contacts)
      if (sticking.has(c)) c.next_p -= relative<&ConeBody::step>(problem.bodies, c) / resistance_at_rest(c);
    for (ConeBody& b : bodies_of(problem)) b.gradient = momentum_of(b, b.step);
  }
  for (ConeContact& c : problem.contacts) c.next_p = project_on_cone(c.next_p, c.n, c.friction);
}

/// m/s, the most that a contact's velocity changes in a substep of the same loads with next_p.
Real imbalance(ConeProblem& problem) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  for (const ConeContact& c : problem.contacts) add_impulse<&ConeBody::gradient>(problem, c, c.next_p - c.p);
  for (ConeBody& b : bodies_of(problem)) b.step = b.gained + b.v - b.start + velocity_of(b, b.gradient);
  Real most2 = 0;
  for (const ConeContact& c : problem.contacts)
    most2 = std::max(most2, relative<&ConeBody::step>(problem.bodies, c).squared_norm());
  return std::sqrt(most2);
}

}  // namespace

std::uint32_t rest(ConeProblem& problem, Real tolerance) {
  constexpr Real kClosing = 0.5;
  std::uint32_t factors = 0;
  for (const bool at_edges : {false, true}) {
    const Sticking sticking(at_edges, kClosing * tolerance);
    if (!find_factor_at_rest(problem, sticking)) return 0;
    ++factors;
    stop(problem, sticking);
    take_stop(problem, tolerance);
    balance_loads(problem, sticking);
    if (residual(problem) <= tolerance && imbalance(problem) <= kLasting * tolerance) return factors;
  }
  return 0;
}

}  // namespace carom::dynamics

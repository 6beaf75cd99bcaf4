// One factor, a few solutions with it: velocities to nothing, impulses that balance the loads.
#include "dynamics/solver/direct/at_rest.h"

#include <algorithm>
#include <utility>

#include "dynamics/solver/direct/patch_bound.h"
#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {
namespace {

/// What is taken to hold still: pairs that bear something, and contacts that bear nothing and close. Where velocities are
/// next to nothing, most pairs hold whose friction is all that it may be, too, but not where neighbours press on each other.
class Sticking {
 public:
  /// @param at_edges  patches that have no friction to spare, too   @param closes  m/s, faster than it should
  Sticking(const ConeProblem& problem, bool at_edges, Real closes)
      : problem_(problem), at_edges_(at_edges), closes_(closes) {}
  bool has(const ConeRow& c) const {
    if (!(c.p > 0)) return c.low - c.u > closes_;
    return has_friction(
        problem_.patches[problem_.places[static_cast<std::size_t>(&c - problem_.contacts.data())].patch]);
  }
  bool has(const ConePatch& c) const {
    const auto contacts = problem_.contacts.subspan(c.first, c.count);
    return std::ranges::any_of(contacts, [&](const ConeRow& row) { return has(row); });
  }

 private:
  bool has_friction(const ConePatch& c) const {
    constexpr Real kShare = 0.99;
    return at_edges_ || project_on_bound(c.p, c.bound(kShare * c.most)) == c.p;
  }

  const ConeProblem& problem_;
  bool at_edges_;
  Real closes_;
};

constexpr Real kLasting = 0.1;          // tolerances: what may be off and still lasts
constexpr Real kSoftnessAtRest = 1e-7;  // leaves 1e-11 m/s of 1e-5 m/s in a pyramid of base 10

template <class Part>
Real resistance_at_rest(const Part& c) {
  return kSoftnessAtRest * c.k;
}

bool find_factor_at_rest(ConeProblem& problem, const Sticking& sticking) {
  problem.factored = 0;
  const Elimination& e = *problem.elimination;
  const Blocks f = problem.factor->all();
  assemble_masses(problem, f);
  for (const ConeRow& c : problem.contacts)
    if (sticking.has(c)) add_row(e, f, c, 1 / resistance_at_rest(c));
  for (const ConePatch& c : problem.patches)
    if (sticking.has(c)) add_patch(e, f, c, (1 / resistance_at_rest(c)) * Mat3::identity());
  hold_locked(problem);
  return factor(e, problem.first, problem.last, *problem.factor);
}

/// Each refinement leaves of a mode that contacts hardly feel, as the sway of a tall stack, R / (R + its share) of what
/// the last left: a tenth or so.
constexpr int kRefinements = 4;

/// Undo velocities where it sticks: into next_p, u0 and change.
void stop(ConeProblem& problem, const Sticking& sticking) {
  each_part(problem, [](auto& c) { c.next_p = c.p, c.u0 = c.u; });
  for (ConeBody& b : bodies_of(problem)) b.change.set_zero();
  for (int i = 0; i < kRefinements; ++i) {
    for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
    each_part(problem, [&](const auto& c) {
      if (sticking.has(c)) add_impulse<&ConeBody::gradient>(problem, c, (1 / resistance_at_rest(c)) * c.u0);
    });
    solve_for_steps(problem, -1);
    for (ConeBody& b : bodies_of(problem)) b.change += b.step;
    each_part(problem, [&](auto& c) {
      c.u0 += relative<&ConeBody::step>(problem.bodies, c);
      if (sticking.has(c)) c.next_p -= (1 / resistance_at_rest(c)) * c.u0;
    });
  }
}

/// Velocities of the impulses next_p: into u0 and change.
void follow_impulses(ConeProblem& problem) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  each_part(problem, [&](const auto& c) { add_impulse<&ConeBody::gradient>(problem, c, c.next_p - c.p); });
  for (ConeBody& b : bodies_of(problem)) b.change = velocity_of(b, b.gradient);
  each_part(problem, [&](auto& c) { c.u0 = c.u + relative<&ConeBody::change>(problem.bodies, c); });
}

/// Impulses next_p led back to what rows and patches may bear.   @return m/s, how far they were off
Real lead_back(ConeProblem& problem) {
  Real outside = 0;
  for (ConeRow& c : problem.contacts) {
    outside = std::max(outside, -c.k * c.next_p);
    c.next_p = std::max(c.next_p, Real(0));
  }
  for (ConePatch& c : problem.patches) {
    Real sum = 0;
    for (const ConeRow& row : problem.contacts.subspan(c.first, c.count)) sum += row.next_p;
    const Vec3 within = project_on_bound(c.next_p, c.bound(c.friction * sum));
    outside = std::max(outside, c.k * (c.next_p - within).norm());
    c.next_p = within;
  }
  return outside;
}

/// Take the solution of stop(), within its bounds, where it is no worse than a tolerance.
void take_stop(ConeProblem& problem, Real tolerance) {
  constexpr Real kRounding = 1e-6;
  const bool is_led_back = lead_back(problem) > kRounding * tolerance;
  if (is_led_back) follow_impulses(problem);
  const auto swap = [&] { each_part(problem, [](auto& c) { std::swap(c.p, c.next_p), std::swap(c.u, c.u0); }); };
  swap();
  if (residual(problem) > (is_led_back ? kLasting : 1) * tolerance) return swap();
  for (ConeBody& b : bodies_of(problem)) b.v += b.change;
}

// With momentum g to be taken away, p' = p - J y / R and (M + J^T J / R) y = g: what is left is M y.
void balance_loads(ConeProblem& problem, const Sticking& sticking) {
  each_part(problem, [](auto& c) { c.next_p = c.p; });
  for (ConeBody& b : bodies_of(problem)) b.gradient = momentum_of(b, b.gained + b.v - b.start);
  for (int i = 0; i < kRefinements; ++i) {
    solve_for_steps(problem, 1);
    each_part(problem, [&](auto& c) {
      if (sticking.has(c)) c.next_p -= (1 / resistance_at_rest(c)) * relative<&ConeBody::step>(problem.bodies, c);
    });
    for (ConeBody& b : bodies_of(problem)) b.gradient = momentum_of(b, b.step);
  }
  lead_back(problem);
}

/// m/s, the most that velocities change in a substep of the same loads with next_p.
Real imbalance(ConeProblem& problem) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  each_part(problem, [&](const auto& c) { add_impulse<&ConeBody::gradient>(problem, c, c.next_p - c.p); });
  for (ConeBody& b : bodies_of(problem)) b.step = b.gained + b.v - b.start + velocity_of(b, b.gradient);
  Real most = 0;
  for (const ConeRow& c : problem.contacts)
    most = std::max(most, std::fabs(relative<&ConeBody::step>(problem.bodies, c)));
  for (const ConePatch& c : problem.patches) most = std::max(most, relative<&ConeBody::step>(problem.bodies, c).norm());
  return most;
}

}  // namespace

std::uint32_t rest(ConeProblem& problem, Real tolerance) {
  constexpr Real kClosing = 0.5;
  std::uint32_t factors = 0;
  for (const bool at_edges : {false, true}) {
    find_bounds(problem, [](const ConeRow& c) { return c.p; });
    const Sticking sticking(problem, at_edges, kClosing * tolerance);
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

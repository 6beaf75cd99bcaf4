// Proximal rounds until the law holds.
#include "dynamics/solver/direct/cone_problem.h"

#include <algorithm>

#include "dynamics/solver/direct/cone.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {
void find_momentum(ConeProblem& problem) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  for (const ConeContact& c : problem.contacts) add_impulse<&ConeBody::gradient>(problem, c, c.p);
  for (const ConeLink& c : problem.links) add_impulse<&ConeBody::gradient>(problem, c, c.p);
}

void apply_impulses(ConeProblem& problem) {
  find_momentum(problem);
  respond(problem);
  for (ConeBody& b : bodies_of(problem)) b.change = b.step, b.v += b.change;
  for (ConeContact& c : problem.contacts) c.u += relative<&ConeBody::change>(problem.bodies, c);
  for (ConeLink& c : problem.links) c.u += relative<&ConeBody::change>(problem.bodies, c);
}

namespace {

/// How far a contact is from the law, (m/s)^2: (k |p - P_K(p - y / k)|)^2. Of many only the largest needs its root.
Real offence2(const ConeContact& c, Real slip) {
  const Vec3 y = c.u - (c.want - slip) * c.n;
  return (c.k * (c.p - project_on_cone(c.p - y / c.k, c.n, c.friction))).squared_norm();
}

/// m/s, of all contacts and links.   @param slip  slip(contact): m/s, what stands for mu |u_t|
template <class Slip>
Real largest_offence(const ConeProblem& problem, const Slip& slip) {
  Real most2 = 0;
  for (const ConeContact& c : problem.contacts) most2 = std::max(most2, offence2(c, slip(c)));
  Real most = std::sqrt(most2);
  for (const ConeLink& c : problem.links) most = std::max(most, c.offence());
  return most;
}

}  // namespace

Real most_borne(const ConeProblem& problem) {
  Real most2 = 0;
  for (const ConeContact& c : problem.contacts) most2 = std::max(most2, c.k * c.k * c.p.squared_norm());
  return std::sqrt(most2);
}

Real residual(const ConeProblem& problem) { return largest_offence(problem, slip_of); }

Real residual_of_known_friction(const ConeProblem& problem) {
  Real most2 = 0;
  for (const ConeContact& c : problem.contacts) {
    const Vec3 z = c.p - (c.u - c.want * c.n) / c.k;
    most2 = std::max(most2, (c.k * (c.p - project_on_cylinder(z, c.n, c.most_friction))).squared_norm());
  }
  Real most = std::sqrt(most2);
  for (const ConeLink& c : problem.links) most = std::max(most, c.offence());
  return most;
}

namespace {

/// Each contact bears something, and what there is to undo at it is little beside what friction there could still bear:
/// it will go on to stick. What was just built bears nothing yet, and will.
bool is_borne(const ConeProblem& problem) {
  constexpr Real kLittle = 0.01;
  return std::ranges::all_of(problem.contacts, [&](const ConeContact& c) {
    if (problem.stood && c.p == Vec3::zero()) return true;
    const ConePart part = part_of(c.p, c.n, c.friction);
    const Real spare = part.kind == ConePart::inside ? c.friction * part.n - part.t : 0;
    return (c.u - c.want * c.n).norm() < kLittle * c.k * spare;
  });
}

/// What there is to undo is so little beside what the group bears that hardly a contact will begin or cease to stick.
bool is_little(const ConeProblem& problem, Real offence) {
  constexpr Real kLittle = 1e-3;
  return problem.stood && offence < kLittle * most_borne(problem);
}

/// Rounds at one slip until the offence with that slip is small.
class FrozenSlip {
 public:
  FrozenSlip(ConeProblem& problem, ConeSolution& solution)
      : problem_(problem), solution_(solution), softness_(first_softness()) {}

  /// @return whether it has come nearer
  bool solve(Real target) {
    const Real first = offence_now();
    Real left = first;
    for (int i = 0, idle = 0; i < kRounds && idle < kIdleRounds && left > target && problem_.may_go_on(); ++i) {
      Round round(problem_, softness_);
      const std::uint32_t steps = round.minimise(0.1 * target, kRoundSteps);
      solution_.factorisations += steps;
      ++solution_.rounds;
      const Real now = offence_now(), was = softness_;
      idle = now < left ? 0 : idle + 1;
      if (!(now < left)) round.take_back();
      if (!(now < kGood * left))
        softness_ =
            steps < kHard && !round.is_stuck() ? std::max(kLeast, kHarder * was) : std::min(kMost, kSofter * was);
      if (!(now < left) && softness_ == was) break;  // at one end, and it did not help
      left = std::min(left, now);
    }
    return left < first;
  }

 private:
  static constexpr int kRounds = 20;
  // Harder ones, then softer ones: what none of so many brought nearer is as near as this slip allows.
  static constexpr int kIdleRounds = 8;
  static constexpr std::uint32_t kRoundSteps = 60, kHard = 30;
  // A soft round is easy for Newton's method and goes part of the way, a hard one the other way round.
  // What lies on all its contacts, within their cones, will mostly go on to stick: that is nearly linear, as joints alone are.
  static constexpr Real kFirstOfBorne = 1e-5;
  static constexpr Real kFirst = 1e-3, kLeast = 1e-10, kMost = 1, kGood = 0.1, kHarder = 0.1, kSofter = 30;

  Real first_softness() const {
    return is_little(problem_, solution_.residual) || is_borne(problem_) ? kFirstOfBorne : kFirst;
  }
  Real offence_now() const {
    return largest_offence(problem_, [](const ConeContact& c) { return c.slip; });
  }

  ConeProblem& problem_;
  ConeSolution& solution_;
  Real softness_;
};

/// Slips for the next problem: those that the last one gave, extrapolated by the secant of the last two. Where the next
/// is a share of the last this finds the end at once, and where it swings it finds the middle.
/// @param noise  m/s: what slips less at first is taken to stick
void update_slips(ConeProblem& problem, bool first, Real noise) {
  Real along = 0, size2 = 0;
  for (ConeContact& c : problem.contacts) {
    const Real given = slip_of(c), change = given - c.slip, bend = change - c.old_change;
    along += bend * change, size2 += bend * bend;
  }
  const Real back = !first && size2 > 0 ? along / size2 : 0;
  for (ConeContact& c : problem.contacts) {
    const Real given = slip_of(c), change = given - c.slip;
    const Real next = first ? (given > noise ? given : 0) : std::max(Real(0), given - back * (given - c.old_slip));
    c.old_slip = given, c.old_change = change;
    c.slip = next;
  }
}

}  // namespace

ConeSolution solve_cones(ConeProblem& problem, Real tolerance) {
  constexpr int kSlips = 60;
  constexpr Real kOfTolerance = 0.3, kOfSlip = 0.03;  // closer to a slip that will change is for nothing
  problem.factored = problem.locked_softness = 0;
  ConeSolution solution;
  solution.residual = residual(problem);
  solution.reached = solution.residual <= tolerance;
  if (solution.reached) return solution;
  save_impulses<&ConeContact::best, &ConeLink::best>(problem);
  for (ConeContact& c : problem.contacts) c.slip = 0;
  FrozenSlip frozen(problem, solution);
  Real now = solution.residual;
  const bool has_slips = !problem.contacts.empty();  // joints have none: what did not help once never will
  bool goes_on = true;
  for (int i = 0; i < kSlips && goes_on && solution.residual > tolerance && problem.may_go_on(); ++i) {
    update_slips(problem, i == 0, tolerance);
    const Real target = kOfTolerance * tolerance;
    goes_on = frozen.solve(has_slips ? std::max(target, kOfSlip * now) : target) || has_slips;
    now = residual(problem);
    if (now < solution.residual) solution.residual = now, save_impulses<&ConeContact::best, &ConeLink::best>(problem);
  }
  if (now > solution.residual) return_to_impulses<&ConeContact::best, &ConeLink::best>(problem);
  solution.reached = solution.residual <= tolerance;
  return solution;
}

}  // namespace carom::dynamics

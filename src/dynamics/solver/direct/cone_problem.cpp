// Proximal rounds until the law holds.
#include "dynamics/solver/direct/cone_problem.h"

#include <algorithm>

#include "dynamics/solver/direct/patch_bound.h"
#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {

void find_momentum(ConeProblem& problem) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  each_part(problem, [&](const auto& c) { add_impulse<&ConeBody::gradient>(problem, c, c.p); });
}

void apply_impulses(ConeProblem& problem) {
  find_momentum(problem);
  for (ConeBody& b : bodies_of(problem)) b.change = velocity_of(b, b.gradient), b.v += b.change;
  each_part(problem, [&](auto& c) { c.u += relative<&ConeBody::change>(problem.bodies, c); });
}

void measure(ConeProblem& problem) {
  each_part(problem, [&](auto& c) { c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c); });
}

Real most_borne(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeRow& c : problem.contacts) most = std::max(most, c.k * c.p);
  for (const ConePatch& c : problem.patches) most = std::max(most, c.k * c.p.norm());
  return most;
}

Real residual_of_rows(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeRow& c : problem.rows) most = std::max(most, c.offence());
  return most;
}

namespace {

/// N s, that a patch may bear by what its contacts bear.
Real bound_of(const ConeProblem& problem, const ConePatch& c) {
  Real sum = 0;
  for (const ConeRow& contact : problem.contacts.subspan(c.first, c.count)) sum += contact.p;
  return c.friction * sum;
}

/// m/s   @param bound  bound(patch): N s
template <class Bound>
Real largest_offence(const ConeProblem& problem, const Bound& bound) {
  Real most2 = 0;
  for (const ConePatch& c : problem.patches) {
    if (!(c.k > 0)) continue;
    const Vec3 off = c.p - project_on_bound(c.p - c.u / c.k, c.bound(bound(c)));
    most2 = std::max(most2, c.k * c.k * off.squared_norm());
  }
  return std::max(residual_of_rows(problem), std::sqrt(most2));
}

}  // namespace

Real residual(const ConeProblem& problem) {
  return largest_offence(problem, [&](const ConePatch& c) { return bound_of(problem, c); });
}

namespace {

/// Each contact bears something, and what there is to undo at it is little beside what friction there could still bear:
/// it will go on to stick. What was just built bears nothing yet, and will.
bool is_borne(const ConeProblem& problem) {
  constexpr Real kLittle = 0.01;
  for (const ConePatch& c : problem.patches) {
    const auto contacts = problem.contacts.subspan(c.first, c.count);
    const bool bears = std::ranges::any_of(contacts, [](const ConeRow& row) { return row.p > 0; });
    if (!bears && problem.stood) continue;
    const Real spare = bound_of(problem, c) - c.p.norm();
    if (!(c.u.norm() < kLittle * c.k * spare)) return false;
    for (const ConeRow& row : contacts)
      if (!(std::fabs(row.u - row.low) < kLittle * c.k * spare) && !(problem.stood && row.p == 0)) return false;
  }
  return true;
}

/// What there is to undo is so little beside what the group bears that hardly a contact will begin or cease to stick.
bool is_little(const ConeProblem& problem, Real offence) {
  constexpr Real kLittle = 1e-3;
  return problem.stood && offence < kLittle * most_borne(problem);
}

/// Rounds at given bounds of patches, until the offence with those bounds is small.
class FrozenBounds {
 public:
  FrozenBounds(ConeProblem& problem, ConeSolution& solution, std::uint32_t most_steps)
      : problem_(problem), solution_(solution), most_steps_(most_steps), softness_(first_softness()) {}

  /// @return whether it has come nearer
  bool solve(Real target) {
    const Real first = offence_now();
    Real left = first;
    for (int i = 0, idle = 0;
         i < kRounds && idle < kIdleRounds && left > target && solution_.factorisations < most_steps_; ++i) {
      Round round(problem_, softness_);
      const std::uint32_t most = std::min(kRoundSteps, most_steps_ - solution_.factorisations);
      const std::uint32_t steps = round.minimise(0.1 * target, most);
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
  // Harder ones, then softer ones: what none of so many brought nearer is as near as these bounds allow.
  static constexpr int kIdleRounds = 8;
  static constexpr std::uint32_t kRoundSteps = 60, kHard = 30;
  // A soft round is easy for Newton's method and goes part of the way, a hard one the other way round.
  // What only locks is linear, and is at its end after a hard round or two.
  static constexpr Real kFirstOfLinks = 1e-7;
  // What lies on all its contacts, within their bounds, will mostly go on to stick: that is nearly linear.
  static constexpr Real kFirstOfBorne = 1e-5;
  // What is next to solved is better followed closely, in more steps, if there are any to spare.
  static constexpr std::uint32_t kStepsToSpare = 10;
  static constexpr Real kFirst = 1e-3, kLeast = 1e-10, kMost = 1, kGood = 0.1, kHarder = 0.1, kSofter = 30;

  Real first_softness() const {
    if (problem_.contacts.empty()) return kFirstOfLinks;
    const bool is_close = most_steps_ >= kStepsToSpare && is_little(problem_, solution_.residual);
    return is_close || is_borne(problem_) ? kFirstOfBorne : kFirst;
  }
  Real offence_now() const {
    return largest_offence(problem_, [](const ConePatch& c) { return c.most; });
  }

  ConeProblem& problem_;
  ConeSolution& solution_;
  std::uint32_t most_steps_;
  Real softness_;
};

/// Rounds in which the friction of what stands is coupled to its loads, as long as they come nearer to the law: what begins
/// to slide is lifted by them.
void solve_coupled(ConeProblem& problem, ConeSolution& solution, Real target, std::uint32_t most_steps) {
  constexpr int kRounds = 20;
  constexpr std::uint32_t kRoundSteps = 60;
  constexpr Real kFirst = 1e-5, kLeast = 1e-10, kGood = 0.1, kHarder = 0.1;
  if (!problem.stood || problem.patches.empty()) return;
  for (ConePatch& c : problem.patches) c.is_coupled = true;
  Real softness = kFirst;
  for (int i = 0; i < kRounds && solution.residual > target && solution.factorisations < most_steps; ++i) {
    Round round(problem, softness);
    solution.factorisations +=
        round.minimise(0.1 * target, std::min(kRoundSteps, most_steps - solution.factorisations));
    ++solution.rounds;
    const Real now = residual(problem);
    if (!(now < solution.residual)) {
      round.take_back();
      break;
    }
    if (!(now < kGood * solution.residual)) softness = std::max(kLeast, kHarder * softness);
    solution.residual = now;
  }
  for (ConePatch& c : problem.patches) c.is_coupled = false;
  save_impulses<&ConeRow::best, &ConePatch::best>(problem);
  problem.factored = 0;
}

/// Bounds for the next problem: by the loads that the last one gave, extrapolated by the secant of the last two. Where the
/// next is a share of the last this finds the end at once, and where it swings it finds the middle.
/// @param share  of the way to those that is gone
void update_bounds(ConeProblem& problem, bool first, Real share) {
  Real along = 0, size2 = 0;
  for (const ConePatch& c : problem.patches) {
    if (first) break;
    const Real change = bound_of(problem, c) - c.most, bend = change - c.old_change;
    along += bend * change, size2 += bend * bend;
  }
  const Real back = size2 > 0 ? along / size2 : 0;
  for (ConePatch& c : problem.patches) {
    const Real given = bound_of(problem, c), change = given - c.most;
    const Real next = first ? given : std::max(Real(0), given - back * (given - c.old_given));
    c.old_given = given, c.old_change = change;
    c.most = bearable(c.most + share * (next - c.most));
  }
}

}  // namespace

ConeSolution solve_rounds(ConeProblem& problem, Real tolerance, std::uint32_t most_steps) {
  constexpr int kBounds = 60, kIdle = 30;
  // Bounds come nearer by a share each time: what ends at the tolerance would be off by all of it in each substep.
  constexpr Real kBeyond = 0.05;
  constexpr Real kFree = 2;                           // idle updates before they go in a circle, and are taken in part
  constexpr Real kOfTolerance = 0.3, kOfLeft = 0.03;  // closer to bounds that will change is for nothing
  problem.factored = problem.locked_softness = 0;
  ConeSolution solution;
  solution.residual = residual(problem);
  solution.reached = solution.residual <= tolerance;
  if (solution.reached) return solution;
  save_impulses<&ConeRow::best, &ConePatch::best>(problem);
  solve_coupled(problem, solution, kOfTolerance * tolerance, most_steps);
  if (solution.residual <= tolerance) solution.reached = true;
  if (solution.reached) return solution;
  FrozenBounds frozen(problem, solution, most_steps);
  Real now = solution.residual;
  const bool has_patches = !problem.patches.empty();  // joints have none: what did not help once never will
  bool goes_on = true;
  int idle = 0;  // updates of bounds that brought it no nearer
  const Real enough = has_patches && problem.links.empty() && !problem.stood ? kBeyond * tolerance : tolerance;
  for (int i = 0;
       i < kBounds && idle < kIdle && goes_on && solution.residual > enough && solution.factorisations < most_steps;
       ++i) {
    if (i == 0)
      find_bounds(problem, [](const ConeRow& c) { return c.p > 0 ? c.p : std::max(Real(0), (c.low - c.u) / c.k); });
    else
      update_bounds(problem, i == 1, 1 / (1 + std::max(Real(0), idle - kFree) / 2));
    const Real target = kOfTolerance * enough;
    goes_on = frozen.solve(has_patches ? std::max(target, kOfLeft * now) : target) || has_patches;
    now = residual(problem);
    idle = now < solution.residual ? 0 : idle + 1;
    if (now < solution.residual) solution.residual = now, save_impulses<&ConeRow::best, &ConePatch::best>(problem);
  }
  if (now > solution.residual) return_to_impulses<&ConeRow::best, &ConePatch::best>(problem);
  solution.reached = solution.residual <= tolerance;
  return solution;
}

}  // namespace carom::dynamics

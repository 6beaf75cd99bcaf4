#include "dynamics/solver/direct/cone_group.h"

#include <algorithm>

#include "dynamics/contact/depth.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/solver/direct/at_rest.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/group_sweeps.h"
#include "dynamics/solver/direct/load.h"
#include "dynamics/solver/direct/round.h"
#include "dynamics/solver/direct/unchanged.h"
#include "dynamics/solver/direct/yielding.h"
#include "dynamics/solver/direct/yielding_constants.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

/// What contacts start from in the next substep. Impulses that are off let velocities grow, substep by substep, until
/// the solver undoes all that has gathered. Taken over whole that would throw the bodies back in the next substep, and
/// a group at rest would be solved for ever: what the loads need of it is as much as undoes what velocities gained in
/// this substep alone. It stays within the cones, which are convex.
void start_from_loads(ConeProblem& problem) {
  Real along = 0, size2 = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    const Vec6 undone = b.start - b.v, momentum = momentum_of(b, undone);
    along += momentum.dot(b.gained), size2 += momentum.dot(undone);
  }
  const Real share = size2 > 0 ? std::clamp(along / size2, Real(0), Real(1)) : 1;
  for (ConeContact& c : problem.contacts) c.next_p = c.start_p + share * (c.p - c.start_p);
  for (ConeLink& c : problem.links) c.next_p = c.start_p + share * (c.p - c.start_p);
  for (ConeLink& c : problem.locks) c.next_p = c.p;
}

void start_from_these(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.next_p = c.p;
  for (ConeLink& c : problem.joint_rows()) c.next_p = c.p;
}

/// Impulses that all but cancel each other where bodies are now would throw them where they will be.
void start_from_nothing(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.next_p.set_zero();
  for (ConeLink& c : problem.joint_rows()) c.next_p = 0;
}

/// What was just built and stands takes the time it takes, once.
bool starts_from_nothing(const ConeProblem& problem) {
  return std::ranges::all_of(problem.contacts, [](const ConeContact& c) { return c.start_p == Vec3::zero(); }) &&
         std::ranges::all_of(problem.links, [](const ConeLink& c) { return c.start_p == 0; });
}

/// m/s, well above what rounding leaves of a residual.
Real rounding(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeContact& c : problem.contacts) most = std::max(most, c.k * c.p.norm());
  for (const ConeLink& c : problem.links) most = std::max(most, c.k * std::fabs(c.p));
  return 1e3 * kEpsilon * most;
}

/// m/s, the most that two points close or part, with impulses as they are.
Real fastest(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeContact& c : problem.contacts) most = std::max(most, std::fabs(c.u.dot(c.n)));
  return most;
}

/// m/s, likewise, in any direction.
Real fastest_any_way(const ConeProblem& problem) {
  Real most2 = 0;
  for (const ConeContact& c : problem.contacts) most2 = std::max(most2, c.u.squared_norm());
  return std::sqrt(most2);
}

}  // namespace

ConeGroup::ConeGroup(const World& world, std::size_t group)
    : world_(world),
      c_(*world.contacts),
      s_(world.state),
      rest_(world.direct->rest[group]),
      solution_(rest_.solution),
      problem_(world.direct->problem(group)),
      row_(world.direct->row.data() + world.direct->begin[group].contact),
      link_row_(world.direct->link_row.data() + world.direct->begin[group].link),
      group_(group),
      work_(world.direct->newton_work(group)) {
  problem_.stood = rest_.stood;
}

/// Of Newton's method, from here on.   @param work  block products
void ConeGroup::allow(std::uint64_t work) {
  if (!rest_.is_bounded) return;
  if (starts_from_nothing(problem_)) work = std::max<std::uint64_t>(work, kStepsOfYielding * work_);
  problem_.most.products = problem_.taken.products + work;
}

/// So many at least, whatever was taken.
void ConeGroup::allow_steps(std::uint32_t steps) { problem_.least_steps = problem_.taken.steps + steps; }

void ConeGroup::account_work() {
  const NewtonWork& taken = problem_.taken;
  if (taken.steps > 0) rest_.work_of_step = std::max(rest_.work_of_step, taken.products / taken.steps);
  if (rest_.is_bounded) rest_.work -= std::min(rest_.work, taken.products);
}

/// Impulses of substeps that repeated the one before, into those of the step.
void ConeGroup::accumulate_repeats() {
  if (rest_.repeats == 0) return;
  each([&](const ConeContact& contact, std::uint32_t row) { c_.geometry[row].impulse += rest_.repeats * contact.p; });
  rest_.repeats = 0;
}

/// Where contacts were found at rest and every impulse in order, the next substep's are the same, as long as that
/// leaves the bodies' velocities as they are: what has changed is looked for once a step.
bool ConeGroup::repeat(Velocities& to, Real tolerance) {
  for (const ConeBody& b : bodies_of(problem_)) {
    const Vec6 gained = Vec6(s_.v[b.slot], s_.omega[b.slot]) + b.change - b.v;
    if (!(speed2(b, gained) < kRest * kRest * tolerance * tolerance)) return false;
  }
  for (ConeBody& b : bodies_of(problem_)) {
    load(b);
    b.v += b.change;
    if (rest_.stands) b.v.set_zero();
  }
  look_for_change();
  for (ConeBody& b : bodies_of(problem_)) store(to, b);
  ++rest_.repeats, ++rest_.substeps;
  return true;
}

/// Of a group that stands unchanged: the solution is the last step's.   @return whether loads are the same, too
bool ConeGroup::stands_on(Velocities& to) {
  const StoodGroup& stood = world_.direct->stood_of(group_);
  if (!rest_.lasts || print_of_motion(world_, bodies_of(problem_)) != stood.motion) return false;
  for (ConeBody& b : bodies_of(problem_)) {
    if (rest_.is_first) b.start = {s_.v[b.slot], s_.omega[b.slot]};  // should another substep not be like it
    b.v.set_zero();
    store(to, b);
  }
  rest_.is_first = false, ++rest_.substeps;
  rest_.lies = true;
  solution_ = {};
  solution_.residual = stood.residual, solution_.reached = true;
  return true;
}

/// What differs from the last step after all is found as if nothing had been known: the substeps that stood, then this.
void ConeGroup::catch_up(Velocities& to, Real h, std::uint64_t work) {
  load_group(world_, group_);
  for (ConeBody& b : bodies_of(problem_)) b.v.set_zero();  // as the step began
  rest_.is_unchanged = rest_.lasts = false;
  if (rest_.is_first) return;
  rest_.caught_up = true;
  const auto set = [&](ConeBody& b, const Vec6& v) { to.v[b.slot] = v.linear(), to.omega[b.slot] = v.angular(); };
  for (ConeBody& b : bodies_of(problem_)) b.awaited = {s_.v[b.slot], s_.omega[b.slot]}, b.unlike = b.start;
  rest_.is_first = true;
  for (std::uint32_t i = std::exchange(rest_.substeps, 0); i > 0; --i) {
    for (ConeBody& b : bodies_of(problem_)) set(b, b.unlike);
    begin(to, h, work);
  }
  for (ConeBody& b : bodies_of(problem_)) set(b, b.awaited);
}

void ConeGroup::store(Velocities& to, ConeBody& b) {
  const Vec3 v = b.v.linear(), omega = b.v.angular();
  const bool spins_on = omega == (b.is_led_back ? b.begun : s_.omega[b.slot]);
  world_.plan->touched[b.slot] = v != s_.v[b.slot] || !spins_on;
  b.is_led_on = !spins_on;
  to.v[b.slot] = v, to.omega[b.slot] = spins_on && b.is_led_back ? b.ended : omega;
}

void ConeGroup::lead_on(Velocities& to, Real h, Participants& scratch) {
  if (is_joined()) return;  // as those in lanes: end_far_turns()
  for (const ConeBody& b : bodies_of(problem_))
    if (b.is_led_on && (b.is_led_back || turns_far(b, h))) dynamics::lead_on(world_, to, b.slot, h, scratch);
}

/// Velocities are what the impulses make of those before, to the bit, whatever rounds went through: what bears nothing
/// after all flies on as if it had touched nothing. Not with joints: what they bear against each other is less exact.
void ConeGroup::follow_impulses() {
  for (ConeBody& b : bodies_of(problem_)) b.gradient.set_zero();
  for (const ConeContact& c : problem_.contacts) add_impulse<&ConeBody::gradient>(problem_, c, c.p);
  for (ConeBody& b : bodies_of(problem_)) load(b), b.v += velocity_of(b, b.gradient);
}

void ConeGroup::keep(Velocities& to) {
  if (solution_.factorisations > 0 && !is_joined() && !solution_.is_held) follow_impulses();
  each([&](const ConeContact& contact, std::uint32_t i) {
    c_.rows[i].p = contact.next_p;
    c_.rows[i].u = contact.u;
    c_.geometry[i].impulse += contact.p;
  });
  keep_links(world_, problem_, link_row_);
  accumulate_links(world_, problem_, link_row_);
  turn_rotors(world_, problem_, link_row_);
  for (ConeBody& b : bodies_of(problem_)) store(to, b);
}

/// Impulses, by the exact law as far as the work goes. What joints and contacts share is undetermined by it, and so is
/// found where contacts yield first.
void ConeGroup::find(Real h, Real goal) {
  if (shares()) return find_shares(goal);
  find_exact(goal);
  if (gives_energy() && drop_bends(problem_)) {
    hold_forest_again();
    find_exact(goal);
  }
  if (problem_.contacts.empty()) return;
  solution_.is_wedged = !solution_.reached && is_wedged(problem_);
  solution_.is_rejected = !is_sound();
  if (solution_.is_wedged || solution_.is_rejected) {
    yield_more(goal);
  } else if (is_few() && !solution_.reached && solution_.residual > kGiveOfContacts * most_borne(problem_)) {
    find_without_work(h, goal);
  }
  solution_.residual = residual(problem_), solution_.reached = solution_.residual <= goal;
}

/// Of joints and contacts: what they bear is undetermined by the exact law, so contacts yield first, from what they bore in
/// the last substep on, and then less and less.
void ConeGroup::find_shares(Real goal) {
  bound_friction(problem_);
  solution_.residual = residual_of_known_friction(problem_);
  solution_.reached = solution_.residual <= goal;
  if (solution_.reached) return;  // the last impulses solve it
  find_yielding(kForgets, goal);
  const std::uint32_t taken = solution_.factorisations;
  allow_steps(kAlways);
  solution_ = solve_closer(problem_, kGiveOfContacts, goal, world_.scene.dials[Dial::velocity_tolerance]);
  solution_.factorisations += taken, ++solution_.rounds;
  solution_.is_rejected = !is_sound();
  if (!solution_.is_rejected) return;
  drop_impulses(problem_);
  allow(rest_.work);
  find_yielding(1, goal);
  if (throws(problem_)) yield_more(goal);
}

/// Of a contact's response: as soft as springs of solver soft_step, but what is thin sinks by no more in a substep than
/// sweeps there leave of its fall.
Real ConeGroup::give_of_sweeps(Real h) const {
  Real most = 0;  // 1/s^2, pull over thickness
  for (std::size_t i = 0; i < problem_.contacts.size(); ++i)
    most = std::max(most, pull_on(world_.scene, c_.rows[row_[i]]) / least_thickness(world_, c_.geometry[row_[i]]));
  return std::min<Real>(kGiveOfSweeps, kSweptWay / (h * h * most));
}

/// Few bodies for which the work did not suffice are swept from where they began: what was found in part may be anything.
/// Where sweeps come nowhere near, or surfaces drive bodies, contacts yield: that has a bound of energy.
void ConeGroup::find_without_work(Real h, Real goal) {
  if (!is_driven(problem_)) {
    return_to_impulses<&ConeContact::start_p, &ConeLink::start_p>(problem_);
    sweep(problem_, kSweepsInstead, give_of_sweeps(h));
    if (!throws(problem_) && residual(problem_) <= kUnborne * most_borne(problem_)) return;
  }
  allow_steps(kStepsOfYielding);
  find_yielding(1, goal);
  bound_by_cones(problem_);
  if (throws(problem_)) yield_more(goal);
}

void ConeGroup::find_yielding(Real forgets, Real goal) {
  solution_.factorisations += solve_yielding(problem_, kGiveOfContacts, forgets, goal);
}

/// Where no velocity obeys the law, as where surfaces close on a body, or it would shoot it out, which no machine does:
/// contacts yield, more and more. From nothing on, for what they bear by now may be anything.
void ConeGroup::yield_more(Real goal) {
  for (Real give = kGiveOfContacts;; give = std::min(10 * give, kGiveOfSweeps.value)) {
    drop_impulses(problem_);
    allow_steps((is_few() ? kStepsOfYielding : kAlways).value);
    solution_.factorisations += solve_yielding(problem_, give, 1, goal);
    if (give >= kGiveOfSweeps || !throws(problem_)) return;
  }
}

/// From the solution on: what is off by a little gives a little.
void ConeGroup::find_exact(Real goal) {
  const ConeSolution was = solution_;
  allow_steps(kAlways);
  solution_ = solve_cones(problem_, goal);
  solution_.factorisations += was.factorisations, solution_.rounds += was.rounds;
}

/// Else bodies have what the last impulses give them.
bool ConeGroup::was_solved() const { return solution_.factorisations > 0 || !problem_.tree.empty(); }

bool ConeGroup::gives_energy() {
  return was_solved() && dynamics::gives_energy(problem_, world_.scene.dials[Dial::velocity_tolerance]);
}

/// Neither shot out by surfaces that close, nor with more energy than before.
bool ConeGroup::is_sound() { return !was_solved() || !(throws(problem_) || gives_energy()); }

Real ConeGroup::tolerance() const { return kDirectShare * world_.scene.dials[Dial::velocity_tolerance]; }

bool ConeGroup::lies_still() const {
  return !is_joined() && fastest_any_way(problem_) < world_.scene.dials[Dial::velocity_tolerance];
}

/// What stood still and has drifted off its solution by a little: contacts that stick go on sticking, so that one
/// factor sets it right, where Newton's method would begin with the question which do.
bool ConeGroup::is_still_at_rest(Real goal) {
  if (is_joined() || !problem_.stood || !rest_.lies || !(solution_.residual < kRest * tolerance())) return false;
  solution_.factorisations = rest(problem_, goal);
  solution_.residual = residual(problem_), solution_.reached = solution_.residual <= goal;
  return lasts_ = solution_.factorisations > 0 && solution_.reached && lies_still();
}

/// A solution in which all lies still, made one that lasts.
bool ConeGroup::comes_to_rest(Real goal) {
  if (lasts_) return true;
  if (!problem_.stood || !solution_.reached || solution_.factorisations == 0 || !lies_still()) return false;
  const std::uint32_t taken = rest(problem_, goal);
  solution_.factorisations += taken;
  return taken > 0;
}

/// What is left over adds up from substep to substep, as loads do. So in a short one it is no more than a share of what
/// those do in it, and of what moves as much less as its square: else a finer step would err by more. Not with joints: what
/// friction holds there would creep by 8e-5 of its arm in a turn in place of 5e-5 (oracle/held).   @param h  s, substep
Real ConeGroup::goal(bool is_bounded, Real h) const {
  constexpr Real kUsualSubsteps = 240;  // 1/s
  const Real fine = std::max(kFineShare * tolerance(), rounding(problem_));
  const Real usual = is_joined() ? tolerance() : std::min(tolerance(), std::max(fine, kConeShare * rest_.load));
  if (is_few() && problem_.stood) return fine;
  const bool roughly = is_bounded && !problem_.stood && !problem_.contacts.empty();
  if (!roughly) return is_joined() ? std::min(usual, fine) : usual;
  const Real finer = is_joined() ? 1 : std::min(Real(1), kUsualSubsteps * h), share = kConeShare * finer * finer;
  const Real rough = std::max(usual, share * fastest(problem_));
  if (!is_few() || is_joined()) return rough;
  return std::clamp(share * fastest_any_way(problem_), std::min(fine, rough), rough);
}

void ConeGroup::begin(Velocities& to, Real h, std::uint64_t work) {
  const bool is_bounded = work > 0;
  if (rest_.is_unchanged) {
    rest_.asks = false;
    if (stands_on(to)) return;
    catch_up(to, h, work);
  }
  if (rest_.is_first) rest_.work = rest_.share = own_work(work);
  rest_.asks = rest_.is_far_off = false;
  if (rest_.lasts && repeat(to, tolerance())) return;
  accumulate_repeats();
  if (rest_.has_moved) turn_frames(), measure();  // should it not lie still any more
  rest_.least = start(h);
  rest_.lies = lies_still();
  rest_.is_bounded = is_bounded && !(problem_.stood && starts_from_nothing(problem_));
  rest_.at_once = rest_.lies || (rest_.is_bounded && rest_.stood && kExpectedAtRest * work_ > own_work(work));
  const bool waits = rest_.is_bounded && rest_.at_once && (rest_.is_close || (rest_.lies && rest_.waits));
  rest_.waits = waits && !goes_round();
  if (rest_.is_too_large || rest_.gave_up || takes_all_of(own_work(work))) return go_on_by_sweeps(to, h);
  solution_ = {};
  solution_.residual = residual(problem_);
  rest_.goal = goal(is_bounded, h);
  solution_.reached = solution_.residual <= rest_.goal;
  if (was_held_ && !solution_.reached && may_be_held() && solution_.residual < kRest * tolerance()) hold();
  rest_.asks = is_joined() || !solution_.reached;
  if (!rest_.asks) finish(to);
}

/// Block products that it may take in a step, whatever others there are. Few of which a step of Newton's method is cheap have
/// as much again: an impact through a stack of fifteen takes a hundred of them, in one step.
std::uint64_t ConeGroup::own_work(std::uint64_t most) const {
  const bool has_more = is_few() && !is_joined() && yields_for_half(work_, world_.plan->substeps);
  if (is_few() || is_joined()) return std::max(most, (has_more ? 2 : 1) * kWorkOfFew);
  return std::min(most, std::max(kLeastWork.value, kWorkOfPoint * problem_.contacts.size()));
}

/// It moves, and one step of Newton's method is more than there is for the step of the world.
bool ConeGroup::takes_all_of(std::uint64_t work) const {
  return rest_.is_bounded && !rest_.at_once && !is_few() && work_ > work;
}

/// Two a substep, as soft contacts take; those solve it from the next step on.
void ConeGroup::sweep_on(Real h) {
  sweep(problem_, 2, give_of_sweeps(h));
  find_lock_impulses(problem_);
  solution_.residual = residual(problem_);
  rest_.is_far_off = is_far_off();
}

void ConeGroup::go_on_by_sweeps(Velocities& to, Real h) {
  rest_.gave_up = true;
  solution_ = {};
  sweep_on(h);
  finish(to);
}

/// Whether its solution came nowhere near the law. Of what stood, or hangs on joints: if it leaves more of the loads
/// than soft contacts and joints would, which are what would solve it then.
bool ConeGroup::is_far_off() const {
  const Real tolerable = world_.scene.dials[Dial::velocity_tolerance];
  return !solution_.reached &&
         solution_.residual > (problem_.stood || is_joined() ? std::max(tolerable, kUnborne * rest_.load) : tolerable);
}

/// Block products that this substep may take: what there is for the step but for half of what each substep to come would have. An
/// impact is in one of them, and a solve that is cut short there tears joints and throws down stacks.
std::uint64_t ConeGroup::work_of_substep(std::uint32_t substeps) const {
  if (rest_.at_once) return rest_.work;
  const std::uint64_t share = rest_.share / substeps;
  const std::uint64_t kept = (substeps - std::min(substeps, rest_.substeps + 1)) * share / 2;
  return std::max(rest_.work, kept) - kept;
}

void ConeGroup::solve(Velocities& to, Real h, int substeps) {
  if (!rest_.waits) find_solution(h, work_of_substep(static_cast<std::uint32_t>(substeps)));
  finish(to);
}

void ConeGroup::find_solution(Real h, std::uint64_t work) {
  const Real goal = rest_.goal;
  if (is_still_at_rest(goal)) {
    rest_.is_close = true;
    return account_work();
  }
  allow(work);
  find(h, goal);
  find_lock_impulses(problem_);
  if (!solution_.reached && may_be_held()) {
    hold();
    return account_work();
  }
  for (int i = 0; i < kJerks && is_joined() && is_jerked(world_, problem_, link_row_, h); ++i) {
    for (ConeLink& link : problem_.joint_rows()) link.next_p = link.p;
    keep_links(world_, problem_, link_row_);
    start(h);
    const std::uint32_t taken = solution_.factorisations;
    solution_ = {};
    solution_.residual = residual(problem_);
    allow(work);
    find(h, goal);
    find_lock_impulses(problem_);
    solution_.factorisations += taken;
  }
  account_work();
  rest_.is_close = solution_.residual < world_.scene.dials[Dial::velocity_tolerance];
  rest_.is_far_off = is_far_off();
  rest_.gave_up |= rest_.is_bounded && !rest_.lies && !is_few() && rest_.is_far_off;
  if (!rest_.gave_up || !is_joined()) return measure_energy();
  return_to_impulses<&ConeContact::start_p, &ConeLink::start_p>(problem_);
  sweep_on(h);
}

/// Whether what moves is no faster than what a solution may be off by: then it is that, and would go on for ever.
bool ConeGroup::stands() const {
  const Real slowest = kFineShare * tolerance();
  return problem_.stood && std::ranges::all_of(bodies_of(problem_),
                                               [&](const ConeBody& b) { return speed2(b, b.v) < slowest * slowest; });
}

/// Whether this substep leaves the group as the step found it, and is like those before it. @see unchanged.h
void ConeGroup::look_for_change() {
  if (rest_.problem == 0 || rest_.varies) return;
  for (const ConeBody& b : bodies_of(problem_)) rest_.varies |= b.v != Vec6::zero();
  each([&](const ConeContact& contact, std::uint32_t row) { rest_.varies |= contact.next_p != c_.rows[row].p; });
  if (rest_.varies) return;
  for (ConeBody& b : bodies_of(problem_)) b.v.set_zero();  // not -0
  const std::uint64_t motion = print_of_motion(world_, bodies_of(problem_));
  if (rest_.is_first) rest_.motion = motion, rest_.residual = solution_.residual;
  rest_.varies = motion != rest_.motion;
}

/// To the bit, so that poses stay what they are.
void ConeGroup::stop() {
  for (ConeBody& b : bodies_of(problem_)) b.v.set_zero();
  for (ConeContact& c : problem_.contacts) c.u.set_zero();
}

/// Of a solution of the convex problem: what others give is a matter of their residual.
void ConeGroup::measure_energy() {
  if (!(problem_.may_give >= 0)) return;
  solution_.excess_energy = std::max(Real(0), dynamics::excess_energy(problem_));
  if (!world_.watches_stages || !problem_.is_proven || !(solution_.excess_energy > 0)) return;
  std::fprintf(stderr, "carom: an island of %u bodies has %.3g J more than its rows may give\n",
               problem_.last - problem_.first, static_cast<double>(solution_.excess_energy));
  std::abort();
}

bool ConeGroup::may_be_held() const { return rest_.is_bounded && rest_.lies && problem_.stood; }

/// What lies still and is not solved within its work, or what was held so before, stays as it lies: at rest, on the
/// best impulses there are, which balance the loads but for next to nothing. Else velocities too small to see would add
/// up, grow by as much again in each substep, and throw down what stood.
void ConeGroup::hold() {
  stop();
  solution_.reached = solution_.is_held = true;
}

void ConeGroup::finish(Velocities& to) {
  if ((solution_.is_wedged || solution_.is_rejected) && !is_joined())
    start_from_nothing(problem_);
  else if (solution_.is_held || shares())
    start_from_these(problem_);
  else if (!comes_to_rest(rest_.goal))
    start_from_loads(problem_);
  rest_.lasts = !is_joined() && !solution_.is_held && solution_.factorisations == 0 && rest_.least >= -1 &&
                !rest_.resists && fastest_any_way(problem_) < kRest * tolerance() &&
                std::ranges::none_of(bodies_of(problem_), &ConeBody::is_led_back);
  rest_.stands = rest_.lasts && stands();
  if (rest_.stands) stop();
  look_for_change();
  keep(to);
  rest_.is_first = false, ++rest_.substeps;
  rest_.has_moved = rest_.lasts;  // or part() measures
}

}  // namespace carom::dynamics

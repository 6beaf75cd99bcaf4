// A group after the move: overlaps undone, joints settled, separations measured.
#include <algorithm>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/depth.h"
#include "dynamics/quarantine.h"
#include "dynamics/solver/direct/cone_group.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/load.h"
#include "dynamics/solver/direct/yielding.h"
#include "dynamics/solver/direct/yielding_constants.h"
#include "dynamics/solver/far_turns.h"

namespace carom::dynamics {

/// Where work counts, and contacts may be in the way of what joints ask for.
bool ConeGroup::may_contradict() const { return rest_.is_bounded && !problem_.contacts.empty(); }

/// m or rad, of a joint that needs no correction: in contact a share of what contacts are let overlap by.
Real ConeGroup::tolerable_gap() const {
  const Real tolerance = world_.scene.dials[Dial::position_tolerance];
  if (rest_.is_dear) return tolerance;
  return may_contradict() || rest_.in_lanes ? std::max<Real>(kGap, kFineShare * tolerance) : kGap;
}

bool ConeGroup::is_nearer() const {
  constexpr Real kNearer = 0.5;
  const Real gap = worst_error(world_, problem_, link_row_);
  const bool must_pay = (may_contradict() || rest_.is_dear) && gap > world_.scene.dials[Dial::position_tolerance];
  return gap > tolerable_gap() && (!must_pay || gap < kNearer * rest_.gap);
}

bool ConeGroup::gapes() const {
  return worst_error(world_, problem_, link_row_) > world_.scene.dials[Dial::position_tolerance];
}

/// To where the bodies are by now.
void ConeGroup::turn_frames() {
  for (const ConeBody& b : bodies_of(problem_)) world_.plan->rotation[b.slot] = s_.q[b.slot].matrix();
}

Real ConeGroup::measure() {
  Real least = kInfinity;
  each([&](const ConeContact&, std::uint32_t row) {
    Real& separation = c_.geometry[row].separation;
    separation = separation_of(world_, c_.rows[row], c_.geometry[row]);
    least = std::min(least, separation / tolerable_depth(world_, c_.geometry[row]));
  });
  return least;
}

/// m or rad, the most that a contact or a joint is to be moved.
Real ConeGroup::asked() const {
  Real asked = 0;
  for (const ConeContact& c : problem_.contacts) asked = std::max(asked, c.want);
  for (const ConeLink& c : problem_.joint_rows())
    if (c.most > 0) asked = std::max({asked, c.low, -c.high});
  return asked;
}

/// Of the displacements that were found, how much is taken. What is wedged between walls that nearly face each other,
/// or is pushed at from all sides, would be moved by metres to be parted by millimetres. What follows a sweep is near already, and
/// turns no farther either; what is torn may have to turn about.
Real ConeGroup::displacement_share(Real asked, Real most_closed) const {
  constexpr Real kFarthestTurn = 0.25;  // rad: of a joint's arm 3 % are off the tangent then
  Real moved2 = 0, turned2 = 0;
  for (const ConeBody& b : bodies_of(problem_)) {
    moved2 = std::max(moved2, follows_ ? speed2(b, b.v) : b.v.linear().squared_norm());
    turned2 = std::max(turned2, b.v.angular().squared_norm());
  }
  const Real most = std::min(kLongestTurn * asked, std::max(asked, most_closed));
  const Real share = moved2 > most * most ? most / std::sqrt(moved2) : 1;
  return is_joined() && turned2 * share * share > kFarthestTurn * kFarthestTurn ? kFarthestTurn / std::sqrt(turned2)
                                                                                : share;
}

/// Displacements yield, contacts and locks alike: what contradicts itself has one then, found in few steps, and a chain
/// that is pulled straight is not moved by metres.
void ConeGroup::let_locks_yield() {
  for (ConeLink& c : problem_.links)
    if (c.is_lock()) c.give = kGiveOfDisplacements * c.k;
}

/// m or rad, of a joint. What waits for the last substep has the whole step for it.
Real ConeGroup::most_closed(Real h) const {
  return kJointPush * h * (rest_.in_lanes && !problem_.links.empty() ? world_.plan->substeps : 1);
}

void ConeGroup::part(Poses& to, Real h) {
  turn_frames();
  part(to, h, most_closed(h), may_contradict() || rest_.in_lanes ? Forest::as_it_began : Forest::anew);
}

void ConeGroup::part_again(Poses& to, Real h) { part(to, h, most_closed(h), Forest::anew); }

void ConeGroup::part(Poses& to, Real h, Real most_closed, Forest forest) {
  if (rest_.lasts || rest_.is_too_large) return;
  if (is_joined() && rest_.gave_up) problem_.contacts = {};  // lanes part it, from the next step on
  Real tolerance = world_.scene.dials[Dial::position_tolerance];
  const Real most = world_.scene.dials[Dial::push_speed] * h;
  solution_ = {};
  rest_.gap = is_joined() ? worst_error(world_, problem_, link_row_) : 0;
  const bool overlaps = measure() < -1;
  if (!overlaps && !(rest_.gap > tolerable_gap())) return;
  each([&](ConeContact& contact, std::uint32_t row) {
    contact.p.set_zero();
    contact.friction = 0;
    const Real depth = tolerable_depth(world_, c_.geometry[row]);
    tolerance = std::min(tolerance, depth);
    contact.want = std::min(-(c_.geometry[row].separation + depth / 2), most);
  });
  for (ConeBody& b : bodies_of(problem_)) b.v.set_zero();
  load_links(world_, problem_, link_row_, LinkPhase::part, h, most_closed);
  hold_forest(forest);
  for (ConeContact& c : problem_.contacts) c.u = relative<&ConeBody::v>(problem_.bodies, c);
  measure_links(problem_);
  const Real most_asked = asked();
  let_locks_yield();
  const Real goal = is_joined() ? std::max(0.1 * tolerable_gap(), kGiveOfDisplacements * most_asked) : 0.01 * tolerance;
  problem_.taken = {}, problem_.most = {kStepsOfYielding, kLeastWork};
  allow_steps(2 * kAlways);
  if (!problem_.contacts.empty() || !problem_.links.empty())
    solution_.factorisations = solve_yielding(problem_, kGiveOfDisplacements, 1, goal);
  rest_.has_parted = true;
  const Real share = displacement_share(most_asked, most_closed);
  for (const ConeBody& b : bodies_of(problem_)) {
    Vec3 turn = share * b.v.angular();
    if (!is_joined() && may_turn_far(world_, b.slot) && turns_too_far(world_, b.slot, turn)) turn.set_zero();
    correct_pose(to, b.slot, share * b.v.linear(), turn);
    if (turn == Vec3::zero()) continue;
    world_.plan->rotation[b.slot] = s_.q[b.slot].matrix();
  }
  for (ConeBody& b : bodies_of(problem_)) load(b);
  measure();
}

bool ConeGroup::is_swept() const {
  return std::ranges::any_of(bodies_of(problem_), [&](const ConeBody& b) { return is_led_by_sweep(world_, b.slot); });
}

void ConeGroup::follow_swept(Poses& to, Real h) {
  constexpr Real kHeavier = 1e6;
  follows_ = true;
  turn_frames();
  Real fastest2 = kJointPush * kJointPush;
  for (ConeBody& b : bodies_of(problem_)) {
    load_mass(world_, b);
    const Vec3 &v = s_.v[b.slot], &omega = s_.omega[b.slot];
    fastest2 = std::max({fastest2, v.squared_norm(), omega.squared_norm()});
    if (joints_alone_ || !is_led_by_sweep(world_, b.slot)) continue;
    b.mass *= kHeavier, b.inertia = kHeavier * b.inertia;
    b.inv_mass /= kHeavier, b.inv_inertia = b.inv_inertia / kHeavier;
  }
  part(to, h, std::sqrt(fastest2) * h, Forest::anew);
  for (ConeBody& b : bodies_of(problem_)) load_mass(world_, b);
}

void ConeGroup::settle(Velocities& to, Real h) {
  if (rest_.in_lanes || !is_joined() || !problem_.contacts.empty()) return;
  const Real tolerance = this->tolerance();
  turn_frames();
  for (ConeBody& b : bodies_of(problem_)) load_mass(world_, b), load(b);
  load_links(world_, problem_, link_row_, LinkPhase::settle, h);
  hold_forest(Forest::anew);
  measure_links(problem_);
  const ConeSolution solution = solve_cones(problem_, kFineShare * tolerance);
  solution_.factorisations += solution.factorisations;
  find_lock_impulses(problem_);
  accumulate_links(world_, problem_, link_row_);
  turn_rotors(world_, problem_, link_row_);
  for (ConeBody& b : bodies_of(problem_)) store(to, b);
}

void ConeGroup::end() {
  StoodGroup& stood = world_.direct->stood_of(group_);
  if (rest_.is_unchanged) {
    each([&](const ConeContact&, std::uint32_t row) {
      Vec3& impulse = c_.geometry[row].impulse;
      const Vec3& p = c_.rows[row].p;
      for (std::uint32_t i = 0; i < (stood.repeats > 0 ? 1 : rest_.substeps); ++i) impulse += p;
      if (stood.repeats > 0) impulse += stood.repeats * p;
    });
  } else {
    const bool alike = !rest_.varies && (rest_.repeats == 0 || rest_.repeats + 1 == rest_.substeps);
    stood = {alike ? rest_.problem : 0, rest_.motion, rest_.residual, rest_.repeats};
    accumulate_repeats();
  }
  measure();
}

}  // namespace carom::dynamics

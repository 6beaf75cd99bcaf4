// How a group begins a substep: contacts follow its bodies, loads act, impulses are those of the substep before.
#include <algorithm>

#include "dynamics/contact/depth.h"
#include "dynamics/contact/held_arms.h"
#include "dynamics/contact/turning_ground.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/solver/direct/cone_group.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/load.h"
#include "dynamics/solver/direct/yielding.h"
#include "dynamics/solver/far_turns.h"

namespace carom::dynamics {

/// Contacts go with the bodies within a step. But not where a shape is curved: points that turned with it would stay
/// behind the place where it touches as it rolls, and drive it on.
void ConeGroup::follow_bodies() {
  for (ConeBody& b : bodies_of(problem_)) {
    if (b.turns) world_.plan->rotation[b.slot] = s_.q[b.slot].matrix();  // others may have asked for it since, or not
    load_mass(world_, b);
  }
  load_contacts(world_, {row_, problem_.contacts.size()}, problem_.bodies, problem_.contacts.data(),
                LoadWhat::not_curved);
}

/// Of contacts that do not go with the bodies: the velocity of ground that a host moves is another in each substep.
void ConeGroup::follow_ground(Real h) {
  if (world_.plan->led.empty()) return;
  each([&](ConeContact& contact, std::uint32_t i) {
    if (!contact.is_curved || (contact.a != kInvalid && contact.b != kInvalid)) return;
    const Row& row = c_.rows[i];
    const LedBody* const led = led_body(world_, contact.a == kInvalid ? row.a : row.b);
    if (!led) return;
    const Arms arms = Arms::now(world_, row, c_.geometry[i]);
    if (contact.a == kInvalid)
      contact.surface -= h * (led->a + led->alpha.cross(arms.a));
    else
      contact.surface += h * (led->a + led->alpha.cross(arms.b));
  });
}

/// Where a body rolls, the middle of the ball that it rolls on leaves the tangent of its way. Velocities are to obey
/// the law in the middle of the substep, where that of the point is by h/2 omega x (omega x l) another than at its
/// beginning, where impulses act. Then they act on the mean of the velocities before and after, which is along the
/// surface, and a body that goes round loses no energy by it. Not of what turns too far for that: its square would
/// throw it. What both have in common on ground that turns is in the lead of the pair.
void ConeGroup::bend_ways(Real h) {
  const TurningPair* of = nullptr;
  Lead lead;
  const auto bend = [&](const Vec3& omega, const Vec3& arm) { return Vec3(h / 2 * omega.cross(omega.cross(arm))); };
  const auto bends = [&](std::uint32_t body, const Vec3& l) {
    if (body == kInvalid || !problem_.bodies[body].turns) return Vec3(Vec3::zero());
    const ConeBody& b = problem_.bodies[body];
    const Vec3 omega = b.v.angular(), arm = world_.plan->rotation[b.slot] * l;
    if (omega.squared_norm() * h * h > kBends * kBends) return Vec3(Vec3::zero());
    return of ? Vec3(bend(omega, arm) - bend(lead.spin, arm)) : bend(omega, arm);
  };
  each([&](ConeContact& contact, std::uint32_t i) {
    const TurningPair* const turning_pairs = led_by(i);
    contact.surface -= contact.curve;
    contact.curve.set_zero();
    if (!c_.rows[i].rolls && !turning_pairs) return;
    if (turning_pairs && turning_pairs != of) lead = lead_of(world_, *turning_pairs, h);
    of = turning_pairs;
    if (c_.rows[i].rolls) contact.curve = bends(contact.b, c_.geometry[i].l_b) - bends(contact.a, c_.geometry[i].l_a);
    if (turning_pairs) contact.curve += lead.along(contact.apart, contact.n);
    contact.surface += contact.curve;
  });
}

/// What hangs on an arm that swings leaves its circle by the tangent, and is displaced back onto it after the move: in
/// contact locks are not asked for that bend (load_links()). Friction's target is where that leads points of the surface, else
/// what is gripped creeps outwards by half (omega h)^2 of its arm in each substep. Of pairs that stick: all of their points have
/// one target, whichever of them bear. Where a joint closes a loop its row leads bodies elsewhere than the forest alone: a track on
/// sprockets gained energy.
void ConeGroup::bend_arms(Real h) {
  if (!shares() || problem_.tree.empty() || std::ranges::any_of(problem_.links, &ConeLink::is_lock)) return;
  // Since the substep before. What is gripped goes round with its gripper. A limb that rocks on the ground does not, and would
  // never come to rest.
  const auto is_gripped = [&](std::span<const ConeContact> pair) {
    constexpr Real kAlike = 0.1;  // of their spin
    const ConeContact& of = pair.front();
    if (of.a == kInvalid || of.b == kInvalid) return false;
    Real bound = 0;
    Vec3 along = Vec3::zero();
    for (const ConeContact& c : pair) {
      const Real n = c.p.dot(c.n);
      along += c.p - n * c.n, bound += c.friction * n;
    }
    if (!(along.norm() < bound)) return false;
    const Vec3 w_a = problem_.bodies[of.a].v.angular(), w_b = problem_.bodies[of.b].v.angular();
    const Real spin2 = std::max(w_a.squared_norm(), w_b.squared_norm());
    return spin2 * h * h < kBends * kBends && (w_a - w_b).squared_norm() <= kAlike * kAlike * spin2;
  };
  bool is_known = false;
  for (std::size_t i = 0, next; i < problem_.contacts.size(); i = next) {
    const auto is_of_pair = [&](const ConeContact& c) {
      return c.a == problem_.contacts[i].a && c.b == problem_.contacts[i].b;
    };
    for (next = i + 1; next < problem_.contacts.size() && is_of_pair(problem_.contacts[next]);) ++next;
    if (!is_gripped(problem_.contacts.subspan(i, next - i))) continue;
    if (!is_known) bend_as_gripped(world_, problem_, link_row_, h), find_bends(problem_, h), is_known = true;
    for (ConeContact& c : problem_.contacts.subspan(i, next - i)) {
      const Vec3 bend = relative<&ConeBody::step>(problem_.bodies, c);
      const Vec3 along = bend - bend.dot(c.n) * c.n;
      c.curve += along, c.surface += along;
    }
  }
}

const TurningPair* ConeGroup::led_by(std::uint32_t row) const { return is_led_ ? turning_pair_at(c_, row) : nullptr; }

/// (m/s)^2, of what this substep's loads alone do to a body that has its velocity of before.
Real ConeGroup::loaded_speed2(const ConeBody& b) const { return speed2(b, Vec6{s_.v[b.slot], s_.omega[b.slot]} - b.v); }

/// Whether ground that turns leads bodies of the group. What stands, and on nothing that a host turns, is led by none of
/// its own: the turns that it has are what loads and the solver leave it, and things of a millimetre turn fast by little.
/// What is round is never so: it rolls on under its loads.
bool ConeGroup::find_leads() {
  if (c_.turning_pairs.empty()) return false;
  bool stands = !is_joined(), is_led = false;
  for (const ConeBody& b : bodies_of(problem_)) stands &= speed2(b, b.v) <= loaded_speed2(b);
  each([&](const ConeContact& contact, std::uint32_t i) {
    const TurningPair* const pair = turning_pair_at(c_, i);
    is_led |=
        pair && (!stands || pair->has_belts || contact.is_curved || contact.a == kInvalid || contact.b == kInvalid);
  });
  return is_led;
}

/// Whether ground that a host moves, or a belt, takes it round: it is asked something else in each substep, and what one left over
/// would add up.
bool ConeGroup::goes_round() {
  bool found = false;
  each([&](const ConeContact& contact, std::uint32_t i) {
    found |= led_by(i) && (contact.a == kInvalid || contact.b == kInvalid);
  });
  return found;
}

/// What loads give a body is reckoned from where the ground that it lies on leads it: on a disc that is round, and what
/// holds it on its circle is a load as its weight is. Ground that a host moves leads all of its group.
void ConeGroup::take_along(Real h) {
  if (!is_led_) return;
  const TurningPair* ground = nullptr;
  Vec3 v = Vec3::zero();  // m/s, of the ground's middle
  each([&](const ConeContact& contact, std::uint32_t i) {
    const TurningPair* const turning_pairs = turning_pair_at(c_, i);
    const Row& row = c_.rows[i];
    if (!turning_pairs || ground || (contact.a != kInvalid && contact.b != kInvalid)) return;
    ground = turning_pairs, v = s_.v[row.moves_a ? row.b : row.a];
  });
  each([&](const ConeContact& contact, std::uint32_t i) {
    const TurningPair* const turning_pairs = turning_pair_at(c_, i);
    if (!turning_pairs) return;
    const Quat turn = exp_map(h * lead_of(world_, ground ? *ground : *turning_pairs, h).turn);
    for (const std::uint32_t body : {contact.a, contact.b}) {
      if (body == kInvalid || problem_.bodies[body].is_taken_along) continue;
      ConeBody& b = problem_.bodies[body];
      b.is_taken_along = true;
      b.v = {v + turn * Vec3(b.v.linear() - v), turn * b.v.angular()};
    }
  });
  for (ConeBody& b : bodies_of(problem_)) b.is_taken_along = false;
}

/// What rolls may spin about its axis as fast as it likes.
bool ConeGroup::turns_far(const ConeBody& b, Real h) const {
  if (!may_turn_far(world_, b.slot) || !turns_by_method(*world_.plan, b.slot) || s_.held_out[b.slot]) return false;
  return b.rolls ? turns_too_far(world_, b.slot, h * s_.omega[b.slot]) : turns_far_for_its_shape(world_, b.slot, h);
}

/// Spins that a rotation method has led on to the end of the substep are led back to where it begins, of what turns far
/// for its shape: there are its masses and arms (far_turns.h). Of what is joined that is done for all in lanes.
void ConeGroup::lead_back(Real h) {
  for (ConeBody& b : bodies_of(problem_)) b.rolls = b.is_led_back = false;
  if (is_joined() || !world_.plan->rotation_method) return;
  each([&](const ConeContact& contact, std::uint32_t i) {
    if (!c_.rows[i].rolls) return;
    if (contact.a != kInvalid) problem_.bodies[contact.a].rolls = true;
    if (contact.b != kInvalid) problem_.bodies[contact.b].rolls = true;
  });
  for (ConeBody& b : bodies_of(problem_)) {
    b.is_led_back = turns_far(b, h);
    if (!b.is_led_back) continue;
    b.ended = s_.omega[b.slot];
    b.begun = led_back(world_, b.slot, b.ended);
  }
}

/// Velocities at which joints of the forest hold, and nothing else acts.
/// @param forest  as it began: what its joints let go is that of the substep's beginning
void ConeGroup::hold_forest(Forest forest) {
  for (ConeBody& b : bodies_of(problem_)) b.unheld = b.v, b.place = s_.x[b.slot];
  if (forest == Forest::anew)
    articulate(problem_);
  else
    free_drives(problem_);
  obey_locks(problem_);
  for (ConeBody& b : bodies_of(problem_)) b.before = b.v;
}

/// Of a forest of which something else is asked now: as the substep begins, without impulses of other rows.
void ConeGroup::hold_forest_again() {
  for (ConeBody& b : bodies_of(problem_)) b.v = b.unheld;
  obey_locks(problem_);
  for (ConeBody& b : bodies_of(problem_)) b.before = b.v;
  drop_impulses(problem_);
}

/// Velocities with the impulses that contacts start from.   @return the least separation, in tolerable depths
Real ConeGroup::start(Real h) {
  Real least = kInfinity;
  problem_.stood = !is_joined(), rest_.load = 0;
  was_held_ = problem_.stood;
  for (ConeBody& b : bodies_of(problem_)) {
    was_held_ &= b.v.linear() == Vec3::zero() && b.v.angular() == Vec3::zero();
  }
  lead_back(h);
  is_led_ = find_leads();
  take_along(h);
  for (ConeBody& b : bodies_of(problem_)) {
    const Real loaded2 = loaded_speed2(b);
    problem_.stood &= speed2(b, b.v) <= loaded2;
    rest_.load = std::max(rest_.load, std::sqrt(loaded2));
    b.gained = -b.v;
    load(b);
    b.gradient.set_zero();
  }
  if (!rest_.is_first) follow_bodies(), follow_ground(h);
  bend_ways(h);
  problem_.stood &=
      std::ranges::all_of(problem_.contacts, [](const ConeContact& c) { return c.surface == Vec3::zero(); });
  rest_.stood = problem_.stood;
  // Gaps of nanometres are none to what stands: else they would say which corners of a stack bear it.
  const Real closes_anyway = problem_.stood ? kRest * tolerance() : 0;  // m/s
  each([&](ConeContact& contact, std::uint32_t i) {
    const Row& row = c_.rows[i];
    // Of what rolls as it stands: what is noted was measured before it was displaced, or after if others asked. What
    // bounces has its leeway noted there.
    const RowGeometry& g = c_.geometry[i];
    const Real separation = row.rolls && row.restitution == 0 ? separation_of(world_, row, g) : g.separation;
    least = std::min(least, separation / tolerable_depth(world_, c_.geometry[i]));
    contact.friction = row.friction;
    contact.want = std::min(Real(0), closes_anyway - separation / h);
    const TurningPair* const turning_pairs = led_by(i);
    contact.p = contact.start_p = turning_pairs ? lead_of(world_, *turning_pairs, h).taken_on(row.p, row.n, h) : row.p;
    contact.borne = std::max(Real(0), contact.p.dot(contact.n));
    add_impulse<&ConeBody::gradient>(problem_, contact, contact.p);
  });
  if (is_joined()) stiffen(world_, problem_, link_row_, h, Borne::in_substep);
  load_links(world_, problem_, link_row_, LinkPhase::move, h);
  hold_forest(Forest::anew);
  bend_arms(h);
  for (ConeLink& link : problem_.links)  // `gained` is, as yet, minus what the substep before ended with
    if (link.is_spring()) link.p = link.start_p = link.given(-relative<&ConeBody::gained>(problem_.bodies, link));
  for (const ConeLink& link : problem_.links) add_impulse<&ConeBody::gradient>(problem_, link, link.p);
  if (const Real share = share_that_helps(problem_); share < 1) {
    for (ConeContact& contact : problem_.contacts) contact.p *= share, contact.start_p = contact.p;
    for (ConeLink& link : problem_.links) link.p *= share, link.start_p = link.p;
    for (ConeBody& b : bodies_of(problem_)) b.gradient = share * b.gradient;
  }
  respond(problem_);
  for (ConeBody& b : bodies_of(problem_)) {
    b.change = b.step;
    b.start = b.v += b.change;
    b.gained += b.v;
  }
  for (ConeContact& contact : problem_.contacts)
    contact.u = contact.surface + relative<&ConeBody::v>(problem_.bodies, contact);
  measure_links(problem_);
  return least;
}

}  // namespace carom::dynamics

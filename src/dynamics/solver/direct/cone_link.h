// A row of a joint in the direct solver's problem: a velocity that is to lie within bounds, by an impulse within
// bounds.
//
//     u + give p  lies in [low, high];   p > 0 only at low, p < 0 only at high;   |p| <= most.
//
// A lock has low = high; a limit a range; a motor low = high and a bound on p; a spring gives.
#pragma once

#include <algorithm>

#include "dynamics/solver/direct/block_factor.h"

namespace carom::dynamics {

/// What a row acts on beside its two bodies: u += d.v + w.omega.
struct LinkMore {
  static constexpr std::size_t kMost = 2;
  std::uint32_t body[kMost] = {kInvalid, kInvalid};  // of the problem
  Vec3 d[kMost], w[kMost];                           // world
};

/// A row along a Newton step: what bounds its impulse from below and above is linear in the length.
struct LinkLine {
  bool is_straight;      // as of a contact
  Real at_low, at_high;  // N s or N m s, that hold it at either bound, at its start
  Real falls;            // by which both fall over the whole step
};

struct ConeLink {
  std::uint32_t a, b;    // bodies of the problem, or kInvalid
  std::uint32_t beside;  // as of a contact
  bool a_later;
  Vec3 d_a, d_b;   // world; u = d_b.v_b - d_a.v_a + w_b.omega_b - w_a.omega_a
  Vec3 w_a, w_b;   // m or 1; zero where the body does not rotate
  Real low, high;  // m/s or rad/s
  Real give;       // 1/kg or 1/(kg m^2)
  Real most;       // N s or N m s
  Real surface;    // m/s or rad/s, of bodies that impulses do not move
  Real k;          // 1/kg or 1/(kg m^2), u per p
  Real p, u;
  Real start_p, next_p;  // p as the substep began; as the next one begins

  Real traced_p;  // as of a contact

  // of a solve, of a round: as of a contact
  Real best, p0, u0, du;
  LinkLine line;
  Real linear;           // N s or N m s, by whether it is held: p, but for what goes on
  bool goes_on = false;  // holds though u says otherwise: @see Round::go_on()
  bool is_held = false;  // in the factor
  // Of a limit or drive of a joint of the forest: S^T of its row, @see TreeNode; and whose, in ConeProblem::tree.
  bool is_of_child = false;
  Vec6 of_child;
  std::uint32_t child;
  const LinkMore* more = nullptr;  // of a coupling of joints
  Real curve;                      // m/s or rad/s, of a lock: how its arm bends over the substep
  bool bends = false;              // that is asked of it

  /// f(body, d, w) of what it acts on beside A and B.
  template <class F>
  void each_more(F&& f) const {
    if (!more) [[likely]]
      return;
    for (std::size_t i = 0; i < LinkMore::kMost; ++i)
      if (more->body[i] != kInvalid) f(more->body[i], more->d[i], more->w[i]);
  }

  /// Its impulse is whatever holds it: linear.
  bool is_lock() const { return k > 0 && low == high && give == 0 && most == kInfinity; }

  /// Its impulse is told by where it is, and a little by velocity: what it was a substep ago says less.
  bool is_spring() const { return k > 0 && low == high && give > k; }
  /// What a spring gives while bodies have velocities that give `v`, and `surface`.
  Real given(Real v) const { return std::clamp((low - v - surface) / give, -most, most); }

  /// What p becomes at velocity v, in a round of resistance r, where v stays at a bound.
  Real at(Real bound, Real v, Real r, Real from) const { return (r * from - (v - bound)) / (r + give); }
  /// What p becomes at velocity v, in a round of resistance r.
  Real pulled(Real v, Real r, Real from) const { return bounded(at(low, v, r, from), at(high, v, r, from)); }
  /// What p becomes where the bounds ask for so much.
  Real bounded(Real at_low, Real at_high) const {
    return std::clamp(std::max(at_low, Real(0)) + std::min(at_high, Real(0)), -most, most);
  }
  /// Whether p follows v there.
  bool follows(Real v, Real r, Real from) const {
    const Real at_low = r * from - (v - low), at_high = r * from - (v - high);
    return (low == high || at_low > 0 || at_high < 0) && std::fabs(pulled(v, r, from)) < most;
  }
  /// How far it is from the law, m/s or rad/s.
  Real offence() const { return k > 0 ? (k + give) * std::fabs(p - pulled(u, k, p)) : 0; }
};

}  // namespace carom::dynamics

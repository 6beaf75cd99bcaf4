// Contacts of bodies that hang together, as one problem: find impulses in the friction cones and velocities such that
//
//     M (v - v_free) = sum J^T p,    K  contains p,    y = u - want n + mu |u_t| n  lies in the dual of K,    p.y = 0,
//
// Coulomb's law with a least normal velocity `want` [DeSaxce1998]. Without friction the same finds displacements. Rows
// of joints (cone_link.h) are part of it: their cone is a line or a half of one.
#pragma once

#include <span>

#include "core/invalid.h"
#include "dynamics/solver/direct/block_factor.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/cone_link.h"

namespace carom::dynamics {

/// How impulses of a contact change with its velocity: not, alike in all directions, or otherwise.
enum class ConeCurvature : std::uint8_t { none, alike, slope };

/// A contact along a Newton step: z, the impulse before it is projected, is z0 + length z1.
struct ConeLine {
  bool is_straight;    // what it gives is linear in the length, up to the whole step
  Real n0, n1;         // N s, of z along n
  Real t00, t01, t11;  // (N s)^2, squares and product across n
  Real u_n;            // m/s, of du along n
  Real ut0, ut1;       // J, of du and z across n
  Real start;          // J, du . p0
};

struct ConeContact {
  std::uint32_t a, b;    // bodies of the problem, or kInvalid: not moved by impulses
  std::uint32_t beside;  // in BlockFactor::beside: the block that couples a and b; kInvalid where there is none
  bool a_later;          // a is eliminated after b
  bool is_curved;        // a shape is not known to be a polytope: @see ConeGroup::follow_bodies()
  bool is_spread;        // of a patch that slides: its friction acts beside its normal impulses, @see spread()
  Vec3 n;                // unit, world, A to B
  Vec3 r_a, r_b;         // m, world axes: where friction acts; zero where the body does not rotate
  Vec3 n_a, n_b;         // m, moment about there of a unit of normal impulse; set only where it is spread
  Real friction;
  Vec3 surface;        // m/s, of the point on B relative to A where impulses do not change the bodies' velocities
  Real want;           // m/s
  Vec3 start_p;        // N s, p as the substep began
  Vec3 curve;          // m/s, of `surface`: @see ConeGroup::bend_ways()
  Vec3 apart;          // m, the arm of A less that of B, on ground that turns
  Vec3 next_p;         // N s, p as the next one begins
  Real k;              // 1/kg, mean velocity at the point per impulse there
  Real give;           // 1/kg, by which it yields: @see yielding.h
  Real borne;          // N s, along n, in the substep before
  Real most_friction;  // N s, where friction is known: of its impulse
  Vec3 traced_p;       // N s, @see Round::trace()
  Vec3 p;              // N s, on B, world
  Vec3 u;              // m/s, relative velocity with p and all others acting

  // of a solve
  Real slip;                  // m/s, what stands for mu |u_t|
  Real old_slip, old_change;  // m/s, what the last slip but one gave, and how far that was from it
  Vec3 best;                  // N s, of the best solution so far

  // of a round
  Vec3 p0, u0;                                    // as it began
  Vec3 z;                                         // N s, its impulse before it is projected, at u
  Vec3 du;                                        // m/s, of a Newton step
  ConeCurvature curvature = ConeCurvature::none;  // of the factor
  bool goes_on = false;                           // holds as z is, which is beyond its cone: @see Round::go_on()
  Mat3 slope;                                     // kg, of its impulse by -u, where it is neither nought nor alike
  ConeLine line;
};

struct ConeBody {
  std::uint32_t slot;
  Vec3 place;                                   // m, of its centre of mass, set where it is of a forest
  Real mass, inv_mass;                          // kg, 1/kg
  Mat3 held_back;                               // @see held_arms.h
  Mat3 inertia, inv_inertia;                    // kg m^2, 1/(kg m^2), world; identity and zero where it does not rotate
  std::uint8_t locks = 0;                       // @see Scene::locks
  bool turns = false;                           // it rotates
  bool is_taken_along = false;                  // scratch: @see ConeGroup::take_along()
  bool rolls = false;                           // on a point of its own that goes round as on a ball
  bool is_led_back = false, is_led_on = false;  // @see ConeGroup::lead_back()
  Vec3 begun, ended;                            // rad/s, if led back: where the substep begins, and where it ends
  Vec6 v;                                       // m/s, rad/s
  Vec6 unheld;                                  // without any impulse of this substep
  Vec6 before;                                  // with those alone that hold the forest's joints, @see tree.h
  Vec6 start, gained;  // with the impulses that the substep starts from; since the last substep, with them

  Mat3 swing;            // kg m^2, scratch: @see stiffen()
  Vec6 awaited, unlike;  // by loads of a substep, and of those before it: @see ConeGroup::catch_up()

  // of a round
  Vec6 change;    // of v since it began
  Vec6 gradient;  // kg m/s, kg m^2/s
  Vec6 step;
};

/// One system: runs of contacts and of bodies; indices in a contact count from the first body of all systems, as do
/// places of the elimination.
/// Of Newton's method: steps, and block products.
struct NewtonWork {
  std::uint32_t steps = 0;
  std::uint64_t products = 0;
};

struct ConeProblem {
  std::span<ConeContact> contacts;
  ConeBody* bodies;
  std::uint32_t first, last;  // bodies
  const Elimination* elimination;
  const std::uint32_t* nodes;  // bodies by place, where there is a forest
  BlockFactor* factor;
  Vec6* scratch;      // by place
  Real factored = 0;  // softness of the round that the factor is for, with curvatures as they stand; 0: another matrix
  Real locked_softness = 0;     // of the locks in BlockFactor::common(); 0: that is of another solve
  std::span<ConeLink> links{};  // rows of joints that are not of the forest, and of limits and drives
  std::span<ConeLink> locks{};  // of the forest's joints
  std::span<TreeNode> tree{};   // by place; empty where no joint is of a forest
  bool stood = false;           // no body was faster, before this substep, than its loads alone make it
  // Of the last round in which friction was known: what its rows may give kinetic energy, but for drives (J), and whether Newton's
  // method came to its end, so that they give no more.
  Real may_give = -1;  // no such round
  bool is_proven = false;
  NewtonWork taken{}, most{kMostSteps, ~std::uint64_t{0}};
  std::uint32_t least_steps = kAlways;  // that it may take however much work those are

  bool may_go_on() const {
    return taken.steps < least_steps || (taken.steps < most.steps && taken.products < most.products);
  }

  /// The body of a node.
  std::uint32_t body_at(std::uint32_t node) const { return nodes[first + node]; }
  /// Whether a place is to be factored anew.
  bool is_stale(std::uint32_t place) const { return tree.empty() || tree[place - first].is_stale; }
  /// Rows of all joints: `links`, then `locks`.
  std::span<ConeLink> joint_rows() const { return {links.data(), links.size() + locks.size()}; }
};

// ---- small parts that all files of this folder share ----

/// What add_impulse() and relative() leave out where a contact is spread: moments of its normal impulse, and normal
/// velocity by spins.
template <Vec6 ConeBody::*kMomentum>
void add_moments(ConeBody* bodies, const ConeContact& c, Real normal) {
  if (c.a != kInvalid) (bodies[c.a].*kMomentum) -= {Vec3::zero(), normal * c.n_a};
  if (c.b != kInvalid) (bodies[c.b].*kMomentum) += {Vec3::zero(), normal * c.n_b};
}
template <Vec6 ConeBody::*kVelocity>
Vec3 by_moments(const ConeBody* bodies, const ConeContact& c) {
  Real normal = 0;
  if (c.b != kInvalid) normal += (bodies[c.b].*kVelocity).angular().dot(c.n_b);
  if (c.a != kInvalid) normal -= (bodies[c.a].*kVelocity).angular().dot(c.n_a);
  return normal * c.n;
}

/// Impulse p on B and -p on A, as changes of the bodies' momentum.
template <Vec6 ConeBody::*kMomentum>
void add_impulse(const ConeProblem& problem, const ConeContact& c, const Vec3& p) {
  if (c.a != kInvalid) {
    Vec6& m = problem.bodies[c.a].*kMomentum;
    m -= {p, c.r_a.cross(p)};
  }
  if (c.b != kInvalid) {
    Vec6& m = problem.bodies[c.b].*kMomentum;
    m += {p, c.r_b.cross(p)};
  }
  if (c.is_spread) [[unlikely]]
    add_moments<kMomentum>(problem.bodies, c, p.dot(c.n));
}

template <Vec6 ConeBody::*kVelocity>
Vec3 relative(const ConeBody* bodies, const ConeContact& c) {
  Vec3 u = Vec3::zero();
  if (c.b != kInvalid) {
    const Vec6& v = bodies[c.b].*kVelocity;
    u += v.linear() + v.angular().cross(c.r_b);
  }
  if (c.a != kInvalid) {
    const Vec6& v = bodies[c.a].*kVelocity;
    u -= v.linear() + v.angular().cross(c.r_a);
  }
  if (c.is_spread) [[unlikely]]
    u += by_moments<kVelocity>(bodies, c);
  return u;
}

template <Vec6 ConeBody::*kMomentum>
void add_impulse(const ConeProblem& problem, const ConeLink& c, Real p) {
  if (c.a != kInvalid) {
    Vec6& m = problem.bodies[c.a].*kMomentum;
    m -= {p * c.d_a, p * c.w_a};
  }
  if (c.b != kInvalid) {
    Vec6& m = problem.bodies[c.b].*kMomentum;
    m += {p * c.d_b, p * c.w_b};
  }
  c.each_more([&](std::uint32_t body, const Vec3& d, const Vec3& w) {
    problem.bodies[body].*kMomentum += {p * d, p * w};
  });
}

template <Vec6 ConeBody::*kVelocity>
Real relative(const ConeBody* bodies, const ConeLink& c) {
  Real u = 0;
  if (c.b != kInvalid) {
    const Vec6& v = bodies[c.b].*kVelocity;
    u += c.d_b.dot(v.linear()) + c.w_b.dot(v.angular());
  }
  if (c.a != kInvalid) {
    const Vec6& v = bodies[c.a].*kVelocity;
    u -= c.d_a.dot(v.linear()) + c.w_a.dot(v.angular());
  }
  c.each_more([&](std::uint32_t body, const Vec3& d, const Vec3& w) {
    const Vec6& v = bodies[body].*kVelocity;
    u += d.dot(v.linear()) + w.dot(v.angular());
  });
  return u;
}

/// What is locked keeps its velocity, which is 0.
inline void hold(const ConeBody& body, Vec6& v) {
  for (int k = 0; body.locks && k < 6; ++k)
    if (body.locks >> k & 1) v[k] = 0;
}
inline Vec6 velocity_of(const ConeBody& body, const Vec6& momentum) {
  Vec6 v(body.inv_mass * momentum.linear(), body.inv_inertia * momentum.angular());
  hold(body, v);
  return v;
}
/// 1/kg or 1/(kg m^2), of a row's end at a body without locked axes.
inline Real response_of(const ConeBody& body, const Vec3& d, const Vec3& turn) {
  return body.inv_mass * d.squared_norm() + turn.dot(body.inv_inertia * turn);
}
inline Vec6 momentum_of(const ConeBody& body, const Vec6& velocity) {
  return {body.mass * velocity.linear(), body.inertia * velocity.angular()};
}

inline std::span<ConeBody> bodies_of(const ConeProblem& problem) {
  return {problem.bodies + problem.first, problem.last - problem.first};
}
/// m/s, mu |u_t|
inline Real slip_of(const ConeContact& c) {
  return c.friction > 0 ? c.friction * (c.u - c.u.dot(c.n) * c.n).norm() : Real(0);
}

/// Its masses, as a block.
inline void put_masses(const ConeBody& b, Block& to) {
  const Vec3 none = Vec3::zero();
  for (int k = 0; k < 3; ++k) {
    RowOfTwos(Vec3(b.mass * Vec3::unit(k)), none).store(to.x[k]);
    RowOfTwos(none, Vec3(b.inertia(k, 0), b.inertia(k, 1), b.inertia(k, 2))).store(to.x[3 + k]);
  }
}

/// (m/s)^2, of the points of a body that has velocity v, in the mean.
inline Real speed2(const ConeBody& b, const Vec6& v) {
  return v.linear().squared_norm() + b.inertia.trace() * b.inv_mass * v.angular().squared_norm();
}

// ---- what the solver does ----

struct ConeSolution {
  Real residual = 0;                 // m/s, @see residual()
  bool reached = false;              // it is within the tolerance
  bool is_wedged = false;            // no velocity obeys the law: contacts yield
  bool is_rejected = false;          // that would have thrown bodies, or given energy: contacts yield
  bool is_held = false;              // all lies as it lay, for want of a solution
  Real excess_energy = 0;            // J, beyond what the convex problem may give: @see excess_energy()
  std::uint32_t rounds = 0;          // proximal
  std::uint32_t factorisations = 0;  // Newton steps
};

/// ConeBody::gradient: kg m/s and kg m^2/s that all impulses give.
void find_momentum(ConeProblem& problem);
/// Change velocities of bodies by impulses of contacts, and contacts' velocities with them.
void apply_impulses(ConeProblem& problem);

/// Impulses put by, and back to those: bodies and rows move by the difference.
template <Vec3 ConeContact::*kContact, Real ConeLink::*kLink>
void save_impulses(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.*kContact = c.p;
  for (ConeLink& c : problem.links) c.*kLink = c.p;
}
template <Vec3 ConeContact::*kContact, Real ConeLink::*kLink>
void return_to_impulses(ConeProblem& problem) {
  for (ConeContact& c : problem.contacts) c.p = c.*kContact - c.p;
  for (ConeLink& c : problem.links) c.p = c.*kLink - c.p;
  apply_impulses(problem);
  for (ConeContact& c : problem.contacts) c.p = c.*kContact;
  for (ConeLink& c : problem.links) c.p = c.*kLink;
}

/// m/s, of the largest impulse that a contact bears.
Real most_borne(const ConeProblem& problem);
/// The largest offence of all contacts. @return m/s
Real residual(const ConeProblem& problem);
/// Likewise, where friction is bounded by ConeContact::most_friction.
Real residual_of_known_friction(const ConeProblem& problem);

/// Solve from the impulses that act already, until the residual is below a tolerance.
///
/// Proximal rounds on the impulses (p next = P_K(p - y / R) with R a small fraction of k: the solution is exact,
/// however large R, and of many that redundant contacts allow the one near the start is found), each a smooth convex
/// problem in the velocities for Newton's method with an exact line search; mu |u_t| is that of the round's start.
///
/// @param tolerance  m/s; the solution of a solve that is cut short by ConeProblem::most is what it came to
/// @source [DeSaxce1998], [Todorov2014] for the primal view; @oracle tests/oracle/test_direct
ConeSolution solve_cones(ConeProblem& problem, Real tolerance);

}  // namespace carom::dynamics

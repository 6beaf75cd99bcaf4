// A group of bodies that hang together, as one problem: rows, which are contacts, limits, locks, motors, springs
// (cone_row.h), and patches of friction. Find impulses within their bounds and velocities such that
//
//     M (v - v_free) = sum J^T p,    and each row and patch has its law:
//
// a row bears what keeps its velocity within bounds, a patch sticks or bears all that it may against its slip. What a
// patch may bear is Coulomb's law for the loads that its contacts bear. Without friction the same finds displacements.
#pragma once

#include <span>

#include "core/invalid.h"
#include "dynamics/solver/direct/block_factor.h"
#include "dynamics/solver/direct/cone_row.h"
#include "dynamics/solver/direct/coupled_patch.h"

namespace carom::dynamics {

/// How the impulse of a patch changes with its velocity: not, alike in all directions, or otherwise.
enum class PatchCurvature : std::uint8_t { none, sticks, slides };

/// Friction of the contacts of a pair that have one normal, or of one contact: a force in the plane and a twist about the
/// normal, as one vector, @see patch_bound.h
struct ConePatch {
  std::uint32_t a, b, below;  // as of a row
  bool a_later;
  bool is_curved;              // a shape is not known to be a polytope: @see ConeGroup::follow_bodies()
  std::uint32_t first, count;  // its contacts, in ConeProblem::contacts
  Vec3 n;                      // unit, world, A to B
  Vec3 r_a, r_b;               // m, world axes: where its force acts; zero where the body does not rotate
  Vec3 w_a, w_b;               // m, reach times n: moment of a unit along n; zero where the body does not rotate
  Real reach;                  // m
  Real friction;
  Vec3 surface;                // m/s, of B relative to A where impulses do not change the bodies' velocities
  Vec3 curve;                  // m/s, of `surface`: @see ConeGroup::bend_ways()
  Real k;                      // 1/kg, mean velocity per impulse
  Real give;                   // 1/kg, by which it yields: @see yielding.h
  bool is_coupled = false;     // to the loads of its contacts, @see coupled_patch.h
  Real most;                   // N s, that its force may be
  bool slides;                 // as the step began: force and twist are bounded together
  bool bears_all;              // it slides, and starts from known loads and most of its friction, @see bear_all()
  Real old_given, old_change;  // of a solve: N s, the last bound that loads gave, and how far that was from `most`
  Vec3 p;                      // N s, on B, world
  Vec3 u;                      // m/s, with p and all others acting
  Vec3 start_p, next_p, yielding_p, best, p0, u0, du;  // as of a row
  PatchBound bound(Real for_most) const { return {n, for_most, slides}; }
  PatchBound bound() const { return bound(most); }
  PatchCurvature curvature = PatchCurvature::none;  // of the factor
  BoundLine line;                                   // along a Newton step
  PatchCoupling coupling;                           // of the factor, where it slides and is coupled
};

/// Of a contact, beside its row.
struct ContactPlace {
  Vec3 r_a, r_b;        // m, world axes: arms to the point; zero where the body does not rotate
  Vec3 d;               // m, from where the friction of its patch acts
  Vec3 n;               // unit, world, A to B
  Vec3 apart;           // m, the arm of A less that of B, on ground that turns
  Real response;        // 1/kg, mean velocity at the point per impulse there, in any direction
  Real curve;           // m/s, of the row's surface
  Real weight;          // of all of its patch: where friction acts is the mean of its points by weight
  std::uint32_t patch;  // in ConeProblem::patches
  bool is_curved;       // as of a patch
};

struct ConeBody {
  std::uint32_t slot;
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
  Vec6 before;                                  // without any impulse of this substep
  Vec6 start, gained;  // with the impulses that the substep starts from; since the last substep, with them

  Mat3 swing;  // kg m^2, scratch: @see stiffen()

  // of a round
  Vec6 change;    // of v since it began
  Vec6 gradient;  // kg m/s, kg m^2/s
  Vec6 step;
};

/// One system: runs of rows, patches and bodies; indices in a row count from the first body of all systems, as do places
/// of the elimination.
struct ConeProblem {
  std::span<ConeRow> rows;             // contacts, then rows of joints
  std::span<ConeRow> contacts, links;  // of them
  std::span<ConePatch> patches;
  std::span<ContactPlace> places;  // by contact
  ConeBody* bodies;
  std::uint32_t first, last;  // bodies
  const Elimination* elimination;
  BlockFactor* factor;
  Vec6* scratch;      // by place
  Real factored = 0;  // softness of the round that the factor is for, with curvatures as they stand; 0: another matrix
  Real locked_softness = 0;  // of the locks in BlockFactor::common(); 0: that is of another solve
  bool stood = false;        // no body was faster, before this substep, than its loads alone make it
};

// ---- small parts that all files of this folder share ----

/// Impulse p on B and -p on A, as changes of the bodies' momentum.
template <Vec6 ConeBody::*kMomentum>
void add_impulse(const ConeProblem& problem, const ConePatch& c, const Vec3& p) {
  const Real along = p.dot(c.n);
  const Vec3 force = p - along * c.n;
  if (c.a != kInvalid) (problem.bodies[c.a].*kMomentum) -= {force, c.r_a.cross(force) + along * c.w_a};
  if (c.b != kInvalid) (problem.bodies[c.b].*kMomentum) += {force, c.r_b.cross(force) + along * c.w_b};
}

template <Vec6 ConeBody::*kVelocity>
Vec3 relative(const ConeBody* bodies, const ConePatch& c) {
  Vec3 u = Vec3::zero();
  Real twist = 0;
  if (c.b != kInvalid) {
    const Vec6& v = bodies[c.b].*kVelocity;
    u += v.linear() + v.angular().cross(c.r_b), twist += v.angular().dot(c.w_b);
  }
  if (c.a != kInvalid) {
    const Vec6& v = bodies[c.a].*kVelocity;
    u -= v.linear() + v.angular().cross(c.r_a), twist -= v.angular().dot(c.w_a);
  }
  return u + (twist - u.dot(c.n)) * c.n;
}

template <Vec6 ConeBody::*kMomentum>
void add_impulse(const ConeProblem& problem, const ConeRow& c, Real p) {
  if (c.a != kInvalid) {
    Vec6& m = problem.bodies[c.a].*kMomentum;
    m -= {p * c.d_a, p * c.w_a};
  }
  if (c.b != kInvalid) {
    Vec6& m = problem.bodies[c.b].*kMomentum;
    m += {p * c.d_b, p * c.w_b};
  }
}

template <Vec6 ConeBody::*kVelocity>
Real relative(const ConeBody* bodies, const ConeRow& c) {
  Real u = 0;
  if (c.b != kInvalid) {
    const Vec6& v = bodies[c.b].*kVelocity;
    u += c.d_b.dot(v.linear()) + c.w_b.dot(v.angular());
  }
  if (c.a != kInvalid) {
    const Vec6& v = bodies[c.a].*kVelocity;
    u -= c.d_a.dot(v.linear()) + c.w_a.dot(v.angular());
  }
  return u;
}

/// f(row or patch) for all.
template <class F>
void each_part(const ConeProblem& problem, const F& f) {
  for (ConeRow& c : problem.rows) f(c);
  for (ConePatch& c : problem.patches) f(c);
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
inline Vec6 momentum_of(const ConeBody& body, const Vec6& velocity) {
  return {body.mass * velocity.linear(), body.inertia * velocity.angular()};
}

inline std::span<ConeBody> bodies_of(const ConeProblem& problem) {
  return {problem.bodies + problem.first, problem.last - problem.first};
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
  std::uint32_t rounds = 0;          // proximal
  std::uint32_t factorisations = 0;  // Newton steps
};

/// ConeBody::gradient: kg m/s and kg m^2/s that all impulses give.
void find_momentum(ConeProblem& problem);
/// Change velocities of bodies by impulses of contacts, and contacts' velocities with them.
void apply_impulses(ConeProblem& problem);

/// Velocities at rows and patches, from the bodies'.
void measure(ConeProblem& problem);
/// A bound whose square is a number.
inline Real bearable(Real bound) { return bound * bound > 0 ? bound : 0; }
/// What patches may bear, by the loads of their contacts. @param load  load(contact): N s
template <class Load>
void find_bounds(ConeProblem& problem, const Load& load) {
  for (ConePatch& c : problem.patches) {
    Real sum = 0;
    for (const ConeRow& contact : problem.contacts.subspan(c.first, c.count)) sum += load(contact);
    c.most = bearable(c.friction * sum);
  }
}

/// Impulses put by, and back to those: bodies and rows move by the difference.
template <Real ConeRow::*kRow, Vec3 ConePatch::*kPatch>
void save_impulses(ConeProblem& problem) {
  for (ConeRow& c : problem.rows) c.*kRow = c.p;
  for (ConePatch& c : problem.patches) c.*kPatch = c.p;
}
template <Real ConeRow::*kRow, Vec3 ConePatch::*kPatch>
void return_to_impulses(ConeProblem& problem) {
  for (ConeRow& c : problem.rows) c.p = c.*kRow - c.p;
  for (ConePatch& c : problem.patches) c.p = c.*kPatch - c.p;
  apply_impulses(problem);
  for (ConeRow& c : problem.rows) c.p = c.*kRow;
  for (ConePatch& c : problem.patches) c.p = c.*kPatch;
}

/// m/s, of the largest impulse that a contact bears.
Real most_borne(const ConeProblem& problem);
/// The largest offence of all rows, whatever friction does. @return m/s
Real residual_of_rows(const ConeProblem& problem);
/// The largest offence of all rows and patches, of these by the loads that contacts bear. @return m/s
Real residual(const ConeProblem& problem);

/// Solve from the impulses that act already, until the residual is below a tolerance.
///
/// Proximal rounds on the impulses (p next = P(p - y / R) with R a small fraction of k: the solution is exact, however
/// large R, and of many that redundant contacts allow the one near the start is found), each a smooth convex problem in
/// the velocities for Newton's method with an exact line search. What patches may bear is that of the loads of the
/// round before.
///
/// @param tolerance  m/s   @param most_steps  Newton steps in all; the solution of a capped solve is what it came to
/// @source [Todorov2014] for the primal view; @oracle tests/oracle/test_direct
ConeSolution solve_rounds(ConeProblem& problem, Real tolerance, std::uint32_t most_steps);

}  // namespace carom::dynamics

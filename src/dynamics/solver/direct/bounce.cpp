// Impacts one after the other.
#include <Eigen/LU>

#include "dynamics/solver/direct/cone.h"
#include "dynamics/solver/direct/cone_problem.h"

namespace carom {
namespace {

/// Velocity at the point per impulse there.
Mat3 response(const ConeProblem& problem, const ConeContact& c) {
  Mat3 k = Mat3::Zero();
  const auto add = [&](std::uint32_t body, const Vec3& r) {
    if (body == kNobody) return;
    const Mat3 x = cross_matrix(r);
    k += problem.bodies[body].inv_mass * Mat3::Identity() - x * problem.bodies[body].inv_inertia * x;
  };
  add(c.a, c.r_a);
  add(c.b, c.r_b);
  return k;
}

/// The impulse after which a contact parts at a speed, and slips no more or rubs as hard as it can.
Vec3 impact_impulse(const ConeProblem& problem, const ConeContact& c, Real speed) {
  const Mat3 k = response(problem, c);
  const Vec3 slip = c.u - c.u.dot(c.n) * c.n;
  const Real wanted = speed - c.u.dot(c.n), size = slip.norm();
  if (!(c.friction > 0) || !(size > 0)) return wanted / c.n.dot(k * c.n) * c.n;
  const Vec3 stick = k.inverse() * (wanted * c.n - slip);
  if (project_on_cone(stick, c.n, c.friction) == stick) return stick;
  Vec3 ray = c.n - (c.friction / size) * slip;
  // Friction may turn a push into a pull where arms are long; then the normal law alone is solved.
  if (!(c.n.dot(k * ray) > 0.1 * c.n.dot(k * c.n))) ray = c.n;
  return wanted / c.n.dot(k * ray) * ray;
}

/// Bodies a and b changed: tell a contact.
void add_change(const ConeProblem& problem, ConeContact& c, std::uint32_t a, std::uint32_t b) {
  if (c.a != kNobody && (c.a == a || c.a == b)) {
    const Vec6& v = problem.bodies[c.a].change;
    c.u -= linear(v) + angular(v).cross(c.r_a);
  }
  if (c.b != kNobody && (c.b == a || c.b == b)) {
    const Vec6& v = problem.bodies[c.b].change;
    c.u += linear(v) + angular(v).cross(c.r_b);
  }
}

}  // namespace

std::uint32_t bounce(ConeProblem& problem, Real least) {
  const std::size_t most = 100 * problem.contacts.size();
  std::uint32_t count = 0;
  for (; count < most; ++count) {
    ConeContact* worst = nullptr;
    Real fastest = 0;
    for (ConeContact& c : problem.contacts) {
      if (!(c.restitution > 0)) continue;
      const Real speed = -c.u.dot(c.n);
      if (speed > fastest && speed > -c.want && speed - c.force_speed > least) fastest = speed, worst = &c;
    }
    if (!worst) break;
    const Vec3 p = impact_impulse(problem, *worst, worst->restitution * (fastest - worst->force_speed));
    worst->impact += worst->p + p;  // what it bore is not taken back either
    worst->p.setZero();
    const auto push = [&](std::uint32_t i, Vec3 impulse, const Vec3& r) {
      if (i == kNobody) return;
      ConeBody& b = problem.bodies[i];
      Vec6 momentum;
      momentum << impulse, r.cross(impulse);
      b.change = velocity_of(b, momentum);
      b.v += b.change;
    };
    push(worst->a, -p, worst->r_a);
    push(worst->b, p, worst->r_b);
    for (ConeContact& c : problem.contacts) add_change(problem, c, worst->a, worst->b);
  }
  return count;
}

}  // namespace carom

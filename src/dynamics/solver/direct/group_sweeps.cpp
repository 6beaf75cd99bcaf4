// Sweeps over the rows of a group that is too large to be factored, or could not be solved within its work.
#include "dynamics/solver/direct/group_sweeps.h"

#include <algorithm>

#include "dynamics/solver/direct/forest.h"

namespace carom::dynamics {
namespace {

void push(ConeProblem& problem, const ConeContact& c, const Vec3& p) {
  const auto act = [&](std::uint32_t body, const Vec3& r, const Vec3& moment, Real sign) {
    if (body == kInvalid) return;
    ConeBody& b = problem.bodies[body];
    const Vec3 turn = c.is_spread ? Vec3(r.cross(p) + p.dot(c.n) * moment) : r.cross(p);
    b.v += velocity_of(b, {sign * p, sign * turn});
  };
  act(c.a, c.r_a, c.n_a, -1), act(c.b, c.r_b, c.n_b, 1);
}

void push(ConeProblem& problem, const ConeLink& c, Real p) {
  if (c.a != kInvalid) problem.bodies[c.a].v -= velocity_of(problem.bodies[c.a], {p * c.d_a, p * c.w_a});
  if (c.b != kInvalid) problem.bodies[c.b].v += velocity_of(problem.bodies[c.b], {p * c.d_b, p * c.w_b});
  c.each_more([&](std::uint32_t body, const Vec3& d, const Vec3& w) {
    problem.bodies[body].v += velocity_of(problem.bodies[body], {p * d, p * w});
  });
}

/// 1/kg, along the normal; and what no direction exceeds.
struct Responses {
  Real normal = 0, any = 0;
  Responses(const ConeProblem& problem, const ConeContact& c) {
    const auto add = [&](std::uint32_t body, const Vec3& r, const Vec3& moment) {
      if (body == kInvalid) return;
      const ConeBody& b = problem.bodies[body];
      const Vec3 turn = c.is_spread ? Vec3(r.cross(c.n) + moment) : r.cross(c.n);
      normal += b.inv_mass + turn.dot(b.inv_inertia * turn);
      any += b.inv_mass + b.inv_inertia.trace() * r.squared_norm();
    };
    add(c.a, c.r_a, c.n_a), add(c.b, c.r_b, c.n_b);
  }
};

/// 1/kg or 1/(kg m^2)
Real response(const ConeProblem& problem, const ConeLink& c) {
  const auto of = [&](std::uint32_t body, const Vec3& d, const Vec3& w) {
    return body == kInvalid ? 0 : response_of(problem.bodies[body], d, w);
  };
  Real sum = of(c.a, c.d_a, c.w_a) + of(c.b, c.d_b, c.w_b);
  c.each_more([&](std::uint32_t body, const Vec3& d, const Vec3& w) { sum += of(body, d, w); });
  return sum;
}

void visit(ConeProblem& problem, ConeContact& c, Real give_share) {
  const Responses response(problem, c);
  if (!(response.normal > 0)) return;
  const Real give = give_share * response.normal;
  const auto velocity = [&] { return Vec3(c.surface + relative<&ConeBody::v>(problem.bodies, c)); };
  const Real p_n = c.p.dot(c.n);
  const Real next_n = std::max(Real(0), p_n - (velocity().dot(c.n) - c.want + give * p_n) / (response.normal + give));
  push(problem, c, (next_n - p_n) * c.n);
  const Vec3 u = velocity(), p_t = c.p - p_n * c.n;
  Vec3 next_t = p_t - (u - u.dot(c.n) * c.n) / response.any;
  const Real size = next_t.norm(), most = c.friction * next_n;
  if (size > most) next_t *= most / size;
  push(problem, c, next_t - p_t);
  c.p = next_n * c.n + next_t;
}

void visit(ConeProblem& problem, ConeLink& c) {
  if (!(c.k > 0)) return;
  const Real u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
  const Real next = c.pulled(u, c.k, c.p);
  push(problem, c, next - c.p);
  c.p = next;
}

}  // namespace

void sweep(ConeProblem& problem, int times, Real give) {
  for (ConeLink& c : problem.locks) c.k = response(problem, c);
  for (int i = 0; i < times; ++i) {
    for (ConeLink& c : problem.locks) visit(problem, c);
    for (ConeLink& c : problem.links) visit(problem, c);
    for (ConeContact& c : problem.contacts) visit(problem, c, give);
  }
  for (ConeLink& c : problem.locks) c.k = 1;
  obey_locks(problem);
  for (ConeContact& c : problem.contacts) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
  for (ConeLink& c : problem.links) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
}

}  // namespace carom::dynamics

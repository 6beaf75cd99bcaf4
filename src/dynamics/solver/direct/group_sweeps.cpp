// Sweeps over the rows of a group that is too large to be factored, or could not be solved within its work.
#include "dynamics/solver/direct/group_sweeps.h"

#include <algorithm>

#include "dynamics/solver/direct/patch_bound.h"
#include "dynamics/solver/direct/yielding_constants.h"

namespace carom::dynamics {
namespace {

void push(ConeProblem& problem, const ConeRow& c, Real p) {
  if (c.a != kInvalid) problem.bodies[c.a].v -= velocity_of(problem.bodies[c.a], {p * c.d_a, p * c.w_a});
  if (c.b != kInvalid) problem.bodies[c.b].v += velocity_of(problem.bodies[c.b], {p * c.d_b, p * c.w_b});
}
void push(ConeProblem& problem, const ConePatch& c, const Vec3& p) {
  const Real along = p.dot(c.n);
  const Vec3 force = p - along * c.n;
  const auto act = [&](std::uint32_t body, const Vec3& r, const Vec3& w, Real sign) {
    if (body == kInvalid) return;
    ConeBody& b = problem.bodies[body];
    b.v += velocity_of(b, {sign * force, sign * (r.cross(force) + along * w)});
  };
  act(c.a, c.r_a, c.w_a, -1), act(c.b, c.r_b, c.w_b, 1);
}

/// 1/kg, what the response of a patch exceeds in no direction.
Real most_response(const ConeProblem& problem, const ConePatch& c) {
  Real sum = 0;
  const auto add = [&](std::uint32_t body, const Vec3& r, const Vec3& w) {
    if (body == kInvalid) return;
    const ConeBody& b = problem.bodies[body];
    sum += b.inv_mass + b.inv_inertia.trace() * r.squared_norm() + w.dot(b.inv_inertia * w);
  };
  add(c.a, c.r_a, c.w_a), add(c.b, c.r_b, c.w_b);
  return sum;
}

void visit(ConeProblem& problem, ConeRow& c, Real k, Real give) {
  if (!(k > 0)) return;
  const Real u = c.surface + relative<&ConeBody::v>(problem.bodies, c) + give * k * c.p;
  const Real next = c.pulled(u, (1 + give) * k, c.p);
  push(problem, c, next - c.p);
  c.p = next;
}

/// 1/kg, of a contact as bodies are turned by now: that of what is curved is of the step's beginning.
Real response(const ConeProblem& problem, const ConeRow& c) {
  Real sum = 0;
  for (const auto& [body, turn] : {std::pair(c.a, c.w_a), std::pair(c.b, c.w_b)})
    if (body != kInvalid) sum += problem.bodies[body].inv_mass + turn.dot(problem.bodies[body].inv_inertia * turn);
  return sum;
}

void visit(ConeProblem& problem, ConePatch& c) {
  Real load = 0;
  for (ConeRow& row : problem.contacts.subspan(c.first, c.count))
    visit(problem, row, response(problem, row), kGiveOfSweeps), load += row.p;
  if (!(c.friction > 0)) return;
  const Vec3 u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
  const Vec3 next = project_on_bound(c.p - u / most_response(problem, c), c.bound(c.friction * load));
  push(problem, c, next - c.p);
  c.p = next;
}

}  // namespace

void sweep(ConeProblem& problem, int times) {
  for (int i = 0; i < times; ++i) {
    for (ConeRow& c : problem.links) visit(problem, c, c.k, 0);
    for (ConePatch& c : problem.patches) visit(problem, c);
  }
  measure(problem);
}

}  // namespace carom::dynamics

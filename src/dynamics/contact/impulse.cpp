// The impulse that fulfils a contact's law.
#include "dynamics/contact/impulse.h"

#include <algorithm>

namespace carom::dynamics {
namespace {

constexpr int kSlideSweeps = 4;  // per visit

}  // namespace

Vec3 resolved_impulse(const Row& row, const RowMass& m, Real target) {
  const Vec3& n = row.n;
  const Real lacking = target - row.u.dot(n);
  if (!(row.friction > 0)) return std::max(Real(0), row.p_n + lacking / row.k_n) * n;
  const Vec3 stick = row.p + m.k_inv * (target * n - row.u);
  const Real stick_n = stick.dot(n);
  if (stick_n > 0 && (stick - stick_n * n).squared_norm() <= row.friction * row.friction * stick_n * stick_n)
    return stick;

  // Sliding. The direction that would stick is not the one in which the point then slips; but steps of one size in all
  // directions of the plane, cut off at the disc, have Coulomb's law as their fixed point. k_t bounds the plane's
  // largest eigenvalue, so they converge; each visit goes on where the last one stopped.
  const Real k_t = m.k.trace() - row.k_n;
  const Vec3 rub = row.p - row.p.dot(n) * n - (row.u - row.u.dot(n) * n) / k_t;
  const Real size = rub.norm();
  Vec3 ray = n;
  if (size > 0) ray += (row.friction / size) * rub;
  // Friction may turn a push into a pull where r is long and mu large (Painleve); then the normal law alone is solved.
  Real k_ray = n.dot(m.k * ray);
  if (!(k_ray > 0.1 * row.k_n)) ray = n, k_ray = row.k_n;
  Real p_n = std::max(Real(0), (n.dot(m.k * row.p) + lacking) / k_ray);
  Vec3 p = p_n * ray;
  if (p_n == 0) return p;
  Vec3 u = row.u + m.k * (p - row.p);
  for (int sweep = 0; sweep < kSlideSweeps; ++sweep) {
    const Real u_n = u.dot(n);
    const Real next_n = std::max(Real(0), p_n + (target - u_n) / row.k_n);
    Vec3 next_friction = (p - p_n * n) - (u - u_n * n) / k_t;
    const Real bound = row.friction * next_n, norm = next_friction.norm();
    if (norm > bound) next_friction *= bound / norm;
    const Vec3 next = next_n * n + next_friction;
    u += m.k * (next - p);
    p = next, p_n = next_n;
  }
  return p;
}

}  // namespace carom::dynamics

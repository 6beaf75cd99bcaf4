// Mass properties of a body from its colliders and from what the host said.
#include "dynamics/mass.h"

namespace carom::dynamics {
namespace {

/// Inertia of a point mass about the origin: m (|d|^2 1 - d d^T).
Mat3 point_inertia(Real m, const Vec3& d) { return m * (d.squared_norm() * Mat3::identity() - outer(d, d)); }

struct MassSum {
  Real mass = 0;
  Vec3 center = Vec3::zero();
  Mat3 inertia = Mat3::zero();  // about center
};

/// @param by_volume  every density counts as 1
MassSum sum_of_colliders(const Scene& scene, std::uint32_t body, std::uint32_t skip, bool by_volume) {
  const Colliders& c = scene.colliders;
  MassSum sum;
  const auto each = [&](auto&& f) {
    for (std::uint32_t slot = scene.first_collider[body]; slot != kInvalid; slot = c.next[slot])
      if (slot != skip && c.shape[slot]->mass.volume > 0)
        f(slot, (by_volume ? 1 : c.density[slot]) * c.shape[slot]->mass.volume);
  };
  each([&](std::uint32_t slot, Real m) {
    sum.mass += m;
    sum.center += m * c.local[slot].apply(c.shape[slot]->mass.centroid);
  });
  if (!(sum.mass > 0)) return {};
  sum.center /= sum.mass;
  each([&](std::uint32_t slot, Real m) {
    const MassProperties& shape = c.shape[slot]->mass;
    const Mat3 r = c.local[slot].q.matrix();
    sum.inertia += (m / shape.volume) * (r * shape.inertia * r.transpose()) +
                   point_inertia(m, c.local[slot].apply(shape.centroid) - sum.center);
  });
  return sum;
}

bool positive_definite(const Mat3& m) {
  const Real d1 = m(0, 0), d2 = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0), d3 = m.determinant();
  return d1 > 0 && d2 > 0 && d3 > 0 && finite(d3);
}

}  // namespace

BodyMass mass_of_body(const Scene& scene, std::uint32_t body, std::uint32_t skip) {
  const BodySettings& def = scene.def[body];
  BodyMass out;
  if (scene.type[body] != BodyType::dynamic) {
    if (def.has_center) out.center = def.center;
    return out;
  }
  MassSum sum = sum_of_colliders(scene, body, skip, false);
  if (def.has_mass && !(sum.mass > 0)) sum = sum_of_colliders(scene, body, skip, true);
  out.mass = def.has_mass ? def.mass : sum.mass;
  out.center = def.has_center ? def.center : sum.center;
  if (def.has_inertia)
    out.inertia = def.inertia;
  else if (sum.mass > 0)
    out.inertia = sum.inertia * (out.mass / sum.mass);
  if (!(out.mass >= kLeastMass)) {
    out.mass = 1;
    out.inertia.set_zero();
  }
  out.inv_mass = 1 / out.mass;
  if (positive_definite(out.inertia)) out.inv_inertia = out.inertia.inverse();
  if (!(out.inv_inertia(0, 0) > 0) || !out.inv_inertia.all_finite()) {
    out.inertia.set_zero();
    out.inv_inertia.set_zero();
  }
  return out;
}

}  // namespace carom::dynamics

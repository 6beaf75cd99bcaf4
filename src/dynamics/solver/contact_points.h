// Points of one pair side by side: where they are, how they move. Part of contact_sweeps.h; all that stands here is
// local to the file that includes it.
#pragma once

#include "dynamics/solver/contact_layout.h"

namespace carom::dynamics {
namespace {

/// The same vector, the same matrix in each lane.
CAROM_LANES_INLINE LaneVec vector_in_all(const double* v) { return {all(v[0]), all(v[1]), all(v[2])}; }
struct MatrixInAll {
  LaneVec column[3];

  CAROM_LANES_INLINE explicit MatrixInAll(const double* m)
      : column{vector_in_all(m), vector_in_all(m + 3), vector_in_all(m + 6)} {}
  CAROM_LANES_INLINE LaneVec operator*(const LaneVec& a) const {
    return a.x * column[0] + (a.y * column[1] + a.z * column[2]);
  }
  CAROM_LANES_INLINE Lanes trace() const { return column[0].x + column[1].y + column[2].z; }
};

/// @see Arms
struct LaneArms {
  LaneVec a, b;

  CAROM_LANES_INLINE LaneArms(const PointSources& of, const LaneVec& n, const LaneVec& l_a, const LaneVec& l_b) {
    const Lanes radius_a = all(of.geometry[0][kGeometryRadiusA]), radius_b = all(of.geometry[0][kGeometryRadiusB]);
    const LaneVec apart = vector_in_all(of.x_b) - vector_in_all(of.x_a);
    const LaneVec on_a = MatrixInAll(of.rotation_a) * l_a + radius_a * n,
                  on_b = apart + (MatrixInAll(of.rotation_b) * l_b - radius_b * n);
    a = on_a + all(of.to_b) * (on_b - on_a);
    b = a - apart;
  }
};

/// 1/kg, of one body: the mean of the eigenvalues of what an impulse does to the velocity at its point, and what one
/// along the normal does to the velocity along it.
CAROM_LANES_INLINE Lanes mean_response(const LaneVec& r, double inv_mass, const MatrixInAll& inv_inertia) {
  return all(inv_mass) + (inner(r, r) * inv_inertia.trace() - inner(r, inv_inertia * r)) / 3;  // trace(-[r]x W [r]x)
}
CAROM_LANES_INLINE Lanes response_along(const LaneVec& n, const LaneVec& r, double inv_mass,
                                        const MatrixInAll& inv_inertia) {
  const LaneVec moment = cross(r, n);
  return all(inv_mass) + inner(moment, inv_inertia * moment);
}

void place_points(const PointSources* sources, std::size_t pairs, PointPlaces* places) {
  for (std::size_t i = 0; i < pairs; ++i) {
    const PointSources& of = sources[i];
    PointPlaces& to = places[i];
    const LaneVec n = vector_at(of.row, kRowNormal), l_a = vector_at(of.geometry, kGeometryA),
                  l_b = vector_at(of.geometry, kGeometryB);
    const LaneArms arms(of, n, l_a, l_b);
    to.r_a = arms.a + MatrixInAll(of.held_a) * l_a;
    to.r_b = arms.b + MatrixInAll(of.held_b) * l_b;
    to.response = mean_response(to.r_a, of.inv_mass_a, MatrixInAll(of.inv_inertia_a)) +
                  mean_response(to.r_b, of.inv_mass_b, MatrixInAll(of.inv_inertia_b));
  }
}

void watch_points(const PointSources* sources, std::size_t pairs, PointMotions* motions) {
  for (std::size_t i = 0; i < pairs; ++i) {
    const PointSources& of = sources[i];
    PointMotions& to = motions[i];
    const LaneVec n = vector_at(of.row, kRowNormal);
    const LaneArms arms(of, n, vector_at(of.geometry, kGeometryA), vector_at(of.geometry, kGeometryB));
    const LaneVec u = vector_in_all(of.v_b) + cross(vector_in_all(of.omega_b), arms.b) - vector_in_all(of.v_a) -
                      cross(vector_in_all(of.omega_a), arms.a) + vector_at(of.surface, 0);
    to.closing = -inner(u, n);
    to.response = response_along(n, arms.a, of.inv_mass_a, MatrixInAll(of.inv_inertia_a)) +
                  response_along(n, arms.b, of.inv_mass_b, MatrixInAll(of.inv_inertia_b));
    to.p_n = inner(vector_at(of.row, kRowImpulse), n);
  }
}

}  // namespace
}  // namespace carom::dynamics

// How the friction of a patch is shared among its points, and added up again.
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// By their loads, turned about the point at which those act together, as those of lanes. A twist that those can't bear, as
/// where all loads are at one corner, is shared by weights. Added up again it is what it was.
template <Real ConeRow::*kLoad>
class FrictionShares {
 public:
  FrictionShares(const ConeProblem& problem, const ConePatch& patch, const Vec3& p) : n_(patch.n) {
    const Real along = p.dot(n_);
    force_ = p - along * n_;
    const std::span<const ConeRow> contacts = problem.contacts.subspan(patch.first, patch.count);
    const std::span<const ContactPlace> places = problem.places.subspan(patch.first, patch.count);
    for (const ConeRow& row : contacts) whole_ += row.*kLoad;
    Real twist = patch.reach * along;
    if (patch.count == 1 || !(patch.reach > 0)) return;
    Real moment = 0, even = 0;  // m^2, of loads and of weights
    for (std::uint32_t k = 0; k < patch.count; ++k) even += places[k].weight * places[k].d.squared_norm();
    if (whole_ > 0) {
      for (std::uint32_t k = 0; k < patch.count; ++k) centre_ += (contacts[k].*kLoad / whole_) * places[k].d;
      for (std::uint32_t k = 0; k < patch.count; ++k)
        moment += (contacts[k].*kLoad / whole_) * n_.cross(places[k].d - centre_).squared_norm();
      twist -= centre_.cross(force_).dot(n_);
    }
    (moment > kLittle * even ? turn_ : even_turn_) = twist / (moment > kLittle * even ? moment : even);
  }
  /// N s, friction at a point.
  Vec3 at(const ContactPlace& place, Real load) const {
    const Vec3 by_load = whole_ > 0 ? Vec3((load / whole_) * (force_ + turn_ * n_.cross(place.d - centre_)))
                                    : Vec3(place.weight * force_);
    return by_load + (place.weight * even_turn_) * n_.cross(place.d);
  }

 private:
  static constexpr Real kLittle = 1e-6;
  Vec3 n_, force_, centre_ = Vec3::zero();
  Real whole_ = 0, turn_ = 0, even_turn_ = 0;
};

/// Add a point's friction to its patch's.   @param sideways  N s, across the normal
inline void add_friction(ConePatch& patch, const ContactPlace& place, const Vec3& sideways) {
  patch.p += sideways;
  if (patch.reach > 0) patch.p += (place.d.cross(sideways).dot(patch.n) / patch.reach) * patch.n;
}

/// Let a patch that slides bear all that it may by what its contacts bear: what loads have changed by since would else be
/// left out of it until it is solved for.
inline void bear_all(const ConeProblem& problem, ConePatch& patch) {
  Real load = 0;
  for (const ConeRow& row : problem.contacts.subspan(patch.first, patch.count)) load += row.p;
  const Real now = gauge_of_bound(patch.p, patch.n, patch.slides);
  if (now > 0) patch.p *= patch.friction * load / now;
}

/// m/s, of B relative to A at a contact.
inline Vec3 velocity_at(const ConeProblem& problem, std::size_t contact) {
  const ContactPlace& place = problem.places[contact];
  const ConePatch& patch = problem.patches[place.patch];
  const Real twist = patch.u.dot(patch.n);
  Vec3 u = patch.u - twist * patch.n;
  if (patch.reach > 0) u += (twist / patch.reach) * patch.n.cross(place.d);
  return u + problem.contacts[contact].u * place.n;
}

}  // namespace carom::dynamics

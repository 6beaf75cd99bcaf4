// Seams of flush colliders: which contacts of a body are ghosts, for its other contacts bear it there.
//
// The ground of a body is the union of all colliders that stand still against each other: what is static or sleeps, the
// parts of one body, kinematic bodies that move alike. Of a body's contacts with two of them one may be a ghost
// (collision/scenery/seam.h): it is left out before rows are made. A body that touches one collider of a ground costs
// nothing, one whose contacts with a ground look the same way a comparison.
#pragma once

#include <span>

#include "collision/scenery/seam.h"
#include "dynamics/contact/contact.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

// rad^2: normals within this look the same way.
inline constexpr Real kSameWay2 = 1e-12;

/// Stage function: leave out contacts that are ghosts.
void leave_out_ghosts(const World& world, PairTable& pairs, const StepTime& time);

/// Contacts of a collider with the ground that another one is part of, as of this step.
std::span<const GroundContact> contacts_with_ground(const World& world, std::uint32_t collider, std::uint32_t ground);

/// Which colliders stand still against each other: equal of two that may. Of driven ones moves_alike() knows;
/// kNoGround: a ground with no body.
std::uint32_t ground_of(const World& world, std::uint32_t collider);
inline constexpr std::uint32_t kStillGround = kInvalid, kDrivenGround = kInvalid - 1, kNoGround = kInvalid - 2;

/// Whether two colliders of one ground move alike at a place, for as long as a step.
bool moves_alike(const World& world, std::uint32_t a, std::uint32_t b, const Vec3& place, Real flush, Real dt);

/// How seams of a collider's shape with another one are looked at.
SeamTerms seam_terms(const Dials& dials, const Shape& body, const Shape& ground);

}  // namespace carom::dynamics

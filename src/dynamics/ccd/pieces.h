// What a collider is swept as: convex pieces. The one place that knows what a collider is made of.
#pragma once

#include "dynamics/world.h"

namespace carom {

/// A convex part of a collider.
struct Piece {
  const Shape* shape = nullptr;
  Pose local;  // shape -> body axes, about the centre of mass
};

/// Call f(piece) for the convex pieces of a collider that may lie within a box.
/// @param box  m, world, where the collider's body stands; what lies outside it may be left out
template <class F>
void each_piece(const World& world, std::uint32_t collider, const Aabb& box, F&& f) {
  const Colliders& c = world.scene.colliders;
  static_cast<void>(box);  // a collider is one convex shape
  const Pose& local = c.local[collider];
  f(Piece{c.shape[collider], {local.q, local.p - world.scene.center[c.body[collider]]}});
}

}  // namespace carom

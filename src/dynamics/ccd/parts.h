// What a collider is swept as: its shape. Scenery is swept against as a whole, and finds the triangles on the way by
// itself (collision/scenery/ask.h).
#pragma once

#include "dynamics/world.h"

namespace carom::dynamics {

/// A shape of a collider.
struct SweptPart {
  const Shape* shape = nullptr;
  Pose local;  // shape -> body axes, about the centre of mass
};

/// Call f(shape) for the shapes of a collider that may lie within a box.
/// @param box  m, world, where the collider's body stands; what lies outside it may be left out
template <class F>
void each_swept_part(const World& world, std::uint32_t collider, const Aabb& box, F&& f) {
  const Colliders& c = world.scene.colliders;
  static_cast<void>(box);  // a collider is one shape
  const Pose& local = c.local[collider];
  f(SweptPart{c.shape[collider], {local.q, local.p - world.scene.center[c.body[collider]]}});
}

}  // namespace carom::dynamics

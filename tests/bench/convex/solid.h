// Solids for libraries out of Carom's shapes.
#pragma once

#include "collision/shape.h"
#include "core/pose.h"
#include "peer.h"

namespace carom::bench {

/// A shape and what other libraries need to know of it. Stays where it is: the solid points into it.
struct OwnedSolid {
  explicit OwnedSolid(Shape made);
  OwnedSolid(const OwnedSolid&) = delete;
  OwnedSolid& operator=(const OwnedSolid&) = delete;

  Shape shape;
  Solid solid;
};

Placement placement(const Frame& frame);
Frame frame_of(const Placement& at);

}  // namespace carom::bench

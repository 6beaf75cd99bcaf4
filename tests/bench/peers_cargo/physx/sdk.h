// What both files of this module take from PhysX.
#pragma once

#include <PxPhysicsAPI.h>

#include <cstddef>

namespace carom::bench {

/// Set up with the first call.
physx::PxPhysics& physx_sdk();

/// A hull of points; the caller releases it.   @param xyz  m, 3 count numbers
physx::PxConvexMesh* make_physx_hull(const double* xyz, std::size_t count);

}  // namespace carom::bench

// FCL's own shapes and poses of the solids under test.
#pragma once

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>

#include <map>

#include "peer.h"

namespace carom::bench {

using Transform = fcl::Transform3<double>;
using V = fcl::Vector3<double>;

/// @param use  called with a shared_ptr to the shape, of its own type. @return what it returns
template <class Use>
auto with_native(const Solid& solid, const Use& use) {
  const double* const h = solid.half;
  const double r = solid.radius, height = 2 * solid.half_height;
  switch (solid.kind) {
    case Kind::sphere:
      return use(std::make_shared<fcl::Sphere<double>>(r));
    case Kind::box:
      return use(std::make_shared<fcl::Box<double>>(2 * h[0], 2 * h[1], 2 * h[2]));
    case Kind::capsule:
      return use(std::make_shared<fcl::Capsule<double>>(r, height));
    case Kind::cylinder:
      return use(std::make_shared<fcl::Cylinder<double>>(r, height));
    case Kind::cone:
      return use(std::make_shared<fcl::Cone<double>>(r, height));
    case Kind::ellipsoid:
      return use(std::make_shared<fcl::Ellipsoid<double>>(h[0], h[1], h[2]));
    case Kind::hull:
      break;
  }
  // Vertices inside the hull and repeated ones have no edge: FCL walks edges, so it is not shown them.
  const auto points = std::make_shared<std::vector<V>>();
  const auto faces = std::make_shared<std::vector<int>>();
  if (solid.triangles.empty())
    for (std::size_t i = 0; i < solid.vertices; ++i) points->emplace_back(&solid.xyz[3 * i]);
  std::map<std::uint32_t, int> renumbered;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const std::uint32_t v = solid.triangles[t];
    const auto [at, fresh] = renumbered.emplace(v, static_cast<int>(points->size()));
    if (fresh) points->emplace_back(&solid.xyz[3 * v]);
    if (t % 3 == 0) faces->push_back(3);
    faces->push_back(at->second);
  }
  return use(std::make_shared<fcl::Convex<double>>(points, static_cast<int>(solid.triangles.size() / 3), faces));
}

inline Transform pose(const Solid& solid, const Placement& at) {
  const Placement turned = z_up(solid, at);
  Transform t = Transform::Identity();
  t.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(turned.r);
  t.translation() = V(turned.p);
  return t;
}

}  // namespace carom::bench

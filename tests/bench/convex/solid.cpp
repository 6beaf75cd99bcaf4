// Facets of a hull, and which vertex neighbours which on it.
#include "solid.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision/hull.h"

namespace carom::bench {

namespace {

Kind kind_of(Form form) {
  switch (form) {
    case Form::sphere:
      return Kind::sphere;
    case Form::capsule:
      return Kind::capsule;
    case Form::box:
      return Kind::box;
    case Form::polytope:
      return Kind::hull;
    case Form::cylinder:
      return Kind::cylinder;
    case Form::cone:
      return Kind::cone;
    case Form::ellipsoid:
      return Kind::ellipsoid;
    default:
      throw std::runtime_error("a shape that other libraries do not have");
  }
}

void build_graph(Solid& solid) {
  Array<std::uint32_t> found(std::pmr::get_default_resource());
  if (!convex_hull({solid.xyz, 3 * solid.vertices}, found)) return;
  solid.triangles.assign(found.begin(), found.end());
  solid.start = solid.triangles[0];
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < found.size(); t += 3)
    for (std::size_t i = 0; i < 3; ++i) edges.emplace(found[t + i], found[t + (i + 1) % 3]);
  solid.first.assign(solid.vertices + 1, 0);
  for (const auto& [from, to] : edges) {
    ++solid.first[from + 1];
    solid.neighbour.push_back(to);  // the set is in order of `from`
  }
  for (std::size_t v = 1; v < solid.first.size(); ++v) solid.first[v] += solid.first[v - 1];
}

}  // namespace

OwnedSolid::OwnedSolid(Shape made) : shape(std::move(made)) {
  solid.kind = kind_of(shape.form);
  solid.radius = shape.radius;
  solid.half_height = shape.half_height;
  const Vec3 middle = 0.5 * (shape.bounds.lo + shape.bounds.hi);
  for (int i = 0; i < 3; ++i) solid.half[i] = shape.half[i], solid.middle[i] = middle[i];
  solid.core_radius = shape.core_radius;
  solid.scan = shape.support;
  solid.params = shape.params.data();
  solid.param_count = shape.params.size();
  solid.shape = &shape;
  solid.xyz = shape.vertices.data();
  solid.vertices = shape.vertices.size() / 3;
  if (solid.kind == Kind::hull) build_graph(solid);
}

Placement placement(const Frame& frame) {
  Placement at;
  for (int i = 0; i < 3; ++i) {
    at.p[i] = frame.p[i];
    for (int k = 0; k < 3; ++k) at.r[3 * i + k] = frame.r(i, k);
  }
  return at;
}

Frame frame_of(const Placement& at) { return Frame(Mat3::from_rows(at.r), Vec3::from(at.p)); }

}  // namespace carom::bench

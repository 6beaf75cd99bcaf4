// Triangles for the eye from any shape, by its support function.
#include "visual/tessellate.h"

#include <cmath>
#include <map>

namespace carom::tools {

namespace {

/// Triangles of scenery, whose corners are one where they are at the same place.
Mesh triangles_of(Engine& engine, carom_shape shape) {
  std::uint64_t count = 0, next = 0;
  Call call;
  call.done(carom_shape_get_triangles(engine.get(), shape, 0, nullptr, &count, &next, call), "counting triangles");
  std::vector<double> corners(9 * count);
  call.done(carom_shape_get_triangles(engine.get(), shape, 0, corners.data(), &count, &next, call),
            "reading triangles");
  Mesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> known;
  for (std::uint64_t t = 0; t < count; ++t) {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double* const x = &corners[9 * t + 3 * k];
      const auto [at, fresh] = known.try_emplace({x[0], x[1], x[2]}, static_cast<std::uint32_t>(mesh.points.size()));
      if (fresh) mesh.points.emplace_back(x[0], x[1], x[2]);
      face[k] = at->second;
    }
    mesh.faces.push_back(face);
  }
  return mesh;
}

}  // namespace

Mesh tessellate(Engine& engine, const Part& part) {
  if (part.shape == "half_space")
    throw Error("a half-space has no mesh: it is unbounded", "draw a floor of finite size instead");
  if (part.shape == "height_field") return triangles_of(engine, engine.height_field(part.params));
  if (part.shape == "mesh") return triangles_of(engine, engine.mesh(part.params));
  const carom_shape shape = engine.shape(part.shape, part.params);
  if (engine.info(shape).form == CAROM_FORM_POLYTOPE) {
    const bool composed = part.shape == "hull_of";
    const std::uint32_t first = composed ? 0 : engine.describe(engine.plugin(part.shape)).geometry->form_arg[0];
    const std::vector<double> numbers = composed ? engine.params(shape) : part.params;
    std::vector<Vec> corners;
    for (std::size_t i = first; i + 2 < numbers.size(); i += 3)
      corners.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return convex_hull(corners);
  }
  constexpr int kMeridians = 24, kBands = 12;
  constexpr double kPi = 3.14159265358979323846;
  std::vector<double> directions = {0, 1, 0, 0, -1, 0};
  for (int band = 1; band < kBands; ++band)
    for (int m = 0; m < kMeridians; ++m) {
      // Half a step off the axes: a box's corners support, and no direction ties along a face.
      const double polar = kPi * band / kBands, turn = 2 * kPi * (m + 0.5) / kMeridians;
      directions.insert(directions.end(),
                        {std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn)});
    }
  std::vector<double> support(directions.size());
  Call call;
  call.done(carom_shape_support(engine.get(), shape, directions.data(), directions.size() / 3, support.data(), call),
            "drawing a " + part.shape);
  std::vector<Vec> points;
  for (std::size_t i = 0; i < support.size(); i += 3) points.emplace_back(support[i], support[i + 1], support[i + 2]);
  return convex_hull(points);
}

ShadedMesh shade(const Mesh& mesh, double crease_cosine) {
  std::vector<Vec> flat;  // face normals, not unit: length is twice the area
  std::vector<std::vector<std::uint32_t>> around(mesh.points.size());  // faces at each point
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    flat.emplace_back((mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]));
    if (flat.back().norm() > 0)
      for (std::uint32_t corner : mesh.faces[f]) around[corner].push_back(static_cast<std::uint32_t>(f));
  }
  ShadedMesh shaded;
  std::vector<std::vector<std::uint32_t>> made(mesh.points.size());  // vertices already made of each point
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!(flat[f].norm() > 0)) continue;
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t point = mesh.faces[f][k];
      Vec sum = Vec::Zero();
      for (std::uint32_t other : around[point])
        if (flat[other].dot(flat[f]) >= crease_cosine * flat[other].norm() * flat[f].norm()) sum += flat[other];
      const Eigen::Vector3f normal = (sum.norm() > 0 ? sum : flat[f]).normalized().cast<float>().normalized();
      std::uint32_t id = UINT32_MAX;
      for (std::uint32_t candidate : made[point])
        if (shaded.normals[candidate].dot(normal) > 0.9999f) id = candidate;
      if (id == UINT32_MAX) {
        id = static_cast<std::uint32_t>(shaded.points.size());
        shaded.points.push_back(mesh.points[point].cast<float>());
        shaded.normals.push_back(normal);
        made[point].push_back(id);
      }
      face[k] = id;
    }
    shaded.faces.push_back(face);
  }
  return shaded;
}

}  // namespace carom::tools

// Meshes as colliders: scenery where they stay, their hull where they are convex, several convex parts where they move.
#include <cmath>
#include <cstdio>

#include "mesh/parts.h"
#include "mesh/solid.h"
#include "scenefile/reader.h"

namespace carom::tools::scenefile {
namespace {

constexpr std::size_t kHullVertices = 256;
// Of a mesh; of a file. Taking one apart takes up to half a second, and a file of strangers may take two in all.
constexpr std::size_t kMostParts = 8, kMostMeshes = 2;
constexpr double kGridBytes =
    64.0 * 64 * 64 * 16;  // more than a grid of 32 cells along its length, and what is cut of it

/// Whether a hull is the mesh: it holds no more.
bool is_convex(const Mesh& mesh, const Mesh& hull) { return std::fabs(volume_of(mesh)) >= 0.995 * volume_of(hull); }

double length_of(const Mesh& mesh) {
  Vec low = mesh.points[0], high = low;
  for (const Vec& p : mesh.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).maxCoeff();
}

}  // namespace

/// The triangles of a node and those below it, in its own frame.
Mesh Reader::mesh_of(const Value& geometry, const Vec& scale) {
  const Value which = geometry["node"];
  Mesh all;
  const auto add = [&](const auto& self, std::size_t i, const Place& place, std::size_t depth) -> void {
    if (depth > 64) which.fail("has meshes nested too deep", "flatten the node");
    if (const auto mesh = node(i).get("mesh")) {
      const Mesh own_mesh = doc_.mesh(mesh->index(doc_.count("meshes"), "meshes"));
      doc_.budget().charge(own_mesh.points.size() + own_mesh.faces.size(), 4 * sizeof(Vec),
                           doc_.path() + ": " + which.place());
      const auto first = static_cast<std::uint32_t>(all.points.size());
      for (const Vec& x : own_mesh.points)
        all.points.push_back(scale.cwiseProduct(place.p + place.q * Vec(place.s.cwiseProduct(x))));
      for (auto face : own_mesh.faces) {
        for (std::uint32_t& corner : face) corner += first;
        all.faces.push_back(face);
      }
    }
    if (const auto children = node(i).get("children"))
      for (std::size_t k = 0; k < children->size(); ++k) {
        const std::size_t child = children->at(k).index(nodes_.size(), "nodes");
        if (!colliders_of(node(child)).empty()) continue;  // what a child collides with is its own
        self(self, child, nodes_[child].local.in(place), depth + 1);
      }
  };
  add(add, which.index(nodes_.size(), "nodes"), Place(), 0);
  return all;
}

void Reader::collide_as(Mesh all, const Value& at, bool convex, bool moves, Part& part, Hulls& hulls) {
  if (all.points.size() < 3 || all.faces.empty()) at.fail("has no triangles", "name a mesh of triangles");
  if (convex || moves) {
    Mesh hull = convex_hull(all.points);
    part.shape = "hull";
    if (convex || is_convex(all, hull) || !take_into_hulls(all, at, hulls)) {
      if (hull.points.size() > kHullVertices) hull = reduce_hull(hull, kHullVertices).hull;
      hulls = {hull_params(hull)};
    }
    part.params = hulls[0];
    if (hulls.size() > 1) return;  // each part looks as it collides
  } else {
    part.shape = "mesh";
    part.params = {0, static_cast<double>(all.points.size())};
    for (const Vec& x : all.points) part.params.insert(part.params.end(), {x.x(), x.y(), x.z()});
    for (const auto& face : all.faces)
      for (const std::uint32_t corner : face) part.params.push_back(corner);
  }
  part.mesh = static_cast<int>(stage_.meshes.size());
  stage_.meshes.push_back(std::move(all));
}

/// @return false: the mesh is to collide as its hull, and that is said
bool Reader::take_into_hulls(const Mesh& mesh, const Value& at, Hulls& hulls) {
  for (const auto& [before, same] : taken_apart_)
    if (before.points == mesh.points && before.faces == mesh.faces) return hulls = same, !same.empty();
  const auto as_hull = [&](const std::string& why) {
    note(at.place() + ": a mesh that moves collides as its hull: " + why);
    if (taken_apart_.size() < kMostMeshes) taken_apart_.emplace_back(mesh, Hulls());
    return false;
  };
  if (taken_apart_.size() >= kMostMeshes)
    return as_hull("more than " + std::to_string(kMostMeshes) + " are not taken apart");
  doc_.budget().charge(1, static_cast<std::uint64_t>(kGridBytes),
                       doc_.path() + ": " + at.place() + ", taking it apart");
  PartsWanted wanted;
  wanted.most = kMostParts;
  wanted.concavity = length_of(mesh) / 10;
  Parts parts;
  try {
    parts = take_apart(mesh, wanted);
  } catch (const Error& e) {
    return as_hull(e.what());
  }
  for (const Mesh& hull : parts.hulls) hulls.push_back(hull_params(hull));
  char text[120];
  std::snprintf(text, sizeof text,
                ": a mesh that moves collides as %zu convex parts that stand out of it by %.2g m at most",
                parts.hulls.size(), parts.outside);
  note(at.place() + text);
  taken_apart_.emplace_back(mesh, hulls);
  return true;
}

}  // namespace carom::tools::scenefile

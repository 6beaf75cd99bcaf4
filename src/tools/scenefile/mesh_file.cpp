// `carom import` of glTF: its triangles in, a body of convex parts out.
#include <set>

#include "scenefile/reader.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace scenefile {
namespace {

/// Triangles are added where they stand. What mirrors them turns them, so that they still look outwards.
void add_mesh(Document& doc, std::size_t index, const Place& place, Mesh& all) {
  const Mesh mesh = doc.mesh(index);
  doc.budget().charge(mesh.points.size() + mesh.faces.size(), 2 * sizeof(Vec),
                      doc.path() + ": /meshes/" + std::to_string(index));
  const auto first = static_cast<std::uint32_t>(all.points.size());
  for (const Vec& x : mesh.points) all.points.push_back(place.p + place.q * Vec(place.s.cwiseProduct(x)));
  const bool mirrored = place.s.prod() < 0;
  for (auto face : mesh.faces) {
    if (mirrored) std::swap(face[1], face[2]);
    for (std::uint32_t& corner : face) corner += first;
    all.faces.push_back(face);
  }
}

/// Those of a node and below it. A node is seen once, whatever the file says.
void add_node(Document& doc, const Value& which, const Place& parent, std::size_t depth, std::set<std::size_t>& seen,
              Mesh& all) {
  constexpr std::size_t kDeepest = 1000;
  if (depth > kDeepest) which.fail("is nested too deep", "make nodes a tree");
  const std::size_t i = which.index(doc.count("nodes"), "nodes");
  if (!seen.insert(i).second) which.fail("has two parents, or is among its own children", "make nodes a tree");
  const Value node = doc.section("nodes", i);
  const Place place = place_of(node).in(parent);
  if (const auto mesh = node.get("mesh")) add_mesh(doc, mesh->index(doc.count("meshes"), "meshes"), place, all);
  const auto children = node.get("children");
  for (std::size_t k = 0; children && k < children->size(); ++k)
    add_node(doc, children->at(k), place, depth + 1, seen, all);
}

std::size_t index_of_mesh(const Document& doc, const std::string& which) {
  const std::size_t count = doc.count("meshes");
  std::string names;
  for (std::size_t i = 0; i < count; ++i) {
    const auto name = doc.section("meshes", i).get("name");
    if (which == std::to_string(i) || (name && name->text() == which)) return i;
    if (names.size() < 300)
      names += (i ? ", " : "") + std::to_string(i) + (name ? " (" + name->text().substr(0, 60) + ")" : "");
  }
  throw Error(doc.path() + " has no mesh '" + which + "'", count ? "name one of: " + names : "it has none at all");
}

}  // namespace
}  // namespace scenefile

Mesh mesh_of_gltf(const std::string& path, const std::string& which) {
  using namespace scenefile;
  Document doc(path);
  Mesh all;
  if (!which.empty()) {
    add_mesh(doc, index_of_mesh(doc, which), Place(), all);
  } else if (doc.count("scenes") == 0) {
    for (std::size_t i = 0; i < doc.count("meshes"); ++i) add_mesh(doc, i, Place(), all);
  } else {
    const auto chosen = doc.root().get("scene");
    const Value scene = doc.section("scenes", chosen ? chosen->index(doc.count("scenes"), "scenes") : 0);
    std::set<std::size_t> seen;
    const auto roots = scene.get("nodes");
    for (std::size_t k = 0; roots && k < roots->size(); ++k) add_node(doc, roots->at(k), Place(), 0, seen, all);
  }
  if (all.faces.empty())
    throw Error(path + " has no triangles" + (which.empty() ? " in its scene" : " in mesh '" + which + "'"),
                "give a file with meshes, or name one: --mesh NAME");
  return all;
}

void write_parts_scene(const std::string& path, const std::string& name, const std::vector<Mesh>& hulls, Stage& stage) {
  Actor actor;
  actor.name = name, actor.kind = "body";
  for (const Mesh& hull : hulls) {
    Part part;
    part.shape = "hull", part.params = hull_params(hull);
    actor.parts.push_back(std::move(part));
  }
  stage.add(std::move(actor));
  stage.bounds_min = Vec::Constant(-1e9), stage.bounds_max = Vec::Constant(1e9);  // it falls, and nothing is lost
  write_scene(path, stage, 5, 1.0 / 60);
}

}  // namespace carom::tools

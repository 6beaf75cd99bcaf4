// The hard pairs of tests/data/convex_pairs.jsonl as shapes and poses.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/pose.h"
#include "shapes.h"

namespace carom::test {

struct HardPair {
  std::string id;
  Shape a, b;
  Frame b_in_a;
  Real expected;               // m, signed: negative in overlap
  Real tolerance;              // m, of the reference
  Real smallest;               // m, smallest feature
  std::optional<Vec3> normal;  // A's frame
};

inline Vec3 vector_of(const nlohmann::json& j) { return Vec3(j.at(0), j.at(1), j.at(2)); }

inline Shape shape_of(const nlohmann::json& j) {
  const std::string type = j.at("type");
  if (type == "sphere") return sphere(j.at("radius"));
  if (type == "box") return box(vector_of(j.at("half")));
  if (type == "capsule") return capsule(j.at("radius"), j.at("half_height"));
  if (type == "cylinder") return cylinder(j.at("radius"), j.at("half_height"));
  if (type == "cone") return cone(j.at("radius"), j.at("half_height"));
  if (type == "ellipsoid") return ellipsoid(vector_of(j.at("radii")));
  std::vector<Vec3> points;
  for (const nlohmann::json& p : j.at("points")) points.push_back(vector_of(p));
  return hull(points);
}

inline Frame frame_of(const nlohmann::json& j) {
  const nlohmann::json& q = j.at("q");
  return Frame(Pose{normalized(Quat(q.at(0), q.at(1), q.at(2), q.at(3))), vector_of(j.at("p"))});
}

inline std::vector<HardPair> load_hard_pairs(const std::string& path) {
  std::vector<HardPair> pairs;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const nlohmann::json j = nlohmann::json::parse(line);
    const nlohmann::json& expect = j.at("expect");
    const Frame a = frame_of(j.at("pose_a")), b = frame_of(j.at("pose_b"));
    const std::string kind = expect.at("kind");
    const Real value =
        kind == "touch" && expect.contains("signed_exact") ? Real(expect.at("signed_exact")) : Real(expect.at("value"));
    HardPair pair{j.at("id"),
                  shape_of(j.at("shape_a")),
                  shape_of(j.at("shape_b")),
                  relative(a, b),
                  kind == "penetration" ? -value : value,
                  expect.at("tol"),
                  j.at("lmin"),
                  {}};
    if (expect.contains("normal") && expect.at("normal").is_array())
      pair.normal = a.rotate_inverse(vector_of(expect.at("normal")));
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace carom::test

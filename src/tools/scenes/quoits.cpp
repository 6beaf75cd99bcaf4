// quoits: rings fall on a post. Each is several convex parts, so that it has a hole; as one hull it would have none.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "mesh/parts.h"
#include "scenes/random.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr double kRing = 0.35, kTube = 0.09;   // m, radii of a ring
constexpr double kPost = 0.1, kPostTop = 1.2;  // m: its radius; its top

Mesh ring_mesh() {
  constexpr std::uint32_t kAround = 48, kAcross = 16;
  constexpr double kTurn = 2 * std::numbers::pi;
  Mesh mesh;
  for (std::uint32_t i = 0; i < kAround; ++i)
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      const double a = kTurn * i / kAround, b = kTurn * j / kAcross, out = kRing + kTube * std::cos(b);
      mesh.points.emplace_back(out * std::cos(a), kTube * std::sin(b), out * std::sin(a));
      const auto at = [&](std::uint32_t x, std::uint32_t y) { return x % kAround * kAcross + y % kAcross; };
      mesh.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return mesh;
}

/// How many rings went over the post.
class QuoitsObserver : public Observer {
 public:
  explicit QuoitsObserver(std::size_t first) : first_(first) {}
  void watch(const Stage&, double) override {}
  std::vector<std::string> tell(const Stage& stage) const override {
    return {std::to_string(around(stage)) + " of " + std::to_string(stage.actors.size() - first_) +
            " rings lie round the post"};
  }
  bool came_off(const Stage& stage) const override { return around(stage) == stage.actors.size() - first_; }

 private:
  std::size_t around(const Stage& stage) const {
    std::size_t count = 0;
    for (std::size_t i = first_; i < stage.actors.size(); ++i) {
      const Vec p = stage.position(i);
      count += std::hypot(p.x(), p.z()) < kRing - kTube && p.y() < kPostTop;
    }
    return count;
  }

  std::size_t first_;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path) {
  PartsWanted wanted;
  wanted.most = static_cast<std::size_t>(knobs[1]);
  if (mesh_path.empty()) wanted.concavity = kTube / 2;  // a coarse grid will do
  std::vector<Mesh> hulls;
  if (!mesh_path.empty()) hulls = read_parts(mesh_path);
  if (hulls.size() > 1) {
    stage.remarks.push_back(std::to_string(hulls.size()) + " parts from " + mesh_path);
  } else {
    Mesh mesh = mesh_path.empty() ? ring_mesh() : hulls[0];
    if (!mesh_path.empty()) fit_to_height(mesh, 2 * kRing);
    const Parts parts = take_apart(mesh, wanted);
    hulls = parts.hulls;
    char text[128];
    std::snprintf(text, sizeof text, "%zu parts, which stand out of the mesh by at most %.1f mm", hulls.size(),
                  1e3 * parts.outside);
    stage.remarks.push_back(text);
  }
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  Actor post;
  post.kind = post.name = "post", post.type = CAROM_BODY_STATIC;
  post.position = Vec(0, kPostTop / 2, 0);
  Part pole;
  pole.shape = "cylinder", pole.params = {kPost, kPostTop / 2}, pole.friction = 0.2;
  post.parts.push_back(std::move(pole));
  const std::size_t first = stage.add(std::move(post)) + 1;
  double size = 0;  // m, across at most
  for (const Mesh& hull : hulls)
    for (const Vec& p : hull.points) size = std::max(size, 2 * p.norm());
  Random random(20110704);
  for (int i = 0; i < static_cast<int>(knobs[0]); ++i) {
    Actor ring;
    ring.kind = "ring", ring.name = "ring " + std::to_string(i + 1);
    const double height = kPostTop + (mesh_path.empty() ? 0.6 : 1) * size * (i + 1);
    ring.position = random.within(Vec(-0.08, height, -0.08), Vec(0.08, height, 0.08));
    const Vec about = random.within(Vec(-1, 0, 1), Vec(1, 0, 1)).normalized();
    ring.orientation = Quat(Eigen::AngleAxisd(random.between(-0.2, 0.2), about));
    for (const Mesh& hull : hulls) {
      Part part;
      part.shape = "hull", part.params = hull_params(hull), part.friction = 0.3;
      ring.parts.push_back(std::move(part));
    }
    stage.add(std::move(ring));
  }
  stage.ground_half_width = 1.5;
  stage.camera_from = Vec(1.2, 1.7, 2.2), stage.camera_to = Vec(0, 0.55, 0);
  return mesh_path.empty() ? std::make_unique<QuoitsObserver>(first) : nullptr;
}

}  // namespace

Scene quoits_scene() {
  return {"quoits",
          "Rings, each of several convex parts, fall on a post; or what --mesh gives, its objects as parts.",
          "rings that slide down the post: as one hull (parts=1) they would have no hole",
          {{"n", "", "number of rings", 5, 1, 100, true}, {"parts", "", "of a ring at most", 12, 1, 64, true}},
          5.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools

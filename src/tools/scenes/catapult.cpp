// catapult: a weight drops on the short arm, three bunnies fly off the long arm into a wall of blocks (the paper's B).
#include <cmath>
#include <cstdio>

#include "scenes/lever.h"
#include "scenes/wall.h"

namespace carom::tools {
namespace {

/// Watches the throw and the wall.
class CatapultStory : public Observer {
 public:
  CatapultStory(std::vector<std::size_t> bunnies, std::vector<std::size_t> blocks, double start_height)
      : bunnies_(std::move(bunnies)), blocks_(std::move(blocks)), start_(start_height) {}

  void watch(const Stage& stage, double time) override {
    if (homes_.empty())
      for (std::size_t block : blocks_) homes_.push_back(stage.position(block));
    for (std::size_t bunny : bunnies_) {
      peak_ = std::max(peak_, stage.position(bunny).y());
      if (first_hit_ < 0) speed_ = std::max(speed_, stage.velocity(bunny).norm());
    }
    if (first_hit_ < 0 && touches_wall(stage)) first_hit_ = time;
  }

  std::vector<std::string> tell(const Stage& stage) const override {
    char line[200];
    std::vector<std::string> lines;
    std::snprintf(line, sizeof line, "the bunnies are thrown at up to %.2f m/s and rise %.2f m", speed_,
                  peak_ - start_);
    lines.emplace_back(line);
    if (first_hit_ < 0)
      lines.emplace_back("none of them touches the wall");
    else {
      std::snprintf(line, sizeof line, "the first hits the wall at t = %.2f s", first_hit_);
      lines.emplace_back(line);
    }
    std::snprintf(line, sizeof line, "%zu of %zu blocks end more than 0.2 m from where they stood", moved(stage),
                  blocks_.size());
    lines.emplace_back(line);
    return lines;
  }

  bool came_off(const Stage& stage) const override { return peak_ - start_ > 1 && first_hit_ >= 0 && moved(stage) > 0; }

 private:
  std::size_t moved(const Stage& stage) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < homes_.size(); ++i) count += (stage.position(blocks_[i]) - homes_[i]).norm() > 0.2;
    return count;
  }

  bool touches_wall(const Stage& stage) const {
    auto one_of = [&](const std::vector<std::size_t>& list, carom_body body) {
      for (std::size_t i : list)
        if (stage.actors[i].body == body) return true;
      return false;
    };
    for (const carom_contact_event& c : stage.world.contact_events())
      if (c.kind != CAROM_CONTACT_END && ((one_of(bunnies_, c.body_a) && one_of(blocks_, c.body_b)) ||
                                          (one_of(bunnies_, c.body_b) && one_of(blocks_, c.body_a))))
        return true;
    return false;
  }

  std::vector<std::size_t> bunnies_, blocks_;
  std::vector<Vec> homes_;
  double start_, peak_ = -1e9, speed_ = 0, first_hit_ = -1;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path) {
  const int columns = static_cast<int>(knobs[0]), rows = static_cast<int>(knobs[1]);
  const double drop = knobs[2], height = 0.4;
  const Bunny bunny = load_bunny(mesh_path, height, static_cast<std::size_t>(knobs[3]));
  stage.meshes.push_back(bunny.mesh);
  stage.remarks.insert(stage.remarks.end(), bunny.remarks.begin(), bunny.remarks.end());
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});

  Lever lever;
  lever.left = 2.4;
  lever.right = 1.6;
  const double spread = 2 * bunny.half_extents().z() + 0.03;  // m from one bunny to the next
  lever.seat_half_width = 1.5 * spread;
  lever.half_width = lever.seat_half_width + 2 * Lever::kWall;
  lever.seat_length = 2 * bunny.half_extents().x();
  lever.sine = 0.6;  // steep, so that the throw leans far over the pivot
  lever.place_on_ground();
  lever.add_to(stage);

  std::vector<std::size_t> bunnies, blocks;
  double start = 0;
  for (int i = 0; i < 3; ++i) {
    Actor rider;
    rider.kind = "bunny";
    rider.name = "bunny " + std::to_string(i + 1);
    rider.position = lever.to_world(lever.seat(bunny.half_extents().x(), height / 2, spread * (i - 1)));
    rider.orientation = lever.tilt();
    Part body;
    body.shape = "hull";
    body.params = hull_params(bunny.hull.hull);
    body.density = 300;
    body.mesh = 0;
    rider.parts.push_back(body);
    start = rider.position.y();
    bunnies.push_back(stage.add(std::move(rider)));
  }

  Actor weight;  // a crate: a ball would roll on into the wall
  weight.name = weight.kind = "weight";
  const double half = 0.35;  // m
  weight.position = lever.to_world(Vec(lever.right - 0.4, lever.top(), 0)) + Vec(0, half + drop, 0);
  weight.mass = knobs[4];
  Part crate;
  crate.shape = "box";
  crate.params = {half, half, half};
  crate.friction = 0.8;
  weight.parts.push_back(crate);
  stage.add(std::move(weight));

  stage.world.collect_contact_events(1);  // a bunny that is fast for its size may hit and be gone within a step
  Wall wall;
  wall.columns = columns;
  wall.rows = rows;
  wall.foot = Vec(knobs[5], 0, 0);
  blocks = wall.add_to(stage);
  stage.bounds_min = Vec(-80, -1, -80);
  stage.bounds_max = Vec(80, 80, 80);
  stage.ground_half_width = 15;
  stage.camera_from = Vec(4, 4, 14);
  stage.camera_to = Vec(4, 1.8, 0);
  return std::make_unique<CatapultStory>(std::move(bunnies), std::move(blocks), start);
}

}  // namespace

Scene catapult_scene() {
  return {"catapult",
          "A catapult throws three bunnies into a wall of blocks (the paper's scene B).",
          "three bunnies leave together, and the wall breaks where they hit it",
          {{"columns", "", "blocks in a row of the wall", 6, 2, 40, true},
           {"rows", "", "rows of the wall", 8, 1, 30, true},
           {"drop", "m", "height that the weight falls", 0.5, 0.1, 20},
           {"hull_vertices", "", "vertices of a bunny's hull at most", 64, 8, 2000, true},
           {"weight", "kg", "mass of the weight", 800, 1, 1e5},
           {"wall", "m", "where the wall stands, from the pivot", 7, 3, 100}},
          5.0,
          1.0 / 120,
          fill};
}

}  // namespace carom::tools

// seesaw: a weight drops on one end, the bunny on the other end flies into a row of dominoes (the paper's scene A).
#include <cmath>
#include <cstdio>

#include "scenes/lever.h"

namespace carom::tools {
namespace {

std::string text(const char* pattern, double a, double b = 0, double c = 0) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, pattern, a, b, c);
  return buffer;
}

/// Follows the bunny's flight and the dominoes' fall.
class SeesawStory : public Observer {
 public:
  SeesawStory(std::size_t bunny, std::vector<std::size_t> dominoes, double start_height)
      : bunny_(bunny), dominoes_(std::move(dominoes)), fell_(dominoes_.size(), -1), start_(start_height) {}

  void watch(const Stage& stage, double time) override {
    const double height = stage.position(bunny_).y();
    const Vec velocity = stage.velocity(bunny_);
    if (height > peak_) {
      peak_ = height;
      peak_time_ = time;
    }
    if (first_hit_ < 0 && velocity.y() > launch_climb_) {  // it leaves the plank when it stops gaining height faster
      launch_climb_ = velocity.y();
      launch_speed_ = velocity.norm();
      launch_time_ = time;
    }
    if (first_hit_ < 0 && touches_domino(stage)) first_hit_ = time;
    for (std::size_t i = 0; i < dominoes_.size(); ++i) {
      const double up = (stage.orientation(dominoes_[i]) * Vec::UnitY()).y();
      if (fell_[i] < 0 && up < kFallenCosine) fell_[i] = time;
    }
  }

  std::vector<std::string> tell(const Stage& stage) const override {
    std::vector<std::string> lines;
    lines.push_back(text("the bunny is thrown at %.2f m/s (t = %.2f s) and rises %.2f m", launch_speed_, launch_time_,
                         peak_ - start_) +
                    text(", highest at t = %.2f s", peak_time_));
    lines.push_back(first_hit_ < 0 ? "it never touches a domino"
                                   : text("it hits the dominoes at t = %.2f s", first_hit_));
    std::string times;
    std::size_t down = 0;
    for (std::size_t i = 0; i < fell_.size(); ++i) {
      down += fell_[i] >= 0;
      times += (i ? ", " : "") + (fell_[i] < 0 ? std::string("stands") : text("%.2f", fell_[i]));
    }
    lines.push_back(std::to_string(down) + " of " + std::to_string(fell_.size()) +
                    " dominoes fall (past 45 degrees at t = " + times + " s)");
    const Vec end = stage.position(bunny_);
    lines.push_back(text("the bunny ends at x = %.2f, y = %.2f, z = %.2f m", end.x(), end.y(), end.z()));
    return lines;
  }

  bool came_off(const Stage&) const override {
    std::size_t down = 0;
    for (double time : fell_) down += time >= 0 && time >= first_hit_;
    return peak_ - start_ > 1 && first_hit_ >= 0 && down == fell_.size();
  }

 private:
  static constexpr double kFallenCosine = 0.70710678118654752;  // 45 degrees

  bool touches_domino(const Stage& stage) const {
    const carom_body bunny = stage.actors[bunny_].body;
    for (const carom_contact_event& c : stage.world.contact_events()) {
      if ((c.body_a != bunny && c.body_b != bunny) || c.kind == CAROM_CONTACT_END) continue;
      for (std::size_t d : dominoes_)
        if (stage.actors[d].body == c.body_a || stage.actors[d].body == c.body_b) return true;
    }
    return false;
  }

  std::size_t bunny_;
  std::vector<std::size_t> dominoes_;
  std::vector<double> fell_;  // s, or -1 while it stands
  double start_, peak_ = -1e9, peak_time_ = 0, launch_speed_ = 0, launch_climb_ = 0, launch_time_ = 0, first_hit_ = -1;
};

// The first domino is tall and wide, so that it is hit wherever the bunny comes down: that differs by decimetres between
// presets, steps and drops that differ by a thousandth, for the throw is an impact of many points at once. Each domino
// after it is a little smaller. Falling, it meets the next one just below its top.
constexpr double kFirstHeight = 3, kNextHeight = 0.9;        // m; of the height of the one before
constexpr double kHalfThickness = 0.025, kHalfWidth = 0.35;  // of a domino's height

/// The row stands along x; a ball behind the last domino shows that the push arrived.
/// @param spacing  from one domino to the next, of the height of the one
std::vector<std::size_t> add_dominoes(Stage& stage, int count, double first, double aside, double spacing) {
  std::vector<std::size_t> dominoes;
  double height = kFirstHeight, at = first;
  for (int i = 0; i < count; ++i) {
    Actor domino;
    domino.kind = "domino";
    domino.name = "domino " + std::to_string(i + 1);
    domino.position = Vec(at, height / 2, aside);
    Part slab;
    slab.shape = "box";
    slab.params = {kHalfThickness * height, height / 2, kHalfWidth * height};
    slab.density = 40;
    slab.friction = 0.4;
    domino.parts.push_back(slab);
    dominoes.push_back(stage.add(std::move(domino)));
    if (i + 1 == count) break;
    at += spacing * height;
    height *= kNextHeight;
  }
  Actor ball;
  ball.name = ball.kind = "ball";
  Part sphere;
  sphere.shape = "sphere";
  sphere.params = {0.25};
  sphere.density = 200;
  ball.parts.push_back(sphere);
  ball.position = Vec(at + (kHalfThickness + 0.55) * height, 0.25, aside);
  stage.add(std::move(ball));
  return dominoes;
}

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path) {
  stage.world.collect_contact_events(1);
  const int domino_count = static_cast<int>(knobs[0]);
  const double drop = knobs[1], weight = knobs[2], height = knobs[3], first = knobs[5];
  const Bunny bunny = load_bunny(mesh_path, height, static_cast<std::size_t>(knobs[4]));
  stage.meshes.push_back(bunny.mesh);
  stage.remarks.insert(stage.remarks.end(), bunny.remarks.begin(), bunny.remarks.end());
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});

  Lever lever;
  // The bunny's arm is the longer one: so a slow weight throws it. A fast one would throw it off the plank as it hits, by
  // contacts that no two settings solve alike.
  lever.left = 2, lever.right = 1.3;
  lever.sine = knobs[6];  // the throw leans by this tilt, over the pivot: the plank carries the bunny past level
  lever.seat_half_width = bunny.half_extents().z() + 0.02;
  lever.half_width = lever.seat_half_width + 2 * Lever::kWall;
  lever.seat_length = 2 * bunny.half_extents().x();
  lever.place_on_ground();
  lever.add_to(stage);

  Actor rider;
  rider.name = rider.kind = "bunny";
  rider.position = lever.to_world(lever.seat(bunny.half_extents().x(), height / 2, 0));
  rider.orientation = lever.tilt();
  Part body;
  body.shape = "hull";
  body.params = hull_params(bunny.hull.hull);
  body.density = 300;
  body.friction = 0.8;
  body.mesh = 0;
  rider.parts.push_back(body);
  const double start = rider.position.y();
  const std::size_t bunny_actor = stage.add(std::move(rider));

  Actor crate;  // a ball would roll on into the dominoes
  crate.name = crate.kind = "weight";
  const double half = 0.35;  // m
  crate.position = lever.to_world(Vec(lever.right - 0.4, lever.top() + half, 0)) + Vec(0, drop, 0);
  crate.orientation = lever.tilt();  // it comes down flat, not on an edge
  crate.mass = weight;
  Part box;
  box.shape = "box";
  box.params = {half, half, half};
  box.friction = 0.8;
  crate.parts.push_back(box);
  stage.add(std::move(crate));

  std::vector<std::size_t> dominoes = add_dominoes(stage, domino_count, first, knobs[7], knobs[8]);
  stage.bounds_min = Vec(-60, -1, -60);
  stage.bounds_max = Vec(60, 60, 60);
  stage.ground_half_width = 16;
  stage.camera_from = Vec(5, 4, 16);
  stage.camera_to = Vec(5.2, 1.5, 0);
  return std::make_unique<SeesawStory>(bunny_actor, std::move(dominoes), start);
}

}  // namespace

Scene seesaw_scene() {
  return {"seesaw",
          "A weight drops on a seesaw; the bunny on its other end flies into a row of dominoes (the paper's scene A).",
          "the bunny leaves the plank, flies an arc, hits the first domino, and the row topples to its end",
          {{"dominoes", "", "length of the row", 10, 2, 60, true},
           {"drop", "m", "height that the weight falls", 0.1, 0.01, 20},
           {"weight", "kg", "mass of the weight", 1500, 1, 1e5},
           {"bunny_height", "m", "how tall the bunny is", 0.5, 0.2, 1},
           {"hull_vertices", "", "vertices of the bunny's hull at most", 256, 8, 2000, true},
           {"first", "m", "where the first domino stands, from the pivot", 3.3, 2.6, 40},
           {"sine", "", "of the plank's tilt at the start", 0.25, 0.1, 0.8},
           // The bunny is lopsided: as it leaves the seat the ledge turns it, and it drifts to one side.
           {"aside", "m", "how far beside the plank's plane the row stands", -0.1, -10, 10},
           {"spacing", "", "from one domino to the next, of the one's height", 0.52, 0.2, 0.9}},
          5.0,
          1.0 / 120,
          fill};
}

}  // namespace carom::tools

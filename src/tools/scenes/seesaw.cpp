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
    const double height = stage.position(bunny_).y(), speed = stage.velocity(bunny_).norm();
    if (height > peak_) {
      peak_ = height;
      peak_time_ = time;
    }
    if (first_hit_ < 0 && speed > launch_speed_) {
      launch_speed_ = speed;
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
    return peak_ - start_ > 1 && first_hit_ >= 0 && 2 * down > fell_.size();
  }

 private:
  static constexpr double kFallenCosine = 0.70710678118654752;  // 45 degrees

  bool touches_domino(const Stage& stage) const {
    const carom_body bunny = stage.actors[bunny_].body;
    for (const carom_contact& c : stage.world.contacts()) {
      if ((c.body_a != bunny && c.body_b != bunny) || c.normal_impulse <= 0) continue;
      for (std::size_t d : dominoes_)
        if (stage.actors[d].body == c.body_a || stage.actors[d].body == c.body_b) return true;
    }
    return false;
  }

  std::size_t bunny_;
  std::vector<std::size_t> dominoes_;
  std::vector<double> fell_;  // s, or -1 while it stands
  double start_, peak_ = -1e9, peak_time_ = 0, launch_speed_ = 0, launch_time_ = 0, first_hit_ = -1;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path) {
  const int domino_count = static_cast<int>(knobs[0]);
  const double drop = knobs[1], weight_radius = knobs[2], height = knobs[3];
  const Bunny bunny = load_bunny(mesh_path, height, static_cast<std::size_t>(knobs[4]));
  stage.meshes.push_back(bunny.mesh);
  stage.remarks.insert(stage.remarks.end(), bunny.remarks.begin(), bunny.remarks.end());
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});

  Lever lever;
  lever.place_on_ground();
  lever.add_to(stage);

  Actor rider;
  rider.name = rider.kind = "bunny";
  rider.position = lever.to_world(Vec(-lever.left + 0.35, lever.top() + height / 2 + 0.003, 0));
  // It looks towards the dominoes: the mesh's nose points along -x.
  rider.orientation = lever.tilt();
  Part body;
  body.shape = "hull";
  body.params = hull_params(bunny.hull.hull);
  body.density = 300;
  body.friction = 0.6;
  body.mesh = 0;
  rider.parts.push_back(body);
  const double start = rider.position.y();
  const std::size_t bunny_actor = stage.add(std::move(rider));

  Actor weight;
  weight.name = weight.kind = "weight";
  weight.position = lever.to_world(Vec(lever.right - 0.35, lever.top(), 0)) + Vec(0, weight_radius + drop, 0);
  Part ball;
  ball.shape = "sphere";
  ball.params = {weight_radius};
  ball.density = 3000;
  weight.parts.push_back(ball);
  stage.add(std::move(weight));

  std::vector<std::size_t> dominoes;
  const double half_height = 0.4, half_thickness = 0.06, gap = 0.4, first = -4.4;  // m
  for (int i = 0; i < domino_count; ++i) {
    Actor domino;
    domino.kind = "domino";
    domino.name = "domino " + std::to_string(i + 1);
    domino.position = Vec(first - gap * i, half_height, 0);
    Part slab;
    slab.shape = "box";
    slab.params = {half_thickness, half_height, 0.3};
    slab.density = 300;
    slab.friction = 0.4;
    domino.parts.push_back(slab);
    dominoes.push_back(stage.add(std::move(domino)));
  }
  stage.bounds_min = Vec(-60, -1, -60);
  stage.bounds_max = Vec(60, 60, 60);
  stage.ground_half_width = 12;
  stage.camera_from = Vec(-3, 3, 10);
  stage.camera_to = Vec(-3, 1.2, 0);
  return std::make_unique<SeesawStory>(bunny_actor, std::move(dominoes), start);
}

}  // namespace

Scene seesaw_scene() {
  return {"seesaw",
          "A weight drops on a seesaw; the bunny on its other end flies into a row of dominoes (the paper's scene A).",
          "the bunny leaves the plank, flies an arc, hits the first domino, and the row topples to its end",
          {{"dominoes", "", "length of the row", 10, 2, 60, true},
           {"drop", "m", "height that the weight falls", 3, 0.1, 20},
           {"weight_radius", "m", "radius of the weight (3,000 kg/m^3)", 0.4, 0.1, 1},
           {"bunny_height", "m", "how tall the bunny is", 0.5, 0.2, 1},
           {"hull_vertices", "", "vertices of the bunny's hull at most", 256, 8, 2000, true}},
          5.0,
          1.0 / 120,
          fill};
}

}  // namespace carom::tools

// Many pyramids that stand, a row of dominoes of which the first is pushed, people of 33 bones who fall into a pile. Boxes
// and ball joints, which every engine has.
#include "scenes.h"

#include <cmath>

#include "scenes/tower.h"

namespace carom::bench {
namespace {

using tools::Actor;
using tools::Observer;
using tools::Stage;
using tools::Vec;

Actor box(const std::string& kind, const std::string& name, const Vec& position, const Vec& half) {
  Actor actor;
  actor.kind = kind;
  actor.name = name;
  actor.position = position;
  tools::Part part;
  part.shape = "box";
  part.params = {half.x(), half.y(), half.z()};
  actor.parts.push_back(std::move(part));
  return actor;
}

std::unique_ptr<Observer> fill_pyramids(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int count = static_cast<int>(knobs[0]), base = static_cast<int>(knobs[1]);
  const int side = static_cast<int>(std::ceil(std::sqrt(count) - 1e-9));
  const double half = 0.5, pitch = 1.05, spacing = base * pitch + 1;  // m
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  std::size_t number = 0;
  for (int k = 0; k < count; ++k)
    for (int row = 0; row < base; ++row)
      for (int i = 0; i < base - row; ++i) {
        const double along = pitch * (i - (base - row - 1) / 2.0), z = 3 * (k / side);
        const Vec at(spacing * (k % side) + along, half * (2 * row + 1), z);
        stage.add(box("block", "block " + std::to_string(++number), at, Vec::Constant(half)));
      }
  return std::make_unique<tools::TowerStory>();
}

std::unique_ptr<Observer> fill_dominoes(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int count = static_cast<int>(knobs[0]);
  const double pitch = 0.5;          // m
  const Vec half(0.075, 0.5, 0.25);  // m
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  for (int i = 0; i < count; ++i) {
    Actor domino = box("block", "domino " + std::to_string(i + 1), Vec(pitch * (i - count / 2), half.y(), 0), half);
    if (i == 0) {             // it turns about its lower edge
      const double turn = 2;  // rad/s: enough to tip it
      domino.angular_velocity = Vec(0, 0, -turn);
      domino.linear_velocity = turn * Vec(half.y(), half.x(), 0);
    }
    stage.add(std::move(domino));
  }
  return std::make_unique<tools::TowerStory>();
}

/// Somebody who stands with arms spread, feet on the ground, looking along z, turned about y and put somewhere.
class Doll {
 public:
  Doll(Stage& stage, const Vec& at, double turn, int number)
      : stage_(stage), at_(at), turn_(Eigen::AngleAxisd(turn, Vec::UnitY())), number_(number) {
    const std::size_t pelvis = bone({0, 1, 0}, {0.14, 0.07, 0.08});
    std::size_t chest = pelvis;
    for (const double y : {1.13, 1.25, 1.37}) chest = hang(chest, {0, y - 0.06, 0}, {0, y, 0}, {0.12, 0.05, 0.07});
    chest = hang(chest, {0, 1.43, 0}, {0, 1.5, 0}, {0.15, 0.06, 0.08});
    const std::size_t neck = hang(chest, {0, 1.57, 0}, {0, 1.615, 0}, {0.04, 0.035, 0.04});
    hang(neck, {0, 1.66, 0}, {0, 1.78, 0}, {0.08, 0.11, 0.09});
    for (const double side : {-1.0, 1.0}) {
      arm(chest, side);
      leg(pelvis, side);
    }
  }

 private:
  void arm(std::size_t chest, double s) {
    const double y = 1.52;
    std::size_t bone = hang(chest, {0.16 * s, y, 0}, {0.22 * s, y, 0}, {0.05, 0.03, 0.04});
    bone = hang(bone, {0.28 * s, y, 0}, {0.44 * s, y, 0}, {0.15, 0.04, 0.04});
    bone = hang(bone, {0.6 * s, y, 0}, {0.76 * s, y, 0}, {0.15, 0.035, 0.035});
    const std::size_t hand = hang(bone, {0.92 * s, y, 0}, {0.99 * s, y, 0}, {0.06, 0.02, 0.06});
    for (int finger = -2; finger <= 2; ++finger)
      hang(hand, {1.06 * s, y, 0.024 * finger}, {1.12 * s, y, 0.024 * finger}, {0.05, 0.009, 0.009});
  }
  void leg(std::size_t pelvis, double s) {
    const double x = 0.09 * s;
    std::size_t bone = hang(pelvis, {x, 0.92, 0}, {x, 0.72, 0}, {0.06, 0.19, 0.06});
    bone = hang(bone, {x, 0.51, 0}, {x, 0.31, 0}, {0.05, 0.18, 0.05});
    bone = hang(bone, {x, 0.11, 0}, {x, 0.06, 0.05}, {0.045, 0.035, 0.11});
    hang(bone, {x, 0.05, 0.165}, {x, 0.05, 0.21}, {0.04, 0.02, 0.04});
  }
  std::size_t bone(const Vec& middle, const Vec& half) {
    const std::string name = "bone " + std::to_string(number_) + "." + std::to_string(stage_.actors.size());
    Actor actor = box("bone", name, at_ + turn_ * middle, half);
    actor.orientation = turn_;
    return stage_.add(std::move(actor));
  }
  std::size_t hang(std::size_t from, const Vec& joint, const Vec& middle, const Vec& half) {
    const std::size_t made = bone(middle, half);
    stage_.join(CAROM_JOINT_BALL, from, made, at_ + turn_ * joint);
    return made;
  }

  Stage& stage_;
  Vec at_;
  tools::Quat turn_;
  int number_;
};

std::unique_ptr<Observer> fill_dolls(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  for (int i = 0; i < static_cast<int>(knobs[0]); ++i) {  // layers of four, each turned against the one beneath
    const int layer = i / 4;
    const double turn = 1.2 * layer;
    const Vec in_layer(1.3 * (i % 2 ? 1 : -1), 0, i / 2 % 2 ? 0.5 : -0.5);
    const Vec at = Eigen::AngleAxisd(turn, Vec::UnitY()) * in_layer + Vec(0, 0.05 + 2 * layer, 0);
    Doll(stage, at, turn, i + 1);
  }
  return nullptr;
}

const std::vector<tools::Scene>& own_scenes() {
  static const std::vector<tools::Scene> scenes = {
      {"pyramids",
       "",
       "",
       {{"n", "", "pyramids", 25, 1, 1000, true}, {"base", "", "cubes in the lowest row", 10, 1, 100, true}},
       10.0,
       1.0 / 60,
       fill_pyramids},
      {"dominoes", "", "", {{"n", "", "dominoes", 1000, 2, 1900, true}}, 10.0, 1.0 / 60, fill_dominoes},
      {"dolls", "", "", {{"n", "", "people", 20, 1, 1000, true}}, 8.0, 1.0 / 60, fill_dolls},
  };
  return scenes;
}

}  // namespace

const tools::Scene& find_scene(const std::string& name) {
  for (const tools::Scene& scene : own_scenes())
    if (scene.name == name) return scene;
  return tools::find_scene(name);
}

}  // namespace carom::bench

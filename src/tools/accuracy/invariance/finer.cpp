// pile, tumble: what collides at random is compared with its own run at a much finer step, while that can be done.
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSample = 0.1;          // s: at which runs are compared, a multiple of all usual steps
constexpr double kFinest = 1.0 / 15360;  // s
constexpr double kParted = 0.01;         // m: runs that differ by more have parted

/// Where all bodies are every tenth of a second. Errors: how far they are from there in the finest run, root mean
/// square over the bodies of a heap, at a time at which runs have not parted yet, and at the end; of many heaps their
/// geometric mean, since one that fell to the other side says nothing about the rest.
class FinerTrial : public Trial {
 public:
  FinerTrial(const Stage& stage, double early, std::size_t heaps)
      : crowd_(stage), heaps_(heaps), early_(static_cast<std::size_t>(early / kSample + 0.5)) {
    place_ = places();
  }
  void watch(const Stage& stage, double time) override {
    crowd_.look(stage);
    const std::vector<double> now = places();
    // A sample between two steps lies on the line between them.
    for (; static_cast<double>(samples_ + 1) * kSample <= time + 1e-9; ++samples_) {
      const double share =
          std::min(1.0, (static_cast<double>(samples_ + 1) * kSample - time_) / std::max(1e-300, time - time_));
      for (std::size_t k = 0; k < now.size(); ++k) solution_.push_back(place_[k] + share * (now[k] - place_[k]));
    }
    place_ = now, time_ = time;
  }
  Solution solution() const override { return solution_; }
  void compare_with(const Solution& truth) override { truth_ = truth; }
  std::vector<double> errors(const Stage&) const override {
    return {samples_ == 0 ? kNoBound : off(std::min(early_, samples_)), samples_ == 0 ? kNoBound : off(samples_)};
  }
  std::vector<std::string> tell(const Stage&) const override {
    std::size_t parted = 0;
    double first = 0;  // s, sum
    for (std::size_t heap = 0; heap < heaps_; ++heap)
      for (std::size_t n = 1; n <= samples_; ++n)
        if (!(off(n, heap) < kParted)) {
          ++parted, first += static_cast<double>(n) * kSample;
          break;
        }
    if (parted == 0) return {"within 1 cm of the finest run all the time"};
    return {std::to_string(parted) + " of " + std::to_string(heaps_) + " part from the finest run by 1 cm, after " +
            std::to_string(first / static_cast<double>(parted)) + " s on average"};
  }

 private:
  std::vector<double> places() const {
    std::vector<double> list;
    for (std::size_t i = 0; i < crowd_.size(); ++i)
      for (int k = 0; k < 3; ++k) list.push_back(crowd_.position(i)[k]);
    return list;
  }
  /// m, of a heap at the n-th sample, from 1 on
  double off(std::size_t n, std::size_t heap) const {
    const std::size_t all = 3 * crowd_.size(), each = all / heaps_, from = (n - 1) * all + heap * each;
    if (truth_.size() < n * all || solution_.size() < n * all) return kNoBound;
    double sum = 0;
    for (std::size_t k = from; k < from + each; ++k) sum += (solution_[k] - truth_[k]) * (solution_[k] - truth_[k]);
    return std::sqrt(3 * sum / static_cast<double>(each));
  }
  double off(std::size_t n) const {
    double sum = 0;
    for (std::size_t heap = 0; heap < heaps_; ++heap) sum += std::log(off(n, heap));
    return std::exp(sum / static_cast<double>(heaps_));
  }

  Crowd crowd_;
  std::size_t heaps_, early_, samples_ = 0;
  double time_ = 0;
  std::vector<double> place_;
  Solution solution_, truth_;
};

std::unique_ptr<Observer> fill_pile(Stage& stage, const std::vector<double>&, const std::string&) {
  constexpr int kHeaps = 16, kBoxes = 4;
  add_ground(stage, 0.5);
  for (int i = 0; i < kHeaps * kBoxes; ++i) {
    const int heap = i / kBoxes, level = i % kBoxes;
    const Vec at(6 * (heap % 4) + 0.2 * std::sin(2.1 * i), 0.5 + 0.6 * level, 6 * (heap / 4) + 0.2 * std::cos(1.3 * i));
    const Vec axis = Vec(std::sin(3.1 * i + 1), std::cos(1.9 * i), std::sin(0.7 * i)).normalized();
    const double half = 0.5 * (0.4 + 0.7 * i);
    const Quat turned(std::cos(half), std::sin(half) * axis.x(), std::sin(half) * axis.y(), std::sin(half) * axis.z());
    add_box(stage, at, Vec(0.2, 0.15, 0.25), 1, {0.5, 0}, Vec::Zero(), turned);
  }
  stage.ground_half_width = 25;
  stage.camera_from = Vec(9, 8, 32), stage.camera_to = Vec(9, 0, 9);
  return std::make_unique<FinerTrial>(stage, 0.5, kHeaps);
}

std::unique_ptr<Observer> fill_tumble(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Settings one;
  one.values = {{"n", 1}, {"push", knobs[0]}};
  build(find_scene("ragdoll"), one, stage);
  return std::make_unique<FinerTrial>(stage, 0.5, 1);
}

Challenge finer(Scene scene) {
  return {35,
          std::move(scene),
          "own run at 1/15360 s, same dials",
          {{"place after 0.5 s", "m", 1e-3}, {"place at the end", "m", kNoBound}},
          {},
          {},
          kFinest};
}

}  // namespace

Challenge pile_challenge() {
  return finer({"pile",
                "Sixteen heaps of four boxes, turned this way and that, fall onto the ground and one another.",
                "heaps that are the same for a while whatever the step",
                {},
                1,
                1.0 / 60,
                fill_pile});
}

Challenge tumble_challenge() {
  return finer({"tumble",
                "Eleven capsules, held together by ten joints, are pushed down a flight of stairs.",
                "a fall that is the same for a while whatever the step",
                {{"push", "m/s", "forwards at first", 2, 0, 10}},
                1,
                1.0 / 60,
                fill_tumble});
}

}  // namespace carom::tools::accuracy

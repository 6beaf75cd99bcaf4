// replay: the same scene a second time, and with a second thread: the same bits after every step.
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// Eight walls of boxes that lean against one another's feet: enough groups that threads have something to share.
void add_things(Stage& stage) {
  add_ground(stage, 0.5);
  for (int wall = 0; wall < 8; ++wall)
    for (int row = 0; row < 6; ++row)
      for (int i = 0; i < 4; ++i)
        add_box(stage, Vec(1.02 * i + 0.5 * (row % 2), 0.26 + 0.55 * row, 2.0 * wall), Vec(0.5, 0.25, 0.25), 1,
                {0.5, 0.2});
  add_ball(stage, Vec(1.5, 2, -6), 0.5, 20, {0.5, 0.2}, Vec(0, 0, 12));
}

/// A world of an engine of its own that does what the judged one does.
class Twin {
 public:
  Twin(Engine& model, std::uint32_t threads) : engine_(std::make_unique<Engine>(model.path())) {
    engine_->set_threads(threads);
    stage_ = std::make_unique<Stage>(*engine_);
    add_things(*stage_);
  }
  void take_dials(const World& model) {
    for (const carom_dial_info& dial : all_dials()) stage_->world.set_dial(dial.dial, model.dial(dial.dial));
  }
  /// Whether it has the judged one's bits after a step.
  bool follows(const World& model, double dt) {
    stage_->world.step(dt);
    return stage_->world.hash() == model.hash();
  }

 private:
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<Stage> stage_;
};

class ReplayTrial : public Trial {
 public:
  explicit ReplayTrial(Engine& engine) : again_(engine, 1), shared_(engine, 2) {}
  void watch(const Stage& stage, double time) override {
    if (dt_ == 0) {
      dt_ = time;
      for (Twin* twin : {&again_, &shared_}) twin->take_dials(stage.world);
    }
    const bool again = again_.follows(stage.world, dt_), shared = shared_.follows(stage.world, dt_);
    if (!again && parted_ == 0) parted_ = time;
    if (!shared && shared_parted_ == 0) shared_parted_ = time;
  }
  bool over() const override { return parted_ > 0 && shared_parted_ > 0; }
  std::vector<double> errors(const Stage&) const override {
    return {parted_ > 0 ? 1.0 : 0.0, shared_parted_ > 0 ? 1.0 : 0.0};
  }
  std::vector<std::string> tell(const Stage&) const override {
    std::vector<std::string> story;
    if (parted_ > 0) story.push_back("the second run parted after " + std::to_string(parted_) + " s");
    if (shared_parted_ > 0) story.push_back("two threads parted after " + std::to_string(shared_parted_) + " s");
    return story;
  }

 private:
  Twin again_, shared_;
  double dt_ = 0, parted_ = 0, shared_parted_ = 0;  // s
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>&, const std::string&) {
  add_things(stage);
  stage.camera_from = Vec(14, 5, 7), stage.camera_to = Vec(1.5, 1, 7);
  return std::make_unique<ReplayTrial>(stage.engine());
}

}  // namespace

Challenge replay_challenge() {
  return {36,
          {"replay",
           "A ball knocks down eight walls of boxes; so it does in a second world, and in a third on two threads.",
           "nothing: all three have the same bits after every step",
           {},
           2,
           1.0 / 60,
           fill},
          "the hash of the first",
          {{"a second run differs", "", 0}, {"two threads differ", "", 0}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy

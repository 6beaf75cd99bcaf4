// Things that ought to stand still: how far they sink and drift, and when they fall.
#pragma once

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {

/// Errors: the largest change of height and the largest sideways move of any body, at the end, m; then how much of the
/// time it did not stand, s. Where a body is ever further from home than `fallen`, the whole has fallen.
class StandTrial : public Trial {
 public:
  /// Of all dynamic bodies that the stage has now.   @param fallen m   @param seconds how long it should stand
  StandTrial(const Stage& stage, double fallen, double seconds);
  void watch(const Stage& stage, double time) override;
  std::vector<double> errors(const Stage& stage) const override;
  std::vector<TruePose> truth(double) const override { return homes_; }

  static std::vector<Metric> metrics(double sink_bound, double drift_bound, double short_bound);

 private:
  Crowd crowd_;
  std::vector<TruePose> homes_;
  double fallen_, seconds_;
};

}  // namespace carom::tools::accuracy

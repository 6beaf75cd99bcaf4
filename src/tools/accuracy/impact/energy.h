// Mechanical energy of equal balls over level ground, step by step, against what they had at the start.
#pragma once

#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {

/// Root mean square over the steps of (E - E0) / E0; E counts height above the ground, flight and spin.
class EnergyTrial : public Trial {
 public:
  /// Of all dynamic bodies that the stage has now: balls of one radius (m) and one mass (kg).
  EnergyTrial(const Stage& stage, double radius, double mass)
      : crowd_(stage), radius_(radius), mass_(mass), start_(energy()) {}

  void watch(const Stage& stage, double) override {
    crowd_.look(stage);
    const double error = energy() / start_ - 1;
    sum_ += error * error;
    ++samples_;
  }
  std::vector<double> errors(const Stage&) const override { return {std::sqrt(sum_ / samples_)}; }

 private:
  double energy() const {  // J
    double sum = 0;
    for (std::size_t i = 0; i < crowd_.size(); ++i)
      sum += kGravity * (crowd_.position(i).y() - radius_) + crowd_.velocity(i).squaredNorm() / 2 +
             0.2 * radius_ * radius_ * crowd_.spin(i).squaredNorm();  // a solid ball: I = 2/5 m r^2
    return mass_ * sum;
  }

  Crowd crowd_;
  double radius_, mass_, start_, sum_ = 0, samples_ = 0;
};

}  // namespace carom::tools::accuracy

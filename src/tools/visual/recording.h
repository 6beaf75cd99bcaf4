// The motion of a stage, sampled at a frame rate: what viewers and tables are made from.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// Poses of every actor at chosen steps, single precision (a viewer's), quaternions continuous in sign.
class Recording {
 public:
  /// @param frames_per_second  > 0; frames fall on steps, so the true rate is that of the nearest whole number of steps
  Recording(const Stage& stage, double dt, double frames_per_second);

  /// Call after every step; keeps a frame when one is due.
  void after_step(std::uint64_t step, double time);
  /// Keep the current pose as the last frame, unless it is there already.
  void finish(double time);

  std::size_t frame_count() const { return times_.size(); }
  const std::vector<float>& times() const { return times_; }  ///< s, increasing, from 0
  /// x, y, z (m) and x, y, z, w of an actor in a frame. A pose that is not finite repeats the one before.
  const float* pose(std::size_t frame, std::size_t actor) const { return &poses_[(frame * actors_ + actor) * 7]; }

 private:
  void keep(double time);
  const Stage& stage_;
  std::size_t actors_;
  std::uint64_t every_;
  std::vector<double> scratch_;
  std::vector<float> times_, poses_;
};

}  // namespace carom::tools

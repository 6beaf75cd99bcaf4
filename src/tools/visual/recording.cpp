// The motion of a stage, sampled at a frame rate.
#include "visual/recording.h"

#include <algorithm>
#include <cmath>

namespace carom::tools {

Recording::Recording(const Stage& stage, double dt, double frames_per_second)
    : stage_(stage),
      actors_(stage.actors.size()),
      every_(static_cast<std::uint64_t>(std::clamp(std::round(1 / (frames_per_second * dt)), 1.0, 1e9))) {
  keep(0);
}

void Recording::after_step(std::uint64_t step, double time) {
  if (step % every_ == 0) keep(time);
}

void Recording::finish(double time) {
  if (static_cast<float>(time) > times_.back()) keep(time);
}

void Recording::keep(double time) {
  stage_.read(CAROM_FIELD_POSE, scratch_);
  const std::size_t previous = poses_.size() - (times_.empty() ? 0 : actors_ * 7);
  times_.push_back(static_cast<float>(time));
  for (std::size_t a = 0; a < actors_; ++a) {
    const double* in = &scratch_[a * 7];
    float out[7];
    bool finite = true;
    for (int i = 0; i < 7; ++i) {
      out[i] = static_cast<float>(in[i]);
      finite = finite && std::isfinite(out[i]);
    }
    if (times_.size() > 1) {
      const float* before = &poses_[previous + a * 7];
      if (!finite) std::copy(before, before + 7, out);
      // q and -q are the same rotation, but a viewer interpolates between their numbers: stay on one side.
      const float dot = out[3] * before[3] + out[4] * before[4] + out[5] * before[5] + out[6] * before[6];
      if (dot < 0)
        for (int i = 3; i < 7; ++i) out[i] = -out[i];
    } else if (!finite) {
      const float rest[7] = {0, 0, 0, 0, 0, 0, 1};
      std::copy(rest, rest + 7, out);
    }
    poses_.insert(poses_.end(), out, out + 7);
  }
}

}  // namespace carom::tools

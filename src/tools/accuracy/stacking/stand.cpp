// Things that ought to stand still.
#include "accuracy/stacking/stand.h"

#include <cmath>

namespace carom::tools::accuracy {

StandTrial::StandTrial(const Stage& stage, double fallen, double seconds)
    : crowd_(stage), fallen_(fallen), seconds_(seconds) {
  for (std::size_t i = 0; i < stage.actors.size(); ++i)
    if (stage.actors[i].type == CAROM_BODY_DYNAMIC) homes_.push_back({i, stage.position(i), stage.orientation(i)});
}

void StandTrial::watch(const Stage& stage, double time) {
  crowd_.look(stage);
  for (std::size_t i = 0; i < crowd_.size(); ++i)
    if (!((crowd_.position(i) - crowd_.home(i)).norm() <= fallen_)) fall(time);  // a body that is not finite, too
}

std::vector<double> StandTrial::errors(const Stage&) const {
  double sink = 0, drift = 0;
  for (std::size_t i = 0; i < crowd_.size(); ++i) {
    const Vec way = crowd_.position(i) - crowd_.home(i);
    sink = std::max(sink, std::fabs(way.y()));
    drift = std::max(drift, std::hypot(way.x(), way.z()));
  }
  return {sink, drift, fell() ? std::max(0.0, seconds_ - fell_at()) : 0};
}

std::vector<Metric> StandTrial::metrics(double sink_bound, double drift_bound, double short_bound) {
  return {{"sink", "m", sink_bound}, {"drift", "m", drift_bound}, {"time not stood", "s", short_bound}};
}

}  // namespace carom::tools::accuracy

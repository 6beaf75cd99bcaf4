// How far a run is from its references, and from the laws that hold whatever the motion.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tune/tune.h"

namespace carom::tools::tune {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kGravity = 9.80665;  // m/s^2: a height stands for so much energy a kilogram

double rms(double sum, std::size_t count) { return count ? std::sqrt(sum / static_cast<double>(count)) : 0; }

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return rms(sum, values.size());
}

bool comparable(const Trace& a, const Trace& b) {  // else one was over before the other
  return a.energy.size() == b.energy.size() && a.center.size() == b.center.size();
}

/// Mean over a body's matter of the square of how far it is from where another run has it: that of its centre, and what
/// its turn moves. No axis counts more than its matter says: a rod's turn about itself moves next to nothing.
double pose_error(const Trace& a, const Trace& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.center.size(); ++i) {
    const Eigen::Matrix3d apart = a.orientation[i].toRotationMatrix() - b.orientation[i].toRotationMatrix();
    const Eigen::Matrix3d& spread = a.matter[i % a.matter.size()].spread;
    sum += (a.center[i] - b.center[i]).squaredNorm() + (apart * spread * apart.transpose()).trace();
  }
  return rms(sum, a.center.size());
}

double drift_error(const Trace& a, const Trace& b) {
  const std::size_t bodies = a.matter.size();
  double sum = 0;
  for (std::size_t m = 0; bodies && m < a.energy.size(); ++m) {
    Vec apart = Vec::Zero();
    for (std::size_t i = m * bodies; i < (m + 1) * bodies; ++i) apart += a.center[i] - b.center[i];
    sum += (apart / static_cast<double>(bodies)).squaredNorm();
  }
  return rms(sum, a.energy.size());
}

double energy_error(const Trace& a, const Trace& b) {
  double sum = 0;
  for (std::size_t m = 0; m < a.energy.size(); ++m) sum += (a.energy[m] - b.energy[m]) * (a.energy[m] - b.energy[m]);
  return rms(sum, a.energy.size());
}

/// J, rms: outside of what the two references have, each moment.
double stray_energy(const Trace& t, const References& r) {
  double sum = 0;
  const std::size_t moments = std::min({t.energy.size(), r.full.energy.size(), r.half.energy.size()});
  for (std::size_t m = 0; m < moments; ++m) {
    const auto [low, high] = std::minmax(r.full.energy[m], r.half.energy[m]);
    const double out = std::max({low - t.energy[m], t.energy[m] - high, 0.0});
    sum += out * out;
  }
  return rms(sum, moments);
}

bool stands(const Trace& t, std::size_t body) {
  const std::size_t bodies = t.matter.size();
  const Matter& m = t.matter[body];
  return m.size() > 0 && (t.center[t.center.size() - bodies + body] - m.home).norm() < m.size();
}

}  // namespace

const char* name_of(ErrorKind kind) {
  static constexpr const char* kNames[kErrorKinds] = {"truth", "pose", "drift", "energy", "gap", "laws"};
  return kNames[static_cast<int>(kind)];
}

const char* unit_of(ErrorKind kind) {
  static constexpr const char* kUnits[kErrorKinds] = {"", "m", "m", "J", "m", "m"};
  return kUnits[static_cast<int>(kind)];
}

int fallen(const Trace& t, const References& r) {
  if (!comparable(t, r.full) || !comparable(r.half, r.full) || t.center.empty()) return 0;
  int fell = 0, differ = 0;
  for (std::size_t i = 0; i < t.matter.size(); ++i) {
    const bool full = stands(r.full, i), half = stands(r.half, i);
    differ += full != half;
    fell += full && half && !stands(t, i);
  }
  return std::max(0, fell - differ);
}

Offences offences_of(const Trace& t, const References& r) {
  return {rms(t.sink), rms(t.joints), rms(t.cone), t.weight > 0 ? stray_energy(t, r) / t.weight : 0};
}

Errors errors_of(const Trace& t, const References& r, double frame_rate) {
  Errors errors;
  errors.fill(kInfinite);
  if (!t.finite || t.dear || t.fell || fallen(t, r) > 0) return errors;
  const auto at = [&](ErrorKind kind) -> double& { return errors[static_cast<std::size_t>(kind)]; };
  at(ErrorKind::truth) = t.truth;
  const Offences o = offences_of(t, r);
  at(ErrorKind::gap) = std::hypot(o.sink, o.joints);
  at(ErrorKind::laws) = std::hypot(std::hypot(o.sink, o.joints), o.cone / frame_rate, o.energy / kGravity);
  if (comparable(t, r.full)) {
    at(ErrorKind::pose) = pose_error(t, r.full);
    at(ErrorKind::drift) = drift_error(t, r.full);
    at(ErrorKind::energy) = energy_error(t, r.full);
  }
  for (double& error : errors)
    if (std::isnan(error)) error = kInfinite;
  return errors;
}

}  // namespace carom::tools::tune

// One run of a scene under a setting, and how far it is from another.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tune/tune.h"

namespace carom::tools::tune {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kMoments = 120;

/// The dynamic bodies and particles of a stage, and what they weigh.
class Watch {
 public:
  Watch(Stage& stage, Trace& trace) : stage_(stage), trace_(trace) {
    for (const Actor& actor : stage.actors)
      if (actor.body != CAROM_NULL_HANDLE && actor.type == CAROM_BODY_DYNAMIC) bodies_.push_back(actor.body);
    if (!bodies_.empty()) stage.world.read(CAROM_FIELD_MASS, bodies_, trace.mass);
    carom_world_get_gravity(stage.world.get(), gravity_, nullptr);
  }

  void after_step(const carom_step_report& report) {
    gap_ = std::max(gap_, report.max_penetration);
    for (const Tie& tie : stage_.ties) {
      carom_joint_state state = {};
      state.struct_size = sizeof state;
      if (carom_joint_get_state(stage_.world.get(), tie.joint, &state, nullptr) == CAROM_OK && !state.broken)
        gap_ = std::max(gap_, state.gap);
    }
    trace_.finite &= report.quarantined_bodies == 0;
    energy_ = report.linear_energy + report.angular_energy;
  }

  void moment() {
    std::vector<double> x;
    if (!bodies_.empty()) stage_.world.read(CAROM_FIELD_CENTER, bodies_, x);
    double energy = energy_;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) energy -= trace_.mass[i] * gravity_[k] * x[3 * i + k];
    trace_.x.insert(trace_.x.end(), x.begin(), x.end());
    trace_.energy.push_back(energy);
    trace_.gap.push_back(gap_);
    gap_ = 0;
  }

 private:
  Stage& stage_;
  Trace& trace_;
  std::vector<carom_body> bodies_;
  double gravity_[3] = {0, 0, 0};  // m/s^2
  double gap_ = 0, energy_ = 0;
};

double rms(double sum, std::size_t count) { return count ? std::sqrt(sum / static_cast<double>(count)) : 0; }

double squares_between(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// m, [moments][3]
std::vector<double> means(const Trace& t) {
  const std::size_t moments = t.energy.size(), bodies = t.mass.size();
  std::vector<double> mean(3 * moments, 0);
  for (std::size_t m = 0; m < moments; ++m)
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        mean[3 * m + k] += t.x[3 * (m * bodies + i) + k] / static_cast<double>(bodies);
  return mean;
}

}  // namespace

Trace play(Engine& engine, const Question& question, const Setting& setting, double seconds, double most_ms) {
  Trace trace;
  Stage stage(engine);
  const std::unique_ptr<Observer> observer = build(*question.scene, question.settings, stage);
  for (const auto& [dial, value] : setting.dials) stage.world.set_dial(dial + "=" + value);
  Watch watch(stage, trace);
  const int frames = std::max(1, static_cast<int>(std::lround(seconds * question.frame_rate)));
  const int stride = (frames + kMoments - 1) / kMoments;
  const double dt = 1 / (question.frame_rate * setting.steps_per_frame);
  const auto* trial = dynamic_cast<const accuracy::Trial*>(observer.get());
  int played = 0;
  for (bool over = false; played < frames && !over && trace.finite && !trace.dear; ++played) {
    double frame = 0;  // s
    for (int k = 0; k < setting.steps_per_frame; ++k) {
      stage.world.step(dt);
      const carom_step_report report = stage.world.report();
      frame += report.total_seconds;
      watch.after_step(report);
      if (observer) observer->watch(stage, report.time);
    }
    trace.ms += 1e3 * frame;
    trace.dear = trace.ms > most_ms * frames;
    trace.worst_ms = std::max(trace.worst_ms, 1e3 * frame);
    over = trial && trial->over();
    if ((played + 1) % stride == 0 || played + 1 == frames) watch.moment();
  }
  trace.ms /= played;
  if (trial) {
    trace.truth = trial->errors(stage).front();
    if (trial->fell() || std::isnan(trace.truth)) trace.truth = kInfinite;
  }
  return trace;
}

double error_of(const Trace& t, const Trace& reference, ErrorKind kind) {
  if (!t.finite || t.dear) return kInfinite;
  if (kind == ErrorKind::truth) return t.truth;
  const std::size_t moments = t.energy.size();
  if (kind == ErrorKind::gap) {
    double sum = 0;
    for (const double gap : t.gap) sum += gap * gap;
    return rms(sum, moments);
  }
  if (moments != reference.energy.size() || t.x.size() != reference.x.size()) return kInfinite;  // one was over before
  double error = 0;
  if (kind == ErrorKind::pose) error = rms(squares_between(t.x, reference.x), t.x.size() / 3);
  if (kind == ErrorKind::drift) error = rms(squares_between(means(t), means(reference)), moments);
  if (kind == ErrorKind::energy) error = rms(squares_between(t.energy, reference.energy), moments);
  return std::isfinite(error) ? error : kInfinite;
}

}  // namespace carom::tools::tune

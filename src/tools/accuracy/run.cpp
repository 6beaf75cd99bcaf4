// Runs a challenge at one step size or at a row of halved ones, and judges it.
#include "accuracy/run.h"

#include <cmath>

#include "scenes/run.h"

namespace carom::tools::accuracy {
namespace {

struct Run {
  std::unique_ptr<Stage> stage;
  std::unique_ptr<Observer> observer;
  RunSummary summary;
  Trial& trial() const { return dynamic_cast<Trial&>(*observer); }
};

Run play(Engine& engine, const Challenge& challenge, const Request& request) {
  Run r;
  r.stage = std::make_unique<Stage>(engine);
  r.observer = build(challenge.scene, request.settings, *r.stage);
  for (const std::string& dial : request.dials) r.stage->world.set_dial(dial);
  const Trial& trial = r.trial();
  r.summary = simulate(*r.stage, r.observer.get(), request.seconds > 0 ? request.seconds : challenge.scene.seconds,
                       request.dt, [&](const carom_step_report& report) {
                         if (request.after_step) request.after_step(*r.stage, report);
                         return !trial.over();
                       });
  return r;
}

}  // namespace

std::vector<std::string> Trial::tell(const Stage&) const {
  if (!fell()) return {};
  return {"fell after " + std::to_string(fell_at_) + " s"};
}

bool within_bounds(const Challenge& challenge, const Result& result) {
  bool within = result.fell_at < 0;
  for (std::size_t i = 0; i < result.errors.size(); ++i)
    if (challenge.metrics[i].bound != kNoBound) within &= result.errors[i] <= challenge.metrics[i].bound;
  return within;
}

std::optional<double> own_truth(Engine& engine, const Challenge& challenge, const Request& request) {
  if (!(challenge.reference_dt > 0)) return std::nullopt;
  Request fine = request;
  fine.dt = challenge.reference_dt;
  fine.after_step = nullptr;
  return play(engine, challenge, fine).trial().answer();
}

Result run(Engine& engine, const Challenge& challenge, const Request& request, std::optional<double> truth) {
  const Run r = play(engine, challenge, request);
  if (truth) r.trial().compare_with(*truth);
  Result result;
  result.dt = request.dt;
  result.errors = r.trial().errors(*r.stage);
  for (double& error : result.errors)
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  result.fell_at = r.trial().fell_at();
  result.simulated = r.summary.simulated;
  result.ms_per_second = 1e3 * r.summary.total_seconds / r.summary.simulated;
  result.story = r.trial().tell(*r.stage);
  return result;
}

std::vector<Result> run_halved(Engine& engine, const Challenge& challenge, Request request, int halvings) {
  const std::optional<double> truth = own_truth(engine, challenge, request);
  std::vector<Result> results;
  for (int k = 0; k <= halvings; ++k, request.dt /= 2) results.push_back(run(engine, challenge, request, truth));
  return results;
}

double observed_order(double error, double error_at_half_step) {
  const bool comparable =
      error > 0 && error_at_half_step > 0 && std::isfinite(error) && std::isfinite(error_at_half_step);
  return comparable ? std::log2(error / error_at_half_step) : std::nan("");
}

}  // namespace carom::tools::accuracy

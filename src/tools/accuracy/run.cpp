// Runs a challenge at one step size or at a row of halved ones, and judges it.
#include "accuracy/run.h"

#include <cmath>

#include "host/cpu_time.h"

namespace carom::tools::accuracy {
namespace {

/// The stage's own world.
class OwnWorld : public Mover {
 public:
  void push(const Stage& stage, const Push& push) override {
    const double torque[3] = {0, 0, 0};
    Call call;
    call.done(carom_body_add_force(stage.world.get(), stage.actors[push.actor].body, push.force.data(), torque, call),
              "pushing " + stage.actors[push.actor].name);
  }
  void step(Stage& stage, double dt) override { stage.world.step(dt); }
};

struct Run {
  std::unique_ptr<Stage> stage;
  std::unique_ptr<Observer> observer;
  double simulated = 0, computed = 0;  // s
  bool given_up = false, lost = false;
  Trial& trial() const { return dynamic_cast<Trial&>(*observer); }
};

Run play(Engine& engine, const Challenge& challenge, const Request& request) {
  const double seconds = request.seconds > 0 ? request.seconds : challenge.scene.seconds, dt = request.dt;
  if (!(seconds > 0 && seconds <= 1e6)) throw Error("a run cannot last that long", "give --seconds between 0 and 1e6");
  if (!(dt > 0 && dt <= 1)) throw Error("the time step must be in (0, 1] s", "give --dt, e.g. 1/60");
  Run r;
  r.stage = std::make_unique<Stage>(engine);
  r.observer = build(challenge.scene, request.settings, *r.stage);
  if (!request.preset.empty()) r.stage->world.set_preset(request.preset);
  for (const std::string& dial : request.dials) r.stage->world.set_dial(dial);
  const Trial& trial = r.trial();
  const std::unique_ptr<Mover> mover = request.mover ? request.mover(*r.stage) : std::make_unique<OwnWorld>();
  const auto steps = static_cast<std::uint64_t>(std::max(1.0, std::ceil(seconds / dt - 1e-6)));
  for (std::uint64_t i = 0; i < steps && !trial.over(); ++i) {
    for (const Push& push : trial.pushes()) mover->push(*r.stage, push);
    const double begun = cpu_time();
    mover->step(*r.stage, dt);
    const double here = cpu_time() - begun, elsewhere = mover->seconds_elsewhere();
    r.computed += elsewhere < 0 ? here : elsewhere;
    r.simulated = static_cast<double>(i + 1) * dt;
    r.lost = !mover->show(*r.stage);
    if (r.lost) break;
    r.observer->watch(*r.stage, r.simulated);
    if (request.after_step) request.after_step(*r.stage, r.stage->world.report());
    r.given_up = request.patience > 0 && r.computed > request.patience && i + 1 < steps;
    if (r.given_up) break;
  }
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

std::optional<Solution> own_truth(Engine& engine, const Challenge& challenge, const Request& request) {
  if (!(challenge.reference_dt > 0)) return std::nullopt;
  Request fine = request;
  fine.dt = challenge.reference_dt;
  fine.after_step = nullptr;
  return play(engine, challenge, fine).trial().solution();
}

Result run(Engine& engine, const Challenge& challenge, const Request& request, const std::optional<Solution>& truth) {
  const Run r = play(engine, challenge, request);
  if (truth) r.trial().compare_with(*truth);
  Result result;
  result.dt = request.dt;
  result.errors = r.trial().errors(*r.stage);
  for (double& error : result.errors)
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  if (r.lost || r.given_up) result.errors.assign(result.errors.size(), std::numeric_limits<double>::infinity());
  result.fell_at = r.lost && !r.trial().fell() ? r.simulated : r.trial().fell_at();
  result.given_up = r.given_up;
  result.simulated = r.simulated;
  result.ms_per_second = 1e3 * r.computed / r.simulated;
  result.story = r.trial().tell(*r.stage);
  return result;
}

std::vector<Result> run_halved(Engine& engine, const Challenge& challenge, Request request, int halvings) {
  const std::optional<Solution> truth = own_truth(engine, challenge, request);
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

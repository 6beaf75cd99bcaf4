// Runs a challenge at one step size or at a row of halved ones, and judges it.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

/// Who moves the bodies of a stage: its own world, or another engine whose state is copied into that world after every
/// step, so that the same Trial judges it.
class Mover {
 public:
  virtual ~Mover() = default;
  virtual void push(const Stage& stage, const Push& push) = 0;
  virtual void step(Stage& stage, double dt) = 0;  ///< what is timed
  /// CPU time of the last step() where another process took it, s; negative: this thread did.
  virtual double seconds_elsewhere() const { return -1; }
  /// Bring the stage's world to where bodies are.   @return false: they are nowhere, the run is lost
  virtual bool show(Stage&) { return true; }
};

/// How a challenge is to be run.
struct Request {
  Settings settings;                                                 ///< knobs of the scene
  std::vector<std::string> dials;                                    ///< "solver=severity"
  double dt = 1.0 / 60;                                              ///< s
  double seconds = 0;                                                ///< simulated; 0: what the scene asks for
  std::function<void(Stage&, const carom_step_report&)> after_step;  ///< may be empty
  double patience = 0;                                       ///< s of computing after which a run is given up; 0: never
  std::function<std::unique_ptr<Mover>(Stage&)> mover = {};  ///< for a stage that is filled; empty: its own world
  std::string preset = {};                                   ///< before dials; empty: a new world's
};

/// What came of a run.
struct Result {
  double dt = 0;
  std::vector<double> errors;      ///< one per metric of the challenge; infinite: not a number, or no solution
  double fell_at = -1;             ///< s, or -1: it stood, or there was nothing to fall
  double simulated = 0;            ///< s; less than asked for where the run was over before
  double ms_per_second = 0;        ///< ms of CPU time in steps, per simulated second
  bool given_up = false;           ///< it ran out of patience: errors say nothing
  std::vector<std::string> story;  ///< the trial's own sentences
};

/// Nothing fell, and no error exceeds its metric's bound.
bool within_bounds(const Challenge& challenge, const Result& result);

/// The scene's own solution at challenge.reference_dt; nothing where the truth is a closed form.   @throws Error
std::optional<Solution> own_truth(Engine& engine, const Challenge& challenge, const Request& request);

/// @param truth  from own_truth()   @throws Error (knob, dial or plugin missing; a step failed)
Result run(Engine& engine, const Challenge& challenge, const Request& request, const std::optional<Solution>& truth);

/// Runs at dt, dt/2, ... dt/2^halvings.
std::vector<Result> run_halved(Engine& engine, const Challenge& challenge, Request request, int halvings);

/// Observed order between a run and one at half its step: log2 of the ratio of errors; NaN if either is 0 or infinite.
double observed_order(double error, double error_at_half_step);

}  // namespace carom::tools::accuracy

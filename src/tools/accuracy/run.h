// Runs a challenge at one step size or at a row of halved ones, and judges it.
#pragma once

#include <functional>
#include <optional>

#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

/// How a challenge is to be run.
struct Request {
  Settings settings;                                                 ///< knobs of the scene
  std::vector<std::string> dials;                                    ///< "solver=severity"
  double dt = 1.0 / 60;                                              ///< s
  double seconds = 0;                                                ///< simulated; 0: what the scene asks for
  std::function<void(Stage&, const carom_step_report&)> after_step;  ///< may be empty
};

/// What came of a run.
struct Result {
  double dt = 0;
  std::vector<double> errors;      ///< one per metric of the challenge; infinite: not a number, or no answer
  double fell_at = -1;             ///< s, or -1: it stood, or there was nothing to fall
  double simulated = 0;            ///< s; less than asked for where the run was over before
  double ms_per_second = 0;        ///< ms of computing, by the library's clock, per simulated second
  std::vector<std::string> story;  ///< the trial's own sentences
};

/// Nothing fell, and no error exceeds its metric's bound.
bool within_bounds(const Challenge& challenge, const Result& result);

/// The scene's own answer at challenge.reference_dt; nothing where the truth is a closed form.   @throws Error
std::optional<double> own_truth(Engine& engine, const Challenge& challenge, const Request& request);

/// @param truth  from own_truth()   @throws Error (knob, dial or plugin missing; a step failed)
Result run(Engine& engine, const Challenge& challenge, const Request& request, std::optional<double> truth);

/// Runs at dt, dt/2, ... dt/2^halvings.
std::vector<Result> run_halved(Engine& engine, const Challenge& challenge, Request request, int halvings);

/// Observed order between a run and one at half its step: log2 of the ratio of errors; NaN if either is 0 or infinite.
double observed_order(double error, double error_at_half_step);

}  // namespace carom::tools::accuracy

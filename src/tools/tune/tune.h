// Which settings err least on a scene within a budget: candidates are run, judged against a reference that is checked
// against half of itself, and what no other beats in both time and error is the front to choose from.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "accuracy/challenge.h"

namespace carom::tools::tune {

/// What an error is. All but truth and gap are told from the reference run.
enum class ErrorKind {
  truth,   ///< what the accuracy scene itself measures, against its closed form: its first metric, in its unit
  pose,    ///< m, rms over bodies and moments of how far they are from where the reference has them
  drift,   ///< m, rms over moments, likewise of the mean of all bodies: also of scenes that are chaotic
  energy,  ///< J, rms over moments, likewise of kinetic energy and that in the world's gravity
  gap      ///< m, rms over moments of the deepest penetration and the widest joint
};
const char* name_of(ErrorKind kind);
const char* unit_of(ErrorKind kind);

/// What a host would set: how often it steps a frame, and dials.
struct Setting {
  int steps_per_frame = 1;
  std::vector<std::pair<std::string, std::string>> dials;  ///< name, value
  std::string text() const;                                ///< "2 steps, solver=auto, substeps=4"
  bool operator==(const Setting&) const = default;
};

/// The settings that are tried first, the library's own among them, and those beside one that is worth a closer look.
std::vector<Setting> first_candidates();
std::vector<Setting> neighbours(const Setting& setting);
/// Finer than any candidate; and the same with half as many steps.
Setting reference_setting();
Setting half_reference_setting();

struct Question {
  const Scene* scene = nullptr;
  const accuracy::Challenge* challenge = nullptr;  ///< of that scene, or null
  Settings settings;                               ///< knobs of the scene
  double seconds = 0;                              ///< simulated
  double frame_rate = 60;                          ///< Hz
  double budget_ms = 2;                            ///< ms of computing a frame
  ErrorKind kind = ErrorKind::pose;
  bool kind_chosen = false;  ///< by the user: else a chaotic scene is judged by its gaps
  int repeats = 5;           ///< of each run on the front
  std::uint32_t threads = 1;
};

/// A scene as it went, at up to 120 moments.
struct Trace {
  std::vector<double> x;        ///< m, [moments][dynamic bodies][3], centres of mass
  std::vector<double> energy;   ///< J, by moment
  std::vector<double> gap;      ///< m, by moment: the largest since the last
  std::vector<double> mass;     ///< kg, by body
  double truth = 0;             ///< of a challenge: its first error
  double ms = 0, worst_ms = 0;  ///< of computing, mean and worst frame
  bool finite = true;           ///< nothing in quarantine
  bool dear = false;            ///< given up: it takes more than it was allowed to
};
/// @param most_ms  of computing a frame, beyond which the run is given up   @throws Error (dials that this scene
/// refuses, ...)
Trace play(Engine& engine, const Question& question, const Setting& setting, double seconds, double most_ms = 1e300);
/// Infinite where a run came to nothing.
double error_of(const Trace& trace, const Trace& reference, ErrorKind kind);

struct Measured {
  Setting setting;
  double error = 0;
  double ms = 0, worst_ms = 0;
  bool is_default = false;
};

struct Answer {
  std::vector<Measured> all;    ///< at full length, by time
  std::vector<Measured> front;  ///< of them those that none beats in both, by time
  int pick = -1;                ///< index in front: the least error within the budget; -1: none is as cheap
  Measured fresh;               ///< the pick, run once more in a new world
  ErrorKind kind = ErrorKind::pose;
  double floor = 0;             ///< how far the reference is from its half: errors below it are not told apart
  bool chaotic = false;         ///< the two references have nothing to do with each other
  double spread = 0;            ///< m, how far apart the two were, rms
  int tried = 0, too_dear = 0;  ///< settings; of them, those that were given up
};

/// @param progress  called with (done, of about so many, what)   @throws Error
Answer search(Engine& engine, const Question& question,
              const std::function<void(int, int, const std::string&)>& progress);

}  // namespace carom::tools::tune

// Which settings err least on a scene within a budget: candidates are run, judged against a reference that is checked
// against half of itself, and what no other beats in both time and error is the front to choose from.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "accuracy/challenge.h"

namespace carom::tools::tune {

/// What an error is. Truth, gap and laws are told without the reference run (but the energy among the laws).
enum class ErrorKind {
  truth,  ///< what the accuracy scene itself measures, against its closed form: its first metric, in its unit
  pose,   ///< m, rms over moments, bodies and their matter of how far it is from where the reference has it: turns, too
  drift,  ///< m, rms over moments, likewise of the mean of all bodies: also of scenes that are chaotic
  energy,  ///< J, rms over moments, likewise of kinetic energy and that in the world's gravity
  gap,     ///< m, rms over moments of the deepest penetration and the widest joint
  laws     ///< m, how far from the laws that hold whatever the motion: see Offences
};
inline constexpr std::size_t kErrorKinds = 6;
const char* name_of(ErrorKind kind);
const char* unit_of(ErrorKind kind);

/// What a run does that no motion may. As lengths they add up, in quadrature, to the error `laws`.
struct Offences {
  double sink = 0;    ///< m, rms over moments of the deepest penetration
  double joints = 0;  ///< m, likewise of the widest joint, its turn at the bodies' size
  double cone = 0;    ///< m/s, likewise of the offence against Coulomb's law; as a length what a frame makes of it
  double energy = 0;  ///< J/kg, rms of how far energy is outside of what two references have; as a length, a height
};

/// What a host would set: how often it steps a frame, and dials.
struct Setting {
  int steps_per_frame = 1;
  std::vector<std::pair<std::string, std::string>> dials;  ///< name, value; "preset", its name, comes first
  std::string text() const;                                ///< "2 steps, solver=auto, substeps=4"
  bool operator==(const Setting&) const = default;
};

/// What a scene has in it, so that a dial matters to it or does not.
struct Participants {
  bool contacts = false, joints = false;
  bool bounces = false;    ///< contacts with a restitution
  bool turns = false;      ///< bodies with unlike moments of inertia that spin
  bool forces = false;     ///< that change along the way: springs, drag, water, fields, damping
  bool may_touch = false;  ///< two colliders are there of which one can move
};

/// The settings that are tried first, the library's own before all others, and those beside one that is worth a closer
/// look: none differs from another in what no body takes part in.   @param few  for scenes that leave little time
std::vector<Setting> first_candidates(const Participants& who, bool few = false);
std::vector<Setting> neighbours(const Setting& setting, const Participants& who);
/// Finer than any candidate; and the same with half as many steps. Of scenes that leave little time, rougher ones.
Setting reference_setting(const Participants& who, bool rough = false);
Setting half_reference_setting(const Participants& who, bool rough = false);

struct Question {
  const Scene* scene = nullptr;
  const accuracy::Challenge* challenge = nullptr;  ///< of that scene, or null
  Settings settings;                               ///< knobs of the scene
  double seconds = 0;                              ///< simulated
  bool seconds_chosen = false;                     ///< by the user: else fewer where `patience` does not allow for all
  double frame_rate = 60;                          ///< Hz
  double budget_ms = 2;                            ///< ms of computing a frame
  double patience = 20;                            ///< s that the search should take; 0: as long as it does
  ErrorKind kind = ErrorKind::pose;
  bool kind_chosen = false;  ///< by the user: else a chaotic scene is judged by its laws
  int repeats = 3;           ///< of each run on the front
  std::uint32_t threads = 1;
};

/// How a body was at the start, and its matter.
struct Matter {
  double mass = 0;                                           ///< kg
  Vec home = Vec::Zero();                                    ///< m, its centre at first
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();          ///< m^2, body axes: mean of r r^T about the centre
  double size() const { return std::sqrt(spread.trace()); }  ///< m, rms radius
};

/// A scene as it went, at up to 120 moments, by at most 400 of its dynamic bodies and particles.
struct Trace {
  std::vector<Matter> matter;        ///< by body
  std::vector<Vec> center;           ///< m, [moments][bodies]
  std::vector<Quat> orientation;     ///< [moments][bodies]
  std::vector<double> energy;        ///< J, by moment
  std::vector<double> sink;          ///< m, by moment: the deepest penetration since the last
  std::vector<double> joints, cone;  ///< m, m/s, by moment
  double weight = 0;                 ///< kg, of all that moves
  double truth = 0;                  ///< of a challenge: its first error
  double ms = 0, worst_ms = 0;       ///< of computing, mean and worst frame
  Participants who;
  bool finite = true;  ///< nothing in quarantine
  bool fell = false;   ///< as a challenge tells
  bool dear = false;   ///< given up: it takes more than it was allowed to
};
/// Runs a scene again and again. What is not judged by a trial is built once and put back to its start: hulls of a mesh
/// take longer to make than the run they are in.
class Player {
 public:
  Player(Engine& engine, const Question& question) : engine_(engine), question_(question) {}
  /// @param most_ms  of computing a frame, beyond which the run is given up
  /// @param nudge  m/s, by which the first body's velocity is another: a run as good as the one without, where all is
  /// chaos
  /// @throws Error (dials that this scene refuses, ...)
  Trace play(const Setting& setting, double seconds, double most_ms = 1e300, double nudge = 0);
  double start_seconds() const {
    return start_seconds_;
  }  ///< s of computing that a run took before its first step, lately

 private:
  Engine& engine_;
  const Question& question_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<Observer> observer_;
  std::vector<char> start_;
  double start_seconds_ = 0;
};

/// Two runs that candidates are compared with.
struct References {
  Trace full, half;
};
/// By ErrorKind; infinite where a run came to nothing, or lets fall what stands in both references.
using Errors = std::array<double, kErrorKinds>;
Errors errors_of(const Trace& trace, const References& references, double frame_rate);
Offences offences_of(const Trace& trace, const References& references);
/// How many bodies stand where they stood at first, by half their size, in both references and not in the run; less as
/// many as the two references differ by.
int fallen(const Trace& trace, const References& references);

struct Measured {
  Setting setting;
  double error = 0;                        ///< of the middle run, where all is chaos
  double least_error = 0, most_error = 0;  ///< among its runs
  double ms = 0, worst_ms = 0;
  bool is_default = false;
  int fallen = 0;  ///< bodies
  Offences offences = {};
  Errors errors = {};
};

struct Result {
  std::vector<Measured> all;    ///< at full length, by time
  std::vector<Measured> front;  ///< of them those that none beats in both, by time
  int pick = -1;                ///< index in front: the least error within the budget; -1: none is as cheap
  Measured fresh;               ///< the pick, run once more in a new world
  ErrorKind kind = ErrorKind::pose;
  Participants who;
  double seconds = 0;           ///< simulated, by which they were judged
  double floor = 0;             ///< how far the reference is from its half: errors below it are not told apart
  bool chaotic = false;         ///< the two references have nothing to do with each other
  double spread = 0;            ///< m, how far apart the two were, rms
  int tried = 0, too_dear = 0;  ///< settings; of them, those that were given up
  int let_fall = 0;             ///< of them, those that let fall what stands
  int left_out = 0;             ///< settings for which no time was left
};

/// Within a factor of two, both: where all is chaos, some run of the one and some run of the other. A pick is the best of what was
/// measured, so its middle run flatters it.
inline bool holds(double said, double found) {
  return (said == 0 && found == 0) || (found <= 2 * said && said <= 2 * found);
}
inline bool errors_agree(const Measured& said, const Measured& found) {
  const bool overlap = said.least_error <= 2 * found.most_error && found.least_error <= 2 * said.most_error;
  return overlap || holds(said.error, found.error);
}

/// @param progress  called with (done, of about so many, what)   @throws Error
Result search(Engine& engine, const Question& question,
              const std::function<void(int, int, const std::string&)>& progress);

}  // namespace carom::tools::tune

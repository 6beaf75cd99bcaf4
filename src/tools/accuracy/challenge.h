// An accuracy scene: a small world with its numbers, a truth to compare with, what is measured, and how small the error
// should be. Written as any host would: through the C ABI.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace carom::tools::accuracy {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// One number that a scene measures.
struct Metric {
  std::string what;  ///< "distance"
  std::string unit;  ///< "m", "" for ratios
  double bound;      ///< the error should not exceed this; kNoBound: told, not judged
};

/// A force on a body's centre of mass for the step that follows.
struct Push {
  std::size_t actor;  ///< index into stage.actors
  Vec force;          ///< N, world
};

/// What a run is compared by where the truth is a finer run: one number, or many.
using Solution = std::vector<double>;

/// Where a body ought to be.
struct TruePose {
  std::size_t actor;                ///< index into stage.actors
  Vec position;                     ///< m, world: origin of the body frame
  std::optional<Quat> orientation;  ///< body -> world, up to a turn about an axis of symmetry; none: it isn't known
};

/// Watches a run and knows the truth. fill() of an accuracy scene returns one of these.
class Trial : public Observer {
 public:
  /// Errors as they stand, one per metric of the challenge, in its order; >= 0, infinite where nothing can be said.
  virtual std::vector<double> errors(const Stage& stage) const = 0;
  /// Nothing that follows can change the errors any more: the run may end.
  virtual bool over() const { return fell(); }
  /// What drives the scene, before each step.
  virtual std::vector<Push> pushes() const { return {}; }
  /// The truth as poses, of scenes that know it so and go their way unaided: no pushes(), and watch() changes nothing.
  /// @param time  s, of the last watch(), or 0 before the first
  virtual std::vector<TruePose> truth(double /*time*/) const { return {}; }
  /// For scenes whose truth is their own run at a much finer step: the quantities that are compared, and the truth for
  /// them.
  virtual Solution solution() const { return {}; }
  virtual void compare_with(const Solution& /*truth*/) {}

  bool fell() const { return fell_at_ >= 0; }
  double fell_at() const { return fell_at_; }  ///< s, or -1
  std::vector<std::string> tell(const Stage& stage) const override;
  bool came_off(const Stage&) const override { return !fell(); }

 protected:
  /// What should stand has collapsed.
  void fall(double time) {
    if (!fell()) fell_at_ = time;
  }

 private:
  double fell_at_ = -1;
};

/// The smallest error that any peer reached: a figure measured for this project, each peer at the best of its settings.
struct Peer {
  double error = -1;    ///< in the unit of the first metric; -1: no figure
  std::string setting;  ///< engine, what was set, and the step where it is not 1/60 s
};

/// A row of the suite.
struct Challenge {
  int number;  ///< of the row; scenes of one row share it
  Scene scene;
  std::string reference;        ///< the truth, in a few words
  std::vector<Metric> metrics;  ///< the first is the one that peers are compared by
  Peer at_60_hz, at_any_step;
  double reference_dt = 0;  ///< s; > 0: the truth is the scene's own solution at this step, same dials
};

/// Every challenge, in the order of the suite.
const std::vector<Challenge>& all_challenges();
/// @throws Error with the nearest name and the list
const Challenge& find_challenge(const std::string& name);

}  // namespace carom::tools::accuracy

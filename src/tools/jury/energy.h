// Energy of bodies that have met: it may change hands, vanish, or come from a paddle, but not from nowhere.
#pragma once

#include "jury/pairs.h"

namespace carom::tools::jury {

double kinetic(const Member& member, const State& state);                    ///< J
double potential(const Member& member, const State& state, double gravity);  ///< J, from the origin

/// A set of bodies that have met, directly or through others, and what it has in excess.
struct Purse {
  double excess = 0;   ///< J: what came from nowhere and has not gone since
  double had = 0;      ///< J: at the start, and given by paddles since
  double lowest = 0;   ///< J: the least potential energy that its bodies had, taken one by one
  double brisk = 0;    ///< kg m/s: the most that masses times speeds were
  double slack = 0;    ///< J: of depths that are borne anyway
  double top = 0;      ///< m: the highest place where a centre began
  double launch = 0;   ///< m/s: the fastest start
  double stirred = 0;  ///< m/s: the fastest surface of a paddle that it met
  double driven = 0;   ///< J: what drives can have given
  double limit(double gravity, double dt) const;  ///< J, of the excess
};

class Energies {
 public:
  Energies(const Case& the_case, double dt, const Frame& start);
  /// @param pairs  near in this step   @param stirred  [members] whether a paddle acts on it, through others too
  /// @param drives  [links] as they are in this step
  void step(const Frame& before, const Frame& now, const std::vector<Near>& pairs, const Sets& islands,
            const std::vector<Drive>& drives, double dt);
  /// A host moved, threw, added or removed bodies: what it gave is theirs.
  void meddled(const Frame& before, const Frame& now);
  bool have_met(std::size_t a, std::size_t b) const { return sets_.of(a) == sets_.of(b); }
  const Purse& purse(std::size_t member) const { return purses_[sets_.of(member)]; }
  double excess_of(std::size_t member) const { return purse(member).excess; }
  /// The set whose excess is largest beside its limit, by one of its bodies: the one that gained most in the last step.
  std::size_t worst() const;
  double limit(std::size_t member) const { return purse(member).limit(the_case_.gravity, dt_); }
  double given() const { return given_; }        ///< J, by paddles in the last step
  double speed_limit(std::size_t member) const;  ///< m/s: README.md, "throws"

 private:
  void merge(std::size_t a, std::size_t b);
  void appear(std::size_t member, const State& state);
  void give_driven(const Frame& before, const Frame& now, const std::vector<Drive>& drives,
                   std::vector<double>& change);
  double paddle_share(const Frame& before, const std::vector<Near>& pairs, const Sets& islands, std::size_t body,
                      double gain);

  const Case& the_case_;
  double dt_, given_ = 0;
  Sets sets_;
  std::vector<Purse> purses_;
  std::vector<double> lowest_;  // J, by member
  std::vector<double> gains_;   // J, by member, in the last step
};

}  // namespace carom::tools::jury

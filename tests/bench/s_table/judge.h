// Judges bodies from their poses and velocities alone, the same way whichever engine put them there.
#pragma once

#include <set>

#include "plan.h"
#include "scenes/tower.h"

namespace carom::bench {

struct Verdict {
  double max_penetration = 0;   // m, over pairs of bodies that no joint holds together
  double mean_penetration = 0;  // m, over the pairs that overlap
  std::size_t overlaps = 0;     // pairs of bodies that overlap
  double mean_energy = 0;       // J, kinetic, a dynamic body
  std::size_t escaped = 0;      // bodies outside the stage's bounds
  std::size_t lost = 0;         // bodies whose state is not finite; in no other number
  double max_gap = 0;           // m, of joints
  double mean_gap = 0;          // m
  tools::Standing standing;     // of what was built
  double flight_error = 0;      // m: how far at most a particle is from its parabola
};

class Judge {
 public:
  explicit Judge(const Plan& plan);
  /// @param states  [actors] in the stage's body frames
  /// @param time    s, since the start
  Verdict judge(const std::vector<BodyState>& states, double time) const;

 private:
  void judge_joints(const std::vector<BodyState>& states, Verdict& verdict) const;
  void judge_overlap(const std::vector<BodyState>& states, std::vector<std::size_t>& order, Verdict& verdict) const;
  double separation(const BodyState& a, carom_shape shape_a, const BodyState& b, carom_shape shape_b) const;

  const Plan& plan_;
  std::set<std::pair<std::size_t, std::size_t>> joined_;  // lesser index first
};

}  // namespace carom::bench

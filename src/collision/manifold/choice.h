// Which four contact points of a pool are kept: those that hold depth and area.
#pragma once

#include <algorithm>

#include "collision/manifold/manifold.h"

namespace carom::collision {

// How much side a point must add to be worth a unit of height over the deepest one (rise per run, 3 degrees): points
// that hover do not carry. Steeper: corners that hover displace ones that touch. Flatter: a tilt of a jitter leaves an
// edge in place of a face.
inline constexpr Real kChoiceTilt = 0.05;

/// Points to choose from: where they are, and how old.
struct Pool {
  static constexpr int kMax = 20;
  int count = 0;
  const ContactPoint* point[kMax];
  std::uint32_t age[kMax];

  void add(const ContactPoint& p, std::uint32_t a) {
    point[count] = &p;
    age[count++] = a;
  }
};

/// The four of a pool of more. All scores are lengths: how far a point widens what is chosen so far (a point, a line, a
/// triangle, seen along the normal), less its height over the deepest divided by kChoiceTilt.
class Choice {
 public:
  /// @param level    m: heights below this are none
  /// @param loyalty  share of the pool's width that a new point (age 0) must add beyond what an old one adds
  Choice(const Frame& a, const Pool& pool, Real level, Real loyalty = 0);

  int operator[](int k) const { return chosen_[k]; }  // ascending: a point keeps its place
  /// Whether the patch has corners beside the four: points that touch, or nearly, and stand out from between them.
  bool leaves_corners() const;

 private:
  Real distance(int i, int j) const;
  Real beside(int i, int j, int k) const;
  void take(int i);
  template <class Score>
  void take_best(const Score& score);

  const Pool& pool_;
  int count_ = 0;
  Real ground_ = 0;                        // m: separation from which heights count
  int chosen_[Manifold::kMaxPoints] = {};  // ascending
  int round_[Manifold::kMaxPoints] = {};   // as they were chosen: the first three counter-clockwise
  bool taken_[Pool::kMax] = {};
  Real x_[Pool::kMax], y_[Pool::kMax], cost_[Pool::kMax];
};

/// Keep a pool's points, or the four of them that `Choice` names.
void store(const Frame& a, const ManifoldSettings& settings, const Pool& pool, Real loyalty, Manifold& manifold);

}  // namespace carom::collision

// Which bodies are near each other in a step, and how deep.
#pragma once

#include "jury/case.h"

namespace carom::tools::jury {

struct Near {
  std::size_t a, b;      ///< a < b
  double separation;     ///< m, negative in overlap
  Vec point_a, point_b;  ///< m, world, nearest each other
};

/// Sets of bodies that merge.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = i;
  }
  std::size_t of(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  /// @return false if they were one already; else a's set is the one that stays
  bool merge(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    if (a == b) return false;
    parent_[b] = a;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// How fast any point of a body moves at most.
double reach_speed(const Member& member, const State& state);
Vec center_of(const Member& member, const State& state);

/// All pairs of which one moves that may touch within a step: nearer than what both go in it, and than 5 mm.
std::vector<Near> near_pairs(carom_engine* engine, const Case& the_case, const Frame& frame, double dt);

/// How deep a body is in the height field: m, negative above it; and whether its centre is below the surface.
struct UnderHills {
  double depth = -1e9;
  bool is_through = false;
  bool is_beyond = false;  ///< of the border: it may roll under them from there
};
UnderHills under_hills(carom_engine* engine, const Case& the_case, std::size_t body, const State& state);

/// Whether the centre of `a` is in `b`, or below it if that is a plane.
bool is_within(carom_engine* engine, const Case& the_case, std::size_t a, std::size_t b, const Frame& frame);

/// Whether the centre of `a` went through all of `b` within a step, from outside to outside.
bool went_through(carom_engine* engine, const Case& the_case, std::size_t a, std::size_t b, const Frame& before,
                  const Frame& now);

}  // namespace carom::tools::jury

// Bodies that shake where they are: seen by the second differences of their places, for what swings smoothly has small
// ones.
#pragma once

#include <array>

#include "jury/case.h"

namespace carom::tools::jury {

/// m, mean over two seconds of the second difference of three points of a body from frame to frame: what swings by 25 mm
/// once a second has 0.3 mm at 60 Hz.
constexpr double kShakes = 5e-4;
constexpr double kPlainShakes = 2e-3;  ///< m: a millimetre to and fro, from frame to frame

class Jitters {
 public:
  void start(std::size_t members) { windows_.assign(members, Window{}); }
  void forget(std::size_t member) { windows_[member] = Window{}; }
  /// @return m, once two seconds in a row have been spent within 3 cm and a tenth of its size; else 0
  double step(std::size_t member, const Member& of, const State& state, double dt);

 private:
  using Points = std::array<Vec, 3>;  ///< the centre, and two beside it: no turn leaves all three in place
  struct Window {
    std::vector<Points> last;     ///< of two frames
    Points first{};               ///< of this second
    double time = 0, shaken = 0;  ///< s, m
    std::size_t steps = 0;
    double before = 0;  ///< m: the mean of the second before
    bool stays = true;
  };
  std::vector<Window> windows_;
};

}  // namespace carom::tools::jury

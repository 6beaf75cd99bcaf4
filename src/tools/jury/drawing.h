// The hand that draws: numbers, shapes, places. One stage and one stream of random numbers for all of a scene.
#pragma once

#include "jury/case.h"
#include "scenes/random.h"

namespace carom::tools::jury {

/// Twice as far with each whole number, straight between: a logarithmic scale without logarithms, alike on every
/// platform.
double octaves(double x);

/// A shape with the names of its plugin and its parameters.
struct Solid {
  std::string plugin;
  std::vector<double> params;
  std::string form;  ///< "rod", "plate" or "lump"
};

class Drawing {
 public:
  Drawing(std::uint64_t seed, Stage& stage) : random(Random(seed).bits()), stage_(stage) {
    static constexpr double kShares[] = {0, 0.15, 0.5};
    thin = kShares[pick(3)], lively = kShares[pick(3)];
  }

  Random random;
  Case scene;
  double thin = 0;    ///< share of rods and plates among the bodies of this scene
  double lively = 0;  ///< share of bodies that are thrown, and of those that spin

  bool chance(double share) { return random.unit() < share; }
  std::size_t pick(std::size_t n) { return static_cast<std::size_t>(random.bits() % n); }
  Solid solid();                  ///< of a random kind, 5 to 80 cm long, no thinner than 1:30
  Part part(const Solid& solid);  ///< with a random density and surface
  Vec support(const Part& part, const Quat& turned, const Vec& direction);  ///< m, from the origin, world axes
  /// The farthest that the shape reaches from its origin.
  double radius(const Part& part);
  /// Whether a shape at a place keeps `gap` from all that was added, but for some members.
  bool is_free(const Part& part, const Vec& position, const Quat& turned, double gap,
               const std::vector<std::size_t>& but = {});
  /// @return its index among members and actors
  std::size_t add(Actor actor);
  Stage& stage() { return stage_; }

 private:
  carom_shape shape_of(const Part& part);
  Stage& stage_;
};

/// @return what it is, for the summary
std::string draw_ground(Drawing& drawing);
void draw_bodies(Drawing& drawing, std::size_t count, bool joined);
void draw_paddle(Drawing& drawing);

constexpr double kPlace = 1.6;  ///< m: bodies start within so much of the middle
constexpr double kGap = 0.004;  ///< m: and so far from each other

}  // namespace carom::tools::jury

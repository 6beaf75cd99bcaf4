// Sequences of poses in which a pair moves a little from frame to frame: for what is kept of a pair between steps.
#pragma once

#include "random_pairs.h"

namespace carom::test {

struct CoherentPair {
  Shape a, b;
  std::vector<Frame> b_in_a;  // [frames]
};

/// A pair that starts at a gap of `gap` and moves steadily: each frame turns B by 0.25 to 1 mrad times `speed` about a
/// random axis through its origin and shifts it by 0.2 mm times `speed` in a random direction.
inline CoherentPair coherent_pair(Random& random, int family_a, int family_b, Real gap, Real speed, int frames) {
  ShapePair start = random_pair(random, family_a, family_b, gap);
  const Vec3 shift = 2e-4 * speed * random.direction(), axis = random.direction();
  const Mat3 turn = exp_map(random.uniform(2.5e-4, 1e-3) * speed * axis).matrix();
  CoherentPair pair{std::move(start.a), std::move(start.b), {start.b_in_a}};
  for (int i = 1; i < frames; ++i) {
    const Frame& last = pair.b_in_a.back();
    // Back onto the rotations in every frame: a product of hundreds leaves them by hundreds of u.
    pair.b_in_a.push_back(Frame(normalized(Quat(Mat3(turn * last.r))).matrix(), last.p + shift));
  }
  return pair;
}

}  // namespace carom::test

// The greedy choice of four: deepest, farthest from it, farthest beside that line, farthest outside that triangle.
#include "collision/manifold/choice.h"

#include "collision/manifold/patch_constants.h"

namespace carom::collision {
namespace {

// Of the pool's width: depths within this are equal, and the choice then stays with the older point. A round base that begins to tip
// has to find the point that it tips over, which is deeper by a share of its tilt.
constexpr Real kSameDepth = 1e-5;

}  // namespace

Choice::Choice(const Frame& a, const Pool& pool, Real level, Real loyalty) : pool_(pool) {
  const Vec3 normal = a.rotate_inverse(pool.point[0]->normal);
  const Vec3 e1 = any_perpendicular(normal), e2 = normal.cross(e1);
  Real deepest = kInfinity, width = 0;
  for (int i = 0; i < pool.count; ++i) {
    x_[i] = e1.dot(pool.point[i]->on_a), y_[i] = e2.dot(pool.point[i]->on_a);
    deepest = std::min(deepest, pool.point[i]->separation);
    width = std::max({width, std::fabs(x_[i] - x_[0]), std::fabs(y_[i] - y_[0])});
  }
  ground_ = std::max(deepest, level);
  for (int i = 0; i < pool.count; ++i)
    cost_[i] = std::max(Real(0), pool.point[i]->separation - ground_) / kChoiceTilt +
               (pool.age[i] == 0 ? loyalty * width : Real(0));
  int first = 0;
  while (pool.point[first]->separation > deepest + kSameDepth * width) ++first;
  take(first);
  take_best([&](int i) { return distance(chosen_[0], i); });
  take_best([&](int i) { return std::fabs(beside(chosen_[0], chosen_[1], i)); });
  if (beside(chosen_[0], chosen_[1], chosen_[2]) < 0) std::swap(chosen_[1], chosen_[2]);  // counter-clockwise
  take_best([&](int i) {
    return -std::min(
        {beside(chosen_[0], chosen_[1], i), beside(chosen_[1], chosen_[2], i), beside(chosen_[2], chosen_[0], i)});
  });
  std::copy(chosen_, chosen_ + Manifold::kMaxPoints, round_);
  std::sort(chosen_, chosen_ + Manifold::kMaxPoints);
}

Real Choice::distance(int i, int j) const {
  return std::sqrt((x_[j] - x_[i]) * (x_[j] - x_[i]) + (y_[j] - y_[i]) * (y_[j] - y_[i]));
}

/// m: how far k lies to the left of the line from i to j.
Real Choice::beside(int i, int j, int k) const {
  const Real dx = x_[j] - x_[i], dy = y_[j] - y_[i], length = std::sqrt(dx * dx + dy * dy);
  return length > 0 ? (dx * (y_[k] - y_[i]) - dy * (x_[k] - x_[i])) / length : 0;
}

bool Choice::leaves_corners() const {
  // The four (three, where the last lies between the others) counter-clockwise.
  int corner[Manifold::kMaxPoints], corners = 0, outside = -1;
  for (int k = 0; k < 3; ++k)
    if (beside(round_[k], round_[(k + 1) % 3], round_[3]) < 0) outside = k;
  for (int k = 0; k < 3; ++k) {
    corner[corners++] = round_[k];
    if (k == outside) corner[corners++] = round_[3];
  }
  const Real width = distance(round_[0], round_[1]);
  for (int i = 0; i < pool_.count; ++i) {
    if (taken_[i] || pool_.point[i]->separation > ground_ + kChoiceTilt * width) continue;
    for (int k = 0; k < corners; ++k)
      if (beside(corner[k], corner[(k + 1) % corners], i) < -kStandsOut.value * width) return true;
  }
  return false;
}

void Choice::take(int i) {
  chosen_[count_++] = i;
  taken_[i] = true;
}

template <class Score>
void Choice::take_best(const Score& score) {
  int best = -1;
  Real most = -kInfinity;
  for (int i = 0; i < pool_.count; ++i) {
    if (taken_[i]) continue;
    const Real s = score(i) - cost_[i];
    if (best < 0 || s > most) best = i, most = s;
  }
  take(best);
}

void store(const Frame& a, const ManifoldSettings& settings, const Pool& pool, Real loyalty, Manifold& manifold) {
  const auto put = [&](int to, int from) {
    manifold.point[to] = *pool.point[from];
    manifold.point[to].age = pool.age[from];
  };
  manifold.count = std::min(pool.count, Manifold::kMaxPoints);
  if (pool.count <= Manifold::kMaxPoints) {
    for (int k = 0; k < pool.count; ++k) put(k, k);
    manifold.has_more_corners = false;
    return;
  }
  const Real level = settings.sunk_alike ? 0 : -kInfinity;
  const Choice choice(a, pool, level, loyalty);
  for (int k = 0; k < Manifold::kMaxPoints; ++k) put(k, choice[k]);
  manifold.has_more_corners = choice.leaves_corners();
}

}  // namespace carom::collision

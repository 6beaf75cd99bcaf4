// Halving bodies by place.
#include "dynamics/solver/regions.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace carom::dynamics {
namespace {

constexpr std::uint32_t kMostLevels = 16;
constexpr std::size_t kPlacedAPart = 512;
constexpr Real kOffset = 0.377;  // cells: what a scene lines up, at round numbers, is not on the edge of a cell

// Three numbers of 21 bits in one.
constexpr int kBits = 21;
constexpr std::uint64_t kMost = (std::uint64_t{1} << kBits) - 1;
std::uint64_t cell_of(Real x, Real cell) {
  constexpr Real kMiddleOfCell = Real(kMost / 2);
  return static_cast<std::uint64_t>(std::clamp(std::floor(x / cell + kOffset) + kMiddleOfCell, Real(0), Real(kMost)));
}
std::uint64_t coordinate_of(std::uint64_t cell, int axis) { return cell >> kBits * axis & kMost; }

using Placed = Regions::Placed;

/// First those of the first half along the longest side, by cells; then by cells along the others, then by number.
void halve_one(Placed* first, Placed* middle, Placed* last) {
  std::uint64_t low[3], high[3];
  for (int k = 0; k < 3; ++k) low[k] = high[k] = coordinate_of(first->cell, k);
  for (const Placed* p = first; p != last; ++p)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], coordinate_of(p->cell, k));
      high[k] = std::max(high[k], coordinate_of(p->cell, k));
    }
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (high[k] - low[k] > high[longest] - low[longest]) longest = k;
  // Turned about so that the longest comes first.
  const int turn = kBits * (2 - longest);
  const auto key = [turn](const Placed& p) {
    constexpr std::uint64_t kAll = (std::uint64_t{1} << 3 * kBits) - 1;
    return (p.cell << turn & kAll) | (turn ? p.cell >> (3 * kBits - turn) : 0);
  };
  std::nth_element(first, middle, last, [&](const Placed& a, const Placed& b) {
    const std::uint64_t i = key(a), j = key(b);
    return i != j ? i < j : a.at < b.at;
  });
}

/// Order and leaves, from cells.
void halve_all(Jobs* jobs, const Array<std::uint32_t>& bodies, Regions& regions) {
  const std::size_t n = bodies.size();
  Array<Placed>& placed = regions.placed;
  placed.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) placed[i] = {regions.cell[i], i};
  const auto begin = [&](std::uint32_t level, std::uint32_t which) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(n) * which >> level);
  };
  const std::uint32_t last = regions.levels - 1, leaves = 1u << last;
  for (std::uint32_t level = 0; level < last; ++level)
    in_parallel(jobs, std::size_t{1} << level, 1, [&](std::uint32_t i) {
      Placed* const all = placed.data();
      halve_one(all + begin(level, i), all + begin(level + 1, 2 * i + 1), all + begin(level, i + 1));
    });
  // Ascending again: each in turn takes the next place of its leaf.
  regions.next.resize(leaves);
  for (std::uint32_t i = 0; i < leaves; ++i) {
    regions.next[i] = begin(last, i);
    for (std::uint32_t k = begin(last, i); k < begin(last, i + 1); ++k) regions.leaf[placed[k].at] = i;
  }
  for (std::uint32_t i = 0; i < n; ++i) regions.order[regions.next[regions.leaf[i]]++] = bodies[i];
  for (std::uint32_t i = 0; i < leaves; ++i)
    std::fill(regions.leaf.begin() + begin(last, i), regions.leaf.begin() + begin(last, i + 1), leaves + i);
}

}  // namespace

std::uint32_t levels_for(std::size_t bodies) {
  std::uint32_t levels = 1;
  while (levels < kMostLevels && bodies >> (levels - 1) > kBodiesARegion) ++levels;
  return levels;
}

bool halve(const Array<Vec3>& x, Real cell, Jobs* jobs, const Array<std::uint32_t>& bodies, Regions& regions) {
  const std::size_t n = bodies.size();
  std::atomic<bool> same{bodies == regions.given};
  regions.levels = levels_for(n);
  regions.cell.resize(regions.levels > 1 ? n : 0);
  in_parallel(jobs, regions.cell.size(), kPlacedAPart, [&](std::uint32_t i) {
    const Vec3& at = x[bodies[i]];
    const std::uint64_t now =
        cell_of(at.z(), cell) << 2 * kBits | cell_of(at.y(), cell) << kBits | cell_of(at.x(), cell);
    if (regions.cell[i] != now) same.store(false, std::memory_order_relaxed);
    regions.cell[i] = now;
  });
  if (same.load(std::memory_order_relaxed)) return true;
  regions.given.clear(), regions.given.reserve(n);  // until all is done: an allocation may fail
  regions.order = bodies;
  regions.leaf.assign(n, 1);
  if (regions.levels > 1) halve_all(jobs, bodies, regions);
  regions.given = bodies;
  return false;
}

}  // namespace carom::dynamics

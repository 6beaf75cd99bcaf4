// Regions: the bodies of a step halved by place, again and again, until few are left in each.
//
// A row belongs to the smallest region that has both its bodies: nearly all to the smallest that there are, a few
// across the cut of a larger one. So regions of one size share no body, and a sweep goes through the whole's rows, then
// through all halves at once, all quarters at once, ...: a thread has a region's rows to itself, and finds its bodies
// where it left them a sweep ago. A step of few bodies has one region, the whole.
//
// Which way a cut goes depends on the cells of a coarse grid that bodies are in, not on their places to the bit: what
// rests keeps its region though it trembles.
#pragma once

#include <bit>

#include "core/jobs.h"
#include "core/memory.h"
#include "core/vec.h"

namespace carom::dynamics {

/// A region has this many bodies at most. Fewer: lanes are left empty, and rows cross cuts; more: too few regions for
/// threads to share, and more rows than a thread's cache holds.
inline constexpr std::size_t kBodiesARegion = 512;

struct Regions {
  explicit Regions(Memory* m) : order(m), leaf(m), given(m), cell(m), placed(m), next(m) {}

  /// The whole is region 1, the halves of region r are 2 r and 2 r + 1: 2^l of level l.
  std::uint32_t levels = 1;
  std::uint32_t end() const { return 1u << levels; }
  static std::uint32_t level_of(std::uint32_t region) { return static_cast<std::uint32_t>(std::bit_width(region)) - 1; }

  Array<std::uint32_t> order;  // bodies in the order of their smallest regions, ascending within each
  Array<std::uint32_t> leaf;   // that region, by place in `order`
  /// The smallest that has both; of smallest ones.
  static std::uint32_t of(std::uint32_t a, std::uint32_t b) { return a >> std::bit_width(a ^ b); }

  // what they were made from
  Array<std::uint32_t> given;
  Array<std::uint64_t> cell;  // of the grid, three numbers in one, by place in `given`

  // scratch
  struct Placed {
    std::uint64_t cell;
    std::uint32_t at;  // in `given`
  };
  Array<Placed> placed;
  Array<std::uint32_t> next;
};

/// How many levels there are for so many bodies.
std::uint32_t levels_for(std::size_t bodies);

/// Halve them. Allocates.
/// @param x       m, by body slot   @param cell  m, about the size of a body: of the grid
/// @param bodies  slots, ascending
/// @return        whether all are where they were, so that nothing has changed
bool halve(const Array<Vec3>& x, Real cell, Jobs* jobs, const Array<std::uint32_t>& bodies, Regions& regions);

}  // namespace carom::dynamics

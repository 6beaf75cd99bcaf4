// The convex hull of shapes that are placed and scaled, and rounded where it has a radius: one shape made of others.
//
//   K = hull of { R S x + t : x in part }, swollen by `radius`          per part: R turn, S scale, t position
//   support of one part along d:  R S s(S R^T d) + t                    s: the part's own support function
//
// A shape at two poses gives its sweep between them; one part with a scale, a scaled shape; one with a radius, a
// rounded one.
#pragma once

#include <span>

#include "collision/shape.h"

namespace carom::collision {

/// Immutable once made; belongs to a Shape. The shapes of its parts outlive it.
struct HullOf {
  static constexpr std::size_t kNumbers = 10;         // of a part: position, orientation (x, y, z, w), scale
  static constexpr int kMostDepth = 8;                // hulls of hulls; their calls nest, and hosts have small stacks
  static constexpr std::size_t kMostParts = 4096;     // with those of inner hulls: a support call calls that many
  static constexpr std::size_t kMostCorners = 65536;  // of a polytope made of them; beyond, its parts are asked

  struct Part {
    const Shape* shape;
    Mat3 into;         // S R^T: a direction as the part sees it
    Mat3 out;          // R S: its transpose, for points
    Vec3 position;     // m
    Real round_inner;  // m: core radius of a part that is scaled unevenly, in the part's frame: an ellipsoid here
    Real round_outer;  // m: of others, beyond what all parts have in common
  };

  explicit HullOf(Memory* memory) : parts(memory), numbers(memory) {}
  Array<Part> parts;
  Array<double> numbers;  // radius, then kNumbers of each part, as they were given
  int depth = 1;
  std::size_t calls = 0;  // of support functions that one of its own makes, hulls in hulls included
};

/// Make of `shape` the hull of parts: its support function, core radius, and form where all parts have corners only. Bounds
/// and mass are still to be derived.
/// @param numbers  [1 + 10 n] as HullOf::numbers; orientations unit, scales not zero
void make_hull_of(std::span<const Shape* const> parts, std::span<const double> numbers, Memory* memory, Shape& shape);

}  // namespace carom::collision

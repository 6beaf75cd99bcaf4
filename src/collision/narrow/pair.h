// Double dispatch: which routine knows a pair of declared shapes, and in which order it wants them.
#pragma once

#include "collision/manifold/manifold.h"
#include "collision/shape.h"
#include "core/pose.h"

namespace carom::collision {

/// Contact points of two declared shapes, every point of the patch.
/// @param b_in_a  pose of B in A's frame
/// @param reach   m: points farther apart than this are left out; kInfinity: none is, and ties are broken by depth
///                alone; a routine that is not exact apart may then say nothing of shapes apart, but nothing false
/// @param found   appended to, at most Candidates::kMax points; normal in A's FRAME, from A to B (the caller turns it).
///                The deepest point attains the signed distance of the pair.
/// @accuracy      16 u M, M the size of the operands, and PairEntry::accuracy times M
using PairRoutine = void (*)(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found);

struct PairEntry {
  PairRoutine routine = nullptr;  // null: the generic path
  bool swapped = false;           // call it with B first
  bool exact_apart = true;        // false: of some pairs apart it does not know the distance, and says nothing
  Real accuracy = 0;              // error of its depth beyond rounding, as a share of the pair's size
};

/// The routine for two forms; an entry without routine where there is none.
const PairEntry& pair_entry(Form a, Form b);

/// Contact points of a half-space and a shape without closed form, by its support function.
/// @param probe   ask in four directions tilted about the normal, too, where the normal's own support point is in reach
/// @param lean    if not 0: of four more directions, the tangent by which they are tilted, @see leaning_tilt
/// @return        false if the support function misbehaved (fault is filled, found is left alone)
/// @param calls   raised by the number of support calls
bool half_space_by_support(const Shape& half_space, const Shape& b, const Frame& b_in_a, Real reach, bool probe,
                           Real lean, Candidates& found, std::uint64_t& calls, SupportFault& fault);

/// The tangent of the tilt along which lies whatever of a shape that leans may come down to a plane within the step:
/// an end that is within reach leans by less, of a shape that is a quarter as wide as its radius too. What rolls turns
/// by half of that at most, so a point of its round side is not met before it comes down.
inline Real leaning_tilt(const Shape& shape, Real reach) {
  return std::min(2 * reach / shape.bounding_radius, Real(1));
}

// The routines, by file.
void contact_sphere_sphere(const Shape&, const Shape&, const Frame&, Real, Candidates&);  // pair_sphere.cpp
void contact_box_sphere(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_capsule_sphere(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_capsule_capsule(const Shape&, const Shape&, const Frame&, Real, Candidates&);    // pair_capsule.cpp
void contact_box_capsule(const Shape&, const Shape&, const Frame&, Real, Candidates&);        // pair_box_capsule.cpp
void contact_box_box(const Shape&, const Shape&, const Frame&, Real, Candidates&);            // pair_box_box.cpp
void contact_half_space_sphere(const Shape&, const Shape&, const Frame&, Real, Candidates&);  // pair_half_space.cpp
void contact_half_space_capsule(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_half_space_box(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_half_space_cylinder(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_half_space_cone(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_half_space_ellipsoid(const Shape&, const Shape&, const Frame&, Real, Candidates&);
void contact_half_space_polytope(const Shape&, const Shape&, const Frame&, Real, Candidates&);

/// Append a point, if it is near enough (a separation that is not a number never is) and there is space.
inline void add_contact(Candidates& found, Real reach, const Vec3& on_a, const Vec3& on_b, const Vec3& normal,
                        Real separation, std::uint32_t feature) {
  if (!(separation <= reach) || found.count == Candidates::kMax) return;
  ContactPoint& p = found.add();
  p.on_a = on_a;
  p.on_b = on_b;
  p.normal = normal;
  p.separation = separation;
  p.feature = feature;
  p.age = 0;
}

}  // namespace carom::collision

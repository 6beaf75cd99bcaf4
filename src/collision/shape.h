// A shape as the collision floor sees it: a support function with parameters, and what was derived and verified from it.
#pragma once

#include <cstdint>
#include <span>

#include "collision/farthest_vertex.h"
#include "collision/hull_faces.h"
#include "core/memory.h"
#include "core/vec.h"

namespace carom::collision {

struct Scenery;  // scenery/scenery.h: many triangles
struct HullOf;   // hull_of.h: parts that are shapes

/// Support function of a bounded convex set, the only code a shape brings. Same type as carom_support_fn in plugin.h.
using SupportFn = std::int32_t (*)(void* user, const double* params, std::uint64_t count, const double dir[3],
                                   double out[3]);

/// Closed forms, verified against the support function. Numbered as CAROM_FORM_* up to ellipsoid.
enum class Form : std::uint32_t {
  none,
  sphere,
  capsule,
  box,
  polytope,
  cylinder,
  cone,
  ellipsoid,
  half_space,
  scenery,
  count
};

struct Aabb {
  Vec3 lo = Vec3::constant(kInfinity);
  Vec3 hi = Vec3::constant(-kInfinity);
  bool overlaps(const Aabb& o) const {
    return lo.x() <= o.hi.x() && o.lo.x() <= hi.x() && lo.y() <= o.hi.y() && o.lo.y() <= hi.y() && lo.z() <= o.hi.z() &&
           o.lo.z() <= hi.z();
  }
};

/// Volume, centre and inertia at unit density, each with a rigorous bound of its error.
struct MassProperties {
  Real volume = 0, volume_min = 0, volume_max = 0;  // m^3
  Vec3 centroid = Vec3::zero();                     // m, shape frame
  Real centroid_error = 0;                          // m
  Mat3 inertia = Mat3::zero();                      // m^5, about the centroid, shape axes
  Real inertia_error = 0;                           // m^5, bound of the spectral norm
  bool exact = false;                               // from a verified closed form
};

/// Immutable once made, shared between worlds and threads.
struct Shape {
  explicit Shape(Memory* memory) : params(memory), farthest(memory), faces(memory) {}

  Form form = Form::none;
  bool host_thread = false;     // support may be called on the stepping thread only
  SupportFn support = nullptr;  // of the core; null for the half-space
  void* user = nullptr;         // whatever it wants to be handed
  Array<double> params;         // [n] owned here, immutable, what support is given
  Real core_radius = 0;         // m: the shape is the core swollen by this
  Real bounding_radius = 0;     // m, about the shape's origin, core radius included
  Aabb bounds;                  // m, shape frame, exact to rounding, core radius included
  MassProperties mass;

  // Numbers of the closed form, so that no pair routine digs in params:
  Real radius = 0;                   // sphere, capsule, cylinder, cone (base)
  Real half_height = 0;              // capsule (of the core segment), cylinder, cone; along y
  Vec3 half = Vec3::zero();          // box half extents; ellipsoid radii
  std::span<const double> vertices;  // polytope: [3k] x,y,z, inside params
  FarthestVertex farthest;           // polytope: of these; empty until built
  Vec3 normal = Vec3::unit_y();      // half-space { x : normal . x <= offset }, unit
  Real offset = 0;                   // m

  HullFaces faces;  // polytope, box: for exact clipping; may be empty

  std::shared_ptr<const Scenery> scenery;  // Form::scenery: its triangles. It has no support function and no volume

  std::shared_ptr<const HullOf> hull_of;  // null but of a hull of other shapes: those

  std::uint64_t handle = 0;  // the ABI's name for it, for reports
};

/// Largest number of a shape that enters its distances, so that rounding goes with it. @return m
inline Real extent(const Shape& s) { return s.form == Form::half_space ? std::fabs(s.offset) : s.bounding_radius; }

inline bool is_scenery(const Shape& s) { return s.form == Form::scenery; }

/// Whether it is neither known to be a polytope, nor a half-space or scenery.
inline bool is_curved(const Shape& s) {
  return s.form != Form::box && s.form != Form::polytope && s.form != Form::half_space && !is_scenery(s);
}

/// m: the least side of its bounds; infinite of what has no far side.
inline Real thickness(const Shape& s) { return is_scenery(s) ? kInfinity : (s.bounds.hi - s.bounds.lo).min_entry(); }

/// What a misbehaving support function did; kept bit for bit as evidence. Kinds as CAROM_FAULT_*.
struct SupportFault {
  enum Kind : std::uint32_t { none = 0, returned = 1, not_finite = 2, outside = 3, not_support = 4 };
  Kind kind = none;
  const Shape* shape = nullptr;
  double dir[3] = {0, 0, 0};
  double out[3] = {0, 0, 0};
};

}  // namespace carom::collision

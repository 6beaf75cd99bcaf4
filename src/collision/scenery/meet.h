// Contacts of a convex shape with the triangles of a surface that are near it.
#pragma once

#include <optional>

#include "collision/manifold/patch.h"
#include "collision/narrow/narrow_phase.h"
#include "collision/scenery/triangle_shape.h"

namespace carom::collision {

/// A convex shape and scenery, each where it stands.
struct SceneryPair {
  const Shape& scenery;
  const Shape& convex;        // no half-space, no scenery
  const Frame& frame;         // scenery -> world
  const Frame& convex_frame;  // shape -> world
};

/// Points of triangles that look the same way.
struct SceneryPatch {
  Vec3 normal;  // unit, world, from the scenery to the shape
  bool firm;    // all its points are of flat faces along one normal, @see PatchMemory
  int count;
  ContactPoint point[PatchPoints::kMax];  // A is the scenery, B the shape
};

/// Finds the contacts of one pair at a time. Allocates only where a pair has more of something than any before.
class SceneryPairFinder {
 public:
  explicit SceneryPairFinder(Memory* memory);

  /// @param reach   m: what is farther apart makes no contact
  /// @return        false if the support function misbehaved: fault is filled, there are no patches
  /// @accuracy      separations and points of flat shapes to rounding; a triangle's own normal to rounding; at boundary
  ///                edges and ridges as the query's tolerance says
  /// @oracle        tests/unit/collision/scenery/test_meet, tests/oracle/test_scenery
  bool find(const SceneryPair& pair, const NarrowSettings& settings, Real reach, NarrowReport& report,
            SupportFault& fault);
  const Array<SceneryPatch>& patches() const { return patches_; }

 private:
  struct Found {
    ContactPoint point;
    std::uint32_t patch;
    bool firm;
    bool is_asked_for = false;  // stands beside a triangle, of a shape whose form is not declared
  };
  /// What is asked of each triangle alike.
  struct Terms {
    const SceneryPair& pair;
    const Frame& convex_in_scenery;
    Vec3 centre;  // m, scenery's frame: of the shape
    const NarrowSettings& settings;
    Real reach;  // m
    NarrowReport& report;
    SupportFault& fault;
  };
  enum class Ground { none, below, above };  // of a height field, beside the shape's centre
  Ground look_down(const Terms& t, Triangle& under) const;
  bool meet(const Terms& t, const Triangle& triangle);
  static bool has_routine(const Terms& t);
  bool stand(const Terms& t, const Triangle& triangle);
  /// Make points of those that stand where a triangle counts. @param counts  says so of a point, m, scenery's frame
  template <class F>
  void add_standing(const Terms& t, F&& counts) {
    PatchPoints points;
    for (const ContactPoint* p = standing_.point; p < standing_.point + standing_.count; ++p)
      if (counts(p->on_a + p->separation * plane_.normal)) points.point[points.count++] = *p;
    const Form form = t.pair.convex.form;
    const std::size_t first = found_.size();
    add(points, Vec3::zero(), form == Form::box || form == Form::polytope, t.reach);
    for (std::size_t i = first; i < found_.size(); ++i) found_[i].is_asked_for = !has_routine(t);
  }
  void drop_round_sides(Real apart);
  bool lift(const Terms& t, const Triangle& triangle);
  void add(const PatchPoints& points, const Vec3& origin, bool firm, Real reach);
  void gather(const Frame& frame, Real same);
  void choose(std::uint32_t k, const Frame& frame, Real tilt, Real same, SceneryPatch& patch) const;

  TriangleShape shape_;
  Shape plane_;          // of a triangle
  Candidates standing_;  // points of the shape over that plane or under it
  Array<std::uint32_t> near_;
  Array<Found> found_;
  std::optional<ContactPoint> left_;  // of triangles with edges that gave no point, the least deep
  Array<Vec3> normals_;               // of patches
  Array<SceneryPatch> patches_;
};

}  // namespace carom::collision

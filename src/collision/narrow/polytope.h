// The polytope that EPA grows: triangles with neighbours in fixed arenas, the search for the face nearest to the
// origin, and the walk around the horizon seen from a new point.
#pragma once

#include "collision/narrow/epa.h"
#include "collision/narrow/fan.h"

namespace carom::collision {

/// A closed mesh of triangles around the origin, wound outwards. Lives on the stack, allocates nothing.
///
/// What it proves needs no convexity: if every face's plane is beyond distance d from the origin, so is every triangle,
/// and a closed mesh that winds around the origin without coming nearer than d holds the ball of radius d. Face
/// distances are therefore taken as the smallest of the three vertices' offsets along the computed normal, true for a
/// badly tilted one too.
class Polytope {
 public:
  /// The other side of an edge: 4 times the face there, plus which of its edges it is.
  using Link = std::int32_t;

  /// A cache line.
  struct alignas(64) Face {
    Vec3 normal;             // unit, outwards
    Real offset;             // smallest of normal . vertex; the plane is at least as far from the origin
    std::int32_t vertex[3];  // counter-clockwise from outside
    Link across[3];          // edge (vertex[e], vertex[e + 1])
    bool alive;
  };

  /// @param rounding  what a height must exceed to count, scaled lengths
  explicit Polytope(Real rounding) : rounding_(rounding) {}

  /// Start from a tetrahedron, either orientation.
  void start(const DifferencePoint* four);
  /// The face nearest to the origin; which one of equals, depends on slots alone.
  int nearest() const;
  /// Where the next point is to be written.
  DifferencePoint& next() { return points_[points_used_]; }
  /// Add the next point, which lies beyond a face: replace the faces it sees by a fan to it.
  /// @return false if the horizon is not one loop (rounding), or capacity is out: the mesh is as it was, but stop
  bool add(int face);

  /// The face nearest to the origin among those that the last add() made; -1 before the first.
  int newest() const;

  bool has(const Vec3& w) const;
  const Face& face(int i) const { return faces_[i]; }
  int faces() const { return faces_used_; }  // slots, alive or not
  const DifferencePoint& point(int i) const { return points_[i]; }

 private:
  static constexpr int kPoints = kMaxEpaIterations + 4;
  static constexpr int kFaces = 2 * kPoints;
  static constexpr int kLanes = 4;

  void set(int slot, int i, int j, int k);
  void place(Face& face) const;
  Vec3 careful_normal(const Vec3& a, const Vec3& b, const Vec3& c) const;
  void join(Link one, Link other);
  bool open(int face, const Vec3& w);
  void remove(int face);

  Real rounding_;
  int points_used_ = 0, faces_used_ = 0, free_used_ = 0, horizon_used_ = 0;
  int fan_ = -1;                         // a face that the last add() made
  DifferencePoint points_[kPoints + 1];  // and one that is not added any more
  Face faces_[kFaces];
  Real offset_[kFaces + kLanes];  // of faces, side by side for the search; infinite where none is alive
  std::int32_t free_[kFaces + 1];
  Link horizon_[kFaces];           // edges of faces that stay, in the order of the loop
  std::int32_t loop_[kFaces + 1];  // vertices between them, the first again at the end
  Horizon<kFaces> loop_at_;        // where they lie
};

}  // namespace carom::collision

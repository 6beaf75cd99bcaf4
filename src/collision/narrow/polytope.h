// The polytope that EPA grows: triangles with neighbours in fixed arenas, a heap of the faces nearest to the origin,
// and the walk around the horizon seen from a new point.
#pragma once

#include "collision/narrow/epa.h"
#include "collision/narrow/fan.h"

namespace carom {

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
    std::uint32_t stamp;     // odd: alive; tells a reused slot from what an old heap entry meant
    bool alive() const { return stamp & 1; }
  };

  /// @param rounding  what a height must exceed to count, scaled lengths
  explicit Polytope(Real rounding) : rounding_(rounding) {}

  /// Start from a tetrahedron, either orientation.
  void start(const DifferencePoint* four, Real keep_below);
  /// Take the alive face nearest to the origin off the heap; -1 if none is left.
  int pop();
  /// Add a point beyond a face (just popped): replace the faces it sees by a fan to it. Faces with offset above
  /// keep_below can't be the nearest any more and stay off the heap.
  /// @return false if the horizon is not one loop (rounding), or room is out: the mesh is as it was, but stop
  bool add(int face, const DifferencePoint& point, Real keep_below);

  /// The face nearest to the origin among those that the last add() made; -1 before the first.
  int newest() const { return newest_; }

  bool has(const Vec3& w) const;
  const Face& face(int i) const { return faces_[i]; }
  int faces() const { return faces_used_; }  // slots, alive or not
  const DifferencePoint& point(int i) const { return points_[i]; }

 private:
  static constexpr int kPoints = kMaxEpaIterations + 4;
  static constexpr int kFaces = 2 * kPoints;
  static constexpr int kHeap = 2 * kFaces;

  struct Entry {
    Real offset;
    std::int32_t face;
    std::uint32_t stamp;
  };

  int new_face(int i, int j, int k);
  void place(Face& face) const;
  Vec3 careful_normal(const Vec3& a, const Vec3& b, const Vec3& c) const;
  void unfold(int from, const Vec3& apex, Fan& fan) const;
  void join(Link one, Link other);
  void push(int face);
  void sift_down(int at);
  void refill();
  bool open(int face, const Vec3& w);
  void remove(int face);

  Real rounding_;
  int points_used_ = 0, faces_used_ = 0, free_used_ = 0, heap_used_ = 0, horizon_used_ = 0, newest_ = -1;
  DifferencePoint points_[kPoints];
  Face faces_[kFaces];
  std::int32_t free_[kFaces];
  Entry heap_[kHeap + 1];         // and one to compare with
  Link horizon_[kFaces];          // edges of faces that stay, in the order of the loop
  std::int32_t rim_[kFaces + 1];  // vertices between them, the first again at the end
};

}  // namespace carom

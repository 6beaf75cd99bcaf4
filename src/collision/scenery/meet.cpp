// Triangle by triangle: along its own normal where that is enough, by a query where an edge may be met; what the
// surface around contradicts is not heard. README.md walks through the steps.
#include "collision/scenery/meet.h"

#include <algorithm>
#include <array>

#include "collision/cast/overlap.h"
#include "collision/narrow/rounding.h"
#include "collision/support.h"
#include "collision/volume.h"

namespace carom::collision {
namespace {

// Sine of an angle by which a surface must turn down at a side to be an edge there. Flatter, it goes on level to
// rounding of its corners, and the gap between two normals is narrower than the tolerance of an outline.
constexpr Real kCrease = 1e-8;
// Sine of what a normal may be off and still count as allowed by a surface: rounding, and far more.
constexpr Real kMeetLevel = 1e-7;
// Cosine of 0.05 rad: triangles that look the same way within this are one patch, each point with its own normal.
constexpr Real kSameWay = 0.99875;
// More patches than this one shape is not given: the nearest of them takes what would begin another.
constexpr std::size_t kMostPatches = 16;
// How far over a concave edge a triangle is taken to go on: the reach of contacts, and this share of the shape's radius
// for what it may sink in; and at a sharp corner at most so many times that.
constexpr Real kEdgeShare = 0.05, kFarthestEdge = 4;
// Which points of many stay: the extreme ones along directions tilted from the normal by this (as in
// narrow/pair_half_space.cpp), at azimuths turned off every symmetry.
constexpr Real kTriangleTilt = 0.05;
constexpr Real kLeaningTilt = 1;  // of a shape that leans: as far up as out
constexpr Real kBeside = 0.25;    // of a radius: a shape that leans has another end if it is as wide
constexpr int kWays = 12;
constexpr Real kAzimuth[kWays][2] = {
    {0.9950041652780258, 0.09983341664682815},   {0.8117821756786866, 0.5839603576017622},
    {0.41104380767626354, 0.9116155923255147},   {-0.09983341664682804, 0.9950041652780258},
    {-0.5839603576017619, 0.8117821756786868},   {-0.9116155923255144, 0.411043807676264},
    {-0.9950041652780258, -0.09983341664682793}, {-0.8117821756786869, -0.5839603576017618},
    {-0.4110438076762633, -0.9116155923255148},  {0.09983341664682745, -0.9950041652780259},
    {0.5839603576017613, -0.8117821756786872},   {0.9116155923255146, -0.41104380767626376}};

/// What lies beyond the sides of a triangle, as seen along its normal.
struct Sides {
  std::array<Vec3, 3> out;      // unit, in the triangle's plane, away from it
  std::array<Vec3, 3> down;     // unit, the way the surface goes on there, square to the side; zero at a boundary
  std::array<bool, 3> edge;     // it turns down there, or ends
  std::array<bool, 3> concave;  // it turns up there, towards the shape
  std::array<bool, 3> wall;     // it turns up there, and the shape is behind what does
  bool any = false;             // edges or walls

  /// @param centre  m, of the shape: a concave edge counts if the shape is on this side of what lies beyond it, too
  Sides(const Triangle& p, const Vec3& centre) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 along = (p.corner[(i + 1) % 3] - p.corner[i]).normalized();
      out[i] = along.cross(p.normal);
      down[i] = Vec3::zero();
      edge[i] = true, concave[i] = wall[i] = false;
      if (!p.boundary[i]) {
        const Vec3 to = p.far[i] - p.corner[i], square = to - to.dot(along) * along;
        down[i] = square.normalized();
        const Real rises = down[i].dot(p.normal);
        // Level and back over itself: a blade.
        edge[i] = rises < -kCrease || (rises <= kCrease && down[i].dot(out[i]) < 0);
        const Vec3 beyond = down[i].cross(along), inner = beyond.dot(out[i]) < 0 ? beyond : Vec3(-beyond);
        const bool before = inner.dot(centre - p.corner[i]) >= 0;
        concave[i] = rises > kCrease && before, wall[i] = rises > kCrease && !before;
      }
      any |= edge[i] || wall[i];
    }
  }
  /// m, how far within the sides a place above the plane is; negative outside.
  Real inset(const std::array<Vec3, 3>& corner, const Vec3& x) const {
    Real least = kInfinity;
    for (std::size_t i = 0; i < 3; ++i) least = std::min(least, -out[i].dot(x - corner[i]));
    return least;
  }
};

/// A triangle's corners, moved out over its concave edges: beyond one, what is below its plane is below the surface as
/// well, and a corner of a shape that is pushed into the triangle beyond by a little still stands on this one. Where a
/// corner has something beyond which the shape is, the triangle ends there.
/// @param centre  m, of the shape   @param by  m
std::array<Vec3, 3> over_concave_edges(const Scenery& scenery, const Triangle& triangle, const Sides& sides,
                                       const Vec3& centre, Real by) {
  std::array<Vec3, 3> corner = triangle.corner;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t before = (k + 2) % 3;
    const Real d1 = sides.concave[before] ? by : 0, d2 = sides.concave[k] ? by : 0;
    if ((d1 == 0 && d2 == 0) ||
        !scenery.is_before_all_around(triangle, own_corner(triangle, static_cast<int>(k)), centre))
      continue;
    const Vec3 &o1 = sides.out[before], &o2 = sides.out[k];
    const Real c = o1.dot(o2);
    const Vec3 way = ((d1 - d2 * c) * o1 + (d2 - d1 * c) * o2) / (1 - c * c);
    const Real length = way.norm();
    corner[k] += length > kFarthestEdge * by ? Vec3(kFarthestEdge * by / length * way) : way;
  }
  return corner;
}

/// What the surface makes of a normal that a query found at a place of a triangle.
///   heard      it lies below the plane through the place that is square to n: it can push that way there
///   neighbours the surface turns down at a side there, and n leans farther over it than the triangle beyond does, or
///   it
///              turns up between triangle and shape: whatever is met there, the triangle beyond or another one meets it
///   own        no more than the way out of this triangle alone: the triangle's own normal is meant
enum class Ruling { own, heard, neighbours };
Ruling judge(const Scenery& scenery, const Triangle& triangle, const Sides& sides, const Vec3& place, const Vec3& n,
             Real near) {
  std::array<bool, 3> at{};
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) count += at[i] = -sides.out[i].dot(place - triangle.corner[i]) <= near;
  if (count == 0) return Ruling::own;
  for (std::size_t i = 0; i < 3; ++i)
    if (at[i] &&
        (sides.edge[i] ? sides.down[i].dot(n) > kMeetLevel : sides.wall[i] && sides.out[i].dot(n) > kMeetLevel))
      return Ruling::neighbours;
  if (n.dot(triangle.normal) < -kMeetLevel) return Ruling::own;
  if (count == 1) {
    const auto i = static_cast<std::size_t>(at[0] ? 0 : at[1] ? 1 : 2);
    return sides.edge[i] && -sides.out[i].dot(n) <= kMeetLevel ? Ruling::heard : Ruling::own;
  }
  std::size_t corner = 0;  // of three at once: a triangle smaller than the query can tell
  for (std::size_t k = 1; k < 3; ++k)
    if ((place - triangle.corner[k]).squared_norm() < (place - triangle.corner[corner]).squared_norm()) corner = k;
  return scenery.falls_away_around(triangle, own_corner(triangle, static_cast<int>(corner)), n) ? Ruling::heard
                                                                                                : Ruling::own;
}

}  // namespace

SceneryPairFinder::SceneryPairFinder(Memory* memory)
    : shape_(memory), plane_(memory), near_(memory), found_(memory), normals_(memory), patches_(memory) {}

bool SceneryPairFinder::find(const SceneryPair& pair, const NarrowSettings& settings, Real reach, NarrowReport& report,
                             SupportFault& fault) {
  near_.clear(), found_.clear(), normals_.clear(), patches_.clear(), left_.reset();
  const Scenery& scenery = *pair.scenery.scenery;
  const Frame convex_in_scenery = relative(pair.frame, pair.convex_frame);
  if (!usable(convex_in_scenery)) return true;
  Aabb box = world_bounds(pair.convex, convex_in_scenery.r, convex_in_scenery.p, fault);
  if (fault.kind != SupportFault::none) return false;
  box.lo -= Vec3::constant(reach), box.hi += Vec3::constant(reach);
  const Vec3 centre = convex_in_scenery.apply(pair.convex.mass.centroid);
  const Terms t{pair, convex_in_scenery, centre, settings, reach, report, fault};
  Triangle under;
  const Ground ground = look_down(t, under);
  if (ground == Ground::below) box.lo.y() = scenery.bounds.lo.y(), box.hi.y() = scenery.bounds.hi.y();
  scenery.each_near(box, [&](std::uint32_t index) { near_.push_back(index); });
  std::sort(near_.begin(), near_.end());  // who moves meets the same triangles in the same order
  for (const std::uint32_t index : near_) {
    Triangle triangle;
    if (!scenery.triangle(index, triangle)) continue;
    if (ground != Ground::none) {
      if (!stand(t, triangle)) return false;
      add_standing(t, [&](const Vec3& point) { return scenery.is_over(index, point); });
    }
    if (ground == Ground::below) {
      if (index == under.index && !lift(t, triangle)) return false;
    } else if (face(scenery, centre, triangle) && !meet(t, triangle)) {
      return false;
    }
  }
  if (!has_routine(t)) drop_round_sides(kBeside * pair.convex.bounding_radius);
  // Deep at a corner, each triangle by itself may be left by a way that the others close. Then the least deep of them
  // holds.
  if (found_.empty() && left_ && left_->separation < 0)
    found_.push_back({*left_, 0, false}), normals_.push_back(left_->normal);
  gather(pair.frame, 1e-6 * pair.convex.bounding_radius);
  return true;
}

bool SceneryPairFinder::meet(const Terms& t, const Triangle& triangle) {
  const SceneryPair& pair = t.pair;
  const Scenery& scenery = *pair.scenery.scenery;
  ++t.report.support_calls;
  Vec3 deepest;
  if (!full_support(pair.convex, -t.convex_in_scenery.rotate_inverse(triangle.normal), deepest, t.fault)) return false;
  const Vec3 foot = t.convex_in_scenery.apply(deepest);
  const Real height = triangle.normal.dot(foot - triangle.corner[0]);
  if (!(height <= t.reach)) return true;
  const Sides sides(triangle, t.centre);
  shape_.set(triangle);
  const Frame frame(pair.frame.r, pair.frame.apply(shape_.origin()));
  ContactPoint nearest;
  nearest.normal = triangle.normal, nearest.separation = height;
  nearest.on_a = foot - height * triangle.normal - shape_.origin(), nearest.on_b = deepest;
  const auto leave = [&] {
    if (left_ && !(height > left_->separation)) return;
    left_.emplace();
    left_->on_a = foot - height * triangle.normal, left_->on_b = deepest;
    left_->normal = pair.frame.rotate(triangle.normal), left_->separation = height;
  };
  bool own = true;  // the triangle's own normal is the result
  const Real inset = sides.inset(triangle.corner, foot);
  // Along another direction, at an angle t to the normal, the triangle reaches farther by inset sin(t) and the shape's
  // depth shrinks by (1 - cos(t)) at most: shallower only if tan(t/2) > inset / depth, and never while that is 1.
  if (sides.any && !(inset >= 0 && -height <= inset)) {
    QuerySettings query = t.settings.query;
    query.max_distance = t.reach, query.method = Method::gjk_epa;
    QueryResult found;
    const Frame convex_in_triangle = relative(frame, pair.convex_frame);
    generic_distance(shape_.shape(), pair.convex, convex_in_triangle, query, nullptr, found, t.fault);
    t.report.gjk_calls += 1, t.report.epa_calls += found.epa_iterations > 0;
    t.report.support_calls += static_cast<std::uint64_t>(found.support_calls);
    if (found.status == QueryStatus::fault) return false;
    if (found.farther || !(found.separation <= t.reach)) return true;
    const Vec3 place = found.point_a + shape_.origin();
    const Ruling verdict = judge(scenery, triangle, sides, place, found.normal, 1e-7 * shape_.shape().bounding_radius);
    if (verdict == Ruling::neighbours) return leave(), true;
    own = verdict == Ruling::own;
    if (!own) {
      nearest.normal = found.normal, nearest.separation = found.separation;
      nearest.on_a = found.point_a, nearest.on_b = found.point_b;
    }
  }
  nearest.normal = pair.frame.rotate(nearest.normal);
  const Real over = t.reach + kEdgeShare * pair.convex.bounding_radius;
  const bool concave_edges = sides.concave[0] || sides.concave[1] || sides.concave[2];
  std::array<Vec3, 3> corner = triangle.corner;
  if (own && concave_edges) corner = over_concave_edges(scenery, triangle, sides, t.centre, over);
  if (own && concave_edges && inset < 0 && -inset <= over) shape_.reshape(corner);
  // What reaches far below a triangle without touching it comes from around an edge elsewhere.
  if (own && -height > std::max(inset, t.reach)) {
    const OverlapResult through = overlap(shape_.shape(), pair.convex, relative(frame, pair.convex_frame), 0,
                                          kPoseRounding * kUnitRoundoff, t.settings.query.gjk_cap, t.fault);
    t.report.support_calls += static_cast<std::uint64_t>(through.support_calls);
    if (through.outcome == Overlap::fault) return false;
    if (through.outcome == Overlap::apart) return true;
  }
  const PatchPair patch_pair{shape_.shape(), pair.convex, frame, pair.convex_frame, 0};
  // Neighbours see a place above their common side from frames of their own.
  const Real blur = 64 * kUnitRoundoff * (frame.p.abs().sum() + shape_.origin().abs().sum());
  PatchPoints points;
  if (!find_patch(patch_pair, nearest, {own, t.reach, blur}, points, t.report.support_calls, t.fault)) return false;
  add(points, shape_.origin(), own && points.flat, t.reach);
  if (own) {
    if (!stand(t, triangle)) return false;
    add_standing(t, [&](const Vec3& point) { return sides.inset(corner, point) >= -blur; });
  }
  if (points.count == 0 && sides.any) leave();
  return true;
}

void SceneryPairFinder::add(const PatchPoints& points, const Vec3& origin, bool firm, Real reach) {
  if (points.count == 0) return;
  const Vec3& n = points.point[0].normal;
  std::size_t patch = 0;
  for (std::size_t k = 1; k < normals_.size(); ++k)
    if (normals_[k].dot(n) > normals_[patch].dot(n)) patch = k;
  const bool other = normals_.empty() || normals_[patch].dot(n) < kSameWay;
  const bool begins = other && normals_.size() < kMostPatches;
  bool any = false;
  for (int i = 0; i < points.count; ++i) {
    const ContactPoint& p = points.point[i];
    if (!(p.separation <= reach)) continue;
    if (begins && !any) patch = normals_.size(), normals_.push_back(n);
    any = true;
    Found& f = found_.emplace_back();
    f.point = p;
    f.point.on_a += origin;
    f.point.feature = 0;  // a corner's name is its triangle's own
    f.patch = static_cast<std::uint32_t>(patch);
    f.firm = firm && (n - normals_[patch]).squared_norm() <= 1e-24;
  }
}

/// Of each patch the points that matter: the deepest, and those farthest out; where a shape leans, so that one end is
/// deepest however little that counts, the other end that may come down within the step, too.
void SceneryPairFinder::gather(const Frame& frame, Real same) {
  for (std::uint32_t k = 0; k < normals_.size(); ++k) {
    SceneryPatch& patch = patches_.emplace_back();
    patch.normal = normals_[k];
    patch.firm = true, patch.count = 0;
    for (const Found& f : found_)
      if (f.patch == k) patch.firm &= f.firm;
    choose(k, frame, kTriangleTilt, same, patch);
    choose(k, frame, kLeaningTilt, same, patch);
  }
}

/// The deepest point of a patch, and the extreme ones along directions tilted from the normal.
void SceneryPairFinder::choose(std::uint32_t k, const Frame& frame, Real tilt, Real same, SceneryPatch& patch) const {
  const Vec3 n = frame.rotate_inverse(patch.normal), e1 = any_perpendicular(n), e2 = n.cross(e1);
  std::array<const Found*, kWays + 1> most{};
  std::array<Real, kWays + 1> score;
  score.fill(-kInfinity);
  for (const Found& f : found_) {
    if (f.patch != k) continue;
    const Real depth = -f.point.separation;
    for (std::size_t way = 0; way <= kWays; ++way) {
      const Real s =
          way == 0 ? depth : depth + tilt * (kAzimuth[way - 1][0] * e1 + kAzimuth[way - 1][1] * e2).dot(f.point.on_a);
      if (s > score[way]) score[way] = s, most[way] = &f;
    }
  }
  for (const Found* f : most) {
    if (!f || patch.count == PatchPoints::kMax) continue;
    const auto known = [&](const ContactPoint& p) {
      return (p.on_a - f->point.on_a).squared_norm() <= same * same &&
             (p.on_b - f->point.on_b).squared_norm() <= same * same;
    };
    if (std::none_of(patch.point, patch.point + patch.count, known)) patch.point[patch.count++] = f->point;
  }
}

}  // namespace carom::collision

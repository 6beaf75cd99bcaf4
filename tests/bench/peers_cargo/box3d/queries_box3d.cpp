// Casts and pairs of Box3D for casts_vs_peers and convex_vs_peers, of the solids that it has. Pairs in the two ways
// that it has: its distance is of clouds of points with a radius, at most 64 of them, and tells no depth; the deepest
// point of its manifolds tells the depth of what overlaps, and no distance.
#include <box3d/box3d.h>
#include <box3d/collision.h>

#include <cmath>
#include <map>

#include "../../casts/peer.h"

namespace carom::bench {
namespace {

b3Vec3 vec(const double* v) { return {float(v[0]), float(v[1]), float(v[2])}; }
b3Quat turn(const Placement& at) {
  const double* r = at.r;  // row by row
  const b3Matrix3 columns = {{float(r[0]), float(r[3]), float(r[6])},
                             {float(r[1]), float(r[4]), float(r[7])},
                             {float(r[2]), float(r[5]), float(r[8])}};
  return b3MakeQuatFromMatrix(&columns);
}
b3Transform pose(const Placement& at) { return {vec(at.p), turn(at)}; }

struct Native {
  std::vector<b3Vec3> points;
  float radius = 0;
  b3HullData* hull = nullptr;  // of boxes and hulls
  bool built = true;           // Box3D makes no hull of some points

  explicit Native(const Solid& s) {
    const auto h = [&](int k, int bit, int i) { return float(i >> bit & 1 ? s.half[k] : -s.half[k]); };
    switch (s.kind) {
      case Kind::box:
        for (int i = 0; i < 8; ++i) points.push_back({h(0, 0, i), h(1, 1, i), h(2, 2, i)});
        break;
      case Kind::hull:
        for (std::size_t i = 0; i < s.vertices; ++i) points.push_back(vec(s.xyz + 3 * i));
        break;
      case Kind::capsule:
        points = {{0, float(-s.half_height), 0}, {0, float(s.half_height), 0}};
        radius = float(s.radius);
        break;
      default:
        points = {{0, 0, 0}};
        radius = float(s.radius);
    }
    const int count = static_cast<int>(points.size());
    if (s.kind != Kind::box && s.kind != Kind::hull) return;
    hull = b3CreateHull(points.data(), count, count);
    built = hull != nullptr;
  }
  Native(const Native&) = delete;
  ~Native() {
    if (hull) b3DestroyHull(hull);
  }
  b3ShapeProxy proxy() const { return {points.data(), static_cast<int>(points.size()), radius}; }
  b3Sphere sphere() const { return {points[0], radius}; }
  b3Capsule capsule() const { return {points[0], points[1], radius}; }
  int rank() const { return hull ? 2 : points.size() == 2 ? 1 : 0; }  // its manifolds want the larger first
};

class Natives {
 public:
  const Native& of(const Solid& solid) { return made_.try_emplace(&solid, solid).first->second; }
  void clear() { made_.clear(); }
  static const char* missing(const Solid& s) {
    static_assert(B3_MAX_SHAPE_CAST_POINTS == 64, "the words below say another number");
    if (s.kind == Kind::cylinder) return "its cylinder is a prism";
    if (s.kind == Kind::cone) return "its cone is a pyramid";
    if (s.kind == Kind::ellipsoid) return "it has no ellipsoid";
    const bool large = s.kind == Kind::hull && s.vertices > B3_MAX_SHAPE_CAST_POINTS;
    return large ? "it measures clouds of at most 64 points" : nullptr;
  }

 private:
  std::map<const Solid*, Native> made_;
};

b3Sweep sweep(const Placement& from, const Placement& to) {
  return {{0, 0, 0}, vec(from.p), vec(to.p), turn(from), turn(to)};
}

class Casts final : public CastPeer {
 public:
  const char* name() const override { return "Box3D f32"; }
  const char* lacks(Task, const Solid& solid) const override { return Natives::missing(solid); }
  void prepare(Task task, const CastCase* cases, std::size_t count) override {
    task_ = task;
    natives_.clear();
    cases_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c) cases_.push_back(prepared(*c));
  }
  double ask(std::size_t i) override {
    const Case& c = cases_[i];
    if (task_ == Task::turning) {
      const b3TOIOutput out = b3TimeOfImpact(&c.turning);
      return out.state == b3_toiStateHit || out.state == b3_toiStateOverlapped ? double(out.fraction) : -1;
    }
    const b3CastOutput out = task_ == Task::linear ? b3ShapeCast(&c.linear) : ray(c);
    return out.hit ? double(out.fraction) : -1;
  }

 private:
  struct Case {
    const Native* b;
    b3RayCastInput ray;  // in b's frame
    b3ShapeCastPairInput linear;
    b3TOIInput turning;
  };
  Case prepared(const CastCase& c) {
    Case made{};
    made.b = &natives_.of(*c.b);
    const b3Transform at_b = pose(c.from_b);
    const double way[3] = {c.to_a.p[0] - c.from_a.p[0], c.to_a.p[1] - c.from_a.p[1], c.to_a.p[2] - c.from_a.p[2]};
    const b3Vec3 way_b = b3InvRotateVector(at_b.q, vec(way));
    made.ray.origin = b3InvTransformPoint(at_b, vec(c.from_a.p));
    made.ray.translation = way_b;
    made.ray.maxFraction = 1;
    if (!c.a) return made;
    const b3ShapeProxy a = natives_.of(*c.a).proxy(), b = made.b->proxy();
    made.linear = {b, a, b3InvMulTransforms(at_b, pose(c.from_a)), way_b, 1, false};
    made.turning = {a, b, sweep(c.from_a, c.to_a), sweep(c.from_b, c.to_b), 1};
    return made;
  }
  static b3CastOutput ray(const Case& c) {
    if (!c.b->built) return {};
    if (c.b->hull) return b3RayCastHull(c.b->hull, &c.ray);
    if (c.b->points.size() == 2) {
      const b3Capsule capsule = c.b->capsule();
      return b3RayCastCapsule(&capsule, &c.ray);
    }
    const b3Sphere sphere = c.b->sphere();
    return b3RayCastSphere(&sphere, &c.ray);
  }

  Task task_ = Task::ray;
  Natives natives_;
  std::vector<Case> cases_;
};

class Distance final : public Peer {
 public:
  const char* name() const override { return "Box3D f32 distance"; }
  const char* lacks(const Solid& solid) const override { return Natives::missing(solid); }
  void prepare(const Query* queries, std::size_t count) override {
    natives_.clear();
    queries_.clear();
    turns_.clear();
    for (const Query* q = queries; q < queries + count; ++q) {
      queries_.push_back({natives_.of(*q->a).proxy(), natives_.of(*q->b).proxy(),
                          b3InvMulTransforms(pose(q->at_a), pose(q->at_b)), true});
      turns_.push_back(turn(q->at_a));
    }
  }
  void ask(std::size_t i, Answer& answer) override {
    b3SimplexCache cache{};
    const b3DistanceOutput out = b3ShapeDistance(&queries_[i], &cache, nullptr, 0);
    answer.overlap = out.distance <= 0;
    if (answer.overlap) return;
    answer.separation = out.distance;
    const b3Vec3 normal = b3RotateVector(turns_[i], out.normal);
    answer.normal[0] = normal.x, answer.normal[1] = normal.y, answer.normal[2] = normal.z;
  }

 private:
  Natives natives_;
  std::vector<b3DistanceInput> queries_;
  std::vector<b3Quat> turns_;
};

class Manifold final : public Peer {
 public:
  const char* name() const override { return "Box3D f32 manifold"; }
  const char* lacks(const Solid& solid) const override { return Natives::missing(solid); }
  void prepare(const Query* queries, std::size_t count) override {
    natives_.clear();
    couples_.clear();
    for (const Query* q = queries; q < queries + count; ++q) {
      const Native &a = natives_.of(*q->a), &b = natives_.of(*q->b);
      if (a.rank() >= b.rank())
        couples_.push_back({&a, &b, b3InvMulTransforms(pose(q->at_a), pose(q->at_b)), turn(q->at_a), 1});
      else
        couples_.push_back({&b, &a, b3InvMulTransforms(pose(q->at_b), pose(q->at_a)), turn(q->at_b), -1});
    }
  }
  void ask(std::size_t i, Answer& answer) override {
    const Couple& c = couples_[i];
    answer.separation = HUGE_VAL;
    if (!c.a->built || !c.b->built) return;
    answer.separation = NAN;  // it tells no distance
    b3LocalManifoldPoint points[kMostPoints];
    b3LocalManifold manifold{};
    manifold.points = points;
    collide(c, manifold);
    float deepest = HUGE_VALF;
    for (int k = 0; k < manifold.pointCount; ++k) deepest = std::fmin(deepest, points[k].separation);
    answer.overlap = deepest <= 0;
    if (!answer.overlap) return;
    answer.separation = deepest;
    const b3Vec3 normal = b3MulSV(c.sign, b3RotateVector(c.turn, manifold.normal));
    answer.normal[0] = normal.x, answer.normal[1] = normal.y, answer.normal[2] = normal.z;
  }

 private:
  static constexpr int kMostPoints = 32;
  struct Couple {
    const Native *a, *b;  // by falling rank
    b3Transform b_in_a;
    b3Quat turn;  // of a
    float sign;   // -1: a and b changed places
  };
  static void collide(const Couple& c, b3LocalManifold& out) {
    b3SimplexCache simplex{};
    if (c.a->hull && c.b->hull) {
      b3SATCache axes{};
      return b3CollideHulls(&out, kMostPoints, c.a->hull, c.b->hull, c.b_in_a, &axes);
    }
    if (c.b->rank() == 1) {
      const b3Capsule b = c.b->capsule();
      if (c.a->hull) return b3CollideHullAndCapsule(&out, kMostPoints, c.a->hull, &b, c.b_in_a, &simplex);
      const b3Capsule a = c.a->capsule();
      return b3CollideCapsules(&out, kMostPoints, &a, &b, c.b_in_a);
    }
    const b3Sphere b = c.b->sphere();
    if (c.a->hull) return b3CollideHullAndSphere(&out, kMostPoints, c.a->hull, &b, c.b_in_a, &simplex);
    if (c.a->rank() == 1) {
      const b3Capsule a = c.a->capsule();
      return b3CollideCapsuleAndSphere(&out, kMostPoints, &a, &b, c.b_in_a);
    }
    const b3Sphere a = c.a->sphere();
    b3CollideSpheres(&out, kMostPoints, &a, &b, c.b_in_a);
  }
  Natives natives_;
  std::vector<Couple> couples_;
};

}  // namespace

extern "C" CastPeer* carom_peer_casts(int i) { return i == 0 ? new Casts : nullptr; }
extern "C" Peer* carom_peer_pairs(int i) {
  if (i == 0) return new Distance;
  return i == 1 ? new Manifold : nullptr;
}

}  // namespace carom::bench

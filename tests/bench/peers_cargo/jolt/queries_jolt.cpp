// Casts and pairs of Jolt for casts_vs_peers and convex_vs_peers, of the solids that it has, their rounding (convex radius)
// off where it isn't the shape itself. Pairs in the two ways that it has: the distance of what is apart by GJK between shapes
// without their radius, and the depth of what overlaps by GJK and EPA, each of which tells no more than whether of the other.
#include <Jolt/Jolt.h>

#include <Jolt/Geometry/EPAPenetrationDepth.h>
#include <Jolt/Physics/Collision/CastResult.h>
#include <Jolt/Physics/Collision/RayCast.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/CylinderShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Collision/Shape/SubShapeID.h>
#include <Jolt/Physics/PhysicsSettings.h>

#include <cfloat>
#include <map>

#include "../../casts/peer.h"

namespace carom::bench {
namespace {

using JPH::Mat44;
using JPH::Vec3;
using JPH::Vec4;

Vec3 vec(const double* v) { return Vec3(float(v[0]), float(v[1]), float(v[2])); }
Mat44 pose(const Placement& at) {
  const auto column = [&](int k) { return Vec4(float(at.r[k]), float(at.r[3 + k]), float(at.r[6 + k]), 0); };
  return Mat44(column(0), column(1), column(2), Vec4(vec(at.p), 1));
}

class Natives {
 public:
  /// Null: Jolt makes no hull of these points.
  const JPH::ConvexShape* of(const Solid& solid) {
    const auto [at, fresh] = made_.try_emplace(&solid);
    if (fresh) at->second = make(solid);
    return at->second;
  }
  void clear() { made_.clear(); }
  static const char* missing(const Solid& s) {
    if (s.kind == Kind::cone) return "it has no cone";
    if (s.kind == Kind::ellipsoid) return "it has no ellipsoid";
    return s.kind == Kind::hull && s.vertices > 256 ? "it keeps at most 256 vertices of a hull" : nullptr;
  }

 private:
  static JPH::RefConst<JPH::ConvexShape> make(const Solid& s) {
    const float radius = float(s.radius), half = float(s.half_height);
    switch (s.kind) {
      case Kind::capsule:
        return new JPH::CapsuleShape(half, radius);
      case Kind::box:
        return new JPH::BoxShape(vec(s.half), 0);
      case Kind::cylinder:
        return new JPH::CylinderShape(half, radius, 0);
      case Kind::hull:
        break;
      default:
        return new JPH::SphereShape(radius);
    }
    JPH::Array<Vec3> points;
    for (std::size_t i = 0; i < s.vertices; ++i) points.push_back(vec(s.xyz + 3 * i));
    const JPH::ShapeSettings::ShapeResult made = JPH::ConvexHullShapeSettings(points, 0).Create();
    return made.IsValid() ? static_cast<const JPH::ConvexShape*>(made.Get().GetPtr()) : nullptr;
  }
  std::map<const Solid*, JPH::RefConst<JPH::ConvexShape>> made_;
};

/// A pair of shapes about their centres of mass, where Jolt's own functions want them.
struct Couple {
  const JPH::ConvexShape *a, *b;  // a null: a ray
  bool built;                     // Jolt has both
  Mat44 at_a, at_b;
  Vec3 way;

  Couple(Natives& natives, const Solid* solid_a, const Placement& from_a, const Solid& solid_b, const Placement& from_b,
         Vec3 moves)
      : a(solid_a ? natives.of(*solid_a) : nullptr),
        b(natives.of(solid_b)),
        built(b && (a || !solid_a)),
        at_a(pose(from_a)),
        at_b(pose(from_b)),
        way(moves) {
    if (a) at_a = at_a * centre(*a);
    if (b) at_b = at_b * centre(*b);
  }
  static Mat44 centre(const JPH::ConvexShape& shape) { return Mat44::sTranslation(shape.GetCenterOfMass()); }
};

using Support = JPH::ConvexShape::Support;
using Buffer = JPH::ConvexShape::SupportBuffer;
const Support& support(const JPH::ConvexShape& shape, JPH::ConvexShape::ESupportMode mode, Buffer& buffer) {
  return *shape.GetSupportFunction(mode, buffer, Vec3::sReplicate(1));
}
constexpr auto kCore = JPH::ConvexShape::ESupportMode::ExcludeConvexRadius;
constexpr auto kWhole = JPH::ConvexShape::ESupportMode::IncludeConvexRadius;

class Casts final : public CastPeer {
 public:
  const char* name() const override { return "Jolt f32"; }
  const char* lacks(Task task, const Solid& solid) const override {
    return task == Task::turning ? "its casts do not turn" : Natives::missing(solid);
  }
  void prepare(Task, const CastCase* cases, std::size_t count) override {
    couples_.clear();
    natives_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c)
      couples_.emplace_back(natives_, c->a, c->from_a, *c->b, c->from_b, vec(c->to_a.p) - vec(c->from_a.p));
  }
  double ask(std::size_t i) override {
    const Couple& c = couples_[i];
    if (!c.built) return -1;
    const Mat44 to_b = c.at_b.InversedRotationTranslation();
    const Vec3 way = to_b.Multiply3x3(c.way);
    if (!c.a) {
      JPH::RayCastResult hit;
      const JPH::RayCast ray(to_b * c.at_a.GetTranslation(), way);
      return c.b->CastRay(ray, JPH::SubShapeIDCreator(), hit) ? double(hit.mFraction) : -1;
    }
    Buffer buffer_a, buffer_b;
    const Support &a = support(*c.a, kCore, buffer_a), &b = support(*c.b, kCore, buffer_b);
    JPH::EPAPenetrationDepth epa;
    float fraction = 1 + FLT_EPSILON;
    Vec3 on_a, on_b, normal;
    const bool hit =
        epa.CastShape(to_b * c.at_a, way, JPH::cDefaultCollisionTolerance, JPH::cDefaultPenetrationTolerance, a, b,
                      a.GetConvexRadius(), b.GetConvexRadius(), false, fraction, on_a, on_b, normal);
    return hit ? double(fraction) : -1;
  }

 private:
  Natives natives_;
  std::vector<Couple> couples_;
};

class Pairs final : public Peer {
 public:
  explicit Pairs(bool depth) : depth_(depth) {}
  const char* name() const override { return depth_ ? "Jolt f32 GJK + EPA" : "Jolt f32 GJK distance"; }
  const char* lacks(const Solid& solid) const override { return Natives::missing(solid); }
  void prepare(const Query* queries, std::size_t count) override {
    couples_.clear();
    natives_.clear();
    for (const Query* q = queries; q < queries + count; ++q)
      couples_.emplace_back(natives_, q->a, q->at_a, *q->b, q->at_b, Vec3::sZero());
  }
  void ask(std::size_t i, Answer& answer) override {
    const Couple& c = couples_[i];
    answer.separation = HUGE_VAL;
    if (!c.built) return;
    answer.separation = NAN;
    const Mat44 b_in_a = c.at_a.InversedRotationTranslation() * c.at_b;
    Buffer buffer_a, buffer_b;
    const Support &a = support(*c.a, kCore, buffer_a), &b = support(*c.b, kCore, buffer_b);
    Vec3 normal = Vec3::sAxisX();
    if (depth_) {
      tell_depth(c, b_in_a, a, b, normal, answer);
    } else {
      const JPH::TransformedConvexObject<Support> placed(b_in_a, b);
      JPH::GJKClosestPoint gjk;
      Vec3 on_a, on_b;
      const float squared =
          gjk.GetClosestPoints(a, placed, JPH::cDefaultCollisionTolerance, FLT_MAX, normal, on_a, on_b);
      const double separation = std::sqrt(squared) - a.GetConvexRadius() - b.GetConvexRadius();
      answer.overlap = separation <= 0;
      if (!answer.overlap) answer.separation = separation;
    }
    if (std::isnan(answer.separation)) return;
    const Vec3 out = c.at_a.Multiply3x3(normal);
    for (std::uint32_t k = 0; k < 3; ++k) answer.normal[k] = out[k];
  }

 private:
  static void tell_depth(const Couple& c, const Mat44& b_in_a, const Support& a, const Support& b, Vec3& normal,
                         Answer& answer) {
    using Depth = JPH::EPAPenetrationDepth;
    const JPH::TransformedConvexObject<Support> placed(b_in_a, b);
    Depth epa;
    Vec3 on_a, on_b;
    const Depth::EStatus status = epa.GetPenetrationDepthStepGJK(a, a.GetConvexRadius(), placed, b.GetConvexRadius(),
                                                                 JPH::cDefaultCollisionTolerance, normal, on_a, on_b);
    bool found = status == Depth::EStatus::Colliding;
    if (status == Depth::EStatus::Indeterminate) {
      Buffer whole_a, whole_b;
      const Support &all_a = support(*c.a, kWhole, whole_a), &all_b = support(*c.b, kWhole, whole_b);
      const JPH::TransformedConvexObject<Support> all_placed(b_in_a, all_b);
      found = epa.GetPenetrationDepthStepEPA(all_a, all_placed, JPH::cDefaultPenetrationTolerance, normal, on_a, on_b);
    }
    answer.overlap = found;
    if (found) answer.separation = -double((on_b - on_a).Length());
  }

  bool depth_;
  Natives natives_;
  std::vector<Couple> couples_;
};

}  // namespace

void set_up_jolt();

extern "C" CastPeer* carom_peer_casts(int i) { return i == 0 ? (set_up_jolt(), new Casts) : nullptr; }
extern "C" Peer* carom_peer_pairs(int i) { return i < 2 ? (set_up_jolt(), new Pairs(i == 1)) : nullptr; }

}  // namespace carom::bench

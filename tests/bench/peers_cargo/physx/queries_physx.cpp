// Casts and pairs of PhysX for casts_vs_peers and convex_vs_peers. Its queries between geometries are asked about the
// solids that it has; of pairs that are apart they tell no distance. Its GJK query takes any support function: PhysX's
// own of what it has, and those that libccd is given of the rest.
#include <extensions/PxGjkQueryExt.h>

#include <cmath>
#include <map>
#include <memory>

#include "../../casts/peer.h"
#include "sdk.h"

namespace carom::bench {
namespace {

using namespace physx;

PxVec3 vec(const double* v) { return PxVec3(float(v[0]), float(v[1]), float(v[2])); }
PxTransform pose(const Placement& at) {
  const auto column = [&](int k) { return PxVec3(float(at.r[k]), float(at.r[3 + k]), float(at.r[6 + k])); };
  return PxTransform(vec(at.p), PxQuat(PxMat33(column(0), column(1), column(2))).getNormalized());
}

/// A solid that PhysX hasn't.
class OtherSupport final : public PxGjkQuery::Support {
 public:
  explicit OtherSupport(const Solid& solid) : solid_(solid), hint_(solid.start) {}
  PxReal getMargin() const override { return float(solid_.core_radius); }
  PxVec3 supportLocal(const PxVec3& direction) const override {
    const double d[3] = {direction.x, direction.y, direction.z};
    double p[3];
    core_support(solid_, d, p, hint_);
    return vec(p);
  }

 private:
  const Solid& solid_;
  mutable std::uint32_t hint_;
};

struct Native {
  PxGeometryHolder shape;  // of no type, if PhysX hasn't the solid, or makes no hull of its points
  std::unique_ptr<PxGjkQuery::Support> support;
  PxTransform frame{PxIdentity};  // of the shape in the solid's: capsules of PhysX lie along x
  bool built() const { return shape.getType() != PxGeometryType::eINVALID; }
};

class Natives {
 public:
  ~Natives() { clear(); }
  const Native& of(const Solid& s) {
    Native& native = made_[&s];
    if (native.support) return native;
    const float radius = float(s.radius);
    if (s.kind == Kind::sphere) native.shape = PxGeometryHolder(PxSphereGeometry(radius));
    if (s.kind == Kind::box) native.shape = PxGeometryHolder(PxBoxGeometry(vec(s.half)));
    if (s.kind == Kind::capsule) {
      native.shape = PxGeometryHolder(PxCapsuleGeometry(radius, float(s.half_height)));
      native.frame.q = PxQuat(PxHalfPi, PxVec3(0, 0, 1));
    }
    if (s.kind == Kind::hull && !missing(s))
      if (PxConvexMesh* const mesh = hull(s)) native.shape = PxGeometryHolder(PxConvexMeshGeometry(mesh));
    if (native.built())
      native.support = std::make_unique<PxGjkQueryExt::ConvexGeomSupport>(native.shape.any());
    else
      native.support = std::make_unique<OtherSupport>(s);
    return native;
  }
  void clear() {
    made_.clear();
    for (PxConvexMesh* mesh : hulls_) mesh->release();
    hulls_.clear();
  }
  static const char* missing(const Solid& s) {
    if (s.kind == Kind::cylinder) return "it has no cylinder";
    if (s.kind == Kind::cone) return "it has no cone";
    if (s.kind == Kind::ellipsoid) return "it has no ellipsoid";
    return s.kind == Kind::hull && s.vertices > 255 ? "it keeps at most 255 vertices of a hull" : nullptr;
  }

 private:
  PxConvexMesh* hull(const Solid& s) {
    PxConvexMesh* const made = make_physx_hull(s.xyz, s.vertices);
    if (made) hulls_.push_back(made);
    return made;
  }
  std::map<const Solid*, Native> made_;
  std::vector<PxConvexMesh*> hulls_;
};

constexpr const char* kStays = "its casts do not turn";

class Casts : public CastPeer {
 public:
  const char* name() const override { return "PhysX f32"; }
  const char* lacks(Task task, const Solid& solid) const override {
    return task == Task::turning ? kStays : Natives::missing(solid);
  }
  void prepare(Task, const CastCase* cases, std::size_t count) override {
    cases_.clear();
    natives_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c) {
      const Native& b = natives_.of(*c->b);
      Case made{nullptr, &b, pose(c->from_a), pose(c->from_b) * b.frame, vec(c->to_a.p) - vec(c->from_a.p), 0};
      made.length = made.way.normalize();
      if (c->a) {
        made.a = &natives_.of(*c->a);
        made.at_a = made.at_a * made.a->frame;
      }
      cases_.push_back(made);
    }
  }
  double ask(std::size_t i) override {
    const Case& c = cases_[i];
    if (!c.b->built() || (c.a && !c.a->built())) return -1;
    if (!c.a) {
      PxGeomRaycastHit hit;
      const bool met = PxGeometryQuery::raycast(c.at_a.p, c.way, c.b->shape.any(), c.at_b, c.length,
                                                PxHitFlag::eDEFAULT, 1, &hit, sizeof hit) > 0;
      return met ? double(hit.distance) / c.length : -1;
    }
    PxGeomSweepHit hit;
    const bool met = PxGeometryQuery::sweep(c.way, c.length, c.a->shape.any(), c.at_a, c.b->shape.any(), c.at_b, hit);
    return met ? double(hit.distance) / c.length : -1;
  }

 protected:
  struct Case {
    const Native *a, *b;  // a null: a ray
    PxTransform at_a, at_b;
    PxVec3 way;  // unit
    float length;
  };
  std::vector<Case> cases_;

 private:
  Natives natives_;
};

class GjkCasts final : public Casts {
 public:
  const char* name() const override { return "PhysX f32 GJK query"; }
  const char* lacks(Task task, const Solid&) const override { return task == Task::turning ? kStays : nullptr; }
  double ask(std::size_t i) override {
    const Case& c = cases_[i];
    PxReal distance;
    PxVec3 normal, point;
    const bool met =
        c.a ? PxGjkQuery::sweep(*c.b->support, *c.a->support, c.at_b, c.at_a, c.way, c.length, distance, normal, point)
            : PxGjkQuery::raycast(*c.b->support, c.at_b, c.at_a.p, c.way, c.length, distance, normal, point);
    return met ? double(distance) / c.length : -1;
  }
};

class Pairs : public Peer {
 public:
  const char* name() const override { return "PhysX f32 penetration"; }
  const char* lacks(const Solid& solid) const override { return Natives::missing(solid); }
  void prepare(const Query* queries, std::size_t count) override {
    couples_.clear();
    natives_.clear();
    for (const Query* q = queries; q < queries + count; ++q) {
      const Native &a = natives_.of(*q->a), &b = natives_.of(*q->b);
      couples_.push_back({&a, &b, pose(q->at_a) * a.frame, pose(q->at_b) * b.frame});
    }
  }
  void ask(std::size_t i, Answer& answer) override {
    const Couple& c = couples_[i];
    answer.separation = HUGE_VAL;
    if (!c.a->built() || !c.b->built()) return;
    answer.separation = NAN;  // it tells no distance
    PxVec3 out_of_b;
    PxF32 depth;
    answer.overlap =
        PxGeometryQuery::computePenetration(out_of_b, depth, c.a->shape.any(), c.at_a, c.b->shape.any(), c.at_b);
    if (answer.overlap) tell(-double(depth), -out_of_b, answer);
  }

 protected:
  struct Couple {
    const Native *a, *b;
    PxTransform at_a, at_b;
  };
  static void tell(double separation, const PxVec3& normal, Answer& answer) {
    answer.separation = separation;
    answer.normal[0] = normal.x, answer.normal[1] = normal.y, answer.normal[2] = normal.z;
  }
  std::vector<Couple> couples_;

 private:
  Natives natives_;
};

class GjkPairs final : public Pairs {
 public:
  const char* name() const override { return "PhysX f32 GJK query"; }
  const char* lacks(const Solid&) const override { return nullptr; }
  void ask(std::size_t i, Answer& answer) override {
    constexpr PxReal kFar = 1e6f, kLength = 1;  // m; how large solids are, which scales its tolerances
    const Couple& c = couples_[i];
    PxVec3 on_a, on_b, to_a;
    PxReal separation;
    answer.separation = HUGE_VAL;
    if (!PxGjkQuery::proximityInfo(*c.a->support, *c.b->support, c.at_a, c.at_b, kFar, kLength, on_a, on_b, to_a,
                                   separation))
      return;
    answer.overlap = separation <= 0;
    tell(separation, -to_a, answer);
  }
};

}  // namespace

extern "C" CastPeer* carom_peer_casts(int i) {
  if (i == 0) return new Casts;
  return i == 1 ? new GjkCasts : nullptr;
}
extern "C" Peer* carom_peer_pairs(int i) {
  if (i == 0) return new Pairs;
  return i == 1 ? new GjkPairs : nullptr;
}

}  // namespace carom::bench

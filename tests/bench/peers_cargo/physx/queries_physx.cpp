// Casts and pairs of PhysX for casts_vs_peers and convex_vs_peers, of the solids that it has. Of pairs that are apart it tells
// no distance.
#include "sdk.h"

#include <cmath>
#include <map>

#include "../../casts/peer.h"

namespace carom::bench {
namespace {

using namespace physx;

PxVec3 vec(const double* v) { return PxVec3(float(v[0]), float(v[1]), float(v[2])); }
PxTransform pose(const Placement& at) {
  const auto column = [&](int k) { return PxVec3(float(at.r[k]), float(at.r[3 + k]), float(at.r[6 + k])); };
  return PxTransform(vec(at.p), PxQuat(PxMat33(column(0), column(1), column(2))).getNormalized());
}

struct Native {
  PxGeometryHolder shape;
  PxTransform frame{PxIdentity};  // of the shape in the solid's: capsules of PhysX lie along x
};

class Natives {
 public:
  ~Natives() { clear(); }
  const Native& of(const Solid& s) {
    Native& native = made_[&s];
    if (native.shape.getType() != PxGeometryType::eINVALID) return native;
    const float radius = float(s.radius);
    if (s.kind == Kind::sphere) native.shape = PxGeometryHolder(PxSphereGeometry(radius));
    if (s.kind == Kind::box) native.shape = PxGeometryHolder(PxBoxGeometry(vec(s.half)));
    if (s.kind == Kind::capsule) {
      native.shape = PxGeometryHolder(PxCapsuleGeometry(radius, float(s.half_height)));
      native.frame.q = PxQuat(PxHalfPi, PxVec3(0, 0, 1));
    }
    if (s.kind == Kind::hull) native.shape = PxGeometryHolder(PxConvexMeshGeometry(&hull(s)));
    return native;
  }
  void clear() {
    made_.clear();
    for (PxConvexMesh* mesh : hulls_) mesh->release();
    hulls_.clear();
  }
  /// It keeps at most 255 vertices of a hull.
  static bool has(const Solid& s) {
    return s.kind == Kind::sphere || s.kind == Kind::capsule || s.kind == Kind::box ||
           (s.kind == Kind::hull && s.vertices <= 255);
  }

 private:
  PxConvexMesh& hull(const Solid& s) {
    hulls_.push_back(make_physx_hull(s.xyz, s.vertices));
    return *hulls_.back();
  }
  std::map<const Solid*, Native> made_;
  std::vector<PxConvexMesh*> hulls_;
};

class Casts final : public CastPeer {
 public:
  const char* name() const override { return "PhysX f32"; }
  bool can(Task task, const Solid& solid) const override { return task != Task::turning && Natives::has(solid); }
  void prepare(Task, const CastCase* cases, std::size_t count) override {
    cases_.clear();
    natives_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c) {
      const Native& b = natives_.of(*c->b);
      Case made{nullptr, &b.shape.any(), pose(c->from_a), pose(c->from_b) * b.frame, vec(c->to_a.p) - vec(c->from_a.p), 0};
      made.length = made.way.normalize();
      if (c->a) {
        const Native& a = natives_.of(*c->a);
        made.a = &a.shape.any();
        made.at_a = made.at_a * a.frame;
      }
      cases_.push_back(made);
    }
  }
  double ask(std::size_t i) override {
    const Case& c = cases_[i];
    if (!c.a) {
      PxGeomRaycastHit hit;
      const bool met = PxGeometryQuery::raycast(c.at_a.p, c.way, *c.b, c.at_b, c.length, PxHitFlag::eDEFAULT, 1, &hit,
                                                sizeof hit) > 0;
      return met ? double(hit.distance) / c.length : -1;
    }
    PxGeomSweepHit hit;
    const bool met = PxGeometryQuery::sweep(c.way, c.length, *c.a, c.at_a, *c.b, c.at_b, hit);
    return met ? double(hit.distance) / c.length : -1;
  }

 private:
  struct Case {
    const PxGeometry *a, *b;
    PxTransform at_a, at_b;
    PxVec3 way;  // unit
    float length;
  };
  Natives natives_;
  std::vector<Case> cases_;
};

class Pairs final : public Peer {
 public:
  const char* name() const override { return "PhysX f32 penetration"; }
  bool can(const Solid& solid) const override { return Natives::has(solid); }
  void prepare(const Query* queries, std::size_t count) override {
    couples_.clear();
    natives_.clear();
    for (const Query* q = queries; q < queries + count; ++q) {
      const Native &a = natives_.of(*q->a), &b = natives_.of(*q->b);
      couples_.push_back({&a.shape.any(), &b.shape.any(), pose(q->at_a) * a.frame, pose(q->at_b) * b.frame});
    }
  }
  void ask(std::size_t i, Answer& answer) override {
    const Couple& c = couples_[i];
    PxVec3 out_of_b;
    PxF32 depth;
    answer.overlap = PxGeometryQuery::computePenetration(out_of_b, depth, *c.a, c.at_a, *c.b, c.at_b);
    if (!answer.overlap) return;
    answer.separation = -double(depth);
    answer.normal[0] = -out_of_b.x, answer.normal[1] = -out_of_b.y, answer.normal[2] = -out_of_b.z;
  }

 private:
  struct Couple {
    const PxGeometry *a, *b;
    PxTransform at_a, at_b;
  };
  Natives natives_;
  std::vector<Couple> couples_;
};

}  // namespace

extern "C" CastPeer* carom_peer_casts(int i) { return i == 0 ? new Casts : nullptr; }
extern "C" Peer* carom_peer_pairs(int i) { return i == 0 ? new Pairs : nullptr; }

}  // namespace carom::bench

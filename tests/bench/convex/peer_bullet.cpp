// Bullet under test, in float or double as its headers say: GJK's pair detector with EPA beneath, and EPA's own
// distance.
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <map>

#include "peer.h"

namespace carom::bench {

namespace {

#ifdef BT_USE_DOUBLE_PRECISION
#define PRECISION "f64"
#else
#define PRECISION "f32"
#endif

btScalar real(double x) { return static_cast<btScalar>(x); }
btVector3 vec(double x, double y, double z) { return btVector3(real(x), real(y), real(z)); }
btVector3 vec(const double* v) { return vec(v[0], v[1], v[2]); }
void copy(const btVector3& from, double* to) {
  for (int k = 0; k < 3; ++k) to[k] = from[k];
}

/// Bullet has no ellipsoid; its boxes' base class wants this much from one.
class Ellipsoid final : public btConvexInternalShape {
 public:
  explicit Ellipsoid(const btVector3& radii) : radii_(radii) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(0);
  }
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& d) const override {
    const btVector3 w = radii_ * d;
    const btScalar length = w.length();
    return length > 0 ? radii_ * w / length : btVector3(radii_.x(), 0, 0);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* d, btVector3* out, int count) const override {
    for (int i = 0; i < count; ++i) out[i] = localGetSupportingVertexWithoutMargin(d[i]);
  }
  void getAabb(const btTransform&, btVector3&, btVector3&) const override {}
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "Ellipsoid"; }

 private:
  btVector3 radii_;
};

std::unique_ptr<btConvexShape> native(const Solid& solid) {
  std::unique_ptr<btConvexShape> made;
  switch (solid.kind) {
    case Kind::sphere:  // spheres and capsules are margin around a core: theirs stays
      return std::make_unique<btSphereShape>(real(solid.radius));
    case Kind::capsule:
      return std::make_unique<btCapsuleShape>(real(solid.radius), real(2 * solid.half_height));
    case Kind::box:
      made = std::make_unique<btBoxShape>(vec(solid.half));
      break;
    case Kind::cylinder:
      made = std::make_unique<btCylinderShape>(vec(solid.radius, solid.half_height, solid.radius));
      break;
    case Kind::cone:
      made = std::make_unique<btConeShape>(real(solid.radius), real(2 * solid.half_height));
      break;
    case Kind::ellipsoid:
      return std::make_unique<Ellipsoid>(vec(solid.half));
    case Kind::hull: {
      auto hull = std::make_unique<btConvexHullShape>();
      for (std::size_t i = 0; i < solid.vertices; ++i) hull->addPoint(vec(&solid.xyz[3 * i]), false);
      made = std::move(hull);
    }
  }
  made->setMargin(0);  // the default one rounds hulls and cones by 4 cm
  return made;
}

class Bullet : public Peer {
 public:
  void prepare(const Query* queries, std::size_t count) override {
    pairs_.clear();
    natives_.clear();  // solids of another set may lie where the last one's lay
    for (const Query* q = queries; q < queries + count; ++q)
      pairs_.push_back({&of(*q->a), &of(*q->b), pose(q->at_a), pose(q->at_b)});
  }

 protected:
  struct Pair {
    const btConvexShape *a, *b;
    btTransform pose_a, pose_b;
  };
  std::vector<Pair> pairs_;

 private:
  const btConvexShape& of(const Solid& solid) {
    std::unique_ptr<btConvexShape>& known = natives_[&solid];
    if (!known) known = native(solid);
    return *known;
  }
  static btTransform pose(const Placement& at) {
    const double* const r = at.r;
    return btTransform(btMatrix3x3(real(r[0]), real(r[1]), real(r[2]), real(r[3]), real(r[4]), real(r[5]), real(r[6]),
                                   real(r[7]), real(r[8])),
                       vec(at.p));
  }
  std::map<const Solid*, std::unique_ptr<btConvexShape>> natives_;
};

class PairDetector final : public Bullet {
 public:
  const char* name() const override { return "Bullet " PRECISION " pair detector"; }
  void ask(std::size_t i, Answer& answer) override {
    const Pair& p = pairs_[i];
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(p.a, p.b, &simplex, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = p.pose_a;
    input.m_transformB = p.pose_b;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    answer.separation = found.m_hasResult ? double(found.m_distance) : HUGE_VAL;
    answer.overlap = found.m_hasResult && found.m_distance <= 0;
    copy(-found.m_normalOnBInWorld, answer.normal);
  }
};

class OwnEpa final : public Bullet {
 public:
  const char* name() const override { return "Bullet " PRECISION " GJK + EPA"; }
  void ask(std::size_t i, Answer& answer) override {
    const Pair& p = pairs_[i];
    const btVector3 guess = p.pose_b.getOrigin() - p.pose_a.getOrigin();
    btGjkEpaSolver2::sResults found;
    answer.separation = HUGE_VAL;
    // Its Distance knows no margin, and spheres and capsules are margin.
    const btScalar margins = margin(*p.a) + margin(*p.b);
    if (btGjkEpaSolver2::Distance(p.a, p.pose_a, p.b, p.pose_b, guess, found) && found.distance > margins) {
      answer.separation = found.distance - margins;
      copy(found.witnesses[1] - found.witnesses[0], answer.normal);
    } else if (btGjkEpaSolver2::Penetration(p.a, p.pose_a, p.b, p.pose_b, guess, found)) {
      answer.overlap = true;
      answer.separation = -std::fabs(double(found.distance));
      copy(found.witnesses[0] - found.witnesses[1], answer.normal);  // found.normal is in A's frame
    }
  }

 private:
  static btScalar margin(const btConvexShape& s) {
    const int type = s.getShapeType();
    return type == SPHERE_SHAPE_PROXYTYPE || type == CAPSULE_SHAPE_PROXYTYPE ? s.getMargin() : 0;
  }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) Peer* carom_bench_peer(int i) {
  if (i == 0) return new PairDetector;
  if (i == 1) return new OwnEpa;
  return nullptr;
}

}  // namespace carom::bench

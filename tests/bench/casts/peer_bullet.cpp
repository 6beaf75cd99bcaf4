// Bullet's casts: the sub-simplex cast that its rays use, GJK's, and continuous convex collision.
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <map>

#include "peer.h"

namespace carom::bench {
namespace {

btVector3 vec(const double* v) {
  return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2]));
}

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
  btVector3 localGetSupportingVertex(const btVector3& d) const override {
    return localGetSupportingVertexWithoutMargin(d);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* d, btVector3* out, int count) const override {
    for (int i = 0; i < count; ++i) out[i] = localGetSupportingVertexWithoutMargin(d[i]);
  }
  void getAabb(const btTransform& t, btVector3& lo, btVector3& hi) const override {
    const btScalar r = radii_[radii_.maxAxis()];
    lo = t.getOrigin() - btVector3(r, r, r), hi = t.getOrigin() + btVector3(r, r, r);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "Ellipsoid"; }

 private:
  btVector3 radii_;
};

std::unique_ptr<btConvexShape> native(const Solid& solid) {
  std::unique_ptr<btConvexShape> made;
  switch (solid.kind) {
    case Kind::sphere:
      return std::make_unique<btSphereShape>(static_cast<btScalar>(solid.radius));
    case Kind::capsule:
      return std::make_unique<btCapsuleShape>(static_cast<btScalar>(solid.radius),
                                              static_cast<btScalar>(2 * solid.half_height));
    case Kind::box:
      made = std::make_unique<btBoxShape>(vec(solid.half));
      break;
    case Kind::ellipsoid:
      return std::make_unique<Ellipsoid>(vec(solid.half));
    case Kind::hull: {
      auto hull = std::make_unique<btConvexHullShape>();
      for (std::size_t i = 0; i < solid.vertices; ++i) hull->addPoint(vec(&solid.xyz[3 * i]), false);
      made = std::move(hull);
      break;
    }
    default: {
      const double half[3] = {solid.radius, solid.half_height, solid.radius};
      made = std::make_unique<btCylinderShape>(vec(half));
    }
  }
  made->setMargin(0);
  return made;
}

btTransform pose(const Placement& at) {
  const double* const r = at.r;
  const auto s = [](double x) { return static_cast<btScalar>(x); };
  return btTransform(btMatrix3x3(s(r[0]), s(r[1]), s(r[2]), s(r[3]), s(r[4]), s(r[5]), s(r[6]), s(r[7]), s(r[8])),
                     vec(at.p));
}

enum class How { subsimplex, gjk, continuous };

class Bullet final : public CastPeer {
 public:
  explicit Bullet(How how) : how_(how) {}
  const char* name() const override {
#ifdef BT_USE_DOUBLE_PRECISION
#define PRECISION "f64"
#else
#define PRECISION "f32"
#endif
    return how_ == How::subsimplex ? "Bullet " PRECISION " sub-simplex"
           : how_ == How::gjk      ? "Bullet " PRECISION " GJK"
                                   : "Bullet " PRECISION " continuous";
  }
  bool can(Task task, Kind) const override {
    return task == Task::turning ? how_ == How::continuous : task == Task::linear || how_ == How::subsimplex;
  }
  void prepare(Task, const CastCase* cases, std::size_t count) override {
    pairs_.clear();
    natives_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c)
      pairs_.push_back(
          {c->a ? &of(*c->a) : &point_, &of(*c->b), pose(c->from_a), pose(c->to_a), pose(c->from_b), pose(c->to_b)});
  }
  double ask(std::size_t i) override {
    const Pair& p = pairs_[i];
    btVoronoiSimplexSolver simplex;
    btConvexCast::CastResult result;
    result.m_fraction = 1;
    bool hit = false;
    if (how_ == How::subsimplex) {
      btSubsimplexConvexCast cast(p.a, p.b, &simplex);
      hit = cast.calcTimeOfImpact(p.from_a, p.to_a, p.from_b, p.to_b, result);
    } else if (how_ == How::gjk) {
      btGjkConvexCast cast(p.a, p.b, &simplex);
      hit = cast.calcTimeOfImpact(p.from_a, p.to_a, p.from_b, p.to_b, result);
    } else {
      btGjkEpaPenetrationDepthSolver depth;
      btContinuousConvexCollision cast(p.a, p.b, &simplex, &depth);
      hit = cast.calcTimeOfImpact(p.from_a, p.to_a, p.from_b, p.to_b, result);
    }
    return hit ? static_cast<double>(result.m_fraction) : -1;
  }

 private:
  struct Pair {
    const btConvexShape *a, *b;
    btTransform from_a, to_a, from_b, to_b;
  };
  const btConvexShape& of(const Solid& solid) {
    std::unique_ptr<btConvexShape>& known = natives_[&solid];
    if (!known) known = native(solid);
    return *known;
  }
  How how_;
  btSphereShape point_{0};
  std::vector<Pair> pairs_;
  std::map<const Solid*, std::unique_ptr<btConvexShape>> natives_;
};

}  // namespace
}  // namespace carom::bench

extern "C" __attribute__((visibility("default"))) carom::bench::CastPeer* carom_bench_cast_peer(int i) {
  using carom::bench::How;
  return i < 3 ? new carom::bench::Bullet(static_cast<How>(i)) : nullptr;
}

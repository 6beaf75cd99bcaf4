// Bullet's own shapes and poses of the solids under test, in float or double as its headers say.
#pragma once

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <map>

#include "peer.h"

#ifdef BT_USE_DOUBLE_PRECISION
#define PRECISION "f64"
#else
#define PRECISION "f32"
#endif

namespace carom::bench {

inline btScalar real(double x) { return static_cast<btScalar>(x); }
inline btVector3 vec(double x, double y, double z) { return btVector3(real(x), real(y), real(z)); }
inline btVector3 vec(const double* v) { return vec(v[0], v[1], v[2]); }

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

inline std::unique_ptr<btConvexShape> native(const Solid& solid) {
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

/// Each solid's shape, made once.
class Natives {
 public:
  void clear() { made_.clear(); }  // solids of another set may lie where the last one's lay
  const btConvexShape& of(const Solid& solid) {
    std::unique_ptr<btConvexShape>& known = made_[&solid];
    if (!known) known = native(solid);
    return *known;
  }

 private:
  std::map<const Solid*, std::unique_ptr<btConvexShape>> made_;
};

inline btTransform pose(const Placement& at) {
  const double* const r = at.r;
  return btTransform(btMatrix3x3(real(r[0]), real(r[1]), real(r[2]), real(r[3]), real(r[4]), real(r[5]), real(r[6]),
                                 real(r[7]), real(r[8])),
                     vec(at.p));
}

}  // namespace carom::bench

// FCL's continuous collision by conservative advancement.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <map>

#include "peer.h"

namespace carom::bench {
namespace {

using Transform = fcl::Transform3<double>;
using V = fcl::Vector3<double>;

std::shared_ptr<fcl::ShapeBase<double>> native(const Solid& solid) {
  const double* const h = solid.half;
  switch (solid.kind) {
    case Kind::sphere:
      return std::make_shared<fcl::Sphere<double>>(solid.radius);
    case Kind::box:
      return std::make_shared<fcl::Box<double>>(2 * h[0], 2 * h[1], 2 * h[2]);
    case Kind::capsule:
      return std::make_shared<fcl::Capsule<double>>(solid.radius, 2 * solid.half_height);
    case Kind::cylinder:
      return std::make_shared<fcl::Cylinder<double>>(solid.radius, 2 * solid.half_height);
    case Kind::ellipsoid:
      return std::make_shared<fcl::Ellipsoid<double>>(h[0], h[1], h[2]);
    default:
      break;
  }
  const auto points = std::make_shared<std::vector<V>>();
  const auto faces = std::make_shared<std::vector<int>>();
  std::map<std::uint32_t, int> renumbered;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const std::uint32_t v = solid.triangles[t];
    const auto [at, fresh] = renumbered.emplace(v, static_cast<int>(points->size()));
    if (fresh) points->emplace_back(&solid.xyz[3 * v]);
    if (t % 3 == 0) faces->push_back(3);
    faces->push_back(at->second);
  }
  return std::make_shared<fcl::Convex<double>>(points, static_cast<int>(solid.triangles.size() / 3), faces);
}

Transform pose(const Solid& solid, const Placement& given) {
  const Placement at = z_up(solid, given);
  Transform t = Transform::Identity();
  for (int i = 0; i < 3; ++i) {
    t.translation()[i] = at.p[i];
    for (int k = 0; k < 3; ++k) t.linear()(i, k) = at.r[3 * i + k];
  }
  return t;
}

class Fcl final : public CastPeer {
 public:
  const char* name() const override { return "FCL conservative adv."; }
  /// It has no ray, and no advancement for ellipsoids (it says so, once a call).
  bool can(Task task, Kind kind) const override { return task != Task::ray && kind != Kind::ellipsoid; }
  void prepare(Task task, const CastCase* cases, std::size_t count) override {
    motion_ = task == Task::linear ? fcl::CCDM_TRANS : fcl::CCDM_LINEAR;
    pairs_.clear();
    natives_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c)
      pairs_.push_back({of(*c->a), of(*c->b), pose(*c->a, c->from_a), pose(*c->a, c->to_a), pose(*c->b, c->from_b),
                        pose(*c->b, c->to_b)});
  }
  double ask(std::size_t i) override {
    const Pair& p = pairs_[i];
    fcl::ContinuousCollisionRequest<double> request;
    request.ccd_motion_type = motion_;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.toc_err = 1e-6;
    fcl::ContinuousCollisionResult<double> result;
    fcl::continuousCollide(p.a, p.from_a, p.to_a, p.b, p.from_b, p.to_b, request, result);
    return result.is_collide ? result.time_of_contact : -1;
  }

 private:
  struct Pair {
    const fcl::CollisionGeometry<double>*a, *b;
    Transform from_a, to_a, from_b, to_b;
  };
  const fcl::CollisionGeometry<double>* of(const Solid& solid) {
    auto& known = natives_[&solid];
    if (!known) {
      known = native(solid);
      known->computeLocalAABB();
    }
    return known.get();
  }
  fcl::CCDMotionType motion_ = fcl::CCDM_TRANS;
  std::vector<Pair, Eigen::aligned_allocator<Pair>> pairs_;
  std::map<const Solid*, std::shared_ptr<fcl::ShapeBase<double>>> natives_;
};

}  // namespace
}  // namespace carom::bench

extern "C" __attribute__((visibility("default"))) carom::bench::CastPeer* carom_bench_cast_peer(int i) {
  return i == 0 ? new carom::bench::Fcl : nullptr;
}

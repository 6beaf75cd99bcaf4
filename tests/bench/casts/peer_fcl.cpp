// FCL's continuous collision by conservative advancement.
#include <fcl/narrowphase/continuous_collision.h>

#include "../convex/native_fcl.h"
#include "peer.h"

namespace carom::bench {
namespace {

class Fcl final : public CastPeer {
 public:
  const char* name() const override { return "FCL conservative adv."; }
  const char* lacks(Task task, const Solid& solid) const override {
    if (task == Task::ray) return "it has no rays";
    return solid.kind == Kind::ellipsoid ? "it does not advance ellipsoids" : nullptr;
  }
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
      known = with_native(solid, [](auto shape) { return std::shared_ptr<fcl::ShapeBase<double>>(shape); });
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

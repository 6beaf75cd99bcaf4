// Bullet's casts: the sub-simplex cast that its rays use, GJK's, and continuous convex collision.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "../convex/native_bullet.h"
#include "peer.h"

namespace carom::bench {
namespace {

enum class How { subsimplex, gjk, continuous };

class Bullet final : public CastPeer {
 public:
  explicit Bullet(How how) : how_(how) {}
  const char* name() const override {
    return how_ == How::subsimplex ? "Bullet " PRECISION " sub-simplex"
           : how_ == How::gjk      ? "Bullet " PRECISION " GJK"
                                   : "Bullet " PRECISION " continuous";
  }
  const char* lacks(Task task, const Solid&) const override {
    if (task == Task::turning && how_ != How::continuous) return "this cast does not turn";
    return task == Task::ray && how_ != How::subsimplex ? "rays are cast by its sub-simplex cast" : nullptr;
  }
  void prepare(Task, const CastCase* cases, std::size_t count) override {
    pairs_.clear();
    natives_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c)
      pairs_.push_back({c->a ? &natives_.of(*c->a) : &point_, &natives_.of(*c->b), pose(c->from_a), pose(c->to_a),
                        pose(c->from_b), pose(c->to_b)});
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
  How how_;
  btSphereShape point_{0};
  std::vector<Pair> pairs_;
  Natives natives_;
};

}  // namespace
}  // namespace carom::bench

extern "C" __attribute__((visibility("default"))) carom::bench::CastPeer* carom_bench_cast_peer(int i) {
  using carom::bench::How;
  return i < 3 ? new carom::bench::Bullet(static_cast<How>(i)) : nullptr;
}

// Bullet under test, in float or double as its headers say: GJK's pair detector with EPA beneath, and EPA's own
// distance.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "native_bullet.h"

namespace carom::bench {

namespace {

void copy(const btVector3& from, double* to) {
  for (int k = 0; k < 3; ++k) to[k] = from[k];
}

class Bullet : public Peer {
 public:
  void prepare(const Query* queries, std::size_t count) override {
    pairs_.clear();
    natives_.clear();
    for (const Query* q = queries; q < queries + count; ++q)
      pairs_.push_back({&natives_.of(*q->a), &natives_.of(*q->b), pose(q->at_a), pose(q->at_b)});
  }

 protected:
  struct Pair {
    const btConvexShape *a, *b;
    btTransform pose_a, pose_b;
  };
  std::vector<Pair> pairs_;

 private:
  Natives natives_;
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

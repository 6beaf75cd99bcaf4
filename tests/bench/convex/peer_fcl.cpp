// FCL under test: its signed distance over libccd's simplex code, and its own GJK with EPA.
//
// The solvers are called beneath fcl::distance and fcl::collide, whose tables know shortcuts for boxes and capsules:
// what is compared is convex cores.
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <stdexcept>

#include "native_fcl.h"

namespace carom::bench {

namespace {

int g_calls = 0;

/// A shape of FCL's and what its solver over libccd wants to know of it.
struct Native {
  std::shared_ptr<fcl::ShapeBase<double>> shape;
  void* (*create)(const fcl::ShapeBase<double>&, const Transform&);
  void (*destroy)(void*);
  fcl::detail::GJKSupportFunction support;
};

template <class S>
Native native(std::shared_ptr<S> shape) {
  using Initializer = fcl::detail::GJKInitializer<double, S>;
  static const auto inner = Initializer::getSupportFunction();
  return {std::move(shape),
          [](const fcl::ShapeBase<double>& s, const Transform& pose) {
            return Initializer::createGJKObject(static_cast<const S&>(s), pose);
          },
          Initializer::deleteGJKObject,
          [](const void* object, const ccd_vec3_t* d, ccd_vec3_t* out) {
            ++g_calls;
            inner(object, d, out);
          }};
}

class Fcl : public Peer {
 public:
  void prepare(const Query* queries, std::size_t count) override {
    pairs_.clear();
    natives_.clear();  // solids of another set may lie where the last one's lay
    for (const Query* q = queries; q < queries + count; ++q)
      pairs_.push_back({&of(*q->a), &of(*q->b), pose(*q->a, q->at_a), pose(*q->b, q->at_b)});
  }

 protected:
  struct Pair {
    const Native *a, *b;
    Transform pose_a, pose_b;
  };

  static void answer_points(const V& on_a, const V& on_b, Answer& answer) {
    const V between = answer.overlap ? V(on_a - on_b) : V(on_b - on_a);
    for (int k = 0; k < 3; ++k) answer.normal[k] = between[k];
  }

  std::vector<Pair, Eigen::aligned_allocator<Pair>> pairs_;

 private:
  const Native& of(const Solid& solid) {
    const auto known = natives_.find(&solid);
    return known != natives_.end() ? known->second : natives_.emplace(&solid, make(solid)).first->second;
  }

  static Native make(const Solid& solid) {
    return with_native(solid, [](auto shape) { return native(std::move(shape)); });
  }

  std::map<const Solid*, Native> natives_;
};

class FclOverCcd final : public Fcl {
 public:
  const char* name() const override { return "FCL signed distance"; }
  void ask(std::size_t i, Answer& answer) override {
    const Pair& p = pairs_[i];
    void* const a = p.a->create(*p.a->shape, p.pose_a);
    void* const b = p.b->create(*p.b->shape, p.pose_b);
    V on_a, on_b;
    g_calls = 0;
    try {
      fcl::detail::GJKSignedDistance<double>(a, p.a->support, b, p.b->support, kIterations, kTolerance,
                                             &answer.separation, &on_a, &on_b);
      answer.overlap = answer.separation <= 0;
      answer_points(on_a, on_b, answer);
    } catch (const std::exception&) {
      answer.separation = HUGE_VAL;  // an exception is no answer
    }
    answer.calls = g_calls / 2;
    p.a->destroy(a), p.b->destroy(b);
  }

 private:
  static constexpr unsigned kIterations = 500;  // FCL's defaults
  static constexpr double kTolerance = 1e-6;
};

class FclOwn final : public Fcl {
 public:
  const char* name() const override { return "FCL GJK + EPA"; }
  void ask(std::size_t i, Answer& answer) override {
    using Gjk = fcl::detail::GJK<double>;
    using Epa = fcl::detail::EPA<double>;
    const Pair& p = pairs_[i];
    fcl::detail::MinkowskiDiff<double> difference;
    difference.shapes[0] = p.a->shape.get();
    difference.shapes[1] = p.b->shape.get();
    difference.toshape1 = p.pose_b.linear().transpose() * p.pose_a.linear();
    difference.toshape0 = p.pose_a.inverse(Eigen::Isometry) * p.pose_b;
    Gjk gjk(128, 1e-6);  // the defaults of its solver
    const V guess(1, 0, 0);
    V on_a = V::Zero(), on_b = V::Zero();
    const auto status = gjk.evaluate(difference, -guess);
    if (status == Gjk::Valid) {
      const auto& simplex = *gjk.getSimplex();
      for (std::size_t k = 0; k < simplex.rank; ++k) {
        on_a += simplex.p[k] * difference.support(simplex.c[k]->d, 0);
        on_b += simplex.p[k] * difference.support(-simplex.c[k]->d, 1);
      }
      answer.separation = (on_a - on_b).norm();
      answer_points(p.pose_a.linear() * on_a, p.pose_a.linear() * on_b, answer);
    } else if (status == Gjk::Inside) {
      answer.overlap = true;
      answer.separation = HUGE_VAL;
      Epa epa(128, 64, 255, 1e-6);
      if (epa.evaluate(gjk, -guess) == Epa::Failed) return;
      answer.separation = -epa.depth;
      const V n = p.pose_a.linear() * epa.normal;
      for (int k = 0; k < 3; ++k) answer.normal[k] = n[k];
    } else {
      answer.separation = HUGE_VAL;
    }
  }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) Peer* carom_bench_peer(int i) {
  if (i == 0) return new FclOverCcd;
  if (i == 1) return new FclOwn;
  return nullptr;
}

}  // namespace carom::bench

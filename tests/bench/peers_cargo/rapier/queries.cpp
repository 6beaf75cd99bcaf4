// Casts and pairs of Rapier's library of shapes, parry, for casts_vs_peers and convex_vs_peers: the work is in Rust.
#include "../../casts/peer.h"

using namespace carom::bench;

/// What ../src/queries.rs is told of a solid.
struct RustSolid {
  const void* id;
  int kind;
  double radius, half_height, half[3];
  std::size_t vertices;
  const double* xyz;
};
struct RustAnswer {
  bool overlap;
  double separation, normal[3];
};

extern "C" {
void* carom_rust_queries();
void carom_rust_queries_free(void* queries);
void carom_rust_queries_clear(void* queries);
/// @param a  null: a ray   @param poses  from_a, to_a, from_b, to_b
void carom_rust_queries_add(void* queries, const RustSolid* a, const RustSolid* b, const Placement* poses);
double carom_rust_cast(const void* queries, int task, std::size_t i);
void carom_rust_pair(const void* queries, std::size_t i, RustAnswer* answer);
const char* carom_rust_shapes_name();
}

namespace {

RustSolid plain(const Solid& s) {
  return {&s, static_cast<int>(s.kind), s.radius, s.half_height, {s.half[0], s.half[1], s.half[2]}, s.vertices, s.xyz};
}

const char* missing(const Solid& s) { return s.kind == Kind::ellipsoid ? "it has no ellipsoid" : nullptr; }

class Queries {
 public:
  ~Queries() { carom_rust_queries_free(queries_); }
  void add(const Solid* a, const Solid& b, const Placement (&poses)[4]) {
    const RustSolid plain_b = plain(b);
    if (!a) return carom_rust_queries_add(queries_, nullptr, &plain_b, poses);
    const RustSolid plain_a = plain(*a);
    carom_rust_queries_add(queries_, &plain_a, &plain_b, poses);
  }
  void clear() { carom_rust_queries_clear(queries_); }
  const void* get() const { return queries_; }

 private:
  void* queries_ = carom_rust_queries();
};

class Casts final : public CastPeer {
 public:
  const char* name() const override { return carom_rust_shapes_name(); }
  const char* lacks(Task, const Solid& solid) const override { return missing(solid); }
  void prepare(Task task, const CastCase* cases, std::size_t count) override {
    task_ = task;
    queries_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c)
      queries_.add(c->a, *c->b, {c->from_a, c->to_a, c->from_b, c->to_b});
  }
  double ask(std::size_t i) override { return carom_rust_cast(queries_.get(), static_cast<int>(task_), i); }

 private:
  Task task_ = Task::ray;
  Queries queries_;
};

class Pairs final : public Peer {
 public:
  const char* name() const override { return carom_rust_shapes_name(); }
  const char* lacks(const Solid& solid) const override { return missing(solid); }
  void prepare(const Query* queries, std::size_t count) override {
    queries_.clear();
    for (const Query* q = queries; q < queries + count; ++q)
      queries_.add(q->a, *q->b, {q->at_a, q->at_a, q->at_b, q->at_b});
  }
  void ask(std::size_t i, Answer& answer) override {
    RustAnswer told;
    carom_rust_pair(queries_.get(), i, &told);
    answer.overlap = told.overlap;
    answer.separation = told.separation;
    for (int k = 0; k < 3; ++k) answer.normal[k] = told.normal[k];
  }

 private:
  Queries queries_;
};

}  // namespace

extern "C" CastPeer* carom_peer_casts(int i) { return i == 0 ? new Casts : nullptr; }
extern "C" Peer* carom_peer_pairs(int i) { return i == 0 ? new Pairs : nullptr; }

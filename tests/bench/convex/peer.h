// What a convex-pair library under test is shown and asked. Plain data: libraries are compiled as they want to be,
// Eigen vectorised in one and not in another, without a header of Carom's.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace carom::collision {
struct Shape;
}

namespace carom::bench {

enum class Kind { sphere, capsule, box, hull, cylinder, cone, ellipsoid };
inline constexpr const char* kKinds[] = {"sphere", "capsule", "box", "hull", "cylinder", "cone", "ellipsoid"};

/// Hulls with more vertices than this are climbed, not scanned, by the libraries that are given a support callback.
inline constexpr std::size_t kScan = 32;

/// A solid as every library is given it. Axes of capsules, cylinders and cones lie along y, apexes at +y.
struct Solid {
  Kind kind = Kind::sphere;
  double radius = 0;             // m: sphere, capsule, cylinder, cone
  double half_height = 0;        // m: capsule (of its segment), cylinder, cone
  double half[3] = {0, 0, 0};    // m: box; radii of an ellipsoid
  double core_radius = 0;        // m: the solid is what core_support() describes, swollen by this
  double middle[3] = {0, 0, 0};  // m: of the bounds

  std::size_t vertices = 0;  // hull
  const double* xyz = nullptr;
  std::vector<std::uint32_t> triangles;         // hull: [3m] counter-clockwise seen from outside; none if it is flat
  std::vector<std::uint32_t> first, neighbour;  // hull: neighbours of vertex v are neighbour[first[v] .. first[v + 1])
  std::uint32_t start = 0;                      // hull: a vertex that has neighbours

  std::int32_t (*scan)(void*, const double*, std::uint64_t, const double*, double*) = nullptr;  // support of the core
  const double* params = nullptr;
  std::uint64_t param_count = 0;
  const collision::Shape* shape = nullptr;  // Carom's
};

struct Placement {
  double r[9];  // row by row, solid -> world
  double p[3];  // m, world

  void rotate(const double* x, double* out) const {
    for (int i = 0; i < 3; ++i) out[i] = r[3 * i] * x[0] + r[3 * i + 1] * x[1] + r[3 * i + 2] * x[2];
  }
  void rotate_inverse(const double* x, double* out) const {
    for (int i = 0; i < 3; ++i) out[i] = r[i] * x[0] + r[3 + i] * x[1] + r[6 + i] * x[2];
  }
  void apply(const double* x, double* out) const {
    rotate(x, out);
    for (int i = 0; i < 3; ++i) out[i] += p[i];
  }
};

struct Query {
  const Solid *a, *b;
  Placement at_a, at_b;
  int track = 0;  // queries of one track are the same pair in successive frames
};

struct Answer {
  bool overlap = false;
  double separation = NAN;             // m, negative in overlap; NaN: the library gives none, infinite: it failed to
  double normal[3] = {NAN, NAN, NAN};  // world, A to B, any length; NaN: none given
  int calls = 0;                       // pairs of support calls; 0: they can't be counted
};

class Peer {
 public:
  virtual ~Peer() = default;
  virtual const char* name() const = 0;
  /// Whether an answer starts from the last one of the same track: then random pairs say nothing about it.
  virtual bool remembers() const { return false; }
  /// What the library lacks to be asked about such a solid, in words; null: nothing.
  virtual const char* lacks(const Solid&) const { return nullptr; }
  /// Build the library's own shapes and poses, off the clock. The queries outlive the answers.
  virtual void prepare(const Query* queries, std::size_t count) = 0;
  virtual void ask(std::size_t i, Answer& answer) = 0;
};

using Peers = std::vector<std::unique_ptr<Peer>>;

void add_carom(Peers& peers);
/// Carom by one sub-algorithm (0 to 2, as its dial counts) at one tolerance.
std::unique_ptr<Peer> make_carom(std::uint32_t simplex, double tolerance);
void add_ccd(Peers& peers);

/// What a shared object with libraries exports as `carom_bench_peer`: the i-th of them, null past the last.
using PeerModule = Peer* (*)(int i);

/// Load such an object into a link namespace of its own: two Bullets that bear the same names, and templates of Eigen's
/// compiled in two ways, then do not meet.
/// @throws std::runtime_error  with what the loader said
void add_module(Peers& peers, const char* path);

/// Support point of a solid's core.
/// @param d     [3] solid's frame, not zero, any length
/// @param hint  where a climb starts; out: where it ended
inline void core_support(const Solid& solid, const double* d, double* out, std::uint32_t& hint) {
  if (solid.vertices <= kScan || solid.triangles.empty()) {
    solid.scan(nullptr, solid.params, solid.param_count, d, out);
    return;
  }
  const double* const xyz = solid.xyz;
  const auto height = [&](std::uint32_t v) {
    return d[0] * xyz[3 * v] + d[1] * xyz[3 * v + 1] + d[2] * xyz[3 * v + 2];
  };
  double best = height(hint);
  for (std::uint32_t from = ~0u; from != hint;) {
    from = hint;
    for (std::uint32_t i = solid.first[from]; i < solid.first[from + 1]; ++i) {
      const double h = height(solid.neighbour[i]);
      if (h > best) best = h, hint = solid.neighbour[i];
    }
  }
  for (std::uint32_t i = 0; i < 3; ++i) out[i] = xyz[3 * hint + i];
}

/// The same solid for libraries whose capsules, cylinders and cones stand along z.
inline Placement z_up(const Solid& solid, const Placement& at) {
  if (solid.kind != Kind::capsule && solid.kind != Kind::cylinder && solid.kind != Kind::cone) return at;
  Placement turned = at;
  for (int i = 0; i < 3; ++i) {  // z to y, y to -z
    turned.r[3 * i + 1] = -at.r[3 * i + 2];
    turned.r[3 * i + 2] = at.r[3 * i + 1];
  }
  return turned;
}

}  // namespace carom::bench

#include "dynamics/solver/direct/unchanged.h"

#include <bit>
#include <cstring>

#include "dynamics/contact/turning_ground.h"

namespace carom::dynamics {
namespace {

/// A hash in four streams, which machines go through side by side: order matters within each, every bit counts.
class Print {
 public:
  explicit Print(std::uint64_t seed) { number_ = seed; }
  void add(std::uint64_t word) { number_ = mixed(number_, word); }
  void add(Real x) { add(bits(x)); }
  void add(const Vec3& v) {
    for (std::size_t i = 0; i < 3; ++i) axis_[i] = mixed(axis_[i], bits(v.at[i]));
  }
  void add(const Quat& q) { add(q.vec()), add(q.w()); }
  void add(const Mat3& m) { add(m.col(0)), add(m.col(1)), add(m.col(2)); }
  std::uint64_t value() const {
    std::uint64_t all = number_;
    for (const std::uint64_t axis : axis_) all = mixed(all, axis);
    return mixed(all, 0);
  }

 private:
  static std::uint64_t mixed(std::uint64_t state, std::uint64_t word) {
    return std::rotl(state ^ word, 29) * 0x9E3779B97F4A7C15ull;
  }
  static std::uint64_t bits(Real x) {
    std::uint64_t word;
    std::memcpy(&word, &x, sizeof word);
    return word;
  }

  std::uint64_t number_, axis_[3] = {1, 2, 3};
};

/// Where a body is, and what it does.
void add_motion(Print& h, const State& s, std::uint32_t slot) {
  h.add(std::uint64_t(slot));
  h.add(s.x[slot]), h.add(s.q[slot]);
  h.add(s.v[slot]), h.add(s.omega[slot]);
}

void add_body(Print& h, const World& world, std::uint32_t slot) {
  const Scene& scene = world.scene;
  add_motion(h, world.state, slot);
  h.add(world.state.held_q[slot]);
  h.add(scene.mass[slot]), h.add(scene.inv_mass[slot]);
  h.add(scene.inertia[slot]), h.add(scene.inv_inertia[slot]);
  h.add(scene.gravity_factor_of(slot));
  h.add(std::uint64_t(scene.locks_of(slot)));
}

/// What the rows of a pair have in common.
void add_pair(Print& h, const World& world, const Row& row, const RowGeometry& g) {
  const Pair pair = world.pairs.place(g.pair).pair;
  const Array<const Shape*>& shape = world.scene.colliders.shape;
  h.add(pair.key());
  for (const Shape* const of : {shape[pair.a], shape[pair.b]})
    h.add(std::uint64_t(reinterpret_cast<std::uintptr_t>(of))), h.add(thickness(*of));
  if (!row.moves_a) add_motion(h, world.state, row.a);
  if (!row.moves_b) add_motion(h, world.state, row.b);
  const bool flags[] = {row.moves_a, row.moves_b,        row.one_normal,  row.rolls,
                        row.slides,  row.slides_by_load, row.loads_known, g.is_asked_again};
  std::uint64_t bits = 0;
  for (const bool flag : flags) bits = 2 * bits + flag;
  h.add(bits);
  h.add(row.slides ? row.twist_share : 0);
  h.add(row.friction), h.add(row.restitution);
  h.add(g.radius_a), h.add(g.radius_b);
}

}  // namespace

std::uint64_t print_of_step(const World& world, Real h) {
  Print print(0);
  for (const Real value : world.scene.dials.value) print.add(value);
  print.add(world.scene.gravity);
  print.add(h), print.add(std::uint64_t(world.plan->substeps));
  return print.value();
}

std::uint64_t print_of_problem(const World& world, std::span<const ConeBody> bodies,
                               std::span<const std::uint32_t> rows, std::uint64_t of_step) {
  const Contacts& c = *world.contacts;
  Print print(of_step);
  for (const ConeBody& b : bodies) add_body(print, world, b.slot);
  for (const std::uint32_t at : rows) {
    const Row& row = c.rows[at];
    const RowGeometry& g = c.geometry[at];
    if (turning_pair_at(c, at)) return 0;
    if (g.point == 0) add_pair(print, world, row, g);
    print.add(row.n), print.add(row.p);
    print.add(g.l_a), print.add(g.l_b);
    print.add(g.separation);
    if (!c.surface.empty()) print.add(c.surface[at]);
  }
  return print.value() | 1;
}

std::uint64_t print_of_motion(const World& world, std::span<const ConeBody> bodies) {
  const State& s = world.state;
  Print print(0);
  for (const ConeBody& b : bodies) print.add(s.v[b.slot]), print.add(s.omega[b.slot]);
  return print.value();
}

}  // namespace carom::dynamics

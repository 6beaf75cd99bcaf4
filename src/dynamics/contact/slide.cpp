// Which pairs slide as a step begins.
#include "dynamics/contact/slide.h"

#include <algorithm>

#include "dynamics/body_state.h"

namespace carom::dynamics {
namespace {

constexpr Real kLeast2 = kCreeps.value * kCreeps.value;

/// One pair's points.
struct Patch {
  const World& world;
  const Row* rows;
  const RowGeometry* geometry;
  std::uint32_t count;

  Patch(const World& w, std::uint32_t first, std::uint32_t n)
      : world(w), rows(&w.contacts->rows[first]), geometry(&w.contacts->geometry[first]), count(n) {}

  bool bears() const {
    bool touches = false;
    Real deepest = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      deepest = std::min(deepest, geometry[k].separation);
      touches |= geometry[k].separation <= 0 || rows[k].p != Vec3::zero();
    }
    return touches && deepest >= -world.scene.dials[Dial::contact_distance];
  }
  /// (m/s)^2: no point can slip as fast, however both move together: without a root.
  Real most_slip2() const {
    const State& s = world.state;
    const Pair& pair = world.pairs.place(geometry->pair).pair;
    const Real turns2 = most_speed2(rows->a, pair.a) + most_speed2(rows->b, pair.b);
    return 3 * ((s.v[rows->b] - s.v[rows->a]).squared_norm() + turns2);
  }
  /// (m/s)^2, bound on what a body's spin moves any place of a collider of it.
  Real most_speed2(std::uint32_t body, std::uint32_t collider) const {
    const Real turn2 = world.state.omega[body].squared_norm();
    if (!(turn2 > 0)) return 0;
    const Real radius = world.scene.colliders.shape[collider]->bounding_radius;
    return 2 * turn2 * (world.plan->local[collider].p.squared_norm() + radius * radius);
  }
  bool slips(const Vec3* surface) const {
    const State& s = world.state;
    const std::uint32_t a = rows->a, b = rows->b;
    const Vec3& n = rows->n;
    const auto is_fast = [&](const Vec3& u) { return (u - u.dot(n) * n).squared_norm() > kLeast2; };
    // At the first point, taken on the body that moves; others by how they lie about it.
    const bool on_b = rows->moves_b;
    const Mat3& turned = world.plan->rotation[on_b ? b : a];
    const Vec3 apart = s.x[b] - s.x[a];
    const Vec3 arm =
        on_b ? turned * geometry->l_b - geometry->radius_b * n : turned * geometry->l_a + geometry->radius_a * n;
    const Vec3 r_a = on_b ? arm + apart : arm, r_b = on_b ? arm : arm - apart;
    const Vec3 u = relative_velocity(s, *rows, r_a, r_b);
    if (is_fast(surface ? u + surface[0] : u)) return true;
    const Vec3 spin = s.omega[b] - s.omega[a];
    for (std::uint32_t k = 1; k < count; ++k) {
      const Vec3 from_first = on_b ? geometry[k].l_b - geometry[0].l_b : geometry[k].l_a - geometry[0].l_a;
      const Vec3 other = u + spin.cross(turned * from_first);
      if (is_fast(surface ? other + surface[k] : other)) return true;
    }
    return false;
  }
  /// Whether friction starts from most of what the loads allow: loads of what tips, rolls or parts will not stay.
  bool slides_all_over() const {
    Real load = 0, rub = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const Real normal = rows[k].p.dot(rows[k].n);
      load += rows[k].friction * normal, rub += (rows[k].p - normal * rows[k].n).norm();
    }
    return 2 * rub > load;
  }
};

}  // namespace

void look_for_slide(const World& world, std::uint32_t first, std::uint32_t count, const Vec3* surface) {
  const Patch patch(world, first, count);
  Row& row = world.contacts->rows[first];
  row.slides = (surface || !(patch.most_slip2() <= kLeast2)) && patch.bears() && patch.slips(surface);
  row.slides_by_load = row.slides && row.loads_known && patch.slides_all_over();
  if (!row.slides) return;
  const collision::Manifold& manifold = world.pairs[patch.geometry->pair].manifold;
  row.twist_share = twist_share(manifold.count, manifold.has_more_corners);
}

bool may_slide(const World& world, std::uint32_t first, std::uint32_t count, Real more2) {
  const Patch patch(world, first, count);
  return !(2 * (patch.most_slip2() + more2) <= kLeast2) && patch.bears();
}

}  // namespace carom::dynamics

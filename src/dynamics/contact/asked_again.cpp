#include "dynamics/contact/asked_again.h"

#include <algorithm>
#include <span>
#include <utility>

#include "collision/narrow/hybrid.h"
#include "collision/support.h"
#include "core/float_guard.h"
#include "dynamics/contact/depth.h"
#include "dynamics/detect.h"
#include "dynamics/solver/direct.h"

namespace carom::dynamics {
namespace {

/// m, by which points of a collider leave the tangent of their way within a time. A spin about the normal is none to a
/// contact, nor is one of a sphere.
Real leaves_tangent(const World& world, std::uint32_t collider, std::uint32_t body, const Vec3& n, Real time) {
  const Shape& shape = *world.scene.colliders.shape[collider];
  if (shape.form == Form::sphere || shape.form == Form::half_space) return 0;
  return extent(shape) * time * time * world.state.omega[body].cross(n).squared_norm() / 2;
}

bool is_of_scenery(const World& world, const Pair& pair) {
  const Array<const Shape*>& shape = world.scene.colliders.shape;
  return is_scenery(*shape[pair.a]) || is_scenery(*shape[pair.b]);
}

const Pair& pair_of(const World& world, const ContactPair& m) {
  return world.pairs.place(world.contacts->geometry[m.row].pair).pair;
}

/// A contact pair where its bodies are now.
class Asking {
 public:
  Asking(const World& world, const ContactPair& m)
      : world_(world),
        m_(m),
        pair_(pair_of(world, m)),
        r_a_(world.state.q[m.a].matrix()),
        r_b_(world.state.q[m.b].matrix()),
        frame_a_(frame(pair_.a, m.a, r_a_)),
        frame_b_(frame(pair_.b, m.b, r_b_)) {}

  void ask(NarrowSettings settings, StepReport& report) {
    Contacts& c = *world_.contacts;
    const Colliders& table = world_.scene.colliders;
    settings.manifold.contact_distance += table.reach[pair_.a] + table.reach[pair_.b];
    QueryMemory memory = world_.pairs[c.geometry[m_.row].pair].memory;
    SupportFault fault;
    Manifold manifold;
    manifold.count = 0;
    find_manifold({*table.shape[pair_.a], *table.shape[pair_.b], frame_a_, frame_b_, shells(settings.query) / 2},
                  settings, memory, manifold, report.narrow, fault);
    if (fault.kind == SupportFault::none && manifold.count > 0) take({manifold.point, std::size_t(manifold.count)});
  }

 private:
  Frame frame(std::uint32_t collider, std::uint32_t body, const Mat3& r) const {
    const Frame& local = world_.plan->local[collider];
    return {r * local.r, world_.state.x[body] + r * local.p};
  }

  void take(std::span<ContactPoint> points) {
    Contacts& c = *world_.contacts;
    for (std::size_t k = 1; k < points.size(); ++k)  // the deepest first
      for (std::size_t l = k; l > 0 && points[l].separation < points[l - 1].separation; --l)
        std::swap(points[l], points[l - 1]);
    const Vec3 first = points[0].normal;
    const bool one_normal = std::ranges::all_of(points, [&](const ContactPoint& p) { return p.normal == first; });
    std::uint32_t taken = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(points.size(), m_.count); ++k) {
      const std::uint32_t at = nearest_row(points[k], taken);
      taken |= 1u << at;
      put(points[k], c.rows[m_.row + at], c.geometry[m_.row + at]);
    }
    for (std::uint32_t k = 0; k < m_.count; ++k) {
      c.rows[m_.row + k].one_normal = one_normal;
      if (one_normal) c.rows[m_.row + k].n = first;
    }
  }

  std::uint32_t nearest_row(const ContactPoint& point, std::uint32_t taken) const {
    const Contacts& c = *world_.contacts;
    const Vec3 place = frame_a_.apply(point.on_a);
    std::uint32_t nearest = 0;
    Real least = kInfinity;
    for (std::uint32_t k = 0; k < m_.count; ++k) {
      if (taken >> k & 1) continue;
      const RowGeometry& g = c.geometry[m_.row + k];
      const Vec3 on_a = world_.state.x[m_.a] + r_a_ * g.l_a + g.radius_a * c.rows[m_.row + k].n;
      if (const Real d = (on_a - place).squared_norm(); d < least) least = d, nearest = k;
    }
    return nearest;
  }

  void put(const ContactPoint& point, Row& row, RowGeometry& g) const {
    row.n = point.normal;
    g.l_a = world_.plan->local[pair_.a].apply(point.on_a) - g.radius_a * (r_a_.transpose() * row.n);
    g.l_b = world_.plan->local[pair_.b].apply(point.on_b) + g.radius_b * (r_b_.transpose() * row.n);
    g.separation = point.separation;
    g.place = world_.scene.type[m_.a] != BodyType::dynamic ? point.on_b : point.on_a;
  }

  const World& world_;
  const ContactPair& m_;
  const Pair& pair_;
  const Mat3 r_a_, r_b_;
  const Frame frame_a_, frame_b_;
};

}  // namespace

void find_asked_again(const World& world, const StepTime& time) {
  Contacts& c = *world.contacts;
  c.any_asked_again = false;
  if (world.plan->substeps == 1 && !world.accuracy) return;
  for (const ContactPair& m : c.contact_pairs) {
    const Pair& pair = pair_of(world, m);
    const Vec3& n = c.rows[m.row].n;
    const Real leaves = leaves_tangent(world, pair.a, m.a, n, time.dt) + leaves_tangent(world, pair.b, m.b, n, time.dt);
    if (!(leaves > kAskedAgain * tolerable_depth(world, c.geometry[m.row])) || is_of_scenery(world, pair)) continue;
    for (std::uint32_t k = 0; k < m.count; ++k) c.geometry[m.row + k].is_asked_again = true;
    c.any_asked_again = true;
  }
}

void ask_again(const World& world, StepReport& report, const StepTime&) {
  const Contacts& c = *world.contacts;
  if (!c.any_asked_again || world.direct->groups() == 0) return;
  const FloatGuard guard;
  NarrowSettings settings = narrow_settings(world.scene.dials);
  settings.manifold.kind = ManifoldKind::clip;
  for (const ContactPair& m : c.contact_pairs) {
    if (!c.geometry[m.row].is_asked_again) continue;
    const GroupRest* const rest = world.direct->rest_of(c.rows[m.row]);
    if (!rest || rest->is_first) continue;
    Asking(world, m).ask(settings, report);
    guard.put_back();
  }
}

}  // namespace carom::dynamics

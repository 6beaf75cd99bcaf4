// Contacts whose surfaces move of themselves.
#include "dynamics/contact/surface.h"

#include "dynamics/contact/slide.h"
#include "dynamics/contact/turning_ground.h"

namespace carom::dynamics {
namespace {

/// What moves it, unless a host forbids that.
SurfaceVelocity allowed_surface(const Scene& scene, std::uint32_t collider) {
  const bool forbidden = scene.modes.forbids(+EffectId::surface_velocity, scene.colliders.body[collider]);
  return forbidden ? SurfaceVelocity{} : scene.surface_of(collider);
}

/// A surface as the step began.
struct Moving {
  Vec3 linear, angular;  // m/s, rad/s, world
  Vec3 origin;           // m, world

  Moving(const Scene& scene, std::uint32_t collider) : origin(scene.colliders.frame[collider].p) {
    const SurfaceVelocity surface = allowed_surface(scene, collider);
    const Mat3& r = scene.colliders.frame[collider].r;
    linear = r * surface.linear, angular = r * surface.angular;
  }
  /// m/s, world   @param arm  m, world axes, from x, m, world
  Vec3 at(const Vec3& x, const Vec3& arm) const { return linear + angular.cross((x - origin) + arm); }
};

}  // namespace

Surface::Surface(const World& world, std::uint32_t collider, std::uint32_t body) : origin(Vec3::zero()) {
  const SurfaceVelocity surface = allowed_surface(world.scene, collider);
  linear = surface.linear, angular = surface.angular;
  if (!surface.any()) return;
  const Frame frame = Frame(world.state.q[body].matrix(), world.state.x[body]) * world.plan->local[collider];
  linear = frame.r * surface.linear, angular = frame.r * surface.angular, origin = frame.p;
}

void find_surfaces(const World& world, const StepTime& time) {
  Contacts& c = *world.contacts;
  const Scene& scene = world.scene;
  c.driven.clear(), c.surface.clear();
  std::uint64_t driven = 0;
  for (std::uint32_t i = 0, next; scene.moving_surfaces > 0 && i < c.rows.size(); i = next) {
    next = c.first_row[c.geometry[i].pair + 1];
    const Pair& pair = world.pairs.place(c.geometry[i].pair).pair;
    if (!allowed_surface(scene, pair.a).any() && !allowed_surface(scene, pair.b).any()) continue;
    const Moving a(scene, pair.a), b(scene, pair.b);
    c.surface.resize(c.rows.size(), Vec3::zero());
    for (std::uint32_t k = i; k < next; ++k) {
      const Row& row = c.rows[k];
      const Arms arms(world, row, c.geometry[k]);
      const Vec3 s = b.at(world.state.x[row.b], arms.b) - a.at(world.state.x[row.a], arms.a);
      c.surface[k] = s - s.dot(row.n) * row.n;
    }
    find_slide(world, i, next - i, &c.surface[i]);
    c.driven.push_back({i, next - i, b.angular - a.angular});
    driven += next - i;
  }
  count_participants(world, EffectId::surface_velocity, driven);
  find_turning_pairs(world, time);
}

}  // namespace carom::dynamics

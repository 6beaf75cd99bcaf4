// Worlds for tests of the inside: shapes with their masses, a few bodies, many steps.
#pragma once

#include <list>
#include <memory_resource>
#include <vector>

#include "collision/volume.h"
#include "core/job_pool.h"
#include "dynamics/effects.h"
#include "dynamics/world.h"
#include "shapes.h"

namespace carom::test {

/// A world that owns the shapes its colliders use.
struct TestWorld {
  explicit TestWorld(const Vec3& gravity = Vec3(0, -9.81, 0)) : world(1, gravity, 0, std::pmr::new_delete_resource()) {}

  const Shape* keep(Shape shape) {
    shapes.push_back(std::move(shape));
    Shape& s = shapes.back();
    if (s.form != Form::half_space && s.form != Form::scenery)
      s.mass = mass_from_form(s.form, s.radius, s.half_height, s.half, s.vertices);
    return &s;
  }

  /// A body with one collider of density 1000 kg/m^3 about its origin. @return body slot
  std::uint32_t add(const Shape* shape, const Vec3& position, BodyType type = BodyType::dynamic,
                    const Quat& orientation = Quat::identity(), std::uint32_t material = Colliders::kNoMaterial) {
    BodyDef def;
    def.type = type;
    def.pose = {orientation, position};
    const std::uint32_t body = handle_slot(world.add_body(def));
    if (shape) world.add_collider(body, shape, Pose{}, 1000, material);
    return body;
  }

  /// The half-space y <= 0, static.
  std::uint32_t ground(std::uint32_t material = Colliders::kNoMaterial) {
    Shape s(std::pmr::get_default_resource());
    s.form = Form::half_space;
    s.bounding_radius = kInfinity;
    s.bounds = {Vec3::constant(-kInfinity), Vec3::constant(kInfinity)};
    return add(keep(std::move(s)), Vec3::zero(), BodyType::fixed, Quat::identity(), material);
  }

  std::uint32_t material(Real friction, Real restitution) {
    Material m;
    m.friction = friction;
    m.restitution = restitution;
    return handle_slot(world.add_material(m));
  }

  /// Five balls along x that touch, weightless, without friction or loss: the first comes from half a metre away at
  /// 1 m/s. @return body slots
  std::vector<std::uint32_t> cradle() {
    const std::uint32_t m = material(0, 1);
    const Shape* ball = keep(sphere(0.5));
    std::vector<std::uint32_t> row;
    for (int i = 0; i < 5; ++i)
      row.push_back(add(ball, Vec3(i > 0 ? i : -0.5, 0, 0), BodyType::dynamic, Quat::identity(), m));
    world.set_velocity(row[0], Vec3(1, 0, 0), Vec3::zero());
    return row;
  }

  void run(int steps, Real dt) {
    for (int i = 0; i < steps; ++i) world.step(dt);
  }

  std::list<Shape> shapes;
  World world;
};

/// Ask for an accuracy of place (m) and turn (rad), a second of motion.
inline void ask_accuracy(TestWorld& t, Real tolerance) {
  t.world.set_dial(Dial::accuracy_place, tolerance);
  t.world.set_dial(Dial::accuracy_turn, tolerance);
}

/// kg m/s, of all bodies.
inline Vec3 momentum(const World& w) {
  Vec3 p = Vec3::zero();
  for (std::uint32_t i = 0; i < w.scene.bodies.slots(); ++i) p += w.scene.mass[i] * w.state.v[i];
  return p;
}

/// CAROM_SOLVER_*
enum SolverChoice { kSeverityChoice, kSoftChoice, kDirectChoice, kAutoChoice, kSolverChoices };

/// Bits of a scene (a TestWorld) after some steps of 1/60 s.
/// @param solver  as of the dial   @param threads  that share a step
template <class Scene>
std::uint64_t hash_of_run(Real solver, std::uint32_t threads, int steps) {
  JobPool pool(
      threads, [] {}, std::pmr::new_delete_resource());
  Scene t;
  t.world.set_dial(Dial::solver, solver);
  if (threads > 1) t.world.jobs = &pool;
  t.run(steps, 1.0 / 60);
  return t.world.hash();
}

}  // namespace carom::test

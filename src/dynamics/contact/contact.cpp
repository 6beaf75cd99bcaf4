// What a substep makes of rows: effective masses, relative velocities, separations.
#include "dynamics/contact/contact.h"

#include <algorithm>

#include "dynamics/body_state.h"
#include "dynamics/contact/turning_ground.h"

namespace carom::dynamics {
namespace {

/// Let a row's starting impulse act.
void start_row(const World& world, Velocities& to, const Row& row, const RowMass& m) {
  const auto push = [&](std::uint32_t body, const Vec3& p, const Vec3& r) {
    push_body(world, to, body, p, r);
    world.plan->touched[body] = 1;
  };
  if (row.moves_a) push(row.a, -row.p, m.r_a);
  if (row.moves_b) push(row.b, row.p, m.r_b);
}

}  // namespace

void push_body(const World& world, Velocities& to, std::uint32_t body, const Vec3& p, const Vec3& r) {
  const Locks locks = world.scene.locks_of(body);
  to.v[body] += world.scene.inv_mass[body] * (locks ? Vec3(free_axes(locks).times(p)) : p);
  if (rotates(world.scene, body)) to.omega[body] += world.contacts->inv_inertia_w[body] * r.cross(p);
}

// K = (1/m_a + 1/m_b) 1 - [r_a]x I_a^-1 [r_a]x - [r_b]x I_b^-1 [r_b]x
Mat3 velocity_per_impulse(const World& world, const Row& row, const RowMass& m) {
  const Scene& scene = world.scene;
  Mat3 k = Mat3::zero();
  const auto add = [&](std::uint32_t body, const Vec3& r) {
    const Locks locks = scene.locks_of(body);
    k.add_to_diagonal(locks ? scene.inv_mass[body] * free_axes(locks) : Vec3::constant(scene.inv_mass[body]));
    if (!rotates(scene, body)) return;
    const Mat3 x = cross_matrix(r);
    k -= x * world.contacts->inv_inertia_w[body] * x;
  };
  if (row.moves_a) add(row.a, m.r_a);
  if (row.moves_b) add(row.b, m.r_b);
  return k;
}

void prepare_rows(const World& world, Velocities& to, Real h) {
  Contacts& c = *world.contacts;
  const State& s = world.state;
  for (const std::uint32_t i : c.bodies) world.plan->touched[i] = 0;
  refresh_inertias(world);
  for (const std::uint32_t i : c.bodies) c.half_of[i].end = c.half_of[i].begin;  // filled anew below
  for (const TurningPair& t : c.turning_pairs) {
    const Lead lead = lead_of(world, t, h);
    for (std::uint32_t i = t.row; i < t.row + t.points; ++i) c.rows[i].p = lead.taken_on(c.rows[i].p, c.rows[i].n, h);
  }
  for (std::uint32_t i = 0; i < c.rows.size(); ++i) {
    Row& row = c.rows[i];
    RowMass& m = c.mass[i];
    const RowGeometry& g = c.geometry[i];
    m.r_a = arm_a(world, row, g);
    m.r_b = arm_b(world, row, g);
    m.k = velocity_per_impulse(world, row, m);
    m.k_inv = m.k.inverse();
    row.k_n = row.n.dot(m.k * row.n);
    row.target = g.separation > 0 ? -g.separation / h : 0;
    if (row.moves_a) c.half[c.half_of[row.a].end++] = {m.r_a, i, -1};
    if (row.moves_b) c.half[c.half_of[row.b].end++] = {m.r_b, i, 1};
    row.set_impulse(row.p);
    if (row.p != Vec3::zero()) start_row(world, to, row, m);
  }
  for (std::size_t i = 0; i < c.rows.size(); ++i) {
    Row& row = c.rows[i];
    const RowMass& m = c.mass[i];
    row.u = relative_velocity(s, row, m.r_a, m.r_b);
  }
  for (std::size_t i = 0; i < c.surface.size(); ++i) c.rows[i].u += c.surface[i];
  for (const TurningPair& t : c.turning_pairs) {
    const Lead lead = lead_of(world, t, h);
    for (std::uint32_t i = t.row; i < t.row + t.points; ++i)
      c.rows[i].u += lead.along(c.mass[i].r_a - c.mass[i].r_b, c.rows[i].n);
  }
}

void refresh_inertias(const World& world) {
  Contacts& c = *world.contacts;
  const Scene& scene = world.scene;
  const Array<Mat3>& rotation = world.plan->rotation;
  in_parallel(world.jobs, c.bodies.size(), kBodiesAPart, [&](std::uint32_t k) {
    const std::uint32_t i = c.bodies[k];
    if (rotates(scene, i)) c.inv_inertia_w[i] = rotation[i] * scene.inv_inertia[i] * rotation[i].transpose();
  });
  world.plan->effects[+EffectId::axis_locks].participants.each([&](std::uint32_t i) {
    if (rotates(scene, i) && (scene.locks_of(i) & kAngularLocks))
      c.inv_inertia_w[i] = inverse_of_free(rotation[i] * scene.inertia[i] * rotation[i].transpose(), scene.locks_of(i));
  });
}

void refresh_rotations(const World& world) {
  Array<Mat3>& rotation = world.plan->rotation;
  const auto orient = [&](std::uint32_t i) { rotation[i] = world.state.q[i].matrix(); };
  const Array<std::uint32_t>& bodies = world.contacts->bodies;
  in_parallel(world.jobs, bodies.size(), kBodiesAPart, [&](std::uint32_t k) {
    if (rotates(world.scene, bodies[k])) orient(bodies[k]);
  });
  world.plan->kinematic.each(orient);
}

void refresh_separations(const World& world) {
  Contacts& c = *world.contacts;
  in_parallel(world.jobs, c.rows.size(), kRowsAPart,
              [&](std::uint32_t i) { c.geometry[i].separation = separation_of(world, c.rows[i], c.geometry[i]); });
}

}  // namespace carom::dynamics

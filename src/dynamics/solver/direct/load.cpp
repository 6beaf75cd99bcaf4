#include "dynamics/solver/direct/load.h"

#include "dynamics/contact/held_arms.h"
#include "dynamics/force/force.h"

namespace carom {
namespace {

/// Mean of the eigenvalues of what an impulse at a point does to the velocity there.
Real mean_response(const ConeBody* bodies, const ConeContact& c) {
  const auto of = [&](std::uint32_t body, const Vec3& r) {
    if (body == kNobody) return Real(0);
    const Mat3& w = bodies[body].inv_inertia;
    return bodies[body].inv_mass + (r.squaredNorm() * w.trace() - r.dot(w * r)) / 3;  // -trace([r]x w [r]x) = ...
  };
  return of(c.a, c.r_a) + of(c.b, c.r_b);
}

bool is_curved(const Shape& s) {
  return s.form != Form::box && s.form != Form::polytope && s.form != Form::half_space && !is_scenery(s);
}

}  // namespace

void load_mass(const World& world, ConeBody& b) {
  b.mass = world.scene.mass[b.slot], b.inv_mass = world.scene.inv_mass[b.slot];
  b.locks = world.scene.locks_of(b.slot);
  b.turns = rotates(world.scene, b.slot);
  if (!b.turns) return void((b.inertia.setIdentity(), b.inv_inertia.setZero(), b.held_back.setZero()));
  const Mat3& r = world.plan->rotation[b.slot];
  b.held_back = held_back(world, b.slot);
  b.inertia = r * world.scene.inertia[b.slot] * r.transpose();
  b.inv_inertia = b.locks & kAngularLocks ? inverse_of_free(b.inertia, b.locks)
                                          : Mat3(r * world.scene.inv_inertia[b.slot] * r.transpose());
}

void load_contact(const World& world, std::uint32_t row_index, const ConeBody* bodies, ConeContact& contact) {
  const Row& row = world.contacts->rows[row_index];
  const RowGeometry& g = world.contacts->geometry[row_index];
  Arms arms(world, row, g);
  if (contact.a != kNobody) arms.a += bodies[contact.a].held_back * g.l_a;
  if (contact.b != kNobody) arms.b += bodies[contact.b].held_back * g.l_b;
  const auto turns = [&](std::uint32_t body) { return body != kNobody && bodies[body].turns; };
  const bool turns_a = turns(contact.a), turns_b = turns(contact.b);
  contact.n = row.n;
  contact.r_a = turns_a ? arms.a : Vec3::Zero();
  contact.r_b = turns_b ? arms.b : Vec3::Zero();
  contact.k = mean_response(bodies, contact);
  // What of relative_velocity() is not relative() of the bodies here.
  const State& s = world.state;
  const Vec3 &v_a = s.v[row.a], &v_b = s.v[row.b], spin_a = s.omega[row.a].cross(arms.a),
             spin_b = s.omega[row.b].cross(arms.b);
  Vec3 own = Vec3::Zero();
  if (contact.b != kNobody) own += v_b + (turns_b ? spin_b : Vec3(Vec3::Zero()));
  if (contact.a != kNobody) own -= v_a + (turns_a ? spin_a : Vec3(Vec3::Zero()));
  contact.carried = (v_b + spin_b - v_a - spin_a) - own;
  if (const Array<Vec3>& surface = world.contacts->surface; !surface.empty()) contact.carried += surface[row_index];
}

void load_groups(World& world, DirectGroups& d) {
  for (ConeBody& b : d.bodies) {
    hold_orientation(world, b.slot);
    load_mass(world, b);
    b.v << world.state.v[b.slot], world.state.omega[b.slot];
  }
  std::uint32_t of = 0xFFFFFFFFu;  // pair
  bool curved = false;
  for (std::size_t i = 0; i < d.contacts.size(); ++i) {
    load_contact(world, d.row[i], d.bodies.data(), d.contacts[i]);
    if (const std::uint32_t own = world.contacts->geometry[d.row[i]].pair; own != of) {
      const Pair& pair = world.pairs.place(own).pair;
      const Array<const Shape*>& shape = world.scene.colliders.shape;
      curved = is_curved(*shape[pair.a]) || is_curved(*shape[pair.b]), of = own;
    }
    d.contacts[i].is_curved = curved;
  }
}

}  // namespace carom

#include "dynamics/contact/lone_rollers.h"

#include <algorithm>

#include "collision/support.h"
#include "dynamics/body_state.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/force/force.h"
#include "dynamics/ledger/accounts.h"

namespace carom::dynamics {
namespace {

using collision::Form;
using collision::Shape;

const Shape& shape_of(const World& world, std::uint32_t collider) { return *world.scene.colliders.shape[collider]; }

/// Whether the surface below is flat as far as a step may lead, about a point of it.   @param n  unit, world, out of it
bool is_flat(const World& world, std::uint32_t collider, const Vec3& n, const Vec3& at, Real far) {
  const Shape& shape = shape_of(world, collider);
  if (shape.form == Form::half_space) return true;
  if (shape.form == Form::scenery || shape.core_radius > 0 || shape.host_thread) return false;
  constexpr Real kTilt = 1e-4;  // rad: a face has its far corner there, a round surface the point itself
  const std::uint32_t body = world.scene.colliders.body[collider];
  const Frame frame = Frame(world.state.q[body].matrix(), world.state.x[body]) * world.plan->local[collider];
  const Vec3 t = (std::fabs(n.x()) < 0.7 ? Vec3::unit(0) : Vec3::unit(1)).cross(n),
             along[2] = {t / t.norm(), n.cross(t / t.norm())};
  for (const Vec3& a : along)
    for (const Real sign : {1.0, -1.0}) {
      Vec3 corner;
      collision::SupportFault fault;
      if (!full_support(shape, frame.rotate_inverse(n + sign * kTilt * a), corner, fault)) return false;
      const Vec3 off = frame.apply(corner) - at;
      if (!(sign * off.dot(a) > far) || !(std::fabs(off.dot(n)) < kTilt * off.norm())) return false;
    }
  return true;
}

bool gains_nothing(const World& world, std::uint32_t collider, std::uint32_t other) {
  const Shape& shape = shape_of(world, collider);
  return shape.form == Form::sphere && world.plan->local[collider].p.is_zero() &&
         world.scene.type[other] != BodyType::kinematic;
}

/// A body's motion over a step, and what it takes to find it.
class Roll {
 public:
  Roll(const World& world, const LoneRoller& of)
      : of_(of),
        shape_(shape_of(world, of.collider)),
        local_(world.plan->local[of.collider]),
        mass_(world.scene.mass[of.body]),
        inertia_(world.scene.inertia[of.body]),
        inv_inertia_(world.scene.inv_inertia[of.body]),
        size_(shape_.bounding_radius + local_.p.norm()) {}

  struct At {
    Vec3 x, v, omega;
    Quat q;
  };

  /// m, from the centre of mass to the lowest point.
  bool arm(const Quat& q, Vec3& r) const {
    const Mat3 turn = q.matrix();
    collision::SupportFault fault;
    Vec3 point;
    if (!full_support(shape_, local_.r.transpose() * (turn.transpose() * (-1 * of_.n)), point, fault)) return false;
    r = turn * local_.apply(point);
    return true;
  }
  Real gap(const Vec3& x, const Vec3& r) const { return (x + r - of_.on_plane).dot(of_.n); }
  Real energy(const At& at) const {
    const Vec3 spin = at.q.conjugate() * at.omega;
    return (mass_ * at.v.squared_norm() + spin.dot(inertia_ * spin)) / 2;
  }
  Real mass() const { return mass_; }

  /// The point comes to rest on its surface, by an impulse there.   @param most  N s, that it may take
  bool settle(At& at, Real most) const {
    Vec3 r;
    if (!arm(at.q, r)) return false;
    const Mat3 inv = inverse_inertia(at.q);
    const Vec3 slip = at.v + at.omega.cross(r) - surface_at(at.x + r);
    const Vec3 p = -1 * (response(inv, r).inverse() * slip);
    if (!(p.norm() <= most)) return false;
    at.v += p / mass_, at.omega += inv * r.cross(p);
    return true;
  }

  /// s: how long it takes to turn, or for its point to travel, by a radian; at rest infinite.
  bool pace(const At& at, Real& seconds) const {
    Touch touch;
    if (!touches(at, touch)) return false;
    const auto& [r, travel] = touch;
    const Real far = r.norm(), rate = std::max(at.omega.norm(), far > 0 ? travel.norm() / far : 0);
    seconds = rate > 0 ? 1 / rate : kInfinity;
    return true;
  }

  /// By the classical fourth-order method. @return whether friction bears it and its point travels as foreseen
  bool advance(At& at, Real h) const {
    Rate a, b, c, d;
    Touch touch;
    Vec3 next;
    if (!touches(at, touch) || !rate(at, touch, a) || !rate(ahead(at, a, h / 2), b) || !rate(ahead(at, b, h / 2), c) ||
        !rate(ahead(at, c, h), d))
      return false;
    const auto mean = [&](auto Rate::*part) { return (1.0 / 6) * (a.*part + d.*part + 2.0 * (b.*part + c.*part)); };
    at = ahead(at, {mean(&Rate::x), mean(&Rate::v), mean(&Rate::omega), mean(&Rate::q)}, h);
    if (!(at.x.all_finite() && at.omega.all_finite()) || !arm(at.q, next)) return false;
    return (next - (touch.r + h * touch.travel)).norm() <= kRollJump * (h * touch.travel.norm() + kRollStep * size_);
  }

 private:
  struct Rate {
    Vec3 x, v, omega;
    Quat q;
  };
  static At ahead(const At& at, const Rate& by, Real h) {
    return {at.x + h * by.x, at.v + h * by.v, at.omega + h * by.omega, normalized(at.q + h * by.q)};
  }
  Mat3 inverse_inertia(const Quat& q) const {
    const Mat3 turn = q.matrix();
    return turn * inv_inertia_ * turn.transpose();
  }
  Mat3 response(const Mat3& inv, const Vec3& r) const {
    const Mat3 arm = cross_matrix(r);
    return Mat3::diagonal(Vec3::constant(1 / mass_)) - arm * inv * arm;
  }
  Vec3 surface_at(const Vec3& p) const { return of_.surface_v + of_.surface_spin.cross(p - of_.surface_x); }

  /// The lowest point from the centre of mass, m, and how it moves as the body turns, m/s.
  struct Touch {
    Vec3 r, travel;
  };
  bool touches(const At& at, Touch& to) const {
    const Real spin = at.omega.norm();
    to.travel = Vec3::zero();
    if (!arm(at.q, to.r)) return false;
    if (!(spin > 0)) return true;
    const Vec3 turn = (kRollProbe / spin) * at.omega;
    Vec3 before, after;
    if (!arm(exp_map(-1 * turn) * at.q, before) || !arm(exp_map(turn) * at.q, after)) return false;
    const Real far = (after - before).norm(), bend = ((after - to.r) - (to.r - before)).norm();
    if (!(far <= 2 * kRollTravel * kRollProbe * size_) || !(bend <= kRollBend * far + kRounding * size_)) return false;
    to.travel = (spin / (2 * kRollProbe)) * (after - before);
    return true;
  }

  /// N m for each newton of load, against rolling and spinning.
  Vec3 resistance(const Vec3& omega) const {
    const Vec3 w = omega - of_.surface_spin;
    const Real spin = w.dot(of_.n);
    const Vec3 roll = w - spin * of_.n;
    const Real rate = roll.norm();
    Vec3 moment = (spin > 0 ? -of_.spinning : spin < 0 ? of_.spinning : 0) * of_.n;
    if (rate > 0) moment -= (of_.rolling / rate) * roll;
    return moment;
  }

  bool rate(const At& at, Rate& to) const {
    Touch touch;
    return touches(at, touch) && rate(at, touch, to);
  }
  bool rate(const At& at, const Touch& touch, Rate& to) const {
    const auto& [r, travel] = touch;
    const Mat3 turn = at.q.matrix(), inv = turn * inv_inertia_ * turn.transpose();
    const Vec3 spun = turn * (inertia_ * (turn.transpose() * at.omega));
    const Vec3 free = inv * (of_.torque - at.omega.cross(spun));
    const Vec3 surface = of_.surface_spin.cross(at.v + travel - of_.surface_v);
    const Vec3 resisted = inv * resistance(at.omega);  // of a newton of load
    const Mat3 to_force = response(inv, r).inverse();
    const Vec3 f0 = to_force * (surface - at.omega.cross(travel) - of_.accel - free.cross(r)),
               f1 = to_force * r.cross(resisted);
    const Real load = f0.dot(of_.n) / (1 - f1.dot(of_.n));
    const Vec3 f = f0 + load * f1;
    if (!(load > 0) || !((f - load * of_.n).norm() <= of_.friction * load)) return false;
    to.x = at.v, to.v = of_.accel + f / mass_;
    to.omega = free + load * resisted + inv * r.cross(f);
    to.q = 0.5 * (Quat(0, at.omega.x(), at.omega.y(), at.omega.z()) * at.q);
    return true;
  }

  static constexpr Real kRounding = 1e-12;

  const LoneRoller& of_;
  const Shape& shape_;
  const Frame& local_;
  const Real mass_;
  const Mat3& inertia_;
  const Mat3& inv_inertia_;
  const Real size_;
};

/// A roller's step. @return false: it is the solver's
bool roll(const World& world, const LoneRoller& of, Real dt, Roll::At& at) {
  const Roll roll(world, of);
  const State& s = world.state;
  at = {of.x, of.v, of.omega, of.q};
  const Real weight = roll.mass() * std::fabs(of.accel.dot(of.n)) * dt;
  if (!roll.settle(at, kRollSettle * std::min(Real(1), of.friction) * weight)) return false;
  Vec3 r_begun, r_ended, r_solved;
  Real pace = 0;
  if (!roll.arm(at.q, r_begun) || !roll.pace(at, pace)) return false;
  const Real wanted = std::ceil(dt / (kRollStep * pace));
  if (!(wanted <= kRollSteps)) return false;
  const int steps = std::max(1, static_cast<int>(wanted));
  const Roll::At begun = at;
  const auto turns_back = [&] {  // what resists turns about is at an end
    const Vec3 then = begun.omega - of.surface_spin, now = at.omega - of.surface_spin;
    const Real spin_then = then.dot(of.n), spin_now = now.dot(of.n);
    return (of.rolling > 0 && !((then - spin_then * of.n).dot(now - spin_now * of.n) > 0)) ||
           (of.spinning > 0 && !(spin_then * spin_now > 0));
  };
  for (int k = 0; k < steps; ++k)
    if (!roll.advance(at, dt / steps) || !roll.settle(at, kRollSettle * weight)) return false;
  if (turns_back() || !roll.arm(at.q, r_ended) || !roll.arm(s.q[of.body], r_solved)) return false;
  const Real gap = roll.gap(at.x, r_ended);
  if (of.surface_spin.is_zero() && of.surface_v.is_zero()) {
    const Real had = roll.energy(begun), work = roll.mass() * of.accel.dot(at.x - begun.x);
    if (roll.energy(at) - had - work > kRollGain * (had + std::fabs(work))) return false;
  }
  const Real before = roll.gap(of.x, r_begun), solved = roll.gap(s.x[of.body], r_solved);
  at.x += ((std::fabs(before) < std::fabs(solved) ? before : solved) - gap) * of.n;
  return true;
}

/// Whether a body in touch with one that impulses do not move is such that its motion may be done once more.
bool may_roll_alone(const World& world, const ContactPair& m) {
  const Scene& scene = world.scene;
  const State& s = world.state;
  const std::uint32_t body = m.moves_a ? m.a : m.b, other = m.moves_a ? m.b : m.a;
  const std::uint32_t collider = scene.first_collider[body];
  const Row& row = world.contacts->rows[m.row];
  if (collider == kInvalid || scene.colliders.next[collider] != kInvalid || scene.type[other] == BodyType::dynamic)
    return false;
  if (!(row.friction > 0) || scene.locks_of(body) || !rotates(scene, body) || s.omega[body].is_zero()) return false;
  if (shape_of(world, collider).host_thread || gains_nothing(world, collider, other)) return false;
  const Vec3& spin = s.omega[other];  // about the normal, which then stays what it is
  return spin.is_zero() || spin.cross(row.n).squared_norm() <= 1e-24 * spin.squared_norm();
}

std::uint32_t deepest_row(const Contacts& c, const ContactPair& m) {
  std::uint32_t k = m.row;
  for (std::uint32_t i = k + 1; i < m.row + m.count; ++i)
    if (c.geometry[i].separation < c.geometry[k].separation) k = i;
  return k;
}

/// Whether it stands on that point, and not on a line or a face.
bool touches_at_one_point(const Contacts& c, const ContactPair& m) {
  const std::uint32_t k = deepest_row(c, m);
  for (std::uint32_t i = m.row; i < m.row + m.count; ++i) {
    const Vec3 apart = m.moves_a ? c.geometry[i].l_a - c.geometry[k].l_a : c.geometry[i].l_b - c.geometry[k].l_b;
    if (apart.is_zero()) continue;  // the same point: @see rolling.h
    if (!(c.geometry[i].separation - c.geometry[k].separation > kRollApart * apart.norm())) return false;
  }
  return true;
}

/// Of the point that is deepest.
LoneRoller as_begun(const World& world, const ContactPair& m) {
  const Contacts& c = *world.contacts;
  const State& s = world.state;
  const std::uint32_t k = deepest_row(c, m);
  const Row& row = c.rows[k];
  const RowGeometry& g = c.geometry[k];
  const collision::Pair pair = world.pairs.place(g.pair).pair;
  const std::uint32_t body = m.moves_a ? m.a : m.b, other = m.moves_a ? m.b : m.a;
  LoneRoller of;
  of.body = body, of.row = m.row, of.rows = m.count, of.deepest = k;
  of.collider = m.moves_a ? pair.a : pair.b, of.surface = m.moves_a ? pair.b : pair.a;
  of.n = m.moves_a ? Vec3(-1 * row.n) : row.n;
  of.on_plane =
      s.x[other] + (m.moves_a ? s.q[other] * g.l_b - g.radius_b * row.n : s.q[other] * g.l_a + g.radius_a * row.n);
  of.friction = row.friction;
  of.x = s.x[body], of.v = s.v[body], of.omega = s.omega[body], of.q = s.q[body];
  of.accel = pull_on(world, body), of.torque = Vec3::zero();
  if (!world.scene.modes.forbids(+EffectId::user_force, body)) of.accel += world.scene.inv_mass[body] * s.force[body];
  if (!world.scene.modes.forbids(+EffectId::user_torque, body)) of.torque = s.torque[body];
  of.surface_x = s.x[other], of.surface_v = s.v[other], of.surface_spin = s.omega[other];
  return of;
}

/// By how much each body is bound: by one for a pair, by two where something else binds it as well.
void count_touches(const World& world, LoneRollers& l) {
  const Contacts& c = *world.contacts;
  l.touches.assign(world.scene.bodies.slots(), 0);
  const auto touch = [&](std::uint32_t body, int times) {
    if (body != kInvalid) l.touches[body] = static_cast<std::uint8_t>(std::min(2, l.touches[body] + times));
  };
  for (const ContactPair& m : c.contact_pairs) touch(m.a, 1), touch(m.b, 1);
  for (const Link& link : c.links) touch(link.a, 2), touch(link.b, 2);
  for (const Driven& d : c.driven) touch(c.rows[d.row].a, 2), touch(c.rows[d.row].b, 2);
}

/// Of the whole step, on the body, at its one point.
void tell_impulse(const World& world, const LoneRoller& of, const Vec3& p) {
  Contacts& c = *world.contacts;
  for (std::uint32_t k = of.row; k < of.row + of.rows; ++k) c.geometry[k].impulse = Vec3::zero();
  c.geometry[of.deepest].impulse = c.rows[of.deepest].b == of.body ? p : Vec3(-1 * p);
}

}  // namespace

void find_lone_rollers(const World& world, const StepTime& time) {
  if (!world.lone_rollers) return;
  LoneRollers& l = *world.lone_rollers;
  l.bodies.clear();
  for (const ContactPair& m : world.contacts->contact_pairs)
    if (m.moves_a != m.moves_b && m.one_normal && may_roll_alone(world, m) && touches_at_one_point(*world.contacts, m))
      l.bodies.push_back(as_begun(world, m));
  if (l.bodies.empty()) return;
  auto of = l.bodies.begin();
  for (const Resistance& r : world.contacts->resisting) {  // both ascend by row
    while (of != l.bodies.end() && of->row < r.row) ++of;
    if (of != l.bodies.end() && of->row == r.row) of->rolling = r.rolling, of->spinning = r.spinning;
  }
  count_touches(world, l);
  std::erase_if(l.bodies, [&](const LoneRoller& roller) {
    const Real far =
        time.dt * (roller.v.norm() + roller.omega.norm() * shape_of(world, roller.collider).bounding_radius);
    return l.touches[roller.body] != 1 || !only_constant_forces_act(world, roller.body) ||
           !is_flat(world, roller.surface, roller.n, roller.on_plane, far);
  });
}

void roll_alone(const World& world, Poses& poses, Velocities& motion, const StepTime& time) {
  if (!world.lone_rollers) return;
  for (const LoneRoller& of : world.lone_rollers->bodies) {
    const SweptBody* const swept = world.continuous->find(of.body);
    if (world.state.held_out[of.body] || (swept && swept->is_hit)) continue;
    Roll::At at;
    if (!roll(world, of, time.dt, at)) continue;
    poses.x[of.body] = at.x, poses.q[of.body] = at.q;
    motion.v[of.body] = at.v, motion.omega[of.body] = at.omega;
    motion.momentum[of.body] = inertia_at(world.scene, of.body, at.q) * at.omega;
    tell_impulse(world, of, world.scene.mass[of.body] * (at.v - of.v - time.dt * of.accel));
  }
}

}  // namespace carom::dynamics

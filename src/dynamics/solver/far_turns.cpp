// Rows of bodies that turn far for their shape, made anew within a step.
#include "dynamics/solver/far_turns.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

/// Where a point of a pair is now, and how far its surfaces are apart.
struct Place {
  Vec3 arm_a;       // m, world, from A's centre of mass
  Real separation;  // m
};

Place place_now(const World& world, const Row& row, const RowGeometry& g, const Vec3& apart) {
  const State& s = world.state;
  const Vec3 on_a = s.q[row.a] * g.l_a + g.radius_a * row.n;
  const Vec3 on_b = apart + (s.q[row.b] * g.l_b - g.radius_b * row.n);
  return {on_a + Arms::to_b(row, g) * (on_b - on_a), (on_b - on_a).dot(row.n)};
}

/// m, what a body's own motion since its lanes were laid adds to a point's separation, as kernels reckon it.
Real moved_by(const WideContacts& wide, const State& s, std::uint32_t body, const Vec3& arm, Real radius,
              const Vec3& n) {
  if (body == 0) return 0;
  const std::uint32_t slot = wide.slot[body];
  const Quat q = s.q[slot] * wide.start_q[body].conjugate();
  const Vec3 u = q.vec();
  const Vec3 m = 2 * (q.w() * n.cross(u) + u.dot(n) * u - u.dot(u) * n);
  return (s.x[slot] - wide.start_x[body]).dot(n) + m.dot(arm) + radius * m.dot(n);
}

/// One pair's rows anew.
class Renewal {
 public:
  /// @param h  s; 0: the sweeps ahead give impulses, else they take them back
  Renewal(const World& world, WideContacts& wide, Real h) : world_(world), wide_(wide), h_(h) {}

  template <class Number>
  void operator()(PairLanesOf<Number>& pair, PointLanesOf<Number>* points, int lane,
                  const WideContacts::Manifold& m) const {
    const Contacts& c = *world_.contacts;
    const State& s = world_.state;
    const Row& row = c.rows[m.row];
    const auto i = static_cast<std::size_t>(lane);
    const std::uint32_t a = pair.a[i], b = pair.b[i];
    const Vec3 apart = s.x[row.b] - s.x[row.a];
    std::array<Place, kPairPoints> at;
    const bool slides = pair.slide[i] > 0;
    for (std::uint32_t k = 0; k < m.points; ++k)
      at[k] = place_now(world_, c.rows[m.row + k], c.geometry[m.row + k], apart);
    const Vec3 middle = middle_of(at, points, lane, m.points, slides);
    const bool far_a = wide_.far_turn[a].marked, far_b = wide_.far_turn[b].marked;
    if (far_a) set(pair.r_a, lane, middle);
    if (far_b) set(pair.r_b, lane, middle - apart);
    if (far_a) set_inertia(row.a, pair.inv_inertia_a, lane);
    if (far_b) set_inertia(row.b, pair.inv_inertia_b, lane);
    const Vec3 r_a = get(pair.r_a, static_cast<std::uint32_t>(lane)),
               r_b = get(pair.r_b, static_cast<std::uint32_t>(lane));
    for (std::uint32_t k = 0; k < m.points; ++k) {
      PointLanesOf<Number>& p = points[k];
      const Row& of = c.rows[m.row + k];
      const Vec3 d = at[k].arm_a - middle;
      set(p.d, lane, d), set(p.reach, lane, (slides ? row.twist_share : 1) * d.norm());
      Real gap = at[k].separation;
      if (h_ > 0) {
        gap = held_gap(gap, a, b, r_a + d, r_b + d, of.n);
      } else {
        set(p.p_n, lane, 0);
        set(p.separation, lane, gap);
      }
      const RowGeometry& g = c.geometry[m.row + k];
      if (!far_a) gap += moved_by(wide_, s, a, r_a + d, g.radius_a, of.n);
      if (!far_b) gap -= moved_by(wide_, s, b, r_b + d, -g.radius_b, of.n);
      set(p.gap, lane, gap);
    }
    // What slides and has been rubbed in this substep has that much less to bear in the sweeps ahead.
    if (slides) set(pair.friction, lane, (h_ > 0 ? left_to_friction(pair, points, lane, m.points) : 1) * row.friction);
    if (h_ > 0)
      accumulate(pair.p_t, pair.sum_t, lane), accumulate(pair.p_s, pair.sum_s, lane),
          accumulate(pair.p_w, pair.sum_w, lane);
    if (h_ > 0 && keeps_ledger(world_)) clear_friction(world_, m.pair, m.lane);
    set(pair.p_t, lane, 0), set(pair.p_s, lane, 0), set(pair.p_w, lane, 0);
  }

 private:
  template <class Lanes>
  static void accumulate(const Lanes& p, Lanes& sum, int lane) {
    sum[lane] += p[lane];
  }
  /// Where friction acts, m, from A's centre of mass: of what slides at the middle of its loads, or where nothing bears
  /// any of the points that touch, @see SlidingMiddle; else at the middle of all.
  template <class Number>
  static Vec3 middle_of(const std::array<Place, kPairPoints>& at, const PointLanesOf<Number>* points, int lane,
                        std::uint32_t count, bool slides) {
    Real weight[kPairPoints], sum = 0, least = kInfinity, width2 = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      sum += weight[k] = slides ? std::max(Real(0), Real(points[k].p_n[lane])) : 1;
      least = std::min(least, at[k].separation);
      width2 = std::max(width2, (at[k].arm_a - at[0].arm_a).squared_norm());
    }
    const Real near = kTouching * std::sqrt(width2);
    for (std::uint32_t k = 0; k < count && !(sum > 0); ++k) weight[k] = at[k].separation - least <= near ? 1 : 0;
    Vec3 middle = Vec3::zero();
    Real whole = 0;
    for (std::uint32_t k = 0; k < count; ++k) middle += weight[k] * at[k].arm_a, whole += weight[k];
    return middle / whole;
  }
  /// Which share of friction's bound a pair does not bear, @see lane_friction.h.
  template <class Number>
  static Real left_to_friction(const PairLanesOf<Number>& pair, const PointLanesOf<Number>* points, int lane,
                               std::uint32_t count) {
    Real load = 0, moment = 0;
    for (std::uint32_t k = 0; k < count; ++k)
      load += points[k].p_n[lane], moment += points[k].reach[lane] * points[k].p_n[lane];
    const Real force2 = pair.p_t[lane] * pair.p_t[lane] + pair.p_s[lane] * pair.p_s[lane];
    const Real x2 = force2 * ratio2(1, pair.friction[lane] * load),
               y2 = ratio2(pair.p_w[lane], pair.friction[lane] * moment);
    const Real sum = x2 + y2, borne2 = (sum + std::sqrt(sum * sum + 4 * kPatchBend * x2 * y2)) / 2;
    return std::max(Real(0), 1 - std::sqrt(borne2));
  }
  static Real ratio2(Real part, Real whole) { return whole > 0 ? part / whole * (part / whole) : 0; }
  template <class Number>
  void set_inertia(std::uint32_t body, LaneSymmetricOf<Number>& to, int lane) const {
    LanesOf<Number> inv_mass;
    set_mass<Number>(world_, true, body, inv_mass, to, lane);
  }
  /// A gap at which a sweep takes no impulse back from a point that closes, and from one that parts only until it
  /// rests.
  Real held_gap(Real gap, std::uint32_t a, std::uint32_t b, const Vec3& r_a, const Vec3& r_b, const Vec3& n) const {
    if (!(gap > 0)) return gap;
    const auto at = [&](std::uint32_t body, const Vec3& r) {
      const BodyVelocity& u = wide_.velocity[body];
      return Vec3(Vec3(u.v[0], u.v[1], u.v[2]) + Vec3(u.omega[0], u.omega[1], u.omega[2]).cross(r));
    };
    const Real closes = h_ * (at(a, r_a) - at(b, r_b)).dot(n);
    return std::clamp(closes, Real(0), gap);
  }

  const World& world_;
  WideContacts& wide_;
  Real h_;
};

/// f(i) for all solver bodies that impulses move, by all threads.
template <class F>
void each_moved(const World& world, const WideContacts& wide, const F& f) {
  if (wide.slot.size() <= wide.first_moved) return;
  in_parallel(world.jobs, wide.slot.size() - wide.first_moved, kBodiesAPart,
              [&](std::uint32_t i) { f(wide.first_moved + i); });
}

/// By what share of its energy a body's inertia is off that has turned since: it errs by t (I_i - I_j) between two
/// principal axes if it has turned by t about the third.   @param turn  rad, body axes
Real misfit(const Plan& plan, std::uint32_t slot, const Vec3& turn) {
  const Principal& top = plan.principal[slot];
  const Vec3 t = top.aligned ? top.sorted(turn) : Vec3(top.frame.conjugate() * turn), &m = top.moment;
  const auto of = [](Real angle, Real i, Real j) { return angle * angle * ((i - j) * (i - j) / (i * j)); };
  return of(t.x(), m.y(), m.z()) + of(t.y(), m.x(), m.z()) + of(t.z(), m.x(), m.y());
}

/// misfit() of one radian about the worst axis, at most.
Real worst_misfit(const Plan& plan, std::uint32_t slot) {
  const Vec3& m = plan.principal[slot].moment;
  const auto of = [](Real i, Real j) { return (i - j) * (i - j) / (i * j); };
  return std::max({of(m.y(), m.z()), of(m.x(), m.z()), of(m.x(), m.y())});
}

/// rad^2: 4 sin^2(t/2), t the angle between two orientations, and what rounding may hide of it.
Real turned2(const Quat& from, const Quat& to) {
  const Real cosine = from.w() * to.w() + from.x() * to.x() + from.y() * to.y() + from.z() * to.z();
  return 4 * (1 - cosine * cosine) + 64 * kUnitRoundoff;
}

/// Who has turned too far since its rows were made; always who is marked `again`. Their masses are made anew.
bool mark(const World& world, WideContacts& wide) {
  const State& s = world.state;
  std::atomic<bool> any{false};
  each_moved(world, wide, [&](std::uint32_t i) {
    FarTurn& f = wide.far_turn[i];
    f.marked = false;
    if (!f.may) return;
    const std::uint32_t slot = wide.slot[i];
    const Quat &q = s.q[slot], &start = wide.start_q[i];
    if (!f.again && !(f.unlike * turned2(start, q) > kFarTurn)) return;
    const Vec3 turn = 2 * (start.conjugate() * q).vec();
    if (!f.again && !(misfit(*world.plan, slot, turn) > kFarTurn)) return;
    f.marked = true, any.store(true, std::memory_order_relaxed);
    const Mat3 r = s.q[slot].matrix();
    world.contacts->inv_inertia_w[slot] = r * world.scene.inv_inertia[slot] * r.transpose();
  });
  return any.load(std::memory_order_relaxed);
}

/// Rows of marked bodies anew.   @param h  as Renewal has it
void renew(const World& world, WideContacts& wide, Real h) {
  if (!mark(world, wide)) return;
  const Renewal renewal(world, wide, h);
  with_lanes(wide, [&](auto& lanes, const auto& sweeps) {
    const auto run = everything(wide, lanes, wide.velocity.data());
    in_parts(world.jobs, wide.first_point.size(), kPairsAPart, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) {
        auto& pair = lanes.pairs[i];
        bool any = false;
        for (int lane = 0; lane < kLanes; ++lane) {
          const std::uint32_t of = wide.occupant[std::size_t(i) * kLanes + static_cast<std::size_t>(lane)];
          const auto k = static_cast<std::size_t>(lane);
          if (of == kEmptyLane || !(wide.far_turn[pair.a[k]].marked || wide.far_turn[pair.b[k]].marked)) continue;
          renewal(pair, lanes.points.data() + pair.first, lane, wide.manifolds[of]);
          any = true;
        }
        if (any) over_part(run, i, i + 1, [&](const auto& part) { sweeps.prepare(part); });
      }
    });
  });
  for (std::uint32_t i = wide.first_moved; i < wide.slot.size(); ++i) {
    FarTurn& f = wide.far_turn[i];
    f.again = f.marked && h > 0;
    if (!f.marked) continue;
    wide.start_x[i] = world.state.x[wide.slot[i]], wide.start_q[i] = world.state.q[wide.slot[i]];
  }
}

}  // namespace

bool may_turn_far(const World& world, std::uint32_t body) {
  return world.plan->rotation_method && world.plan->effects[+EffectId::gyroscopic].candidates.has(body);
}

// Of any axis: what spins about one that an impulse then tilts must carry its spin along, or has it beside its axis.
// What begins a step without spin is integrated by no rotation method in it: it turns about its axis, which keeps its
// energy as well.
bool turns_far_for_its_shape(const World& world, std::uint32_t body, Real time) {
  const Vec3& moment = world.plan->principal[body].moment;
  const Real unlike = moment.max_entry() / moment.min_entry() - 1;
  return unlike * time * time * world.state.omega[body].squared_norm() > kFarTurn;
}

bool turns_too_far(const World& world, std::uint32_t body, const Vec3& turn) {
  return misfit(*world.plan, body, world.state.q[body].conjugate() * turn) > kFarTurn;
}

Vec3 led_back(const World& world, std::uint32_t body, const Vec3& end) {
  const Vec3 momentum = inertia_at(world.scene, body, world.plan->predicted.q[body]) * end;
  const Mat3 r = world.state.q[body].matrix();
  return r * (world.scene.inv_inertia[body] * (r.transpose() * momentum));
}

void lead_on(const World& world, Velocities& to, std::uint32_t body, Real h, Participants& scratch) {
  scratch.runs[0] = {body, body + 1};
  world.plan->rotation_method->advance(world, to, scratch, h);
}

void find_far_turners(const World& world, WideContacts& wide) {
  const Plan& plan = *world.plan;
  wide.far_turn.assign(wide.slot.size(), {});
  wide.far_turners = false;
  if (!plan.rotation_method || (wide.manifolds.empty() && world.contacts->links.empty())) return;
  plan.effects[+EffectId::gyroscopic].candidates.each([&](std::uint32_t slot) {  // @see may_turn_far()
    const std::uint32_t i = wide.body[slot];
    if (i >= wide.first_moved && wide.slot[i] == slot) wide.far_turn[i].may = wide.far_turners = true;
  });
  each_moved(world, wide, [&](std::uint32_t i) {
    FarTurn& f = wide.far_turn[i];
    if (f.may) f.unlike = worst_misfit(plan, wide.slot[i]);
  });
  if (wide.far_turners && wide.one_turner.runs.empty()) wide.one_turner.add(0);
}

void begin_far_turns(const World& world, Velocities& to, WideContacts& wide, Real h) {
  if (!wide.far_turners) return;
  const State& s = world.state;
  renew(world, wide, 0);
  each_moved(world, wide, [&](std::uint32_t i) {
    FarTurn& f = wide.far_turn[i];
    const std::uint32_t slot = wide.slot[i];
    f.led_on = false;
    f.led_back =
        f.may && turns_by_method(*world.plan, slot) && turns_far_for_its_shape(world, slot, h) && !s.held_out[slot];
    f.end = s.omega[slot];
    if (f.led_back) f.begun = to.omega[slot] = led_back(world, slot, f.end);
  });
}

void end_far_turns(const World& world, Velocities& to, WideContacts& wide, Real h) {
  if (!wide.far_turners) return;
  const State& s = world.state;
  const auto end = [&](std::uint32_t i) {
    BodyVelocity& b = wide.velocity[i];
    for (int k = 0; k < 3; ++k) b.omega[k] = s.omega[wide.slot[i]][k];
  };
  std::atomic<bool> any{false};
  each_moved(world, wide, [&](std::uint32_t i) {
    FarTurn& f = wide.far_turn[i];
    const std::uint32_t slot = wide.slot[i];
    f.led_on = f.led_back || (f.may && turns_by_method(*world.plan, slot) && world.plan->touched[slot] &&
                              turns_far_for_its_shape(world, slot, h));
    f.waits = f.led_on && !(f.led_back && s.omega[slot] == f.begun);
    if (f.waits) any.store(true, std::memory_order_relaxed);
    if (f.led_on && !f.waits) to.omega[slot] = f.end, end(i);
  });
  if (!any.load(std::memory_order_relaxed)) return;
  for (std::uint32_t i = wide.first_moved; i < wide.slot.size(); ++i)
    if (wide.far_turn[i].waits) lead_on(world, to, wide.slot[i], h, wide.one_turner), end(i);
}

void heed_far_turns(const World& world, WideContacts& wide, Real h) {
  if (wide.far_turners) renew(world, wide, h);
}

void measure_far_turns(const World& world, WideContacts& wide) {
  if (!wide.far_turners) return;
  with_lanes(wide, [&](auto& lanes, const auto&) {
    for (const WideContacts::Manifold& m : wide.manifolds) {
      const auto& pair = lanes.pairs[m.pair];
      if (!wide.far_turn[pair.a[m.lane]].again && !wide.far_turn[pair.b[m.lane]].again) continue;
      for (std::uint32_t k = 0; k < m.points; ++k)
        set(lanes.points[pair.first + k].separation, static_cast<int>(m.lane),
            world.contacts->geometry[m.row + k].separation);
    }
  });
}

}  // namespace carom::dynamics

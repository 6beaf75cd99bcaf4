// Impacts of a substep, one after the other.
#include "dynamics/contact/impact.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "dynamics/contact/impact_points.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/quarantine.h"
#include "dynamics/solver/far_turns.h"

namespace carom::dynamics {
namespace {

class Impacts {
 public:
  Impacts(const World& world, Poses& poses, Velocities& motion, StepReport& report, const StepTime& time)
      : world_(world),
        poses_(poses),
        motion_(motion),
        report_(report),
        c_(*world.contacts),
        search_(c_.keys, c_.ranked, c_.place),
        time_(time),
        lag_(world.plan->integrator->lag * time.h),
        threshold_(world.scene.dials[Dial::restitution_speed]),
        near_(world.scene.dials[Dial::position_tolerance]) {}

  void solve() {
    lead_spins_back();
    for (Impact& at : c_.impacts) {
      const Row& row = c_.rows[at.row];
      at.accel = (velocity(at) - at.before) / time_.h;
      c_.last_impact[row.a] = c_.last_impact[row.b] = -time_.dt;
    }
    Real most = 0;
    for (const Impact& at : c_.impacts) most = std::max(most, c_.keys[at.row] = key(at));
    if (most > 0) {
      solve_all();
      move_back();
    }
    lead_spins_on();
    if (lag_ > time_.h / 2) give_leeway();
  }

 private:
  struct Point : ImpactPoint {
    Impact* at;
    bool is_turned;  // A of the others is B of its row
  };

  /// Spins of the substep's beginning, of bodies whose inertia turns too far in it for the spin of its end.
  void lead_spins_back() {
    c_.spins.clear();
    if (!world_.plan->rotation_method) return;
    const State& s = world_.state;
    for (const std::uint32_t body : c_.bodies) {
      if (!world_.plan->effects[+EffectId::gyroscopic].candidates.has(body) || s.held_out[body]) continue;
      const bool far = turns_by_method(*world_.plan, body) && turns_far_for_its_shape(world_, body, time_.h);
      const Vec3 end = s.omega[body], begun = far ? led_back(world_, body, end) : end;
      c_.spins.push_back({body, begun, end, far});
      if (far) motion_.omega[body] = begun;
    }
  }
  /// And on again, over the substep.
  void lead_spins_on() {
    const State& s = world_.state;
    for (const ImpactSpin& spin : c_.spins) {
      const Vec3 gained = s.omega[spin.slot] - spin.begun;
      if (gained == Vec3::zero()) {
        if (spin.is_led_back) motion_.omega[spin.slot] = spin.end;
        continue;
      }
      if (!spin.is_led_back && !turns_far_for_its_shape(world_, spin.slot, time_.h)) continue;
      if (!turns_by_method(*world_.plan, spin.slot)) {
        if (world_.plan->integrator->proposes)
          world_.plan->predicted.q[spin.slot] = normalized(exp_map(time_.h * s.omega[spin.slot]) * s.q[spin.slot]);
        continue;
      }
      if (!spin.is_led_back) motion_.omega[spin.slot] = led_back(world_, spin.slot, spin.end) + gained;
      lead_on(world_, motion_, spin.slot, time_.h, c_.one_spin);
    }
  }

  void solve_all() {
    refresh_inertias(world_);
    list_by_body();
    search_.start(c_.bouncing, 0);
    for (std::uint32_t i; (i = search_.top()) != kNoRow;) strike(c_.impacts[c_.geometry[i].impact]);
  }

  void list_by_body() {
    for (const std::uint32_t i : c_.bodies) c_.half_of[i].end = c_.half_of[i].begin;
    for (const Impact& at : c_.impacts) {
      const Row& row = c_.rows[at.row];
      if (row.moves_a) c_.half[c_.half_of[row.a].end++].row = at.row;
      if (row.moves_b) c_.half[c_.half_of[row.b].end++].row = at.row;
    }
  }

  /// m/s, world: as stored.
  Vec3 velocity(const Impact& at) const { return relative_velocity(world_.state, c_.rows[at.row], at.r.a, at.r.b); }
  /// m, m/s, m/s^2: a row's parabola as the substep begins, of bodies that move as they do after the impacts so far.
  Real gap(const Impact& at) const {
    const Row& row = c_.rows[at.row];
    const Vec3 moved = (c_.displaced[row.b].shift + c_.displaced[row.b].turn.cross(at.r.b)) -
                       (c_.displaced[row.a].shift + c_.displaced[row.a].turn.cross(at.r.a));
    return at.gap + moved.dot(row.n);
  }
  Real closing(const Impact& at) const { return (lag_ * at.accel - velocity(at)).dot(c_.rows[at.row].n); }
  Real accel(const Impact& at) const { return -at.accel.dot(c_.rows[at.row].n); }

  Touch touch(const Impact& at) const {
    const Row& row = c_.rows[at.row];
    return find_touch(gap(at), closing(at), accel(at), std::max(c_.last_impact[row.a], c_.last_impact[row.b]));
  }
  /// s, of the substep after the impact; 0: there is none.
  Real key(const Impact& at) const {
    const Touch t = touch(at);
    return t.speed > threshold_ && t.time < time_.h && at.count < kMostImpacts ? time_.h - t.time : 0;
  }

  /// The points of a row's pair that touch as it does are hit together: flat on the ground, a box does not roll from
  /// corner to corner. Likewise those of the body with all that stands still and looks the same way: tiles.
  void strike(Impact& first) {
    const Touch hit = touch(first);
    const Row& row = c_.rows[first.row];
    std::array<Point, kMostHitPoints> points;
    std::size_t count = 0;
    const auto add = [&](Impact& at, bool is_turned) {
      const Real a = accel(at), c0 = closing(at), speed = &at == &first ? hit.speed : c0 + a * hit.time;
      if (&at != &first && gap(at) - hit.time * (c0 + a * hit.time / 2) > near_) return;
      if (count < points.size()) points[count++] = point(at, speed, is_turned);
    };
    each_of_pair(first, [&](Impact& at) { add(at, false); });
    const bool only_a = row.moves_a && stands_still(row.b, row.moves_b);
    const bool only_b = row.moves_b && stands_still(row.a, row.moves_a);
    if (only_a || only_b) {
      const std::uint32_t body = only_a ? row.a : row.b;
      for (std::uint32_t k = c_.half_of[body].begin; k < c_.half_of[body].end; ++k) {
        const Row& other = c_.rows[c_.half[k].row];
        const RowGeometry& g = c_.geometry[c_.half[k].row];
        const bool is_turned = (other.a == body) != only_a;
        if (g.pair == c_.geometry[first.row].pair || !looks_alike(row, other, is_turned) ||
            !(other.a == body ? stands_still(other.b, other.moves_b) : stands_still(other.a, other.moves_a)))
          continue;
        add(c_.impacts[g.impact], is_turned);
      }
    }
    exchange({points.data(), count}, hit);
    for (const std::uint32_t body : {row.a, row.b}) {
      if (body == row.a ? !row.moves_a : !row.moves_b) continue;
      for (std::uint32_t k = c_.half_of[body].begin; k < c_.half_of[body].end; ++k) {
        const std::uint32_t i = c_.half[k].row;
        search_.set(i, key(c_.impacts[c_.geometry[i].impact]));
      }
    }
    ++report_.velocity_impulses;
  }

  template <class F>
  void each_of_pair(Impact& first, const F& f) {
    const std::uint32_t pair = c_.geometry[first.row].pair;
    Impact* at = &first;
    while (at > c_.impacts.data() && c_.geometry[at[-1].row].pair == pair) --at;
    for (; at < c_.impacts.data() + c_.impacts.size() && c_.geometry[at->row].pair == pair; ++at) f(*at);
  }

  bool stands_still(std::uint32_t body, bool moves) const {
    return !moves && world_.state.v[body] == Vec3::zero() && world_.state.omega[body] == Vec3::zero();
  }
  static bool looks_alike(const Row& row, const Row& other, bool is_turned) {
    return row.n.dot(is_turned ? Vec3(-other.n) : other.n) >= kSweepSamePatch;
  }

  /// @param speed  m/s, @see wanted_speed()
  Point point(Impact& at, Real speed, bool is_turned) const {
    const Row& row = c_.rows[at.row];
    Point p{{row, {}, wanted_speed(speed, row.restitution, threshold_)}, &at, is_turned};
    p.mass.r_a = at.r.a, p.mass.r_b = at.r.b;
    p.mass.k = velocity_per_impulse(world_, row, p.mass);
    if (is_turned) {
      std::swap(p.mass.r_a, p.mass.r_b);
      p.row.n = -p.row.n;
    }
    const Scene& scene = world_.scene;
    const bool locked = scene.locks_of(row.a) | scene.locks_of(row.b);
    p.be_ready(locked ? row.moves_a * scene.inv_mass[row.a] + row.moves_b * scene.inv_mass[row.b] : 0);
    return p;
  }

  ImpactBody body_of(std::uint32_t i, bool moves) const {
    const Scene& scene = world_.scene;
    const bool turns = moves && rotates(scene, i);
    const Vec3 inv_mass = moves ? scene.inv_mass[i] * free_axes(scene.locks_of(i)) : Vec3::zero();
    const Mat3 inv_inertia = turns ? c_.inv_inertia_w[i] : Mat3::zero();
    return {world_.state.v[i], world_.state.omega[i], inv_mass, inv_inertia, moves, turns};
  }

  /// What the points give each other; the bodies' share of the motion up to this moment is taken back.
  void exchange(std::span<Point> points, const Touch& hit) {
    const Row& row = points[0].row;
    ImpactPair pair{body_of(row.a, row.moves_a), body_of(row.b, row.moves_b)};
    // As stored, but of the moment; in the order of additions of relative_velocity().
    resolve_impact(pair, points, hit.speed, [&](const Point& p) {
      Vec3 u = pair.b.v + pair.b.omega.cross(p.mass.r_b) - pair.a.v - pair.a.omega.cross(p.mass.r_a);
      const Real sign = p.is_turned ? -1 : 1;
      u += sign * (hit.time - lag_) * p.at->accel;
      if (!c_.surface.empty()) u += sign * c_.surface[p.at->row];
      return u;
    });
    for (const Point& p : points) {
      ++p.at->count;
      c_.geometry[p.at->row].impulse += p.is_turned ? Vec3(-p.row.p) : p.row.p;
      c_.rows[p.at->row].p.set_zero();  // an impact does not come again
    }
    if (row.moves_a) turn_off(row.a, hit.time, pair.a);
    if (row.moves_b) turn_off(row.b, hit.time, pair.b);
  }

  /// A body's velocities change at a moment of the substep.
  void turn_off(std::uint32_t body, Real moment, const ImpactBody& hit) {
    Velocities& s = motion_;
    const Vec3 dv = hit.v - s.v[body], domega = hit.omega - s.omega[body];
    s.v[body] = hit.v, s.omega[body] = hit.omega;
    c_.last_impact[body] = moment;
    c_.displaced[body].shift -= moment * dv;
    c_.displaced[body].turn -= moment * domega;
    Plan& plan = *world_.plan;
    const Real rest = time_.h - moment;
    const bool by_method = turns_by_method(plan, body);
    if (plan.integrator->proposes) plan.predicted.x[body] += rest * dv;
    if (!rotates(world_.scene, body) || !(plan.integrator->proposes || by_method)) return;
    plan.predicted.q[body] = normalized(exp_map(rest * domega) * plan.predicted.q[body]);
    if (by_method) plan.predicted.omega[body] += domega;
  }

  /// Bodies stand where the motion that they have now would have begun.
  void move_back() {
    for (const ImpactSpin& spin : c_.spins)  // a turn that does not fit a body's shape would change its energy
      if (turns_too_far(world_, spin.slot, c_.displaced[spin.slot].turn)) c_.displaced[spin.slot].turn.set_zero();
    for (const std::uint32_t i : c_.bodies) {
      correct_pose(poses_, i, c_.displaced[i].shift, c_.displaced[i].turn);
      c_.displaced[i].shift.set_zero(), c_.displaced[i].turn.set_zero();
    }
    refresh_rotations(world_);
    refresh_separations(world_);
    for (Impact& at : c_.impacts) at.gap = c_.geometry[at.row].separation;
  }

  /// A velocity that is ahead of the motion closes faster than the body comes nearer. What will bounce, and not yet in
  /// this substep, is not to be held up for that.
  void give_leeway() {
    for (Impact& at : c_.impacts) {
      const Touch t = touch(at);
      if (!(t.speed > threshold_ && t.time >= time_.h)) continue;
      at.leeway = std::max(Real(0), (lag_ - time_.h / 2) * time_.h * accel(at));
      c_.geometry[at.row].separation += at.leeway;
    }
  }

  const World& world_;
  Poses& poses_;
  Velocities& motion_;
  StepReport& report_;
  Contacts& c_;
  HeapSearch search_;
  StepTime time_;
  Real lag_, threshold_, near_;  // s, m/s, m
};

}  // namespace

Touch find_touch(Real gap, Real closing, Real accel, Real since) {
  constexpr Real kRounding = 1e-9;  // what an impact before time 0 sets off at once comes no earlier than that one
  const Real from = std::max(Real(0), since);
  const Real s = gap - from * (closing + accel * from / 2), c = closing + accel * from;
  const Real speed2 = c * c + 2 * accel * s, speed = speed2 > 0 ? std::sqrt(speed2) : 0;
  if (s <= 0 && c > 0) {
    const Real then = from + 2 * s / (c + speed);
    return speed > 0 && then >= since * (1 + kRounding) ? Touch{std::max(then, since), speed} : Touch{from, c};
  }
  if (c > 0 && speed > 0) return {from + 2 * s / (c + speed), speed};
  if (accel > 0 && speed > 0) return {from + (speed - c) / accel, speed};
  return {from, 0};
}

void measure_approach(const World& world) {
  Contacts& c = *world.contacts;
  if (c.impacts.empty()) return;
  refresh_rotations(world);
  for (Impact& at : c.impacts) {
    const Row& row = c.rows[at.row];
    RowGeometry& g = c.geometry[at.row];
    at.r = Arms(world, row, g);
    at.before = relative_velocity(world.state, row, at.r.a, at.r.b);
    at.gap = g.separation = separation_of(world, row, g);
    at.count = 0, at.leeway = 0;
  }
}

void solve_impacts(const World& world, Poses& poses, Velocities& motion, StepReport& report, const StepTime& time) {
  if (!world.contacts->impacts.empty()) Impacts(world, poses, motion, report, time).solve();
}

}  // namespace carom::dynamics

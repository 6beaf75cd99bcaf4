// One island in one step: its stages, each a kick, impulses that lead back onto the joints, a kick, and impulses that
// lead velocities along them.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "dynamics/joint/rattle/blocks.h"
#include "dynamics/joint/rattle/motion.h"
#include "dynamics/joint/rattle/rows.h"

namespace carom::dynamics::rattle {

/// Its angles as counted, where bodies stand at a stage's end.
/// @param h  s, of the stage; 0: as the step begins
void count_turns(const World& world, RattleJoint& j, const RattleBody& a, const RattleBody& b, Real h);
/// Whether all that a joint limits is between its limits.
bool is_within_limits(const World& world, const RattleJoint& j, const RattleBody& a, const RattleBody& b);

/// One island in one step.
template <int n>
class Mover {
 public:
  Mover(const World& world, Rattle& r, RattleIsland& island)
      : world_(world),
        r_(r),
        island_(island),
        blocks_{&r.elimination,
                island.joint,
                island.joint + island.joints,
                r.diagonal.data() + island.diagonal,
                r.below.data() + island.beside,
                r.above.data() + island.beside} {}

  /// From the state: joints are shut, velocities are along them. @return whether the step can be tried
  /// @param h  s, the longest stage
  bool begin(Real h) const {
    const State& s = world_.state;
    Real far = 0;
    for (RattleBody& b : bodies()) {
      if (b.slot == kInvalid) continue;
      b.x = b.x1 = s.x[b.slot], b.q = b.q1 = s.q[b.slot], b.v = s.v[b.slot], b.omega = s.omega[b.slot];
      b.r = b.r1 = b.q.matrix();
      far = std::max(far, b.x.norm());
      if (b.inv_mass == 0 && !b.travels) b.v = b.omega = Vec3::zero();
      if (b.locks) b.v = free_axes(b.locks).times(b.v), b.omega = free_turns(b.locks).times(b.omega);
      if (!b.turns) continue;
      b.l = s.momentum[b.slot];
      constexpr Real kAgree = 64 * kUnitRoundoff;  // as in integrate/rotation/top.h
      if (b.locks || !((spin_of_body(b, b.q, b.l) - b.omega).squared_norm() < kAgree * kAgree * b.omega.squared_norm()))
        b.l = turned(b.inertia, b.r) * b.omega;
      b.inv_world = response_at(b, b.r);
    }
    for (RattleJoint& j : joints()) j.force = j.torque = Vec3::zero();
    for (const RattleJoint& j : joints()) {
      const Joint& joint = world_.joints.joint[j.slot];
      for (std::uint32_t k = 0; k < j.rows; ++k)
        r_.rows[j.row + k].load = joint.p_h > 0 ? joint.p[k] / (joint.p_h / 2) : 0;
    }
    island_.rounding = 16 * kEpsilon * std::max(Real(1), far + island_.reach);
    island_.gain = 0;
    count(0);
    if (!within_limits() || !shut()) return bar();
    place();
    if (!is_resolved(h, kRattleSwing)) return false;
    settle(nullptr);
    return true;
  }

  /// One stage up to its end, before the second kick: kick, impulses, the way.
  /// @param t  s, from the step's beginning to the stage's end   @param kick  s, that forces act first
  bool go(Real h, Real kick, Real t) const {
    for (RattleBody& b : bodies())
      if (b.inv_mass > 0)
        take_kick(b, kick);
      else if (b.travels)
        travel(world_, b, t);
    island_.energy = energy();
    each_row([&](RattleRow& row) { row.p = row.load * (h / 2); });
    Real before = kInfinity;
    for (int round = 0; round < kRattleRounds; ++round) {
      push(h);
      const Real off = find_errors();
      if (!finite(off)) return false;
      if (off <= island_.rounding || (off > 0.5 * before && off <= 64 * island_.rounding)) {
        tell();
        for (RattleBody& b : bodies()) b.inv_mass > 0 ? arrive(b) : stay(b);
        count(h);
        place();
        island_.gain += energy() - island_.energy;
        return true;
      }
      if (off > 0.3 * before && off > 64 * island_.rounding) aim();
      before = off;
      // errors are those of displacements h M^-1 J^T p
      solve([&](RattleRow& row, Real x) { row.p -= x / h; });
    }
    ++island_.halvings;
    return false;
  }

  /// Its end: the second kick, and velocities along the joints.
  bool stop(Real h) const {
    for (RattleBody& b : bodies())
      if (b.inv_mass > 0) take_kick(b, h / 2);
    const Real kicked = energy();
    settle(&h);
    island_.gain += energy() - kicked;
    if (island_.gain > kRattleGain * (island_.energy + kicked) &&
        std::ranges::none_of(bodies(), &RattleBody::travels)) {
      ++island_.halvings;
      return false;
    }
    for (const RattleBody& b : movers())
      if (!(b.x.all_finite() && b.v.squared_norm() < 1e18 && b.omega.squared_norm() < 1e18)) return false;
    if (!within_limits()) return bar();
    return is_resolved(h, kHoldsTo);
  }

  /// Springs of joints, where bodies are: what they accelerate, added to what forces do.
  /// @param h  s, a substep: none is faster than a quarter of its rate   @param share  s, for which they will act
  bool pull(Real h, Real share) const {
    for (RattleJoint& j : joints())
      if (j.springs) pull(j, h, share);
    return true;
  }

 private:
  static constexpr Real kHoldsTo = 1.8;  // rad a stage: short of 2, where what is explicit in directions holds no more

  /// J, of motion.
  Real energy() const {
    Real twice = 0;
    for (const RattleBody& b : movers())
      twice += b.v.squared_norm() / b.inv_mass + (b.turns ? b.l.dot(b.inv_world * b.l) : 0);
    return twice / 2;
  }

  /// Whether stages of h can follow how joints swing bodies; else how many halvings can, or one more.
  bool is_resolved(Real h, Real most) const {
    for (RattleBody& b : movers()) b.swing = 0;
    for (const RattleJoint& j : joints()) {
      Vec3 force = Vec3::zero();
      for (std::uint32_t k = 0; k < j.rows; ++k) force += r_.rows[j.row + k].load * r_.rows[j.row + k].d;
      const Real f = force.norm();
      RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      if (a.inv_mass > 0) a.swing += f * j.swing_a;
      if (b.inv_mass > 0) b.swing += f * j.swing_b;
    }
    Real swing = 0;
    for (const RattleBody& b : movers()) swing = std::max(swing, b.swing);
    Real turn = h * h * swing;
    if (turn <= most * most) return true;
    for (; turn > kRattleSwing * kRattleSwing && island_.halvings <= island_.most_halvings; turn /= 4)
      ++island_.halvings;
    return false;
  }

  std::span<RattleBody> bodies() const { return {r_.bodies.data() + island_.body, island_.bodies}; }
  std::span<RattleBody> movers() const { return {r_.bodies.data() + island_.body, island_.movers}; }
  std::span<RattleJoint> joints() const { return {r_.joints.data() + island_.joint, island_.joints}; }
  template <class F>
  void each_row(F&& f) const {
    for (const RattleJoint& j : joints())
      for (std::uint32_t k = 0; k < j.rows; ++k) f(r_.rows[j.row + k]);
  }
  Real* of(Array<Real>& by_joint, std::uint32_t joint) const {  // in the order of elimination
    const std::size_t at = r_.elimination.place[joint] - island_.joint;
    return by_joint.data() + kMostRows * island_.joint + n * at;
  }
  std::uint32_t index(const RattleJoint& j) const { return static_cast<std::uint32_t>(&j - r_.joints.data()); }

  static void stay(RattleBody& b) { b.x = b.x1, b.q = b.q1, b.r = b.r1; }

  /// What forces do at the state's place in h.
  void take_kick(RattleBody& b, Real h) const {
    const Vec3& a = r_.trial.accel[b.slot];
    b.v += h * (b.locks ? Vec3(free_axes(b.locks).times(a)) : a);
    const Vec3& alpha = r_.trial.alpha[b.slot];
    if (b.turns && !alpha.is_zero()) b.l += turned(b.inertia, b.r) * (h * alpha);
    b.v1 = b.v, b.l1 = b.l;
  }

  /// v1, l1 and the pose they lead to, from the impulses p along the rows of where bodies are.
  void push(Real h) const {
    for (RattleBody& b : movers()) b.v1 = b.v, b.l1 = b.l;
    act([](RattleBody& b) -> Vec3& { return b.v1; }, [](RattleBody& b) -> Vec3& { return b.l1; });
    for (RattleBody& b : movers()) fly(b, h);
  }
  template <class V, class L>
  void act(V&& v, L&& l) const {
    for (const RattleJoint& j : joints()) {
      Vec3 p = Vec3::zero(), on_a = Vec3::zero(), on_b = Vec3::zero();
      for (std::uint32_t k = 0; k < j.rows; ++k) {
        const RattleRow& row = r_.rows[j.row + k];
        p += row.p * row.d, on_a += row.p * row.w_a, on_b += row.p * row.w_b;
      }
      RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      if (a.inv_mass > 0) v(a) -= speed_of(a, p), l(a) -= on_a;
      if (b.inv_mass > 0) v(b) += speed_of(b, p), l(b) += on_b;
    }
  }

  /// Errors at x1, q1 into `right`. @return the largest
  Real find_errors() const {
    Real most = 0;
    for (const RattleJoint& j : joints()) {
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      const Stand at_a = next(a), at_b = next(b);
      Real* to = of(r_.right, index(j));
      Real* const end = to + n;
      Placed(j, at_a, at_b).each<false>([&](Real error, const Vec3&, const Vec3&, const Vec3&) {
        *to++ = error;
        most = std::max(most, finite(error) ? std::fabs(error) : kInfinity);
      });
      std::fill(to, end, 0);
    }
    return most;
  }
  /// x of A x = right; f(row, x) for each.
  template <class F>
  void solve(F&& f) const {
    blocks_.solve(r_.right.data() + kMostRows * island_.joint);
    for (const RattleJoint& j : joints()) {
      const Real* const x = of(r_.right, index(j));
      for (std::uint32_t k = 0; k < j.rows; ++k) f(r_.rows[j.row + k], x[k]);
    }
  }

  void pull(RattleJoint& j, Real h, Real share) const {
    const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
    const Stand at_a = now(a), at_b = now(b);
    const Placed placed(j, at_a, at_b);
    // The mass that the locks leave a spring, were the two bodies alone.
    Real locks[n * n], own[n];
    for (std::uint32_t k = 0; k < n; ++k)
      for (std::uint32_t l = 0; l < n; ++l)
        locks[n * k + l] =
            k < j.rows && l < j.rows ? response(r_.rows[j.row + k], r_.rows[j.row + l], a, b) : Real(k == l);
    for (int k = 0; k < n; ++k) own[k] = locks[n * k + k];
    Blocks<n>::invert(locks, own, true);
    for (std::uint32_t c = 0; c < kCoordinates; ++c) {
      if (!(j.springs >> c & 1)) continue;
      const JointSpring& spring = world_.joints.joint[j.slot].drive[c].spring;
      const Placed::Along along = placed.coordinate(static_cast<Coordinate>(c));
      RattleRow row{along.d, along.w_a, along.w_b, a.inv_world * along.w_a, b.inv_world * along.w_b, 0, 0};
      Real coupled[n] = {};
      for (std::uint32_t k = 0; k < j.rows; ++k) coupled[k] = response(r_.rows[j.row + k], row, a, b);
      const Real whole = response(row, row, a, b);
      Real rest = whole;
      for (int k = 0; k < n; ++k)
        for (int l = 0; l < n; ++l) rest -= coupled[k] * locks[n * k + l] * coupled[l];
      if (!(rest > kRattleRest * whole)) continue;
      const auto v = [&](const RattleBody& of) { return of.inv_mass > 0 ? r_.trial.v[of.slot] : of.v; };
      const auto omega = [&](const RattleBody& of) { return of.inv_mass > 0 ? r_.trial.omega[of.slot] : of.omega; };
      const Real rate = row.d.dot(v(b) - v(a)) + (row.w_b.dot(omega(b)) - row.w_a.dot(omega(a)));
      const Real w = 2 * std::numbers::pi * std::min(spring.frequency, 0.25 / h);
      const Real most = spring.max_force,
                 f = std::clamp(-w * (w * (along.at - spring.target) + 2 * spring.damping * rate) / rest, -most, most);
      if (a.inv_mass > 0) r_.trial.accel[a.slot] -= speed_of(a, row.d, f), r_.trial.alpha[a.slot] -= f * row.i_a;
      if (b.inv_mass > 0) r_.trial.accel[b.slot] += speed_of(b, row.d, f), r_.trial.alpha[b.slot] += f * row.i_b;
      j.force += (share * f) * row.d;
      j.torque += (share * f) * (row.w_b - placed.r_b.cross(row.d));
    }
  }
  /// Velocity at one row per impulse at another of the same joint.
  static Real response(const RattleRow& at, const RattleRow& by, const RattleBody& a, const RattleBody& b) {
    const Real turned = at.w_a.dot(by.i_a) + at.w_b.dot(by.i_b);
    if (a.locks | b.locks) return at.d.dot(speed_of(a, by.d) + speed_of(b, by.d)) + turned;
    return (a.inv_mass + b.inv_mass) * at.d.dot(by.d) + turned;
  }

  /// Rows where bodies are, and the matrix.
  void place() const {
    for (RattleJoint& j : joints()) {
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      const Stand at_a = now(a), at_b = now(b);
      const Placed placed(j, at_a, at_b);
      j.r_b = placed.r_b;
      RattleRow* row = r_.rows.data() + j.row;
      placed.each<true>([&](Real, const Vec3& d, const Vec3& w_a, const Vec3& w_b) {
        row->d = d, row->w_a = w_a, row->w_b = w_b;
        row->i_a = a.inv_world * w_a, row->i_b = b.inv_world * w_b;
        ++row;
      });
    }
    couple([&](const RattleJoint& j) { return std::span<const RattleRow>(r_.rows.data() + j.row, j.rows); }, true);
  }

  /// The matrix again, of the rates that rows have where the stage may lead: the slope of errors there.
  void aim() const {
    const auto at = [&](const RattleJoint& j) {
      std::array<RattleRow, kMostRows> rows;
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      const Stand at_a = next(a), at_b = next(b);
      RattleRow* row = rows.data();
      Placed(j, at_a, at_b).each<true>([&](Real, const Vec3& d, const Vec3& w_a, const Vec3& w_b) {
        row->d = d, row->w_a = w_a, row->w_b = w_b;
        ++row;
      });
      return rows;
    };
    couple(at, false);
  }

  /// J1 M^-1 J0^T and its factors.   @param rates  joint -> its rows of J1
  template <class Rates>
  void couple(Rates&& rates, bool is_symmetric) const {
    Real* const own = r_.left.data() + kMostRows * island_.joint;
    for (const RattleJoint& j : joints()) {
      Real* const block = blocks_.at_diagonal(r_.elimination.place[index(j)]);
      const auto rows = rates(j);
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      Real* const self = own + n * (r_.elimination.place[index(j)] - island_.joint);
      for (std::uint32_t k = 0; k < n; ++k)
        for (std::uint32_t l = 0; l < n; ++l) {
          if (k >= j.rows || l >= j.rows) {
            block[n * k + l] = k == l;
            continue;
          }
          block[n * k + l] = response(rows[k], r_.rows[j.row + l], a, b);
        }
      if (is_symmetric)
        for (int k = 0; k < n; ++k) self[k] = block[n * k + k];
    }
    const std::size_t size =
        static_cast<std::size_t>(n * n) * (r_.elimination.column[blocks_.last] - r_.elimination.column[blocks_.first]);
    std::fill_n(blocks_.below, size, 0), std::fill_n(blocks_.above, size, 0);
    for (std::uint32_t i = island_.pair; i < island_.pair + island_.pairs; ++i) {
      const RattlePair& pair = r_.pairs[i];
      const RattleJoint &high = r_.joints[pair.high], &low = r_.joints[pair.low];
      const auto rates_high = rates(high), rates_low = rates(low);
      const Real sign = pair.is_a_of_high == pair.is_a_of_low ? 1 : -1, m = r_.bodies[pair.body].inv_mass;
      const Vec3 free = free_axes(r_.bodies[pair.body].locks);
      const auto add = [&](Real* block, const RattleJoint& of, const auto& rows, bool is_a, const RattleJoint& by,
                           bool by_a) {
        for (std::uint32_t k = 0; k < of.rows; ++k)
          for (std::uint32_t l = 0; l < by.rows; ++l) {
            const RattleRow& other = r_.rows[by.row + l];
            block[n * k + l] += sign * (m * rows[k].d.dot(free.times(other.d)) +
                                        (is_a ? rows[k].w_a : rows[k].w_b).dot(by_a ? other.i_a : other.i_b));
          }
      };
      add(blocks_.at_below(pair.at), high, rates_high, pair.is_a_of_high, low, pair.is_a_of_low);
      add(blocks_.at_above(pair.at), low, rates_low, pair.is_a_of_low, high, pair.is_a_of_high);
    }
    blocks_.factor(own, is_symmetric);
  }

  /// Velocities along the joints, by impulses of half a stage; null: as a step begins, by none that is told.
  void settle(const Real* h) const {
    find_spins();
    for (const RattleJoint& j : joints()) {
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      Real* to = of(r_.right, index(j));
      Real* const end = to + n;
      for (std::uint32_t k = 0; k < j.rows; ++k) {
        const RattleRow& row = r_.rows[j.row + k];
        *to++ = row.d.dot(b.v - a.v) + (row.w_b.dot(b.omega) - row.w_a.dot(a.omega));
      }
      std::fill(to, end, 0);
    }
    solve([](RattleRow& row, Real x) { row.p = -x; });
    act([](RattleBody& b) -> Vec3& { return b.v; }, [](RattleBody& b) -> Vec3& { return b.l; });
    find_spins();
    if (!h) return;
    tell();
    each_row([&](RattleRow& row) { row.load = row.p / (*h / 2); });
  }
  void find_spins() const {
    for (RattleBody& b : movers())
      if (b.turns) b.omega = b.inv_world * b.l;
  }

  /// Errors that the solver has left are undone at once, by displacements alone. @return whether they are small enough
  bool shut() const {
    Real before = kRattleGap;
    for (int round = 0; round < kRattleRounds; ++round) {
      const Real off = find_errors();
      if (off <= 64 * island_.rounding) return round == 0 || stand_there();
      if (!(off <= before)) return false;
      if (round == 0) place();
      before = off / 2;
      solve([](RattleRow& row, Real x) { row.p = -x; });
      for (RattleBody& b : movers()) b.v1 = b.l1 = Vec3::zero();
      act([](RattleBody& b) -> Vec3& { return b.v1; }, [](RattleBody& b) -> Vec3& { return b.l1; });
      for (RattleBody& b : movers()) {
        b.x1 += b.v1;
        if (!b.turns) continue;
        b.q1 = normalized(exp_map(b.inv_world * b.l1) * b.q1);
        b.r1 = b.q1.matrix();
      }
    }
    return false;
  }
  bool stand_there() const {
    for (RattleBody& b : movers()) {
      b.v1 = b.v, b.l1 = b.turns ? Vec3(turned(b.inertia, b.r1) * b.omega) : Vec3(Vec3::zero());
      arrive(b);
    }
    return true;
  }

  /// Impulses to what joints bear in this step.
  void tell() const {
    for (RattleJoint& j : joints())
      for (std::uint32_t k = 0; k < j.rows; ++k) {
        const RattleRow& row = r_.rows[j.row + k];
        j.force += row.p * row.d;
        j.torque += row.p * (row.w_b - j.r_b.cross(row.d));
      }
  }

  /// The solver's in this step, however it moves.
  bool bar() const {
    island_.is_barred = true;
    return false;
  }

  void count(Real h) const {
    for (RattleJoint& j : joints())
      if (j.is_limited || j.springs) count_turns(world_, j, r_.bodies[j.a], r_.bodies[j.b], h);
  }

  /// No limit acts.
  bool within_limits() const {
    for (const RattleJoint& j : joints())
      if (j.is_limited && !is_within_limits(world_, j, r_.bodies[j.a], r_.bodies[j.b])) return false;
    return true;
  }

  const World& world_;
  Rattle& r_;
  RattleIsland& island_;
  const Blocks<n> blocks_;
};

}  // namespace carom::dynamics::rattle

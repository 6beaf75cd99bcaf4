// One island in one step: its stages, each a kick, impulses that lead back onto the joints, a kick, and impulses that
// lead velocities along them.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "dynamics/joint/coupling.h"
#include "dynamics/joint/rattle/blocks.h"
#include "dynamics/joint/rattle/driving.h"

namespace carom::dynamics::rattle {

/// Its angles as counted, where bodies stand at a stage's end.
/// @param h  s, of the stage; 0: as the step begins
void count_turns(const World& world, RattleJoint& j, const RattleBody& a, const RattleBody& b, Real h);

/// One island in one step.
class Mover {
 public:
  Mover(const World& world, Rattle& r, RattleIsland& island)
      : world_(world),
        r_(r),
        island_(island),
        driving_(world, r, island),
        n_(static_cast<std::uint32_t>(island.block)),
        blocks_{{n_, &r.elimination, island.joint, island.joint + island.joints, r.diagonal.data() + island.diagonal,
                 r.below.data() + island.beside, r.above.data() + island.beside}} {}

  /// From the state: joints are shut, and it is known which drives are rows. @return whether the step can be tried
  /// @param h  s, the longest stage
  bool begin(Real h) const {
    const State& s = world_.state;
    Real far = 0;
    for (RattleBody& b : bodies()) {
      if (b.slot == kInvalid) continue;
      if (island_.goes_on) {
        b.x1 = b.x, b.q1 = b.q, b.r1 = b.r;
        far = std::max(far, b.x.norm());
        continue;
      }
      b.driven_p = b.driven_l = Vec3::zero();
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
    for (RattleJoint& j : joints()) j.rows = j.locks, j.soft_rows = 0;
    island_.has_soft_rows = false;
    if (!island_.goes_on) begin_joints();
    island_.rounding = 16 * kEpsilon * std::max(Real(1), far + island_.reach);
    island_.gain = island_.stage = 0;
    if (!shut()) return bar();
    if (!has_drives()) return true;
    lay_rows();
    const bool goes_on = driving_.decide(h);
    island_.is_decided |= goes_on;
    return goes_on;
  }
  void begin_joints() const {
    for (RattleJoint& j : joints()) {
      j.force = j.torque = Vec3::zero();
      const Joint& joint = world_.joints.joint[j.slot];
      for (std::uint32_t k = 0; k < j.locks; ++k)
        r_.rows[j.row + k].load = joint.p_h > 0 ? joint.p[k] / (joint.p_h / 2) : 0;
      if (j.is_gear) j.over.phase = joint.transmission.phase;
    }
    count(0);
  }

  /// Velocities are along the rows.
  bool ready(Real h) const {
    if (has_drives() && !shut()) return bar();
    place();
    if (!is_resolved(h, kRattleSwing)) return false;
    settle();
    if (!has_drives()) return true;
    if (!driving_.reach(h)) return false;
    if (island_.goes_on) tell(false);  // what met a limit is stopped by that
    driving_.look();
    island_.is_new = true;
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
    island_.stage = h;
    each_row([&](RattleRow& row) { row.p = row.load * (h / 2); });
    aim_drives(h);
    Real before = kInfinity, first = 0;
    for (int round = 0; round < kRattleRounds; ++round) {
      push(h);
      const Real off = find_errors();
      if (!finite(off)) return give_up(h);
      if (round == 0) first = off;
      if (off > kLost * first) break;
      if (off <= island_.rounding || (off > 0.5 * before && off <= 64 * island_.rounding)) {
        tell(false);
        if (has_drives()) driving_.look_at_loads(h / 2, std::exchange(island_.is_new, false));
        turn_gears();
        const Real work = work_of_rows();
        for (RattleBody& b : bodies()) b.inv_mass > 0 ? arrive(b) : stay(b);
        count(h);
        if (island_.has_soft_rows)
          lay_rows();
        else
          place();
        island_.gain += energy() - island_.energy - work;
        return true;
      }
      if (off > 0.3 * before && off > 64 * island_.rounding) aim();
      before = off;
      // errors are those of displacements h M^-1 J^T p
      solve([&](RattleRow& row, Real x) { row.p -= x / h; });
    }
    return give_up(h);
  }

  /// What its end is tried from, maybe more than once.
  bool save_middle() const {
    for (const RattleBody& b : movers()) r_.middle_v[place_of(b)] = b.v, r_.middle_l[place_of(b)] = b.l;
    island_.is_first = true, island_.agrees = false;
    return true;
  }

  /// Its end: the second kick, and velocities along the joints. Where forces read velocities, these are tried until they
  /// are those that were read.
  bool try_stop(Real h) const {
    if (island_.agrees) return true;
    if (!island_.is_first)
      for (RattleBody& b : movers()) b.v = r_.middle_v[place_of(b)], b.l = r_.middle_l[place_of(b)];
    for (RattleBody& b : movers()) take_kick(b, h / 2);
    island_.kicked = energy();
    if (island_.has_soft_rows && island_.is_first) couple_at_end(h / 2);
    settle(island_.has_soft_rows);
    island_.is_first = false;
    island_.agrees = true;
    if (!r_.reads_velocities) return true;
    for (const RattleBody& b : movers()) {
      Vec3 &v = r_.trial.v[b.slot], &omega = r_.trial.omega[b.slot];
      island_.agrees &= std::fabs(h) * std::max((b.v - v).norm(), (b.omega - omega).norm()) <= island_.rounding;
      v = b.v, omega = b.omega;
    }
    return true;
  }

  /// @param begun, whole  of the part of the step: where the substep began, and its length; 0: it is not at its end
  bool stop(Real h, Real begun, Real whole) const {
    if (!island_.agrees) return ++island_.halvings, false;
    const Real kicked = island_.kicked;
    tell(true);
    each_row([&](RattleRow& row) { row.load = row.p / (h / 2); });
    if (has_drives() && whole > 0) {
      const bool bears = driving_.bears(begun, whole);
      if (!driving_.soft_rows_bear(h / 2) || !bears) return false;
    }
    island_.gain += energy() - kicked - work_of_rows();
    if (island_.has_soft_rows) place();
    if (island_.gain > kRattleGain * (island_.energy + kicked) &&
        std::ranges::none_of(bodies(), &RattleBody::travels)) {
      ++island_.halvings;
      return false;
    }
    for (const RattleBody& b : movers())
      if (!(b.x.all_finite() && b.v.squared_norm() < 1e18 && b.omega.squared_norm() < 1e18)) return false;
    if (has_drives() && whole > 0 && !driving_.look_back(begun, whole)) return false;
    return is_resolved(h, kHoldsTo);
  }

  /// Drives of joints, where bodies are.   @see Driving
  bool pull(bool ends) const {
    if (has_drives() && !(island_.agrees && !island_.is_first)) driving_.pull(ends);
    return true;
  }
  bool tell_drives(Real share) const {
    if (has_drives()) driving_.tell(share);
    return true;
  }

 private:
  static constexpr Real kLeast = 1e-300;  // N s/m: a damper that does not act bears nothing
  static constexpr Real kLost =
      100;  // of errors as Newton's method began: it leads nowhere, and turns grow without end
  static constexpr Real kHoldsTo = 1.8;  // rad a stage: short of 2, where what is explicit in directions holds no more

  /// A stage that Newton's method found no end of: it turns bodies too far for their rows, or these can't all be held.
  bool give_up(Real h) const {
    constexpr Real kFar = 1;  // rad
    const bool far = std::ranges::any_of(
        movers(), [&](const RattleBody& b) { return b.turns && h * h * b.omega.squared_norm() > kFar * kFar; });
    if ((far && island_.halvings < island_.most_halvings) || !driving_.give_way()) ++island_.halvings;
    return false;
  }

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
    return by_joint.data() + kMostRows * island_.joint + n_ * at;
  }
  std::size_t place_of(const RattleBody& b) const { return static_cast<std::size_t>(&b - r_.bodies.data()); }
  bool has_drives() const { return island_.has_drives; }
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
      if (j.coupling) {
        const Real pushed = r_.rows[j.row].p;
        each_end(j, [&](RattleBody& b, const RattleCoupling::End& end) {
          if (b.inv_mass > 0) v(b) += speed_of(b, end.d, pushed), l(b) += pushed * end.w;
        });
        continue;
      }
      Vec3 p = Vec3::zero(), on_a = Vec3::zero(), on_b = Vec3::zero();
      Real sum = 0;
      for (std::uint32_t k = 0; k < j.rows; ++k) {
        const RattleRow& row = r_.rows[j.row + k];
        p += row.p * row.d, on_a += row.p * row.w_a, on_b += row.p * row.w_b, sum += row.p;
      }
      RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      if (a.inv_mass > 0) v(a) -= speed_of(a, j.two_ways ? Vec3(sum * j.d_a) : p), l(a) -= on_a;
      if (b.inv_mass > 0) v(b) += speed_of(b, p), l(b) += on_b;
    }
  }

  /// A joint where the stage may lead; of a gear how far it has turned since it began.
  Placed placed_next(const RattleJoint& j) const {
    const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
    Placed placed(j, next(a), next(b));
    if (!j.is_gear) return placed;
    const auto turned = [&](const RattleBody& of, const Quat& frame) {
      const Vec3 x = (of.q * frame) * Vec3::unit_x();
      const Quat turn = of.q1 * of.q.conjugate();
      const Real sign = turn.w() < 0 ? -1 : 1;
      const Real angle = 2 * angle_of<double>(sign * turn.vec().dot(x), sign * turn.w());
      const Vec3 spin = of.turns ? Vec3(of.inv_world * of.l1) : of.omega;
      return nearest_turn(angle, island_.stage * spin.dot(x));
    };
    placed.turned_a = turned(a, j.frame_a), placed.turned_b = turned(b, j.frame_b);
    return placed;
  }
  /// Gears stand as they would there.
  void turn_gears() const {
    for (RattleJoint& j : joints())
      if (j.is_gear) {
        const Placed placed = placed_next(j);
        j.over.phase += placed.turned_a + j.over.ratio * placed.turned_b;
      }
  }

  /// Errors at x1, q1 into `right`. @return the largest
  Real find_errors() const {
    Real most = 0;
    for (const RattleJoint& j : joints()) {
      Real* to = of(r_.right, index(j));
      Real* const end = to + n_;
      if (j.coupling) {
        *to++ = lay_coupling(j, true);
        most = std::max(most, finite(to[-1]) ? std::fabs(to[-1]) : kInfinity);
        std::fill(to, end, 0);
        continue;
      }
      const Placed placed = placed_next(j);
      const auto add = [&](Real error, const Vec3&, const Vec3&, const Vec3&) {
        *to++ = error;
        most = std::max(most, finite(error) ? std::fabs(error) : kInfinity);
      };
      placed.each<false>(add);
      driving_.each_row(j, [&](const RattleDrive& d) { add(driving_.error(j, d, placed), {}, {}, {}); });
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

  /// Where motors are to be as a stage ends.
  void aim_drives(Real h) const {
    if (has_drives())
      for (RattleJoint& j : joints())
        driving_.each_row(j, [&](RattleDrive& d) {
          const Stand at_a = now(r_.bodies[j.a]), at_b = now(r_.bodies[j.b]);
          d.goal = driving_.goal(j, d, Placed(j, at_a, at_b)) + h * d.speed;
        });
  }

  /// J: what motors that are rows did just now.
  Real work_of_rows() const {
    Real work = 0;
    for (const RattleJoint& j : joints()) {
      std::uint32_t k = j.row + j.locks;
      driving_.each_row(j, [&](const RattleDrive& d) { work += r_.rows[k++].p * d.speed; });
    }
    return work;
  }

  /// Rows where bodies are, and the matrix.
  void place() const {
    lay_rows();
    couple([&](const RattleJoint& j) { return std::span<const RattleRow>(r_.rows.data() + j.row, j.rows); }, true);
  }
  /// The matrix with soft rows beside.
  void couple_at_end(Real half) const {
    for (RattleJoint& j : joints()) j.rows += j.soft_rows;
    couple([&](const RattleJoint& j) { return std::span<const RattleRow>(r_.rows.data() + j.row, j.rows); }, true,
           half);
    for (RattleJoint& j : joints()) j.rows -= j.soft_rows;
  }
  /// The ends of a coupling's row where bodies are, or where the stage may lead.   @return m or rad, by how much it is off
  Real lay_coupling(const RattleJoint& j, bool ahead) const {
    RattleCoupling& c = r_.couplings[j.coupling - 1];
    RattleCoupling::End* const ends = ahead ? c.ahead : c.now;
    for (std::uint32_t k = 0; k < c.count; ++k) ends[k] = {Vec3::zero(), Vec3::zero(), Vec3::zero()};
    const auto look = [&](std::uint32_t joint) {
      const RattleJoint& of = r_.joints[joint];
      const RattleBody &a = r_.bodies[of.a], &b = r_.bodies[of.b];
      const Stand at_a = ahead ? next(a) : now(a), at_b = ahead ? next(b) : now(b);
      return Placed(of, at_a, at_b).coordinate(is_slide(world_, of.slot) ? Coordinate::slide : Coordinate::twist);
    };
    const auto add = [&](std::uint32_t joint, const Placed::Along& along, Real share) {
      const RattleJoint& of = r_.joints[joint];
      for (std::uint32_t k = 0; k < c.count; ++k) {
        if (c.body[k] == of.a) ends[k].d -= share * along.d, ends[k].w -= share * along.w_a;
        if (c.body[k] == of.b) ends[k].d += share * along.d, ends[k].w += share * along.w_b;
      }
    };
    const Placed::Along follows = look(c.follower), leads = look(c.leader);
    const PolynomialAt f = polynomial_at(world_.joints.coupling_of(world_.joints.joint[j.slot]), leads.at);
    add(c.follower, follows, 1), add(c.leader, leads, -f.slope);
    if (!ahead)
      for (std::uint32_t k = 0; k < c.count; ++k) ends[k].i = r_.bodies[c.body[k]].inv_world * ends[k].w;
    return follows.at - f.value;
  }
  /// f(body, end) of a coupling, where bodies are.
  template <class F>
  void each_end(const RattleJoint& j, F&& f) const {
    const RattleCoupling& c = r_.couplings[j.coupling - 1];
    for (std::uint32_t k = 0; k < c.count; ++k) f(r_.bodies[c.body[k]], c.now[k]);
  }

  void lay_rows() const {
    for (RattleJoint& j : joints()) {
      if (j.coupling) {
        lay_coupling(j, false);
        RattleRow& own = r_.rows[j.row];
        own.d = own.w_a = own.w_b = own.i_a = own.i_b = Vec3::zero();
        continue;
      }
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      const Stand at_a = now(a), at_b = now(b);
      const Placed placed(j, at_a, at_b);
      j.r_b = placed.r_b;
      if (j.two_ways) j.d_a = placed.way_at_a();
      RattleRow* row = r_.rows.data() + j.row;
      const auto add = [&](Real, const Vec3& d, const Vec3& w_a, const Vec3& w_b) {
        row->d = d, row->w_a = w_a, row->w_b = w_b;
        row->i_a = a.inv_world * w_a, row->i_b = b.inv_world * w_b;
        ++row;
      };
      placed.each<true>(add);
      driving_.each_row(j, [&](const RattleDrive& d) {
        const Placed::Along along = driving_.along(placed, j, d);
        add(0, along.d, along.w_a, along.w_b);
      });
      driving_.each_soft_row(j, [&](const RattleDrive& d) {
        const Placed::Along along = driving_.along(placed, j, d);
        add(0, along.d, along.w_a, along.w_b);
      });
    }
  }

  /// The matrix again, of the rates that rows have where the stage may lead: the slope of errors there.
  void aim() const {
    const auto at = [&](const RattleJoint& j) {
      std::array<RattleRow, kMostRows> rows;
      if (j.coupling) {
        lay_coupling(j, true);
        return rows;
      }
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      const Stand at_a = next(a), at_b = next(b);
      RattleRow* row = rows.data();
      const Placed placed(j, at_a, at_b);
      const auto add = [&](Real, const Vec3& d, const Vec3& w_a, const Vec3& w_b) {
        row->d = d, row->w_a = w_a, row->w_b = w_b;
        ++row;
      };
      placed.each<true>(add);
      driving_.each_row(j, [&](const RattleDrive& d) {
        const Placed::Along along = driving_.along(placed, j, d);
        add(0, along.d, along.w_a, along.w_b);
      });
      return rows;
    };
    couple(at, false);
  }

  Real response_of_coupling(const RattleJoint& j, bool is_symmetric) const {
    const RattleCoupling& c = r_.couplings[j.coupling - 1];
    Real sum = 0;
    for (std::uint32_t k = 0; k < c.count; ++k) {
      const RattleCoupling::End& rate = is_symmetric ? c.now[k] : c.ahead[k];
      sum += rate.d.dot(speed_of(r_.bodies[c.body[k]], c.now[k].d)) + rate.w.dot(c.now[k].i);
    }
    return sum;
  }

  /// J1 M^-1 J0^T and its factors.   @param rates  joint -> its rows of J1
  /// @param half  s, of a stage, where soft rows are among these; else 0
  template <class Rates>
  void couple(Rates&& rates, bool is_symmetric, Real half = 0) const {
    Real* const own = r_.left.data() + kMostRows * island_.joint;
    for (const RattleJoint& j : joints()) {
      Real* const block = blocks_.at_diagonal(r_.elimination.place[index(j)]);
      const auto rows = rates(j);
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      Real* const self = own + n_ * (r_.elimination.place[index(j)] - island_.joint);
      if (j.rows < n_)
        for (std::uint32_t k = 0; k < n_; ++k)
          for (std::uint32_t l = 0; l < n_; ++l) block[n_ * k + l] = k == l;
      for (std::uint32_t k = 0; k < j.rows; ++k)
        for (std::uint32_t l = 0; l < j.rows; ++l)
          block[n_ * k + l] =
              j.coupling ? response_of_coupling(j, is_symmetric) : response(j, rows[k], r_.rows[j.row + l], a, b);
      if (half != 0) {
        std::uint32_t k = j.rows - j.soft_rows;
        driving_.each_soft_row(j, [&](const RattleDrive& d) {
          block[(n_ + 1) * k] += 1 / (half * std::max(d.damping, kLeast));
          ++k;
        });
      }
      if (is_symmetric)
        for (std::uint32_t k = 0; k < n_; ++k) self[k] = block[n_ * k + k];
    }
    const std::size_t size = static_cast<std::size_t>(n_ * n_) *
                             (r_.elimination.column[blocks_.last] - r_.elimination.column[blocks_.first]);
    std::fill_n(blocks_.below, size, 0), std::fill_n(blocks_.above, size, 0);
    for (std::uint32_t i = island_.pair; i < island_.pair + island_.pairs; ++i) {
      const RattlePair& pair = r_.pairs[i];
      const RattleJoint &high = r_.joints[pair.high], &low = r_.joints[pair.low];
      const auto rates_high = rates(high), rates_low = rates(low);
      const Real sign = pair.is_a_of_high == pair.is_a_of_low ? 1 : -1, m = r_.bodies[pair.body].inv_mass;
      const Vec3 free = free_axes(r_.bodies[pair.body].locks);
      if (high.coupling || low.coupling) {
        // Of a joint's row at one of its bodies: what its rate is there, and what its impulse does there.
        const auto rate_at = [&](const RattleJoint& j, const auto& rows, std::uint32_t k, bool is_a, std::uint8_t end) {
          if (j.coupling) {
            const RattleCoupling& c = r_.couplings[j.coupling - 1];
            return is_symmetric ? c.now[end] : c.ahead[end];
          }
          return is_a ? RattleCoupling::End{-way_at_a(j, rows[k].d), -rows[k].w_a, Vec3::zero()}
                      : RattleCoupling::End{rows[k].d, rows[k].w_b, Vec3::zero()};
        };
        const auto push_at = [&](const RattleJoint& j, std::uint32_t l, bool is_a, std::uint8_t end) {
          if (j.coupling) return r_.couplings[j.coupling - 1].now[end];
          const RattleRow& row = r_.rows[j.row + l];
          return is_a ? RattleCoupling::End{-way_at_a(j, row.d), -row.w_a, -row.i_a}
                      : RattleCoupling::End{row.d, row.w_b, row.i_b};
        };
        const auto add_one = [&](Real* block, const RattleJoint& of, const auto& rows, bool is_a, std::uint8_t end,
                                 const RattleJoint& by, bool by_a, std::uint8_t by_end) {
          for (std::uint32_t k = 0; k < of.rows; ++k)
            for (std::uint32_t l = 0; l < by.rows; ++l) {
              const RattleCoupling::End at = rate_at(of, rows, k, is_a, end), push = push_at(by, l, by_a, by_end);
              block[n_ * k + l] += m * at.d.dot(free.times(push.d)) + at.w.dot(push.i);
            }
        };
        add_one(blocks_.at_below(pair.at), high, rates_high, pair.is_a_of_high, pair.end_of_high, low, pair.is_a_of_low,
                pair.end_of_low);
        add_one(blocks_.at_above(pair.at), low, rates_low, pair.is_a_of_low, pair.end_of_low, high, pair.is_a_of_high,
                pair.end_of_high);
        continue;
      }
      const auto add = [&](Real* block, const RattleJoint& of, const auto& rows, bool is_a, const RattleJoint& by,
                           bool by_a) {
        for (std::uint32_t l = 0; l < by.rows; ++l) {
          const RattleRow& other = r_.rows[by.row + l];
          const Vec3 push = free.times(by_a ? way_at_a(by, other.d) : other.d), &turn = by_a ? other.i_a : other.i_b;
          for (std::uint32_t k = 0; k < of.rows; ++k) {
            const Vec3& at = is_a ? way_at_a(of, rows[k].d) : rows[k].d;
            block[n_ * k + l] += sign * (m * at.dot(push) + (is_a ? rows[k].w_a : rows[k].w_b).dot(turn));
          }
        }
      };
      add(blocks_.at_below(pair.at), high, rates_high, pair.is_a_of_high, low, pair.is_a_of_low);
      add(blocks_.at_above(pair.at), low, rates_low, pair.is_a_of_low, high, pair.is_a_of_high);
    }
    blocks_.factor(own, is_symmetric);
  }

  /// Velocities along the joints, by impulses.   @param softly  rows of dampers act, too
  void settle(bool softly = false) const {
    if (softly)
      for (RattleJoint& j : joints()) j.rows += j.soft_rows;
    settle_rows();
    if (softly)
      for (RattleJoint& j : joints()) j.rows -= j.soft_rows;
  }
  void settle_rows() const {
    find_spins();
    for (const RattleJoint& j : joints()) {
      const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
      Real* to = of(r_.right, index(j));
      Real* const end = to + n_;
      if (j.coupling) {
        Real u = 0;
        each_end(j, [&](const RattleBody& of_it, const RattleCoupling::End& at) {
          u += at.d.dot(of_it.v) + at.w.dot(of_it.omega);
        });
        *to++ = u;
        std::fill(to, end, 0);
        continue;
      }
      for (std::uint32_t k = 0; k < j.rows; ++k) {
        const RattleRow& row = r_.rows[j.row + k];
        *to++ = rate_of(j, row, a, b);
      }
      Real* driven = end - n_ + j.locks;
      driving_.each_row(j, [&](const RattleDrive& d) { *driven++ -= d.speed; });
      if (driven < end) driving_.each_soft_row(j, [&](const RattleDrive& d) { *driven++ -= d.speed; });
      std::fill(to, end, 0);
    }
    solve([](RattleRow& row, Real x) { row.p = -x; });
    act([](RattleBody& b) -> Vec3& { return b.v; }, [](RattleBody& b) -> Vec3& { return b.l; });
    find_spins();
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
    turn_gears();
    for (RattleBody& b : movers()) {
      b.v1 = b.v, b.l1 = b.turns ? Vec3(turned(b.inertia, b.r1) * b.omega) : Vec3(Vec3::zero());
      arrive(b);
    }
    return true;
  }

  /// Impulses to what joints bear in this step.
  void tell(bool softly) const {
    for (RattleJoint& j : joints())
      for (std::uint32_t k = 0; k < j.locks; ++k) {
        if (j.coupling) {
          j.torque.x() += r_.rows[j.row].p;
          continue;
        }
        const RattleRow& row = r_.rows[j.row + k];
        j.force += row.p * row.d;
        j.torque += row.p * (row.w_b - j.r_b.cross(row.d));
      }
    if (has_drives()) driving_.tell_rows(softly);
  }

  /// The solver's in this step, however it moves.
  bool bar() const {
    island_.is_barred = true;
    return false;
  }

  void count(Real h) const {
    for (RattleJoint& j : joints())
      if (j.is_counted) count_turns(world_, j, r_.bodies[j.a], r_.bodies[j.b], h);
  }

  const World& world_;
  Rattle& r_;
  RattleIsland& island_;
  const Driving driving_;
  const std::uint32_t n_;  // rows of a block
  const Blocks blocks_;
};

}  // namespace carom::dynamics::rattle

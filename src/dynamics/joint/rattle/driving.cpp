#include "dynamics/joint/rattle/driving.h"

#include <algorithm>
#include <utility>

namespace carom::dynamics::rattle {
namespace {

constexpr Real kAtOnce = 1e-9;  // of a part of a step: what happens before that is so as it begins

using By = RattleDrive::By;
using Law = RattleDrive::Law;

/// What a joint's locks leave of the response along a row, were its two bodies alone.
class Freedom {
 public:
  Freedom(const Rattle& r, const RattleJoint& j) : r_(r), j_(j) {}

  /// 1/kg or 1/(kg m^2); 0: nothing
  Real along(const RattleRow& row) {
    const RattleBody &a = r_.bodies[j_.a], &b = r_.bodies[j_.b];
    if (!is_known_) invert(a, b);
    Real coupled[kMostRows];
    for (std::uint32_t k = 0; k < j_.locks; ++k) coupled[k] = response(j_, r_.rows[j_.row + k], row, a, b);
    const Real whole = response(j_, row, row, a, b);
    Real rest = whole;
    for (std::uint32_t k = 0; k < j_.locks; ++k)
      for (std::uint32_t l = 0; l < j_.locks; ++l) rest -= coupled[k] * inverse_[k][l] * coupled[l];
    return rest > kRattleRest * whole ? rest : 0;
  }

 private:
  /// @see Blocks::invert()
  void invert(const RattleBody& a, const RattleBody& b) {
    is_known_ = true;
    const std::uint32_t n = j_.locks;
    Real own[kMostRows];
    for (std::uint32_t k = 0; k < n; ++k)
      for (std::uint32_t l = 0; l < n; ++l)
        inverse_[k][l] = response(j_, r_.rows[j_.row + k], r_.rows[j_.row + l], a, b);
    for (std::uint32_t k = 0; k < n; ++k) own[k] = inverse_[k][k];
    for (std::uint32_t k = 0; k < n; ++k) {
      const Real pivot = inverse_[k][k];
      if (!(pivot > kRattleRest * own[k])) {
        for (std::uint32_t l = 0; l < n; ++l) inverse_[k][l] = inverse_[l][k] = 0;
        continue;
      }
      const Real by = 1 / pivot;
      for (std::uint32_t l = 0; l < n; ++l) inverse_[k][l] *= by;
      inverse_[k][k] = by;
      for (std::uint32_t i = 0; i < n; ++i) {
        if (i == k) continue;
        const Real s = inverse_[i][k];
        inverse_[i][k] = 0;
        for (std::uint32_t l = 0; l < n; ++l) inverse_[i][l] -= s * inverse_[k][l];
      }
    }
  }

  const Rattle& r_;
  const RattleJoint& j_;
  bool is_known_ = false;
  Real inverse_[kMostRows][kMostRows];
};

RattleRow row_along(const Placed::Along& along, const RattleBody& a, const RattleBody& b) {
  return {along.d, along.w_a, along.w_b, a.inv_world * along.w_a, b.inv_world * along.w_b, 0, 0};
}

/// m/s and rad/s, that a host bears; 0: none asks.
Real borne_rate(const Dials& dials) {
  const Real place = dials[Dial::accuracy_place], turn = dials[Dial::accuracy_turn];
  return place > 0 && turn > 0 ? std::min(place, turn) : std::max(place, turn);
}

}  // namespace

bool Driving::decide(Real h) const {
  for (RattleJoint& j : joints())
    if (j.drives > 0 && !decide(j, h)) return false;
  return true;
}

/// Whether stages can follow how a damper decays; else how many more can.   @param h  s, the longest
bool Driving::follows(const RattleDrive& d, Real rest, Real h) const {
  constexpr Real kBack = 0.5, kOn = 1;  // c h / 2 m, of stages that go back, of those that go on
  constexpr int kMostParts = 16;        // of a stage
  const Real z = (d.per_mass ? d.c : d.c * rest) * h / 2;
  if (z <= (island_.is_stiff ? kOn : kBack)) return true;
  if (!island_.is_stiff)
    island_.is_stiff = true;
  else if (island_.finer * z <= kMostParts)
    island_.finer = static_cast<int>(std::ceil(island_.finer * z));
  else
    return island_.is_barred = true, false;
  return island_.is_changed = true, false;
}

/// Whether a motor is taken to be at its speed as a stage begins, though it lacks `off`. It is half of the way there further
/// on then than it would be: where an accuracy is asked for that is no more than is borne, else it gets there in a part of the step.
/// @param most  m/s^2 or rad/s^2, that it can give   @param h  s, a stage
bool Driving::is_there(const RattleDrive& d, Real off, Real most, Real h) const {
  if (!(std::fabs(off) <= most * h)) return false;
  const bool got_there_now =
      island_.goes_on && 2 * static_cast<std::uint32_t>(&d - r_.drives.data()) == island_.event_drive;
  const Real borne = borne_rate(world_.scene.dials);
  return borne == 0 || got_there_now || off * off <= 2 * most * borne * h;
}

bool Driving::decide(RattleJoint& j, Real h) const {
  const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
  const Stand at_a = now(a), at_b = now(b);
  const Placed placed(j, at_a, at_b);
  const Real slack = 64 * island_.rounding;
  Freedom freedom(r_, j);
  std::uint32_t taken = 0;  // coordinates that have a row
  for (RattleDrive& d : drives(j)) {
    const Placed::Along along = this->along(placed, j, d);
    const bool is_idle = d.law == Law::limit && d.load == 0 && d.way == 0 && !island_.is_decided;
    if (is_idle && along.at >= d.lower - slack && along.at <= d.upper + slack) {
      d.by = By::nothing, d.gave_way = false;
      continue;
    }
    RattleRow row = row_along(along, a, b);
    if (!island_.is_decided) {
      d.gave_way = false;
      const Real u = rate_of(j, row, a, b), rest = freedom.along(row);
      const bool may_be = rest > 0 && j.rows + j.soft_rows < j.most_rows && !(taken >> d.row.coordinate & 1);
      d.by = rest > 0 ? By::force : By::nothing;
      if (d.law == Law::pull) {
        d.way = 0;
        const bool acts = d.lower == d.upper || !(along.at >= d.lower && along.at <= d.upper);
        if (may_be && d.c > 0 && acts) d.by = By::soft_row;
        if (d.by == By::soft_row && !follows(d, rest, h)) return false;
      } else if (d.law == Law::motor) {
        const Real off = d.speed - u;
        const bool at_bound = std::fabs(d.load) >= (1 - 1e-9) * d.most && d.load * off > 0;
        if (may_be && !at_bound && is_there(d, off, rest * d.most, h)) d.by = By::row;
        d.way = off > 0 ? 1 : -1;
      } else {
        const bool rests = may_be && std::fabs(u) * h <= kRattleGap;
        d.by = By::nothing;
        if (may_be && d.way != 0 && island_.goes_on)  // it was met just now
          d.by = By::row, d.goal = d.way > 0 ? d.lower : d.upper;
        else if (rests && d.load > 0 && along.at <= d.lower + kRattleGap && along.at >= d.lower - kRattleGap)
          d.by = By::row, d.goal = d.lower;
        else if (rests && d.load < 0 && along.at >= d.upper - kRattleGap && along.at <= d.upper + kRattleGap)
          d.by = By::row, d.goal = d.upper;
        else if (!(along.at >= d.lower - slack && along.at <= d.upper + slack))
          return island_.is_barred = true, false;
        d.way = 0;
      }
    }
    const bool may = j.rows + j.soft_rows < j.most_rows && !(taken >> d.row.coordinate & 1);
    if (!may && d.by >= By::soft_row) {  // another found a row since
      if (d.law == Law::limit) return island_.is_barred = true, false;
      d.by = By::force, d.gave_way = true;
    }
    if (d.by == By::soft_row) ++j.soft_rows, island_.has_soft_rows = true;
    if (d.by == By::row || d.by == By::soft_row) {
      taken |= 1u << d.row.coordinate;
      island_.block = std::max(island_.block, static_cast<int>(j.rows + j.soft_rows) + (d.by == By::row));
    }
    if (d.by != By::row) continue;
    d.goal = goal(j, d, placed);
    row.load = d.load;
    r_.rows[j.row + j.rows++] = row;
  }
  return true;
}

void Driving::pull(bool ends) const {
  for (RattleJoint& j : joints())
    if (j.drives > j.rows - j.locks) pull(j, ends);
}

void Driving::pull(RattleJoint& j, bool ends) const {
  const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
  const Stand at_a = now(a), at_b = now(b);
  const Placed placed(j, at_a, at_b);
  Freedom freedom(r_, j);
  for (RattleDrive& d : drives(j)) {
    if (d.by != By::force && d.by != By::soft_row) continue;
    const Placed::Along along = this->along(placed, j, d);
    const RattleRow row = row_along(along, a, b);
    Real f = d.effort;
    if (d.law == Law::motor) {
      f = d.way * d.most;
    } else if (d.k > 0 || d.c > 0) {
      const Real off = along.at - std::clamp(along.at, d.lower, d.upper), rest = freedom.along(row);
      d.goal = off;
      f = 0;
      if (rest > 0 && (d.lower == d.upper || off != 0)) {
        const auto v = [&](const RattleBody& of) { return of.inv_mass > 0 ? r_.trial.v[of.slot] : of.v; };
        const auto omega = [&](const RattleBody& of) { return of.inv_mass > 0 ? r_.trial.omega[of.slot] : of.omega; };
        const Real u = rate_of(j, row, v(a), omega(a), v(b), omega(b));
        const Real mass = d.per_mass ? 1 / rest : 1, k = std::min(mass * d.k, d.stiffest / rest);
        d.damping = mass * d.c;
        const bool is_damped = d.by == By::soft_row ? !ends : d.way == 0;
        f = -(k * off + (is_damped ? d.damping * (u - d.speed) : 0));
        if (d.by == By::force && d.way != 0 && d.lower == d.upper) f = d.way * d.most;  // all that it has
        if (d.lower < d.upper) f = off < 0 ? std::max(f, Real(0)) : std::min(f, Real(0));
        if (d.by == By::force || !ends) f = std::clamp(f, -d.most, d.most);  // else with its damper: soft_rows_bear()
      }
    }
    d.load = f, d.d = row.d, d.w_a = row.w_a, d.w_b = row.w_b;
    if (a.inv_mass > 0)
      r_.trial.accel[a.slot] -= speed_of(a, way_at_a(j, row.d), f), r_.trial.alpha[a.slot] -= f * row.i_a;
    if (b.inv_mass > 0) r_.trial.accel[b.slot] += speed_of(b, row.d, f), r_.trial.alpha[b.slot] += f * row.i_b;
  }
}

void Driving::tell(Real share) const {
  for (RattleJoint& j : joints())
    for (const RattleDrive& d : drives(j))
      if (d.by == By::force || d.by == By::soft_row) tell(j, d.d, d.w_a, d.w_b, share * d.load);
}

void Driving::tell(RattleJoint& j, const Vec3& d, const Vec3& w_a, const Vec3& w_b, Real p) const {
  RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
  j.force += p * d, j.torque += p * (w_b - j.r_b.cross(d));
  a.driven_p -= p * way_at_a(j, d), a.driven_l -= p * w_a;
  b.driven_p += p * d, b.driven_l += p * w_b;
}

void Driving::tell_rows(bool softly) const {
  for (RattleJoint& j : joints())
    for (std::uint32_t k = j.row + j.locks; k < j.row + j.rows + (softly ? j.soft_rows : 0); ++k) {
      const RattleRow& row = r_.rows[k];
      tell(j, row.d, row.w_a, row.w_b, row.p);
    }
}

/// @return how many there are; 0: nothing that it does ends
int Driving::ends_of(const RattleJoint& j, const RattleDrive& d, Real h, Real apart[2]) const {
  const RattleBody &a = r_.bodies[j.a], &b = r_.bodies[j.b];
  const bool pushes = d.law == Law::motor && d.by == By::force;
  if (!pushes && (d.law != Law::limit || d.by == By::row)) return 0;
  const Stand at_a = now(a), at_b = now(b);
  const Placed::Along along = this->along(Placed(j, at_a, at_b), j, d);
  if (d.law == Law::limit) return apart[0] = along.at - d.lower, apart[1] = d.upper - along.at, 2;
  const RattleRow row = row_along(along, a, b);
  // One that is so weak that when it turns round makes no difference beyond rounding.
  if (h > 0 && 2 * d.most * response(j, row, row, a, b) * h * h <= island_.rounding) return 0;
  return apart[0] = d.way * (d.speed - rate_of(j, row, a, b)), 1;
}

void Driving::look() const {
  for (const RattleJoint& j : joints())
    for (RattleDrive& d : drives(j)) ends_of(j, d, 0, d.before);
}

bool Driving::look_back(Real begun, Real whole) const {
  const Real slack = 64 * island_.rounding;
  bool is_well = true;
  for (const RattleJoint& j : joints())
    for (RattleDrive& d : drives(j)) {
      Real apart[2];
      const int ends = ends_of(j, d, std::fabs(island_.stage) / whole, apart);
      for (int k = 0; k < ends; ++k) {
        const bool is_limit = d.law == Law::limit;
        const Real before = std::exchange(d.before[k], apart[k]);
        const std::uint32_t place =
            2 * static_cast<std::uint32_t>(&d - r_.drives.data()) + static_cast<std::uint32_t>(k);
        if (!island_.takes_events && place == island_.event_drive && before > apart[k])
          island_.late = whole * apart[k] / (before - apart[k]);
        if (apart[k] >= (is_limit ? -slack : Real(0))) continue;
        if (!island_.takes_events) {
          if (is_limit && apart[k] < -kRattleGap && place != island_.event_drive)
            return island_.is_barred = true, false;
          continue;
        }
        is_well = false;
        const Real event = before > 0 ? begun + whole * before / (before - apart[k]) : 0;
        if (event > kAtOnce) {
          if (island_.event == 0 || event < island_.event) island_.event = event, island_.event_drive = place;
          if (is_limit) d.way = k == 0 ? 1 : -1;
        } else if (is_limit) {
          d.by = By::row, d.goal = k == 0 ? d.lower : d.upper, d.load = 0;
        } else {
          d.gave_way ? void(d.way = -d.way) : void(d.by = By::row);
        }
      }
    }
  if (!is_well) island_.is_changed = true;
  return is_well;
}

bool Driving::reach(Real h) const {
  bool all = true;
  for (const RattleJoint& j : joints()) {
    std::uint32_t k = j.row + j.locks;
    each_row(j, [&](RattleDrive& d) {
      const Real p = r_.rows[k++].p;
      if (d.law == Law::limit || std::fabs(p) <= d.most * h) return;
      all = false;
      d.by = By::force, d.way = p > 0 ? 1 : -1, d.gave_way = true;
    });
  }
  if (!all) island_.is_changed = true;
  return all;
}

bool Driving::give_way() const {
  bool any = false, limits = false;
  for (const RattleJoint& j : joints())
    each_row(j, [&](RattleDrive& d) {
      if (d.law == Law::motor)
        d.by = By::force, d.way = d.load < 0 ? -1 : 1, d.gave_way = any = true;
      else
        limits = true;
    });
  if (any) return island_.is_changed = true;
  return island_.is_barred |= limits;
}

/// N or N m: what is left of what a row may bear.
Real Driving::left_of(const RattleDrive& d) {
  return d.law == Law::motor ? d.most - std::fabs(d.load) : d.goal == d.lower ? d.load : -d.load;
}

void Driving::look_at_loads(Real half, bool is_first) const {
  for (const RattleJoint& j : joints()) {
    std::uint32_t k = j.row + j.locks;
    each_row(j, [&](RattleDrive& d) {
      d.led = r_.rows[k++].p / half;
      if (is_first) d.load = d.led, d.before[0] = left_of(d);
    });
  }
}

bool Driving::bears(Real begun, Real whole) const {
  bool all = true, is_known = true;
  for (const RattleJoint& j : joints()) {
    std::uint32_t k = j.row + j.locks;
    each_row(j, [&](RattleDrive& d) {
      d.load = r_.rows[k++].load;
      const Real mean = (d.load + d.led) / 2;
      if (d.law == Law::motor && std::fabs(d.load - d.led) > d.most && std::fabs(mean) <= d.most) {
        if (left_of(d) < 0 && island_.halvings < island_.most_halvings) return void(is_known = false);
        d.load = mean;
      }
      const Real left = left_of(d), before = std::exchange(d.before[0], left);
      if (left >= 0) return;
      all = false;
      const Real event = before > 0 ? begun + whole * before / (before - left) : 0;
      if (event > kAtOnce && island_.takes_events) {
        if (island_.event == 0 || event < island_.event) island_.event = event, island_.event_drive = kInvalid;
        return;
      }
      if (event > kAtOnce) return void(all = true);  // at the end of a part that ends there
      d.by = d.law == Law::motor ? By::force : By::nothing;
      d.way = d.law == Law::limit ? 0 : d.load > 0 ? 1 : -1;
      d.gave_way = true;
    });
  }
  if (!is_known) return ++island_.halvings, false;
  if (!all) island_.is_changed = true;
  return all;
}

bool Driving::soft_rows_bear(Real half) const {
  bool all = true;
  for (const RattleJoint& j : joints()) {
    std::uint32_t k = j.row + j.rows;
    each_soft_row(j, [&](RattleDrive& d) {
      d.load += r_.rows[k++].p / half;
      const bool is_within = d.lower == d.upper || d.load * d.goal <= 0;
      if (std::fabs(d.load) <= d.most && is_within) return;
      all = false;
      d.by = By::force, d.way = d.load > 0 ? 1 : -1;
    });
  }
  if (!all) island_.is_changed = true;
  return all;
}

}  // namespace carom::dynamics::rattle

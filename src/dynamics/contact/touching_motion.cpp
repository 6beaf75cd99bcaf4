#include "dynamics/contact/touching_motion.h"

#include <algorithm>

#include "collision/support.h"
#include "dynamics/effects.h"
#include "dynamics/world.h"

namespace carom::dynamics {
namespace {

constexpr Real kRounding = 1e-12;
constexpr Real kImplied = 1e-10;  // of the largest entry: a pivot below it is of a row that the others imply

/// x of A x = b in place of b, of up to six rows. @return false: one is implied by the others
bool eliminate(int n, Real a[6][6], Real b[6]) {
  Real largest = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) largest = std::max(largest, std::fabs(a[i][j]));
  for (int k = 0; k < n; ++k) {
    int best = k;
    for (int i = k + 1; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[best][k])) best = i;
    if (!(std::fabs(a[best][k]) > kImplied * largest)) return false;
    if (best != k) {
      std::swap(b[best], b[k]);
      for (int j = k; j < n; ++j) std::swap(a[best][j], a[k][j]);
    }
    for (int i = k + 1; i < n; ++i) {
      const Real by = a[i][k] / a[k][k];
      for (int j = k + 1; j < n; ++j) a[i][j] -= by * a[k][j];
      b[i] -= by * b[k];
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return true;
}

TouchingMotion::At ahead(const TouchingMotion::At& at, const Vec3& x, const Vec3& v, const Vec3& omega, const Quat& q,
                         Real h) {
  return {at.x + h * x, at.v + h * v, at.omega + h * omega, normalized(at.q + h * q)};
}

}  // namespace

TouchingMotion::TouchingMotion(const World& world, const TouchingBody& of, Trial& trial)
    : world_(world),
      of_(of),
      trial_(trial),
      mass_(world.scene.mass[of.body]),
      inertia_(world.scene.inertia[of.body]),
      inv_inertia_(world.scene.inv_inertia[of.body]) {
  for (int k = 0; k < of.count; ++k) {
    const std::uint32_t collider = of.touches[k].collider;
    size_[k] = world.scene.colliders.shape[collider]->bounding_radius + world.plan->local[collider].p.norm();
  }
  for (int end = 0; end < kMostEnds; ++end) slips_[end] = impulse_[end] = Vec3::zero();
}

Real TouchingMotion::energy(const At& at) const {
  const Vec3 spin = at.q.conjugate() * at.omega;
  return (mass_ * at.v.squared_norm() + spin.dot(inertia_ * spin)) / 2;
}

Vec3 TouchingMotion::accel(const At& at) const {
  Vec3 accel = of_.accel, alpha = Vec3::zero();
  of_.varying.add(world_, trial_, at.x, at.q, at.v, at.omega, accel, alpha);
  return accel;
}

Mat3 TouchingMotion::inverse_inertia(const Quat& q) const {
  const Mat3 turn = q.matrix();
  return turn * inv_inertia_ * turn.transpose();
}

/// m, from the centre of mass to the farthest point in a direction of the world.
bool TouchingMotion::support(const Mat3& turn, const FlatTouch& touch, const Vec3& direction, Vec3& r) const {
  const Frame& local = world_.plan->local[touch.collider];
  collision::SupportFault fault;
  Vec3 point;
  if (!full_support(*world_.scene.colliders.shape[touch.collider], local.r.transpose() * (turn.transpose() * direction),
                    point, fault))
    return false;
  r = turn * local.apply(point);
  return true;
}

/// The line turns over the body as it rolls: each look for its ends leads nearer to it by `roll_tilt`.
bool TouchingMotion::line_ends(const Mat3& turn, const FlatTouch& touch, Vec3& near, Vec3& far) const {
  constexpr int kLooks = 5;
  constexpr Real kLeastLine = 0.05;  // of the body's size
  constexpr Real kSettled = 1e-9;    // rad
  Vec3 along = touch.along;
  for (int look = 0; look < kLooks; ++look) {
    if (!support(turn, touch, -1 * touch.n + kRollTilt * along, far) ||
        !support(turn, touch, -1 * touch.n - kRollTilt * along, near))
      return false;
    Vec3 line = far - near;
    line -= line.dot(touch.n) * touch.n;
    const Real length = line.norm();
    if (!(length > kLeastLine * size(static_cast<int>(&touch - of_.touches)))) return false;
    line = line / length;
    if ((line - along).squared_norm() <= kSettled * kSettled) return true;
    along = line;
  }
  return false;
}

bool TouchingMotion::ends(const Quat& q, Vec3 r[kMostEnds]) const {
  const Mat3 turn = q.matrix();
  for (int k = 0; k < of_.count; ++k) {
    if (grip_[k] == Grip::opened) continue;
    const FlatTouch& touch = of_.touches[k];
    if (touch.is_line() ? !line_ends(turn, touch, r[2 * k], r[2 * k + 1])
                        : !support(turn, touch, -1 * touch.n, r[2 * k]))
      return false;
  }
  return true;
}

bool TouchingMotion::clearance(const At& at, int touch, Real t, Real& to) const {
  Vec3 r;
  if (!support(at.q.matrix(), of_.touches[touch], -1 * of_.touches[touch].n, r)) return false;
  to = gap(at.x, r, touch, t);
  return true;
}

bool TouchingMotion::travelling(const At& at, Ends& e) const {
  const Real spin = at.omega.norm();
  for (Vec3& travel : e.travel) travel = Vec3::zero();
  if (!ends(at.q, e.r)) return false;
  if (!(spin > 0)) return true;
  const Vec3 turn = (kRollProbe / spin) * at.omega;
  Vec3 before[kMostEnds], after[kMostEnds];
  if (!ends(exp_map(-1 * turn) * at.q, before) || !ends(exp_map(turn) * at.q, after)) return false;
  for (int i = 0; i < kMostEnds; ++i) {
    if (!is_active(i)) continue;
    const Real far = (after[i] - before[i]).norm(), bend = ((after[i] - e.r[i]) - (e.r[i] - before[i])).norm();
    if (!(far <= 2 * kRollTravel * kRollProbe * size(i / 2)) || !(bend <= kRollBend * far + kRounding * size(i / 2)))
      return false;
    e.travel[i] = (spin / (2 * kRollProbe)) * (after[i] - before[i]);
  }
  return true;
}

Vec3 TouchingMotion::slip(const At& at, const Vec3& r, int touch) const {
  return at.v + at.omega.cross(r) - surface_velocity(of_.touches[touch], at.x + r);
}

bool TouchingMotion::note_slips(const At& at, Real least) {
  Vec3 r[kMostEnds];
  if (!ends(at.q, r)) return false;
  for (int i = 0; i < kMostEnds; ++i) {
    if (!is_active(i)) continue;
    const Vec3& n = of_.touches[i / 2].n;
    const Vec3 s = slip(at, r[i], i / 2);
    slips_[i] = s - s.dot(n) * n;
    if (!(slips_[i].norm() >= least * of_.touches[i / 2].friction)) return false;
  }
  return true;
}

/// N m for each newton of load, against rolling and spinning.
Vec3 TouchingMotion::resistance(const FlatTouch& touch, const Vec3& omega) const {
  const Vec3 w = omega - touch.surface_spin;
  const Real spin = w.dot(touch.n);
  const Vec3 roll = w - spin * touch.n;
  const Real rate = roll.norm();
  Vec3 moment = (spin > 0 ? -touch.spinning : spin < 0 ? touch.spinning : 0) * touch.n;
  if (rate > 0) moment -= (touch.rolling / rate) * roll;
  return moment;
}

void TouchingMotion::open_what_parts(const At& at) {
  Vec3 r[kMostEnds];
  Rate rates;
  if (!ends(at.q, r) || !rate(at, rates)) return;
  for (int k = 0; k < of_.count; ++k)
    if (grip_[k] != Grip::opened && !(rates.load[k] > 0) && slip(at, r[2 * k], k).dot(of_.touches[k].n) > 0)
      grip_[k] = Grip::opened;
}

/// The directions that are held, and the forces that hold them.
/// @return false: more than can hold a body, or what slides has turned back
bool TouchingMotion::add_rows(const At& at, const Vec3 r[kMostEnds], bool with_friction, Rows& rows) const {
  const auto add = [&](int end, Along along, const Vec3& d, const Vec3& push, const Vec3& resisted) {
    if (rows.count == 6) return false;
    rows.at[rows.count++] = {end, along, d, push, r[end].cross(push) + resisted};
    return true;
  };
  for (int i = 0; i < kMostEnds; ++i) {
    if (!is_active(i)) continue;
    const FlatTouch& touch = of_.touches[i / 2];
    const bool holds = grip_[i / 2] == Grip::holds;
    Vec3 push = touch.n;
    if (with_friction && !holds && touch.friction > 0) {
      const Vec3 s = slip(at, r[i], i / 2), level = s - s.dot(touch.n) * touch.n;
      if (!(level.dot(slips_[i]) > 0)) return false;
      push -= (touch.friction / level.norm()) * level;
    }
    if (!add(i, Along::normal, touch.n, push, with_friction ? resistance(touch, at.omega) : Vec3::zero())) return false;
    if (!holds) continue;
    const Vec3 line = touch.is_line() ? r[i | 1] - r[i & ~1] : any_perpendicular(touch.n);
    const Vec3 across = touch.n.cross(line) / touch.n.cross(line).norm(), along = across.cross(touch.n);
    if (i % 2 == 0 && !add(i, Along::line, along, along, Vec3::zero())) return false;
    if (!add(i, Along::across, across, across, Vec3::zero())) return false;
  }
  return true;
}

/// The forces, or impulses, that give what is wanted of each row, in its place.
bool TouchingMotion::respond(const Rows& rows, const Mat3& inv, const Vec3 r[kMostEnds], Real wanted[6]) const {
  Real a[6][6];
  for (int j = 0; j < rows.count; ++j) {
    const Vec3 v = rows.at[j].push / mass_, w = inv * rows.at[j].moment;
    for (int i = 0; i < rows.count; ++i) a[i][j] = rows.at[i].d.dot(v + w.cross(r[rows.at[i].end]));
    if (!(a[j][j] > 0)) return false;  // friction would drive it into its surface: the paradox of Painleve
  }
  return eliminate(rows.count, a, wanted);
}

bool TouchingMotion::settle(At& at, Real most) {
  Vec3 r[kMostEnds];
  Rows rows;
  if (!ends(at.q, r) || !add_rows(at, r, false, rows)) return false;
  const Mat3 inv = inverse_inertia(at.q);
  Real p[6];
  for (int i = 0; i < rows.count; ++i) p[i] = -rows.at[i].d.dot(slip(at, r[rows.at[i].end], rows.at[i].end / 2));
  if (!respond(rows, inv, r, p)) return false;
  Vec3 push = Vec3::zero(), moment = Vec3::zero(), at_end[kMostEnds];
  for (Vec3& of_end : at_end) of_end = Vec3::zero();
  Real taken = 0;
  for (int i = 0; i < rows.count; ++i) {
    push += p[i] * rows.at[i].push, moment += p[i] * rows.at[i].moment, taken += p[i] * p[i];
    at_end[rows.at[i].end] += p[i] * rows.at[i].push;
  }
  if (!(taken <= most * most)) return false;
  at.v += push / mass_, at.omega += inv * moment;
  for (int i = 0; i < kMostEnds; ++i) impulse_[i] += at_end[i];
  return true;
}

/// 1/s: how fast forces change along its way, w of a'' = -w^2 a.
Real TouchingMotion::swing(const At& at, Real dt) const {
  const Real size = std::max(size_[0], size_[1]), way = dt * (at.v.norm() + at.omega.norm() * size);
  if (!of_.varying || !(way > 0)) return 0;
  const At then = {at.x + dt * at.v, at.v, at.omega, normalized(exp_map(dt * at.omega) * at.q)};
  Vec3 a[2], alpha[2];
  for (int k = 0; k < 2; ++k) {
    const At& of = k == 0 ? at : then;
    a[k] = alpha[k] = Vec3::zero();
    of_.varying.add(world_, trial_, of.x, of.q, of.v, of.omega, a[k], alpha[k]);
  }
  return std::sqrt(((a[1] - a[0]).norm() + (alpha[1] - alpha[0]).norm() * size) / way);
}

bool TouchingMotion::pace(const At& at, Real dt, Real& seconds) const {
  Ends e;
  if (!travelling(at, e)) return false;
  Real rate = std::max({at.omega.norm(), of_.varying.rate, swing(at, dt)});
  for (int i = 0; i < kMostEnds; ++i) {
    const Real far = is_active(i) ? e.r[i].norm() : 0;
    if (far > 0) rate = std::max(rate, e.travel[i].norm() / far);
  }
  seconds = rate > 0 ? 1 / rate : kInfinity;
  return true;
}

/// Whether what is held bears its tangential forces. Along a line both ends bear them as they bear the load.
bool TouchingMotion::friction_bears(const Rows& rows, const Real force[6]) const {
  for (int k = 0; k < of_.count; ++k) {
    if (grip_[k] != Grip::holds) continue;
    Real load[2] = {0, 0}, along = 0, across[2] = {0, 0};
    for (int i = 0; i < rows.count; ++i) {
      const Row& row = rows.at[i];
      if (row.end / 2 != k) continue;
      if (row.along == Along::line) along = force[i];
      if (row.along == Along::normal) load[row.end % 2] = force[i];
      if (row.along == Along::across) across[row.end % 2] = force[i];
    }
    const Real sum = load[0] + load[1], friction = of_.touches[k].friction;
    for (int end = 0; end < (of_.touches[k].is_line() ? 2 : 1); ++end) {
      const Real share = sum > 0 ? along * (load[end] / sum) : along;
      if (!(share * share + across[end] * across[end] <= friction * friction * load[end] * load[end])) return false;
    }
  }
  return true;
}

/// @return false: friction does not bear it, or the place that touches is not what it was. A load below 0 is told alone.
bool TouchingMotion::rate(const At& at, Rate& to) const {
  Ends e;
  return travelling(at, e) && rate(at, e, to);
}
bool TouchingMotion::rate(const At& at, const Ends& e, Rate& to) const {
  const Mat3 turn = at.q.matrix(), inv = turn * inv_inertia_ * turn.transpose();
  const Vec3 spun = turn * (inertia_ * (turn.transpose() * at.omega));
  Vec3 accel = of_.accel, free = inv * (of_.torque - at.omega.cross(spun)), alpha = Vec3::zero();
  if (of_.varying) of_.varying.add(world_, trial_, at.x, at.q, at.v, at.omega, accel, alpha), free += alpha;
  to.work = mass_ * accel.dot(at.v) + of_.torque.dot(at.omega);
  if (of_.varying) to.work += (turn * (inertia_ * (turn.transpose() * alpha))).dot(at.omega);
  Rows rows;
  if (!add_rows(at, e.r, true, rows)) return false;
  Real force[6];
  for (int i = 0; i < rows.count; ++i) {
    const int end = rows.at[i].end;
    const FlatTouch& touch = of_.touches[end / 2];
    const Vec3 surface = touch.surface_spin.cross(at.v + e.travel[end] - touch.surface_v);
    force[i] = rows.at[i].d.dot(surface - at.omega.cross(e.travel[end]) - accel - free.cross(e.r[end]));
  }
  if (!respond(rows, inv, e.r, force)) return false;
  Vec3 push = Vec3::zero(), moment = Vec3::zero();
  for (Vec3& of_end : to.force) of_end = Vec3::zero();
  for (Real& load : to.load) load = kInfinity;
  for (int i = 0; i < rows.count; ++i) {
    const Row& row = rows.at[i];
    push += force[i] * row.push, moment += force[i] * row.moment;
    to.force[row.end] += force[i] * row.push;
    if (row.along == Along::normal) to.load[row.end / 2] = std::min(to.load[row.end / 2], force[i]);
  }
  if (pulled(to.load) < 0 && !friction_bears(rows, force)) return false;
  to.x = at.v, to.v = accel + push / mass_, to.omega = free + inv * moment;
  to.q = 0.5 * (Quat(0, at.omega.x(), at.omega.y(), at.omega.z()) * at.q);
  return true;
}

/// The touch that would have to be pulled, or -1.
int TouchingMotion::pulled(const Real load[TouchingBody::kMost]) const {
  for (int k = 0; k < of_.count; ++k)
    if (grip_[k] != Grip::opened && !(load[k] > 0)) return k;
  return -1;
}

/// A step of the method, wherever loads lead.
bool TouchingMotion::run(At& at, Real h, Rate& mean, Ends& begun) const {
  Rate a, b, c, d;
  const auto by = [&](const Rate& rate, Real s) { return ahead(at, rate.x, rate.v, rate.omega, rate.q, s); };
  if (!travelling(at, begun) || !rate(at, begun, a) || !rate(by(a, h / 2), b) || !rate(by(b, h / 2), c) ||
      !rate(by(c, h), d))
    return false;
  const auto weigh = [&](const auto& p, const auto& q, const auto& r, const auto& s) {
    return (1.0 / 6) * (p + s + 2.0 * (q + r));
  };
  mean.x = weigh(a.x, b.x, c.x, d.x), mean.v = weigh(a.v, b.v, c.v, d.v);
  mean.omega = weigh(a.omega, b.omega, c.omega, d.omega), mean.q = weigh(a.q, b.q, c.q, d.q);
  mean.work = weigh(a.work, b.work, c.work, d.work);
  for (int i = 0; i < kMostEnds; ++i) mean.force[i] = weigh(a.force[i], b.force[i], c.force[i], d.force[i]);
  for (int k = 0; k < of_.count; ++k)
    mean.load[k] = std::min(std::min(a.load[k], b.load[k]), std::min(c.load[k], d.load[k]));
  at = by(mean, h);
  return at.x.all_finite() && at.omega.all_finite();
}

void TouchingMotion::note(const Rate& mean, Real h) {
  work_ += h * mean.work;
  for (int i = 0; i < kMostEnds; ++i)
    if (is_active(i)) impulse_[i] += h * mean.force[i];
}

TouchingMotion::Outcome TouchingMotion::advance(At& at, Real h, int& opened) {
  At next = at;
  Rate mean;
  Ends begun;
  if (!run(next, h, mean, begun)) return Outcome::fails;
  opened = pulled(mean.load);
  if (opened >= 0) return Outcome::opens;
  Vec3 r[kMostEnds];
  if (!ends(next.q, r)) return Outcome::fails;
  for (int i = 0; i < kMostEnds; ++i)
    if (is_active(i) && !((r[i] - (begun.r[i] + h * begun.travel[i])).norm() <=
                          kRollJump * (h * begun.travel[i].norm() + kRollStep * size(i / 2))))
      return Outcome::fails;
  note(mean, h);
  at = next;
  return Outcome::moved;
}

/// By bisection: it happens once in the life of a touch.
bool TouchingMotion::advance_to_opening(At& at, Real& h, int opened) {
  constexpr int kHalvings = 24;
  Real presses = 0, pulls = h;
  for (int i = 0; i < kHalvings; ++i) {
    const Real middle = (presses + pulls) / 2;
    At next = at;
    Rate mean, end;
    Ends begun;
    if (!run(next, middle, mean, begun) || !rate(next, end)) return false;
    (end.load[opened] > 0 ? presses : pulls) = middle;
  }
  h = presses;
  if (!(h > 0)) return true;
  Rate mean;
  Ends begun;
  if (!run(at, h, mean, begun)) return false;
  note(mean, h);
  return true;
}

bool TouchingMotion::correct(At& at, Real t, const Real want[kMostEnds]) const {
  constexpr Real kMostTurn = 0.01;  // rad
  Vec3 r[kMostEnds];
  if (!ends(at.q, r)) return false;
  Rows rows;
  Real by[6];
  for (int i = 0; i < kMostEnds; ++i) {
    if (!is_active(i)) continue;
    const Vec3& n = of_.touches[i / 2].n;
    by[rows.count] = want[i] - gap(at.x, r[i], i / 2, t);
    rows.at[rows.count++] = {i, Along::normal, n, n, r[i].cross(n)};
  }
  if (rows.count == 1) {
    at.x += by[0] * rows.at[0].d;
    return true;
  }
  const Mat3 inv = inverse_inertia(at.q);
  if (!respond(rows, inv, r, by)) return false;
  Vec3 push = Vec3::zero(), moment = Vec3::zero();
  for (int i = 0; i < rows.count; ++i) push += by[i] * rows.at[i].push, moment += by[i] * rows.at[i].moment;
  const Vec3 turn = inv * moment;
  if (!(turn.norm() <= kMostTurn)) return false;
  at.x += push / mass_, at.q = normalized(exp_map(turn) * at.q);
  return true;
}

}  // namespace carom::dynamics

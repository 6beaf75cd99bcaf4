// Purses of energy by sets of bodies, and what a paddle can have put into them.
#include "jury/energy.h"

#include <algorithm>
#include <cmath>

#include "jury/gaps.h"

namespace carom::tools::jury {
namespace {

/// How fast the paddle's surface moves at a place, m/s.
Vec surface_velocity(const Member& member, const State& paddle, const Vec& at) {
  return paddle.velocity + paddle.omega.cross(at - paddle.position) + paddle.orientation * member.surface;
}

/// What a body can have after it met a surface that moves at u: in the frame of the surface nothing is gained, so its
/// motion there is at most what it was, in any direction.
/// @param spread  m/s, by how much u differs between the points at which they may touch
double most_after(const Member& m, const State& s, const Vec& u, double spread) {
  State relative = s;
  relative.velocity -= u;
  return 0.5 * std::pow(std::sqrt(2 * kinetic(m, relative)) + std::sqrt(m.mass) * (u.norm() + 2 * spread), 2);
}

}  // namespace

double kinetic(const Member& m, const State& s) {
  const Vec omega_b = s.orientation.conjugate() * s.omega;
  return 0.5 * m.mass * s.velocity.squaredNorm() + 0.5 * omega_b.dot(m.inertia * omega_b);
}

double potential(const Member& m, const State& s, double gravity) { return m.mass * gravity * center_of(m, s).y(); }

double Purse::limit(double gravity, double dt) const {
  return 0.02 * std::max(had - lowest, 0.0) + slack + gravity * dt / 2 * brisk;
}

Energies::Energies(const Case& c, double dt, const Frame& start)
    : the_case_(c), dt_(dt), sets_(start.size()), purses_(start.size()), lowest_(start.size()), gains_(start.size()) {
  std::size_t moving = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    purses_[i].top = -HUGE_VAL;
    moving += c.members[i].moves();
    if (c.members[i].moves() && start[i].is_there) appear(i, start[i]);
  }
  for (Purse& purse : purses_) purse.slack += purse.slack > 0 ? c.stored / static_cast<double>(moving) : 0;
}

/// What a body brings with it.
void Energies::appear(std::size_t i, const State& state) {
  const Member& m = the_case_.members[i];
  Purse& purse = purses_[sets_.of(i)];
  lowest_[i] = potential(m, state, the_case_.gravity);
  purse.lowest += lowest_[i];
  purse.had += kinetic(m, state) + lowest_[i];
  purse.brisk += m.mass * state.velocity.norm();
  purse.slack += m.mass * the_case_.gravity * (0.001 + 0.02 * m.thickness);
  purse.top = std::max(purse.top, center_of(m, state).y());
  purse.launch = std::max(purse.launch, reach_speed(m, state));
}

void Energies::merge(std::size_t a, std::size_t b) {
  const std::size_t stays = sets_.of(a), goes = sets_.of(b);
  if (!sets_.merge(a, b)) return;
  Purse& p = purses_[stays];
  const Purse& q = purses_[goes];
  p.excess += q.excess, p.had += q.had, p.lowest += q.lowest, p.brisk += q.brisk, p.slack += q.slack;
  p.driven += q.driven, p.top = std::max(p.top, q.top), p.launch = std::max(p.launch, q.launch),
                        p.stirred = std::max(p.stirred, q.stirred);
}

/// How much of what a body gained in a step the paddles explain.
double Energies::paddle_share(const Frame& before, const std::vector<Near>& pairs, const Sets& islands,
                              std::size_t body, double gain) {
  const Member& m = the_case_.members[body];
  double most = 0;
  for (const Near& near : pairs) {
    const bool a_stirs = the_case_.members[near.a].stirs();
    if (!a_stirs && !the_case_.members[near.b].stirs()) continue;
    const std::size_t paddle = a_stirs ? near.a : near.b, touched = a_stirs ? near.b : near.a;
    if (islands.of(touched) != islands.of(body)) continue;
    const Vec u = surface_velocity(the_case_.members[paddle], before[paddle], a_stirs ? near.point_a : near.point_b);
    Purse& purse = purses_[sets_.of(body)];
    const double spread =
        before[paddle].omega.norm() * std::min(the_case_.members[touched].size, the_case_.members[paddle].size);
    purse.stirred = std::max(purse.stirred, u.norm() + spread);
    double after = most_after(m, before[body], u, spread);
    if (touched != body)  // pushed through others, from any side
      after = 0.5 * std::pow(std::sqrt(2 * kinetic(m, before[body])) + 2 * std::sqrt(m.mass) * (u.norm() + spread), 2);
    most = std::max(most, after - kinetic(m, before[body]) + m.mass * the_case_.gravity * (u.norm() + spread) * dt_);
  }
  return std::clamp(gain, 0.0, std::max(most, 0.0));
}

/// Drives give to a set as a whole: what one of its bodies loses another may have.
void Energies::give_driven(const Frame& before, const Frame& now, const std::vector<Drive>& drives,
                           std::vector<double>& change) {
  std::vector<double> most(now.size());
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const Link& link = the_case_.links[k];
    if (drives[k].aim == Drive::Aim::none || !now[link.a].is_there || !now[link.b].is_there) continue;
    most[sets_.of(the_case_.members[link.a].moves() ? link.a : link.b)] += most_work(link, drives[k], before, now, dt_);
  }
  for (std::size_t set = 0; set < most.size(); ++set) {
    const double given = std::clamp(change[set], 0.0, most[set]);
    purses_[set].driven += most[set], purses_[set].had += given;
    change[set] -= given, given_ += given;
  }
}

void Energies::step(const Frame& before, const Frame& now, const std::vector<Near>& pairs, const Sets& islands,
                    const std::vector<Drive>& drives, double dt) {
  const double g = the_case_.gravity;
  dt_ = dt;
  for (const Near& near : pairs)
    if (the_case_.members[near.a].moves() && the_case_.members[near.b].moves()) merge(near.a, near.b);
  for (const Link& link : the_case_.links)
    if (the_case_.members[link.a].moves() && the_case_.members[link.b].moves()) merge(link.a, link.b);
  given_ = 0;
  std::vector<double> change(now.size()), brisk(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Member& m = the_case_.members[i];
    gains_[i] = 0;
    if (!m.moves() || !now[i].is_there) continue;
    const double p = potential(m, now[i], g);
    gains_[i] = kinetic(m, now[i]) + p - kinetic(m, before[i]) - potential(m, before[i], g);
    const double given = paddle_share(before, pairs, islands, i, gains_[i]);
    given_ += given;
    const std::size_t set = sets_.of(i);
    purses_[set].had += given;
    purses_[set].lowest += std::min(p - lowest_[i], 0.0);
    lowest_[i] = std::min(lowest_[i], p);
    change[set] += gains_[i] - given;
    brisk[set] += m.mass * now[i].velocity.norm();
  }
  give_driven(before, now, drives, change);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!the_case_.members[i].moves() || sets_.of(i) != i) continue;
    Purse& purse = purses_[i];
    purse.excess = std::max(0.0, purse.excess + change[i]);
    purse.brisk = std::max(purse.brisk, brisk[i]);
  }
}

void Energies::meddled(const Frame& before, const Frame& now) {
  const double g = the_case_.gravity;
  const auto energy = [&](std::size_t i, const State& s) {
    return kinetic(the_case_.members[i], s) + potential(the_case_.members[i], s, g);
  };
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Member& m = the_case_.members[i];
    if (!m.moves() || !now[i].is_there) continue;
    if (!before[i].is_there) {
      appear(i, now[i]);
      continue;
    }
    if (before[i].position == now[i].position && before[i].velocity == now[i].velocity &&
        before[i].omega == now[i].omega)
      continue;
    Purse& purse = purses_[sets_.of(i)];
    const double p = potential(m, now[i], g);
    purse.had += std::max(0.0, energy(i, now[i]) - energy(i, before[i]));
    purse.lowest += std::min(p - lowest_[i], 0.0);
    lowest_[i] = std::min(lowest_[i], p);
    purse.top = std::max(purse.top, center_of(m, now[i]).y());
    purse.launch = std::max(purse.launch, reach_speed(m, now[i]));
    // A joint that a host tore is pulled together: what hangs on it may be lifted by as much.
    double weight = 0;
    for (std::size_t k = 0; k < now.size(); ++k)
      if (the_case_.members[k].moves() && sets_.of(k) == sets_.of(i)) weight += the_case_.members[k].mass * g;
    for (const Link& link : the_case_.links)
      if (link.a == i || link.b == i) purse.slack += weight * gap_of(the_case_, link, now);
  }
}

std::size_t Energies::worst() const {
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t i = 0; i < gains_.size(); ++i)
    if (the_case_.members[i].moves() && excess_of(i) > most * limit(i)) most = excess_of(i) / limit(i), worst = i;
  for (std::size_t i = 0; i < gains_.size(); ++i)
    if (the_case_.members[i].moves() && sets_.of(i) == sets_.of(worst) && gains_[i] > gains_[worst]) worst = i;
  return worst;
}

double Energies::speed_limit(std::size_t member) const {
  const Purse& p = purse(member);
  const double fall = std::max(p.top - the_case_.floor, 0.0);
  const double driven = p.driven > 0 ? 2 * p.driven / the_case_.members[member].mass : 0;
  return 2 * (std::sqrt(p.launch * p.launch + 2 * the_case_.gravity * fall + driven) + 2 * p.stirred);
}

}  // namespace carom::tools::jury

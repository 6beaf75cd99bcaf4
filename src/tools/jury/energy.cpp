// Purses of energy by sets of bodies, and what a paddle can have put into them.
#include "jury/energy.h"

#include <algorithm>
#include <cmath>

namespace carom::tools::jury {
namespace {

/// How fast the paddle's surface moves at a place, m/s.
Vec surface_velocity(const State& paddle, const Vec& at) {
  return paddle.velocity + paddle.omega.cross(at - paddle.position);
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
    : the_case_(c), dt_(dt), sets_(start.size()), gains_(start.size()) {
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Member& m = c.members[i];
    Purse purse;
    lowest_.push_back(0);
    if (m.moves()) {
      lowest_[i] = purse.lowest = potential(m, start[i], c.gravity);
      purse.had = kinetic(m, start[i]) + purse.lowest;
      purse.brisk = m.mass * start[i].velocity.norm();
      purse.slack = m.mass * c.gravity * (0.001 + 0.02 * m.thickness);
      purse.top = center_of(m, start[i]).y();
      purse.launch = reach_speed(m, start[i]);
    } else {
      purse.top = -HUGE_VAL;
    }
    purses_.push_back(purse);
  }
}

void Energies::merge(std::size_t a, std::size_t b) {
  const std::size_t stays = sets_.of(a), goes = sets_.of(b);
  if (!sets_.merge(a, b)) return;
  Purse& p = purses_[stays];
  const Purse& q = purses_[goes];
  p.excess += q.excess, p.had += q.had, p.lowest += q.lowest, p.brisk += q.brisk, p.slack += q.slack;
  p.top = std::max(p.top, q.top), p.launch = std::max(p.launch, q.launch), p.stirred = std::max(p.stirred, q.stirred);
}

/// How much of what a body gained in a step the paddles explain.
double Energies::paddle_share(const Frame& before, const std::vector<Near>& pairs, const Sets& islands,
                              std::size_t body, double gain) {
  const Member& m = the_case_.members[body];
  double most = 0;
  for (const Near& near : pairs) {
    const bool a_stirs = the_case_.members[near.a].type == CAROM_BODY_KINEMATIC;
    if (!a_stirs && the_case_.members[near.b].type != CAROM_BODY_KINEMATIC) continue;
    const std::size_t paddle = a_stirs ? near.a : near.b, touched = a_stirs ? near.b : near.a;
    if (islands.of(touched) != islands.of(body)) continue;
    const Vec u = surface_velocity(before[paddle], a_stirs ? near.point_a : near.point_b);
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

void Energies::step(const Frame& before, const Frame& now, const std::vector<Near>& pairs, const Sets& islands) {
  const double g = the_case_.gravity;
  for (const Near& near : pairs)
    if (the_case_.members[near.a].moves() && the_case_.members[near.b].moves()) merge(near.a, near.b);
  for (const Link& link : the_case_.links)
    if (the_case_.members[link.a].moves() && the_case_.members[link.b].moves()) merge(link.a, link.b);
  given_ = 0;
  std::vector<double> change(now.size()), brisk(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Member& m = the_case_.members[i];
    if (!m.moves()) continue;
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
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!the_case_.members[i].moves() || sets_.of(i) != i) continue;
    Purse& purse = purses_[i];
    purse.excess = std::max(0.0, purse.excess + change[i]);
    purse.brisk = std::max(purse.brisk, brisk[i]);
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
  return 2 * (std::sqrt(p.launch * p.launch + 2 * the_case_.gravity * fall) + 2 * p.stirred);
}

}  // namespace carom::tools::jury

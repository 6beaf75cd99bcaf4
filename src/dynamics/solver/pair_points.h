// Solvers that go pair by pair, over rows of a group: a pair's points go through kernels side by side.
#pragma once

#include <array>
#include <span>

#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

/// Rows of one pair, which stand together: in the list of rows that is gone through, and in Contacts::rows.
struct PairRows {
  std::uint32_t at, row, count;
};

inline constexpr double kNoMatrix[9] = {};

/// What both kernels ask; masses, inertias and how bodies are held are the solver's.
inline PointSources point_sources(const World& world, const PairRows& pair) {
  const Contacts& c = *world.contacts;
  const State& s = world.state;
  const Row& first = c.rows[pair.row];
  PointSources of;
  of.rotation_a = world.plan->rotation[first.a].data(), of.rotation_b = world.plan->rotation[first.b].data();
  of.held_a = of.held_b = kNoMatrix;
  of.x_a = s.x[first.a].data(), of.x_b = s.x[first.b].data();
  of.v_a = s.v[first.a].data(), of.v_b = s.v[first.b].data();
  of.omega_a = s.omega[first.a].data(), of.omega_b = s.omega[first.b].data();
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    const std::uint32_t row = pair.row + (lane < pair.count ? lane : 0);
    of.row[lane] = c.rows[row].u.data(), of.geometry[lane] = c.geometry[row].l_a.data();
    of.surface[lane] = c.surface.empty() ? kNoMatrix : c.surface[row].data();
  }
  of.to_b = Arms::to_b(first, c.geometry[pair.row]);
  return of;
}

/// Go through pairs, some at a time: sources(pair, of) says what of them, or false: leave this one out;
/// kernel(sources, pairs, results) finds what is asked; f(pair, result) takes it.
/// @param rows  ascending, all or none of a pair's
template <class Result, class Sources, class F>
void each_pair(const Contacts& c, std::span<const std::uint32_t> rows, const Sources& sources,
               void (*kernel)(const PointSources*, std::size_t, Result*), const F& f) {
  constexpr std::size_t kTogether = 8;
  std::array<PairRows, kTogether> pairs;
  std::array<PointSources, kTogether> asked;
  std::array<Result, kTogether> results;
  std::size_t n = 0;
  const auto run = [&] {
    kernel(asked.data(), n, results.data());
    for (std::size_t i = 0; i < n; ++i) f(pairs[i], results[i]);
    n = 0;
  };
  for (std::uint32_t at = 0, next; at < rows.size(); at = next) {
    const std::uint32_t row = rows[at];
    pairs[n] = {at, row, c.first_row[c.geometry[row].pair + 1] - row};
    next = at + pairs[n].count;
    if (sources(pairs[n], asked[n]) && ++n == kTogether) run();
  }
  if (n > 0) run();
}

}  // namespace carom::dynamics

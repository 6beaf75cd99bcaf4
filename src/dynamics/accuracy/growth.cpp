// Two motions side by side.
#include "dynamics/accuracy/growth.h"

#include <algorithm>
#include <cmath>

#include "core/logarithm.h"
#include "dynamics/body_state.h"

namespace carom::dynamics::accuracy {
namespace {

/// Of length `apart`, another for each body: @source Weyl's sequence, whose terms are spread evenly.
Vec3 direction_of(std::uint32_t number, Real apart) {
  const auto term = [&](Real step) {
    const Real at = step * (number + 1);
    return 2 * (at - std::floor(at)) - 1;
  };
  const Vec3 d(term(0.8191725133961644), term(0.6710436067037893), term(0.5497004779019703));
  const Real length = d.norm();
  return length > 0 ? Vec3((apart / length) * d) : Vec3(apart * Vec3::unit(0));
}

bool moves(const World& world, std::uint32_t i) {
  return world.scene.bodies.alive(i) && responds(world.scene, world.state, i) && !world.state.sleeps(i);
}

void push_apart(World& world) {
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i)
    if (moves(world, i))
      world.set_velocity(i, world.state.v[i] + direction_of(2 * i, kGrowthApart),
                         world.state.omega[i] + direction_of(2 * i + 1, kGrowthApart));
}

Real distance(const World& one, const World& other, std::uint32_t i) {
  const State &a = one.state, &b = other.state;
  const Quat turn = a.q[i] * b.q[i].conjugate();
  const Real angle = 2 * std::min(Real(1), Vec3(turn.x(), turn.y(), turn.z()).norm());
  return std::max({(a.x[i] - b.x[i]).norm(), (a.v[i] - b.v[i]).norm(), angle, (a.omega[i] - b.omega[i]).norm()});
}

}  // namespace

Growth measure_growth(World& one, World& other, Real dt, std::uint32_t steps) {
  Growth growth;
  push_apart(other);
  std::uint32_t to_root = 0;  // steps until growth was the root of what it is in the end
  Array<Real> factors(one.memory);
  factors.reserve(steps);
  while (growth.steps < steps && growth.factor < kGrowthMost) {
    one.step(dt), other.step(dt);
    ++growth.steps;
    Real most = 0;
    for (std::uint32_t i = 0; i < one.scene.bodies.slots(); ++i) {
      if (!one.scene.bodies.alive(i) || !(one.scene.inv_mass[i] > 0)) continue;
      const Real apart = distance(one, other, i);
      if (!(apart > most)) continue;
      most = apart, growth.body = i;
    }
    growth.factor = most / kGrowthApart;
    factors.push_back(growth.factor);
  }
  if (growth.steps == 0 || !(growth.factor > 0)) return growth;
  growth.rate = logarithm(growth.factor) / (growth.steps * dt);
  while (to_root < growth.steps && factors[to_root] * factors[to_root] < growth.factor) ++to_root;
  growth.is_sensitive = growth.factor >= kGrowthLeast && to_root >= kGrowthShare * growth.steps;
  return growth;
}

}  // namespace carom::dynamics::accuracy

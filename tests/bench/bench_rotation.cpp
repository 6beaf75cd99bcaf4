// Rotation methods: what a step of a body costs, and how wrong its pose is after a minute of free spin.
//
// Counters: ns a body and step in the stage `integrate` alone, least of 60 steps of 1,024 tops; angle in rad, momentum
// and energy relative, of the suite's top (box 1 x 2 x 3 m, omega (4, 1, 2) rad/s) after 60 s at the rate given.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "eigen.h"
#include "tools/accuracy/free_top.h"
#include "world_builder.h"

namespace {

using namespace carom;
using namespace carom::test;
using tools::accuracy::FreeTop;

constexpr std::uint32_t kBodies = 1024;

std::uint32_t add_top(TestWorld& t) {
  BodyDef def;
  def.has_mass = def.has_inertia = true;
  def.mass = 6000;
  def.inertia = Mat3::diagonal(Vec3(6500, 5000, 2500));
  def.omega = Vec3(4, 1, 2);
  return handle_slot(t.world.add_body(def));
}

double least_ns(Real integrator, Real method, Real h) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, integrator);
  t.world.set_dial(Dial::rotation, method);
  for (std::uint32_t i = 0; i < kBodies; ++i) add_top(t);
  double least = 1e9;
  for (int i = 0; i < 60; ++i) {
    t.world.step(h);
    least = std::min(least, t.world.report.stage_seconds[static_cast<std::size_t>(Stage::integrate)]);
  }
  return 1e9 * least / kBodies;
}

void spin(benchmark::State& state, Real integrator, Real method) {
  const auto hertz = static_cast<int>(state.range(0));
  const Vec3 inertia(6500, 5000, 2500), omega(4, 1, 2);
  static const Quat kEnd = plain(FreeTop(eigen(inertia), eigen(omega)).orientation(60));
  double ns = 1e9, angle = 0, momentum = 0, energy = 0;
  for (auto _ : state) {
    ns = std::min(ns, least_ns(integrator, method, 1.0 / hertz));
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, integrator);
    t.world.set_dial(Dial::rotation, method);
    const std::uint32_t b = add_top(t);
    t.run(60 * hertz, 1.0 / hertz);
    const Quat& q = t.world.state.q[b];
    const Vec3 w = q.conjugate() * t.world.state.omega[b], l0 = inertia.times(omega);
    angle = 2 * std::min((kEnd.conjugate() * q).vec().norm(), 1.0);
    momentum = (q * inertia.times(w) - l0).norm() / l0.norm();
    energy = std::fabs(w.dot(inertia.times(w)) / omega.dot(l0) - 1);
  }
  state.counters["ns"] = ns;
  state.counters["angle"] = angle;
  state.counters["momentum"] = momentum;
  state.counters["energy"] = energy;
}

#define CAROM_BENCH_SPIN(name, integrator, method)  \
  BENCHMARK_CAPTURE(spin, name, integrator, method) \
      ->Arg(30)                                     \
      ->Arg(60)                                     \
      ->Arg(120)                                    \
      ->Arg(240)                                    \
      ->Arg(480)                                    \
      ->Arg(960)                                    \
      ->Iterations(3)
CAROM_BENCH_SPIN(none, 1, 0);
CAROM_BENCH_SPIN(explicit, 1, 1);
CAROM_BENCH_SPIN(implicit, 1, 2);
CAROM_BENCH_SPIN(rk4, 1, 3);
CAROM_BENCH_SPIN(lie_midpoint, 1, 4);
CAROM_BENCH_SPIN(splitting, 1, 5);
CAROM_BENCH_SPIN(splitting_4, 1, 6);
CAROM_BENCH_SPIN(splitting_6, 1, 7);
CAROM_BENCH_SPIN(rk4_integrator, 2, 1);
CAROM_BENCH_SPIN(verlet_splitting, 3, 5);

}  // namespace

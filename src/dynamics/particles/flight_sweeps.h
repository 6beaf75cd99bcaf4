// The integrators for particles, and the loop around them: the arithmetic behind FlightKernels. Included by one file for
// each width of registers, compiled for it; all that stands here is local to that file.
//
// The same operations in the same order as integrate/ does to a body without a shape: same bits
// (tests/oracle/test_particles.cpp).
#pragma once

#include "core/wide.h"
#include "dynamics/particles/flight_kernels.h"

namespace carom::dynamics {
namespace {

struct ExplicitEulerFlight {
  const Lanes h, kick, keep;
  CAROM_LANES_INLINE explicit ExplicitEulerFlight(const Flight& f)
      : h(all(f.h)), kick(all(f.h * f.gravity)), keep(all(f.keep)) {}
  CAROM_LANES_INLINE void operator()(Lanes& x, Lanes& v) const {
    x = x + h * v;
    v = (v + kick) * keep;
  }
};

struct SemiImplicitFlight {
  const Lanes h, kick, keep;
  CAROM_LANES_INLINE explicit SemiImplicitFlight(const Flight& f)
      : h(all(f.h)), kick(all(f.h * f.gravity)), keep(all(f.keep)) {}
  CAROM_LANES_INLINE void operator()(Lanes& x, Lanes& v) const {
    v = (v + kick) * keep;
    x = x + h * v;
  }
};

struct RungeKuttaFlight {
  const Lanes h, half, gravity, drag, keep;
  CAROM_LANES_INLINE explicit RungeKuttaFlight(const Flight& f)
      : h(all(f.h)), half(all(f.h / 2)), gravity(all(f.gravity)), drag(all(f.drag)), keep(all(f.keep)) {}
  CAROM_LANES_INLINE void operator()(Lanes& x, Lanes& v) const {
    const Lanes outer = all(1.0 / 6), inner = all(1.0 / 3);
    const Lanes a1 = gravity - drag * v, v2 = v + half * a1;
    const Lanes a2 = gravity - drag * v2, v3 = v + half * a2;
    const Lanes a3 = gravity - drag * v3, v4 = v + h * a3;
    const Lanes a4 = gravity - drag * v4;
    x = x + h * (outer * v + inner * v2 + inner * v3 + outer * v4);
    v = (v + h * (outer * a1 + inner * a2 + inner * a3 + outer * a4)) * keep;
  }
};

struct VerletFlight {
  const Lanes h, kick, keep;
  CAROM_LANES_INLINE explicit VerletFlight(const Flight& f)
      : h(all(f.h)), kick(all(f.h / 2 * f.gravity)), keep(all(f.keep)) {}
  CAROM_LANES_INLINE void operator()(Lanes& x, Lanes& v) const {
    v = v * keep + kick;
    x = x + h * v;
    v = (v + kick) * keep;
  }
};

CAROM_LANES_INLINE Lanes load(const double* from, std::size_t n) {
  Lanes to = all(0);
  __builtin_memcpy(&to, from, n * sizeof(double));
  return to;
}
CAROM_LANES_INLINE double sum(Lanes a) { return (a[0] + a[1]) + (a[2] + a[3]); }

template <class Method, bool kWeighed>
struct Pass {
  const Method method;
  const int substeps;
  Lanes vis_viva = all(0), x2 = all(0), v2 = all(0);

  /// @param n  up to four; empty lanes are 0
  CAROM_LANES_INLINE void four(const FlightRun& run, std::size_t i, std::size_t n) {
    Lanes x = load(run.x + i, n), v = load(run.v + i, n);
    method(x, v);
    for (int k = 1; k < substeps; ++k) method(x, v);
    __builtin_memcpy(run.x + i, &x, n * sizeof(double));
    __builtin_memcpy(run.v + i, &v, n * sizeof(double));
    if (n < kLanes) x = load(run.x + i, n), v = load(run.v + i, n);  // empty lanes have flown too
    x2 += x * x;
    v2 += v * v;
    if constexpr (kWeighed) vis_viva += load(run.mass + i, n) * (v * v);
  }
};

template <class Method, bool kWeighed>
void fly(const FlightRun& given, const Flight& flight, int substeps, FlightSums& sums) {
  const FlightRun run = given;  // what is written could be a part of it, for all that a compiler knows
  Pass<Method, kWeighed> pass{Method(flight), substeps};
  std::size_t i = 0;
  for (; i + kLanes <= run.count; i += kLanes) pass.four(run, i, kLanes);
  if (i < run.count) pass.four(run, i, run.count - i);
  sums.vis_viva += sum(kWeighed ? pass.vis_viva : pass.v2);
  sums.x2 += sum(pass.x2);
  sums.v2 += sum(pass.v2);
}

constexpr FlightKernels kernels_named(const char* name) {
  return {name,
          {fly<ExplicitEulerFlight, false>, fly<SemiImplicitFlight, false>, fly<RungeKuttaFlight, false>,
           fly<VerletFlight, false>},
          {fly<ExplicitEulerFlight, true>, fly<SemiImplicitFlight, true>, fly<RungeKuttaFlight, true>,
           fly<VerletFlight, true>}};
}

}  // namespace
}  // namespace carom::dynamics

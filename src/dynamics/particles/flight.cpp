// One pass over memory a step: each block is read, taken through all substeps, summed and written.
#include "dynamics/particles/flight.h"

#include <algorithm>
#include <bit>

#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {
namespace {

/// Call f(begin, end) for runs of [begin, end) in which none is held.
template <class F>
void each_free_run(const ParticleSet& set, std::size_t begin, std::size_t end, F&& f) {
  const auto next = [&](std::size_t i, bool is_held) {
    while (i < end) {
      const std::uint64_t word = (is_held ? set.held[i / 64] : ~set.held[i / 64]) >> (i % 64);
      if (word) return std::min(end, i + static_cast<std::size_t>(std::countr_zero(word)));
      i = (i / 64 + 1) * 64;
    }
    return end;
  };
  for (std::size_t i = next(begin, false); i < end;) {
    const std::size_t stop = next(i, true);
    f(i, stop);
    i = next(stop, false);
  }
}

struct BlockRange {
  std::size_t begin, end;
  BlockRange(const ParticleSet& set, std::size_t block)
      : begin(block * kParticleBlock), end(std::min(begin + kParticleBlock, set.size())) {}
};

enum : std::uint32_t { kRungeKutta = 2, kVelocityVerletChoice = 3 };  // as CAROM_INTEGRATOR_*

/// As bodies do (integrate/free_flight.h): where nothing but gravity acts, one substep is as good as many.
int substeps_of(const World& world, const ParticleDef& def) {
  return world.plan->integrator->exact_in_flight && def.linear_damping == 0 ? 1 : world.plan->substeps;
}

/// What a set does in a substep, by axis.
std::array<Flight, 3> plan_flight(const Scene& scene, const ParticleDef& def, const StepTime& time, int substeps) {
  const std::uint32_t integrator = scene.dials.choice(Dial::integrator);
  const Real c = def.linear_damping;
  const bool as_force = integrator == kRungeKutta && c * time.dt <= substeps;  // as refresh() decides for bodies
  const Real over = integrator == kVelocityVerletChoice ? time.h / 2 : time.h;
  std::array<Flight, 3> flight;
  for (int axis = 0; axis < 3; ++axis)
    flight[axis] = {time.h, def.gravity_factor * scene.gravity[axis], as_force ? c : 0,
                    as_force || c == 0 ? 1 : decay(over * c)};
  return flight;
}

constexpr std::size_t kBlocksAPart = 4;  // some microseconds

bool within_limits(Real x2, Real v2) {
  return x2 <= kMaxPosition * kMaxPosition && v2 <= kMaxSpeed * kMaxSpeed;
}  // NaN is not

/// Hold those of a block who left the world, at its edge if they went beyond. @return the first, or the block's end
std::size_t hold_outliers(Particles& particles, std::uint32_t s, std::size_t block) {
  ParticleSet& set = particles.set[s];
  const BlockRange range(set, block);
  std::size_t first = range.end;
  Real vis_viva = 0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (set.is_held(i)) continue;
    const Vec3 x = set.position(i);
    const Real x2 = x.squared_norm(), v2 = set.velocity(i).squared_norm();
    if (within_limits(x2, v2)) {
      vis_viva += (set.mass.empty() ? 1 : set.mass[i]) * v2;
      continue;
    }
    if (!within_limits(x2, 0))
      particles.place(s, i, finite(x2) ? Vec3(kMaxPosition / std::sqrt(x2) * x) : Vec3(Vec3::zero()));
    particles.hold(s, i);
    first = std::min(first, i);
  }
  if (first < range.end) set.sums[block].vis_viva = vis_viva;
  return first;
}

/// Look for strays where there may be some (a sum bounds its terms), and report the first of the set.
void judge(Particles& particles, FaultViews& faults, std::uint32_t s) {
  ParticleSet& set = particles.set[s];
  FaultView view;
  for (std::size_t b = 0; b < set.sums.size(); ++b) {
    if (within_limits(set.sums[b].x2, set.sums[b].v2)) continue;
    const std::size_t first = hold_outliers(particles, s, b);
    if (first < BlockRange(set, b).end && view.particles == kInvalid)
      view.particles = s, view.particle = static_cast<std::uint32_t>(first);
  }
  if (view.particles != kInvalid && faults.size() < faults.capacity()) faults.push_back(view);
}

}  // namespace

void integrate_particles(const World& world, Particles& particles, FaultViews& faults, const StepTime& time) {
  if (particles.count() == 0 || world.scene.modes.forbids(+EffectId::particles)) return;
  const std::uint32_t integrator = world.scene.dials.choice(Dial::integrator);
  PlannedEffect& row = world.plan->effects[+EffectId::particles];
  for (std::uint32_t s = 0; s < particles.set.size(); ++s) {
    ParticleSet& set = particles.set[s];
    const int substeps = substeps_of(world, set.def);
    const std::array<Flight, 3> flight = plan_flight(world.scene, set.def, {time.dt, time.dt / substeps}, substeps);
    row.evaluations += (set.size() - set.held_count) * static_cast<std::uint64_t>(substeps);
    const bool alike = set.mass.empty();
    const FlyRun fly_run = (alike ? particles.kernels->alike : particles.kernels->weighed)[integrator];
    in_parallel(world.jobs, set.sums.size(), kBlocksAPart, [&](std::uint32_t b) {
      FlightSums sums;
      const BlockRange range(set, b);
      each_free_run(set, range.begin, range.end, [&](std::size_t begin, std::size_t end) {
        for (int axis = 0; axis < 3; ++axis)
          fly_run({&set.x[axis][begin], &set.v[axis][begin], alike ? nullptr : &set.mass[begin], end - begin},
                  flight[axis], substeps, sums);
      });
      set.sums[b] = sums;
    });
    judge(particles, faults, s);
  }
}

}  // namespace carom::dynamics

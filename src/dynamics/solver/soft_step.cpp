// Stage functions of the soft-step solver.
#include "dynamics/solver/soft_step.h"

#include <algorithm>
#include <atomic>
#include <numbers>

#include "dynamics/contact/depth.h"
#include "dynamics/joint/coupled_rows.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/solver/sweep_constants.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

constexpr Real kDeep = 4;         // position tolerances
constexpr Real kSoftShare = 0.3;  // of what is deeper than that, per step

/// The same rate, and as much stiffer as takes what it gives from the one to the other.   @param give, wanted  s^2
Softness stiffened(const Softness& s, Real give, Real wanted) {
  if (!(wanted < give)) return s;
  const Real ratio = s.impulse_scale / s.mass_scale * (wanted / give);
  return {s.bias_rate, 1 / (1 + ratio), ratio / (1 + ratio)};
}

void soften(const World& world, Real h) {
  const Dials& dials = world.scene.dials;
  const Real frequency = std::min(dials[Dial::contact_frequency], 0.25 / h), damping = dials[Dial::contact_damping];
  const Softness both = softness(frequency, damping, h), one = softness(2 * frequency, damping, h);
  const Real w = 2 * std::numbers::pi * frequency, give = w > 0 ? 1 / (w * w) : 0;  // s^2, of two that move
  std::atomic<Real> longest{0};
  with_lanes(*world.wide, [&](auto& lanes, const auto&) {
    in_parallel(world.jobs, lanes.pairs.size(), kLanes * kPairsAPart, [&](std::uint32_t k) {
      auto& pair = lanes.pairs[k];
      Real way = 0;
      for (int i = 0; i < kLanes; ++i) {
        const Real pull = pair.pull[i], thickness = pair.thickness[i];
        const bool both_move = pair.inv_mass_a[i] > 0 && pair.inv_mass_b[i] > 0;
        const Real own = both_move ? give : give / 4;
        const Softness s = stiffened(both_move ? both : one, own, soft_give(own, pull, thickness));
        if (way * thickness < h * h * pull) way = h * h * pull / thickness;
        set(pair.bias_rate, i, s.bias_rate);
        set(pair.mass_scale, i, s.mass_scale);
        set(pair.impulse_scale, i, s.impulse_scale);
      }
      for (Real before = longest.load(std::memory_order_relaxed); way > before;)
        if (longest.compare_exchange_weak(before, way, std::memory_order_relaxed)) break;
    });
  });
  world.wide->longest_way = static_cast<float>(longest);
}

void soft_step_begin(const World& world, Solver::Begins to, const StepTime& time) {
  WideContacts& wide = *world.wide;
  pack(world, to, wide, time.h);
  wide.displacement.resize(wide.velocity.size());
  begin_joints(world, time.h);
  soften(world, time.h);
}

void soft_step_velocities(const World& world, Solver::Solves to, const StepTime& time) {
  heed_impacts(world, *world.wide);
  begin_far_turns(world, to, *world.wide, time.h);
  solve_softly(world, to, time);
  end_far_turns(world, to, *world.wide, time.h);
}

void soft_step_positions(const World& world, Solver::Relaxes to, const StepTime& time) {
  StepReport& report = to;
  WideContacts& wide = *world.wide;
  const Real inv_h = 1 / time.h;
  const bool sparing = !world.contacts->impacts.empty();
  heed_far_turns(world, wide, time.h);
  load_shifts(world, wide);
  return_to_joints(world);
  sweep_rows(
      world, [&](const JointRun& run) { world.wide_joints->kernels->relax(run, inv_h); },
      [&](const auto& s, const auto& run) { (sparing ? s.relax_sparing : s.relax)(run, inv_h); });
  relax_couplings(world);
  store_velocities(world, to, wide, time.h);
  report.velocity_impulses += wide.rows;
}

/// What springs let sink deep is parted once a step, apart from velocities: for springs to do it they would have to be
/// as stiff as makes heaps shake. relax() has just measured.
void part_deep(const World& world, Poses& to) {
  WideContacts& wide = *world.wide;
  const Real deep = kDeep * world.scene.dials[Dial::position_tolerance];
  bool any = false;
  with_lanes(wide, [&](const auto& lanes, const auto&) {
    any = std::ranges::any_of(lanes.pairs, [&](const auto& pair) {
      bool is_deep = false;
      for (int i = 0; i < kLanes; ++i) {
        const Real left = std::min<Real>(deep, kTolerableDepth / 2 * pair.thickness[i]);
        for (std::uint32_t k = 0; k < pair.points; ++k) is_deep |= lanes.points[pair.first + k].separation[i] < -left;
      }
      return is_deep;
    });
  });
  if (!any) return;
  std::fill(wide.displacement.begin(), wide.displacement.end(), BodyVelocity{});
  sweep_bodies(world, wide.displacement.data(),
               [&](const auto& s, const auto& run) { s.part(run, kSoftShare, deep, kTolerableDepth / 2); });
  displace(world, to, wide);
}

void soft_step_end(const World& world, Poses& to, const StepTime&) {
  part_deep(world, to);
  unpack(world, *world.wide);
}

/// A sweep leaves what touches closing by about as much as gravity gives it in a substep. Where that is a way to be
/// seen, of what is thin, it takes more sweeps.
void sweep_thin(const World& world, Real h) {
  const Real inv_h = 1 / h, push_speed = world.scene.dials[Dial::push_speed];
  for (int k = 1; k < kMostSweeps && world.wide->longest_way > k * kSweptWay; ++k)
    sweep_contacts(world, [&](const auto& s, const auto& run) { s.solve_thin(run, inv_h, push_speed, k * kSweptWay); });
}

/// What sweeps over a substep begin with: velocities in lanes, and the impulses of the substep before where they give no
/// energy.   @param h  s
void start_sweeps(const World& world, Real h) {
  lead_lanes(world, *world.wide, h);
  load_velocities(world, *world.wide);
  bend_joints(world, h);
  const JointKernels* const joints = world.wide_joints->kernels;
  sweep_rows(
      world, [&](const JointRun& run) { joints->warm_start(run); },
      [](const auto& s, const auto& run) { s.warm_start(run); });
  start_couplings(world);
  refuse_start(world);
}

}  // namespace

void solve_softly(const World& world, Solver::Solves to, const StepTime& time) {
  StepReport& report = to;
  WideContacts& wide = *world.wide;
  const Real inv_h = 1 / time.h, push_speed = world.scene.dials[Dial::push_speed];
  start_sweeps(world, time.h);
  sweep_thin(world, time.h);
  const JointKernels* const joints = world.wide_joints->kernels;
  sweep_rows(
      world, [&](const JointRun& run) { joints->solve(run, inv_h); },
      [&](const auto& s, const auto& run) { s.solve(run, inv_h, push_speed); });
  solve_couplings(world);
  store_velocities(world, to, wide, time.h);
  report.velocity_impulses += wide.rows;
}

void sweep_again(const World& world, Real h) {
  const WideContacts& wide = *world.wide;
  const Real inv_h = 1 / h, push_speed = world.scene.dials[Dial::push_speed];
  sweep_contacts(world,
                 [&](const auto& s, const auto& run) { s.solve_of(run, inv_h, push_speed, wide.swept_again.data()); });
}

Real soft_give(Real give, Real pull, Real thickness) {
  return pull * give > kSoftSink * thickness ? kSoftSink * thickness / pull : give;
}

Softness softness(Real frequency, Real damping, Real h) {
  const Real w = 2 * std::numbers::pi * frequency, b = 2 * damping + h * w, a = h * w * b;
  if (!(a > 0)) return {0, 1, 0};  // no spring: the law alone
  return {w / b, a / (1 + a), 1 / (1 + a)};
}

extern constexpr Solver kSoftStep = {
    "soft_step", true, false, false, soft_step_begin, soft_step_velocities, soft_step_positions, soft_step_end};

}  // namespace carom::dynamics

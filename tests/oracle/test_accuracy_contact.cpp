// An accuracy is asked for of what slides: distances and speeds are within it, by few substeps. Soft contacts would
// settle first, and be off by friction times their sink, whatever the substeps; so what sinks by more than is borne is
// solved directly. Closed forms of friction.
#include <cstdio>
#include <span>

#include "carom_test.h"
#include "dynamics/accuracy/accuracy.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kG = 9.81;

/// A block on a plane that leans along x.
struct Slide {
  const char* what;
  Vec3 half;       // m
  Real speed;      // m/s, along x at first
  Real friction;   // of the pair
  Real lean;       // rad: 0 is level, positive goes down along x
  Real dt;         // s
  Real time;       // s
  Real tolerance;  // m/s
  int high = 1;    // blocks on each other
};

/// m, along the plane. A block that stops on a plane that holds it stays.
Real way_of(const Slide& s) {
  const Real a = kG * (std::sin(s.lean) - s.friction * std::cos(s.lean));
  if (a < 0 && s.speed / -a < s.time) return s.speed * s.speed / (2 * -a);
  return s.speed * s.time + a * s.time * s.time / 2;
}

struct Slid {
  Real way = 0;            // m
  Real substeps = 0;       // mean a step, of all runs
  std::uint32_t most = 0;  // substeps accepted
};

Slid run(const Slide& s) {
  TestWorld t(kG * Vec3(std::sin(s.lean), -std::cos(s.lean), 0));
  ask_accuracy(t, s.tolerance);
  const std::uint32_t m = t.material(s.friction, 0), grips = t.material(1.5, 0);
  t.ground(m);
  const std::uint32_t block =
      t.add(t.keep(box(s.half)), Vec3(0, s.half.y(), 0), BodyType::dynamic, Quat::identity(), m);
  t.world.set_velocity(block, Vec3(s.speed, 0, 0), Vec3::zero());
  for (int k = 1; k < s.high; ++k) {
    const Vec3 at(0, (2 * k + 1) * s.half.y(), 0);
    const std::uint32_t rider = t.add(t.keep(box(s.half)), at, BodyType::dynamic, Quat::identity(), grips);
    t.world.set_velocity(rider, Vec3(s.speed, 0, 0), Vec3::zero());
  }
  const int steps = static_cast<int>(std::lround(s.time / s.dt));
  Slid slid;
  for (int k = 0; k < steps; ++k) {
    t.world.step(s.dt);
    for (const AccuracyView& view : t.world.accuracy->views) {
      slid.substeps += static_cast<Real>(view.work) / steps;
      slid.most = std::max(slid.most, view.substeps);
    }
  }
  slid.way = t.world.state.x[block].x();
  return slid;
}

void hold(std::span<const Slide> slides) {
  for (const Slide& s : slides) {
    const Slid slid = run(s);
    const Real off = std::fabs(slid.way - way_of(s)), asked = s.tolerance * s.time;
    std::printf("  %s: asked %.1e, off by %.1e m, %.2f substeps a step, %u at most\n", s.what, asked, off,
                slid.substeps, slid.most);
    assert_true(off < 3 * asked);
    // By n substeps the step in which it stops is off by a (dt/n)^2 / 2. A trial may go up to 8 times as far, with half as
    // many to compare with, after others that took a quarter of it: 16 n in all, in one step.
    const Real stops = std::sqrt(kG * s.friction * s.dt / (2 * s.tolerance));
    assert_true(slid.substeps < 3 + 16 * stops * s.dt / s.time);
  }
}

}  // namespace

static void blocks_slide_as_far_as_they_should(void**) {
  const Slide slides[] = {
      {"a small cube", Vec3(0.05, 0.05, 0.05), 1, 0.2, 0, 1.0 / 60, 1.5, 1e-4},
      {"a crate", Vec3(0.6, 0.5, 0.7), 8, 0.7, 0, 1.0 / 60, 2, 1e-4},
      {"a plank, half the step", Vec3(1, 0.04, 0.2), 3, 0.35, 0, 1.0 / 120, 1.5, 1e-4},
      {"a slab down a slope", Vec3(0.3, 0.1, 0.3), 0.5, 0.3, 0.5, 1.0 / 60, 1, 1e-4},
      {"up a slope, and it holds", Vec3(0.2, 0.1, 0.2), 2, 0.6, -0.3, 1.0 / 60, 1.5, 1e-4},
      {"asked ten times less", Vec3(0.2, 0.15, 0.3), 4, 0.5, 0, 1.0 / 60, 1.5, 1e-5},
      {"a long step", Vec3(0.25, 0.1, 0.25), 5, 0.45, 0, 1.0 / 30, 1.5, 1e-4},
  };
  hold(slides);
}

/// Looked at once all of the above went well.
static void other_blocks_slide_as_far_as_they_should(void**) {
  const Slide slides[] = {
      {"a die, a quarter of the step", Vec3(0.01, 0.01, 0.01), 0.5, 0.25, 0, 1.0 / 240, 0.5, 1e-4},
      {"a slab, fast and rough", Vec3(1.2, 0.4, 1), 12, 0.9, 0, 1.0 / 60, 2, 1e-4},
      {"at 90 Hz, down a slope that holds", Vec3(0.15, 0.05, 0.4), 2.5, 0.55, 0.2, 1.0 / 90, 2, 1e-4},
      {"two on each other", Vec3(0.4, 0.1, 0.4), 3, 0.3, 0, 1.0 / 60, 1.5, 1e-4, 2},
      {"asked 3e-4", Vec3(0.1, 0.08, 0.12), 6, 0.4, 0, 1.0 / 50, 2, 3e-4},
  };
  hold(slides);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(blocks_slide_as_far_as_they_should),
      cmocka_unit_test(other_blocks_slide_as_far_as_they_should),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

// What each pair routine costs beside the generic path, in the poses that a scene is full of: resting, near, apart.
#include <benchmark/benchmark.h>

#include <vector>

#include "collision/narrow/narrow_phase.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

enum class Pose { resting, random };

/// A thousand poses of a pair, so that branches are not learnt by heart: resting ones touch along B's or A's y with
/// some jitter and any turn about it; random ones are what random_pose() gives.
std::vector<Frame> poses_of(const Shape& a, const Shape& b, Pose kind) {
  Random random(11);
  std::vector<Frame> poses;
  for (int i = 0; i < 1000; ++i) {
    if (kind == Pose::random) {
      poses.push_back(random_pose(a, b, random));
      continue;
    }
    const Vec3 jitter = 1e-4 * random.direction();
    Frame f(exp_map(Vec3(0, random.uniform(-3, 3), 0) + jitter).matrix(), Vec3::zero());
    const Real bottom = a.form == Form::half_space ? 0 : a.bounds.hi.y();
    f.p =
        Vec3{random.uniform(-0.3, 0.3), bottom - b.bounds.lo.y() + random.uniform(-1e-3, 0), random.uniform(-0.3, 0.3)};
    if (a.form != Form::half_space && a.form != Form::box) f.p.x() = f.p.z() = 0;
    poses.push_back(f);
  }
  return poses;
}

Shape shape_of(Form form) {
  Random random(12);
  switch (form) {
    case Form::sphere:
      return sphere(0.5);
    case Form::capsule:
      return capsule(0.3, 0.4);
    case Form::box:
      return box(Vec3(0.5, 0.4, 0.6));
    case Form::cylinder:
      return cylinder(0.4, 0.5);
    case Form::cone:
      return cone(0.4, 0.5);
    case Form::ellipsoid:
      return ellipsoid(Vec3(0.3, 0.5, 0.4));
    case Form::half_space:
      return half_space(Vec3::unit_y(), 0);
    default:
      return random_shape(form, 0.5, random);
  }
}

const char* name_of(Form form) {
  static constexpr const char* kNames[] = {"none",     "sphere", "capsule",   "box",       "polytope",
                                           "cylinder", "cone",   "ellipsoid", "half_space"};
  return kNames[static_cast<std::size_t>(form)];
}

/// One collide() and the manifold's update; a pass is one pair.
void collide_pair(benchmark::State& state, Form form_a, Form form_b, Pose kind, bool routines) {
  const Shape a = shape_of(form_a), b = shape_of(form_b);
  const std::vector<Frame> poses = poses_of(a, b, kind);
  NarrowSettings settings;
  settings.query.routines = routines;
  settings.manifold.contact_distance = 0.01;
  QueryMemory memory;
  Manifold manifold;
  Candidates found;
  NarrowReport report;
  const Frame at_a;
  std::size_t i = 0, points = 0, passes = 0;
  for (auto _ : state) {
    SupportFault fault;
    const Frame& at_b = poses[i];
    if (++i == poses.size()) i = 0;
    collide(a, at_a, b, at_b, settings, memory, nullptr, found, report, fault);
    update_cache(at_a, at_b, found, settings.manifold, manifold);
    points += static_cast<std::size_t>(manifold.count), ++passes;
    benchmark::DoNotOptimize(manifold.point[0].separation);
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(passes);
}

void enter_all() {
  for (const auto& [a, b] : kRoutinePairs)
    for (const Pose kind : {Pose::resting, Pose::random})
      for (const bool routines : {true, false}) {
        const std::string name = std::string(name_of(a)) + "/" + name_of(b) + "/" +
                                 (kind == Pose::resting ? "resting" : "random") + (routines ? "/routine" : "/generic");
        benchmark::RegisterBenchmark(name.c_str(), collide_pair, a, b, kind, routines);
      }
}

}  // namespace

int main(int argc, char** argv) {
  enter_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

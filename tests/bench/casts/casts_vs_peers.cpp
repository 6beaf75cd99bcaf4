// Rays, linear casts and times of impact of random solids: what a question costs and how far its answer is off, Carom
// beside Bullet, FCL, parry, Box3D, Jolt and PhysX in one process.
#include <dlfcn.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

#include "../convex/closed_forms.h"
#include "../module_reason.h"
#include "collision/cast/ray.h"
#include "collision/cast/shape_cast.h"
#include "collision/cast/time_of_impact.h"
#include "peer.h"
#include "random_pairs.h"

namespace carom::bench {
namespace {

using namespace carom::test;

constexpr int kSolids = 50, kCases = 1000;
constexpr std::size_t kBlock = 250;  // cases; each block counts with the least time of all passes
constexpr const char* kTasks[] = {"ray", "linear", "turning"};

RigidMotion motion_of(const Placement& from, const Placement& to) {
  RigidMotion m;
  const Frame f = frame_of(from), t = frame_of(to);
  m.at = {Quat(f.r), f.p};
  m.centre = f.p;
  m.velocity = t.p - f.p;
  const Quat turn(t.r * f.r.transpose());
  const Real sine = turn.vec().norm();  // of half the angle
  if (sine > 0) m.omega = 2 * std::atan2(std::copysign(sine, turn.w()), std::fabs(turn.w())) / sine * turn.vec();
  return m;
}

class Carom final : public CastPeer {
 public:
  /// @param routines  rays as a world casts them: by closed forms where there are some
  explicit Carom(Real tolerance, bool routines = false) {
    settings_.tolerance = tolerance;
    settings_.routines = routines;
    char text[32];
    std::snprintf(text, sizeof text, "Carom %.0e", tolerance);
    name_ = routines ? "Carom with its routines" : text;
    if (tolerance < 1e-9) settings_.cap = 1000;
  }
  const char* name() const override { return name_.c_str(); }
  const char* lacks(Task task, const Solid&) const override {
    return settings_.routines && task != Task::ray ? "it has routines for rays alone" : nullptr;
  }
  void prepare(Task task, const CastCase* cases, std::size_t count) override {
    task_ = task;
    cases_.clear();
    for (const CastCase* c = cases; c < cases + count; ++c)
      cases_.push_back({c->a ? c->a->shape : nullptr, c->b->shape, frame_of(c->from_a), frame_of(c->from_b),
                        motion_of(c->from_a, c->to_a), motion_of(c->from_b, c->to_b)});
    calls = asked = 0;
  }
  double ask(std::size_t i) override {
    const Case& c = cases_[i];
    CastResult r;
    SupportFault fault;
    if (task_ == Task::ray)
      cast_ray(Ray{c.from_a.p, c.a_moves.velocity, 1}, *c.b, c.from_b, settings_, r, fault);
    else if (task_ == Task::linear)
      cast_shape(*c.a, c.from_a, c.a_moves.velocity, *c.b, c.from_b, settings_, r, fault);
    else
      time_of_impact(*c.a, c.a_moves, *c.b, c.b_moves, 1, settings_, r, fault);
    calls += static_cast<double>(r.support_calls);
    ++asked;
    return r.outcome == CastOutcome::miss ? -1 : r.time;
  }
  double calls = 0, asked = 0;

 private:
  struct Case {
    const Shape *a, *b;
    Frame from_a, from_b;
    RigidMotion a_moves, b_moves;
  };
  std::string name_;
  CastSettings settings_;
  Task task_ = Task::ray;
  std::vector<Case> cases_;
};

/// 1,000 cases of a family: bodies of about 1 m, 3 to 5 m apart, sent at each other with an error of up to 1 m: some 2
/// in 3 meet.
std::vector<CastCase> make_cases(Task task, int family, std::deque<OwnedSolid>& solids) {
  Random random(900 + family);
  while (solids.size() < kSolids) solids.emplace_back(random_shape(random, family));
  std::vector<CastCase> cases;
  for (int i = 0; i < kCases; ++i) {
    const Solid& a = solids[static_cast<std::size_t>(i) % kSolids].solid;
    const Solid& b = solids[static_cast<std::size_t>(7 * i + 3) % kSolids].solid;
    const Quat qa = random_rotation(random), qb = random_rotation(random);
    const Vec3 from = random.uniform(3, 5) * random.direction(), to = random.in_cube(0.6);
    const Vec3 spin_a = random.in_cube(1), spin_b = random.in_cube(1);
    const bool turns = task == Task::turning;
    CastCase c;
    c.a = task == Task::ray ? nullptr : &a;
    c.b = &b;
    c.from_a = placement(Frame(Pose{qa, from}));
    c.to_a = placement(Frame(Pose{turns ? Quat(exp_map(spin_a) * qa) : qa, Vec3(1.2 * to - 0.2 * from)}));
    c.from_b = placement(Frame(Pose{qb, Vec3::zero()}));
    c.to_b = placement(Frame(Pose{turns ? Quat(exp_map(spin_b) * qb) : qb, Vec3::zero()}));
    cases.push_back(c);
  }
  return cases;
}

double cpu_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

std::vector<std::unique_ptr<CastPeer>> load(const char* path) {
  std::vector<std::unique_ptr<CastPeer>> peers;
  void* const object = dlmopen(LM_ID_NEWLM, path, RTLD_NOW | RTLD_LOCAL);
  if (!object) throw std::runtime_error(dlerror());
  const auto make = reinterpret_cast<CastPeerModule>(dlsym(object, "carom_bench_cast_peer"));
  if (!make) throw std::runtime_error(std::string(path) + " exports no carom_bench_cast_peer");
  for (int i = 0; CastPeer* const peer = make(i); ++i) peers.emplace_back(peer);
  return peers;
}

double length_of(const CastCase& c) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += (c.to_a.p[i] - c.from_a.p[i]) * (c.to_a.p[i] - c.from_a.p[i]);
  return std::sqrt(sum);
}

/// Prints the rows of one task and family.
/// @param unasked  in and out: the tasks and families that a library was not asked about, by its name and why
void compare(Task task, int family, std::vector<std::unique_ptr<CastPeer>>& all, int passes,
             std::map<std::string, std::string>& unasked) {
  std::deque<OwnedSolid> solids;
  const std::vector<CastCase> cases = make_cases(task, family, solids);
  const Solid& solid = solids.front().solid;  // all of a family are alike
  std::vector<CastPeer*> peers;
  for (auto& peer : all)
    if (const char* const lack = peer->lacks(task, solid))
      unasked[std::string(peer->name()) + ": " + lack] +=
          std::string(", ") + kTasks[static_cast<int>(task)] + " " + kFamilies[family];
    else
      peers.push_back(peer.get());
  Carom reference(1e-12);
  reference.prepare(task, cases.data(), cases.size());
  std::vector<double> truth;
  for (int i = 0; i < kCases; ++i) truth.push_back(reference.ask(static_cast<std::size_t>(i)));
  std::vector<std::array<double, kCases / kBlock>> least(peers.size());
  for (auto& blocks : least) blocks.fill(HUGE_VAL);
  for (CastPeer* const peer : peers) peer->prepare(task, cases.data(), cases.size());
  volatile double sink = 0;
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t p = 0; p < peers.size(); ++p) {
      double sum = 0;
      for (std::size_t block = 0; block < least[p].size(); ++block) {
        const double start = cpu_ns();
        for (std::size_t i = block * kBlock; i < (block + 1) * kBlock; ++i) sum += peers[p]->ask(i);
        least[p][block] = std::min(least[p][block], cpu_ns() - start);
      }
      sink = sum;
    }
  static_cast<void>(sink);
  for (std::size_t p = 0; p < peers.size(); ++p) {
    std::vector<double> errors;
    int wrong = 0;
    for (int i = 0; i < kCases; ++i) {
      const double t = peers[p]->ask(static_cast<std::size_t>(i)), s = truth[static_cast<std::size_t>(i)];
      if ((t < 0) != (s < 0))
        ++wrong;
      else if (s >= 0)
        errors.push_back(std::fabs(t - s) * length_of(cases[static_cast<std::size_t>(i)]));
    }
    std::sort(errors.begin(), errors.end());
    const auto share = [&](double q) {
      return errors[static_cast<std::size_t>(q * static_cast<double>(errors.size() - 1))];
    };
    const auto* const own = dynamic_cast<const Carom*>(peers[p]);
    std::printf("| %s | %s | %s | %.0f | %.1f | %.0e | %.0e | %d |\n", kTasks[static_cast<int>(task)],
                kFamilies[family], peers[p]->name(), std::accumulate(least[p].begin(), least[p].end(), 0.0) / kCases,
                own ? own->calls / own->asked : NAN, share(0.5), share(1), wrong);
  }
}

/// Casts that miss what lies in their way, on many of the random cases too.
bool known(const std::string& name, Kind kind) {
  if (name == "Bullet f32 GJK" || name == "Bullet f64 GJK") return true;
  return name == "FCL conservative adv." && (kind == Kind::capsule || kind == Kind::cylinder);
}

/// Holds every library to closed forms: falls of 3 m upon a stack that meet after 2 m, and falls beside it. The longest
/// slop of an engine is 5 mm.   @return  wrong answers, but those of libraries that are known to give them
int check(std::vector<std::unique_ptr<CastPeer>>& peers) {
  constexpr double kHeight = 2, kWay = 3, kSlop = 1e-2;  // m
  int wrong = 0;
  for (const Stack& stack : stacks())
    for (const Task task : {Task::ray, Task::linear, Task::turning})
      for (const Vec3& astray : {Vec3::zero(), Vec3(5, 0, 0)}) {
        const bool turns = task == Task::turning;
        CastCase c{&stack.upper.solid,
                   &stack.lower.solid,
                   stack.upper_at(kHeight, 0.3, astray),
                   stack.upper_at(kHeight - kWay, turns ? 0.9 : 0.3, astray),
                   stack.lower_at(-0.5),
                   stack.lower_at(turns ? -1.2 : -0.5)};
        if (task == Task::ray) {
          const Vec3 start = stack.above(kHeight, astray);
          c.a = nullptr;
          c.from_a = placement(Frame(Mat3::identity(), start));
          c.to_a = placement(Frame(Mat3::identity(), start + kWay * stack.down()));
        }
        const bool meets = astray.x() == 0;
        for (auto& peer : peers) {
          if (peer->lacks(task, *c.b)) continue;
          peer->prepare(task, &c, 1);
          const double time = peer->ask(0);
          if (meets ? std::fabs(time * kWay - kHeight) <= kSlop : time < 0) continue;
          const bool as_ever = known(peer->name(), c.b->kind);
          std::printf("%s: %s, two of %s, which %s: %s%s\n", peer->name(), kTasks[static_cast<int>(task)],
                      kKinds[static_cast<int>(c.b->kind)], meets ? "meet after 2 m" : "do not meet",
                      time < 0 ? "no hit" : (std::to_string(time * kWay) + " m").c_str(), as_ever ? " (known)" : "");
          wrong += !as_ever;
        }
      }
  return wrong;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
  using namespace carom::bench;
  const bool checks = argc > 1 && std::strcmp(argv[1], "--check") == 0;
  const int passes = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 20;
  const std::string only = argc > 2 ? argv[2] : "";
  std::vector<std::unique_ptr<CastPeer>> peers;
  peers.emplace_back(new Carom(1e-6, true));
  peers.emplace_back(new Carom(1e-3));
  peers.emplace_back(new Carom(1e-6));
  peers.emplace_back(new Carom(1e-9));
  std::vector<std::string> missing;
  for (const std::string path : {CAROM_CAST_PEERS}) {
    if (only == "carom") break;
    const std::string reason = reason_missing(path);
    if (!reason.empty()) {
      missing.push_back(path + ": " + reason);
      continue;
    }
    for (auto& peer : load(path.c_str())) peers.push_back(std::move(peer));
  }
  if (checks) return check(peers) ? 1 : 0;
  std::map<std::string, std::string> unasked;
  std::printf(
      "| task | family | who | ns | support calls | median error m | worst | wrong of 1000 "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const Task task : {Task::ray, Task::linear, Task::turning})
    for (const int family : {0, 1, 3, 4, 5, 7}) compare(task, family, peers, passes, unasked);
  if (!unasked.empty()) std::printf("\nNot asked:\n");
  for (const auto& [why, what] : unasked) std::printf("- %s (%s)\n", why.c_str(), what.c_str() + 2);
  for (const std::string& line : missing) std::printf("\nNot in the table: %s\n", line.c_str());
}

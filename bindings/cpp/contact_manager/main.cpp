// An arm of seven capsules among boxes, balls and cylinders: contacts at random poses and on ways between them. Checks what it finds by
// asking every pair anew, and by walking along the motion; compiled with -DWITH_FCL or -DWITH_COAL it asks these about the same pairs.
#include "contact_manager.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#if defined(WITH_FCL)
#include <fcl/fcl.h>
#endif
#if defined(WITH_COAL)
#include <coal/distance.h>
#include <coal/shape/geometric_shapes.h>
#endif

using namespace contacts;

namespace {

constexpr int kLinks = 7, kThings = 60, kPoses = 400;
constexpr double kMargin = 0.1;

struct Pair {
  int form;
  double size[3];
  Pose arm, thing;
  double separation;
  carom_shape shape;
};

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
void demand(bool holds, const char* what) {
  if (!holds) std::fprintf(stderr, "amiss: %s\n", what), std::exit(1);
}

#if defined(WITH_FCL) || defined(WITH_COAL)
/// Its pose as others have it, whose capsules and cylinders lie along z.
template <class Transform>
Transform frame_along_z(const Pose& p, bool is_round) {
  const Eigen::Quaterniond q(p.orientation[3], p.orientation[0], p.orientation[1], p.orientation[2]);
  const double turn = is_round ? -std::acos(-1.0) / 2 : 0;
  const Eigen::Matrix3d r = q.toRotationMatrix() * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Vector3d at(p.position[0], p.position[1], p.position[2]);
  if constexpr (requires { Transform(r, at); })
    return Transform(r, at);
  else
    return Eigen::Translation3d(at) * Eigen::Quaterniond(r);
}

/// @param prepare  of a pair -> a function that gives its distance, which alone is timed
template <class Prepare>
void compare(const char* name, const std::vector<Pair>& pairs, Prepare&& prepare) {
  double farthest = 0, time = 0;
  std::size_t off = 0, asked = 0;
  for (const Pair& p : pairs) {
    const auto distance = prepare(p);
    const double start = seconds(), found = distance();
    if (p.form == 0) time += seconds() - start, ++asked;
    const double error = std::fabs(found - p.separation);
    farthest = std::max(farthest, error), off += error > 1e-4;
  }
  std::printf(
      "%s: %.2f us a distance of a capsule and a box; %zu of %zu pairs differ by more than 0.1 mm, at most %.3g m\n",
      name, 1e6 * time / double(asked), off, pairs.size(), farthest);
}
#endif

}  // namespace

int main() {
  auto engine = carom::Engine::create();
  Manager manager(engine);
  std::mt19937_64 random(3);
  const auto uniform = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
  const auto turn = [&] {
    Quat q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const double n = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    for (double& x : q) x /= n;
    return q;
  };
  const carom_shape capsule = engine.shape("capsule", {0.08, 0.15});
  struct Thing {
    int form;
    double size[3];
    Pose pose;
    carom_shape shape;
  };
  std::vector<Thing> things;
  for (int i = 0; i < kLinks; ++i) manager.add("link " + std::to_string(i), {{capsule, {}}}, true);
  for (int i = 0; i < kThings; ++i) {
    Thing t{i % 3,
            {uniform(0.05, 0.3), uniform(0.05, 0.3), uniform(0.05, 0.3)},
            {{uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)}, turn()},
            0};
    t.shape = t.form == 0   ? engine.shape("box", {t.size[0], t.size[1], t.size[2]})
              : t.form == 1 ? engine.shape("sphere", {t.size[0]})
                            : engine.shape("cylinder", {t.size[0], t.size[1]});
    manager.add("thing " + std::to_string(i), {{t.shape, {}}}, false);
    manager.set_pose("thing " + std::to_string(i), t.pose);
    things.push_back(t);
  }
  manager.set_margin(kMargin);
  manager.allow(
      [](const std::string& a, const std::string& b) { return a.starts_with("link") && b.starts_with("link"); });

  std::vector<std::vector<Pose>> poses(kPoses, std::vector<Pose>(kLinks));
  for (auto& arm : poses) {
    Pose at{{0, 0, 0}, {0, 0, 0, 1}};
    for (Pose& link : arm) link = at = at * Pose{{0, 0, 0}, turn()} * Pose{{0, 0.38, 0}, {0, 0, 0, 1}};
  }
  const auto move_to = [&](const std::vector<Pose>& arm) {
    for (int i = 0; i < kLinks; ++i) manager.set_pose("link " + std::to_string(i), arm[std::size_t(i)]);
  };

  // As they stand: the manager finds what asking every pair finds.
  std::size_t count = 0, deep = 0, near = 0, moved = 0;
  std::vector<Pair> pairs;
  const double begin = seconds();
  for (const auto& arm : poses) {
    move_to(arm);
    for (const Contact& c : manager.test()) {
      demand(c.lower <= c.separation && c.separation <= c.upper && c.separation <= kMargin, "a bracket");
      ++count, deep += c.separation < 0;
    }
  }
  const double took = seconds() - begin;
  for (const auto& arm : poses)
    for (const Pose& link : arm)
      for (const Thing& t : things) {
        auto r = carom::make<carom_distance>();
        engine.call(carom_shape_distance, capsule, link.position.data(), link.orientation.data(), t.shape,
                    t.pose.position.data(), t.pose.orientation.data(), nullptr, &r);
        near += r.separation <= kMargin;
        if (r.separation <= 0.5)
          pairs.push_back({t.form, {t.size[0], t.size[1], t.size[2]}, link, t.pose, r.separation, t.shape});
      }
  demand(near == count, "as many contacts as pairs that are near");
  std::printf("%zu contacts at %d poses, %zu of them deep: %.1f us a pose of %d links and %d things\n", count, kPoses,
              deep, 1e6 * took / kPoses, kLinks, kThings);

  // On the way: nothing is nearer than the margin before the time that is said.
  const double began = seconds();
  std::vector<std::pair<int, Contact>> met;
  for (int k = 0; k + 1 < kPoses; ++k) {
    move_to(poses[std::size_t(k)]);
    std::map<std::string, Pose> to;
    for (int i = 0; i < kLinks; ++i) to["link " + std::to_string(i)] = poses[std::size_t(k) + 1][std::size_t(i)];
    for (const Contact& c : manager.test_motion(to)) met.emplace_back(k, c);
  }
  const double took_motion = seconds() - began;
  moved = met.size();
  std::printf("%zu first contacts on %d ways: %.1f us a way\n", moved, kPoses - 1, 1e6 * took_motion / (kPoses - 1));

  // The sweep of a shape as a shape, in one call: against a ball in its middle it is as deep as a capsule is.
  const carom_shape ball = engine.shape("sphere", {0.2}),
                    sweep = manager.swept(ball, {{-1, 0, 0}, {0, 0, 0, 1}}, {{1, 0, 0}, {0, 0, 0, 1}});
  auto r = carom::make<carom_distance>();
  const double zero[3] = {0, 0, 0}, beside[3] = {0.3, 0.3, 0}, upright[4] = {0, 0, 0, 1};
  engine.call(carom_shape_distance, sweep, zero, upright, ball, beside, upright, nullptr, &r);
  demand(std::fabs(r.separation + 0.1) < 1e-6, "the depth of a sweep");

  double best = 1e9;
  for (int round = 0; round < 5; ++round) {
    const double start = seconds();
    std::size_t boxes = 0;
    for (const Pair& p : pairs) {
      if (p.form != 0) continue;
      ++boxes;
      auto out = carom::make<carom_distance>();
      carom_shape_distance(engine.get(), capsule, p.arm.position.data(), p.arm.orientation.data(), p.shape,
                           p.thing.position.data(), p.thing.orientation.data(), nullptr, &out, nullptr);
    }
    best = std::min(best, (seconds() - start) / double(boxes));
  }
  std::printf("Carom: %.2f us a distance of a capsule and a box, bracket included\n", 1e6 * best);
#if defined(WITH_FCL)
  const auto fcl_arm = std::make_shared<fcl::Capsuled>(0.08, 0.3);
  compare("FCL", pairs, [&](const Pair& p) {
    std::shared_ptr<fcl::CollisionGeometryd> shape;
    if (p.form == 0) shape = std::make_shared<fcl::Boxd>(2 * p.size[0], 2 * p.size[1], 2 * p.size[2]);
    if (p.form == 1) shape = std::make_shared<fcl::Sphered>(p.size[0]);
    if (p.form == 2) shape = std::make_shared<fcl::Cylinderd>(p.size[0], 2 * p.size[1]);
    const fcl::CollisionObjectd one(fcl_arm, frame_along_z<fcl::Transform3d>(p.arm, true)),
        other(shape, frame_along_z<fcl::Transform3d>(p.thing, p.form == 2));
    return [=] {
      fcl::DistanceRequestd request;
      request.enable_signed_distance = true, request.gjk_solver_type = fcl::GST_LIBCCD;
      request.distance_tolerance = 1e-6;
      fcl::DistanceResultd result;
      fcl::distance(&one, &other, request, result);
      return result.min_distance;
    };
  });
#endif
#if defined(WITH_COAL)
  const coal::Capsule coal_arm(0.08, 0.3);
  compare("Coal", pairs, [&](const Pair& p) {
    std::shared_ptr<coal::CollisionGeometry> shape;
    if (p.form == 0) shape = std::make_shared<coal::Box>(2 * p.size[0], 2 * p.size[1], 2 * p.size[2]);
    if (p.form == 1) shape = std::make_shared<coal::Sphere>(p.size[0]);
    if (p.form == 2) shape = std::make_shared<coal::Cylinder>(p.size[0], 2 * p.size[1]);
    const auto one = frame_along_z<coal::Transform3s>(p.arm, true),
               other = frame_along_z<coal::Transform3s>(p.thing, p.form == 2);
    return [=, &coal_arm] {
      coal::DistanceRequest request;
      request.gjk_tolerance = request.epa_tolerance = 1e-6;
      coal::DistanceResult result;
      return coal::distance(&coal_arm, one, shape.get(), other, request, result);
    };
  });
#endif
}

// What has limbs: rag dolls that fall down stairs, walkers and arms on drives.
#include <algorithm>
#include <cmath>

#include "jury/built/builder.h"
#include "jury/gaps.h"

namespace carom::tools::jury {
namespace {

/// A person of eleven capsules, from the middle of its pelvis; 1.8 m at scale 1.
void add_doll(Builder& b, double s, const Stuff& flesh) {
  const auto at = [&](double x, double y) { return Vec(x * s, y * s, 0); };
  const auto rod = [&](const char* kind, double radius, const Vec& from, const Vec& to) {
    return b.rod(kind, radius * s, from, to, flesh);
  };
  const double knee = b.between(1.6, 2.4), elbow = b.between(1.6, 2.4), hip = b.between(0.6, 1.2);
  const double shoulder = b.between(0.9, 1.5);
  const std::size_t pelvis = rod("pelvis", 0.09, at(-0.08, 0), at(0.08, 0));
  const std::size_t chest = rod("chest", 0.11, at(-0.07, 0.36), at(0.07, 0.36));
  const std::size_t head = rod("head", 0.09, at(0, 0.68), at(0, 0.74));
  const std::size_t spine = b.socket(pelvis, chest, at(0, 0.17), Vec::UnitY());
  b.limit_swing(spine, 0.5), b.limit(spine, -0.5, 0.5);
  const std::size_t neck = b.socket(chest, head, at(0, 0.53), Vec::UnitY());
  b.limit_swing(neck, 0.6), b.limit(neck, -0.8, 0.8);
  for (const double side : {-1.0, 1.0}) {
    const std::size_t thigh = rod("thigh", 0.07, at(0.13 * side, -0.18), at(0.13 * side, -0.43));
    const std::size_t shank = rod("shank", 0.055, at(0.13 * side, -0.58), at(0.13 * side, -0.9));
    b.limit_swing(b.socket(pelvis, thigh, at(0.13 * side, -0.1), -Vec::UnitY()), hip);
    b.limit(b.hinge(thigh, shank, at(0.13 * side, -0.51), Vec::UnitX()), 0, knee);
    const std::size_t upper = rod("arm", 0.05, at(0.26 * side, 0.4), at(0.45 * side, 0.4));
    const std::size_t lower = rod("forearm", 0.04, at(0.57 * side, 0.4), at(0.8 * side, 0.4));
    b.limit_swing(b.socket(chest, upper, at(0.2 * side, 0.4), Vec(side, 0, 0)), shoulder);
    b.limit(b.hinge(upper, lower, at(0.51 * side, 0.4), Vec(0, side, 0)), -elbow, 0);
  }
}

}  // namespace

void draw_doll(Builder& b) {
  b.scene.seconds = 6;
  b.ground(b.between(0.4, 0.9));
  const int steps = b.count(3, 10), dolls = b.count(1, 4);
  const double rise = b.between(0.12, 0.25), tread = b.between(0.25, 0.45), rub = b.between(0.3, 0.8);
  for (int i = 0; i < steps; ++i) {
    const double top = rise * (steps - i);
    b.fixed("step", Vec(tread / 2, top / 2, 2), Vec(tread * i, top / 2, 0), {1000, rub, 0});
  }
  const double s = b.between(0.6, 1.1);
  const Stuff flesh{b.scale(500, 2000), rub, 0};
  for (int i = 0; i < dolls; ++i) {
    const double x = b.between(0, 0.6) * tread * steps, z = b.between(-0.5, 0.5), go = b.between(0, 3);
    const Quat turned = b.random.rotation();
    b.stand(Vec(x, rise * steps + 1.2 * s + 2.1 * s * i, z), turned, Vec(go, 0, 0));
    add_doll(b, s, flesh);
  }
  b.stand(Vec::Zero());
  b.scene.summary = std::to_string(dolls) + " rag dolls down " + std::to_string(steps) + " stairs";
}

namespace {

void draw_legs(Builder& b) {
  const int pairs = b.count(2, 3);
  const double s = b.between(0.6, 1.4), length = 0.25 * s * (pairs - 1);
  const Stuff metal{b.scale(600, 3000), b.between(0.6, 1), 0};
  const double thigh = 0.12 * s, shank = 0.12 * s, foot = 0.04 * s, spread = 0.2 * s;
  const double level = foot + 2 * shank + 2 * thigh + 4 * foot;
  const std::size_t trunk = b.box("trunk", Vec(length + 0.08 * s, 0.05 * s, 0.1 * s), Vec(0, level, 0), metal);
  const double weight = 2.5 * 9.81 * b.mass(trunk);
  const double stiff = b.between(2, 6), damping = b.between(0.5, 1.5), sway = b.between(0.03, 0.12);
  const double beat = b.between(0.2, 0.5);
  for (int i = 0; i < pairs; ++i)
    for (const double side : {-1.0, 1.0}) {
      const double x = (pairs > 1 ? 2.0 * i / (pairs - 1) - 1 : 0) * length, z = side * spread;
      const Vec hip(x, level, z), knee(x, foot + 2 * shank + 2 * foot, z), toe(x, foot, z);
      const std::size_t hub = b.ball("hip", 2 * foot, hip - Vec(0, 0, side * 3 * foot), metal);
      const std::size_t upper = b.rod("thigh", foot, hip - Vec(0, 2 * foot, 0), knee + Vec(0, 1.5 * foot, 0), metal);
      const std::size_t lower = b.rod("shank", foot, knee - Vec(0, 1.5 * foot, 0), toe, metal);
      const std::size_t joints[] = {b.hinge(trunk, hub, Vec(x, level, side * 0.1 * s), Vec::UnitX()),
                                    b.hinge(hub, upper, hip), b.hinge(upper, lower, knee)};
      for (const std::size_t joint : joints) {
        b.limit(joint, -1.2, 1.2);
        b.aim(joint, 0, stiff * weight * level, damping, weight * level);
      }
      for (double t = 1; t < b.scene.seconds - 2.2; t += beat)    // then it stands still
        for (const std::size_t joint : {joints[1], joints[2]}) {  // it does not straddle
          const double to = b.between(-sway, sway);
          b.deed(t, Deed::What::drive, joint, to);
        }
    }
  Goal goal{"the walker stands", 0, b.scene.seconds, false, {}, 0.15 * level, "m"};
  goal.missed_by = [trunk, level](const Frame&, const Frame& now) { return 0.6 * level - now[trunk].position.y(); };
  b.ask(goal);
  b.scene.summary = "walker on " + std::to_string(2 * pairs) + " driven legs";
}

/// An arm of hinges upright on a foot, each led from place to place, with a weight at its end.
void draw_arm(Builder& b) {
  const int parts = b.count(3, 5);
  const double s = b.between(0.5, 1.2), half = 0.15 * s, thin = 0.03 * s;
  const Stuff metal{b.scale(800, 4000), 0.5, 0};
  std::size_t before = b.fixed("foot", Vec(0.15 * s, 0.1, 0.15 * s), Vec(0, 0.1, 0));
  std::vector<std::size_t> joints;
  double y = 0.2 + 2 * thin;
  for (int i = 0; i < parts; ++i) {
    const double thick = (1 + 0.4 * (parts - 1 - i)) * thin;  // the lower, the more it bears
    const std::size_t part = b.rod("arm", thick, Vec(0, y + thick, 0), Vec(0, y + 2 * half, 0), metal);
    joints.push_back(b.hinge(before, part, Vec(0, y, 0), i % 2 ? Vec::UnitX() : Vec::UnitZ()));
    before = part;
    y += 2 * (half + thick);
  }
  const double heavy = b.between(1, 3) * thin, end = y + heavy;
  const std::size_t weight = b.ball("weight", heavy, Vec(0, end, 0), {b.scale(500, 8000), 0.5, 0});
  b.join(CAROM_JOINT_WELD, before, weight, Vec(0, end - heavy, 0));
  double torque = 0;
  for (const std::size_t part : b.since(0)) torque += 9.81 * b.mass(part) * b.actor(part).position.y();
  const double stiff = b.between(5, 20), most = b.between(0.2, 0.8);
  std::vector<double> goals;
  for (const std::size_t joint : joints) {
    b.limit(joint, -1.5, 1.5);
    b.aim(joint, 0, stiff * torque, 1, 3 * torque);
    const double first = b.between(-most, most), last = b.between(-most, most);
    b.lead(joint, 0, first, 0.5, 2), b.lead(joint, first, last, 2.5, 4);
    goals.push_back(last);
  }
  Goal goal{"the arm is where it was led", b.scene.seconds - 0.1, b.scene.seconds, false, {}, 0.3, "rad"};
  goal.missed_by = [links = std::vector<Link>(b.scene.links), joints, goals](const Frame&, const Frame& now) {
    double most_off = 0;
    for (std::size_t i = 0; i < joints.size(); ++i)
      most_off = std::max(most_off, std::fabs(coordinate_of(links[joints[i]], now) - goals[i]));
    return most_off - 0.3;
  };
  b.ask(goal);
  b.scene.summary = "arm of " + std::to_string(parts) + " driven hinges, a weight";
}

}  // namespace

void draw_walker(Builder& b) {
  b.scene.seconds = 5;
  b.ground(b.between(0.6, 1));
  if (b.chance(0.6))
    draw_legs(b);
  else
    draw_arm(b);
}

}  // namespace carom::tools::jury

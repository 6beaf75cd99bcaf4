// What people handle: grippers that lift, doors and drawers on motors with stops.
#include <algorithm>
#include <cmath>

#include "jury/built/builder.h"

namespace carom::tools::jury {

void draw_gripper(Builder& b) {
  b.scene.seconds = 6;
  b.ground(0.6);
  const double s = b.between(0.5, 1.5), rub = b.between(0.5, 1), table = 0.5, half = 0.06 * s;
  const Stuff thing{b.scale(100, 5000), rub, 0}, metal{b.scale(500, 4000), rub, 0};
  b.fixed("table", Vec(0.4 * s, table / 2, 0.4 * s), Vec(0, table / 2, 0));
  const int shape = b.count(0, 2);
  const double tall = b.between(0.6, 1.5) * half;
  const Vec at(0, table + (shape == 1 ? half : tall), 0);
  const std::size_t held = shape == 0   ? b.box("thing", Vec(half, tall, half), at, thing)
                           : shape == 1 ? b.ball("thing", half, at, thing)
                                        : b.wheel("thing", half, tall, at, thing, Vec::UnitY());
  const double thick = 0.02 * s, reach = 0.12 * s, away = b.between(0.005, 0.04) * s;
  const double deck = table + 2 * reach + 0.03 * s + 0.3 * half;
  const std::size_t palm = b.box("palm", Vec(0.2 * s, 0.03 * s, 0.08 * s), Vec(0, deck, 0), metal);
  const std::size_t mast = b.fixed("mast", Vec::Constant(0.03), Vec(0, deck + 0.6 * s + 0.3, 0));
  double weight = 9.81 * b.mass(palm);
  const int fingers = b.chance(0.3) ? 4 : 2;
  // Friction bears it two and a half times over; led up, it weighs half as much again at most.
  const double grip = b.between(2.5, 5) * 9.81 * b.mass(held) / rub / fingers;
  for (int i = 0; i < fingers; ++i) {
    const Vec out = i < 2 ? Vec((i ? 1 : -1), 0, 0) : Vec(0, 0, (i > 2 ? 1 : -1));
    const double off = half + away + thick;
    const Vec middle = off * out + Vec(0, deck - 0.03 * s - reach - 0.002, 0);
    const Vec wide = i < 2 ? Vec(thick, reach, 0.7 * half) : Vec(0.7 * half, reach, thick);
    const std::size_t finger = b.box("finger", wide, middle, metal);
    const std::size_t rail = b.slider(palm, finger, middle + Vec(0, reach, 0), -out);
    b.limit(rail, -0.01, off);
    b.run(rail, b.between(0.05, 0.3), grip);
    weight += 9.81 * b.mass(finger);
  }
  weight += 9.81 * b.mass(held);
  const double lift = b.between(0.2, 0.5) * s;
  const std::size_t column = b.slider(mast, palm, Vec(0, deck, 0), Vec::UnitY());
  b.aim(column, 0, weight / 0.003, 1, 4 * weight + 4 * grip);
  const double quick = b.between(1, 2);
  b.lead(column, 0, lift, 1.5, 1.5 + quick);
  Goal goal{"the gripper holds what it lifted", b.scene.seconds - 1, b.scene.seconds, false, {}, 0.5 * lift, "m"};
  goal.missed_by = [held, lift](const Frame& start, const Frame& now) {
    return 0.8 * lift - (now[held].position.y() - start[held].position.y());
  };
  b.ask(goal);
  b.scene.summary = "gripper of " + std::to_string(fingers) + " fingers, " +
                    (shape == 0   ? "a box"
                     : shape == 1 ? "a ball"
                                  : "a tin");
}

namespace {

/// A door in a frame, with something that stands in its way.
void draw_swing_door(Builder& b) {
  const double wide = b.between(0.3, 0.6), high = b.between(0.6, 1.1), thick = b.between(0.01, 0.04);
  const double clear = b.between(0.002, 0.01), rub = b.between(0.3, 0.9);
  const Stuff wood{b.scale(200, 2000), rub, 0};
  const double post = 0.05;
  const std::size_t jamb = b.fixed("jamb", Vec(post, high + clear, post), Vec(-post - clear, high + clear, 0));
  b.fixed("jamb", Vec(post, high + clear, post), Vec(2 * wide + clear + post, high + clear, 0));
  const Vec middle(wide, high + clear, 0);
  const std::size_t door = b.box("door", Vec(wide, high, thick), middle, wood);
  const int hinges = b.count(1, 2);
  const double open = b.between(0.8, 1.5), speed = b.between(0.5, 2);
  std::size_t driven = 0;
  for (int i = 0; i < hinges; ++i) {
    const double y = high + clear + (hinges > 1 ? (i ? 0.7 : -0.7) * high : 0);
    driven = b.hinge(jamb, door, Vec(0, y, 0), Vec::UnitY());
    b.limit(driven, -open, 0);
  }
  // A crate that leans on it or stands in its way, and is pushed aside.
  double weight = 0;
  const int crates = b.count(0, 3);
  for (int i = 0; i < crates; ++i) {
    const double half = b.between(0.06, 0.15), x = b.between(0.4, 0.8) * 2 * wide;
    const double off = thick + half + (i ? 0.32 * i : 0.003);
    const std::size_t crate = b.box("crate", Vec(half, half, half), Vec(x, half, off), {b.scale(100, 1500), rub, 0});
    weight += 9.81 * b.mass(crate);
  }
  const double torque = b.between(1.5, 4) * (2 * weight * 2 * wide + 2 * b.mass(door) * wide);
  b.run(driven, -speed, torque);
  Goal goal{"the door opens", b.scene.seconds - 0.5, b.scene.seconds, false, {}, 0.4 * open, "rad"};
  goal.missed_by = [door, open](const Frame&, const Frame& now) {
    const Vec along = now[door].orientation * Vec::UnitX();
    return 0.9 * open - std::fabs(std::atan2(along.z(), along.x()));
  };
  b.ask(goal);
  b.scene.summary = "door on " + std::to_string(hinges) + " hinges, " + std::to_string(crates) + " crates";
}

/// Drawers in a chest, each with things in it: opened, shut, opened.
void draw_drawers(Builder& b) {
  const int drawers = b.count(1, 4);
  const double wide = b.between(0.15, 0.3), high = b.between(0.06, 0.12), deep = b.between(0.2, 0.4);
  const double wall = 0.012, rub = b.between(0.3, 0.8), way = deep;
  const Stuff wood{b.scale(300, 1500), rub, 0};
  for (int i = 0; i < drawers; ++i) {
    const double floor = 0.1 + i * (2 * high + 0.06);
    const std::size_t shelf = b.fixed("shelf", Vec(deep, 0.01, wide), Vec(0, floor, 0), {1000, rub, 0});
    const double bottom = floor + 0.01 + 0.003 + wall;
    const std::size_t base = b.box("drawer", Vec(deep, wall, wide), Vec(0, bottom, 0), wood);
    const auto side = [&](const Vec& half, const Vec& at) {
      b.join(CAROM_JOINT_WELD, base, b.box("side", half, at, wood), at);
    };
    const double middle = bottom + wall + high * 0.6;
    for (const double z : {-1.0, 1.0}) side(Vec(deep - 2 * wall, high * 0.6, wall), Vec(0, middle, z * (wide - wall)));
    for (const double x : {-1.0, 1.0}) side(Vec(wall, high * 0.6, wide), Vec(x * (deep - wall), middle, 0));
    double weight = 5 * 9.81 * b.mass(base);
    const int things = b.count(0, 4);
    for (int k = 0; k < things; ++k) {
      const double half = b.between(0.2, 0.35) * high;
      const Vec at((k - 1.5) * 0.4 * deep, bottom + wall + half + 0.002, (k % 2 ? 0.3 : -0.3) * wide);
      weight += 9.81 * b.mass(b.box("thing", Vec(half, half, half), at, {b.scale(100, 4000), rub, 0}));
    }
    const std::size_t rail = b.slider(shelf, base, Vec(0, bottom, 0), Vec::UnitX());
    b.limit(rail, 0, way);
    const double speed = b.between(0.3, 1);
    b.run(rail, speed, b.between(1.5, 5) * weight);
    b.deed(2, Deed::What::drive, rail, -speed), b.deed(3.5, Deed::What::drive, rail, speed);
    Goal goal{"the drawer opens again", b.scene.seconds - 0.05, b.scene.seconds, false, {}, 0.4 * way, "m"};
    const double due = std::min(way, speed * 1.4);
    goal.missed_by = [base, due](const Frame& start, const Frame& now) {
      return 0.8 * due - (now[base].position.x() - start[base].position.x());
    };
    b.ask(goal);
  }
  b.scene.summary = "chest of " + std::to_string(drawers) + " drawers";
}

}  // namespace

void draw_door(Builder& b) {
  b.scene.seconds = 5;
  b.ground(b.between(0.3, 0.9));
  if (b.chance(0.5))
    draw_swing_door(b);
  else
    draw_drawers(b);
}

}  // namespace carom::tools::jury

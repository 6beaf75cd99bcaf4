// What is closed on itself: four-bars, scissor lifts, rings; and conveyors, of rollers or belts.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "jury/built/builder.h"

namespace carom::tools::jury {
namespace {

/// The pin of a coupler and a rocker: so far from one place and so far from another, the upper of the two.
Vec meet(const Vec& a, double from_a, const Vec& c, double from_c) {
  const Vec way = c - a;
  const double far = way.norm(), along = (far * far + from_a * from_a - from_c * from_c) / (2 * far);
  const double up = std::sqrt(std::max(0.0, from_a * from_a - along * along));
  return a + along / far * way + up / far * Vec(-way.y(), way.x(), 0);
}

/// A bar in a layer of its own, from pin to pin.
std::size_t add_bar(Builder& b, const char* kind, const Vec& from, const Vec& to, double layer, double thick,
                    const Stuff& steel) {
  const Vec way = to - from, aside(0, 0, layer);
  return b.box(kind, Vec(way.norm() / 2 + 0.8 * thick, 0.8 * thick, 0.4 * thick), (from + to) / 2 + aside, steel,
               turn_between(Vec::UnitX(), way));
}

/// A crank that turns, a coupler, a rocker; or several cranks in step, which is one more loop than is needed.
std::string draw_four_bar(Builder& b) {
  const double s = b.between(0.3, 1.5), thick = 0.04 * s, level = 2 * s;
  const bool in_step = b.chance(0.4);
  const Stuff steel{b.scale(500, 8000), 0.4, 0};
  const double crank = b.between(0.2, 0.4) * s, speed = b.between(2, 8);
  const int cranks = in_step ? b.count(2, 4) : 1;
  const double base = in_step ? b.between(0.8, 1.2) * s : s;
  std::vector<Vec> pins, pivots;
  for (int i = 0; i < cranks; ++i) {
    pivots.emplace_back(base * i, level, 0);
    pins.emplace_back(pivots.back() + Vec(0.6 * crank, 0.8 * crank, 0));
  }
  std::vector<std::size_t> arms;
  std::size_t driven = 0;
  double weight = 0;
  for (int i = 0; i < cranks; ++i) {
    const std::size_t post = b.fixed("pivot", Vec::Constant(0.5 * thick), pivots[i] - Vec(0, 0, 1.5 * thick));
    arms.push_back(add_bar(b, "crank", pivots[i], pins[i], 0, thick, steel));
    const std::size_t axle = b.hinge(post, arms.back(), pivots[i]);
    if (i == 0) driven = axle;
    weight += 9.81 * b.mass(arms.back());
  }
  if (in_step) {
    const std::size_t coupler = add_bar(b, "coupler", pins.front(), pins.back(), thick, thick, steel);
    for (int i = 0; i < cranks; ++i) b.hinge(arms[i], coupler, pins[i]);
    weight += 9.81 * b.mass(coupler);
  } else {
    // By Grashof's rule the crank turns: shortest and longest are less than the other two.
    const double rocker = b.between(0.7, 0.9) * s, bar = b.between(0.9, 1.1) * s;
    const Vec pivot = pivots[0] + Vec(base, 0, 0), pin = meet(pins[0], bar, pivot, rocker);
    const std::size_t coupler = add_bar(b, "coupler", pins[0], pin, thick, thick, steel);
    const std::size_t arm = add_bar(b, "rocker", pin, pivot, 2 * thick, thick, steel);
    const std::size_t post = b.fixed("pivot", Vec::Constant(0.5 * thick), pivot + Vec(0, 0, 3.5 * thick));
    b.hinge(arms[0], coupler, pins[0]), b.hinge(coupler, arm, pin), b.hinge(arm, post, pivot);
    weight += 9.81 * (b.mass(coupler) + b.mass(arm));
  }
  b.run(driven, speed, 4 * weight * crank + 0.2 * weight * speed * speed * crank * crank);
  for (const double half : {-1.0, 1.0}) {
    Goal goal{half > 0 ? "the crank comes up" : "the crank goes down",
              half > 0 ? 2.5 : 0.0,
              half > 0 ? 5.0 : 2.5,
              true,
              {},
              0.5,
              ""};
    if (2.5 * speed < 2 * 3.2) goal.from = 0, goal.until = 5;
    goal.missed_by = [arm = arms[0], half, level, crank](const Frame&, const Frame& now) {
      return 0.8 - half * (now[arm].position.y() - level) / (crank / 2);
    };
    b.ask(goal);
  }
  return in_step ? std::to_string(cranks) + " cranks in step" : "four-bar";
}

/// Crossed bars, floor on floor, drawn together at the foot by a slide.
std::string draw_scissors(Builder& b) {
  const int floors = b.count(1, 4);
  const double s = b.between(0.4, 1), thick = 0.04 * s, low = 0.35, high = 0.75;  // sines of how steep the bars are
  const double cos_low = std::sqrt(1 - low * low), cos_high = std::sqrt(1 - high * high), foot = 0.3;
  const Stuff steel{b.scale(500, 4000), 0.5, 0}, load{b.scale(100, 3000), 0.7, 0};
  const double wide = s * cos_low, rise = s * low;
  const auto at = [&](int side, int floor) { return Vec((side ? 1 : -1) * wide / 2, foot + rise * floor, 0); };
  const std::size_t rail = b.fixed("rail", Vec(0.8 * s, 0.05, 0.1), Vec(0, foot - 0.2, 0));
  const double half = 0.8 * thick;
  // As heavy as what it moves: a drive as stiff as is needed would be too quick for a light one.
  const std::size_t slide =
      b.box("slide", Vec(3 * half, half, 3 * half), at(1, 0) + Vec(0, 0, -4 * thick), {20000, 0.5, 0});
  std::size_t left = rail, right = slide;  // what the feet of this floor hang on
  for (int i = 0; i < floors; ++i) {
    const std::size_t up = add_bar(b, "bar", at(0, i), at(1, i + 1), i % 2 ? 0.5 * thick : 0, thick, steel);
    const std::size_t down = add_bar(b, "bar", at(1, i), at(0, i + 1), i % 2 ? 1.5 * thick : thick, thick, steel);
    b.hinge(left, up, at(0, i)), b.hinge(right, down, at(1, i));
    b.hinge(up, down, (at(0, i) + at(1, i + 1)) / 2);
    left = down, right = up;
  }
  const double top = foot + rise * floors;
  const std::size_t deck = b.box("deck", Vec(0.7 * s, 0.5 * thick, 0.2 * s), Vec(0, top + 2 * thick, 0), steel);
  const std::size_t runner = b.box("slide", Vec(half, half, half), at(1, floors) + Vec(0, 0, -2 * thick), steel);
  b.hinge(deck, left, at(0, floors)), b.hinge(runner, right, at(1, floors));
  b.limit(b.slider(deck, runner, at(1, floors), Vec::UnitX()), -wide, 0.1 * s);
  const double crate = b.between(0.1, 0.2) * s;
  const std::size_t box = b.box("load", Vec::Constant(crate), Vec(0, top + 2.5 * thick + crate, 0), load);
  double weight = 0;
  for (const std::size_t i : b.since(0)) weight += 9.81 * b.mass(i);
  const std::size_t drive = b.slider(rail, slide, at(1, 0), Vec::UnitX());
  const double pull = 2 * weight * floors * cos_low / low, way = s * (cos_low - cos_high);
  b.limit(drive, -1.2 * way, 0.05 * s);
  b.aim(drive, 0, 2 * pull / (0.05 * s), 1, 2 * pull);
  b.lead(drive, 0, -way, 0.7, 0.7 + b.between(1, 2.5));
  const double lift = s * (high - low) * floors;
  Goal goal{"the lift is up", 4.5, 5, false, {}, 0.3 * lift, "m"};
  goal.missed_by = [deck, lift](const Frame& start, const Frame& now) {
    return 0.75 * lift - (now[deck].position.y() - start[deck].position.y());
  };
  b.ask(goal);
  Goal on{"the load is on the lift", 4.5, 5, false, {}, 0.1 * lift, "m"};
  on.missed_by = [box, deck](const Frame&, const Frame& now) { return now[deck].position.y() - now[box].position.y(); };
  b.ask(on);
  return "scissor lift of " + std::to_string(floors) + " floors";
}

/// Bars in a ring that hangs by one and swings.
std::string draw_ring(Builder& b) {
  const int bars = b.count(3, 12), more = b.count(0, 2);
  const double radius = b.between(0.3, 0.8), thick = b.between(0.02, 0.04);
  const Stuff steel{b.scale(500, 8000), 0.4, 0};
  const bool balls = b.chance(0.4);
  const auto pin = [&](int i) {
    const Turned t = turned_by(2 * std::numbers::pi * ((i % bars) + 0.5) / bars - std::numbers::pi);
    return Vec(radius * t.cos, 2 + radius * t.sin, 0);
  };
  std::vector<std::size_t> ring;
  for (int i = 0; i < bars; ++i) {
    const Vec from = pin(i), to = pin(i + 1), way = (to - from).normalized();
    ring.push_back(b.rod("bar", thick, from + 1.2 * thick * way, to - 1.2 * thick * way, steel));
  }
  for (int i = 0; i < bars; ++i) {
    const std::size_t from = ring[static_cast<std::size_t>(i)], to = ring[static_cast<std::size_t>((i + 1) % bars)];
    if (balls)
      b.socket(from, to, pin(i + 1));
    else
      b.hinge(from, to, pin(i + 1));
  }
  const std::size_t post = b.fixed("post", Vec::Constant(0.03), pin(0) + Vec(0, 0, 0.1));
  if (balls)
    b.socket(post, ring[0], pin(0));
  else
    b.hinge(post, ring[0], pin(0));
  for (int i = 0; i < more; ++i) {  // weights on it
    const int at = b.count(0, bars - 1);
    const double r = b.between(0.05, 0.12);
    const Vec where = b.actor(ring[static_cast<std::size_t>(at)]).position - Vec(0, 0, r + 2 * thick);
    const std::size_t weight = b.ball("weight", r, where, {b.scale(500, 8000), 0.4, 0});
    b.join(CAROM_JOINT_WELD, ring[static_cast<std::size_t>(at)], weight, where);
  }
  return "ring of " + std::to_string(bars) + " bars";
}

}  // namespace

void draw_linkage(Builder& b) {
  b.scene.seconds = 5;
  b.ground(0.6);
  const int kind = b.count(0, 2);
  b.scene.summary = kind == 0 ? draw_four_bar(b) : kind == 1 ? draw_scissors(b) : draw_ring(b);
}

void draw_conveyor(Builder& b) {
  b.scene.seconds = 6;
  b.ground(0.6);
  const bool rollers = b.chance(0.6);
  const double level = b.between(0.5, 1), wide = b.between(0.25, 0.5), speed = b.between(0.3, 1.5);
  const double radius = b.between(0.03, 0.08), rub = b.between(0.5, 1);
  const int count = b.count(8, 20);
  const double pitch = 2 * radius + b.between(0.005, 0.02), length = rollers ? pitch * count : b.between(1.5, 4);
  if (rollers) {
    const std::size_t frame =
        b.fixed("frame", Vec(length / 2, 0.02, 0.02), Vec(length / 2, level - 2 * radius, wide + 0.1));
    const Stuff steel{b.scale(500, 8000), rub, 0};
    for (int i = 0; i < count; ++i) {
      const Vec at(pitch * (i + 0.5), level - radius, 0);
      const std::size_t roller = b.wheel("roller", radius, wide, at, steel);
      const std::size_t axle = b.hinge(frame, roller, at);
      b.run(axle, -speed / radius, 20 * b.mass(roller) * radius + 40 * radius);
    }
  } else {
    const double tilt = b.between(-0.1, 0.25);
    b.belt(Vec(length / 2, 0.05, wide), Vec(length / 2, level - 0.05, 0), Vec(speed, 0, 0), rub,
           about(Vec::UnitZ(), tilt));
  }
  const double rise = rollers ? 0 : 0.3 * length;
  const int crates = b.count(1, 6);
  std::vector<std::size_t> goods;
  for (int i = 0; i < crates; ++i) {
    const double half = b.between(1.4, 2.5) * 0.08, z = b.between(-0.2, 0.2) * wide;
    const Vec at(0.3 + 0.4 * i, level + rise + half + 0.01 + 0.1 * (i % 2), z);
    const Vec sides(half, b.between(0.5, 1) * half, half);
    goods.push_back(b.box("crate", sides, at, {b.scale(50, 1000), rub, 0}));
  }
  const double way = 0.4 * std::min(speed * 4, length - 0.3 - 0.4 * crates);
  Goal goal{"the crate is carried along", 0, 6, true, {}, std::max(0.05, 0.5 * way), "m"};
  goal.missed_by = [crate = goods.back(), way](const Frame& start, const Frame& now) {
    return way - (now[crate].position.x() - start[crate].position.x());
  };
  b.ask(goal);
  b.scene.summary =
      std::string(rollers ? std::to_string(count) + " rollers" : "belt") + ", " + std::to_string(crates) + " crates";
}

}  // namespace carom::tools::jury

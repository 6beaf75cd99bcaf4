// What spans a gap: bridges of planks under loads, nets that catch.
#include <algorithm>
#include <cmath>

#include "jury/built/builder.h"

namespace carom::tools::jury {
namespace {

/// Crates and balls that fall on a bridge.
void drop_loads(Builder& b, int loads, double half_span, double half_width, double level, double density) {
  for (int i = 0; i < loads; ++i) {
    const double half = b.between(0.3, 0.7) * half_width, x = b.between(-0.7, 0.7) * half_span;
    const double z = b.between(-0.3, 0.3) * half_width;
    const Vec at(x, level + 0.3 + half + 0.12 * half_width + 1.5 * half_width * i, z);
    if (b.chance(0.3))
      b.ball("load", half, at, {density, 0.6, 0});
    else
      b.box("load", Vec(half, half, half), at, {density, 0.6, 0});
  }
}

}  // namespace

void draw_bridge(Builder& b) {
  b.scene.seconds = 5;
  b.ground(0.6);
  const int planks = b.count(5, 14);
  const double pitch = b.between(0.25, 0.6), half_width = b.between(0.25, 0.6), level = b.between(1.5, 2.5);
  const double span = planks * pitch, sag = b.chance(0.4) ? 0 : b.between(0.02, 0.25) * span;
  const double thick = b.between(0.01, 0.05), load = b.scale(200, 4000);
  const bool ropes = b.chance(0.4);
  const Stuff wood{b.scale(300, 1200), b.between(0.4, 0.9), 0};
  const auto node = [&](int i) {
    const double x = -span / 2 + pitch * i, u = 2 * x / span;
    return Vec(x, level - std::min(sag, level - 0.6) * (1 - u * u), 0);
  };
  const Vec post(0.3, 0.1, half_width);
  const auto join = [&](std::size_t before, std::size_t after, const Vec& at) {
    for (const double z : {-0.8, 0.8}) {
      const Vec here = at + Vec(0, 0, z * half_width);
      if (ropes)
        b.socket(before, after, here);
      else
        b.hinge(before, after, here);
    }
  };
  std::size_t before = b.fixed("bank", post, node(0) - Vec(0.32, 0, 0));
  const std::size_t far = b.fixed("bank", post, node(planks) + Vec(0.32, 0, 0)), first = b.members();
  double length = 0;
  for (int i = 0; i < planks; ++i) {
    const Vec from = node(i), to = node(i + 1), way = to - from;
    length += way.norm();
    const std::size_t plank = b.box("plank", Vec(0.45 * way.norm(), thick, half_width), (from + to) / 2, wood,
                                    turn_between(Vec::UnitX(), way));
    join(before, plank, from);
    before = plank;
  }
  join(before, far, node(planks));
  const std::vector<std::size_t> deck = b.since(first);
  const int loads = b.count(1, 9);
  drop_loads(b, loads, span / 2, half_width, level, load);
  // So deep a taut rope of this length hangs at most, and a plank may lean on it.
  const double deepest = std::sqrt(std::max(0.0, length * length - span * span)) / 2 + 0.02 * span + thick;
  Goal goal{"the bridge bears what is on it", 0, b.scene.seconds, false, {}, 0.05 * span, "m"};
  goal.missed_by = [deck, low = level - deepest](const Frame&, const Frame& now) {
    double most = -HUGE_VAL;
    for (const std::size_t plank : deck) most = std::max(most, low - now[plank].position.y());
    return most;
  };
  b.ask(goal);
  b.scene.summary = std::string(sag > 0 ? "sagging" : "taut") + " bridge of " + std::to_string(planks) + " planks on " +
                    (ropes ? "ropes" : "hinges") + ", " + std::to_string(loads) + " loads";
}

void draw_net(Builder& b) {
  b.scene.seconds = 5;
  b.ground(0.6);
  const int side = b.count(3, 6);
  const double pitch = b.between(0.12, 0.3), wide = pitch * (side - 1), level = 1.2 * wide + 0.6;
  const double sag = b.chance(0.4) ? 0 : b.between(0.05, 0.35) * wide;
  const bool edges = b.chance(0.5);  // held along its edges, or at its corners alone
  const Stuff knot{b.scale(300, 3000), 0.6, 0};
  const double radius = b.between(0.12, 0.25) * pitch;
  std::vector<std::size_t> at;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double u = 2.0 * i / (side - 1) - 1, v = 2.0 * k / (side - 1) - 1;
      const double deep = sag * (edges ? (1 - u * u) * (1 - v * v) : 1 - (u * u + v * v) / 2);
      const Vec place(u * wide / 2, level - deep, v * wide / 2);
      at.push_back(b.ball("knot", radius, place, knot));
      const auto tie = [&](int i2, int k2) {
        const std::size_t other = at[static_cast<std::size_t>(i2 * side + k2)];
        b.socket(other, at.back(), (b.actor(other).position + place) / 2);
      };
      if (i > 0) tie(i - 1, k);
      if (k > 0) tie(i, k - 1);
    }
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const bool corner = i % (side - 1) == 0 && k % (side - 1) == 0;
      const bool edge = i % (side - 1) == 0 || k % (side - 1) == 0;
      if (!corner && !(edges && edge)) continue;
      const std::size_t held = at[static_cast<std::size_t>(i * side + k)];
      const Vec place = b.actor(held).position;
      const std::size_t post = b.fixed("peg", Vec::Constant(0.3 * radius), place + Vec(0, 1.5 * radius, 0));
      b.socket(post, held, place);
    }
  const double big = b.between(0.9, 1.3) * pitch, x = b.between(-0.2, 0.2) * pitch, z = b.between(-0.2, 0.2) * pitch;
  const double fall = b.between(0.1, 1);
  const std::size_t ball = b.ball("load", big, Vec(x, level + big + fall, z), {b.scale(200, 8000), 0.6, 0});
  Goal goal{"the net catches the ball", b.scene.seconds - 0.5, b.scene.seconds, false, {}, 0.1 * wide, "m"};
  goal.missed_by = [ball, big, wide](const Frame&, const Frame& now) {
    const Vec& p = now[ball].position;
    return std::max({big + 0.2 - p.y(), std::fabs(p.x()) - wide / 2, std::fabs(p.z()) - wide / 2});
  };
  b.ask(goal);
  b.scene.summary = std::string(sag > 0 ? "slack" : "taut") + " net of " + std::to_string(side * side) +
                    " knots held by " + (edges ? "edges" : "corners") + ", a ball";
}

}  // namespace carom::tools::jury

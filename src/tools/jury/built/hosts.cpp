// Hosts that meddle: bodies put elsewhere, thrown, added, removed, steps of other lengths, pushers.
#include <algorithm>
#include <cmath>

#include "jury/built/builder.h"

namespace carom::tools::jury {
namespace {

/// What is meddled with. @return its bodies, no two of which a joint holds; members of joints are not among them
std::vector<std::size_t> add_pile(Builder& b, const Stuff& stuff) {
  const int rows = b.count(2, 5), columns = b.count(2, 4);
  const double half = b.between(0.08, 0.2);
  const std::size_t first = b.members();
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < columns; ++i) {
      const Vec at((2.05 * i - columns) * half, (2 * row + 1) * half, row % 2 * 0.3 * half);
      if (b.chance(0.2))
        b.wheel("drum", half, half, at, stuff, Vec::UnitY());
      else
        b.box("box", Vec::Constant(half), at, stuff);
    }
  return b.since(first);
}

/// A chain that hangs from a post beside the pile.
std::vector<std::size_t> add_chain(Builder& b, const Stuff& stuff) {
  const int links = b.count(3, 9);
  const double half = b.between(0.06, 0.12), top = 2 * half * links * 1.1 + 0.5;
  std::size_t before = b.fixed("post", Vec::Constant(0.03), Vec(1.5, top, 0));
  const std::size_t first = b.members();
  for (int i = 0; i < links; ++i) {
    const Vec pin(1.5 + 2 * half * i, top, 0), end = pin + Vec(2 * half, 0, 0);  // straight out: it falls
    const std::size_t link = b.rod("link", 0.3 * half, pin + Vec(0.4 * half, 0, 0), end - Vec(0.4 * half, 0, 0), stuff);
    b.socket(before, link, pin);
    before = link;
  }
  return b.since(first);
}

State above(Builder& b, double level) {
  State state;
  const double x = b.between(-1, 1), z = b.between(-1, 1);
  state.position = Vec(x, level, z);
  state.orientation = b.random.rotation();
  return state;
}

void change_pace(Builder& b) {
  static constexpr double kSteps[] = {1.0 / 30, 1.0 / 60, 1.0 / 90, 1.0 / 144, 1.0 / 240};
  const bool each = b.chance(0.3);  // as a host without a fixed step
  for (double t = each ? 0.5 : b.between(0.3, 1); t < b.scene.seconds; t += each ? 0.01 : b.between(0.1, 0.8)) {
    const double dt = each ? b.between(0.004, 0.033) : kSteps[b.count(0, 4)];
    b.deed(t, Deed::What::pace, 0, dt);
  }
}

void put_elsewhere(Builder& b, const std::vector<std::size_t>& loose, const std::vector<std::size_t>& chain) {
  double level = 2.5;
  for (double t = 0.7; t < b.scene.seconds - 1; t += b.between(0.2, 0.6)) {
    const bool joined = b.chance(0.3);
    const auto& from = joined ? chain : loose;
    const std::size_t who = from[static_cast<std::size_t>(b.count(0, static_cast<int>(from.size()) - 1))];
    State state = above(b, level);
    if (joined) {  // not far: its joint is open by so much
      const double x = b.between(-0.2, 0.2), y = b.between(-0.2, 0.2);
      state.position = b.actor(who).position + Vec(x, y, 0.15);
    }
    level = level > 4 ? 2.5 : level + 0.5;
    b.deed(t, Deed::What::put, who, state);
  }
}

void add_and_remove(Builder& b, const std::vector<std::size_t>& loose, const Stuff& stuff) {
  for (double t = 0.4; t < b.scene.seconds - 1; t += b.between(0.1, 0.4)) {
    const double half = b.between(0.05, 0.15);
    const State state = above(b, 3);
    const std::size_t late = b.chance(0.5) ? b.box("late box", Vec::Constant(half), Vec(0, 20, 0), stuff)
                                           : b.ball("late ball", half, Vec(0, 20, 0), stuff);
    b.make_late(late, t, state);
    if (b.chance(0.5)) b.deed(t + b.between(0.5, 2), Deed::What::remove, late, State());
  }
  double when = 1;
  for (const std::size_t who : loose) {
    if (b.chance(0.5)) continue;
    when += b.between(0, 0.4);
    if (when < b.scene.seconds) b.deed(when, Deed::What::remove, who, State());
  }
}

void throw_about(Builder& b, const std::vector<std::size_t>& loose) {
  for (double t = 0.5; t < b.scene.seconds - 1; t += b.between(0.1, 0.4)) {
    const std::size_t who = loose[static_cast<std::size_t>(b.count(0, static_cast<int>(loose.size()) - 1))];
    State state;
    const double speed = b.between(0, 5), spin = b.between(0, 10);
    state.velocity = speed * b.random.direction();
    state.omega = spin * b.random.direction();
    b.deed(t, Deed::What::throws, who, state);
  }
}

void add_pusher(Builder& b, double rub) {
  const Vec half(b.between(0.3, 0.8), 0.15, 0.05);
  Paddle paddle;
  paddle.member = b.add("pusher", "box", {half.x(), half.y(), half.z()}, Vec(0, 0.16, b.between(-0.2, 0.2) - 0.8),
                        {1000, rub, 0}, Quat::Identity(), CAROM_BODY_KINEMATIC);
  paddle.swing = Vec(0, 0, b.between(0.4, 1));
  paddle.period = b.between(2, 5);
  b.scene.paddles.push_back(paddle);
}

}  // namespace

void draw_meddler(Builder& b) {
  b.scene.seconds = 5;
  const double rub = b.between(0.3, 0.9);
  b.ground(rub);
  const Stuff stuff{b.scale(200, 3000), rub, b.chance(0.2) ? 0.4 : 0};
  const std::vector<std::size_t> loose = add_pile(b, stuff), chain = add_chain(b, stuff);
  const int kind = b.count(0, 4);
  static constexpr const char* kWhat[] = {"puts bodies elsewhere", "adds and removes", "throws", "changes its step",
                                          "pushes"};
  if (kind == 0) put_elsewhere(b, loose, chain);
  if (kind == 1) add_and_remove(b, loose, stuff);
  if (kind == 2) throw_about(b, loose);
  if (kind == 3 || (kind != 4 && b.chance(0.3))) change_pace(b);
  if (kind == 4) add_pusher(b, rub);
  b.scene.summary = std::string("a host that ") + kWhat[kind];
}

}  // namespace carom::tools::jury

// What swings: Newton's cradles, cranes with wrecking balls.
#include <algorithm>
#include <cmath>

#include "jury/built/builder.h"

namespace carom::tools::jury {

void draw_cradle(Builder& b) {
  b.scene.seconds = 5;
  const int balls = b.count(2, 7), raised = 1 + (balls > 3 ? b.count(0, 1) : 0);
  const double r = b.between(0.03, 0.2), string = b.between(3, 8) * r, level = string + 2 * r;
  const double apart = b.chance(0.5) ? 0 : b.between(0.0005, 0.01) * r, angle = b.between(0.3, 1.2);
  const double bounce = b.chance(0.6) ? 1 : b.between(0.9, 1);
  const bool two_strings = b.chance(0.5);
  const Stuff steel{b.scale(1000, 8000), 0.3, bounce};
  const std::size_t beam = b.fixed("beam", Vec(2 * r * balls, 0.1 * r, 0.1 * r), Vec(0, level + 0.2 * r, 0));
  const Turned out = turned_by(angle);
  std::size_t first = 0, last = 0;
  for (int i = 0; i < balls; ++i) {
    const double x = (i - (balls - 1) / 2.0) * (2 * r + apart);
    const Vec pin(x, level, 0), way = i < raised ? Vec(-out.sin, -out.cos, 0) : Vec(0, -1, 0);
    last = b.ball("ball", r, pin + string * way, steel);
    if (i == 0) first = last;
    if (two_strings)
      for (const double z : {-1.0, 1.0}) b.socket(beam, last, pin + Vec(0, 0, 0.5 * z * string));
    else
      b.hinge(beam, last, pin);
  }
  const double height = string * (1 - out.cos);
  Goal goal{"the last ball swings out", 0, 4, true, {}, 0.3 * height, "m"};
  goal.missed_by = [last, height](const Frame& start, const Frame& now) {
    return 0.5 * height - (now[last].position.y() - start[last].position.y());
  };
  b.ask(goal);
  Goal slow{"the first ball rises no higher than it began", 0, b.scene.seconds, false, {}, 0.1 * height, "m"};
  slow.missed_by = [first, height](const Frame& start, const Frame& now) {
    return now[first].position.y() - start[first].position.y() - 0.02 * height;
  };
  b.ask(slow);
  b.scene.summary = "cradle of " + std::to_string(balls) + " balls on " + (two_strings ? "two strings" : "hinges");
}

void draw_crane(Builder& b) {
  b.scene.seconds = 6;
  b.ground(b.between(0.5, 0.9));
  const int links = b.count(2, 12), columns = b.count(2, 5), rows = b.count(2, 6);
  const double cable = b.between(1.2, 2.5), link = cable / links / 2, thick = b.between(0.01, 0.03);
  const double r = b.between(0.15, 0.35), reach = b.between(0.8, 1.8), height = cable + 2 * r + b.between(0.2, 0.8);
  const bool slews = b.chance(0.5);  // else the ball is held aside and let go
  const Stuff steel{b.scale(1000, 8000), 0.5, 0};
  const std::size_t mast = b.fixed("mast", Vec(0.1, height / 2, 0.1), Vec(0, height / 2, 0));
  const std::size_t boom =
      b.box("boom", Vec(reach / 2 + 0.1, 0.05, 0.05), Vec(reach / 2 - 0.1, height + 0.06, 0), {800, 0.5, 0});
  const std::size_t slew = b.hinge(mast, boom, Vec(0, height + 0.05, 0), Vec::UnitY());
  const Turned aside = turned_by(slews ? 0 : b.between(0.5, 1.2));
  const Vec tip(reach, height + 0.06, 0), way(0, -aside.cos, -aside.sin);
  std::size_t before = boom;
  for (int i = 0; i < links; ++i) {
    const Vec from = tip + 2 * link * i * way, to = tip + 2 * link * (i + 1) * way;
    const double end = std::min(0.3 * link, thick);
    const std::size_t part = b.rod("link", std::min(thick, 0.3 * link), from + end * way, to - end * way, steel);
    b.socket(before, part, from);
    before = part;
  }
  const std::size_t ball = b.ball("ball", r, tip + (cable + r) * way, {b.scale(500, 8000), 0.5, 0});
  b.socket(before, ball, tip + cable * way);
  const double weight = 9.81 * (b.mass(ball) + b.mass(boom));
  const double speed = b.between(0.3, 1);
  if (slews)
    b.run(slew, -speed, weight * reach);
  else
    b.run(slew, 0, 2 * weight * reach);  // a brake
  const double half = b.between(0.06, 0.15);
  const Stuff brick{b.scale(300, 2500), 0.6, 0};
  const double level = height - cable - 2 * r, far = slews ? 1.2 * r + 1.5 * half + 0.3 : 1.5 * half + 1.1 * r;
  const double up = std::max(0.0, level - rows * half);
  if (up > 0.05) b.fixed("plinth", Vec(3, up / 2, 2 * half), Vec(reach, up / 2, far + half));
  const std::size_t first = b.members();
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < columns; ++i)
      b.box("brick", Vec(half, half, half),
            Vec(reach + (2 * i + 1 - columns + row % 2 * 0.9) * 1.01 * half,
                (up > 0.05 ? up : 0) + (2 * row + 1) * half, far + half),
            brick);
  const std::vector<std::size_t> bricks = b.since(first);
  Goal hit{"the ball hits the wall", 0, b.scene.seconds, true, {}, 0.01, "m"};
  hit.missed_by = [bricks](const Frame& start, const Frame& now) {
    double most = 0;
    for (const std::size_t i : bricks) most = std::max(most, (now[i].position - start[i].position).norm());
    return 0.02 - most;
  };
  b.ask(hit);
  Goal hangs{"the ball hangs on its cable", 0, b.scene.seconds, false, {}, 0.2, "m"};
  hangs.missed_by = [ball, boom, length = cable + r, out = reach / 2 + 0.1](const Frame&, const Frame& now) {
    const Vec end = now[boom].position + now[boom].orientation * Vec(out, 0, 0);
    return (now[ball].position - end).norm() - length - 0.02 * length;
  };
  b.ask(hangs);
  b.scene.summary = "crane, a ball of " + std::to_string(static_cast<int>(b.mass(ball))) + " kg on " +
                    std::to_string(links) + " links, " + std::to_string(rows * columns) + " bricks";
}

}  // namespace carom::tools::jury

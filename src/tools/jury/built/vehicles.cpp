// What drives: vehicles on sprung or bare wheels over bumps, and chains of links round wheels.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "jury/built/builder.h"

namespace carom::tools::jury {
namespace {

/// One wheel: hinged to the body, or to a carrier that slides on it and is sprung.
struct Corner {
  Vec at;  // m, of the wheel's centre
  double radius, half_width, side;
  bool sprung, round;
  double load;  // N that it bears at rest
  double speed, torque;
};

void add_wheel(Builder& b, std::size_t body, const Corner& c, const Stuff& rubber, double stiffness, double damping) {
  const std::size_t wheel =
      c.round ? b.ball("wheel", c.radius, c.at, rubber) : b.wheel("wheel", c.radius, c.half_width, c.at, rubber);
  std::size_t holder = body;
  if (c.sprung) {
    const double half = 0.15 * c.radius;
    const Vec inside = c.at - Vec(0, 0, c.side * (c.half_width + 2 * half));
    holder = b.box("carrier", Vec(half, half, half), inside, {2000, 0.5, 0});
    const std::size_t strut = b.slider(body, holder, inside, Vec::UnitY());
    b.limit(strut, -0.4 * c.radius, 0.4 * c.radius);
    b.aim(strut, -0.1 * c.radius, stiffness * c.load / (0.1 * c.radius), damping, 8 * c.load);
  }
  const std::size_t axle = b.hinge(holder, wheel, c.at);
  b.run(axle, c.speed, c.torque);
}

void add_bumps(Builder& b, double from, double until, double highest, double wide) {
  for (double x = from; x < until; x += b.between(0.4, 1.5)) {
    const double height = b.between(0.2, 1) * highest;
    const bool is_step = b.chance(0.4);
    const double half = b.between(0.1, 0.3);
    if (is_step) {
      b.fixed("kerb", Vec(half, height, wide), Vec(x, 0, 0));
    } else {
      const double radius = b.between(1, 4) * height;
      b.wheel("bump", radius, wide, Vec(x, height - radius, 0), {}, Vec::UnitZ(), CAROM_BODY_STATIC);
    }
    x += 2 * half;
  }
}

}  // namespace

void draw_vehicle(Builder& b) {
  b.scene.seconds = 5;
  b.ground(b.between(0.6, 1));
  const int axles = b.count(2, 4);
  const double r = b.between(0.12, 0.4), width = b.between(0.3, 0.7), flat = b.between(0.25, 0.5) * r;
  const bool sprung = b.chance(0.7), round = b.chance(0.25);
  const double length = axles * r * b.between(1.25, 1.6), high = b.between(0.3, 0.8) * r;
  const Stuff hull{b.scale(150, 1200), 0.5, 0}, rubber{b.scale(200, 2000), b.between(0.7, 1), 0};
  const double deck = r + (sprung ? 0.75 : 0.3) * r + high;
  const std::size_t body = b.box("chassis", Vec(length, high, width), Vec(0, deck, 0), hull);
  const double load = b.mass(body) * 9.81 / (2 * axles), speed = b.between(0.8, 3);
  const double stiffness = b.between(0.7, 2), damping = b.between(0.3, 1);
  const double wheel_mass = 3 * r * r * (round ? 1.4 * r : 2 * flat) * rubber.density;
  const double torque = 0.9 * r * (load + 9.81 * wheel_mass);
  for (int i = 0; i < axles; ++i)
    for (const double side : {-1.0, 1.0}) {
      const double x = axles > 1 ? (2.0 * i / (axles - 1) - 1) * (length - 0.5 * r) : 0;
      const double half = round ? r : flat;
      const double z = side * (width + half + (sprung ? 0.7 : 0.1) * r);
      add_wheel(b, body, {Vec(x, r, z), r, half, side, sprung, round, load, -speed / r, torque}, rubber, stiffness,
                damping);
    }
  const double way = speed * b.scene.seconds;
  add_bumps(b, length + 3 * r + 0.3, length + way, 0.3 * r, width + 4 * r);
  Goal goal{"the vehicle comes along", b.scene.seconds, b.scene.seconds, false, {}, 0.1 * way, "m"};
  goal.missed_by = [body, way](const Frame& start, const Frame& now) {
    return 0.25 * way - (now[body].position.x() - start[body].position.x());
  };
  b.ask(goal);
  Goal upright{"the vehicle stays on its wheels", 0, b.scene.seconds, false, {}, 0.5, ""};
  upright.missed_by = [body](const Frame&, const Frame& now) {
    return 0.5 - (now[body].orientation * Vec::UnitY()).y();
  };
  b.ask(upright);
  b.scene.summary = std::string(sprung ? "sprung" : "bare") + " vehicle on " + std::to_string(2 * axles) +
                    (round ? " balls" : " wheels");
}

namespace {

/// A belt of links round two wheels: `arc` links round each, `straight` on each side.
struct Belt {
  int arc, straight;
  double radius, thick, wide, pitch, span;  // m: of the wheels; half of a link; from pin to pin; between the axles
};

std::vector<std::size_t> add_belt(Builder& b, const Belt& belt, double height, const Stuff& steel) {
  const Turned half_step = turned_by(std::numbers::pi / belt.arc / 2);
  const double radius = belt.pitch / 2 / half_step.sin;
  std::vector<Vec> pins;
  const auto round = [&](double middle, int from) {  // half a turn about an axle
    for (int i = 0; i < belt.arc; ++i) {
      const Vec spoke = about(Vec::UnitZ(), std::numbers::pi * i / belt.arc) * Vec(0, from * radius, 0);
      pins.push_back(Vec(middle, height, 0) + spoke);
    }
  };
  round(-belt.span / 2, 1);
  for (int i = 0; i < belt.straight; ++i) pins.emplace_back(-belt.span / 2 + belt.pitch * i, height - radius, 0);
  round(belt.span / 2, -1);
  for (int i = 0; i < belt.straight; ++i) pins.emplace_back(belt.span / 2 - belt.pitch * i, height + radius, 0);
  std::vector<std::size_t> links;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const Vec &from = pins[i], to = pins[(i + 1) % pins.size()];
    links.push_back(b.box("link", Vec(0.42 * belt.pitch, belt.thick, belt.wide), (from + to) / 2, steel,
                          turn_between(Vec::UnitX(), to - from)));
  }
  for (std::size_t i = 0; i < links.size(); ++i)
    b.hinge(links[(i + links.size() - 1) % links.size()], links[i], pins[i]);
  return links;
}

}  // namespace

void draw_track(Builder& b) {
  b.scene.seconds = 5;
  b.ground(b.between(0.6, 1));
  Belt belt{};
  belt.arc = b.count(5, 8), belt.straight = b.count(3, 8);
  belt.radius = b.between(0.15, 0.35), belt.thick = belt.radius * b.between(0.05, 0.12);
  belt.wide = belt.radius * b.between(0.8, 1.5);
  const Turned half_step = turned_by(std::numbers::pi / belt.arc / 2);
  // Links are clear of the wheels by 2 mm where they are nearest.
  const double ring = (belt.radius + belt.thick + 0.002) / half_step.cos;
  belt.pitch = 2 * ring * half_step.sin;
  while (belt.pitch * belt.straight < 2.2 * belt.radius) ++belt.straight;  // the wheels are clear of each other
  belt.span = belt.pitch * belt.straight;
  const bool drives = b.chance(0.5);
  const double height = drives ? ring + belt.thick + 0.002 : 1.0;
  const Stuff steel{b.scale(500, 8000), b.between(0.5, 1), 0}, rubber{b.scale(300, 3000), b.between(0.6, 1), 0};
  const std::vector<std::size_t> links = add_belt(b, belt, height, steel);
  const Vec inside(belt.span / 2 + 0.6 * belt.radius, 0.35 * belt.radius, 0.2 * belt.wide);
  std::size_t body = 0;
  for (const double side : {-1.0, 1.0}) {  // plates beside the track, joined under it
    const Vec at(0, height, side * (belt.wide + 0.3 * belt.wide));
    if (drives) {
      const std::size_t plate = b.box("plate", inside, at, {b.scale(200, 2000), 0.5, 0});
      if (side > 0) b.join(CAROM_JOINT_WELD, body, plate, Vec(0, height, 0));
      body = plate;
    } else {
      body = b.fixed("plate", inside, at);
    }
  }
  double weight = 0;
  for (const std::size_t link : links) weight += 9.81 * b.mass(link);
  if (drives) weight += 2 * 9.81 * b.mass(body);
  const double speed = b.between(0.5, 2);
  for (const double side : {-1.0, 1.0}) {
    const Vec at(side * belt.span / 2, height, 0);
    const std::size_t wheel = b.wheel("sprocket", belt.radius, 0.9 * belt.wide, at, rubber);
    const std::size_t axle = b.hinge(body, wheel, at);
    b.run(axle, -speed / belt.radius, 0.7 * weight * belt.radius);
  }
  const double way = speed * b.scene.seconds;
  if (drives) {
    Goal goal{"the track comes along", b.scene.seconds, b.scene.seconds, false, {}, 0.1 * way, "m"};
    goal.missed_by = [body, way](const Frame& start, const Frame& now) {
      return 0.25 * way - (now[body].position.x() - start[body].position.x());
    };
    b.ask(goal);
  } else {
    Goal goal{"the belt goes round", 0, b.scene.seconds, true, {}, 0.3 * belt.span, "m"};
    goal.missed_by = [link = links[0], span = belt.span](const Frame& start, const Frame& now) {
      return 0.6 * span - (now[link].position - start[link].position).norm();
    };
    b.ask(goal);
  }
  Goal on{"the track stays on its wheels", 0, b.scene.seconds, false, {}, belt.wide, "m"};
  const std::size_t wheel = b.members() - 1;
  on.missed_by = [links, wheel, far = belt.span + 2 * ring, wide = belt.wide](const Frame&, const Frame& now) {
    double most = 0;
    for (const std::size_t link : links) {
      const Vec at = now[wheel].orientation.conjugate() * Vec(now[link].position - now[wheel].position);
      most = std::max({most, std::fabs(at.y()) - 0.7 * wide, at.norm() - far - wide});
    }
    return most;
  };
  b.ask(on);
  b.scene.summary = std::string(drives ? "tank" : "belt") + " of " + std::to_string(links.size()) + " links";
}

}  // namespace carom::tools::jury

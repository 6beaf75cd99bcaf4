// What bodies fall on, and what stirs them.
#include <algorithm>
#include <cmath>

#include "jury/drawing.h"

namespace carom::tools::jury {
namespace {

/// A turn about an axis by twice the angle whose tangent is `half_tangent`.
Quat turn(const Vec& axis, double half_tangent) {
  const Vec v = half_tangent * axis;
  return Quat(1, v.x(), v.y(), v.z()).normalized();
}

void add_plane(Drawing& d, double level, double friction) {
  Actor ground;
  ground.name = "plane", ground.kind = "ground";
  ground.type = CAROM_BODY_STATIC;
  Part part;
  part.shape = "half_space";
  part.params = {0, 1, 0, level};
  part.friction = friction;
  part.restitution = d.chance(0.2) ? d.random.between(0.05, 0.5) : 0;
  ground.parts.push_back(std::move(part));
  d.add(std::move(ground));
}

void add_block(Drawing& d, const std::string& name, const Vec& half, const Vec& position, const Quat& turned) {
  Actor block;
  block.name = name, block.kind = "ground";
  block.type = CAROM_BODY_STATIC;
  block.position = position;
  block.orientation = turned;
  Part part;
  part.shape = "box";
  part.params = {half.x(), half.y(), half.z()};
  part.friction = d.random.between(0.1, 0.9);
  block.parts.push_back(std::move(part));
  d.add(std::move(block));
}

void add_blocks(Drawing& d) {
  const std::size_t count = 2 + d.pick(6);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec half = d.random.within(Vec(0.1, 0.03, 0.1), Vec(0.7, 0.3, 0.7));
    const Vec place = d.random.within(Vec(-kPlace, 0, -kPlace), Vec(kPlace, half.y(), kPlace));
    const bool tumbled = d.chance(0.3);
    add_block(d, "block " + std::to_string(i), half, place,
              tumbled ? d.random.rotation() : turn(Vec::UnitY(), d.random.between(-1, 1)));
  }
}

void add_ramps(Drawing& d) {
  const std::size_t count = 1 + d.pick(3);
  for (std::size_t i = 0; i < count; ++i) {
    const Quat aside = turn(Vec::UnitY(), d.random.between(-1, 1));
    const Quat tilt = turn(Vec::UnitZ(), d.random.between(0.08, 0.4));  // 9 to 44 degrees
    const double across = d.random.between(0.4, 1.2);
    const Vec half(d.random.between(0.6, 1.5), 0.05, across);
    const Vec place = d.random.within(Vec(-1, 0.3, -1), Vec(1, 0.6, 1));
    add_block(d, "ramp " + std::to_string(i), half, place, aside * tilt);
  }
}

/// Hills with a border around them, of random heights smoothed once.
void add_heights(Drawing& d) {
  Heights field;
  field.columns = field.rows = 21;
  field.spacing = d.random.between(0.2, 0.4);
  const double half = 10 * field.spacing, rough = d.random.between(0.02, 0.35);
  field.corner = Vec(-half, 0, -half);
  std::vector<double> raw;
  for (std::size_t i = 0; i < field.columns * field.rows; ++i) raw.push_back(d.random.between(0, rough));
  const auto at = [&](std::size_t row, std::size_t column) {
    return raw[std::min(row, field.rows - 1) * field.columns + std::min(column, field.columns - 1)];
  };
  for (std::size_t row = 0; row < field.rows; ++row)
    for (std::size_t column = 0; column < field.columns; ++column) {
      const double u = std::fabs(static_cast<double>(column) / 10 - 1),
                   v = std::fabs(static_cast<double>(row) / 10 - 1);
      const double edge = std::max(u, v), square = edge * edge, border = square * square * square;
      field.values.push_back((2 * at(row, column) + at(row + 1, column) + at(row, column + 1)) / 4 + border);
    }
  Actor hills;
  hills.name = "hills", hills.kind = "ground";
  hills.type = CAROM_BODY_STATIC;
  hills.position = field.corner;
  Part part;
  part.shape = "height_field";
  part.params = {21, 21, field.spacing, field.spacing};
  part.params.insert(part.params.end(), field.values.begin(), field.values.end());
  part.friction = d.random.between(0.1, 0.9);
  hills.parts.push_back(std::move(part));
  d.scene.heights = std::move(field);
  d.add(std::move(hills));
}

}  // namespace

std::string draw_ground(Drawing& d) {
  const std::size_t kind = d.pick(4);
  if (kind == 3) {
    add_heights(d);
    d.scene.floor = -3;
    add_plane(d, d.scene.floor, 0.5);  // for what leaves over the border
    return "hills";
  }
  add_plane(d, 0, d.random.between(0.1, 0.9));
  if (kind == 1) add_blocks(d);
  if (kind == 2) add_ramps(d);
  return kind == 0 ? "a plane" : kind == 1 ? "blocks" : "ramps";
}

void draw_paddle(Drawing& d) {
  Actor actor;
  actor.name = actor.kind = "paddle";
  actor.type = CAROM_BODY_KINEMATIC;
  Part part;
  part.shape = "box";
  const Vec half = d.random.within(Vec(0.3, 0.05, 0.02), Vec(1, 0.2, 0.1));
  part.params = {half.x(), half.y(), half.z()};
  part.friction = d.random.between(0.1, 0.9);
  const double clear = d.random.between(0.005, 0.1);
  Paddle paddle;
  const std::size_t kind = d.pick(3);
  double height = half.y() + clear;
  if (kind == 0) {  // sweeps the ground
    paddle.spin = Vec(0, d.random.between(0.5, 4), 0);
  } else if (kind == 1) {  // a mill wheel
    paddle.spin = Vec(0, 0, d.random.between(0.5, 4));
    height = Vec(half.x(), half.y(), 0).norm() + clear;
  } else {
    paddle.swing = Vec(0, 0, d.random.between(0.2, 0.8));
    paddle.period = d.random.between(1.5, 5);
  }
  double level = 0;
  if (d.scene.heights)
    for (const double h : d.scene.heights->values) level = std::max(level, h < 0.4 ? h : 0);
  const double aside = d.random.between(-0.5, 0.5);
  actor.position = Vec(d.random.between(-0.5, 0.5), level + height, aside);
  actor.angular_velocity = paddle.spin;
  actor.parts.push_back(std::move(part));
  paddle.member = d.add(std::move(actor));
  d.scene.paddles.push_back(paddle);
}

Vec Paddle::velocity(double from, double to) const {
  const auto place = [&](double time) {  // two parabolas a period
    const double u = time / period - std::floor(time / period);
    return u < 0.5 ? 16 * u * (0.5 - u) : -16 * (u - 0.5) * (1 - u);
  };
  return (place(to) - place(from)) / (to - from) * swing;
}

std::optional<Heights::At> Heights::at(double x, double z) const {
  const double u = (x - corner.x()) / spacing, v = (z - corner.z()) / spacing;
  if (!(u >= 0 && v >= 0 && u < static_cast<double>(columns - 1) && v < static_cast<double>(rows - 1)))
    return std::nullopt;
  const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
  const double s = u - static_cast<double>(column), t = v - static_cast<double>(row);
  const double* h = values.data() + row * columns + column;
  const double first = h[0], along = h[1], beyond = h[columns], far = h[columns + 1];
  // Divided from the first corner to the far one.
  const double du = s >= t ? along - first : far - beyond, dv = s >= t ? far - along : beyond - first;
  const Vec normal = Vec(-du / spacing, 1, -dv / spacing).normalized();
  return At{corner.y() + first + du * s + dv * t, normal};
}

}  // namespace carom::tools::jury

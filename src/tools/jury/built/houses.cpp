// What stands: houses of cards, towers, walls, pyramids; and boxes that are made in each other.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "jury/built/builder.h"

namespace carom::tools::jury {

/// Pairs of cards that lean on each other, and cards that lie across from top to top: a triangle of them.
void draw_cards(Builder& b) {
  b.scene.seconds = 4;
  const double rub = b.between(0.6, 0.9), half = b.scale(0.04, 0.4), thin = b.between(0.004, 0.03) * half;
  b.ground(rub);
  const int base = b.count(1, 4);
  const Stuff paper{b.scale(300, 2000), rub, 0};
  const Turned lean = turned_by(b.between(0.25, 0.4));
  const double reach = half * lean.sin + thin * lean.cos;  // from a top to a card's middle
  const double rise = 2 * (half * lean.cos + thin * lean.sin),
               pitch = 4 * half * lean.sin + 4 * thin * lean.cos + 0.1 * half;
  const double angle_half = std::sqrt((1 - lean.cos) / 2), cos_half = std::sqrt((1 + lean.cos) / 2);
  double floor = 0;
  for (int row = 0; row < base; ++row) {
    const int pairs = base - row;
    for (int i = 0; i < pairs; ++i) {
      const double top = (i - (pairs - 1) / 2.0) * pitch;
      for (const double side : {-1.0, 1.0})
        b.box("card", Vec(thin, half, 0.7 * half), Vec(top + side * reach, floor + rise / 2, 0), paper,
              Quat(cos_half, 0, 0, side * angle_half));
    }
    floor += rise;
    for (int i = 0; i + 1 < pairs; ++i)
      b.box("roof", Vec(pitch / 2 - 0.01 * half, thin, 0.7 * half), Vec((i + 1 - pairs / 2.0) * pitch, floor + thin, 0),
            paper);
    floor += 2 * thin;
  }
  b.ask_to_stay("the house of cards stands", b.since(1), 0.03 * half, 0.3 * half);
  b.scene.summary = "house of " + std::to_string(b.since(1).size()) + " cards";
}

namespace {

void stack_rows(Builder& b, int rows, int columns, int less, const Vec& half, const Stuff& stone, int deep) {
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < columns - less * row; ++i)
      for (int k = 0; k < deep - (deep > 1 ? row : 0); ++k) {
        const double aside = less ? row : row % 2;
        const double z = deep > 1 ? 2 * k - (deep - row - 1) : 0;
        b.box("block", half, Vec((2 * i + aside - columns) * half.x(), (2 * row + 1) * half.y(), z * half.z()), stone);
      }
}

std::string draw_tower(Builder& b) {  // three beams a layer, across those below
  const int layers = b.count(5, 14);
  const double s = b.between(0.03, 0.3);
  const Stuff wood{b.scale(300, 1500), b.between(0.3, 0.9), 0};
  for (int i = 0; i < layers; ++i)
    for (int k = -1; k <= 1; ++k) {
      const Vec at(0, (2 * i + 1) * 0.2 * s, 0), aside = 2.02 * s / 3 * k * (i % 2 ? Vec::UnitX() : Vec::UnitZ());
      b.box("beam", i % 2 ? Vec(s / 3, 0.2 * s, s) : Vec(s, 0.2 * s, s / 3), at + aside, wood);
    }
  return "tower of " + std::to_string(3 * layers) + " beams";
}

std::string draw_column(Builder& b) {  // of boxes, heavy ones on light ones
  const int boxes = b.count(3, 14);
  const double s = b.between(0.05, 0.4), light = b.scale(50, 500), ratio = b.scale(1, 200);
  for (int i = 0; i < boxes; ++i)
    b.box("box", Vec(s, 0.6 * s, s), Vec(0, (2 * i + 1) * 0.6 * s, 0), {i % 2 ? light * ratio : light, 0.6, 0});
  return "column of " + std::to_string(boxes) + " boxes, masses 1:" + std::to_string(static_cast<int>(ratio));
}

/// Stones of an arch between two abutments, held by nothing.
std::string draw_arch(Builder& b) {
  const int stones = 2 * b.count(2, 6) + 1;
  const double inner = b.between(0.4, 1), thick = b.between(0.25, 0.4) * inner, deep = b.between(0.2, 0.4);
  const Stuff stone{b.scale(500, 4000), b.between(0.6, 0.9), 0};
  for (int i = 0; i < stones; ++i) {
    const Turned half = turned_by(std::numbers::pi / stones / 2);
    // A wedge about its own middle line, and turned to its place.
    std::vector<double> corners;
    for (const double r : {inner, inner + thick})
      for (const double side : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0}) {
          const Vec corner(r * half.sin * side, r * half.cos - inner - thick / 2, z * deep);
          corners.insert(corners.end(), corner.data(), corner.data() + 3);
        }
    const Quat turned = about(Vec::UnitZ(), std::numbers::pi / 2 - std::numbers::pi * (i + 0.5) / stones);
    b.add("stone", "hull", corners, turned * Vec(0, inner + thick / 2, 0), stone, turned);
  }
  return "arch of " + std::to_string(stones) + " stones";
}

}  // namespace

void draw_stack(Builder& b) {
  b.scene.seconds = 4;
  b.ground(b.between(0.6, 0.9));
  const int kind = b.count(0, 4);
  std::string what;
  if (kind == 0) {
    what = draw_tower(b);
  } else if (kind == 1) {
    what = draw_column(b);
  } else if (kind == 2) {
    what = draw_arch(b);
  } else {
    const double x = b.between(0.05, 0.3), y = b.between(0.4, 1) * x, z = b.between(0.4, 1) * x;
    const Stuff stone{b.scale(300, 3000), b.between(0.3, 0.9), 0};
    const bool wall = kind == 3;
    const int rows = b.count(4, wall ? 10 : 12), columns = wall ? b.count(4, 10) : rows,
              deep = !wall && rows < 6 ? rows : 1;
    stack_rows(b, rows, columns, wall ? 0 : 1, Vec(x, y, z), stone, deep);
    what = (wall ? "wall of " : "pyramid of ") + std::to_string(b.since(1).size()) + " blocks";
  }
  b.ask_to_stay("the " + what + " stands", b.since(1), 0.005, 0.05);
  b.scene.summary = what;
}

/// Boxes in each other where they are made, some hinged to the one before: what overlaps comes apart, and calmly.
void draw_overlap(Builder& b) {
  b.scene.seconds = 6, b.scene.grace = 2.5;
  b.ground(b.between(0.3, 0.9));
  const int boxes = b.count(8, 60), every = b.count(2, 4);
  const double half = b.between(0.05, 0.3), pitch = b.between(1.3, 1.9) * half;
  const Stuff stuff{b.scale(200, 3000), b.between(0.2, 0.9), 0};
  double weight = 0;
  std::size_t before = 0;
  for (int i = 0; i < boxes; ++i) {
    const Vec at(i % 4 * pitch, half + i / 12 * pitch, i / 4 % 3 * pitch);
    const std::size_t box = b.box("box", Vec::Constant(half), at, stuff);
    if (i % every == 1) b.hinge(before, box, (b.actor(before).position + at) / 2, Vec::UnitY());
    weight += 9.81 * b.mass(box);
    before = box;
  }
  // What is pushed out of another may rise by as much as it was in it, row upon row.
  b.scene.stored = weight * (2 * half - pitch) * (1 + boxes / 24);
  b.scene.summary = std::to_string(boxes) + " boxes in each other, each " + std::to_string(every) + ". hinged";
}

}  // namespace carom::tools::jury

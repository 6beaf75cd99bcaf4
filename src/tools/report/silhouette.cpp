// Shadows by raster and boundary walk; outlines of convex parts by asking for supports all around.
#include "report/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carom::report {
namespace {

using tools::Vec;

double cross(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Cells of a raster, with a margin of empty ones so that every boundary closes.
struct Raster {
  int width, height;
  std::vector<char> full;
  Raster(int w, int h) : width(w), height(h), full(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  char& at(int x, int y) {
    return full[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  bool is(int x, int y) { return x >= 0 && y >= 0 && x < width && y < height && at(x, y); }

  // Fill the cells whose centre is inside the triangle, and those of its corners, so that slivers leave no hole.
  void add(Point a, Point b, Point c) {
    if (cross(a, b, c) < 0) std::swap(b, c);
    const auto low = [](double p, double q, double r) { return static_cast<int>(std::floor(std::min({p, q, r}))); };
    const auto high = [](double p, double q, double r) { return static_cast<int>(std::floor(std::max({p, q, r}))); };
    for (int y = low(a.y, b.y, c.y); y <= high(a.y, b.y, c.y); ++y)
      for (int x = low(a.x, b.x, c.x); x <= high(a.x, b.x, c.x); ++x) {
        const Point m{x + 0.5, y + 0.5};
        if (cross(a, b, m) >= 0 && cross(b, c, m) >= 0 && cross(c, a, m) >= 0) at(x, y) = 1;
      }
    for (const Point p : {a, b, c}) at(static_cast<int>(p.x), static_cast<int>(p.y)) = 1;
  }
};

// Walk the boundary that begins at the lower left corner of a cell whose lower neighbour is empty, full cells at the
// left.
std::vector<Point> walk(Raster& raster, int x, int y, std::vector<char>& visited) {
  constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const int start_x = x, start_y = y;
  int heading = 0;
  std::vector<Point> path;
  do {
    // The middle of the edge: a slanted boundary becomes a smaller staircase than through the corners.
    path.push_back({x + 0.5 * kStep[heading][0], y + 0.5 * kStep[heading][1]});
    if (heading == 0)
      visited[static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x)] = 1;
    x += kStep[heading][0];
    y += kStep[heading][1];
    // Cells ahead at the left and at the right of the corner reached. Where the left one is empty turn left, also where
    // only the right one is full: a part that touches another by a corner is a part of its own.
    const int ahead_x[4][2] = {{x, x}, {x - 1, x}, {x - 1, x - 1}, {x, x - 1}};
    const int ahead_y[4][2] = {{y, y - 1}, {y, y}, {y - 1, y}, {y - 1, y - 1}};
    const bool left = raster.is(ahead_x[heading][0], ahead_y[heading][0]);
    const bool right = raster.is(ahead_x[heading][1], ahead_y[heading][1]);
    if (!left) {
      heading = (heading + 1) % 4;
    } else if (right) {
      heading = (heading + 3) % 4;
    }
  } while (x != start_x || y != start_y || heading != 0);
  return path;
}

// Douglas and Peucker's thinning: keep what lies further than `tolerance` from the chord.
void thin(const std::vector<Point>& path, std::size_t first, std::size_t last, double tolerance,
          std::vector<Point>& out) {
  std::size_t far = first;
  double worst = tolerance;
  const Point a = path[first], b = path[last];
  const double chord = std::hypot(b.x - a.x, b.y - a.y);
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d = chord > 0 ? std::fabs(cross(a, b, path[i])) / chord : std::hypot(path[i].x - a.x, path[i].y - a.y);
    if (d > worst) {
      worst = d;
      far = i;
    }
  }
  if (far == first) {
    out.push_back(a);
    return;
  }
  thin(path, first, far, tolerance, out);
  thin(path, far, last, tolerance, out);
}

std::vector<Point> convex_outline(tools::Engine& engine, const tools::Part& part, const Vec& position,
                                  const tools::Quat& orientation) {
  constexpr int kDirections = 48;
  std::vector<double> directions, supports(3 * kDirections);
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Vec d = orientation.conjugate() * Vec(std::cos(angle), std::sin(angle), 0);
    directions.insert(directions.end(), {d.x(), d.y(), d.z()});
  }
  tools::Call call;
  call.done(carom_shape_support(engine.get(), engine.shape(part.shape, part.params), directions.data(), kDirections,
                                supports.data(), call),
            "drawing a " + part.shape);
  std::vector<Point> outline;
  for (std::size_t i = 0; i < kDirections; ++i) {
    const Vec p = position + orientation * Vec(supports[3 * i], supports[3 * i + 1], supports[3 * i + 2]);
    outline.push_back({p.x(), p.y()});
  }
  return hull(std::move(outline));
}

}  // namespace

std::vector<Point> shadow(const tools::Mesh& mesh, int cells) {
  const std::vector<Vec>& points = mesh.points;
  if (points.empty() || mesh.faces.empty()) return {};
  Vec low = points[0], high = points[0];
  for (const Vec& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double cell = std::max({high.x() - low.x(), high.y() - low.y(), 1e-12}) / cells;
  Raster raster(static_cast<int>((high.x() - low.x()) / cell) + 3, static_cast<int>((high.y() - low.y()) / cell) + 3);
  const auto place = [&](const Vec& p) { return Point{1 + (p.x() - low.x()) / cell, 1 + (p.y() - low.y()) / cell}; };
  for (const auto& f : mesh.faces) raster.add(place(points[f[0]]), place(points[f[1]]), place(points[f[2]]));
  std::vector<char> visited(raster.full.size());
  std::vector<Point> longest;
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x) {
      const auto index =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) + static_cast<std::size_t>(x);
      if (!raster.is(x, y) || raster.is(x, y - 1) || visited[index]) continue;
      std::vector<Point> path = walk(raster, x, y, visited);
      if (path.size() > longest.size()) longest = std::move(path);
    }
  longest.push_back(longest.front());
  std::vector<Point> outline;
  thin(longest, 0, longest.size() - 1, 0.6, outline);  // cells: the staircase stays within 0.36 of its line
  for (Point& p : outline) p = {low.x() + (p.x - 1) * cell, low.y() + (p.y - 1) * cell};
  return outline;
}

std::vector<Outline> side_view(tools::Stage& stage, const tools::Recording& recording, std::size_t frame) {
  std::vector<std::string> kinds;
  std::vector<std::pair<double, Outline>> found;
  for (std::size_t i = 0; i < stage.actors.size(); ++i) {
    const tools::Actor& actor = stage.actors[i];
    const float* pose = recording.pose(frame, i);
    const Vec origin(pose[0], pose[1], pose[2]);
    const tools::Quat turn = tools::Quat(pose[6], pose[3], pose[4], pose[5]).normalized();
    const auto kind = std::find(kinds.begin(), kinds.end(), actor.kind);
    const auto colour = static_cast<int>(kind - kinds.begin()) % 6;
    bool drawn = false;
    for (const tools::Part& part : actor.parts) {
      if (part.is_ground()) continue;
      const Vec position = origin + turn * part.position;
      const tools::Quat orientation = turn * part.orientation;
      Outline outline;
      outline.colour = colour;
      outline.ghost = actor.type == CAROM_BODY_STATIC;
      if (part.mesh >= 0) {
        tools::Mesh mesh = stage.meshes[static_cast<std::size_t>(part.mesh)];
        for (Vec& p : mesh.points) p = position + orientation * p;
        outline.points = shadow(mesh);
      } else {
        outline.points = convex_outline(stage.engine(), part, position, orientation);
      }
      found.emplace_back(position.z(), outline);
      drawn = true;
    }
    if (drawn && kind == kinds.end()) kinds.push_back(actor.kind);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Outline> outlines;
  for (auto& f : found) outlines.push_back(std::move(f.second));
  return outlines;
}

Filmstrip filmstrip_of(tools::Stage& stage, const tools::Recording& recording, int panels) {
  Filmstrip strip;
  strip.left = strip.bottom = std::numeric_limits<double>::infinity();
  strip.right = strip.top = -strip.left;
  const std::size_t last = recording.frame_count() - 1;
  for (int i = 0; i < panels; ++i) {
    const std::size_t frame =
        panels == 1 ? last : last * static_cast<std::size_t>(i) / static_cast<std::size_t>(panels - 1);
    strip.panels.push_back({"t = " + number(recording.times()[frame], 3) + " s", side_view(stage, recording, frame)});
    for (const Outline& outline : strip.panels.back().outlines)
      for (const Point& p : outline.points) {
        strip.left = std::min(strip.left, p.x);
        strip.right = std::max(strip.right, p.x);
        strip.bottom = std::min(strip.bottom, p.y);
        strip.top = std::max(strip.top, p.y);
      }
  }
  if (!(strip.right > strip.left)) strip.left = strip.bottom = 0, strip.right = strip.top = 1;
  const double margin = 0.03 * (strip.right - strip.left);
  strip.left -= margin;
  strip.right += margin;
  strip.bottom -= margin;
  strip.top += margin;
  return strip;
}

}  // namespace carom::report

// A mesh as several convex parts: cut along the axes, joined again where that costs little.
#include "mesh/parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host/host.h"
#include "mesh/solid.h"

namespace carom::tools {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

/// Cells [low, high) of the grid.
struct Box {
  Vector3i low, high;
};

/// Some boxes' share of the solid.
struct Part {
  std::vector<Box> boxes;
  Mesh hull;              // of the cells that are not outside
  double out = 0;         // m, how far it stands out
  double volume = 0;      // m^3
  double length2 = 0;     // m^2, of its bounding box from corner to corner
  bool is_whole = false;  // no cut makes it better
};

/// Corners of the convex polygon around points of a plane.   @param points  sorted here
std::vector<Eigen::Vector2d> around(std::vector<Eigen::Vector2d>& points) {
  std::ranges::sort(points,
                    [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Eigen::Vector2d> chain;
  const auto side = [&](const Eigen::Vector2d& c) {
    const Eigen::Vector2d &a = chain[chain.size() - 2], &b = chain.back();
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t begin = chain.size();
    for (const auto& p : points) {
      while (chain.size() >= begin + 2 && side(p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::ranges::reverse(points);
  }
  return chain;
}

std::pair<Vector3d, Vector3d> bounds_of(const std::vector<Vector3d>& points) {
  Vector3d low = points[0], high = low;
  for (const Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return {low, high};
}

class Cutter {
 public:
  explicit Cutter(const Solid& solid) : solid_(solid) {}

  /// What boxes hold; nothing where all is outside.
  std::optional<Part> part(std::vector<Box> boxes) const {
    std::vector<Vector3d> points;
    for (const Box& box : boxes) add_corners(box, points);
    if (points.empty()) return std::nullopt;
    return finished({std::move(boxes), convex_hull(points)});
  }
  Part joined(const Part& a, const Part& b) const {
    std::vector<Box> boxes = a.boxes;
    boxes.insert(boxes.end(), b.boxes.begin(), b.boxes.end());
    std::vector<Vector3d> points = a.hull.points;
    points.insert(points.end(), b.hull.points.begin(), b.hull.points.end());
    return finished({std::move(boxes), convex_hull(points)});
  }

  /// The cut across an axis after which the least is left: of how far the worse stands out, of what they hold, and of
  /// how long they are. (A ring's hull still holds its hole after any one cut: only the last says that halves are a way
  /// to quarters, and slices are none.)
  /// @return two parts, or none: it is as thin as a cell
  std::vector<Part> cut(const Part& part) const {
    const Box& box = part.boxes[0];
    std::vector<Part> best;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const int length = box.high[axis] - box.low[axis];
      int at = box.low[axis] + length / 2;
      double here = std::numeric_limits<double>::infinity();
      const auto try_at = [&](int plane) {
        if (plane <= box.low[axis] || plane >= box.high[axis]) return;
        Box lower = box, upper = box;
        lower.high[axis] = upper.low[axis] = plane;
        std::optional<Part> a = this->part({lower}), b = this->part({upper});
        if (!a || !b) return;
        const double left = std::max(a->out, b->out) / part.out + (a->volume + b->volume) / part.volume +
                            (a->length2 + b->length2) / (2 * part.length2);
        if (left < here) here = left, at = plane;
        if (left < least) least = left, best = {std::move(*a), std::move(*b)};
      };
      constexpr int kCoarse = 8;
      const int stride = std::max(1, length / kCoarse);
      for (int plane = box.low[axis] + std::max(1, stride / 2); plane < box.high[axis]; plane += stride) try_at(plane);
      for (int near = stride / 2; near > 0; near /= 2)
        for (const int plane : {at - near, at + near}) try_at(plane);
    }
    return best;
  }

 private:
  Part finished(Part part) const {
    part.volume = volume_of(part.hull);
    const auto [low, high] = bounds_of(part.hull.points);
    part.length2 = (high - low).squaredNorm();
    part.out = stands_out(part.hull);
    return part;
  }

  /// Corners of cells that are not outside, as few as give their hull: slice by slice.
  void add_corners(const Box& box, std::vector<Vector3d>& points) const {
    std::vector<Eigen::Vector2d> slice;
    for (int z = box.low.z(); z < box.high.z(); ++z) {
      slice.clear();
      for (int y = box.low.y(); y < box.high.y(); ++y) {
        const auto is_in = [&](int x) { return solid_.kind[solid_.at(x, y, z)] != Solid::kOutside; };
        int first = box.low.x(), last = box.high.x() - 1;
        while (first <= last && !is_in(first)) ++first;
        while (last >= first && !is_in(last)) --last;
        if (first > last) continue;
        for (const int side : {0, 1}) slice.emplace_back(first, y + side), slice.emplace_back(last + 1, y + side);
      }
      if (slice.empty()) continue;
      for (const Eigen::Vector2d& p : around(slice))
        for (const int side : {0, 1}) points.push_back(solid_.low + solid_.cell * Vector3d(p.x(), p.y(), z + side));
    }
  }

  /// m: the farthest from the solid that a cell's middle in a hull is.
  double stands_out(const Mesh& hull) const {
    const auto [low, high] = bounds_of(hull.points);
    std::vector<Eigen::Vector4d> planes;  // n.x <= w
    for (const auto& f : hull.faces) {
      const Vector3d n = (hull.points[f[1]] - hull.points[f[0]]).cross(hull.points[f[2]] - hull.points[f[0]]);
      planes.emplace_back(n.x(), n.y(), n.z(), n.dot(hull.points[f[0]]));
    }
    const auto cell = [&](double x, int axis) {
      return std::clamp(static_cast<int>(std::floor((x - solid_.low[axis]) / solid_.cell)), 0, solid_.n[axis] - 1);
    };
    float worst = 0;
    for (int z = cell(low.z(), 2); z <= cell(high.z(), 2); ++z)
      for (int y = cell(low.y(), 1); y <= cell(high.y(), 1); ++y) {
        const Vector3d at = solid_.middle(0, y, z);
        double from = low.x(), to = high.x();
        for (const Eigen::Vector4d& p : planes) {
          const double rest = p.w() - p.y() * at.y() - p.z() * at.z();
          if (p.x() > 0) to = std::min(to, rest / p.x());
          if (p.x() < 0) from = std::max(from, rest / p.x());
          if (p.x() == 0 && rest < 0) to = from - 1;
        }
        if (!(to >= from)) continue;
        const int first = std::max(0, static_cast<int>(std::ceil((from - at.x()) / solid_.cell)));
        const int last = std::min(solid_.n.x() - 1, static_cast<int>(std::floor((to - at.x()) / solid_.cell)));
        for (int x = first; x <= last; ++x) worst = std::max(worst, solid_.away[solid_.at(x, y, z)]);
      }
    return worst;
  }

  const Solid& solid_;
};

/// Cut what stands out the farthest until none does by more than `most_out`, or there are `most` parts.
void cut_all(const Cutter& cutter, std::vector<Part>& parts, double most_out, std::size_t most,
             const PartsWanted& wanted) {
  while (parts.size() < most) {
    const auto worst = std::ranges::max_element(parts, {}, [](const Part& p) { return p.is_whole ? -1.0 : p.out; });
    if (worst->is_whole || worst->out <= most_out) return;
    std::vector<Part> halves = cutter.cut(*worst);
    if (halves.empty()) {
      worst->is_whole = true;
      continue;
    }
    *worst = std::move(halves[0]);
    parts.push_back(std::move(halves[1]));
    if (wanted.progress && parts.size() % 8 == 0) wanted.progress("cut into " + std::to_string(parts.size()));
  }
}

/// Join the two whose hull stands out the least, while that is within `most_out`, or there are too many.
void join_all(const Cutter& cutter, std::vector<Part>& parts, double most_out, std::size_t most) {
  // Neighbours rather than what lies apart: a hull across a gap overlaps others.
  const auto cost = [&](std::size_t i, std::size_t j) {
    const Part joined = cutter.joined(parts[i], parts[j]);
    return joined.out * std::max(1.0, joined.volume / (parts[i].volume + parts[j].volume));
  };
  std::vector<std::vector<double>> costs(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) costs[i].push_back(cost(i, j));
  while (parts.size() > 1) {
    std::size_t a = 1, b = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (costs[i][j] < costs[a][b]) a = i, b = j;
    if (costs[a][b] > most_out && parts.size() <= most) return;
    parts[b] = cutter.joined(parts[a], parts[b]);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(a));
    costs.erase(costs.begin() + static_cast<std::ptrdiff_t>(a));
    for (std::size_t i = a; i < parts.size(); ++i) costs[i].erase(costs[i].begin() + static_cast<std::ptrdiff_t>(a));
    for (std::size_t j = 0; j < b; ++j) costs[b][j] = cost(b, j);
    for (std::size_t i = b + 1; i < parts.size(); ++i) costs[i][b] = cost(i, b);
  }
}

/// What of a polygon is within a box, m.
void clip(std::vector<Vector3d>& polygon, const Vector3d& low, const Vector3d& high) {
  std::vector<Vector3d> kept;
  for (int side = 0; side < 6 && !polygon.empty(); ++side) {
    const int axis = side / 2;
    const double sign = side % 2 ? -1 : 1, plane = side % 2 ? high[axis] : low[axis];
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double at_a = sign * (a[axis] - plane), at_b = sign * (b[axis] - plane);
      if (at_a >= 0) kept.push_back(a);
      if ((at_a < 0) == (at_b < 0)) continue;
      Vector3d cut = a + at_a / (at_a - at_b) * (b - a);
      cut[axis] = plane;
      kept.push_back(cut);
    }
    polygon.swap(kept);
  }
}

/// The hull of a mesh's faces within each part's boxes. Faces that alone have no thickness there go to the nearest
/// other.
std::vector<Mesh> hulls_of(const Mesh& mesh, const Solid& solid, const std::vector<Part>& parts) {
  std::vector<std::vector<Vector3d>> points(parts.size());
  std::vector<Vector3d> polygon;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const Box& box : parts[i].boxes) {
      const Vector3d low = solid.low + solid.cell * box.low.cast<double>();
      const Vector3d high = solid.low + solid.cell * box.high.cast<double>();
      for (const auto& f : mesh.faces) {
        const Vector3d &a = mesh.points[f[0]], &b = mesh.points[f[1]], &c = mesh.points[f[2]];
        if ((a.cwiseMin(b).cwiseMin(c).array() > high.array()).any()) continue;
        if ((a.cwiseMax(b).cwiseMax(c).array() < low.array()).any()) continue;
        polygon = {a, b, c};
        clip(polygon, low, high);
        points[i].insert(points[i].end(), polygon.begin(), polygon.end());
      }
    }
  std::vector<Mesh> hulls;
  std::vector<Vector3d> over;
  const auto keep = [&](std::vector<Vector3d>& own) {
    if (own.empty()) return;
    try {
      hulls.push_back(convex_hull(own));
    } catch (const Error&) {
      over.insert(over.end(), own.begin(), own.end());
    }
  };
  for (auto& own : points) keep(own);
  if (hulls.empty()) hulls.push_back(convex_hull(over)), over.clear();
  for (const Vector3d& p : over) {
    const auto far = [&](const Mesh& hull) {
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3d& q : hull.points) least = std::min(least, (p - q).squaredNorm());
      return least;
    };
    std::ranges::min_element(hulls, {}, far)->points.push_back(p);
  }
  if (!over.empty())
    for (Mesh& hull : hulls) hull = convex_hull(hull.points);
  return hulls;
}

/// Whether p is inside a hull.
bool holds(const Mesh& hull, const Vector3d& p) {
  return std::ranges::none_of(hull.faces, [&](const auto& f) {
    const Vector3d& a = hull.points[f[0]];
    return (hull.points[f[1]] - a).cross(hull.points[f[2]] - a).dot(p - a) > 0;
  });
}

/// m: how far the surface of the hulls' union stands out of the mesh, at points half a cell apart.
double stands_out_of(const std::vector<Mesh>& hulls, const FaceTree& tree, const Solid& solid) {
  double worst = 0;
  const auto look = [&](std::size_t own, const Vector3d& p) {
    Vector3i i;
    for (int k = 0; k < 3; ++k)
      i[k] = std::clamp(static_cast<int>((p[k] - solid.low[k]) / solid.cell), 0, solid.n[k] - 1);
    if (solid.away[solid.at(i.x(), i.y(), i.z())] + 2 * solid.cell < worst) return;  // its corners' distance and a half
    const double distance = tree.distance(p);
    if (distance <= worst || std::fabs(tree.winding(p)) > 0.5) return;
    for (std::size_t k = 0; k < hulls.size(); ++k)
      if (k != own && holds(hulls[k], p)) return;
    worst = distance;
  };
  for (std::size_t k = 0; k < hulls.size(); ++k)
    for (const auto& f : hulls[k].faces) {
      const Vector3d &a = hulls[k].points[f[0]], u = hulls[k].points[f[1]] - a, v = hulls[k].points[f[2]] - a;
      const int steps = 1 + static_cast<int>(2 * std::max({u.norm(), v.norm(), (u - v).norm()}) / solid.cell);
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps - i; ++j) look(k, a + (u * i + v * j) / steps);
    }
  return worst;
}

void check(const Mesh& mesh, const PartsWanted& wanted) {
  if (wanted.most < 1 || wanted.most > 256) throw Error("the number of parts is out of range", "give 1 to 256");
  if (wanted.vertices < 8 || wanted.vertices > 2000)
    throw Error("the number of vertices of a part is out of range", "give 8 to 2000");
  if (!(wanted.concavity >= 0) || !std::isfinite(wanted.concavity))
    throw Error("the concavity is out of range", "give metres, 0 for a fiftieth of the mesh's length");
  if (mesh.faces.empty())
    throw Error("the mesh has no faces, so nothing is inside it",
                "give a mesh with f lines, closed and looking outwards");
}

constexpr double kEnclosed = 0.75;  // of a winding number

}  // namespace

Parts take_apart(const Mesh& mesh, const PartsWanted& wanted) {
  check(mesh, wanted);
  const auto tell = [&](const std::string& line) {
    if (wanted.progress) wanted.progress(line);
  };
  const Mesh whole = convex_hull(mesh.points);  // refuses what is flat
  const auto [low, high] = bounds_of(whole.points);
  const double length = (high - low).maxCoeff();
  const double concavity = wanted.concavity > 0 ? wanted.concavity : length / 50;
  const int across = static_cast<int>(std::clamp(std::ceil(3 * length / concavity), 32.0, 96.0));
  const FaceTree tree(mesh);
  const Solid solid = fill_solid(mesh, tree, across);
  tell("a grid of " + std::to_string(across) + " cells along its length, " + std::to_string(solid.inside()) +
       " inside");
  if (solid.most_winding < kEnclosed)
    throw Error("the mesh encloses nothing", "give a closed mesh, or one with small holes, thicker than " +
                                                 std::to_string(100 / across + 1) + " % of its length somewhere");
  const Cutter cutter(solid);
  std::vector<Part> parts{*cutter.part({{Vector3i::Zero(), solid.n}})};
  const double most_out = std::max(concavity - solid.cell / 2, solid.cell);
  if (wanted.most > 1) {
    cut_all(cutter, parts, most_out, 3 * wanted.most, wanted);
    tell("cut into " + std::to_string(parts.size()) + ", joining what may be");
    join_all(cutter, parts, most_out, wanted.most);
  }
  Parts result;
  for (const Mesh& hull : hulls_of(mesh, solid, parts)) {
    ReducedHull reduced = reduce_hull(hull, wanted.vertices);
    result.lost = std::max(result.lost, reduced.loss);
    result.hulls.push_back(std::move(reduced.hull));
  }
  std::ranges::stable_sort(result.hulls, std::greater<>(), volume_of);
  std::ranges::transform(result.hulls, std::back_inserter(result.volumes), volume_of);
  result.mesh_volume = std::fabs(volume_of(mesh)), result.hull_volume = volume_of(whole);
  result.outside = stands_out_of(result.hulls, tree, solid);
  return result;
}

}  // namespace carom::tools

// What a triangle mesh encloses.
#include "mesh/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace carom::tools {
namespace {

using Eigen::Vector3d;

/// A face's solid angle from a point, rad^2 [VanOosterom1983].
double solid_angle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d x = a - p, y = b - p, z = c - p;
  const double lx = x.norm(), ly = y.norm(), lz = z.norm();
  return 2 * std::atan2(x.dot(y.cross(z)), lx * ly * lz + x.dot(y) * lz + y.dot(z) * lx + z.dot(x) * ly);
}

/// Squared distances along one line, in cells: the lower envelope of parabolas [Felzenszwalb2012].
void spread(std::vector<double>& f, std::vector<double>& out, std::vector<int>& hull, std::vector<double>& from) {
  const int n = static_cast<int>(f.size());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  int k = -1;
  for (int q = 0; q < n; ++q) {
    if (f[q] == kFar) continue;
    double s = -kFar;
    while (k >= 0) {
      const int v = hull[k];
      s = ((f[q] + q * q) - (f[v] + v * v)) / (2.0 * (q - v));
      if (s > from[k]) break;
      --k;
    }
    if (k < 0) s = -kFar;
    hull[++k] = q, from[k] = s;
  }
  if (k < 0) return void(out = f);
  for (int q = 0, j = 0; q < n; ++q) {
    while (j < k && from[j + 1] < q) ++j;
    out[q] = f[hull[j]] + static_cast<double>(q - hull[j]) * (q - hull[j]);
  }
}

/// Exact distances from cell to cell, axis by axis.
void measure_away(Solid& solid) {
  std::vector<double> d(solid.kind.size());
  for (std::size_t i = 0; i < d.size(); ++i)
    d[i] = solid.kind[i] == Solid::kOutside ? std::numeric_limits<double>::infinity() : 0;
  const std::size_t stride[3] = {1, static_cast<std::size_t>(solid.n.x()),
                                 static_cast<std::size_t>(solid.n.x() * solid.n.y())};
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::size_t>(solid.n[axis]);
    std::vector<double> line(n), spread_line(n), from(n);
    std::vector<int> hull(n);
    for (std::size_t start = 0; start < d.size(); ++start) {
      if (start / stride[axis] % n != 0) continue;
      for (std::size_t i = 0; i < n; ++i) line[i] = d[start + i * stride[axis]];
      spread(line, spread_line, hull, from);
      for (std::size_t i = 0; i < n; ++i) d[start + i * stride[axis]] = spread_line[i];
    }
  }
  solid.away.resize(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) solid.away[i] = static_cast<float>(solid.cell * std::sqrt(d[i]));
}

}  // namespace

// By its Voronoi regions.
double distance_squared(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  const Vector3d* corner[3] = {&a, &b, &c};
  bool inside = area > 0;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d& from = *corner[i];
    const Vector3d edge = *corner[(i + 1) % 3] - from;
    if (normal.cross(edge).dot(p - from) < 0) inside = false;
    const double length = edge.squaredNorm();
    const double t = length > 0 ? std::clamp(edge.dot(p - from) / length, 0.0, 1.0) : 0.0;
    best = std::min(best, (from + t * edge - p).squaredNorm());
  }
  if (!inside) return best;
  const double height = normal.dot(p - a);
  return height * height / area;
}

FaceTree::FaceTree(const Mesh& mesh) : mesh_(mesh), order_(mesh.faces.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(2 * order_.size());
  build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t FaceTree::build(std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kLeaf = 8;
  const auto corner = [&](std::uint32_t f, int k) -> const Vector3d& { return mesh_.points[mesh_.faces[f][k]]; };
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node{Vector3d::Zero(), Vector3d::Zero(), 0, first, last, 0, 0};
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  double weight = 0;
  Vector3d weighted = Vector3d::Zero();
  for (std::uint32_t i = first; i < last; ++i) {
    const std::uint32_t f = order_[i];
    const Vector3d area = (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0)) / 2;
    const Vector3d middle = (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3;
    node.area += area;
    weighted += area.norm() * middle, weight += area.norm();
    low = low.cwiseMin(middle), high = high.cwiseMax(middle);
  }
  node.middle = weight > 0 ? Vector3d(weighted / weight) : Vector3d((low + high) / 2);
  for (std::uint32_t i = first; i < last; ++i)
    for (int k = 0; k < 3; ++k) node.radius = std::max(node.radius, (corner(order_[i], k) - node.middle).norm());
  nodes_.push_back(node);
  if (last - first <= kLeaf) return index;
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t half = (first + last) / 2;
  const auto along = [&](std::uint32_t f) { return corner(f, 0)[axis] + corner(f, 1)[axis] + corner(f, 2)[axis]; };
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](auto a, auto b) { return along(a) != along(b) ? along(a) < along(b) : a < b; });
  const std::uint32_t left = build(first, half), right = build(half, last);
  nodes_[index].left = left, nodes_[index].right = right;
  return index;
}

double FaceTree::winding(const Vector3d& p) const {
  constexpr double kFar = 2;  // radii, from which a cluster is a dipole
  double sum = 0;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    const Vector3d d = node.middle - p;
    const double distance = d.norm();
    if (distance > kFar * node.radius) {
      sum += node.area.dot(d) / (distance * distance * distance);
    } else if (node.left) {
      open.push_back(node.left), open.push_back(node.right);
    } else {
      for (std::uint32_t i = node.first; i < node.last; ++i) {
        const auto& f = mesh_.faces[order_[i]];
        sum += solid_angle(p, mesh_.points[f[0]], mesh_.points[f[1]], mesh_.points[f[2]]);
      }
    }
  }
  return sum / (4 * std::numbers::pi);
}

double FaceTree::distance(const Vector3d& p) const {
  double best2 = std::numeric_limits<double>::infinity();
  nearest(0, p, best2);
  return std::sqrt(best2);
}

void FaceTree::nearest(std::uint32_t index, const Vector3d& p, double& best2) const {
  const auto least = [&](std::uint32_t i) { return std::max(0.0, (nodes_[i].middle - p).norm() - nodes_[i].radius); };
  const Node& node = nodes_[index];
  if (!node.left) {
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      const auto& f = mesh_.faces[order_[i]];
      best2 = std::min(best2, distance_squared(p, mesh_.points[f[0]], mesh_.points[f[1]], mesh_.points[f[2]]));
    }
    return;
  }
  const double left = least(node.left), right = least(node.right);
  const bool left_first = left < right;
  for (int k = 0; k < 2; ++k) {
    const bool is_left = (k == 0) == left_first;
    const double bound = is_left ? left : right;
    if (bound * bound < best2) nearest(is_left ? node.left : node.right, p, best2);
  }
}

std::size_t Solid::inside() const { return static_cast<std::size_t>(std::ranges::count(kind, kInside)); }

Solid fill_solid(const Mesh& mesh, const FaceTree& tree, int across) {
  Vector3d low = mesh.points[mesh.faces[0][0]], high = low;
  for (const auto& f : mesh.faces)
    for (const std::uint32_t i : f) low = low.cwiseMin(mesh.points[i]), high = high.cwiseMax(mesh.points[i]);
  Solid solid;
  solid.cell = (high - low).maxCoeff() / across;
  solid.low = low - Vector3d::Constant(solid.cell);
  for (int k = 0; k < 3; ++k) solid.n[k] = static_cast<int>(std::ceil((high[k] - low[k]) / solid.cell - 1e-9)) + 2;
  solid.kind.assign(solid.at(0, 0, solid.n.z()), Solid::kOutside);
  const auto mark = [&](const Vector3d& p) {
    Eigen::Vector3i i;
    for (int k = 0; k < 3; ++k)
      i[k] = std::clamp(static_cast<int>((p[k] - solid.low[k]) / solid.cell), 1, solid.n[k] - 2);
    solid.kind[solid.at(i.x(), i.y(), i.z())] = Solid::kSurface;
  };
  for (const auto& f : mesh.faces) {
    const Vector3d &a = mesh.points[f[0]], u = mesh.points[f[1]] - a, v = mesh.points[f[2]] - a;
    const int steps = 1 + static_cast<int>(2 * std::max({u.norm(), v.norm(), (u - v).norm()}) / solid.cell);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps - i; ++j) mark(a + (u * i + v * j) / steps);
  }
  for (int z = 1; z < solid.n.z() - 1; ++z)
    for (int y = 1; y < solid.n.y() - 1; ++y)
      for (int x = 1; x < solid.n.x() - 1; ++x) {
        std::uint8_t& kind = solid.kind[solid.at(x, y, z)];
        if (kind != Solid::kOutside) continue;
        const double winding = std::fabs(tree.winding(solid.middle(x, y, z)));
        if (winding > 0.5) kind = Solid::kInside;
        solid.most_winding = std::max(solid.most_winding, winding);
      }
  measure_away(solid);
  return solid;
}

double volume_of(const Mesh& mesh) {
  double six = 0;
  const Vector3d& origin = mesh.points[0];
  for (const auto& f : mesh.faces)
    six += (mesh.points[f[0]] - origin).dot((mesh.points[f[1]] - origin).cross(mesh.points[f[2]] - origin));
  return six / 6;
}

}  // namespace carom::tools

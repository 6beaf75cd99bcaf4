// Sides of one outline clipped to the other, one by one; then the other's corners inside. No list of corners is handed
// along, so their number has no bound.
#include "collision/manifold/cut_outlines.h"

#include <algorithm>

#include "collision/manifold/choice.h"
#include "collision/manifold/patch_constants.h"

namespace carom::collision {
namespace {

std::uint32_t corner_of_a(std::uint32_t name) { return name ? 0x40000000u | name : 0; }
std::uint32_t corner_of_b(std::uint32_t name) { return name ? 0x80000000u | name : 0; }
std::uint32_t crossing(std::uint32_t a, std::uint32_t b) { return a && b ? (a * 40503u ^ b) | 0xC0000000u : 0; }

/// Height of a place over side j of a polygon, m, positive inside.
Real inside(const Outline& o, int j, Real x, Real y) { return o.in_x[j] * x + o.in_y[j] * y - o.in[j]; }

bool holds(const Outline& o, Real x, Real y, Real tolerance) {
  for (int j = 0; j < o.count; ++j)
    if (!(inside(o, j, x, y) >= -tolerance)) return false;
  return true;
}

struct Cut {
  Real from = 0, to = 1;         // of the way
  int enters = -1, leaves = -1;  // sides of the polygon
};

/// The part of a line within a polygon. @return false if there is none
bool cut(const Outline& o, Real x0, Real y0, Real x1, Real y1, Real tolerance, Cut& c) {
  for (int j = 0; j < o.count; ++j) {
    const Real h0 = inside(o, j, x0, y0), h1 = inside(o, j, x1, y1);
    if (h0 < -tolerance && h1 < -tolerance) return false;
    if (h0 < -tolerance) {
      const Real t = std::min(h0 / (h0 - h1), Real(1));
      if (t > c.from) c.from = t, c.enters = j;
    } else if (h1 < -tolerance) {
      const Real t = std::max(h0 / (h0 - h1), Real(0));
      if (t < c.to) c.to = t, c.leaves = j;
    }
  }
  return c.from <= c.to;
}

class Cutter {
 public:
  Cutter(const Outline& a, const Outline& b, Real tolerance, ClippedVertices& out)
      : a_(a), b_(b), tolerance_(tolerance), out_(out) {}

  void run() {
    if (a_.count == 0) return all(b_, corner_of_b);
    if (b_.count == 0) return all(a_, corner_of_a);
    if (a_.count == 1 || b_.count == 1) return point();
    if (a_.count == 2 && b_.count == 2) return lines();
    if (a_.count == 2) return line(a_, b_, false);
    if (b_.count == 2) return line(b_, a_, true);
    for (int i = 0; i < a_.count; ++i) side(i);
    for (int j = 0; j < b_.count; ++j)
      if (holds(a_, b_.x[j], b_.y[j], tolerance_)) add(b_.x[j], b_.y[j], corner_of_b(b_.name[j]));
    within(a_, b_, corner_of_a), within(b_, a_, corner_of_b);
  }

 private:
  void add(Real x, Real y, std::uint32_t feature) { out_.add({x, y, feature}, b_.z(x, y) - a_.z(x, y), tolerance_); }

  /// Every corner, over a plane.
  void all(const Outline& o, std::uint32_t (*feature)(std::uint32_t)) {
    for (int i = 0; i < o.count; ++i) add(o.x[i], o.y[i], feature(o.name[i]));
    for (std::size_t i = 0; i < o.within_count; ++i) add(o.within[i].x, o.within[i].y, feature(o.within[i].name));
  }

  /// Corners within one outline that lie within the other too.
  void within(const Outline& o, const Outline& other, std::uint32_t (*feature)(std::uint32_t)) {
    for (const OutlineCorner* c = o.within; c < o.within + o.within_count; ++c)
      if (holds(other, c->x, c->y, tolerance_)) add(c->x, c->y, feature(c->name));
  }

  void point() {
    const bool of_a = a_.count == 1;
    const Outline &p = of_a ? a_ : b_, &o = of_a ? b_ : a_;
    if (o.count < 3 || !holds(o, p.x[0], p.y[0], tolerance_)) return;  // a point on less than a face: the query's own
    add(p.x[0], p.y[0], of_a ? corner_of_a(p.name[0]) : corner_of_b(p.name[0]));
  }

  void line(const Outline& l, const Outline& o, bool swapped) {
    Cut c;
    if (!cut(o, l.x[0], l.y[0], l.x[1], l.y[1], tolerance_, c)) return;
    const Real dx = l.x[1] - l.x[0], dy = l.y[1] - l.y[0];
    const auto end = [&](Real t, int at, int by) {
      if (by >= 0)
        add(l.x[0] + t * dx, l.y[0] + t * dy, 0);
      else
        add(l.x[at], l.y[at], swapped ? corner_of_b(l.name[at]) : corner_of_a(l.name[at]));
    };
    end(c.from, 0, c.enters), end(c.to, 1, c.leaves);
  }

  void lines() {
    const Real ax = a_.x[1] - a_.x[0], ay = a_.y[1] - a_.y[0], bx = b_.x[1] - b_.x[0], by = b_.y[1] - b_.y[0];
    const Real la2 = ax * ax + ay * ay, lb2 = bx * bx + by * by, turn = ax * by - ay * bx;
    const Real wx = b_.x[0] - a_.x[0], wy = b_.y[0] - a_.y[0];
    // Lines that enclose less (sine) lie along each other: the tilt within which facets are fitted at all.
    if (turn * turn > kFirstTilt * kFirstTilt * la2 * lb2) {
      const Real s = (wx * by - wy * bx) / turn, t = (wx * ay - wy * ax) / turn;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) add(a_.x[0] + s * ax, a_.y[0] + s * ay, 0);
      return;
    }
    // Along each other: the stretch of A's line that B's covers.
    const Real s0 = (wx * ax + wy * ay) / la2, s1 = s0 + (bx * ax + by * ay) / la2;
    const Real from = std::max(Real(0), std::min(s0, s1)), to = std::min(Real(1), std::max(s0, s1));
    if (!(from <= to)) return;
    add(a_.x[0] + from * ax, a_.y[0] + from * ay, 0), add(a_.x[0] + to * ax, a_.y[0] + to * ay, 0);
  }

  /// Side i of A within B: where it begins, and where it leaves B before its end (which begins the next side).
  void side(int i) {
    const int k = i + 1 < a_.count ? i + 1 : 0;
    Cut c;
    if (!cut(b_, a_.x[i], a_.y[i], a_.x[k], a_.y[k], tolerance_, c)) return;
    const auto meet = [&](Real t, int j) {
      add(a_.x[i] + t * (a_.x[k] - a_.x[i]), a_.y[i] + t * (a_.y[k] - a_.y[i]), crossing(a_.name[i], b_.name[j]));
    };
    if (c.enters < 0)
      add(a_.x[i], a_.y[i], corner_of_a(a_.name[i]));
    else
      meet(c.from, c.enters);
    if (c.leaves >= 0) meet(c.to, c.leaves);
  }

  const Outline &a_, &b_;
  Real tolerance_;
  ClippedVertices& out_;
};

}  // namespace

void Outline::close() {
  for (int j = 0; j < count; ++j) {
    const int k = j + 1 < count ? j + 1 : 0;
    const Real dx = x[k] - x[j], dy = y[k] - y[j], length = std::sqrt(dx * dx + dy * dy);
    in_x[j] = length > 0 ? -dy / length : 0, in_y[j] = length > 0 ? dx / length : 0;
    in[j] = in_x[j] * x[j] + in_y[j] * y[j];
  }
}

/// Andrew's chain: the lower side from left to right, the upper one back. What lies on a side is within.
void Outline::wrap(std::span<OutlineCorner> p) {
  std::sort(p.begin(), p.end(), [](const OutlineCorner& a, const OutlineCorner& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.name < b.name;
  });
  std::size_t chain[2 * Facet::kMostCorners], n = 0;
  bool on_chain[Facet::kMostCorners] = {};
  const auto left = [&](std::size_t i, std::size_t j, std::size_t k) {
    return (p[j].x - p[i].x) * (p[k].y - p[i].y) - (p[j].y - p[i].y) * (p[k].x - p[i].x) > 0;
  };
  const auto grow = [&](std::size_t i, std::size_t from) {
    while (n >= from + 2 && !left(chain[n - 2], chain[n - 1], i)) --n;
    chain[n++] = i;
  };
  for (std::size_t i = 0; i < p.size(); ++i) grow(i, 0);
  const std::size_t lower = n - 1;
  for (std::size_t i = p.size() - 1; i-- > 0;) grow(i, lower);
  --n;  // the first again
  count = static_cast<int>(std::min<std::size_t>(n, kMax));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::size_t at = chain[n <= kMax ? i : i * n / kMax];
    x[i] = p[at].x, y[i] = p[at].y, name[i] = p[at].name;
    on_chain[at] = true;
  }
  within_count = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!on_chain[i]) within[within_count++] = p[i];
}

void ClippedVertices::add(const ClippedVertex& m, Real separation, Real same) {
  for (int i = 0; i < count; ++i) {
    const Real dx = at[i].x - m.x, dy = at[i].y - m.y;
    if (dx * dx + dy * dy <= 4 * same * same) return;
  }
  if (count == kMax) thin();
  separation_[count] = separation;
  at[count++] = m;
}

void ClippedVertices::thin() {
  constexpr Real kWay[4][2] = {{1, 0}, {0.7071, 0.7071}, {0, 1}, {-0.7071, 0.7071}};  // and their opposites
  bool keep[kMax] = {};
  keep[std::min_element(separation_, separation_ + count) - separation_] = true;
  for (const auto& way : kWay) {
    for (const Real sign : {-1, 1}) {
      const auto reach = [&](int i) {
        return sign * (at[i].x * way[0] + at[i].y * way[1]) - separation_[i] / kChoiceTilt;
      };
      int best = 0;
      for (int i = 1; i < count; ++i)
        if (reach(i) > reach(best)) best = i;
      keep[best] = true;
    }
  }
  int n = 0;
  for (int i = 0; i < count; ++i)
    if (keep[i]) at[n] = at[i], separation_[n++] = separation_[i];
  count = n;
}

void cut_outlines(const Outline& a, const Outline& b, Real tolerance, ClippedVertices& out) {
  Cutter(a, b, tolerance, out).run();
}

}  // namespace carom::collision

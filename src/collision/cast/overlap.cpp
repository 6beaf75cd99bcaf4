// GJK that stops at the first proof: a separating plane, or a simplex around the origin (or nearer to it than the
// radii).
#include "collision/cast/overlap.h"

#include <algorithm>

#include "collision/narrow/difference.h"
#include "collision/narrow/gjk.h"
#include "collision/narrow/pair.h"
#include "collision/narrow/simplex_geometry.h"

namespace carom::collision {
namespace {

/// How far within a tetrahedron the origin is; negative: outside. The planes' errors are left to the caller.
Real depth_in(const Vec3* w) {
  static constexpr int kFace[4][4] = {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}};
  Real least = kInfinity;
  for (const auto& f : kFace) {
    const Vec3 n = triangle_normal(w[f[0]], w[f[1]], w[f[2]]);
    const Real length = n.norm(), side = n.dot(w[f[3]] - w[f[0]]);
    if (!(length > 0)) return -1;
    least = std::min(least, (side > 0 ? -n.dot(w[f[0]]) : n.dot(w[f[0]])) / length);
  }
  return least;
}

class Search {
 public:
  Search(const Shape& a, const Shape& b, const Frame& b_in_a, Real target, Real rounding)
      : a_(a), b_(b), frame_(b_in_a), target_(target), difference_(a, b, b_in_a, target) {
    rounding_ = difference_.rounding() +
                difference_.to_scaled(rounding * (b_in_a.p.norm() + a.bounding_radius + b.bounding_radius + target));
  }

  OverlapResult run(int cap, SupportFault& fault) {
    result_.slack = difference_.to_metres(rounding_);
    if (!difference_.usable()) return result_;
    if (!walk(cap)) {
      result_.outcome = Overlap::fault;
      fault = difference_.fault;
    }
    result_.support_calls += difference_.calls;
    result_.capped = result_.outcome == Overlap::touching && difference_.calls >= cap;
    if (result_.outcome == Overlap::touching && !result_.capped) ask_distance(fault);
    return result_;
  }

 private:
  /// @return false if a support function misbehaved; the outcome stays `touching` if nothing was proven
  bool walk(int cap) {
    const Real radii = difference_.radii();
    Vec3 n = difference_.centre_offset();
    const Real length = n.norm();
    n = length > 1e-100 ? Vec3(n / length) : Vec3(Vec3::unit_x());
    DifferencePoint p[4];
    Vec3 w[4];
    int count = 0;
    Real before = kInfinity;
    while (difference_.calls < cap) {
      Real value = 0;
      if (!difference_.support(n, p[count], value)) return false;
      if (value > radii + rounding_) {
        result_.outcome = Overlap::apart;
        result_.normal = n;
        result_.separation_bound = difference_.to_metres(value - radii - rounding_) + target_;
        return true;
      }
      for (int i = 0; i < count; ++i)
        if (p[i].w == p[count].w) return true;
      w[count] = p[count].w;
      ++count;
      Nearest nearest;
      nearest_voronoi_last(w, count, nearest);
      if (!nearest.inside && !(nearest.distance2 < before)) nearest_voronoi(w, count, nearest);
      Vec3 v = Vec3::zero();
      for (int i = 0; i < nearest.count; ++i) v += nearest.weight[i] * w[nearest.index[i]];
      if (v.norm() < radii - rounding_ || (nearest.inside && depth_in(w) > rounding_)) {
        write_witness(p, nearest);
        return true;
      }
      if (nearest.inside || !(nearest.distance2 < before)) return true;
      const Real d2 = nearest.direction.squared_norm();
      if (!(d2 > 0)) return true;
      before = nearest.distance2;
      n = nearest.direction / std::sqrt(d2);
      count = nearest.count;
      std::sort(nearest.index, nearest.index + count);
      for (int i = 0; i < count; ++i) p[i] = p[nearest.index[i]], w[i] = p[i].w;
    }
    return true;
  }

  void write_witness(const DifferencePoint* p, const Nearest& nearest) {
    Vec3 on_a = Vec3::zero(), on_b = Vec3::zero();
    for (int i = 0; i < nearest.count; ++i) {
      on_a += nearest.weight[i] * p[nearest.index[i]].a;
      on_b += nearest.weight[i] * p[nearest.index[i]].b;
    }
    // The cores' points are nearer to each other than the radii: a point between them, in their ratio, is in both.
    const Real a = a_.core_radius + 0.5 * target_, b = b_.core_radius + 0.5 * target_, sum = a + b;
    result_.outcome = Overlap::overlapping;
    result_.point = sum > 0 ? Vec3(on_a + (a / sum) * (frame_.apply(on_b) - on_a)) : on_a;
  }

  /// A simplex through the origin proves nothing (concentric boxes give one): the depth does.
  void ask_distance(SupportFault& fault) {
    QuerySettings settings;
    settings.tolerance = 1e-3;  // a bracket that excludes the target is enough
    for (; settings.tolerance > 1e-16; settings.tolerance *= 1e-6) {
      QueryResult found;
      generic_distance(a_, b_, frame_, settings, nullptr, found, fault);
      result_.support_calls += found.support_calls;
      if (found.status == QueryStatus::fault) {
        result_.outcome = Overlap::fault;
        return;
      }
      result_.normal = found.normal;
      if (found.lower - result_.slack > target_) {
        result_.outcome = Overlap::apart;
        result_.separation_bound = found.lower - result_.slack;
      } else if (found.upper + result_.slack < target_) {
        result_.outcome = Overlap::overlapping;
        result_.point = 0.5 * (found.point_a + frame_.apply(found.point_b));
      } else if (found.status == QueryStatus::exact_enough) {
        continue;
      }
      return;
    }
  }

  const Shape &a_, &b_;
  const Frame& frame_;
  const Real target_;
  Real rounding_ = 0;
  Difference difference_;
  OverlapResult result_;
};

std::int32_t point_support(void*, const double*, std::uint64_t, const double*, double* out) {
  out[0] = out[1] = out[2] = 0;
  return 0;
}

/// One of them is a half-space: its distance is one look away.
OverlapResult overlap_with_plane(const Shape& a, const Shape& b, const Frame& b_in_a, Real target, Real rounding,
                                 SupportFault& fault) {
  OverlapResult result;
  QueryResult found;
  distance(a, b, b_in_a, QuerySettings(), nullptr, found, fault);
  const Real more = rounding * (b_in_a.p.norm() + extent(a) + extent(b));
  result.slack = 0.5 * (found.upper - found.lower) + more;
  result.support_calls = found.support_calls;
  result.normal = found.normal;
  if (found.status == QueryStatus::fault) {
    result.outcome = Overlap::fault;
  } else if (found.lower - more > target) {
    result.outcome = Overlap::apart;
    result.separation_bound = found.lower - more;
  } else if (found.upper + more < target) {
    result.outcome = Overlap::overlapping;
    result.point = 0.5 * (found.point_a + b_in_a.apply(found.point_b));
  }
  return result;
}

}  // namespace

OverlapResult overlap(const Shape& a, const Shape& b, const Frame& b_in_a, Real target, Real rounding, int cap,
                      SupportFault& fault) {
  if (!usable(b_in_a)) return {};
  if (a.form == Form::half_space || b.form == Form::half_space)
    return overlap_with_plane(a, b, b_in_a, target, rounding, fault);
  return Search(a, b, b_in_a, target, rounding).run(cap, fault);
}

OverlapResult overlap_with_point(const Shape& shape, const Vec3& point, Real target, Real rounding, int cap,
                                 SupportFault& fault) {
  Shape dot(std::pmr::null_memory_resource());
  dot.support = point_support;
  OverlapResult result = overlap(dot, shape, Frame(Mat3::identity(), -point), target, rounding, cap, fault);
  result.point += point;
  return result;
}

}  // namespace carom::collision

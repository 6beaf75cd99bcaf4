#include "collision/hull_of.h"

#include <algorithm>

#include "collision/support.h"
#include "core/pose.h"

namespace carom::collision {
namespace {

bool is_even(const Vec3& scale) {
  const Vec3 s = scale.abs();
  return s.x() == s.y() && s.y() == s.z();
}

/// The farthest support point of the parts' cores, of equals the first.
std::int32_t farthest_of_parts(void* user, const double*, std::uint64_t, const double dir[3], double out[3]) {
  const auto& hull = *static_cast<const HullOf*>(user);
  const Vec3 given(dir[0], dir[1], dir[2]), d = given / given.abs().max_entry();
  Real farthest = -kInfinity;
  Vec3 best = Vec3::zero();
  for (const HullOf::Part& part : hull.parts) {
    const Shape& s = *part.shape;
    const Vec3 q = part.into * d;
    double x[3] = {0, 0, 0};
    if (const std::int32_t status = s.support(s.user, s.params.data(), s.params.size(), q.data(), x)) return status;
    Vec3 point(x[0], x[1], x[2]);
    if (part.round_inner > 0) point += part.round_inner * direction_of(q);
    point = part.out * point + part.position;
    if (part.round_outer > 0) point += part.round_outer * direction_of(d);
    const Real along = d.dot(point);
    if (along <= farthest) continue;
    farthest = along, best = point;
    if (!(along < kInfinity)) break;  // no number: the caller sees it
  }
  std::copy_n(best.data(), 3, out);
  return 0;
}

/// The same where all parts have corners only, which are the parameters.
std::int32_t farthest_of_corners(void*, const double* params, std::uint64_t n, const double dir[3], double out[3]) {
  const Vec3 given(dir[0], dir[1], dir[2]), d = given / given.abs().max_entry();
  Real farthest = -kInfinity;
  for (std::uint64_t i = 0; i + 3 <= n; i += 3) {
    const Real along = d.dot(Vec3::from(params + i));
    if (along > farthest) farthest = along, std::copy_n(params + i, 3, out);
  }
  return 0;
}

/// @return  0: it is round somewhere
std::size_t corners_of(const Shape& s) {
  return s.form == Form::box ? 8 : s.form == Form::polytope ? s.vertices.size() / 3 : 0;
}

void add_corners(const HullOf::Part& part, Array<double>& to) {
  const auto add = [&](const Vec3& x) {
    const Vec3 at = part.out * x + part.position;
    to.insert(to.end(), at.data(), at.data() + 3);
  };
  const Shape& s = *part.shape;
  if (s.form == Form::box)
    for (int k = 0; k < 8; ++k)
      add(Vec3(k & 1 ? s.half.x() : -s.half.x(), k & 2 ? s.half.y() : -s.half.y(), k & 4 ? s.half.z() : -s.half.z()));
  else
    for (std::size_t i = 0; i < s.vertices.size(); i += 3) add(Vec3::from(&s.vertices[i]));
}

}  // namespace

void make_hull_of(std::span<const Shape* const> parts, std::span<const double> numbers, Memory* memory, Shape& shape) {
  auto hull = std::allocate_shared<HullOf>(std::pmr::polymorphic_allocator<HullOf>(memory), memory);
  hull->numbers.assign(numbers.begin(), numbers.end());
  Real common = kInfinity;  // m: every part is some core swollen by this
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double* const x = &numbers[1 + HullOf::kNumbers * i];
    const Mat3 turn = Quat(x[6], x[3], x[4], x[5]).normalized().matrix();
    const Vec3 scale = Vec3::from(x + 7);
    const bool even = is_even(scale);
    const Mat3 out = scale_columns(turn, scale);
    hull->parts.push_back({parts[i], out.transpose(), out, Vec3::from(x), even ? 0 : parts[i]->core_radius,
                           even ? parts[i]->core_radius * std::fabs(scale.x()) : 0});
    common = std::min(common, hull->parts.back().round_outer);
    shape.host_thread |= parts[i]->host_thread;
    const HullOf* const inner = parts[i]->hull_of.get();
    hull->calls += inner ? inner->calls : 1;
    if (inner) hull->depth = std::max(hull->depth, inner->depth + 1);
  }
  for (HullOf::Part& part : hull->parts) part.round_outer -= common;
  shape.core_radius = numbers[0] + common;
  shape.support = farthest_of_parts, shape.user = hull.get();
  std::size_t corners = 0;
  for (const Shape* part : parts) corners += corners_of(*part);
  if (corners <= HullOf::kMostCorners &&
      std::ranges::all_of(parts, [](const Shape* s) { return corners_of(*s) > 0; })) {
    shape.params.reserve(3 * corners);
    for (const HullOf::Part& part : hull->parts) add_corners(part, shape.params);
    shape.support = farthest_of_corners, shape.user = nullptr;
    if (shape.core_radius == 0) shape.form = Form::polytope, shape.vertices = shape.params;
  }
  shape.hull_of = std::move(hull);
}

}  // namespace carom::collision

// Bytes to a pair: most inputs are valid and structured (features aligned, touching, nested), a few are raw or garbage.
#include <algorithm>
#include <limits>

#include "bytes.h"
#include "pair_case.h"

namespace carom::fuzz {
namespace {

/// A length of about 1: a round number, any number, a small one, a needle's.
double length(Bytes& in) {
  const unsigned style = in.byte();
  switch (style & 3) {
    case 0:
      return 0.25 * (1 + (style >> 2) % 4);
    case 1:
      return 0.25 + 0.75 * in.unit();
    case 2:
      return in.any_order(-10, 0);
    default:
      return (style >> 2) & 1 ? in.any_order(-27, 0) : 1;
  }
}

/// Moves a point by a unit in the last place now and then.
double nudge(Bytes& in, double x) {
  const int choice = in.below(4);
  return choice == 0 ? std::nextafter(x, 1e300) : choice == 1 ? std::nextafter(x, -1e300) : x;
}

void cloud(Bytes& in, double size, std::vector<double>& out) {
  const unsigned many = in.byte();
  const int count = many >= 252 ? 40 + 16 * in.below(12) : 1 + static_cast<int>(many) % 14, style = in.below(8);
  double half[3] = {size * length(in), size * length(in), size * length(in)};
  const double slope_x = in.both_signs(), slope_y = in.both_signs();
  std::uint64_t state = in.byte() * 0x9E3779B97F4A7C15ull + 1;
  const auto coordinate = [&] {
    if (many < 252) return in.both_signs();
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(static_cast<std::int64_t>(state)) * 0x1p-63;
  };
  if (style == 3) half[1] = 0;            // flat
  if (style == 4) half[0] = half[2] = 0;  // a line
  out.clear();
  for (int i = 0; i < count; ++i) {
    double x[3] = {coordinate(), coordinate(), coordinate()};
    if (style == 1 || style == 2) {  // on an ellipsoid
      const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      for (double& v : x) v = norm > 0 ? v / norm : 0;
    }
    if (style == 5)  // a lattice: equal, collinear and coplanar points
      for (double& v : x) v = std::floor(2 * v + 0.5) * 0.5;
    for (int k = 0; k < 3; ++k) x[k] *= half[k];
    if (style == 6) x[1] = slope_x * x[0] + slope_y * x[2];  // coplanar but for rounding
    if (style == 7 && i > 0)                                 // some points twice, or an ulp aside
      if (in.byte() & 1)
        for (int k = 0; k < 3; ++k) x[k] = nudge(in, out[out.size() - 3]);
    out.insert(out.end(), x, x + 3);
  }
  if (!in.one_in(4)) return;
  const double aside[3] = {4 * size * in.both_signs(), 4 * size * in.both_signs(), 4 * size * in.both_signs()};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += aside[i % 3];
}

void shape(Bytes& in, double size, ShapeSpec& s) {
  static constexpr Kind kKinds[] = {Kind::sphere,    Kind::capsule, Kind::box,  Kind::cylinder, Kind::cone,
                                    Kind::ellipsoid, Kind::hull,    Kind::hull, Kind::top,      Kind::box};
  s.kind = kKinds[in.below(10)];
  const unsigned flags = in.byte();
  s.declared = (flags & 7) != 7;
  s.swell = (flags >> 3 & 7) == 7 ? size * in.any_order(-20, 1) : 0;
  s.lie = Lie::none;
  s.params.clear();
  switch (s.kind) {
    case Kind::sphere:
      s.params = {size * length(in)};
      break;
    case Kind::capsule:
    case Kind::cylinder:
    case Kind::cone:
    case Kind::top:
      for (int i = 0; i < 2; ++i) s.params.push_back(size * length(in));
      break;
    case Kind::hull:
      cloud(in, size, s.params);
      break;
    default:
      for (int i = 0; i < 3; ++i) s.params.push_back(size * length(in));
  }
  if (flags >= 252 && s.kind == Kind::box) s.lie = static_cast<Lie>(in.below(static_cast<int>(Lie::count)));
}

Vec3 direction(Bytes& in) {
  const Vec3 v(in.both_signs(), in.both_signs(), in.both_signs());
  const Real norm = v.norm();
  return norm > 0 ? Vec3(v / norm) : Vec3(Vec3::unit_y());
}

/// Any attitude, a quarter turn, or a quarter turn tilted by little.
Mat3 rotation(Bytes& in) {
  const unsigned style = in.byte();
  if (style % 4 == 0) return Mat3::identity();
  if (style % 4 == 1) {
    const Quat q(in.both_signs(), in.both_signs(), in.both_signs(), in.both_signs());
    return normalized(q).matrix();
  }
  const unsigned turn = in.byte();
  Mat3 r = Mat3::zero();  // a signed permutation with determinant 1
  const int i = static_cast<int>(turn) % 3, j = (i + 1 + static_cast<int>(turn / 3) % 2) % 3, k = 3 - i - j;
  r(0, i) = turn & 64 ? -1 : 1;
  r(1, j) = turn & 128 ? -1 : 1;
  r.row(2).set_zero();
  r(2, k) = r.row(0).cross(r.row(1))[k];
  if (style % 4 == 2) return r;
  return exp_map(in.any_order(-54, 0) * direction(in)).matrix() * r;
}

Vec3 special_direction(Bytes& in, const Mat3& r) {
  const unsigned choice = in.byte();
  const int axis = static_cast<int>(choice >> 4) % 3;
  const Real sign = choice & 128 ? -1 : 1;
  switch (choice % 5) {
    case 0:
      return sign * Vec3::unit(axis);
    case 1:
      return sign * r.col(axis);
    case 2: {
      const Vec3 across = Vec3::unit(axis).cross(r.col((axis + 1) % 3));
      return sign * (across / across.abs().max_entry()).normalized();  // however short
    }
    case 3:
      return Vec3(sign, choice & 64 ? 1 : -1, choice & 32 ? 1 : -1) / std::sqrt(3.0);
    default:
      return direction(in);
  }
}

/// Lowest value of n . w over the difference B - A, core radii taken off: what the direction n alone says.
Real bound(const Shape& a, const Shape& b, const Frame& f, const Vec3& n) {
  const Vec3 n_b = -f.rotate_inverse(n);
  Vec3 on_a, on_b;
  a.support(a.user, a.params.data(), a.params.size(), n.data(), on_a.data());
  b.support(b.user, b.params.data(), b.params.size(), n_b.data(), on_b.data());
  return n.dot(f.apply(on_b) - on_a) - a.core_radius - b.core_radius;
}

Vec3 position(Bytes& in, const Shape& a, const Shape& b, const Mat3& r) {
  const Real size = a.bounding_radius + b.bounding_radius;
  const unsigned style = in.byte();
  Vec3 p = Vec3::zero();
  switch (style % 8) {
    case 0:
      break;  // concentric
    case 1:
      p = size * Vec3(in.both_signs(), in.both_signs(), in.both_signs());
      break;
    case 2:
      p = size * in.any_order(-52, -4) * direction(in);
      break;
    case 3:
      p = size * in.any_order(0, 30) * direction(in);
      break;
    default: {  // face to face, edge to edge, vertex to vertex or almost: a gap along a direction
      const Vec3 n = special_direction(in, r);
      if (style & 8) p = size * Vec3(in.both_signs(), in.both_signs(), in.both_signs());
      if (style & 16) p[in.below(3)] = 0;
      const Real gap = style & 32 ? (style & 64 ? -1 : 1) * size * in.any_order(-56, -1) : 0;
      p += (gap - bound(a, b, Frame(r, p), n)) * n;
    }
  }
  if (style >= 232) {  // what is left of it when both bodies are far from the origin
    const Vec3 far = size * in.any_order(4, 40) * direction(in);
    p = (far + p) - far;
  }
  return p;
}

void garbage(Bytes& in, Frame& f) {
  static constexpr Real kBad[] = {std::numeric_limits<Real>::quiet_NaN(), kInfinity, -kInfinity, 1e300, -1e120, 1e-320};
  const int where = in.below(12);
  const Real bad = kBad[in.below(where < 3 ? 6 : 5)];  // the last makes of a matrix another one, not garbage
  (where < 3 ? f.p[where] : f.r((where - 3) / 3, where % 3)) = bad;
}

void settings(Bytes& in, Real least, QuerySettings& s) {
  s = QuerySettings();
  const unsigned flags = in.byte();
  s.simplex = static_cast<Simplex>(flags % 3);
  s.routines = !(flags & 64);
  if (in.byte() & 1) s.tolerance = in.any_order(-54, -2);
  if (flags >= 224) {
    s.method = Method::hybrid;
    s.margin = least * in.any_order(-30, 1);
  }
  const unsigned limits = in.byte();
  if (limits % 4 == 0) s.gjk_cap = 1 + static_cast<int>(limits / 4);
  if (limits % 4 == 1) s.epa_cap = 1 + static_cast<int>(limits / 4) * 8;
  if (limits % 16 == 2) s.max_distance = least * in.any_order(-20, 10);
}

}  // namespace

void decode(const std::uint8_t* bytes, std::size_t size, PairCase& out) {
  Bytes in(bytes, size);
  const unsigned kind = in.byte();
  out.twist = static_cast<Twist>(kind % static_cast<unsigned>(Twist::count));
  out.sweep = in.byte() | in.byte() << 8;
  const unsigned sizes = in.byte();
  const double size_a = sizes & 1 ? 1 : in.any_order(-20, 21);
  const double size_b = sizes & 2 ? size_a : size_a * in.any_order(sizes & 4 ? -24 : -3, sizes & 4 ? 24 : 4);
  shape(in, size_a, out.a);
  shape(in, std::clamp(size_b, 0x1p-30, 0x1p30), out.b);
  const Shape a = make(out.a), b = make(out.b);
  Mat3 r = rotation(in);
  out.b_in_a = Frame(r, position(in, a, b, r));
  out.next = out.b_in_a;
  const Real reach = a.bounding_radius + b.bounding_radius;
  settings(in, std::min(a.bounding_radius, b.bounding_radius), out.settings);
  if (out.twist == Twist::warm) {  // as a step would move it
    out.next.p += reach * in.any_order(-30, -2) * direction(in);
    out.next.r = exp_map(in.any_order(-30, -1) * direction(in)).matrix() * r;
  }
  if (out.twist == Twist::warm_far) {
    r = rotation(in);
    out.next = Frame(r, position(in, a, b, r));
  }
  const unsigned rare = in.byte();
  if (rare == 253) garbage(in, out.b_in_a);
  if (rare < 254) return;
  // The half-space as B.
  const Vec3 n = special_direction(in, Mat3::identity());
  out.b.kind = Kind::half_space;
  out.b.swell = 0;
  out.b.lie = Lie::none;
  out.b.params = {n.x(), n.y(), n.z(), reach * in.both_signs()};
}

}  // namespace carom::fuzz

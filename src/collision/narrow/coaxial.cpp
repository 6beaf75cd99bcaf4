// EPA in a half-plane, and who may be revolved.
#include "collision/narrow/coaxial.h"

#include <algorithm>

namespace carom::collision {

namespace {

constexpr Real kSideways = 1e-6;  // sine from the axis below which a direction has no side
constexpr Real kMostTilt = 1e-2;  // rad: more is no common axis, however small the shape that is tilted
// rad: looks at the rims of flat ends lean by this, or by the root of the axes' tilt t, where that is more: they miss
// the side meant by t / sqrt(t), the rim's height along the side by t / 2 of its radius, which unevenness allows for.
constexpr Real kLean = 1e-4;
// rad: looks at both sides of a pole lean by no more than they must, for they lower the pole of a ball, if by 5e-19 of
// its radius.
constexpr Real kPoleLean = 1e-9;

/// Which of a shape's axes it may be turned about: 0 to 2, 3 for all, -1 for none.
int axis_of_revolution(const Shape& s) {
  switch (s.form) {
    case Form::sphere:
      return 3;
    case Form::capsule:
    case Form::cylinder:
    case Form::cone:
      return 1;
    case Form::ellipsoid: {
      const bool xy = s.half.x() == s.half.y(), yz = s.half.y() == s.half.z(), zx = s.half.z() == s.half.x();
      return xy && yz ? 3 : (zx ? 1 : (yz ? 0 : (xy ? 2 : -1)));
    }
    default:
      return -1;
  }
}

/// The corners of the profile in a half-plane (r, y), from the upper pole, on the axis, to the lower, and the edges
/// between neighbours.
class Profile {
 public:
  struct Corner {
    Real r, y;
    DifferencePoint point;
    int next;     // towards the lower end; -1 there
    Real offset;  // of the edge to next: the smaller of its ends' along its normal
    Real nr, ny;  // unit normal of that edge, outwards
  };

  int add(const DifferencePoint& point, const Vec3& axis) {
    Corner& c = corner_[used_];
    c.point = point;
    c.y = axis.dot(point.w);
    c.r = (point.w - c.y * axis).norm();
    c.next = -1;
    return used_++;
  }
  /// The pole at the height of a point: where that is off the axis, so are all around the axis, and the pole is
  /// between.
  void add_pole(const DifferencePoint& point, const Vec3& axis) { corner_[add(point, axis)].r = 0; }
  /// @return false if the two corners are one, to rounding: the edge between would look anywhere
  bool join(int from, int to, Real rounding) {
    Corner &a = corner_[from], &b = corner_[to];
    const Real dr = b.r - a.r, dy = b.y - a.y, length = std::sqrt(dr * dr + dy * dy);
    if (!(length > rounding)) return false;
    a.next = to;
    a.nr = -dy / length;
    a.ny = dr / length;
    a.offset = std::min(a.nr * a.r + a.ny * a.y, a.nr * b.r + a.ny * b.y);
    return true;
  }
  /// The edge nearest to the origin; -1 if there is none.
  int nearest() const {
    int best = -1;
    for (int i = 0; i < used_; ++i)
      if (corner_[i].next >= 0 && (best < 0 || corner_[i].offset < corner_[best].offset)) best = i;
    return best;
  }
  const Corner& operator[](int i) const { return corner_[i]; }
  int used() const { return used_; }

 private:
  Corner corner_[kMaxEpaIterations + 5];
  int used_ = 0;
};

/// A point of the profile, with its share, as points of the difference. A pole is its own point, or, on a flat end,
/// where that may lie anywhere, halfway between two points of the rim.
bool write_corner(Difference& difference, const Profile::Corner& corner, const Vec3& up, const Vec3& aside, Real slop,
                  Real tilt, Real share, DifferenceSimplex& simplex) {
  const auto put = [&](const DifferencePoint& point, Real weight) {
    simplex.point[simplex.count] = point;
    simplex.weight[simplex.count++] = weight;
  };
  const Real rounding = difference.rounding();
  if (corner.r > 0 || (corner.point.w - corner.y * up).norm() <= rounding) {
    put(corner.point, share);
    return true;
  }
  const Vec3 pole = corner.y > 0 ? up : Vec3(-up), lean = std::max(kPoleLean, std::sqrt(tilt)) * aside;
  DifferencePoint rim[2];
  Real value = 0;
  if (!difference.support(-(pole + lean).normalized(), rim[0], value) ||
      !difference.support(-(pole - lean).normalized(), rim[1], value))
    return false;
  // Lower than the pole: a cap so curved that what was found along the axis is nearer to it.
  const Real height = 0.5 * up.dot(rim[0].w + rim[1].w);
  if (std::fabs(height - corner.y) > 4 * rounding + slop) {
    put(corner.point, share);
    return (corner.point.w - corner.y * up).squared_norm() <= rounding;
  }
  put(rim[0], 0.5 * share);
  put(rim[1], 0.5 * share);
  return true;
}

}  // namespace

Axis common_axis(const Shape& a, const Shape& b, const Frame& b_in_a) {
  const int of_a = axis_of_revolution(a), of_b = axis_of_revolution(b);
  Axis axis;
  if (of_a < 0 || of_b < 0) return axis;
  if (of_a == 3 && of_b == 3) {
    const Real apart = b_in_a.p.norm();
    if (apart > 0) axis.along = b_in_a.p / apart;
    axis.uneven = 0;
    return axis;
  }
  const Vec3 from_b = b_in_a.r.col(of_b == 3 ? 0 : of_b);
  axis.along = of_a == 3 ? Vec3(from_b / from_b.norm()) : Vec3(Vec3::unit(of_a));
  Real tilt = 0;  // 2 sin of half the angle between the axes
  if (of_a != 3 && of_b != 3) {
    const Real same_way = from_b.dot(axis.along) < 0 ? -1 : 1;
    tilt = (from_b - same_way * axis.along).norm();
  }
  axis.tilt = tilt;
  const Real aside = (b_in_a.p - b_in_a.p.dot(axis.along) * axis.along).norm();
  if (tilt < kMostTilt) axis.uneven = aside + tilt * b.bounding_radius;
  return axis;
}

EpaEnd coaxial(Difference& difference, const Axis& axis, Real gap, int cap, DifferenceSimplex& simplex,
               int& iterations) {
  const Vec3& up = axis.along;
  const Real slop = 2 * difference.to_scaled(axis.uneven);
  // Of the ring, the point on the side that was looked along so far: bound, normal and witness then belong together.
  const Vec3 across = difference.normal().dot(up) * up - difference.normal();
  const Real length = across.norm();
  const Vec3 aside = length > kSideways ? Vec3(across / length) : any_perpendicular(up);
  // Of a flat end every point supports: a look that far from the axis finds the rim on this side, on both shapes.
  const Real lean = std::max(kLean, std::sqrt(axis.tilt));
  const Vec3 looks[] = {up, (up + lean * aside).normalized(), aside, (-up + lean * aside).normalized(), -up};
  constexpr int kLast = 4;
  const Real lower = difference.lower, upper = difference.upper;
  const Vec3 normal = difference.normal();
  const auto nothing = [&] {  // what was proved goes with what proved it
    difference.set_lower(lower, normal);
    difference.upper = upper;
    return EpaEnd::flat;
  };
  Profile profile;
  DifferencePoint point;
  Real value = 0;
  for (int i = 0; i <= kLast; ++i) {
    if (!difference.support(-looks[i], point, value)) return EpaEnd::fault;
    if (i == 0 || i == kLast)
      profile.add_pole(point, up);
    else
      profile.add(point, up);
  }
  if (difference.lower > difference.rounding()) return EpaEnd::apart;
  const Real same = 4 * difference.rounding() + slop;
  for (int i = 1, last = 0; i <= kLast; ++i)
    if (profile.join(last, i, same)) last = i;
  EpaEnd end = EpaEnd::narrow;
  Real inside = 0;
  for (;;) {
    const int at = profile.nearest();
    if (at < 0) return nothing();
    const Profile::Corner edge = profile[at];
    inside = edge.offset - slop;
    if (!(inside > difference.rounding())) return nothing();
    difference.upper = std::min(difference.upper, std::max(-inside, difference.lower));
    if (difference.upper - difference.lower <= gap) break;
    if (iterations >= cap) {
      end = EpaEnd::capped;
      break;
    }
    ++iterations;
    if (!difference.support(-(edge.nr * aside + edge.ny * up).normalized(), point, value)) return EpaEnd::fault;
    if (difference.lower > difference.rounding()) return EpaEnd::apart;
    const int fresh = -value - edge.offset > difference.rounding() ? profile.add(point, up) : -1;
    if (fresh < 0 || !profile.join(at, fresh, same) || !profile.join(fresh, edge.next, same)) {
      end = EpaEnd::stuck;
      break;
    }
  }
  if (difference.upper < -inside) return nothing();  // known better before, by other points

  // The witness: the point of the profile nearest to where the shortest way out ends.
  const Vec3 out = difference.lower * difference.normal();
  const Real r = aside.dot(out), y = up.dot(out);
  int from = 0;
  Real least = kInfinity, share = 0;
  for (int i = 0; i < profile.used(); ++i) {
    if (profile[i].next < 0) continue;
    const Profile::Corner &a = profile[i], &b = profile[a.next];
    const Real er = b.r - a.r, ey = b.y - a.y, along = (r - a.r) * er + (y - a.y) * ey;
    const Real t = along > 0 ? std::min(along / (er * er + ey * ey), Real(1)) : 0;
    const Real dr = a.r + t * er - r, dy = a.y + t * ey - y, d2 = dr * dr + dy * dy;
    if (!(d2 < least)) continue;
    least = d2;
    from = i;
    share = t;
  }
  simplex.count = 0;
  const auto write = [&](int i, Real weight) {
    return write_corner(difference, profile[i], up, aside, slop, axis.tilt, weight, simplex);
  };
  const bool written = write(from, 1 - share) && write(profile[from].next, share);
  if (difference.fault.kind != SupportFault::none) return EpaEnd::fault;
  Vec3 witness = Vec3::zero();
  for (int i = 0; i < simplex.count; ++i) witness += simplex.weight[i] * simplex.point[i].w;
  // The pair is one of revolution only nearly: its own points must lie where the bracket says, or EPA has to find some.
  const Real off = std::fabs(difference.normal().dot(witness) - difference.lower);
  return written && off <= difference.upper - difference.lower + difference.rounding() ? end : nothing();
}

}  // namespace carom::collision

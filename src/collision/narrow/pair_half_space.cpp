// The half-space against everything: whichever points of the other shape lie deepest, in closed form where there is
// one.
#include <algorithm>
#include <array>

#include "collision/narrow/pair.h"
#include "collision/support.h"

namespace carom::collision {
namespace {

// How far to the side a point must lie to be worth its height (rise per run; 3 degrees): among the points near a plane,
// those asked for are the extreme ones along directions tilted by this from the normal. Steeper: points that do not
// carry. Flatter: a jitter in tilt makes the patch collapse to an edge.
constexpr Real kPlaneTilt = 0.05;
// Azimuths of those directions: equally spaced, so that a corner of a right angle or less can't hide between two of
// them, and turned by 0.1 rad, so that on shapes built along their axes no two corners tie.
constexpr Real kSeven[7][2] = {
    {0.99500416527802582, 0.099833416646828155}, {0.54232204172097276, 0.84017069876519468},
    {-0.31873964060555959, 0.94784230835442174}, {-0.9397838724523413, 0.34176932729325132},
    {-0.85315168024512755, -0.5216629280434979}, {-0.12407887169061955, -0.99227235857902585},
    {0.69842785799464857, -0.71568046443717259}};
constexpr Real kFour[4][2] = {{0.99500416527802582, 0.099833416646828155},
                              {-0.099833416646828183, 0.99500416527802571},
                              {-0.99500416527802582, -0.099833416646828113},
                              {0.099833416646827614, -0.99500416527802582}};
constexpr Real kThree[3][2] = {{0.99500416527802571, 0.099833416646828155},
                               {-0.58396035760176192, 0.8117821756786868},
                               {-0.41104380767626379, -0.91161559232551507}};

/// The half-space's plane in the other shape's frame; points of that shape become contacts against it.
struct Plane {
  Vec3 n;       // unit, out of the half-space
  Real offset;  // m: height of x is n . x - offset
  const Vec3& normal;
  const Frame& b_in_a;
  Real reach;
  Candidates& found;

  Plane(const Shape& half_space, const Frame& frame, Real limit, Candidates& out)
      : n(frame.rotate_inverse(half_space.normal)),
        offset(half_space.offset - half_space.normal.dot(frame.p)),
        normal(half_space.normal),
        b_in_a(frame),
        reach(limit),
        found(out) {
    found.gap = kInfinity;  // until a point is looked at
  }

  Real height(const Vec3& x) const { return n.dot(x) - offset; }
  void add(const Vec3& x, std::uint32_t feature) const {
    const Real h = height(x);
    found.gap = std::min(found.gap, h);
    if (h <= reach) add_contact(found, reach, b_in_a.apply(x) - h * normal, x, normal, h, feature);
  }
};

/// A rim around y is level below this tilt (rad): four points in fixed directions are then as good as the deepest and
/// three beside it, to 3e-6 of its radius. Those of a coin that slides would turn with what it tips by, 1e-8 rad, which
/// is across its way: friction of four points is not the same in all directions.
constexpr Real kLevel = 1e-5;

Real across_y(const Vec3& n) { return std::sqrt(n.x() * n.x() + n.z() * n.z()); }
/// The direction across y in which a rim around y dips deepest; x where it is level.
Vec3 down_rim(const Vec3& n) {
  const Real across = across_y(n);
  return across > kLevel ? Vec3(-n.x() / across, 0, -n.z() / across) : Vec3(Vec3::unit_x());
}

/// Points of a rim of given radius at height y. Of one that is steeper than 45 degrees the deepest alone: others are in
/// the air, and what rolls does not come to stand on them, however far it turns in a step. Else four: the deepest
/// first, or where it is level in fixed directions, the deepest of them sunk to where the rim is deepest, so that the
/// distance is that of the rim.
void add_rim(const Plane& plane, Real radius, Real y, const Vec3& down) {
  const Vec3 side(down.z(), 0, -down.x());
  const Vec3 way[4] = {down, side, -down, -side};
  const Real across = across_y(plane.n);
  int deepest = 0;
  for (int k = 1; k < 4; ++k)
    if (plane.n.dot(way[k]) < plane.n.dot(way[deepest])) deepest = k;
  const int count = across * across > 0.5 ? 1 : 4;
  for (int k = 0; k < count; ++k) {
    Vec3 x = Vec3(0, y, 0) + radius * way[k];
    if (k == deepest && across <= kLevel) x -= radius * (plane.n.dot(way[k]) + across) * plane.n;
    plane.add(x, static_cast<std::uint32_t>(k + 1));
  }
}

}  // namespace

void contact_half_space_sphere(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  plane.add(-b.radius * plane.n, 1);
  found.whole = true;
}

void contact_half_space_capsule(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  for (const Real end : {b.half_height, -b.half_height})
    plane.add(Vec3(0, end, 0) - b.radius * plane.n, end > 0 ? 1 : 2);
  found.whole = true;
}

void contact_half_space_box(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  // The four corners of the face that looks down most: the deepest corner is one of them, and the corners above carry
  // nothing even where a box thinner than the reach brings them near.
  const int face = plane.n.abs().max_axis();
  Vec3 x;
  x[face] = plane.n[face] > 0 ? -b.half[face] : b.half[face];
  const int u = face == 2 ? 0 : face + 1, v = u == 2 ? 0 : u + 1;
  for (std::uint32_t c = 0; c < 4; ++c) {
    x[u] = c & 1 ? -b.half[u] : b.half[u];
    x[v] = c & 2 ? -b.half[v] : b.half[v];
    std::uint32_t corner = 0;  // the same name whichever face it is reached through
    for (int k = 0; k < 3; ++k) corner = corner * 2 + (x[k] < 0);
    plane.add(x, corner + 1);
  }
  found.whole = true;
}

void contact_half_space_cylinder(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  const Vec3 down = down_rim(plane.n);
  const Real bottom = plane.n.y() > 0 ? -b.half_height : b.half_height;
  add_rim(plane, b.radius, bottom, down);
  found.on_rim = found.count == 4;
  plane.add(Vec3(0, -bottom, 0) + b.radius * down, 5);  // the other end of the line it lies on
  found.whole = true;
}

void contact_half_space_cone(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  plane.add(Vec3(0, b.half_height, 0), 5);
  add_rim(plane, b.radius, -b.half_height, down_rim(plane.n));
  found.on_rim = found.count == 4 && found.point[0].feature == 1;
  found.whole = true;
}

void contact_half_space_ellipsoid(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  const auto add = [&](const Vec3& out, std::uint32_t feature) {
    const Vec3 scaled = b.half.times(out);
    plane.add(b.half.times(scaled / scaled.norm()), feature);
  };
  add(-plane.n, 1);
  found.whole = true;
  if (found.count == 0 || reach == kInfinity) return;
  // A flat one rocks from end to end within a step. Three and the deepest: a manifold keeps them all.
  const Vec3 e1 = any_perpendicular(plane.n), e2 = plane.n.cross(e1);
  for (std::uint32_t k = 0; k < 3; ++k)
    add(leaning_tilt(b, reach) * (kThree[k][0] * e1 + kThree[k][1] * e2) - plane.n, k + 2);
}

namespace {

/// Which vertices within reach are extreme straight down and in seven azimuths, each weighed by its height at a tilt.
struct Extremes {
  static constexpr int kWays = Candidates::kMax;  // way 0: straight down
  std::array<Real, kWays> most;
  std::array<std::size_t, kWays> which{};

  Extremes(const Plane& plane, const Shape& b, Real tilt) {
    const Vec3 e1 = any_perpendicular(plane.n), e2 = plane.n.cross(e1);
    most.fill(-kInfinity);
    std::array<Vec3, kWays> way;
    way[0] = -plane.n;
    for (int k = 1; k < kWays; ++k) way[k] = tilt * (kSeven[k - 1][0] * e1 + kSeven[k - 1][1] * e2) - plane.n;
    const double* v = b.vertices.data();
    const std::size_t count = b.vertices.size() / 3;
    for (std::size_t i = 0; i < count; ++i, v += 3) {
      const Vec3 x(v[0], v[1], v[2]);
      const Real h = plane.height(x);
      plane.found.gap = std::min(plane.found.gap, h);
      if (!(h <= plane.reach)) continue;
      for (int k = 0; k < kWays; ++k) {
        const Real s = way[k].dot(x);
        if (s > most[k]) most[k] = s, which[k] = i;
      }
    }
  }
  bool any() const { return most[0] > -kInfinity; }
  void add(const Plane& plane, const Shape& b) const {
    for (const std::size_t i : which) {
      const auto name = static_cast<std::uint32_t>(i) + 1;
      const auto same = [&](const ContactPoint& p) { return p.feature == name; };
      if (std::any_of(plane.found.point, plane.found.point + plane.found.count, same)) continue;
      const double* x = b.vertices.data() + 3 * i;
      plane.add(Vec3(x[0], x[1], x[2]), name);
    }
  }
};

}  // namespace

/// All vertices are looked at once, which is what a single support call of theirs costs; of one that leans, once more.
void contact_half_space_polytope(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Plane plane(a, b_in_a, reach, found);
  found.whole = true;
  const Extremes flat(plane, b, kPlaneTilt);
  if (!flat.any()) return;
  flat.add(plane, b);
  // On a corner or an edge: the far side may come down within the step.
  if (found.count < 3 && reach < kInfinity) Extremes(plane, b, leaning_tilt(b, reach)).add(plane, b);
}

bool half_space_by_support(const Shape& half_space, const Shape& b, const Frame& b_in_a, Real reach, bool probe,
                           Real lean, Candidates& found, std::uint64_t& calls, SupportFault& fault) {
  const Plane plane(half_space, b_in_a, reach, found);
  const Vec3 e1 = any_perpendicular(plane.n), e2 = plane.n.cross(e1);
  const int before = found.count;
  for (int k = 0; k <= (lean > 0 ? 8 : probe ? 4 : 0); ++k) {
    Vec3 dir = -plane.n;
    if (k > 0) dir += (k <= 4 ? kPlaneTilt : lean) * (kFour[(k - 1) % 4][0] * e1 + kFour[(k - 1) % 4][1] * e2);
    dir /= dir.norm();
    Vec3 x;
    ++calls;
    if (!full_support(b, dir, x, fault)) {
      found.count = before;
      return false;
    }
    if (k == 0) found.gap = plane.height(x);
    if (k == 0 && !(found.gap <= reach)) return true;  // the deepest point is out of reach, so are all
    const auto same = [&](int i) {
      return (found.point[i].on_b - x).squared_norm() <= 1e-20 * b.bounding_radius * b.bounding_radius;
    };
    bool known = false;
    for (int i = before; i < found.count; ++i) known |= same(i);
    if (!known) plane.add(x, 0);
  }
  return true;
}

}  // namespace carom::collision

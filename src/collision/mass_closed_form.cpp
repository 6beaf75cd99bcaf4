// Volume, centre and inertia of the closed forms: the textbook's, at unit density, about the centroid.

#include "collision/hull.h"
#include "collision/volume.h"
#include "core/sum.h"

namespace carom::collision {

namespace {

constexpr Real kPi = 3.14159265358979323846;

MassProperties exact(Real volume, const Vec3& centroid, const Vec3& diagonal) {
  MassProperties m;
  m.volume = m.volume_min = m.volume_max = volume;
  m.centroid = centroid;
  m.inertia = Mat3::diagonal(volume * diagonal);
  m.exact = true;
  return m;
}

/// Two half balls of radius r, pushed h apart from the middle, and the cylinder between them.
///   a half ball about its own centroid: 83/320 m r^2, that centroid 3/8 r above its disc
MassProperties capsule(Real r, Real h) {
  const Real barrel = kPi * r * r * 2 * h, ball = 4 * kPi / 3 * r * r * r;
  const Real offset = h + 3 * r / 8;
  const Real across = barrel * (r * r / 4 + h * h / 3) + ball * (83 * r * r / 320 + offset * offset);
  const Real along = barrel * r * r / 2 + ball * 2 * r * r / 5;
  MassProperties m = exact(barrel + ball, Vec3::zero(), Vec3::zero());
  m.inertia = Mat3::diagonal(Vec3(across, along, across));
  return m;
}

/// Signed tetrahedra from a point to every triangle of the hull. For a tetrahedron (0, a, b, c) of volume V
///   integral of x     = V/4 s,                             s = a + b + c
///   integral of x x^T = V/20 (a a^T + b b^T + c c^T + s s^T)
/// Summed in the frame in which the hull was found, where no determinant cancels (a needle of aspect 1e8 that lies
/// across the axes would lose all digits); twice, the second time about the centroid, so that nothing cancels in the
/// inertia either.
MassProperties polytope(std::span<const double> vertices, Memory* memory) {
  Array<std::uint32_t> triangles(memory);
  MassProperties m;
  m.exact = true;
  if (vertices.size() < 3) return m;
  const auto vertex = [&](std::uint32_t i) { return Vec3(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]); };
  m.centroid = vertex(0);
  FitFrame frame;
  if (!convex_hull(vertices, triangles, &frame)) return m;
  Vec3 origin = Vec3::zero();  // y
  for (const std::uint32_t i : triangles) origin += frame.map(vertex(i)) / static_cast<Real>(triangles.size());
  Real volume = 0;
  Mat3 second;
  for (int pass = 0; pass < 2; ++pass) {
    Sum<Real> volumes(0);
    Sum<Vec3> firsts(Vec3::zero());
    Sum<Mat3> seconds(Mat3::zero());
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      const Vec3 a = frame.map(vertex(triangles[t])) - origin, b = frame.map(vertex(triangles[t + 1])) - origin,
                 c = frame.map(vertex(triangles[t + 2])) - origin, s = a + b + c;
      const Real v = a.dot(b.cross(c)) / 6;
      volumes.add(v);
      firsts.add(v / 4 * s);
      seconds.add(v / 20 * (outer(a, a) + outer(b, b) + outer(c, c) + outer(s, s)));
    }
    volume = volumes.value();
    second = seconds.value();
    origin += firsts.value() / volume;
  }
  m.volume = m.volume_min = m.volume_max = volume * frame.determinant;
  m.centroid = frame.origin + frame.from * origin;
  const Mat3 x = frame.determinant * (frame.from * second * frame.from.transpose()), turned = (x + x.transpose()) / 2;
  m.inertia = turned.trace() * Mat3::identity() - turned;
  return m;
}

}  // namespace

MassProperties mass_from_form(Form form, Real radius, Real half_height, const Vec3& half,
                              std::span<const double> vertices, Memory* memory) {
  const Real r2 = radius * radius, h2 = half_height * half_height;
  const Vec3 s = half.times(half);
  const Vec3 across(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
  const Real product = half.x() * half.y() * half.z();
  switch (form) {
    case Form::sphere:
      return exact(4 * kPi / 3 * r2 * radius, Vec3::zero(), Vec3::constant(2 * r2 / 5));
    case Form::capsule:
      return capsule(radius, half_height);
    case Form::box:
      return exact(8 * product, Vec3::zero(), across / 3);
    case Form::polytope:
      return polytope(vertices, memory);
    case Form::cylinder: {
      const Real transverse = r2 / 4 + h2 / 3;
      return exact(kPi * r2 * 2 * half_height, Vec3::zero(), Vec3(transverse, r2 / 2, transverse));
    }
    case Form::cone: {  // centroid a quarter of the height above the base
      const Real transverse = 3 * (r2 + h2) / 20;
      return exact(kPi * r2 * 2 * half_height / 3, Vec3(0, -half_height / 2, 0),
                   Vec3(transverse, 3 * r2 / 10, transverse));
    }
    case Form::ellipsoid:
      return exact(4 * kPi / 3 * product, Vec3::zero(), across / 5);
    default:
      return {};
  }
}

}  // namespace carom::collision

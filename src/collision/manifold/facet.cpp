// Rings of tilted support calls, and what their chords tell: see README.md, step 1.
#include "collision/manifold/facet.h"

#include <algorithm>

#include "collision/core.h"
#include "collision/manifold/patch_constants.h"

namespace carom::collision {
namespace {

constexpr int kRings = 3;
// Tilts of the rings, rad. The first must exceed the error of the query's normal and stay below the angle to the next
// face: at 0.03 a box's face is found whole with a normal 0.02 off, and neighbours that enclose less are taken for one
// curved part. Each ring leaves the normal off by about the square of its tilt, so the next may be that much finer and
// still see both ends of what is flat; the last leaves a round edge's height off by tilt^2/2 = 5e-9 of its radius.
constexpr Real kFacetTilt[kRings] = {kFirstTilt, 2e-3, 1e-4};
// The most that a face may lean, rad, to be looked for at all. Beyond, its far side carries nothing before the next
// step.
constexpr Real kWidest = 0.3;
// Azimuths every 45 degrees from 0.1 rad on: off every symmetry, so that on shapes built along axes no corners tie.
constexpr Real kRing[Facet::kAzimuths][2] = {
    {0.99500416527802582, 0.099833416646828155},   {0.63298131066220204, 0.7741670784769464},
    {-0.099833416646828155, 0.99500416527802582},  {-0.7741670784769464, 0.63298131066220204},
    {-0.99500416527802582, -0.099833416646828155}, {-0.63298131066220204, -0.7741670784769464},
    {0.099833416646828155, -0.99500416527802582},  {0.7741670784769464, -0.63298131066220204}};
// The last ring makes do with six, so that what it finds can be settled within 25 calls.
constexpr Real kLastRing[6][2] = {
    {0.9950041652780258, 0.09983341664682815},  {0.4110438076762635, 0.9116155923255147},
    {-0.5839603576017622, 0.8117821756786866},  {-0.9950041652780258, -0.09983341664682811},
    {-0.4110438076762642, -0.9116155923255144}, {0.5839603576017621, -0.8117821756786867}};
// Of a size: below this two support points are one, and heights are noise. Ten times what a support function may be
// off (kSloppiness).
constexpr Real kNoise = 1e-8;
// Of a chord: corners within this of the fitted plane lie in it. Ten times the noise of a function in single precision.
constexpr Real kFlat = 1e-6;
// A chord shorter than this share of its predecessor shrank with the tilt (by 15 or 20), so it spans a curved part.
constexpr Real kShrank = 0.3;

struct Ring {
  int count = 0;
  Vec3 point[Facet::kAzimuths];

  const Vec3& operator[](int k) const { return point[k]; }
  int half() const { return count / 2; }  // k and k + half() lie opposite each other
  const Vec3* begin() const { return point; }
  const Vec3* end() const { return point + count; }
};

bool ask_ring(const Prober& probe, const Vec3& about, Real tilt, Ring& p) {
  const bool last = tilt == kFacetTilt[kRings - 1];
  const auto* way = last ? kLastRing : kRing;
  const Vec3 e1 = steady_perpendicular(about), e2 = about.cross(e1);
  for (p.count = 0; p.count < (last ? 6 : Facet::kAzimuths); ++p.count)
    if (!probe(about + tilt * (way[p.count][0] * e1 + way[p.count][1] * e2), p.point[p.count])) return false;
  return true;
}

/// The longest chord between opposite points of a ring, and how far another one reaches beside it.
struct Chords {
  Real length = 0, width = 0;   // m
  Vec3 along = Vec3::unit_x();  // unit
  Vec3 normal;                  // unit, across both; valid if width > 0
  int longest = 0;

  Chords(const Ring& p, const Vec3& out) {
    const int half = p.half();
    Vec3 chord[Facet::kAzimuths / 2];
    for (int k = 0; k < half; ++k) {
      chord[k] = p[k] - p[k + half];
      const Real l = chord[k].norm();
      if (l > length) length = l, longest = k;
    }
    if (!(length > 0)) return;
    along = chord[longest] / length;
    Vec3 beside = Vec3::zero();
    for (int k = 0; k < half; ++k) {
      const Vec3 q = chord[k] - chord[k].dot(along) * along;
      const Real w = q.norm();
      if (w > width) width = w, beside = q;
    }
    if (!(width > 0)) return;
    normal = along.cross(beside);
    normal /= normal.norm();
    if (normal.dot(out) < 0) normal = -normal;
  }
};

int count_distinct(const Ring& p, Real noise) {
  int n = 0;
  for (int k = 0; k < p.count; ++k) n += (p[k] - p[k + 1 < p.count ? k + 1 : 0]).squared_norm() > noise * noise;
  return n;
}

/// All in one plane, and none of them, nor the tip, above it.
bool flat(const Ring& p, const Vec3& tip, const Vec3& normal, Real tolerance) {
  Real lo = kInfinity, hi = -kInfinity;
  for (const Vec3& x : p) {
    const Real h = normal.dot(x - tip);
    lo = std::min(lo, h), hi = std::max(hi, h);
  }
  return hi - lo <= tolerance && hi >= -tolerance;
}

/// Whether a ring looks like one of a surface that is curved in every direction: there the tip stands over the middle
/// of a chord by tilt/4 of the chord's length, times the cosine between azimuth and chord.
bool dome(const Ring& p, const Vec3& tip, const Chords& chords, Real tilt) {
  const auto rise = [&](int k) { return chords.normal.dot(tip - 0.5 * (p[k] + p[k + p.half()])) / tilt; };
  for (int k = 0; k < p.half(); ++k)
    if (!(rise(k) > (p[k] - p[k + p.half()]).norm() / 64)) return false;
  const Real share = rise(chords.longest) / chords.length;
  return share > 1.0 / 6 && share < 1.0 / 3;
}

void be_point(Facet& f, bool round) {
  f.rank = Facet::point, f.round = round;
  f.count = 1;
  f.corner[0] = f.tip;
}

void be_edge(const Ring& p, const Vec3& along, int ring, Facet& f) {
  f.rank = Facet::edge, f.round = ring > 0, f.ring = ring;
  f.count = 2;
  f.along = along;
  const auto by_reach = [&](const Vec3& x, const Vec3& y) { return along.dot(x - y) < 0; };
  f.corner[0] = *std::max_element(p.begin(), p.end(), by_reach);
  f.corner[1] = *std::min_element(p.begin(), p.end(), by_reach);
}

/// A face's corners stand in the order of their azimuths.
void be_face(const Ring& p, const Vec3& normal, Real noise, Facet& f) {
  f.rank = Facet::face, f.round = false;
  f.normal = normal;
  f.count = 0;
  for (int k = 0; k < p.count; ++k) {
    if (f.count > 0 && (p[k] - f.corner[f.count - 1]).squared_norm() <= noise * noise) continue;
    f.corner[f.count++] = p[k];
  }
  while (f.count > 1 && (f.corner[0] - f.corner[f.count - 1]).squared_norm() <= noise * noise) --f.count;
}

/// The facet within the rings' tilts. @param sharp  it is a corner or an edge for certain, after one ring, or may be a
/// point of a rim
bool fit_near(const Prober& probe, const Vec3& n, Facet& f, bool& sharp) {
  f.normal = n;
  if (!probe(n, f.tip)) return false;
  const Real noise = kNoise * probe.shape.bounding_radius;
  Vec3 about = n;
  Real length = 0, width = 0;  // of the ring before
  for (int i = 0; i < kRings; ++i) {
    Ring p;
    if (!ask_ring(probe, about, kFacetTilt[i], p)) return false;
    const Chords c(p, n);
    const bool last = i + 1 == kRings;
    if (c.length <= noise) return sharp = i == 0, be_point(f, i > 0), true;
    if (c.length < kShrank * length) {  // curved along its longest chord: what is flat beside it is shorter still
      if (last) return sharp = true, be_point(f, true), true;
      length = c.length, width = c.width;
      continue;
    }
    if (c.width <= noise || c.width < kShrank * width) return sharp = i == 0, be_edge(p, c.along, i, f), true;
    const bool near = c.normal.dot(n) > kPatchSamePlane;
    if (near && flat(p, f.tip, c.normal, std::max(kFlat * c.length, noise))) {
      // Few corners: all of them. Many: a ring square to the face leaves out fewest, and finds a rim at azimuths that
      // stay put in the body.
      const int distinct = count_distinct(p, noise);
      const bool square = (c.normal - about).squared_norm() < 0.01 * kFacetTilt[i] * kFacetTilt[i];
      if (distinct <= 4 || (distinct < Facet::kAzimuths && square) || i > 0)
        return be_face(p, c.normal, noise, f), true;
    } else if (last) {
      return near ? be_face(p, c.normal, noise, f) : be_edge(p, c.along, i, f), true;
    } else if (i == 0 && dome(p, f.tip, c, kFacetTilt[i])) {
      return be_point(f, true), true;
    }
    if (near) about = c.normal;
    length = c.length, width = c.width;
  }
  return true;
}

/// A flat face that leans by up to `lean` over a corner, an edge or a point of its rim.
bool look_wide(const Prober& probe, const Vec3& n, Real lean, Facet& f) {
  const Real noise = kNoise * probe.shape.bounding_radius;
  Ring p;
  if (!ask_ring(probe, n, lean, p)) return false;
  const Chords c(p, n);
  if (c.width > noise && c.normal.dot(n) > 1 - 0.5 * lean * lean &&
      flat(p, f.tip, c.normal, std::max(kFlat * c.length, noise)))
    be_face(p, c.normal, noise, f);
  return true;
}

}  // namespace

bool fit_facet(const Prober& probe, const Vec3& n, Real reach, Facet& f) {
  // A core that is a point has nothing to look for.
  if (!(probe.shape.bounding_radius > (1 + kNoise) * probe.shape.core_radius))
    return f.normal = n, probe(n, f.tip) && (be_point(f, false), true);
  bool sharp = false;
  if (!fit_near(probe, n, f, sharp)) return false;
  const Real lean = leaning(probe.shape, reach);
  return !sharp || lean <= kFacetTilt[0] || look_wide(probe, n, lean, f);
}

Vec3 steady_perpendicular(const Vec3& n) {
  constexpr Real kSeam = 0.58;  // a unit vector has a component below 1/sqrt(3) = 0.5774
  const int axis = std::fabs(n.x()) < kSeam ? 0 : std::fabs(n.y()) < kSeam ? 1 : 2;
  const Vec3 e = Vec3::unit(axis) - n[axis] * n;
  return e / e.norm();
}

bool Prober::operator()(const Vec3& d, Vec3& out) const {
  ++calls;
  Core core(shape);
  out.set_zero();
  return core.support(d, out) || core.blame(d, out, fault);
}

Real leaning(const Shape& shape, Real reach) {
  return std::min(kWidest, reach / (2 * std::max(shape.bounding_radius - shape.core_radius, reach)));
}

bool settle_facet(const Prober& probe, const Vec3& n, Facet& f) {
  if (!f.round) return true;
  if (f.rank == Facet::edge) {
    // Twice, so that an error of `along` of 1e-3 leaves 1e-10 of the radius to the side: what lies beside the line
    // would set the shape rolling.
    for (int i = f.ring; i < kRings; ++i) {
      Vec3 across = n - n.dot(f.along) * f.along;
      across /= across.norm();
      const Real length = (f.corner[0] - f.corner[1]).norm();
      if (!probe(across + kFacetTilt[i] * f.along, f.corner[0]) ||
          !probe(across - kFacetTilt[i] * f.along, f.corner[1]))
        return false;
      const Vec3 chord = f.corner[0] - f.corner[1];
      const Real now = chord.norm();
      if (!(now > 0.5 * length)) break;
      f.along = chord / now;
      if (i + 1 == kRings) return true;
    }
  }
  if (!probe(n, f.tip)) return false;
  return be_point(f, true), true;
}

}  // namespace carom::collision

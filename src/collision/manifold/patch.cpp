// The whole patch of a pair: facets fitted, a common normal chosen, outlines cut; README.md walks through the steps.
#include "collision/manifold/patch.h"

#include <algorithm>

#include "collision/manifold/adopt.h"
#include "collision/manifold/cut_outlines.h"
#include "collision/manifold/facet.h"
#include "collision/manifold/patch_constants.h"

namespace carom::collision {
namespace {

// rad: a declared face that leans by more is probed for, not looked up. Half as much again as probing sees.
constexpr Real kFacing = 1.5 * kFirstTilt;

struct Party {
  Prober probe;
  Facet facet;
  Real push;  // m: core radius and shell

  Party(const Shape& s, Real shell, std::uint64_t& calls, SupportFault& fault)
      : probe{s, calls, fault}, push(s.form == Form::half_space ? 0 : s.core_radius + shell) {}

  bool is_plane() const { return facet.rank == Facet::plane; }
  const Shape& shape() const { return probe.shape; }
};

/// Make a face one with those that look the same way within what rests on them: a lid that is flat but for its points'
/// precision, which would else be seen in parts, now this one, now that. The larger ones first, as many as there is
/// space for. Its normal is their mean.
void unite(const HullFaces& faces, std::uint32_t best, Facet& f) {
  f.united = 0;
  if (!faces.has_alike[best]) return;
  std::size_t corners = 0;
  Vec3 sum = Vec3::zero();
  const auto take = [&](std::uint32_t i) {
    const std::size_t more = faces.begin[i + 1] - faces.begin[i];
    if (f.united == Facet::kMostUnited || corners + more > Facet::kMostCorners) return;
    f.united_face[f.united++] = i;
    std::copy_n(&faces.loop[faces.begin[i]], more, f.united_corner + corners);
    corners += more;
    sum += faces.area[i] * faces.normal[i];
  };
  for (std::uint32_t i = 0; i < faces.count(); ++i) {
    if (i == best || !faces.look_alike(i, best)) continue;
    if (f.united == 0) take(best);
    if (f.united > 0) take(i);
  }
  if (f.united < 2) {
    f.united = 0;
    return;
  }
  std::sort(f.united_corner, f.united_corner + corners);
  f.count = static_cast<int>(std::unique(f.united_corner, f.united_corner + corners) - f.united_corner);
  f.normal = sum.normalized();
}

/// The declared face that looks along n, if one does.
bool look_up(const Shape& s, const Vec3& n, Real reach, Facet& f) {
  const HullFaces& faces = s.faces;
  std::size_t best = 0;
  Real most = -1;
  for (std::size_t i = 0; i < faces.count(); ++i) {
    const Real d = faces.normal[i].dot(n);
    if (d > most) most = d, best = i;
  }
  const Real lean = std::max(kFacing, leaning(s, reach));
  if (!(most > 1 - 0.5 * lean * lean)) return false;
  f.rank = Facet::face, f.round = false;
  f.normal = faces.normal[best];
  f.faces = &faces;
  f.vertices = faces.own.empty() ? s.vertices.data() : faces.own.data();
  f.loop = faces.loop.data() + faces.begin[best];
  f.count = static_cast<int>(faces.begin[best + 1] - faces.begin[best]);
  unite(faces, static_cast<std::uint32_t>(best), f);
  f.tip = f.at(0);
  for (int i = 1; i < f.count; ++i)
    if (n.dot(f.at(i) - f.tip) > 0) f.tip = f.at(i);
  return true;
}

/// @param n  unit, out of the shape, its frame
bool find_facet(const Vec3& n, Real reach, bool declared, Party& p) {
  const Shape& s = p.shape();
  if (s.form == Form::half_space) {
    p.facet.rank = Facet::plane;
    p.facet.normal = s.normal;
    p.facet.tip = s.offset * s.normal;
    return true;
  }
  return (declared && look_up(s, n, reach, p.facet)) || fit_facet(p.probe, n, reach, p.facet);
}

// Of how far bodies may move while a patch is kept, if it has more corners than points: which of them bear it changes with
// the least tilt.
constexpr Real kKeepChosen = 0.004;

constexpr Real kSteepest = 0.1;  // cosine: no face that is a part of a patch leans so far from its normal

enum class Owner { a, b, none };  // whose face a normal is

class Patch {
 public:
  Patch(const PatchPair& pair, const ContactPoint& nearest, std::uint64_t& calls, SupportFault& fault,
        const PatchTerms& terms = {})
      : pair_(pair),
        nearest_(nearest),
        terms_(terms),
        b_in_a_(relative(pair.frame_a, pair.frame_b)),
        a_(pair.a, pair.shell, calls, fault),
        b_(pair.b, pair.shell, calls, fault),
        size_(std::min(pair.a.bounding_radius, pair.b.bounding_radius)),
        margin_(kPatchPreferRelative * std::fabs(nearest.separation) + kPatchPreferAbsolute * size_),
        n_(pair.frame_a.rotate_inverse(nearest.normal)) {}

  bool find(bool declared, Real reach) {
    if (!find_facet(n_, reach, declared, a_) || !find_facet(-b_in_a_.rotate_inverse(n_), reach, declared, b_))
      return false;
    if (terms_.fixed)
      owner_ = Owner::a;
    else
      choose_normal();
    if (!settle_facet(a_.probe, n_, a_.facet) || !settle_facet(b_.probe, -b_in_a_.rotate_inverse(n_), b_.facet))
      return false;
    meet();
    return true;
  }

  const ContactPoint* points() const { return point_; }
  int count() const { return count_; }
  bool flat() const { return !a_.facet.round && !b_.facet.round; }
  void remember(PatchMemory& memory) const {
    memory.firm = flat();
    memory.of_b = owner_ == Owner::b;
    memory.normal = memory.of_b ? b_in_a_.rotate_inverse(n_) : n_;
    memory.b_in_a = b_in_a_;
  }

 private:
  Vec3 b_at(int i) const { return b_in_a_.apply(b_.facet.at(i)); }

  /// How far apart the facets are along m (A's frame): least height of B's over A's highest.
  Real separation_along(const Vec3& m) const {
    Real top = m.dot(a_.facet.tip), bottom = m.dot(b_in_a_.apply(b_.facet.tip));
    if (!a_.is_plane())
      for (int i = 0; i < a_.facet.count; ++i) top = std::max(top, m.dot(a_.facet.at(i)));
    if (!b_.is_plane())
      for (int i = 0; i < b_.facet.count; ++i) bottom = std::min(bottom, m.dot(b_at(i)));
    return bottom - top;
  }

  void choose_normal() {
    if (a_.is_plane() || b_.is_plane()) {
      owner_ = a_.is_plane() ? Owner::a : Owner::b;
      n_ = a_.is_plane() ? a_.facet.normal : Vec3(-b_in_a_.rotate(b_.facet.normal));
      return;
    }
    Real to_beat = separation_along(n_) - margin_;
    const Vec3 queried = n_;
    const auto offer = [&](const Vec3& m, Owner whose) {
      const Real s = separation_along(m);
      if (!(s >= to_beat) || !(m.dot(queried) > kPatchSamePlane)) return;
      n_ = m, owner_ = whose;
      to_beat = std::max(to_beat, s + margin_);
    };
    // A face that is one knows its normal; the mean of several is off by what they differ.
    for (const bool several : {false, true}) {
      if (a_.facet.rank == Facet::face && (a_.facet.united > 0) == several) offer(a_.facet.normal, Owner::a);
      if (b_.facet.rank == Facet::face && (b_.facet.united > 0) == several)
        offer(-b_in_a_.rotate(b_.facet.normal), Owner::b);
    }
    if (a_.facet.rank != Facet::edge || b_.facet.rank != Facet::edge) return;
    const Vec3 along_b = b_in_a_.rotate(b_.facet.along), across = a_.facet.along.cross(along_b);
    const Real sine = across.norm();
    if (sine > kFirstTilt) {  // what encloses less lies along each other
      offer((across.dot(queried) < 0 ? -1 : 1) / sine * across, Owner::none);
    } else {
      const Vec3 square = queried - queried.dot(a_.facet.along) * a_.facet.along;
      offer(square / square.norm(), Owner::none);
    }
  }

  /// A facet seen along the normal. B's corners are turned round: they stand clockwise from here.
  void outline(const Party& p, const Frame& to_a, bool reversed, Outline& o) const {
    const Facet& f = p.facet;
    if (p.is_plane()) {
      o.height = n_.dot(to_a.apply(f.tip) - origin_);
      return;
    }
    if (f.united > 0) return unite_outline(f, to_a, reversed, o);
    o.count = std::min(f.count, Outline::kMax);
    Real height[2] = {0, 0};
    for (int i = 0; i < o.count; ++i) {
      const int spaced = f.count <= Outline::kMax ? i : i * f.count / o.count;
      const int at = reversed ? o.count - 1 - i : i;
      const Vec3 x = to_a.apply(f.at(spaced)) - origin_;
      o.x[at] = u_.dot(x), o.y[at] = v_.dot(x), o.name[at] = f.name(spaced);
      if (at < 2) height[at] = n_.dot(x);
    }
    if (f.rank == Facet::face) {
      const Vec3 m = to_a.rotate(f.normal);
      const Real mz = m.dot(n_);
      o.slope_x = -m.dot(u_) / mz, o.slope_y = -m.dot(v_) / mz;
    } else if (f.rank == Facet::edge) {
      const Real dx = o.x[1] - o.x[0], dy = o.y[1] - o.y[0], l2 = dx * dx + dy * dy;
      const Real slope = l2 > 0 ? (height[1] - height[0]) / l2 : 0;
      o.slope_x = slope * dx, o.slope_y = slope * dy;
    }
    o.height = height[0] - o.slope_x * o.x[0] - o.slope_y * o.y[0];
    o.close();
  }

  /// Of several faces: the outline of all their corners, those that lie within it, and each face's plane.
  void unite_outline(const Facet& f, const Frame& to_a, bool below, Outline& o) const {
    OutlineCorner corner[Facet::kMostCorners];
    for (int i = 0; i < f.count; ++i) {
      const Vec3 x = to_a.apply(f.at(i)) - origin_;
      corner[i] = {u_.dot(x), v_.dot(x), f.name(i)};
    }
    o.wrap({corner, static_cast<std::size_t>(f.count)});
    o.below = below;
    for (std::size_t k = 0; k < f.united; ++k) {
      const std::uint32_t i = f.united_face[k];
      const double* p = f.vertices + 3 * static_cast<std::size_t>(f.faces->loop[f.faces->begin[i]]);
      const Vec3 m = to_a.rotate(f.faces->normal[i]), x = to_a.apply(Vec3(p[0], p[1], p[2])) - origin_;
      const Real mz = m.dot(n_);
      if (!(std::fabs(mz) > kSteepest)) continue;
      const Real slope_x = -m.dot(u_) / mz, slope_y = -m.dot(v_) / mz;
      o.add_plane({n_.dot(x) - slope_x * u_.dot(x) - slope_y * v_.dot(x), slope_x, slope_y});
    }
    o.close();
  }

  void meet() {
    origin_ = a_.is_plane() ? b_in_a_.apply(b_.facet.tip) : a_.facet.tip;
    u_ = any_perpendicular(n_), v_ = n_.cross(u_);
    Outline a, b;
    outline(a_, Frame(), false, a);
    outline(b_, b_in_a_, true, b);
    const Real tolerance =
        std::max(1e-9 * size_, 16 * kUnitRoundoff * (b_in_a_.p.abs().sum() + size_of_both())) + terms_.tolerance;
    ClippedVertices met;
    cut_outlines(a, b, tolerance, met);
    for (int i = 0; i < met.count; ++i) {
      const ClippedVertex& m = met.at[i];
      const Vec3 foot = origin_ + m.x * u_ + m.y * v_;
      add(foot + a.z(m.x, m.y) * n_, foot + b.z(m.x, m.y) * n_, m.feature);
    }
    if (terms_.fixed) return;
    // What the facets leave out: two edges that pass, a corner beside a face, a point deeper than any that they share.
    Real deepest = kInfinity;
    for (int i = 0; i < count_; ++i) deepest = std::min(deepest, point_[i].separation);
    if (deepest > nearest_.separation + margin_) point_[count_++] = nearest_;
  }

  /// m: size of what enters the places of points.
  Real size_of_both() const {
    return (a_.is_plane() ? 0 : pair_.a.bounding_radius) + (b_.is_plane() ? 0 : pair_.b.bounding_radius);
  }

  void add(const Vec3& core_a, const Vec3& core_b, std::uint32_t feature) {
    ContactPoint& p = point_[count_++];
    p.on_a = core_a + a_.push * n_;
    p.on_b = b_in_a_.apply_inverse(core_b - b_.push * n_);
    p.normal = pair_.frame_a.rotate(n_);
    p.separation = n_.dot(core_b - core_a) - a_.push - b_.push;
    p.feature = feature;
  }

  const PatchPair& pair_;
  const ContactPoint& nearest_;
  const PatchTerms terms_;
  const Frame b_in_a_;
  Party a_, b_;
  const Real size_, margin_;  // m
  Vec3 n_;                    // A's frame, A to B
  Owner owner_ = Owner::none;
  Vec3 origin_, u_, v_;
  int count_ = 0;
  ContactPoint point_[ClippedVertices::kMax + 1];
};
static_assert(ClippedVertices::kMax + 1 <= Pool::kMax && ClippedVertices::kMax + 1 == PatchPoints::kMax);

}  // namespace

bool update_patch(const PatchPair& pair, const Candidates& found, const ManifoldSettings& settings, Manifold& manifold,
                  PatchMemory& memory, std::uint64_t& calls, SupportFault& fault) {
  memory.firm = false;
  const ContactPoint* const nearest = deepest(found, settings.contact_distance);
  if (!nearest) {
    manifold.count = 0;
    return true;
  }
  Patch patch(pair, *nearest, calls, fault);
  if (!patch.find(settings.kind == ManifoldKind::clip, settings.contact_distance)) {
    manifold.count = 0;
    return false;
  }
  adopt(pair.frame_a, patch.points(), patch.count(), settings, manifold);
  patch.remember(memory);
  return true;
}

bool find_patch(const PatchPair& pair, const ContactPoint& nearest, const PatchTerms& terms, PatchPoints& points,
                std::uint64_t& calls, SupportFault& fault) {
  points.count = 0;
  Patch patch(pair, nearest, calls, fault, terms);
  if (!patch.find(true, terms.reach)) return false;
  points.count = patch.count();
  points.flat = patch.flat();
  std::copy(patch.points(), patch.points() + patch.count(), points.point);
  return true;
}

void adopt_patch(const PatchPair& pair, const Candidates& found, const ManifoldSettings& settings, Manifold& manifold,
                 PatchMemory& memory) {
  ManifoldSettings own_settings = settings;
  own_settings.sunk_alike = pair.a.form == Form::half_space || pair.b.form == Form::half_space;
  adopt(pair.frame_a, found.point, found.count, own_settings, manifold);
  manifold.has_more_corners |= found.on_rim && manifold.count == Manifold::kMaxPoints;
  const auto flat = [](Form f) { return f == Form::box || f == Form::polytope || f == Form::half_space; };
  memory.firm = false;
  if (manifold.count == 0 || !flat(pair.a.form) || !flat(pair.b.form)) return;
  const Vec3 n_a = pair.frame_a.rotate_inverse(manifold.point[0].normal);
  const Vec3 n_b = pair.frame_b.rotate_inverse(manifold.point[0].normal);
  // Of two boxes the normal is a face's, and so along an axis, or of two edges: then it stays with A.
  const auto own = [](const Shape& s, const Vec3& n) {
    return s.form == Form::half_space || (s.form == Form::box && n.abs().max_entry() > 1 - 1e-12);
  };
  memory.firm = true;
  memory.of_b = !own(pair.a, n_a) && own(pair.b, n_b);
  memory.normal = memory.of_b ? n_b : n_a;
  memory.b_in_a = relative(pair.frame_a, pair.frame_b);
}

bool keep_patch(const PatchPair& pair, const ManifoldSettings& settings, const PatchMemory& memory,
                Manifold& manifold) {
  if (!memory.firm || manifold.count == 0) return false;
  const Frame now = relative(pair.frame_a, pair.frame_b);
  const Real moved = motion_bound(memory.b_in_a, now, pair.a.bounding_radius, pair.b.bounding_radius);
  const Real radius = std::min(pair.a.bounding_radius, pair.b.bounding_radius);
  const Real share = manifold.has_more_corners ? kKeepChosen : 1;
  if (!(moved <= share * std::min(settings.keep_distance, kKeepRadius * radius))) return false;
  const Vec3 n = memory.of_b ? now.rotate(memory.normal) : memory.normal;
  const Vec3 normal = pair.frame_a.rotate(n);
  for (int k = 0; k < manifold.count; ++k) {
    ContactPoint& p = manifold.point[k];
    p.normal = normal;
    p.separation = n.dot(now.apply(p.on_b) - p.on_a);
    ++p.age;
  }
  return true;
}

}  // namespace carom::collision

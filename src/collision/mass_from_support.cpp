// Mass properties of a set known by its support function alone: grow an inscribed polytope at its worst facet, and
// bracket.
//
// Let c be a point inside, and for a facet of the inscribed polytope A its area, n its outward normal, H = n.(v - c)
// its height over c, g = h(n) - n.v >= 0 the gap that the support function shows beyond it. The cones from c over the
// facets fill space; in each of them the set reaches at least to the facet and at most to the parallel plane at H + g.
// So
//   V_in = sum(A H / 3)  <=  V  <=  sum(A H / 3 k^3) = V_out,        k = 1 + g / H
// and any integral over the set lies between the one over the inscribed polytope and that plus what the shells between
// facet and plane, each a cone stretched from 1 to k, can add at most. All of it is invariant under affine maps, so it
// is done in a frame where the set is plump (FitFrame); rounding enters as a slack added to every gap.
#include <algorithm>

#include "collision/fit_frame.h"
#include "collision/hull.h"
#include "collision/support.h"
#include "collision/volume.h"
#include "core/sum.h"

namespace carom::collision {

namespace {

constexpr int kFewestSupports = 32;  // 12 to fit the frame, 4 for the first facets, and some to grow with

/// The polytope and what the support function said beyond each facet.
class Growth {
 public:
  Growth(const Shape& shape, SupportFault& fault, Memory* memory)
      : shape_(shape), fault_(fault), mesh_(memory), beyond_(memory), worst_(memory) {}

  bool fit() {
    return fit_frame([this](const Vec3& d, Vec3& x) { return ask(d, x); }, frame_);
  }
  const FitFrame& frame() const { return frame_; }

  /// Grow until the bracket is narrower than tolerance, relatively, or the next step might need more than max supports.
  bool grow(Real tolerance, int max_supports) {
    mesh_.start(frame_.map(frame_.start[0]), frame_.map(frame_.start[1]), frame_.map(frame_.start[2]),
                frame_.map(frame_.start[3]));
    for (std::uint32_t f = 0; f < 4; ++f)
      if (!measure(f)) return false;
    while (!worst_.empty() && outer_ - inner_ > tolerance * (outer_ + inner_) / 2) {
      std::pop_heap(worst_.begin(), worst_.end());
      const Candidate c = worst_.back();
      worst_.pop_back();
      if (!mesh_.facet(c.facet).alive || beyond_[c.facet].stamp != c.stamp) continue;
      const std::size_t fan = mesh_.look(c.facet, beyond_[c.facet].point, frame_.slack);
      if (fan == 0) continue;  // no fan but one that folds over: this gap stays in the bracket
      if (asked_ + static_cast<int>(fan) > max_supports) break;
      mesh_.grow();
      for (const std::uint32_t r : mesh_.removed()) account(r, -1);
      for (const std::uint32_t f : mesh_.created())
        if (!measure(f)) return false;
    }
    return true;
  }

  MassProperties bracket() const;

 private:
  struct Beyond {
    Vec3 point = Vec3::zero();  // y, support point along the facet's normal
    Real gap = 0;               // y, >= 0
    std::uint32_t stamp = 0;    // which life of the slot
  };
  struct Candidate {
    Real shell;  // y^3
    std::uint32_t facet, stamp;
    bool operator<(const Candidate& o) const { return shell != o.shell ? shell < o.shell : stamp > o.stamp; }
  };

  /// Integrals of 1, x and x x^T over the set, about an inner point: from below or above (the first per component).
  struct Bound {
    Real volume;
    Vec3 first;
    Mat3 second;
  };

  Vec3 inscribed_centroid() const;
  void integrate(const Vec3& c, Bound& low, Bound& high) const;
  bool counts(std::uint32_t f) const { return mesh_.facet(f).alive && !mesh_.facet(f).normal.is_zero(); }

  bool ask(const Vec3& d, Vec3& x) {
    ++asked_;
    return full_support(shape_, d, x, fault_);
  }

  /// Ask for the gap beyond a new facet.
  bool measure(std::uint32_t f) {
    if (beyond_.size() <= f) beyond_.resize(f + 1);
    Beyond& b = beyond_[f];
    b.stamp = ++stamp_;
    b.gap = 0;
    const Vec3& n = mesh_.facet(f).normal;
    if (n.is_zero()) return true;  // a sliver: no volume stands on it
    const Vec3 d = frame_.pull_back(n);
    Vec3 x;
    if (!ask(d, x)) return false;
    b.point = HullMesh::snap(frame_.map(x));
    b.gap = mesh_.height(f, b.point);
    if (b.gap < -kSloppiness * frame_.extent * d.norm() -
                    4 * frame_.slack) {  // the facet's own vertices, or the first six points, say otherwise
      fault_.kind = SupportFault::not_support;
      fault_.shape = &shape_;
      for (int i = 0; i < 3; ++i) fault_.dir[i] = d[i], fault_.out[i] = x[i] - shape_.core_radius * direction_of(d)[i];
      return false;
    }
    b.gap = std::max(b.gap, Real(0));
    account(f, 1);
    if (b.gap > frame_.slack && mesh_.sees(f, b.point)) {
      worst_.push_back({cone(f) * (cube(stretch(f)) - 1), f, b.stamp});
      std::push_heap(worst_.begin(), worst_.end());
    }
    return true;
  }

  static Real cube(Real x) { return x * x * x; }
  Real cone(std::uint32_t f) const { return mesh_.facet(f).cross.norm() * mesh_.height(f, mesh_.inner()) / -6; }
  Real stretch(std::uint32_t f) const { return 1 - beyond_[f].gap / mesh_.height(f, mesh_.inner()); }
  void account(std::uint32_t f, int sign) {
    if (mesh_.facet(f).normal.is_zero()) return;
    inner_ += sign * cone(f);
    outer_ += sign * cone(f) * cube(stretch(f));
  }

  const Shape& shape_;
  SupportFault& fault_;
  FitFrame frame_;
  HullMesh mesh_;
  Array<Beyond> beyond_;        // by facet
  Array<Candidate> worst_;      // heap
  Real inner_ = 0, outer_ = 0;  // y^3, running bracket about mesh_.inner()
  int asked_ = 0;
  std::uint32_t stamp_ = 0;
};

Vec3 Growth::inscribed_centroid() const {
  Sum<Real> volume(0);
  Sum<Vec3> first(Vec3::zero());
  const Vec3& c = mesh_.inner();
  for (std::uint32_t f = 0; f < mesh_.slots(); ++f) {
    if (!counts(f)) continue;
    const std::uint32_t* v = mesh_.facet(f).v;
    volume.add(cone(f));
    first.add(cone(f) / 4 * (mesh_.point(v[0]) + mesh_.point(v[1]) + mesh_.point(v[2]) - 3 * c));
  }
  return c + first.value() / volume.value();
}

/// For a cone (tetrahedron a, b, d over c) of volume v, stretched by k, s = a + b + d:
///   volume v k^3      first moment v k^4 s / 4      second moment v k^5 (a a^T + b b^T + d d^T + s s^T) / 20
/// The first moment of what lies in the shell is bounded per component: its points are k' (convex combination), 1 <= k'
/// <= k.
void Growth::integrate(const Vec3& c, Bound& low, Bound& high) const {
  Sum<Real> volume[2] = {Sum<Real>(0), Sum<Real>(0)};
  Sum<Vec3> first[2] = {Sum<Vec3>(Vec3::zero()), Sum<Vec3>(Vec3::zero())};
  Sum<Mat3> second[2] = {Sum<Mat3>(Mat3::zero()), Sum<Mat3>(Mat3::zero())};
  for (std::uint32_t f = 0; f < mesh_.slots(); ++f) {
    if (!counts(f)) continue;
    const HullMesh::Facet& facet = mesh_.facet(f);
    const Vec3 a = mesh_.point(facet.v[0]) - c, b = mesh_.point(facet.v[1]) - c, d = mesh_.point(facet.v[2]) - c,
               s = a + b + d;
    const Real height = facet.normal.dot(s) / 3, v = facet.cross.norm() * height / 6;
    const Real shrink = std::max(Real(0), 1 - frame_.slack / height);
    const Real k = 1 + (beyond_[f].gap + frame_.slack) / height;
    const Real inside = v * cube(shrink), outside = v * cube(k);
    const Mat3 m = v / 20 * (outer(a, a) + outer(b, b) + outer(d, d) + outer(s, s));
    const Vec3 most = a.max(b).max(d).max(Vec3::zero()), least = a.min(b).min(d).min(Vec3::zero());
    volume[0].add(inside);
    volume[1].add(outside);
    first[0].add(v / 4 * s + (outside - inside) * k * least);
    first[1].add(v / 4 * s + (outside - inside) * k * most);
    second[0].add(m * (cube(shrink) * shrink * shrink));
    second[1].add(m * (cube(k) * k * k));
  }
  low = {volume[0].value(), first[0].value(), second[0].value()};
  high = {volume[1].value(), first[1].value(), second[1].value()};
}

MassProperties Growth::bracket() const {
  const Vec3 c = inscribed_centroid();  // makes first moments small, and with them what their errors multiply
  Bound low, high;
  integrate(c, low, high);
  const Real volume = (low.volume + high.volume) / 2, volume_error = (high.volume - low.volume) / 2;
  const Vec3 first = (low.first + high.first) / 2, first_error = (high.first - low.first) / 2;
  const Vec3 centre = first / volume;  // from c
  // |S / V - S^ / V^| = |(S - S^) / V + S^ / V^ (V^ - V) / V|
  const Vec3 centre_error = (first_error + centre.abs() * volume_error) / low.volume;

  const Mat3& from = frame_.from;
  const auto to_shape = [&](const Mat3& m) {
    const Mat3 x = frame_.determinant * (from * m * from.transpose());
    return Mat3((x + x.transpose()) / 2);
  };
  MassProperties out;
  out.volume = volume * frame_.determinant;
  out.volume_min = low.volume * frame_.determinant;
  out.volume_max = high.volume * frame_.determinant;
  out.centroid = frame_.origin + from * (c + centre);
  out.centroid_error = (from.abs() * centre_error).norm();
  const Mat3 half_width = (high.second - low.second) / 2;
  const Mat3 second = to_shape((low.second + high.second) / 2 - outer(volume * centre, centre));
  out.inertia = second.trace() * Mat3::identity() - second;
  // The set's second moment about c differs from the middle by a matrix E with -half_width <= E <= half_width (as
  // quadratic forms: each adds or takes away mass), and u . inertia(E) u is the trace of E over the plane across u: at
  // most trace(half_width). What the shift to the centroid adds: V g g^T against V^ g^ g^^T.
  const Vec3 g = from * centre;
  const Real shift = 2 * g.norm() * out.centroid_error + out.centroid_error * out.centroid_error;
  out.inertia_error =
      to_shape(half_width).trace() + out.volume_max * shift + volume_error * frame_.determinant * g.squared_norm();
  return out;
}

}  // namespace

MassProperties mass_from_support(const Shape& shape, Real tolerance, int max_supports, SupportFault& fault) {
  if (shape.form == Form::half_space) return {};
  Growth growth(shape, fault, shape.params.get_allocator().resource());
  if (!growth.fit()) return {};
  if (growth.frame().flat) {
    MassProperties flat;
    flat.volume_max = growth.frame().flat_volume;
    flat.centroid = growth.frame().origin;
    return flat;
  }
  if (!growth.grow(tolerance, std::max(max_supports, kFewestSupports))) return {};
  return growth.bracket();
}

}  // namespace carom::collision

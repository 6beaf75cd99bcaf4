#include "dynamics/contact/asked_again.h"

#include <algorithm>
#include <span>
#include <utility>

#include "collision/narrow/hybrid.h"
#include "collision/support.h"
#include "core/float_guard.h"
#include "dynamics/contact/depth.h"
#include "dynamics/contact/seams.h"
#include "dynamics/detect.h"
#include "dynamics/scenery.h"
#include "dynamics/solver/direct.h"

namespace carom::dynamics {
namespace {

/// m, by which points of a collider leave the tangent of their way within a time. A spin about the normal is none to a
/// contact, nor is one of a sphere.
Real leaves_tangent(const World& world, std::uint32_t collider, const Vec3& spin, Real time) {
  const Shape& shape = *world.scene.colliders.shape[collider];
  if (shape.form == Form::sphere || shape.form == Form::half_space) return 0;
  return extent(shape) * time * time * spin.squared_norm() / 2;
}

const Vec3& spin_of(const World& world, std::uint32_t collider) {
  return world.state.omega[world.scene.colliders.body[collider]];
}

/// Whether points of a pair leave the tangent of their way so far within a step.   @param spin  (collider), @see leaves_tangent()
template <class Spin>
bool leave_tangent(const World& world, const Pair& pair, const StepTime& time, const Spin& spin) {
  const Real leaves =
      leaves_tangent(world, pair.a, spin(pair.a), time.dt) + leaves_tangent(world, pair.b, spin(pair.b), time.dt);
  return leaves > 0 && leaves > kAskedAgain * tolerable_depth(world, pair);
}

/// m, by which a pair of two that are round leaves the plane between them within a time, as their middles pass each other:
/// the normal turns meanwhile, whether they spin or not.
Real passes_by(const World& world, const Pair& pair, const Vec3& n, Real time) {
  const State& s = world.state;
  const auto middle = [&](std::uint32_t collider, Vec3& x) -> Vec3 {
    const std::uint32_t body = world.scene.colliders.body[collider];
    const Vec3 arm = s.q[body] * world.plan->local[collider].p;
    x = s.x[body] + arm;
    return s.v[body] + s.omega[body].cross(arm);
  };
  Vec3 a, b;
  const Vec3 passes = middle(pair.b, b) - middle(pair.a, a);
  const Real apart = (b - a).norm(), across2 = passes.squared_norm() - passes.dot(n) * passes.dot(n);
  return apart > 0 ? across2 * time * time / (2 * apart) : 0;
}

/// Whether that is more than queries leave open.
bool bends_away(const World& world, const Pair& pair, const Vec3& n, Real tolerance, Real time) {
  const Colliders& c = world.scene.colliders;
  const Shape &a = *c.shape[pair.a], &b = *c.shape[pair.b];
  return is_curved(a) && is_curved(b) &&
         passes_by(world, pair, n, time) > tolerance * std::min(a.bounding_radius, b.bounding_radius);
}

/// Whether contacts are asked again at all: at the end of a step they are found anyway.
bool has_substeps(const World& world) { return world.plan->substeps > 1 || world.accuracy; }

const Pair& pair_of(const World& world, const ContactPair& m) {
  return world.pairs.place(world.contacts->geometry[m.row].pair).pair;
}

/// A contact pair where its bodies are now.
class Asking {
 public:
  Asking(const World& world, const ContactPair& m)
      : world_(world),
        m_(m),
        pair_(pair_of(world, m)),
        r_a_(world.state.q[m.a].matrix()),
        r_b_(world.state.q[m.b].matrix()),
        frame_a_(frame(pair_.a, m.a, r_a_)),
        frame_b_(frame(pair_.b, m.b, r_b_)) {}

  void ask(const NarrowSettings& settings, StepReport& report) {
    const std::uint32_t own = world_.contacts->geometry[m_.row].pair;
    const bool is_on_triangles = is_scenery(shape(pair_.a)) || is_scenery(shape(pair_.b));
    const Manifold manifold =
        is_on_triangles ? found_on_plane(settings, report) : found(own, {frame_a_, frame_b_}, settings, report);
    count_ = manifold.count;
    std::copy_n(manifold.point, count_, points_);
    if (!is_on_triangles) {
      ask_neighbours(pair_.a, pair_.b, settings, report);
      ask_neighbours(pair_.b, pair_.a, settings, report);
    }
    if (count_ > 0) take({points_, std::size_t(count_)});
  }

 private:
  static constexpr int kMostPoints = 4 * Manifold::kMaxPoints;

  struct Frames {
    const Frame &a, &b;
  };

  Frame frame(std::uint32_t collider, std::uint32_t body, const Mat3& r) const {
    const Frame& local = world_.plan->local[collider];
    return {r * local.r, world_.state.x[body] + r * local.p};
  }
  Frame frame(std::uint32_t collider) const {
    const std::uint32_t body = world_.scene.colliders.body[collider];
    return frame(collider, body, world_.state.q[body].matrix());
  }

  struct Shapes {
    const Shape &a, &b;
  };

  /// Points of two shapes, which stand for those of a pair.
  Manifold found(const Pair& pair, const Shapes& of, const Frames& f, QueryMemory memory, NarrowSettings settings,
                 StepReport& report) const {
    const Colliders& table = world_.scene.colliders;
    settings.manifold.contact_distance += table.reach[pair.a] + table.reach[pair.b];
    SupportFault fault;
    Manifold manifold;
    manifold.count = 0;
    find_manifold({of.a, of.b, f.a, f.b, shells(settings.query) / 2}, settings, memory, manifold, report.narrow, fault);
    if (fault.kind != SupportFault::none) manifold.count = 0;
    return manifold;
  }
  Manifold found(std::uint32_t record, const Frames& f, const NarrowSettings& settings, StepReport& report) const {
    const Pair& pair = world_.pairs.place(record).pair;
    return found(pair, {shape(pair.a), shape(pair.b)}, f, world_.pairs[record].memory, settings, report);
  }

  const Shape& shape(std::uint32_t collider) const { return *world_.scene.colliders.shape[collider]; }

  /// Scenery is as it was met: the plane of its patch, through the highest of the rows' points. Beyond an edge of it the plane goes on,
  /// as long as the step.
  Manifold found_on_plane(const NarrowSettings& settings, StepReport& report) const {
    const Contacts& c = *world_.contacts;
    const bool is_a = is_scenery(shape(pair_.a));
    const Frame& frame = is_a ? frame_a_ : frame_b_;
    Shape plane(std::pmr::get_default_resource());  // nothing of it allocates
    plane.form = Form::half_space;
    plane.bounding_radius = kInfinity;
    plane.bounds = {Vec3::constant(-kInfinity), Vec3::constant(kInfinity)};
    plane.normal = frame.rotate_inverse(is_a ? normal() : Vec3(-normal()));
    plane.offset = -kInfinity;
    const Frame& local = world_.plan->local[is_a ? pair_.a : pair_.b];
    for (std::uint32_t k = 0; k < m_.count; ++k) {
      const RowGeometry& g = c.geometry[m_.row + k];
      plane.offset = std::max(plane.offset, plane.normal.dot(local.apply_inverse(is_a ? g.l_a : g.l_b)));
    }
    return found(pair_, {is_a ? plane : shape(pair_.a), is_a ? shape(pair_.b) : plane}, {frame_a_, frame_b_}, {},
                 settings, report);
  }

  /// Whether a point looks as the rows do.
  struct KeepsPlane {
    Vec3 n;
    bool operator()(const ContactPoint& p) const { return (p.normal - n).squared_norm() <= kSameWay2; }
  };
  Vec3 normal() const { return world_.contacts->rows[m_.row].n; }

  /// Points that other colliders of a ground bear the body at in the same plane. An edge that leans away above them is
  /// none.
  void ask_neighbours(std::uint32_t body, std::uint32_t ground, const NarrowSettings& settings, StepReport& report) {
    const Colliders& table = world_.scene.colliders;
    const SeamTerms terms = seam_terms(world_.scene.dials, *table.shape[body], *table.shape[ground]);
    const KeepsPlane keeps_plane{normal()};
    Real least = kInfinity;
    for (const GroundContact& beside : contacts_with_ground(world_, body, ground)) {
      const Pair& pair = world_.pairs.place(beside.record).pair;
      const std::uint32_t other = beside.ground_is_a ? pair.a : pair.b;
      if (other == ground || !moves_alike(world_, ground, other, frame_a_.p, terms.flush, 0)) continue;
      const Frame a = frame(pair.a), b = frame(pair.b);
      const bool is_alike = beside.ground_is_a == (ground == pair_.a);
      Manifold manifold;
      if (is_scenery(shape(other)))
        meet_patch(world_, report.narrow, settings, {pair, a, b}, is_alike ? normal() : Vec3(-normal()), manifold);
      else
        manifold = found(beside.record, {a, b}, settings, report);
      for (int k = 0; k < manifold.count && count_ < kMostPoints; ++k) {
        ContactPoint p = is_alike ? manifold.point[k] : exchanged(manifold.point[k]);
        p.on_a = frame_a_.apply_inverse((is_alike ? a : b).apply(p.on_a));
        p.on_b = frame_b_.apply_inverse((is_alike ? b : a).apply(p.on_b));
        const auto is_at = [&](const ContactPoint& q) { return (q.on_a - p.on_a).norm() <= terms.flush; };
        if (!keeps_plane(p) || std::any_of(points_, points_ + count_, is_at)) continue;
        least = std::min(least, p.separation);
        points_[count_++] = p;
      }
    }
    if (least == kInfinity) return;
    const auto leans = [&](const ContactPoint& p) { return !keeps_plane(p) && p.separation >= least; };
    count_ = static_cast<int>(std::remove_if(points_, points_ + count_, leans) - points_);
    keep_farthest_apart(terms.flush);
  }

  /// As many points as there are rows: the deepest one, then those of its height that are farthest from all before.
  void keep_farthest_apart(Real height) {
    const int rows = static_cast<int>(m_.count);
    if (count_ <= rows) return;
    const auto deeper = [](const ContactPoint& p, const ContactPoint& q) { return p.separation < q.separation; };
    std::swap(points_[0], *std::min_element(points_, points_ + count_, deeper));
    const auto apart = [&](const ContactPoint& p, int kept) {
      Real least = kInfinity;
      for (int k = 0; k < kept; ++k) least = std::min(least, (points_[k].on_a - p.on_a).norm());
      return p.separation <= points_[0].separation + height ? least : -p.separation;
    };
    for (int kept = 1; kept < rows; ++kept) {
      int next = kept;
      for (int k = kept + 1; k < count_; ++k)
        if (apart(points_[k], kept) > apart(points_[next], kept)) next = k;
      std::swap(points_[kept], points_[next]);
    }
    count_ = rows;
  }

  void take(std::span<ContactPoint> points) {
    Contacts& c = *world_.contacts;
    for (std::size_t k = 1; k < points.size(); ++k)  // the deepest first
      for (std::size_t l = k; l > 0 && points[l].separation < points[l - 1].separation; --l)
        std::swap(points[l], points[l - 1]);
    const Vec3 first = points[0].normal;
    const bool one_normal = std::ranges::all_of(points, [&](const ContactPoint& p) { return p.normal == first; });
    std::uint32_t taken = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(points.size(), m_.count); ++k) {
      const std::uint32_t at = nearest_row(points[k], taken);
      taken |= 1u << at;
      put(points[k], c.rows[m_.row + at], c.geometry[m_.row + at]);
    }
    for (std::uint32_t k = 0; k < m_.count; ++k) {
      c.rows[m_.row + k].one_normal = one_normal;
      if (one_normal) c.rows[m_.row + k].n = first;
    }
  }

  std::uint32_t nearest_row(const ContactPoint& point, std::uint32_t taken) const {
    const Contacts& c = *world_.contacts;
    const Vec3 place = frame_a_.apply(point.on_a);
    std::uint32_t nearest = 0;
    Real least = kInfinity;
    for (std::uint32_t k = 0; k < m_.count; ++k) {
      if (taken >> k & 1) continue;
      const RowGeometry& g = c.geometry[m_.row + k];
      const Vec3 on_a = world_.state.x[m_.a] + r_a_ * g.l_a + g.radius_a * c.rows[m_.row + k].n;
      if (const Real d = (on_a - place).squared_norm(); d < least) least = d, nearest = k;
    }
    return nearest;
  }

  void put(const ContactPoint& point, Row& row, RowGeometry& g) const {
    row.n = point.normal;
    g.l_a = world_.plan->local[pair_.a].apply(point.on_a) - g.radius_a * (r_a_.transpose() * row.n);
    g.l_b = world_.plan->local[pair_.b].apply(point.on_b) + g.radius_b * (r_b_.transpose() * row.n);
    g.separation = point.separation;
    g.place = world_.scene.type[m_.a] != BodyType::dynamic ? point.on_b : point.on_a;
  }

  const World& world_;
  const ContactPair& m_;
  const Pair& pair_;
  const Mat3 r_a_, r_b_;
  const Frame frame_a_, frame_b_;
  ContactPoint points_[kMostPoints];
  int count_ = 0;
};

}  // namespace

bool may_be_asked_again(const World& world, const Pair& pair, const StepTime& time) {
  return has_substeps(world) &&
         leave_tangent(world, pair, time, [&](std::uint32_t collider) { return spin_of(world, collider); });
}

void find_asked_again(const World& world, const StepTime& time) {
  Contacts& c = *world.contacts;
  c.any_asked_again = false;
  if (!has_substeps(world)) return;
  const Real tolerance = world.scene.dials[Dial::gjk_tolerance];
  for (const ContactPair& m : c.contact_pairs) {
    const Pair& pair = pair_of(world, m);
    const Vec3& n = c.rows[m.row].n;
    const auto across = [&](std::uint32_t collider) -> Vec3 { return spin_of(world, collider).cross(n); };
    if (!leave_tangent(world, pair, time, across) && !bends_away(world, pair, n, tolerance, time.dt)) continue;
    for (std::uint32_t k = 0; k < m.count; ++k) c.geometry[m.row + k].is_asked_again = true;
    c.any_asked_again = true;
  }
}

void ask_again(const World& world, StepReport& report, const StepTime& time) {
  const Contacts& c = *world.contacts;
  if (!c.any_asked_again || world.direct->groups() == 0) return;
  const FloatGuard guard;
  NarrowSettings settings = narrow_settings(world.scene.dials, time.dt);
  settings.manifold.kind = ManifoldKind::clip;
  for (const ContactPair& m : c.contact_pairs) {
    if (!c.geometry[m.row].is_asked_again) continue;
    const GroupRest* const rest = world.direct->rest_of(c.rows[m.row]);
    if (!rest || rest->is_first) continue;
    Asking(world, m).ask(settings, report);
    guard.put_back();
  }
}

}  // namespace carom::dynamics

// Lines of shapes, boxes, contacts, joints and frames. One kind after the other, each in ascending order of slots.
#include "dynamics/draw.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "collision/scenery/scenery.h"
#include "collision/support.h"
#include "collision/volume.h"
#include "core/trig.h"
#include "dynamics/contact_views.h"
#include "dynamics/joint/parts.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

constexpr std::uint32_t kGrey = 0x8A8F94FFu, kBlue = 0x3B7DD8FFu, kSand = 0xD8A657FFu, kDim = 0x6B6257FFu;
constexpr std::uint32_t kTouching = 0xE5484DFFu, kNear = 0x46A758FFu, kTie = 0xC678DDFFu;
constexpr std::array<std::uint32_t, 3> kAxis = {0xE5484DFFu, 0x46A758FFu, 0x3B7DD8FFu};
// Islands: hues that stay apart, dark and light in turn; those with the same colour seldom lie side by side.
constexpr std::array<std::uint32_t, 12> kIsland = {0x4C78A8FFu, 0xF58518FFu, 0x54A24BFFu, 0xE45756FFu,
                                                   0x72B7B2FFu, 0xEECA3BFFu, 0xB279A2FFu, 0xFF9DA6FFu,
                                                   0x9D755DFFu, 0x2F4B7CFFu, 0xA05195FFu, 0x665191FFu};
constexpr int kAround = 32;  // corners of a silhouette: off a circle by half a percent

class Drawing {
 public:
  Drawing(const World& world, const DrawSettings& settings, Array<DrawLine>& lines)
      : world_(world), scene_(world.scene), settings_(settings), lines_(lines), island_(world.memory) {}

  void run() {
    if (settings_.by_island) find_islands();
    const Colliders& c = scene_.colliders;
    each_collider(DrawLine::shapes, [&](std::uint32_t slot) { shape(slot, *c.shape[slot]); });
    each_collider(DrawLine::scenery, [&](std::uint32_t slot) { scenery(slot, *c.shape[slot]); });
    each_collider(DrawLine::bounds, [&](std::uint32_t slot) { box(slot, *c.shape[slot]); });
    if (wants(DrawLine::contacts)) contacts();
    if (wants(DrawLine::joints)) joints();
    if (wants(DrawLine::bodies)) bodies();
  }

 private:
  bool wants(DrawLine::Kind kind) const { return settings_.what & kind; }
  template <class F>
  void each_collider(DrawLine::Kind kind, F&& f) {
    if (!wants(kind)) return;
    kind_ = kind;
    for (const std::uint32_t slot : scene_.colliders.live)
      if (takes_part(world_, slot)) f(slot);
  }

  std::uint32_t colour_of(std::uint32_t body) const {
    const bool dynamic = scene_.type[body] == BodyType::dynamic;
    if (settings_.by_island && dynamic) return kIsland[island_[body] % kIsland.size()];
    if (dynamic) return world_.state.sleeps(body) ? kDim : kSand;
    return scene_.type[body] == BodyType::kinematic ? kBlue : kGrey;
  }
  void line(const Vec3& from, const Vec3& to, std::uint32_t colour, std::uint32_t body) {
    lines_.push_back({from, to, colour, kind_, body});
  }
  void axes(const Vec3& at, const Mat3& r, std::uint32_t body) {
    for (int k = 0; k < 3; ++k) line(at, at + settings_.scale * r.col(k), kAxis[static_cast<std::size_t>(k)], body);
  }

  /// Least body of each island: what contacts of the last step and joints tie together.
  void find_islands() {
    island_.resize(scene_.bodies.slots());
    std::iota(island_.begin(), island_.end(), 0u);
    const auto root = [&](std::uint32_t i) {
      while (island_[i] != i) i = island_[i] = island_[island_[i]];
      return i;
    };
    const auto tie = [&](std::uint32_t a, std::uint32_t b) {
      if (a == kInvalid || b == kInvalid || scene_.type[a] != BodyType::dynamic || scene_.type[b] != BodyType::dynamic)
        return;
      const std::uint32_t x = root(a), y = root(b);
      island_[std::max(x, y)] = std::min(x, y);
    };
    for (const ContactView& v : world_.contact_views())
      tie(scene_.colliders.body[v.collider_a], scene_.colliders.body[v.collider_b]);
    for (std::uint32_t j = 0; j < world_.joints.slots.slots(); ++j)
      if (world_.joints.alive(j) && !world_.joints.joint[j].broken)
        tie(world_.joints.joint[j].def.body_a, world_.joints.joint[j].def.body_b);
    for (std::uint32_t i = 0; i < island_.size(); ++i) island_[i] = root(i);
  }

  void shape(std::uint32_t slot, const Shape& s) {
    if (s.form == Form::half_space || is_scenery(s)) return;
    const Frame frame = collider_frame(world_, slot);
    const std::uint32_t body = scene_.colliders.body[slot], colour = colour_of(body);
    if (!s.faces.empty()) return edges(s, frame, colour, body);
    for (int k = 0; k < 3; ++k) silhouette(s, frame, k, colour, body);
  }

  /// Each edge once, from the face that meets its lower corner first.
  void edges(const Shape& s, const Frame& frame, std::uint32_t colour, std::uint32_t body) {
    const HullFaces& faces = s.faces;
    const double* const xyz = faces.own.empty() ? s.vertices.data() : faces.own.data();
    const auto at = [&](std::uint32_t i) { return frame.apply(Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2])); };
    for (std::size_t f = 0; f < faces.count(); ++f)
      for (std::uint32_t k = faces.begin[f]; k < faces.begin[f + 1]; ++k) {
        const std::uint32_t a = faces.loop[k], b = faces.loop[k + 1 < faces.begin[f + 1] ? k + 1 : faces.begin[f]];
        if (a < b) line(at(a), at(b), colour, body);
      }
  }

  /// Support points along directions in one of the shape's own planes.
  void silhouette(const Shape& s, const Frame& frame, int normal, std::uint32_t colour, std::uint32_t body) {
    const int u = (normal + 1) % 3, v = (normal + 2) % 3;
    std::array<Vec3, kAround> corner;
    for (int i = 0; i < kAround; ++i) {
      const SinCos turn = sin_cos(2 * 3.14159265358979323846 * (i + 0.5) / kAround);  // off the axes: no ties on boxes
      Vec3 d = Vec3::zero();
      d[u] = turn.cos, d[v] = turn.sin;
      SupportFault fault;
      if (!full_support(s, d, corner[static_cast<std::size_t>(i)], fault)) return;
    }
    for (std::size_t i = 0; i < kAround; ++i) {
      const Vec3 &from = corner[i], &to = corner[(i + 1) % kAround];
      if (from != to) line(frame.apply(from), frame.apply(to), colour, body);
    }
  }

  void scenery(std::uint32_t slot, const Shape& s) {
    if (!is_scenery(s)) return;
    const Frame frame = collider_frame(world_, slot);
    const std::uint32_t body = scene_.colliders.body[slot], colour = colour_of(body);
    Triangle triangle;
    for (std::uint32_t i = 0; i < s.scenery->triangles(); ++i) {
      if (!s.scenery->triangle(i, triangle)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = triangle.corner[k], &b = triangle.corner[(k + 1) % 3];
        // A side that two share is drawn by the one that runs along it forward.
        const bool forward = std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
        if (triangle.boundary[k] || forward) line(frame.apply(a), frame.apply(b), colour, body);
      }
    }
  }

  void box(std::uint32_t slot, const Shape& s) {
    if (s.form == Form::half_space) return;
    const Frame frame = collider_frame(world_, slot);
    SupportFault fault;
    const Aabb b = world_bounds(s, frame.r, frame.p, fault);
    if (fault.kind != SupportFault::none) return;
    const std::uint32_t body = scene_.colliders.body[slot], colour = colour_of(body);
    const auto corner = [&](int i) {
      return Vec3(i & 1 ? b.hi.x() : b.lo.x(), i & 2 ? b.hi.y() : b.lo.y(), i & 4 ? b.hi.z() : b.lo.z());
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if (!(i & bit)) line(corner(i), corner(i | bit), colour, body);
  }

  void contacts() {
    kind_ = DrawLine::contacts;
    for (const ContactView& v : world_.contact_views())
      line(v.point, v.point + settings_.scale * v.normal, v.normal_impulse > 0 ? kTouching : kNear,
           scene_.colliders.body[v.collider_b]);
  }

  void joints() {
    kind_ = DrawLine::joints;
    for (std::uint32_t j = 0; j < world_.joints.slots.slots(); ++j) {
      if (!world_.joints.alive(j) || world_.joints.joint[j].broken) continue;
      const JointDef& def = world_.joints.joint[j].def;
      if (is_coupling(def.kind)) continue;  // the joints that it couples are drawn
      const JointEnds ends = ends_of(world_, def);
      const auto whose = [](std::uint32_t body) { return body == kInvalid ? kInvalid : body; };
      axes(ends.a.p, ends.a.q.matrix(), whose(def.body_a));
      axes(ends.b.p, ends.b.q.matrix(), whose(def.body_b));
      if (def.kind == JointKind::pulley) {
        const Transmission& over = world_.joints.joint[j].transmission;
        line(ends.a.p, over.anchor_a, kTie, whose(def.body_a));
        line(over.anchor_a, over.anchor_b, kTie, whose(def.body_b));
        line(over.anchor_b, ends.b.p, kTie, whose(def.body_b));
      } else {
        line(ends.a.p, ends.b.p, kTie, whose(def.body_b));
      }
    }
  }

  void bodies() {
    kind_ = DrawLine::bodies;
    for (std::uint32_t i = 0; i < scene_.bodies.slots(); ++i)
      if (scene_.bodies.alive(i) && !world_.state.held_out[i]) axes(world_.state.x[i], world_.state.q[i].matrix(), i);
  }

  const World& world_;
  const Scene& scene_;
  const DrawSettings& settings_;
  Array<DrawLine>& lines_;
  DrawLine::Kind kind_ = DrawLine::shapes;
  Array<std::uint32_t> island_;  // by body: the least of its island
};

}  // namespace

void draw(const World& world, const DrawSettings& settings, Array<DrawLine>& lines) {
  Drawing(world, settings, lines).run();
}

}  // namespace carom::dynamics

#include "dynamics/contact/seams.h"

#include <algorithm>

#include "dynamics/contact/asked_again.h"

namespace carom::dynamics {
namespace {

// Of the smaller size of two that touch: what stands out by less is level.
constexpr Real kFlush = 1e-3;

std::uint64_t key_of(std::uint32_t body, std::uint32_t ground) { return (std::uint64_t(body) << 32) | ground; }

Vec3 outward(const ContactPoint& p, bool ground_is_a) { return ground_is_a ? p.normal : Vec3(-p.normal); }

GroundTouch touch_of(const Colliders& c, const Pair& pair, const ContactPoint& p, bool ground_is_a) {
  return {outward(p, ground_is_a), ground_is_a ? c.frame[pair.a].apply(p.on_a) : c.frame[pair.b].apply(p.on_b)};
}

/// The contacts of one collider with one ground.
class Seam {
 public:
  Seam(const World& world, PairTable& pairs, const StepTime& time, GroundContact* first, GroundContact* last)
      : world_(world), pairs_(pairs), dt_(time.dt), first_(first), last_(last) {}

  void run() {
    if (!is_bent()) return;
    for (GroundContact* i = first_; i < last_; ++i)
      for (int k = 0; k < pairs_[i->record].manifold.count; ++k)
        if (is_ghost_point(*i, k)) i->ghosts |= 1u << k;
    const auto all = [&](const GroundContact& i) { return i.ghosts + 1u == 1u << pairs_[i.record].manifold.count; };
    if (std::all_of(first_, last_, all)) return;  // each leaves it to another one: nothing would bear the body
    for (GroundContact* i = first_; i < last_; ++i) drop(*i);
  }

 private:
  /// Whether not all contacts look the same way.
  bool is_bent() const {
    const GroundContact* i = first_;
    while (i < last_ && pairs_[i->record].manifold.count == 0) ++i;
    if (i == last_) return false;
    const Vec3 n = outward(pairs_[i->record].manifold.point[0], i->ground_is_a);
    for (; i < last_; ++i) {
      const Manifold& m = pairs_[i->record].manifold;
      for (int k = 0; k < m.count; ++k)
        if ((outward(m.point[k], i->ground_is_a) - n).squared_norm() > kSameWay2) return true;
    }
    return false;
  }

  bool is_ghost_point(const GroundContact& i, int k) const {
    const Colliders& c = world_.scene.colliders;
    const Pair pair = pairs_.place(i.record).pair;
    const std::uint32_t ground = i.ground_is_a ? pair.a : pair.b, body = i.ground_is_a ? pair.b : pair.a;
    const GroundTouch touch = touch_of(c, pair, pairs_[i.record].manifold.point[k], i.ground_is_a);
    const SeamTerms terms = seam_terms(world_.scene.dials, *c.shape[body], *c.shape[ground]);
    // A neighbour may cover the place though its own contact is none to go by: where an edge of the body lies just
    // above a seam, both tiles' normals lean.
    bool is_level = false, is_covered = false;
    for (const GroundContact* j = first_; j < last_; ++j) {
      const Pair other = pairs_.place(j->record).pair;
      const std::uint32_t beside = j->ground_is_a ? other.a : other.b;
      if (pairs_[j->record].manifold.count == 0 || beside == ground ||
          world_.scene.modes.forbids(+EffectId::response, c.body[beside]) ||
          !moves_alike(world_, ground, beside, touch.point, terms.flush, dt_))
        continue;
      const Manifold& m = pairs_[j->record].manifold;
      for (int l = 0; l < m.count; ++l) {
        const Beside b =
            compare({*c.shape[ground], c.frame[ground]}, touch, touch_of(c, other, m.point[l], j->ground_is_a), terms);
        if (b == Beside::ghost) return true;
        is_level |= b == Beside::level;
      }
      is_covered = is_covered || covers({*c.shape[beside], c.frame[beside]}, touch, terms);
    }
    return is_level && is_covered;
  }

  void drop(const GroundContact& i) {
    if (i.ghosts == 0) return;
    PairRecord& r = pairs_[i.record];
    int kept = 0;
    for (int k = 0; k < r.manifold.count; ++k)
      if (!(i.ghosts >> k & 1u)) r.manifold.point[kept++] = r.manifold.point[k];
    r.manifold.count = kept;
    r.patch.firm = false;
    pairs_.place(i.record).points = static_cast<std::uint32_t>(kept);
    pairs_.place(i.record).horizon = -kInfinity;
  }

  const World& world_;
  PairTable& pairs_;
  Real dt_;
  GroundContact *first_, *last_;
};

}  // namespace

std::uint32_t ground_of(const World& world, std::uint32_t collider) {
  const Scene& s = world.scene;
  const std::uint32_t body = s.colliders.body[collider];
  if (s.type[body] == BodyType::fixed || world.state.sleeps(body)) return kStillGround;
  if (s.type[body] == BodyType::kinematic)
    return world.state.v[body] == Vec3::zero() && world.state.omega[body] == Vec3::zero() ? kStillGround
                                                                                          : kDrivenGround;
  return s.colliders.next[s.first_collider[body]] == kInvalid ? kNoGround : body;
}

bool moves_alike(const World& world, std::uint32_t a, std::uint32_t b, const Vec3& place, Real flush, Real dt) {
  const std::uint32_t i = world.scene.colliders.body[a], k = world.scene.colliders.body[b];
  if (i == k || ground_of(world, a) == kStillGround) return true;
  const State& s = world.state;
  const Vec3 at_i = s.v[i] + s.omega[i].cross(place - s.x[i]), at_k = s.v[k] + s.omega[k].cross(place - s.x[k]);
  return dt * (at_i - at_k).norm() <= flush;
}

SeamTerms seam_terms(const Dials& dials, const Shape& body, const Shape& ground) {
  const Real size =
      ground.form == Form::half_space ? body.bounding_radius : std::min(body.bounding_radius, ground.bounding_radius);
  return {size, std::min(kFlush * size, dials[Dial::position_tolerance]), dials.whole(Dial::gjk_iterations)};
}

void leave_out_ghosts(const World& world, PairTable& pairs, const StepTime& time) {
  Array<GroundContact>& found = world.contacts->grounds;
  found.clear();
  std::uint32_t of = kInvalid, a = kNoGround;  // pairs of one A come one after the other
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const PairTable::Place& place = pairs.place(i);
    if (place.pair.a != of) of = place.pair.a, a = ground_of(world, of);
    const std::uint32_t b = ground_of(world, place.pair.b);
    if (a == kNoGround && b == kNoGround) continue;
    if (place.points == 0 && !may_be_asked_again(world, place.pair, time)) continue;
    const auto add = [&](std::uint32_t body, std::uint32_t ground, bool ground_is_a) {
      found.push_back({key_of(body, ground), i, ground_is_a, 0});
    };
    if (b != kNoGround) add(place.pair.a, b, false);
    if (a != kNoGround) add(place.pair.b, a, true);
  }
  std::sort(found.begin(), found.end(), [](const GroundContact& p, const GroundContact& q) {
    return p.key != q.key ? p.key < q.key : p.record < q.record;
  });
  for (std::size_t i = 0, j; i < found.size(); i = j) {
    for (j = i + 1; j < found.size() && found[j].key == found[i].key;) ++j;
    if (j > i + 1) Seam(world, pairs, time, &found[i], found.data() + j).run();
  }
}

std::span<const GroundContact> contacts_with_ground(const World& world, std::uint32_t collider, std::uint32_t ground) {
  const Array<GroundContact>& all = world.contacts->grounds;
  const std::uint64_t key = key_of(collider, ground_of(world, ground));
  const auto first =
      std::lower_bound(all.begin(), all.end(), key, [](const GroundContact& g, std::uint64_t k) { return g.key < k; });
  const auto last = std::find_if(first, all.end(), [&](const GroundContact& g) { return g.key != key; });
  return {first, last};
}

}  // namespace carom::dynamics

// What a hit does: one impulse of all points that touch at that moment, and two bodies that go on from there.
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "collision/manifold/adopt.h"
#include "collision/narrow/hybrid.h"
#include "dynamics/ccd/sweeper.h"
#include "dynamics/contact/impact_points.h"
#include "dynamics/contact/seams.h"
#include "dynamics/detect.h"
#include "dynamics/filter.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
struct Sweeper::Strike {
  Side a, b;
  Real now;     // s, on the path
  Real moment;  // s, on the parabolas of which the paths are chords
  Vec3 normal, point;
  ImpactPair of;  // bodies at the moment, changed by the impulse
  std::array<ImpactPoint, kMostHitPoints> points;
  std::size_t count = 0;
  Real impulse = 0, speed = 0;  // N s; m/s, the fastest point's
  Real sinks = 0;               // m/s, at which the paths after it would still close
};

void Sweeper::strike(SweptBody& b) {
  const Colliders& table = world_.scene.colliders;
  const std::uint32_t other = table.body[b.other];
  SweptBody* const partner = take_up(other);
  Strike s;
  s.now = b.when, s.normal = b.normal, s.point = b.point;
  s.a = {b.body, b.own, b.own_part, b.path, &b};
  s.b = {other, b.other, b.other_part, path_of(other), partner};
  b.when = kInfinity;
  for (SweptBody* const p : {&b, partner}) {
    if (!p || !moved_by_hits(p->body)) continue;
    const collision::Pair pair = {std::min(b.own, b.other), std::max(b.own, b.other)};
    each_as_one(*p, [&](SweptBody& one) {
      sense(one, s.now);
      if (!std::exchange(one.is_hit, true)) one.hit = pair;
      one.is_hit_elsewhere |= one.hit != pair;
    });
    ++p->hits;
  }
  if (has_its_turn_later(other)) return wait_at(s);
  ++report_.sweep_hits;
  const bool is_hit = (is_movable(b.body) || is_movable(other)) && exchange(s);
  // Bodies that are pushed on by nothing but their path are aimed along their velocity, which does not close.
  const Real rest = time_.h - s.now;
  const bool astray =
      (is_movable(b.body) || is_movable(other)) && (!is_hit || s.sinks * rest > kDeeper * slack(s.a, s.b));
  if (astray) brace(s);
  join(other, b, partner, s.now);
  const bool are_one = partner && is_one_with(b, *partner);
  const auto each_of_both = [&](auto&& f) {
    each_as_one(b, f);
    if (partner && !are_one) each_as_one(*partner, f);
  };
  each_of_both([&](SweptBody& p) { go_on(p); });
  each_of_both([&](SweptBody& p) {
    if (p.swept) look_ahead(p, s.now);
  });
  if (is_hit && c_.hits.size() < c_.most_hits) {
    const bool in_order = s.a.collider < s.b.collider;
    c_.hits.push_back({{std::min(s.a.collider, s.b.collider), std::max(s.a.collider, s.b.collider)},
                       static_cast<std::uint32_t>(c_.hits.size()),
                       s.point,
                       in_order ? s.normal : Vec3(-s.normal),
                       s.impulse,
                       s.speed});
  }
}

/// Its path is another one from now on.
void Sweeper::go_on(SweptBody& b) {
  if (!moved_by_hits(b.body)) return;
  ++b.version;
  b.swept |= goes_far(b);
  if (!b.loose) b.loose = true, c_.loose.push_back(static_cast<std::uint32_t>(&b - c_.bodies.data()));
}

/// What is in its way takes its substeps apart: the hit is left to the next step, which finds the two together.
void Sweeper::wait_at(Strike& s) {
  SweptBody& b = *c_.find(s.a.body);
  hold(b, b.body, s.now);
  go_on(b);
}

/// Whether a body that is hit would be a quarter of its thickness farther by the end of the step: then it is swept as
/// well. What contacts push apart later need not be found here, and hits do not run through a heap from one to the
/// next.
bool Sweeper::goes_far(const SweptBody& b) const {
  const Colliders& table = world_.scene.colliders;
  Real thin = kInfinity;
  for (std::uint32_t slot = world_.scene.first_collider[b.body]; slot != kInvalid; slot = table.next[slot])
    thin = std::min(thin, (table.shape[slot]->bounds.hi - table.shape[slot]->bounds.lo).min_entry());
  return 4 * time_.dt * (b.path.u.norm() + b.radius * b.path.w.norm()) > thin;
}

/// The record of a body that is hit, made if there is capacity; null for what stands still or sleeps.
SweptBody* Sweeper::take_up(std::uint32_t body) {
  if (SweptBody* const known = c_.find(body)) return known;
  if (!moved_by_hits(body) || world_.state.sleeps(body) || c_.bodies.size() >= c_.most_bodies) return nullptr;
  if (has_its_turn_later(body)) return nullptr;
  const Path path = path_of(body);
  SweptBody& b = know(world_, body);
  b.path = path;
  return &b;
}

/// Those of a patch of scenery that looks the way of the hit.
void Sweeper::scenery_points(const SceneryPair& pair, const NarrowSettings& settings, const Vec3& normal,
                             Manifold& manifold) {
  SceneryPairFinder& pair_finder = world_.plan->scenery->pair_finder;
  SupportFault fault;
  try {
    if (!pair_finder.find(pair, settings, settings.manifold.contact_distance, report_.narrow, fault)) return;
  } catch (const std::bad_alloc&) {
    return;  // the sweep's own point does
  }
  for (const SceneryPatch& patch : pair_finder.patches()) {
    if (patch.normal.dot(-normal) < kSweepSamePatch || patch.count <= manifold.count) continue;
    manifold.count = 0;
    ContactPoint point[PatchPoints::kMax];
    for (int i = 0; i < patch.count; ++i) point[i] = exchanged(patch.point[i]);
    adopt(pair.convex_frame, point, patch.count, settings.manifold, manifold);
  }
}

/// Points of two that touch at the moment of a hit and look its way, as the narrow phase has them.
void Sweeper::find_points(const Strike& s, const Side& b, Manifold& manifold) {
  const Frame frame_a = s.a.path.frame(s.a.part, s.now), frame_b = b.path.frame(b.part, s.now);
  NarrowSettings settings = narrow_settings(world_.scene.dials);
  settings.manifold.kind = ManifoldKind::clip;
  settings.manifold.contact_distance = slack(s.a, b);
  const Shape &a = *s.a.part.shape, &shape_b = *b.part.shape;
  QueryMemory memory;
  SupportFault fault;
  if (is_scenery(shape_b) && world_.plan->scenery)
    scenery_points({shape_b, a, frame_b, frame_a}, settings, s.normal, manifold);
  find_manifold({a, shape_b, frame_a, frame_b, shells(settings.query) / 2}, settings, memory, manifold, report_.narrow,
                fault);
  if (fault.kind != SupportFault::none) manifold.count = 0;
  for (int k = 0; k < manifold.count; ++k)
    if (!(manifold.point[k].normal.dot(s.normal) > 0)) manifold.count = 0;  // the other side of what is thin
}

/// Flush neighbours of what still ground is hit, that are hit at the same moment: @see contact/seams.h.
template <class F>
void Sweeper::each_beside(const Strike& s, const F& f) {
  if (ground_of(world_, s.b.collider) != kStillGround || is_movable(s.b.body)) return;
  const Colliders& table = world_.scene.colliders;
  gather(*s.a.known, swept_box(*s.a.known, s.a.collider, s.now), s.now);
  for (const std::uint32_t other : c_.found) {
    const std::uint32_t body = table.body[other];
    if (other == s.b.collider || body == s.a.body || table.is_sensor(other) || is_movable(body) ||
        ground_of(world_, other) != kStillGround || !may_touch(table, s.a.collider, other) ||
        (filtered_ && !lets_touch(world_.scene, s.a.collider, other)) ||
        world_.scene.modes.forbids(+EffectId::response, body))
      continue;
    Side side{body, other, {}, path_of(body), nullptr};
    each_swept_part(world_, other, s.a.path.swept(s.now, s.now, s.a.known->radius), [&](const SweptPart& part) {
      side.part = part;
      f(side);
    });
  }
}

/// But for its velocities.
ImpactBody Sweeper::body_of(const Side& side, Real now) const {
  const Scene& scene = world_.scene;
  const Locks locks = scene.locks_of(side.body);
  ImpactBody b{};
  b.moves = is_movable(side.body), b.turns = b.moves && rotates(scene, side.body);
  b.inv_mass = b.moves ? scene.inv_mass[side.body] * free_axes(locks) : Vec3::zero();
  b.inv_inertia = Mat3::zero();
  if (side.is_joined()) {
    b.inv_mass = Vec3::constant(1 / side.whole.mass);
    b.inv_inertia = side.whole.inertia.inverse();
    return b;
  }
  if (!b.turns) return b;
  const Mat3 r = side.path.orientation(now).matrix();
  b.inv_inertia = locks & kAngularLocks ? inverse_of_free(r * scene.inertia[side.body] * r.transpose(), locks)
                                        : Mat3(r * scene.inv_inertia[side.body] * r.transpose());
  return b;
}

/// The impulse after which all points part as their materials want.
/// @return whether there was one: no point closes on velocities that already part
bool Sweeper::exchange(Strike& s) {
  const Scene& scene = world_.scene;
  for (Side* const side : {&s.a, &s.b})
    if (side->is_joined()) side->whole = whole_of(*c_.find(side->body), s.now);
  s.of = {body_of(s.a, s.now), body_of(s.b, s.now)};
  const auto centre = [&](const Side& side) { return side.is_joined() ? side.whole.centre : side.path.place(s.now); };
  const Vec3 x_a = centre(s.a), x_b = centre(s.b);

  // The moment on the parabolas: chords have come nearer by what these sag.
  const auto sag = [&](const Side& side) -> Vec3 {
    if (!side.known || !side.known->flies) return Vec3::zero();
    return side.known->accel * ((s.now - side.path.t) * (time_.h - s.now) / 2);
  };
  const auto move = [&](Real to) {
    const auto put = [&](const Side& side, ImpactBody& b) {
      const Velocity u = side.is_joined() ? Velocity{side.whole.v, side.whole.omega} : velocity(side, to, s.now);
      b.v = u.v, b.omega = u.omega;
    };
    s.moment = to;
    put(s.a, s.of.a), put(s.b, s.of.b);
  };
  move(s.now);
  const Real gap = s.normal.dot(sag(s.a) - sag(s.b));
  const Real closing = s.normal.dot(s.of.a.at(s.point - x_a) - s.of.b.at(s.point - x_b));
  if (closing > 0 && gap != 0) move(std::clamp(s.now + gap / closing, std::max(s.a.path.t, s.b.path.t), time_.h));
  const ImpactPair before = s.of;

  const Real threshold = scene.dials[Dial::restitution_speed];
  const Frame frame_a = s.a.path.frame(s.a.part, s.now);
  const bool locked = scene.locks_of(s.a.body) | scene.locks_of(s.b.body);
  const Real unlocked = locked ? s.of.a.moves * scene.inv_mass[s.a.body] + s.of.b.moves * scene.inv_mass[s.b.body] : 0;
  std::array<ImpactPoint, kMostHitPoints>& points = s.points;
  std::size_t& count = s.count;
  const auto add = [&](const Side& side, const Vec3& on_a, const Vec3& on_b, const Vec3& n) {
    if (count == points.size()) return;
    ImpactPoint& p = points[count++];
    const MixedMaterial material = mixed(scene, s.a.collider, side.collider);
    const Vec3 place = (on_a + on_b) / 2;
    p.mass.r_a = place - x_a, p.mass.r_b = place - x_b;
    const Mat3 cross_a = cross_matrix(p.mass.r_a), cross_b = cross_matrix(p.mass.r_b);
    p.mass.k = -cross_a * s.of.a.inv_inertia * cross_a - cross_b * s.of.b.inv_inertia * cross_b;
    p.mass.k.add_to_diagonal(s.of.a.inv_mass + s.of.b.inv_mass);
    p.row.n = n;
    p.row.friction = material.friction;
    p.be_ready(unlocked);
    const Real speed = n.dot(s.of.a.at(p.mass.r_a) - s.of.b.at(p.mass.r_b));
    p.want = wanted_speed(speed, material.restitution, threshold);
    s.speed = std::max(s.speed, speed);
  };
  const auto add_all = [&](const Side& side, Real least) {
    Manifold manifold;
    find_points(s, side, manifold);
    const Frame frame_b = side.path.frame(side.part, s.now);
    for (const ContactPoint& c : std::span(manifold.point, static_cast<std::size_t>(manifold.count)))
      if (c.normal.dot(s.normal) >= least) add(side, frame_a.apply(c.on_a), frame_b.apply(c.on_b), c.normal);
  };
  add_all(s.b, 0);
  if (count == 0) add(s.b, s.point, s.point, s.normal);  // the sweep's own
  each_beside(s, [&](const Side& side) { add_all(side, kSweepSamePatch); });
  if (s.speed > 0) {
    resolve_impact(s.of, std::span(points.data(), count), s.speed,
                   [&](const ImpactPoint& p) { return s.of.b.at(p.mass.r_b) - s.of.a.at(p.mass.r_a); });
    for (std::size_t k = 0; k < count; ++k) s.impulse += points[k].row.p_n;
  }
  turn_off(s.a, s, {s.of.a.v - before.a.v, s.of.a.omega - before.a.omega});
  turn_off(s.b, s, {s.of.b.v - before.b.v, s.of.b.omega - before.b.omega});
  for (Side* const side : {&s.a, &s.b})
    if (side->is_joined()) side->path.u = side->whole.v, side->path.w = side->whole.omega;
  for (std::size_t k = 0; k < count; ++k) {
    const Velocity path_a{s.a.path.u, s.a.path.w}, path_b{s.b.path.u, s.b.path.w};
    const ImpactPoint& p = points[k];
    s.sinks = std::max(s.sinks, p.row.n.dot(path_a.at(p.mass.r_a) - path_b.at(p.mass.r_b)));
  }
  return s.impulse > 0;
}

/// A body goes on with other velocities: what is stored changes by as much as the velocity of the moment, the place at
/// the end by what is left of it.
void Sweeper::turn_off(Side& side, Strike& s, const Velocity& change) {
  if (!is_movable(side.body) || (change.v == Vec3::zero() && change.omega == Vec3::zero())) return;
  const std::uint32_t i = side.body;
  if (side.is_joined()) {
    side.whole.v += change.v, side.whole.omega += change.omega;
    return lay_whole(*c_.find(i), side.whole, s.now);
  }
  if (world_.state.sleeps(i)) wake(world_, sleep_, i);
  SweptBody* const known = c_.find(i);
  motion_.v[i] += change.v;
  if (!known) {
    motion_.omega[i] += change.omega;
    return;
  }
  const Real rest = time_.h - s.now;
  const Vec3 end = known->path.place(time_.h) + (time_.h - s.moment) * change.v;
  known->changed = true;
  const bool turns = turns_by_own_method(i);
  const Vec3 omega = (turns ? velocity(side, s.moment, s.now).omega : motion_.omega[i]) + change.omega;
  known->path.go_on_from(s.now);
  Path& path = known->path;
  path.u = rest > 0 ? Vec3((end - path.x) / rest) : motion_.v[i];
  if (turns && rest > 0) {
    // The method itself, over what is left.
    poses_.q[i] = path.q, motion_.omega[i] = omega;
    c_.one.runs[0] = {i, i + 1};
    world_.plan->rotation_method->advance(world_, motion_, c_.one, rest);
    path.w = rotation_vector(world_.plan->predicted.q[i] * path.q.conjugate(), rest * omega) / rest;
  } else {
    motion_.omega[i] = omega;
    path.w += change.omega;
  }
  side.path = path;
}

/// Both along their velocities from now on. What is stored is ahead of the moment: where forces press the two together
/// for the rest of the substep, the contact bears that.
void Sweeper::brace(Strike& s) {
  aim(s.a, s.now), aim(s.b, s.now);
  Real closing = 0;
  const auto put = [](const Side& side, ImpactBody& b) {
    const Path& path = side.known && !side.is_joined() ? side.known->path : side.path;
    b.v = path.u, b.omega = path.w;
  };
  put(s.a, s.of.a), put(s.b, s.of.b);
  for (std::size_t k = 0; k < s.count; ++k) {
    ImpactPoint& p = s.points[k];
    p.row.set_impulse(Vec3::zero());
    p.want = 0;
    closing = std::max(closing, p.row.n.dot(s.of.a.at(p.mass.r_a) - s.of.b.at(p.mass.r_b)));
  }
  if (!(closing > 0)) return;
  resolve_impact(s.of, std::span(s.points.data(), s.count), closing,
                 [&](const ImpactPoint& p) { return s.of.b.at(p.mass.r_b) - s.of.a.at(p.mass.r_a); });
  const auto take = [&](Side& side, const ImpactBody& b) {
    if (!b.moves || !side.known) return;
    if (side.is_joined()) {
      side.whole.v = b.v, side.whole.omega = b.omega;
      return lay_whole(*c_.find(side.body), side.whole, s.now);
    }
    SweptBody& known = *c_.find(side.body);
    motion_.v[side.body] = known.path.u = b.v;
    if (b.turns) motion_.omega[side.body] = known.path.w = b.omega;
  };
  take(s.a, s.of.a), take(s.b, s.of.b);
}

/// Along its velocity from now on, and about its axis of now.
void Sweeper::aim(const Side& side, Real now) {
  SweptBody* const known = c_.find(side.body);
  if (!known || !is_movable(side.body) || known->is_joined()) return;
  const Velocity u = velocity(side, now, now);
  known->changed = true;
  known->path.go_on_from(now);
  known->path.u = motion_.v[side.body];
  known->path.w = motion_.omega[side.body] = u.omega;
}

}  // namespace carom::dynamics

// What a hit does: one impulse of all points that touch at that moment, and two bodies that go on from there.
#include <algorithm>
#include <array>

#include "collision/manifold/adopt.h"
#include "collision/narrow/hybrid.h"
#include "dynamics/ccd/sweeper.h"
#include "dynamics/contact/impulse.h"
#include "dynamics/detect.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

constexpr int kStrikeSweeps = 50;        // over the points, which depend on each other
constexpr Real kStrikeSamePatch = 0.99;  // cosine of 0.14 rad: a patch of scenery is of the hit
constexpr Real kStrikeSettled = 1e-13;   // of the speed of the impact: what the last sweep may still change

}  // namespace

struct Sweeper::Strike {
  Side a, b;
  Real now;     // s, on the path
  Real moment;  // s, on the parabolas of which the paths are chords
  Vec3 normal, point;
  Velocity of_a, of_b;                // at the moment, changed by the impulse
  Mat3 inv_inertia_a, inv_inertia_b;  // 1/(kg m^2), world; zero of what does not turn
  Vec3 inv_mass_a, inv_mass_b;        // 1/kg, along the world's axes; 0 of what a hit does not move, or a lock holds
  bool moves_a, moves_b;
  Real impulse = 0, speed = 0;  // N s; m/s, the fastest point's
  Real sinks = 0;               // m/s, at which the paths after it would still close
};

void Sweeper::strike(SweptBody& b) {
  const Colliders& table = world_.scene.colliders;
  const std::uint32_t other = table.body[b.other];
  SweptBody* const partner = take_up(other);
  Strike s;
  s.now = b.when, s.normal = b.normal, s.point = b.point;
  s.a = {b.body, b.own, b.own_piece, b.path, &b};
  s.b = {other, b.other, b.other_piece, path_of(other), partner};
  b.when = kInfinity;
  for (SweptBody* const p : {&b, partner})
    if (p && moved_by_hits(p->body)) ++p->hits;
  const bool struck = exchange(s);
  ++world_.report.sweep_hits;
  // Bodies that are pushed on by nothing but their path are aimed along their velocity, which does not close.
  const Real rest = time_.h - s.now;
  const bool astray = !struck || s.sinks * rest > slack(s.a, s.b);
  for (SweptBody* const p : {&b, partner}) {
    if (!p || !moved_by_hits(p->body)) continue;
    if (astray) aim(p == &b ? s.a : s.b, s.now);
    if (p->hits >= SweptBody::kMostHits) p->path.go_on_from(s.now), p->path.stay(), p->changed = true;
    ++p->version;
    p->swept |= goes_far(*p);
    if (!p->loose) p->loose = true, c_.loose.push_back(static_cast<std::uint32_t>(p - c_.bodies.data()));
  }
  look_ahead(b, s.now);
  if (partner && partner->swept) look_ahead(*partner, s.now);
  if (struck && c_.hits.size() < c_.most_hits) {
    const bool in_order = s.a.collider < s.b.collider;
    c_.hits.push_back({{std::min(s.a.collider, s.b.collider), std::max(s.a.collider, s.b.collider)},
                       static_cast<std::uint32_t>(c_.hits.size()),
                       s.point,
                       in_order ? s.normal : Vec3(-s.normal),
                       s.impulse,
                       s.speed});
  }
}

/// Whether a body that is hit would be a quarter of its thickness farther by the end of the step: then it is swept as
/// well. What contacts push apart later need not be found here, and hits do not run through a heap from one to the
/// next.
bool Sweeper::goes_far(const SweptBody& b) const {
  const Colliders& table = world_.scene.colliders;
  Real thin = kInfinity;
  for (std::uint32_t slot = world_.scene.first_collider[b.body]; slot != Colliders::kNone; slot = table.next[slot])
    thin = std::min(thin, (table.shape[slot]->bounds.hi - table.shape[slot]->bounds.lo).min_entry());
  return 4 * time_.dt * (b.path.u.norm() + b.radius * b.path.w.norm()) > thin;
}

/// The record of a body that is hit, made if there is room; null for what stands still or sleeps.
SweptBody* Sweeper::take_up(std::uint32_t body) {
  if (SweptBody* const known = c_.find(body)) return known;
  if (!moved_by_hits(body) || world_.state.sleeps(body) || c_.bodies.size() >= c_.most_bodies) return nullptr;
  const Path path = path_of(body);
  SweptBody& b = know(world_, body);
  b.path = path;
  return &b;
}

/// Those of a patch of scenery that looks the way of the hit.
void Sweeper::scenery_points(const SceneryPair& pair, const NarrowSettings& settings, const Vec3& normal,
                             Manifold& manifold) {
  SceneryMeeting& meeting = world_.plan->scenery->meeting;
  SupportFault fault;
  try {
    if (!meeting.find(pair, settings, settings.manifold.contact_distance, world_.report.narrow, fault)) return;
  } catch (const std::bad_alloc&) {
    return;  // the sweep's own point does
  }
  for (const SceneryPatch& patch : meeting.patches()) {
    if (patch.normal.dot(-normal) < kStrikeSamePatch || patch.count <= manifold.count) continue;
    manifold.count = 0;
    ContactPoint point[PatchPoints::kMax];
    for (int i = 0; i < patch.count; ++i) point[i] = exchanged(patch.point[i]);
    adopt(pair.convex_frame, point, patch.count, settings.manifold, manifold);
  }
}

/// Points that touch at the moment of a hit, as the narrow phase has them; where it finds none, the sweep's own.
int Sweeper::find_points(const Strike& s, Manifold& manifold) {
  const Frame frame_a = s.a.path.frame(s.a.piece, s.now), frame_b = s.b.path.frame(s.b.piece, s.now);
  NarrowSettings settings = narrow_settings(world_.scene.dials);
  settings.manifold.kind = ManifoldKind::clip;
  settings.manifold.contact_distance = slack(s.a, s.b);
  const Shape &a = *s.a.piece.shape, &b = *s.b.piece.shape;
  QueryMemory memory;
  Candidates found;
  SupportFault fault;
  if (is_scenery(b) && world_.plan->scenery) scenery_points({b, a, frame_b, frame_a}, settings, s.normal, manifold);
  collide(a, frame_a, b, frame_b, settings, memory, found, world_.report.narrow, fault);
  const PatchPair pair{a, b, frame_a, frame_b, shells(settings.query) / 2};
  PatchMemory patch;
  if (fault.kind == SupportFault::none && found.count > 0) {
    if (found.whole)
      adopt_patch(pair, found, settings.manifold, manifold, patch);
    else
      update_patch(pair, found, settings.manifold, manifold, patch, world_.report.narrow.support_calls, fault);
  }
  if (fault.kind != SupportFault::none) manifold.count = 0;
  for (int k = 0; k < manifold.count; ++k)
    if (!(manifold.point[k].normal.dot(s.normal) > 0)) manifold.count = 0;  // the other side of what is thin
  if (manifold.count > 0) return manifold.count;
  manifold.count = 1;
  manifold.point[0] = {};
  manifold.point[0].on_a = frame_a.apply_inverse(s.point), manifold.point[0].on_b = frame_b.apply_inverse(s.point);
  manifold.point[0].normal = s.normal;
  return 1;
}

/// The impulse after which all points part as their materials want.
/// @return whether there was one: no point closes on velocities that already part
bool Sweeper::exchange(Strike& s) {
  const Scene& scene = world_.scene;
  s.moves_a = moved_by_hits(s.a.body), s.moves_b = moved_by_hits(s.b.body);
  const auto inertia = [&](const Side& side, bool moves) -> Mat3 {
    if (!moves || !rotates(scene, side.body)) return Mat3::zero();
    const Mat3 r = side.path.orientation(s.now).matrix();
    const Locks locks = scene.locks_of(side.body);
    return locks & kAngularLocks ? inverse_of_free(r * scene.inertia[side.body] * r.transpose(), locks)
                                 : Mat3(r * scene.inv_inertia[side.body] * r.transpose());
  };
  const auto inv_mass = [&](std::uint32_t body, bool moves) -> Vec3 {
    return moves ? Vec3(scene.inv_mass[body] * free_axes(scene.locks_of(body))) : Vec3(Vec3::zero());
  };
  s.inv_mass_a = inv_mass(s.a.body, s.moves_a), s.inv_mass_b = inv_mass(s.b.body, s.moves_b);
  s.inv_inertia_a = inertia(s.a, s.moves_a), s.inv_inertia_b = inertia(s.b, s.moves_b);
  const Vec3 x_a = s.a.path.place(s.now), x_b = s.b.path.place(s.now);

  // The moment on the parabolas: chords have come nearer by what these sag.
  const auto sag = [&](const Side& side) -> Vec3 {
    if (!side.known || !side.known->flies) return Vec3::zero();
    return side.known->accel * ((s.now - side.path.t) * (time_.h - s.now) / 2);
  };
  s.moment = s.now;
  s.of_a = velocity(s.a, s.now), s.of_b = velocity(s.b, s.now);
  const Real gap = s.normal.dot(sag(s.a) - sag(s.b));
  const Real closing = s.normal.dot(s.of_a.at(s.point - x_a) - s.of_b.at(s.point - x_b));
  if (closing > 0 && gap != 0) {
    s.moment = std::clamp(s.now + gap / closing, std::max(s.a.path.t, s.b.path.t), time_.h);
    s.of_a = velocity(s.a, s.moment), s.of_b = velocity(s.b, s.moment);
  }
  const Velocity before_a = s.of_a, before_b = s.of_b;

  Manifold manifold;
  find_points(s, manifold);
  const MixedMaterial material = mixed(scene, s.a.collider, s.b.collider);
  const Real threshold = scene.dials[Dial::restitution_speed];
  const Frame frame_a = s.a.path.frame(s.a.piece, s.now), frame_b = s.b.path.frame(s.b.piece, s.now);
  struct Point {
    Row row;
    RowMass mass;
    Real want;
  };
  std::array<Point, Manifold::kMaxPoints> points;
  const auto count = static_cast<std::size_t>(manifold.count);
  for (std::size_t k = 0; k < count; ++k) {
    const ContactPoint& c = manifold.point[k];
    Point& p = points[k];
    const Vec3 place = (frame_a.apply(c.on_a) + frame_b.apply(c.on_b)) / 2;
    p.mass.r_a = place - x_a, p.mass.r_b = place - x_b;
    const Mat3 cross_a = cross_matrix(p.mass.r_a), cross_b = cross_matrix(p.mass.r_b);
    p.mass.k = -cross_a * s.inv_inertia_a * cross_a - cross_b * s.inv_inertia_b * cross_b;
    p.mass.k.add_to_diagonal(s.inv_mass_a + s.inv_mass_b);
    p.mass.k_inv = p.mass.k.inverse();
    p.row.n = c.normal;
    p.row.friction = material.friction;
    p.row.k_n = c.normal.dot(p.mass.k * c.normal);
    p.row.set_impulse(Vec3::zero());
    const Real speed = c.normal.dot(s.of_a.at(p.mass.r_a) - s.of_b.at(p.mass.r_b));
    p.want = speed > 0 && !(speed > threshold) ? 0 : material.restitution * speed;
    s.speed = std::max(s.speed, speed);
  }
  if (s.speed > 0) {
    for (int sweep = 0; sweep < kStrikeSweeps; ++sweep) {
      Real most = 0;
      for (std::size_t k = 0; k < count; ++k) {
        Point& p = points[k];
        p.row.u = s.of_b.at(p.mass.r_b) - s.of_a.at(p.mass.r_a);
        const Vec3 next = resolved_impulse(p.row, p.mass, p.want), change = next - p.row.p;
        p.row.set_impulse(next);
        s.of_a.v -= s.inv_mass_a.times(change), s.of_a.omega -= s.inv_inertia_a * p.mass.r_a.cross(change);
        s.of_b.v += s.inv_mass_b.times(change), s.of_b.omega += s.inv_inertia_b * p.mass.r_b.cross(change);
        most = std::max(most, change.norm() * p.row.k_n);
      }
      if (!(most > kStrikeSettled * s.speed)) break;
    }
    for (std::size_t k = 0; k < count; ++k) s.impulse += points[k].row.p_n;
  }
  turn_off(s.a, s, {s.of_a.v - before_a.v, s.of_a.omega - before_a.omega});
  turn_off(s.b, s, {s.of_b.v - before_b.v, s.of_b.omega - before_b.omega});
  for (std::size_t k = 0; k < count; ++k) {
    const Velocity path_a{s.a.path.u, s.a.path.w}, path_b{s.b.path.u, s.b.path.w};
    const Point& p = points[k];
    s.sinks = std::max(s.sinks, p.row.n.dot(path_a.at(p.mass.r_a) - path_b.at(p.mass.r_b)));
  }
  return s.impulse > 0;
}

/// A body goes on with other velocities: what is stored changes by as much as the velocity of the moment, the place at
/// the end by what is left of it.
void Sweeper::turn_off(Side& side, Strike& s, const Velocity& change) {
  if (!moved_by_hits(side.body) || (change.v == Vec3::zero() && change.omega == Vec3::zero())) return;
  State& state = world_.state;
  const std::uint32_t i = side.body;
  if (world_.state.sleeps(i)) wake(world_, i);
  SweptBody* const known = c_.find(i);
  state.v[i] += change.v;
  if (!known) {
    state.omega[i] += change.omega;
    return;
  }
  const Real rest = time_.h - s.now;
  const Vec3 end = known->path.place(time_.h) + (time_.h - s.moment) * change.v;
  known->changed = true;
  const bool turns = carried(i);
  const Vec3 omega = (turns ? velocity(side, s.moment).omega : state.omega[i]) + change.omega;
  known->path.go_on_from(s.now);
  Path& path = known->path;
  path.u = rest > 0 ? Vec3((end - path.x) / rest) : state.v[i];
  if (turns && rest > 0) {
    // The method itself, over what is left.
    state.q[i] = path.q, state.omega[i] = omega;
    c_.one.runs[0] = {i, i + 1};
    world_.plan->rotation_method->advance(world_, c_.one, rest);
    path.w = rotation_vector(world_.plan->proposal.q[i] * path.q.conjugate(), rest * omega) / rest;
  } else {
    state.omega[i] = omega;
    path.w += change.omega;
  }
  side.path = path;
}

/// Along its velocity from now on, and about its axis of now.
void Sweeper::aim(const Side& side, Real now) {
  SweptBody* const known = c_.find(side.body);
  State& s = world_.state;
  const Velocity u = velocity(side, now);
  known->changed = true;
  known->path.go_on_from(now);
  known->path.u = s.v[side.body];
  known->path.w = s.omega[side.body] = u.omega;
}

}  // namespace carom::dynamics

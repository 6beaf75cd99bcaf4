// One move of a character.
#include "kit/mover.h"

#include "kit/bodies.h"

namespace carom::kit {
namespace {

constexpr Real kMargin = 0.02;     // of the skin: moved back after a stop, so that no cast begins in touch
constexpr Real kLeast = 1e-9;      // m: a shorter motion is none
constexpr int kMostStops = 8;      // of a motion; what is left of it then is dropped
constexpr int kMostSteps = 3;      // of a move
constexpr Real kStepSlack = 1e-5;  // m: a step may be higher by so much, which is more than casts err by
constexpr Real kLeap = 100;        // m/s: ground whose pose a host moves faster has no velocity that a jump could take
constexpr Real kUpright = 0.17;    // sine of 10 degrees: what leans back by less is a wall to one that looks for ground
constexpr Real kLeastLift = 0.2;   // cosine: contacts that lean more do not lift the shape any farther off

/// Velocities follow a wish at a bounded rate; the way in between is exact, whatever dt.
/// @param v  m/s, in and out   @return m
Vec3 approach(Vec3& v, const Vec3& wish, Real rate, Real dt) {
  const Vec3 change = wish - v;
  const Real speed = change.norm();
  if (speed <= rate * dt) {
    const Real t = speed > 0 ? speed / rate : 0;
    const Vec3 way = (0.5 * t) * (v + wish) + (dt - t) * wish;
    v = wish;
    return way;
  }
  const Vec3 before = v;
  v += (rate * dt / speed) * change;
  return (0.5 * dt) * (before + v);
}

void put(const Vec3& v, double* to) { to[0] = v[0], to[1] = v[1], to[2] = v[2]; }
void put(const Quat& q, double* to) { to[0] = q.x(), to[1] = q.y(), to[2] = q.z(), to[3] = q.w(); }

}  // namespace

Mover::Mover(Call& call, carom_world* world, const carom_character_desc& desc, carom_character& character, Real dt)
    : call_(call),
      world_(world),
      desc_(desc),
      c_(character),
      probe_(call, world, 3),
      dt_(dt),
      skin_(desc.skin),
      margin_(kMargin * desc.skin),
      least_up_(sin_cos(desc.max_slope).cos),
      up_(Vec3::from(desc.up).normalized()),
      p_(Vec3::from(character.position)),
      ground_velocity_(Vec3::from(character.ground_velocity)) {
  probe_.look_for(desc.category, desc.mask, desc.body);
  probe_.set_shape(character.shape, quat_of(character.orientation));
}

bool Mover::move(const Vec3& wish, Real jump) {
  const bool flies = desc_.flags & CAROM_CHARACTER_FLIES;
  c_.contact_count = 0;
  for (double& x : c_.contact_points) x = 0;
  for (double& x : c_.contact_normals) x = 0;
  for (double& x : c_.contact_speeds) x = 0;
  for (carom_body& body : c_.contact_bodies) body = CAROM_NULL_HANDLE;
  if (!follow_ground() || !recover()) return false;
  const bool walks = !flies && c_.ground == CAROM_GROUND_FIRM && jump == 0;
  if (!(flies ? fly(wish) : walks ? walk(across(wish)) : fall(across(wish), jump))) return false;
  put(p_, c_.position);
  return true;
}

// ---- the ground moves ----

bool Mover::follow_ground() {
  if (c_.ground != CAROM_GROUND_FIRM || c_.ground_body == CAROM_NULL_HANDLE) return true;
  carom_error inner = CAROM_ERROR_INIT;
  double position[3], orientation[4];
  const std::int32_t result = carom_body_get_pose(world_, c_.ground_body, position, orientation, &inner);
  if (is_gone(result)) {
    c_.ground_body = CAROM_NULL_HANDLE, c_.ground_collider = CAROM_NULL_HANDLE;
    return true;
  }
  if (!call_.passed(result, inner, 3)) return false;

  const Vec3 feet = p_ - (c_.foot + skin_ + margin_) * up_;
  Vec3 way = Vec3::zero(), surface = Vec3::zero();
  bool moved = false;
  for (int k = 0; k < 3; ++k) moved = moved || position[k] != c_.ground_position[k];
  for (int k = 0; k < 4; ++k) moved = moved || orientation[k] != c_.ground_orientation[k];
  const Pose before{quat_of(c_.ground_orientation), Vec3::from(c_.ground_position)};
  const Pose now{quat_of(orientation), Vec3::from(position)};
  const Quat turn = now.q * before.q.conjugate();
  if (moved) {
    // By differences, so that places far from the origin lose nothing.
    way = (now.p - before.p) + (turn * (feet - before.p) - (feet - before.p));
    const Vec3 touched = Vec3::from(c_.ground_point);
    put(now.p + turn * (touched - before.p), c_.ground_point);
    const Real lean = turn.vec().dot(up_), length = std::sqrt(turn.w() * turn.w() + lean * lean);
    if ((desc_.flags & CAROM_CHARACTER_TURNS) && length > 1e-6) {
      const Vec3 axis = (lean / length) * up_;
      const Quat about_up(turn.w() / length, axis.x(), axis.y(), axis.z());
      put((about_up * quat_of(c_.orientation)).normalized(), c_.orientation);
      probe_.set_shape(c_.shape, quat_of(c_.orientation));
    }
  }
  if (!velocity_at(call_, world_, c_.ground_body, feet, ground_velocity_) || !follow_surface(feet, surface))
    return false;
  const bool teleports = way.norm() > kLeap * dt_;
  if (moved && ground_velocity_.is_zero() && !teleports) ground_velocity_ = way / dt_;  // moved by poses
  ground_velocity_ += surface;
  put(ground_velocity_, c_.ground_velocity);
  way += dt_ * surface;
  Planes planes;
  return way.is_zero() || slide_through(way, ground_velocity_, c_.ground_body, planes);
}

/// The velocity of a conveyor in its plane. @see carom_collider_set_surface_velocity()
bool Mover::follow_surface(const Vec3& point, Vec3& velocity) {
  carom_error inner = CAROM_ERROR_INIT;
  Vec3 linear, angular;
  if (c_.ground_collider == CAROM_NULL_HANDLE) return true;
  std::int32_t result =
      carom_collider_get_surface_velocity(world_, c_.ground_collider, linear.data(), angular.data(), &inner);
  if (is_gone(result)) return true;
  if (!call_.passed(result, inner, 3)) return false;
  if (linear.is_zero() && angular.is_zero()) return true;
  carom_collider_desc collider;
  carom_collider_desc_init(&collider, sizeof collider);
  carom_body body;
  double position[3], orientation[4];
  if (!call_.passed(carom_collider_get(world_, c_.ground_collider, &collider, &body, &inner), inner, 3) ||
      !call_.passed(carom_body_get_pose(world_, body, position, orientation, &inner), inner, 3))
    return false;
  const Pose of_body{quat_of(orientation), Vec3::from(position)};
  const Pose pose = of_body * Pose{quat_of(collider.orientation), Vec3::from(collider.position)};
  velocity = pose.q * (linear + angular.cross(pose.q.conjugate() * (point - pose.p)));
  const Vec3 normal = Vec3::from(c_.ground_normal);
  velocity -= velocity.dot(normal) * normal;
  return true;
}

// ---- out of what it overlaps ----

/// Deepest first, each along its normal, at a bounded speed, and never into anything else.
bool Mover::recover() {
  Real budget = desc_.recover_speed * dt_;
  for (int i = 0; i < kMostStops && budget > kLeast; ++i) {
    Met met;
    if (!probe_.nearest(p_, skin_, met)) return false;
    const Real missing = skin_ - met.separation;
    if (!met.any || missing < 0.05 * margin_) return true;
    const Real lift = met.normal.dot(up_);
    // Off firm ground along up: else it would creep down a slope.
    const bool stands_on = c_.ground == CAROM_GROUND_FIRM && is_firm(met.normal);
    const Vec3 out = stands_on ? up_ / lift : met.normal;
    const Vec3 way = smaller(missing + margin_, budget) * out;
    Met stop;
    if ((!stands_on && !touch(met, Vec3::zero())) || !sweep(way, stop)) return false;
    const Real share = stop.any ? stop.time : 1;
    p_ += share * way;
    budget -= share * smaller(missing + margin_, budget);
    if (share * missing < kLeast) return true;  // squeezed
  }
  return true;
}

// ---- on the ground ----

bool Mover::walk(const Vec3& wish) {
  Vec3 v = across(Vec3::from(c_.velocity));
  Way way;
  way.wish = approach(v, wish, desc_.acceleration, dt_);
  const Vec3 normal = Vec3::from(c_.ground_normal);
  way.ground.add(is_firm(normal) ? normal : up_);
  way.base = larger(foot_level(), Vec3::from(c_.ground_point).dot(up_));
  if (!go(way)) return false;
  v = slide_across(v, way.walls);
  put(v, c_.velocity);
  return look_for_ground(desc_.step_down, v + ground_velocity_, way.stepped);
}

bool Mover::go(Way& way) {
  int steps = 0;
  for (int i = 0; i < kMostStops; ++i) {
    const Vec3 ahead = way.left * slide_across(way.wish, way.walls);
    if (ahead.norm() < kLeast) break;
    // As high as the highest of the planes of ground, so that no two of them send it to and fro.
    Real rise = -kInfinity;
    Vec3 ground = up_;
    for (int k = 0; k < way.ground.count; ++k) {
      const Vec3& n = way.ground.normals[k];
      const Real by = -ahead.dot(n) / n.dot(up_);
      if (by > rise) rise = by, ground = n;
    }
    const Vec3 motion = ahead + rise * up_;
    Met met;
    if (!sweep(motion, met)) return false;
    if (!met.any) {
      p_ += motion;
      break;
    }
    const Real share = advance(motion, met);
    way.left *= 1 - share;
    const Vec3 rest = (1 - share) * ahead;
    if (is_firm(met.normal)) {
      way.base = larger(way.base, met.point.dot(up_));
      way.ground.add(met.normal);
      continue;
    }
    bool done = false;
    if (steps < kMostSteps && !step_up(way, rest, met, done)) return false;
    if (done) {
      ++steps;
      continue;
    }
    const Vec3 speed = (dt_ > 0 ? way.wish / dt_ : Vec3::zero()) + ground_velocity_;
    if (!touch(met, speed)) return false;
    // Steep ground stands upright to one that walks. What leans over is met where the ground leads.
    const Real lift = met.normal.dot(up_);
    const Vec3 wall = lift > 0 ? across(met.normal) : across(met.normal - (lift / ground.dot(up_)) * ground);
    const Real length = wall.norm();
    if (!(length > 1e-6)) break;  // a ceiling that the ground runs along and into: no way ahead is known
    way.walls.add(wall / length);
  }
  return true;
}

/// Whether what was met ahead is a step: firm ground on its top, no more than step_up above where it stands.
/// @param height  m, of it above the foot; 0: it is none
bool Mover::is_step(const Way& way, const Vec3& ahead, const Met& met, Real& height) {
  height = 0;
  if (!(desc_.step_up > 0) || met.normal.dot(up_) < -0.02) return true;
  const Vec3 wall = across(met.normal);
  const Real length = wall.norm(), distance = ahead.norm();
  if (!(length > 1e-3) || !(ahead.dot(wall) < 0)) return true;
  // A ray down, just behind the point of contact.
  const Real top = way.base + desc_.step_up + kStepSlack;
  const Vec3 behind = met.point - (0.1 * skin_ / length) * wall;
  Met found;
  const Real low = foot_level();
  if (!probe_.ray(behind + (top - behind.dot(up_)) * up_, (low - top) * up_, found)) return false;
  const Real level = (1 - found.time) * (top - low);
  if (found.any && !found.overlap && found.time > 0 && level > 0.1 * margin_ && is_firm(found.normal)) {
    height = level;
    return true;
  }
  // What is too round for a ray: the shape itself, a radius ahead.
  const Vec3 start = p_;
  const Real probe = c_.reach + skin_;
  Met above, beyond, below;
  const Vec3 lift = desc_.step_up * up_, along = (larger(probe, distance) / distance) * ahead;
  if (!sweep(lift, above)) return false;
  const Real raised = above.any ? above.time : 1;
  p_ += raised * lift;
  if (!sweep(along, beyond)) return false;
  if (!beyond.any) {
    p_ += along;
    if (!sweep(-(raised * desc_.step_up + margin_) * up_, below)) return false;
    const Real landed = below.point.dot(up_);
    if (below.any && !below.overlap && is_firm(below.normal) && landed > low + margin_ && landed <= top)
      height = landed - low;
  }
  p_ = start;
  return true;
}

/// Up, along, down: no farther along than it walks.
bool Mover::step_up(Way& way, const Vec3& ahead, const Met& met, bool& done) {
  done = false;
  Real height = 0;
  if (!is_step(way, ahead, met, height)) return false;
  if (height == 0) return true;
  const Vec3 start = p_;
  const Vec3 lift = (desc_.step_up + margin_) * up_;
  Met above, beyond, below;
  if (!sweep(lift, above)) return false;
  const Real raised = above.any ? above.time : 1;
  if (raised * (desc_.step_up + margin_) < height) return true;  // something is above
  p_ += raised * lift;
  if (!sweep(ahead, beyond)) return false;
  const Real share = beyond.any ? clear_share(ahead, beyond) : 1;
  if (share * ahead.norm() < kLeast) {
    p_ = start;
    return true;
  }
  p_ += share * ahead;
  const Vec3 down = -raised * lift;
  if (!sweep(down, below)) return false;
  p_ += (below.any ? below.time : 1) * down;
  if (below.any) {
    p_ += (margin_ / larger(below.normal.dot(up_), kLeastLift)) * up_;
    way.base = larger(foot_level(), below.point.dot(up_));
  }
  way.left *= 1 - share;
  way.ground.count = 0;
  way.ground.add(below.any && is_firm(below.normal) ? below.normal : up_);
  way.stepped = done = true;
  return true;
}

// ---- in the air ----

bool Mover::fall(const Vec3& wish, Real jump) {
  Vec3 v = Vec3::from(c_.velocity);
  const bool takes_off = c_.ground == CAROM_GROUND_FIRM;
  // The ground has taken it through this dt already, so as it takes off it moves relative to that, and in the world
  // from the next move on.
  const Vec3 frame = takes_off ? ground_velocity_ : Vec3::zero();
  if (takes_off) v += jump * up_;
  Vec3 along = across(v), aim = wish;
  if (!takes_off) aim += across(ground_velocity_);
  if (c_.ground == CAROM_GROUND_STEEP) {  // it slides down, and cannot walk up
    const Vec3 wall = across(Vec3::from(c_.ground_normal)).normalized();
    const Real into = smaller((aim - along).dot(wall), 0.0);
    aim -= into * wall;
  }
  Vec3 vertical(v.dot(up_), 0, 0);
  const Vec3 drop = approach(vertical, Vec3(-desc_.fall_speed, 0, 0), desc_.gravity, dt_);
  const Vec3 way = approach(along, aim, desc_.air_acceleration, dt_) + drop.x() * up_;
  v = along + vertical.x() * up_;

  c_.ground = CAROM_GROUND_AIR;
  Planes planes;
  Real left = 1;
  for (int i = 0; i < kMostStops; ++i) {
    const Vec3 motion = left * slide(way, planes);
    if (motion.norm() < kLeast) break;
    Met met;
    if (!sweep(motion, met)) return false;
    if (!met.any) {
      p_ += motion;
      break;
    }
    left *= 1 - advance(motion, met);
    if (is_firm(met.normal)) return land(met, v + frame, left * across(way));
    if (!touch(met, v + frame)) return false;
    if (!planes.add(met.normal)) break;
  }
  return look_for_ground(0.1 * skin_, slide(v, planes) + frame, false);
}

/// Firm ground under one that falls: what is left of the way goes along it.
bool Mover::land(const Met& met, const Vec3& velocity, const Vec3& rest) {
  if (!touch(met, velocity)) return false;
  Way way;
  way.wish = rest;
  way.ground.add(met.normal);
  way.base = met.point.dot(up_);
  if (!go(way)) return false;
  const Vec3 v = velocity.dot(up_) * up_ + slide_across(across(velocity), way.walls);
  return look_for_ground(desc_.step_down, v, way.stepped);
}

bool Mover::fly(const Vec3& wish) {
  Vec3 v = Vec3::from(c_.velocity);
  if (c_.ground == CAROM_GROUND_FIRM) v += ground_velocity_;
  const Vec3 way = approach(v, wish, desc_.acceleration, dt_);
  Planes planes;
  if (!slide_through(way, v, CAROM_NULL_HANDLE, planes)) return false;
  ground_velocity_ = Vec3::zero();
  return leave_ground(slide(v, planes));
}

/// The share of a motion after which it is a margin clear of what it meets.
Real Mover::clear_share(const Vec3& motion, const Met& met) const {
  const Real into = -motion.dot(met.normal);
  return into > 0 ? larger(met.time - margin_ / into, 0.0) : met.time;
}

/// Move up to what was met.   @return the share of the motion that was taken
Real Mover::advance(const Vec3& motion, const Met& met) {
  const Real share = clear_share(motion, met);
  p_ += share * motion;
  return share;
}

bool Mover::slide_through(const Vec3& motion, const Vec3& velocity, carom_body skip, Planes& planes) {
  Real left = 1;
  for (int i = 0; i < kMostStops; ++i) {
    const Vec3 ahead = left * slide(motion, planes);
    if (ahead.norm() < kLeast) break;
    Met met;
    if (!sweep(ahead, met, skip)) return false;
    if (!met.any) {
      p_ += ahead;
      break;
    }
    left *= 1 - advance(ahead, met);
    if (!touch(met, velocity)) return false;
    if (!planes.add(met.normal)) break;
  }
  return true;
}

// ---- what is under it ----

/// @param reach     m, how far down   @param velocity  m/s, world
/// @param stepped   what it meets is firm, whatever its normal
bool Mover::look_for_ground(Real reach, const Vec3& velocity, bool stepped) {
  const Vec3 start = p_;
  const bool walks = c_.ground == CAROM_GROUND_FIRM;
  Real left = reach + 2 * margin_;
  Planes walls;
  Met met;
  for (int i = 0; i < 3; ++i) {  // past walls that lean back a little
    const Vec3 down = slide(-left * up_, walls);
    if (!sweep(down, met)) return false;
    if (!met.any) break;
    p_ += met.time * down;
    left *= 1 - met.time;
    if (stepped || met.normal.dot(up_) >= kUpright || left < margin_) break;
    p_ += margin_ * met.normal;
    if (!walls.add(met.normal)) break;
  }
  Vec3 at_ground = Vec3::zero();
  if (met.any && !velocity_at(call_, world_, met.body, met.point, at_ground)) return false;
  const bool flies_off = !walks && (velocity - at_ground).dot(met.normal) > 1e-6;
  if (!met.any || flies_off) {
    p_ = start;
    return leave_ground(velocity);
  }
  Vec3 normal = met.normal;
  bool firm = is_firm(normal);
  if (!firm) {
    Met under;
    if (!probe_.ray(p_, -(c_.foot + skin_ + reach + 2 * margin_) * up_, under)) return false;
    if (under.any && under.time > 0 && is_firm(under.normal)) firm = true, normal = under.normal;
  }
  if (!firm && (start - p_).dot(up_) > 4 * margin_ && !stepped) {
    p_ = start;
    return leave_ground(velocity);
  }
  if (!firm) {
    normal = up_;
    if (stepped)
      firm = true;
    else if (!is_held(met, firm))
      return false;
  }
  if (!firm) {
    p_ = start;
    put(velocity, c_.velocity);
    put(ground_velocity_, c_.ground_velocity);
    return stand(met, met.normal, CAROM_GROUND_STEEP);
  }
  p_ += (margin_ / larger(met.normal.dot(up_), kLeastLift)) * up_;
  if ((p_ - start).norm() < 0.05 * margin_) p_ = start;  // at rest to the bit
  const bool same = walks && c_.ground_body == met.body;
  if (!same) put(across(velocity - at_ground), c_.velocity);
  put(same ? ground_velocity_ : at_ground, c_.ground_velocity);
  return stand(met, normal, CAROM_GROUND_FIRM);
}

/// Whether it cannot slide down the steep surface that it touches, because others hold it.
bool Mover::is_held(const Met& met, bool& held) {
  const Vec3 start = p_;
  Planes planes;
  Met next = met;
  held = false;
  for (int i = 0; i < 3 && !held && next.any && planes.add(next.normal); ++i) {
    held = slide(-up_, planes).dot(up_) > -0.02;
    if (held) break;
    p_ += margin_ * next.normal;
    if (!sweep(skin_ * slide(-up_, planes), next)) return false;
    if (next.any && next.normal.dot(up_) < -1e-6) break;
  }
  p_ = start;
  return true;
}

bool Mover::stand(const Met& met, const Vec3& normal, std::uint32_t ground) {
  c_.ground = ground;
  c_.ground_body = met.body, c_.ground_collider = met.collider;
  put(met.point, c_.ground_point);
  put(normal, c_.ground_normal);
  carom_error inner = CAROM_ERROR_INIT;
  return call_.passed(carom_body_get_pose(world_, met.body, c_.ground_position, c_.ground_orientation, &inner), inner,
                      3);
}

/// Into the air.   @param velocity  m/s, world
bool Mover::leave_ground(const Vec3& velocity) {
  put(velocity, c_.velocity);
  put(ground_velocity_, c_.ground_velocity);
  c_.ground = CAROM_GROUND_AIR;
  c_.ground_body = CAROM_NULL_HANDLE, c_.ground_collider = CAROM_NULL_HANDLE;
  put(p_ - c_.foot * up_, c_.ground_point);
  put(up_, c_.ground_normal);
  return true;
}

/// Note what is in the way, and how fast it would be met. Contacts of one body with one normal are one.
bool Mover::touch(const Met& met, const Vec3& velocity) {
  Vec3 of_body;
  if (!velocity_at(call_, world_, met.body, met.point, of_body)) return false;
  const Real speed = larger((of_body - velocity).dot(met.normal), 0.0);
  for (std::uint32_t i = 0; i < c_.contact_count; ++i)
    if (c_.contact_bodies[i] == met.body && met.normal.dot(Vec3::from(c_.contact_normals + 3 * i)) > 0.99) {
      c_.contact_speeds[i] = larger(c_.contact_speeds[i], speed);
      return true;
    }
  if (c_.contact_count == CAROM_CHARACTER_CONTACTS) return true;
  const std::uint32_t i = c_.contact_count++;
  c_.contact_bodies[i] = met.body;
  put(met.point, c_.contact_points + 3 * i);
  put(met.normal, c_.contact_normals + 3 * i);
  c_.contact_speeds[i] = speed;
  return true;
}

}  // namespace carom::kit

// One drive of a vehicle.
#include "kit/drive.h"

#include "kit/bodies.h"
#include "kit/engine_model.h"
#include "kit/probe.h"

namespace carom::kit {
namespace {

constexpr Real kPart = 1e-3;         // s: springs and tyres of cars are slow beside it
constexpr Real kBumpStop = 10;       // times the spring
constexpr Real kLeastUpright = 0.3;  // cosine: ground that leans more from a wheel's axis bears it no better
constexpr Real kTurn = 6.28318530717958647693;

/// What a wheel stands on.
struct Ground {
  bool any = false;
  Vec3 center;    // m, world: of the wheel where it touches this ground
  Vec3 to_point;  // m, from there to where it touches
  Vec3 normal;
  BodyMotion motion;  // of the body that it is part of, which goes on as it moves now
  Vec3 velocity;      // m/s, of the ground there

  void move(Real h) {
    center += h * motion.at(center);
    to_point += h * motion.angular.cross(to_point);
    normal = (normal + h * motion.angular.cross(normal)).normalized();
    motion.center += h * motion.linear;
  }
};

/// A wheel through a drive.
struct Wheel {
  const carom_wheel_desc* desc;
  carom_wheel* state;
  Ground ground;
  Tyre tyre;
  Real compression = 0, rate = 0;  // m, m/s
  Real mass = 0;                   // kg: of the chassis, for a push up at this wheel
  Real ahead = 1, left = 0;        // cosine and sine of the steering angle
  Vec3 point;                      // m, world
  Real load = 0;                   // N, of the part
  Vec3 force_sum = Vec3::zero();   // N
  Real load_sum = 0, along_sum = 0, across_sum = 0;
};

/// The chassis as a free body.
struct Chassis {
  Pose pose;      // of the body frame
  Vec3 center_b;  // m, of mass
  Vec3 v, w;      // m/s of the centre, rad/s
  Real mass;
  Mat3 inertia_b;  // kg m^2; zero: it does not rotate
  Mat3 inverse_b;
  Vec3 steady;   // N: weight and pending forces
  Vec3 turning;  // N m: pending

  Vec3 center() const { return pose.apply(center_b); }
  Vec3 velocity_at(const Vec3& point) const { return v + w.cross(point - center()); }

  void move(const Vec3& force, const Vec3& torque, Real h) {
    Vec3 c = center();
    v += (h / mass) * (force + steady);
    const Mat3 r = pose.q.matrix();
    const Vec3 spin_b = r.transpose() * w, torque_b = r.transpose() * (torque + turning);
    w += r * (inverse_b * (h * (torque_b - spin_b.cross(inertia_b * spin_b))));
    c += h * v;
    const Vec3 half = (0.5 * h) * w;
    pose.q = (pose.q + Quat(0, half.x(), half.y(), half.z()) * pose.q).normalized();
    pose.p = c - pose.q * center_b;
  }
};

struct Drive {
  Drive(Call& of, carom_world* in, Driven& what, Real duration) : call(of), world(in), driven(what), dt(duration) {}

  Call& call;
  carom_world* world;
  Driven& driven;
  Real dt;
  Chassis chassis;
  Wheel wheels[CAROM_VEHICLE_WHEELS];
  Vec3 force_sum = Vec3::zero(), torque_sum = Vec3::zero();
  Vec3 up_b, forward_b, left_b;

  bool read_chassis();
  bool look_down();
  void steer();
  void press(Real h);
  void part(Real h);
  void turn_wheels(const Real along[], const Real yields[], Real h);
  void write_states(Real parts);
  bool write_forces(Real parts);
};

bool Drive::read_chassis() {
  const carom_body body = driven.desc.chassis;
  carom_error inner = CAROM_ERROR_INIT;
  double position[3], orientation[4], linear[3], angular[3], mass, center[3], tensor[9], gravity[3], factor, pending[6];
  std::uint32_t type = 0;
  if (!call.passed(carom_body_get_type(world, body, &type, &inner), inner, 2)) return false;
  if (type != CAROM_BODY_DYNAMIC) return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->chassis is not a dynamic body");
  if (!call.passed(carom_body_get_pose(world, body, position, orientation, &inner), inner, 2) ||
      !call.passed(carom_body_get_velocity(world, body, linear, angular, &inner), inner, 2) ||
      !call.passed(carom_body_get_mass(world, body, &mass, center, tensor, &inner), inner, 2) ||
      !call.passed(carom_body_get_gravity_factor(world, body, &factor, &inner), inner, 2) ||
      !call.passed(carom_world_get_gravity(world, gravity, &inner), inner, 1) ||
      !call.passed(carom_world_read(world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, &body, 1, pending, 0, &inner), inner,
                   2))
    return false;
  chassis.pose = {quat_of(orientation), Vec3::from(position)};
  chassis.center_b = Vec3::from(center);
  chassis.v = Vec3::from(linear), chassis.w = Vec3::from(angular);
  chassis.mass = mass;
  chassis.inertia_b = Mat3::from_rows(tensor);
  chassis.inverse_b = chassis.inertia_b.determinant() > 0 ? chassis.inertia_b.inverse() : Mat3::zero();
  chassis.steady = (mass * factor) * Vec3::from(gravity) + Vec3::from(pending);
  chassis.turning = Vec3::from(pending + 3);
  up_b = Vec3::from(driven.desc.up).normalized();
  forward_b = Vec3::from(driven.desc.forward);
  forward_b = (forward_b - forward_b.dot(up_b) * up_b).normalized();
  left_b = up_b.cross(forward_b);
  return true;
}

/// By a ray from a radius above the highest place of the wheel, or by its shape from there.
bool Drive::look_down() {
  Probe probe(call, world, 3);
  probe.look_for(driven.desc.category, driven.desc.mask, driven.desc.chassis);
  const Vec3 up = chassis.pose.q * up_b;
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    const carom_wheel_desc& d = driven.wheel_descs[i];
    w.desc = &d, w.state = &driven.wheels[i];
    const Vec3 turn = (Vec3::from(d.position) - chassis.center_b).cross(up_b);
    w.mass = 1 / (1 / chassis.mass + turn.dot(chassis.inverse_b * turn));
    w.tyre.deflection[0] = w.state->slip * d.relaxation, w.tyre.deflection[1] = w.state->side_slip * d.relaxation;
    const Vec3 start = chassis.pose.apply(Vec3::from(d.position)) + (d.travel + d.radius) * up;
    const bool by_shape = d.shape != CAROM_NULL_HANDLE;
    const Vec3 way = -(d.travel + (by_shape ? 1 : 2) * d.radius) * up;
    Met met;
    if (by_shape) {
      probe.set_shape(d.shape, chassis.pose.q);
      if (!probe.sweep(start, way, 0, CAROM_NULL_HANDLE, met)) return false;
    } else if (!probe.ray(start, way, met)) {
      return false;
    }
    w.ground.any = met.any && !met.overlap && met.normal.dot(up) > kLeastUpright;
    w.state->body = w.ground.any ? met.body : CAROM_NULL_HANDLE;
    w.state->collider = w.ground.any ? met.collider : CAROM_NULL_HANDLE;
    if (!w.ground.any) continue;
    const Vec3 end = start + met.time * way;
    w.ground.center = by_shape ? end : end + d.radius * up;
    w.ground.to_point = (by_shape ? met.point : end) - w.ground.center;
    w.ground.normal = met.normal;
    if (!read_motion(call, world, met.body, w.ground.motion)) return false;
  }
  return true;
}

void Drive::steer() {
  Real fixed = 0;  // m, forward: the axle that is not steered
  int count = 0;
  for (std::uint32_t i = 0; i < driven.n; ++i)
    if (wheels[i].desc->max_steer == 0) fixed += Vec3::from(wheels[i].desc->position).dot(forward_b), ++count;
  if (count) fixed /= count;
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    const Real angle = driven.input.steer * w.desc->max_steer;
    const SinCos turn = sin_cos(angle);
    w.ahead = turn.cos, w.left = turn.sin;
    w.state->steer = angle;
    if (!(driven.desc.flags & CAROM_VEHICLE_ACKERMANN) || !count || angle == 0) continue;
    // The centre of turn is at lateral distance length / tan; a wheel on its side turns more.
    const Vec3 place = Vec3::from(w.desc->position);
    const Real length = place.dot(forward_b) - fixed, tangent = turn.sin / turn.cos;
    const Real nearer = length - place.dot(left_b) * tangent;
    if (!(length * nearer > 0)) continue;
    const Real own = tangent * length / nearer, secant = std::sqrt(1 + own * own);
    w.ahead = 1 / secant, w.left = own / secant;
  }
}

/// Compressions and loads.
void Drive::press(Real h) {
  const Vec3 down = -(chassis.pose.q * up_b);
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    w.compression = w.rate = 0;
    if (!w.ground.any) continue;
    w.ground.move(h);
    const Vec3 top = chassis.pose.apply(Vec3::from(w.desc->position)) - w.desc->travel * down;
    const Real toward = smaller(down.dot(w.ground.normal), -kLeastUpright);
    const Real drop = (w.ground.center - top).dot(w.ground.normal) / toward;
    w.compression = w.desc->travel - drop;
    if (w.compression <= 0) {
      w.compression = 0;
      continue;
    }
    const Vec3 center = top + drop * down;
    w.point = center + w.ground.to_point;
    w.ground.velocity = w.ground.motion.at(w.point);
    w.rate = (chassis.velocity_at(center) - w.ground.velocity).dot(w.ground.normal) / toward;
  }
  Real bars[CAROM_VEHICLE_WHEELS] = {0};
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    const std::uint32_t other = wheels[i].desc->anti_roll_partner;
    if (other == CAROM_NO_WHEEL) continue;
    const Real stiffness =
        smaller(wheels[i].desc->anti_roll, 0.1 * smaller(wheels[i].mass, wheels[other].mass) / (h * h));
    const Real force = stiffness * (wheels[i].compression - wheels[other].compression);
    bars[i] += force, bars[other] -= force;
  }
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    const carom_wheel_desc& d = *w.desc;
    // Of what is stiffer than parts can follow, so much acts.
    const Real most = 0.25 * w.mass / (h * h), damping = w.rate > 0 ? d.damping_bump : d.damping_rebound;
    const Real stop = larger(w.compression - d.travel, 0.0) * smaller(kBumpStop * d.stiffness, most);
    const Real spring =
        smaller(d.stiffness, most) * w.compression + stop + bars[i] + smaller(damping, 0.25 * w.mass / h) * w.rate;
    w.load = w.compression > 0 ? larger(spring, 0.0) / -smaller(down.dot(w.ground.normal), -kLeastUpright) : 0;
  }
}

void Drive::part(Real h) {
  press(h);
  const Vec3 forward = chassis.pose.q * forward_b, left = chassis.pose.q * left_b;
  Vec3 force = Vec3::zero(), torque = Vec3::zero();
  Real along[CAROM_VEHICLE_WHEELS] = {0}, yields[CAROM_VEHICLE_WHEELS] = {0};
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    if (!(w.load > 0)) {
      w.tyre = Tyre();
      continue;
    }
    const Vec3 heading = w.ahead * forward + w.left * left;
    const Vec3 ahead = (heading - heading.dot(w.ground.normal) * w.ground.normal).normalized();
    const Vec3 side = w.ground.normal.cross(ahead);
    const Vec3 over = chassis.velocity_at(w.point) - w.ground.velocity;
    const Real rolled = w.desc->radius * w.state->spin;
    const Real slip[2] = {over.dot(ahead) - rolled, over.dot(side)};
    const TyreForce tyre = move_tyre(w.tyre, *w.desc, slip, std::fabs(rolled), w.load, h);
    along[i] = tyre.force[0], yields[i] = tyre.yields;
    const Vec3 f = w.load * w.ground.normal + tyre.force[0] * ahead + tyre.force[1] * side;
    force += f, torque += (w.point - chassis.center()).cross(f);
    w.force_sum += f;
    w.load_sum += w.load, w.along_sum += tyre.force[0], w.across_sum += tyre.force[1];
  }
  turn_wheels(along, yields, h);
  force_sum += force, torque_sum += torque;
  chassis.move(force, torque, h);
}

/// Engine, brakes and what tyres bear turn the wheels; a brake holds at most, it never turns back.
void Drive::turn_wheels(const Real along[], const Real yields[], Real h) {
  Real shares = 0, mean = 0, inertia = 0;
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    const carom_wheel_desc& d = *wheels[i].desc;
    shares += d.drive, mean += d.drive * wheels[i].state->spin;
    if (d.drive > 0) inertia += d.inertia;
  }
  if (shares > 0) mean /= shares;
  const Real torque = move_engine(driven.desc, driven.input.throttle, driven.vehicle, mean, inertia, h);
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    const carom_wheel_desc& d = *w.desc;
    // Implicit in the tyre, which yields to the spin: stiff tyres on light wheels stay calm.
    const Real inert = d.inertia + h * d.radius * d.radius * yields[i];
    Real drive = shares > 0 ? torque * d.drive / shares : 0;
    if (d.drive > 0 && driven.desc.limited_slip > 0) {
      const Real together = (mean - w.state->spin) * d.inertia / h;
      drive += larger(smaller(together, driven.desc.limited_slip), -driven.desc.limited_slip);
    }
    Real spin = w.state->spin + (h / inert) * (drive - d.radius * along[i]);
    const Real holds =
        larger(driven.input.brake * d.brake, driven.input.handbrake * d.handbrake) + d.rolling * w.load * d.radius;
    const Real most = h * holds / inert;
    spin = spin > most ? spin - most : spin < -most ? spin + most : 0;
    w.state->spin = larger(smaller(spin, 1e5), -1e5);
    Real angle = w.state->angle + h * w.state->spin;
    if (!(std::fabs(angle) <= 0.5 * kTurn)) angle -= kTurn * std::floor(angle / kTurn + 0.5);
    w.state->angle = smaller(larger(angle, -3.1415926535897931), 3.1415926535897931);
  }
}

void Drive::write_states(Real parts) {
  const Vec3 down = -(chassis.pose.q * up_b);
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    Wheel& w = wheels[i];
    carom_wheel& s = *w.state;
    const auto put = [](const Vec3& from, double* to) { to[0] = from[0], to[1] = from[1], to[2] = from[2]; };
    s.touches = w.load_sum > 0;
    s.compression = w.compression;
    put(chassis.pose.apply(Vec3::from(w.desc->position)) - w.compression * down, s.position);
    put(s.touches ? w.point : Vec3::from(s.position), s.point);
    put(s.touches ? w.ground.normal : -down, s.normal);
    s.load = w.load_sum / parts, s.force = w.along_sum / parts, s.side_force = w.across_sum / parts;
    s.slip = w.tyre.deflection[0] / w.desc->relaxation, s.side_slip = w.tyre.deflection[1] / w.desc->relaxation;
  }
  driven.vehicle.speed = chassis.v.dot(chassis.pose.q * forward_b);
}

/// On the chassis, and opposite on what wheels stand on: all at once, so that a failure leaves none.
bool Drive::write_forces(Real parts) {
  Forces<CAROM_VEHICLE_WHEELS + 1> forces;
  forces.add(driven.desc.chassis, force_sum / parts, torque_sum / parts);
  for (std::uint32_t i = 0; i < driven.n; ++i) {
    const Wheel& w = wheels[i];
    if (!(w.load_sum > 0) || w.state->body == CAROM_NULL_HANDLE) continue;
    Inertia body;
    if (!read_inertia(call, world, w.state->body, 7, body)) return false;
    const Vec3 opposite = -w.force_sum / parts;
    if (body.dynamic) forces.add(w.state->body, opposite, (w.point - body.center).cross(opposite));
  }
  return forces.write(call, world, 2);
}

}  // namespace

bool drive(Call& call, carom_world* world, Driven& driven, Real dt) {
  Drive d(call, world, driven, dt);
  if (!d.read_chassis() || !d.look_down()) return false;
  choose_gear(driven.desc, driven.input, driven.vehicle, dt);
  d.steer();
  const Real parts = std::ceil(dt / kPart);
  for (Real i = 0; i < parts; ++i) d.part(dt / parts);
  d.write_states(parts);
  return d.write_forces(parts);
}

}  // namespace carom::kit

// Bodies and joints as families ask for them, in the stage and in the case that is judged.
#include "jury/built/builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jury/gaps.h"
#include "jury/trial.h"

namespace carom::tools::jury {

Turned turned_by(double angle) {
  // Of a quarter of it, doubled twice: ten terms are exact to rounding.
  const double x = angle / 4, square = x * x;
  double cos = 1, sin = 1;
  for (int i = 9; i > 0; --i) {
    cos = 1 - square * cos / (2.0 * i * (2 * i - 1));
    sin = 1 - square * sin / (2.0 * i * (2 * i + 1));
  }
  sin *= x;
  for (int i = 0; i < 2; ++i) {
    const double doubled = 2 * sin * cos;
    cos = cos * cos - sin * sin, sin = doubled;
  }
  return {cos, sin};
}

Quat about(const Vec& axis, double angle) {
  const Turned half = turned_by(angle / 2);
  return Quat(half.cos, half.sin * axis.x(), half.sin * axis.y(), half.sin * axis.z()).normalized();
}

double Builder::scale(double low, double high) {
  int doublings = 0;
  while (low * std::ldexp(1.0, doublings + 1) < high) ++doublings;
  const double rest = high / (low * std::ldexp(1.0, doublings)) - 1;
  return low * octaves(random.unit() * (doublings + rest));
}

void Builder::stand(const Vec& origin, const Quat& turned, const Vec& velocity) {
  origin_ = origin, turned_ = turned.normalized(), velocity_ = velocity;
}

std::size_t Builder::place(Actor actor) {
  actor.name = actor.kind + " " + std::to_string(scene.members.size());
  actor.position = origin_ + turned_ * actor.position;
  actor.orientation = (turned_ * actor.orientation).normalized();
  if (actor.type == CAROM_BODY_DYNAMIC) actor.linear_velocity = velocity_;
  return drawing_.add(std::move(actor));
}

std::size_t Builder::ground(double friction) {
  Actor actor;
  actor.kind = "ground", actor.type = CAROM_BODY_STATIC;
  Part part;
  part.shape = "half_space", part.params = {0, 1, 0, 0}, part.friction = friction;
  actor.parts.push_back(std::move(part));
  return place(std::move(actor));
}

std::size_t Builder::add(const std::string& kind, const std::string& shape, const std::vector<double>& params,
                         const Vec& at, const Stuff& stuff, const Quat& turned, std::uint32_t type) {
  Actor actor;
  actor.kind = kind, actor.type = type;
  actor.position = at, actor.orientation = turned;
  Part part;
  part.shape = shape, part.params = params;
  part.density = stuff.density, part.friction = stuff.friction, part.restitution = stuff.restitution;
  actor.parts.push_back(std::move(part));
  return place(std::move(actor));
}

std::size_t Builder::rod(const std::string& kind, double radius, const Vec& from, const Vec& to, const Stuff& stuff) {
  const Vec way = to - from;
  return add(kind, "capsule", {radius, way.norm() / 2}, (from + to) / 2, stuff, turn_between(Vec::UnitY(), way));
}

std::size_t Builder::wheel(const std::string& kind, double radius, double half_width, const Vec& at, const Stuff& stuff,
                           const Vec& axis, std::uint32_t type) {
  return add(kind, "cylinder", {radius, half_width}, at, stuff, turn_between(Vec::UnitY(), axis), type);
}

std::size_t Builder::belt(const Vec& half, const Vec& at, const Vec& speed, double friction, const Quat& turned) {
  Actor actor;
  actor.kind = "belt", actor.type = CAROM_BODY_STATIC;
  actor.position = at, actor.orientation = turned;
  Part part;
  part.shape = "box", part.params = {half.x(), half.y(), half.z()};
  part.friction = friction, part.surface_velocity = speed;
  actor.parts.push_back(std::move(part));
  const std::size_t made = place(std::move(actor));
  scene.members[made].surface = speed;
  return made;
}

std::size_t Builder::join(std::uint32_t kind, std::size_t a, std::size_t b, const Vec& at, const Vec& axis) {
  Link link;
  link.kind = kind, link.a = a, link.b = b;
  link.joint = drawing_.stage().join(kind, a, b, origin_ + turned_ * at,
                                     (turned_ * turn_between(Vec::UnitX(), axis)).normalized());
  carom_joint_desc desc;
  Call call;
  call.done(carom_joint_desc_init(&desc, sizeof desc), "asking for a joint");
  call.done(carom_joint_get(drawing_.stage().world.get(), link.joint, &desc, call), "asking for a joint");
  link.at_a = Vec(desc.position_a), link.at_b = Vec(desc.position_b);
  link.axes_a = Quat(Eigen::Vector4d(desc.orientation_a)), link.axes_b = Quat(Eigen::Vector4d(desc.orientation_b));
  scene.links.push_back(link);
  return scene.links.size() - 1;
}

namespace {

std::uint32_t coordinate_of_kind(std::uint32_t kind) {
  return kind == CAROM_JOINT_SLIDER ? CAROM_COORDINATE_SLIDE : CAROM_COORDINATE_TWIST;
}

void set_limit(Stage& stage, const Link& link, std::uint32_t coordinate, double lower, double upper) {
  carom_joint_limit limit;
  Call call;
  call.done(carom_joint_limit_init(&limit, sizeof limit), "limiting a joint");
  limit.enabled = 1, limit.lower = lower, limit.upper = upper;
  call.done(carom_joint_set_limit(stage.world.get(), link.joint, coordinate, &limit, call), "limiting a joint");
}

}  // namespace

void set_drive(Stage& stage, const Link& link) {
  Call call;
  const Drive& drive = link.drive;
  if (drive.aim == Drive::Aim::speed) {
    carom_joint_motor motor;
    call.done(carom_joint_motor_init(&motor, sizeof motor), "driving a joint");
    motor.enabled = 1, motor.speed = drive.goal, motor.max_force = drive.most;
    call.done(carom_joint_set_motor(stage.world.get(), link.joint, coordinate_of_kind(link.kind), &motor, call),
              "driving a joint");
    return;
  }
  carom_joint_spring spring;
  call.done(carom_joint_spring_init(&spring, sizeof spring), "driving a joint");
  spring.enabled = 1, spring.target = drive.goal, spring.max_force = drive.most;
  spring.frequency = drive.frequency, spring.damping = drive.damping;
  call.done(carom_joint_set_spring(stage.world.get(), link.joint, coordinate_of_kind(link.kind), &spring, call),
            "driving a joint");
}

void Builder::limit(std::size_t index, double lower, double upper) {
  Link& link = scene.links[index];
  link.limited = true, link.lower = lower, link.upper = upper;
  set_limit(drawing_.stage(), link, coordinate_of_kind(link.kind), lower, upper);
}

void Builder::limit_swing(std::size_t index, double most) {
  scene.links[index].swing = most;
  set_limit(drawing_.stage(), scene.links[index], CAROM_COORDINATE_SWING, 0, most);
}

void Builder::run(std::size_t index, double speed, double most) {
  scene.links[index].drive = {Drive::Aim::speed, speed, most, 0, 0};
  set_drive(drawing_.stage(), scene.links[index]);
}

void Builder::aim(std::size_t index, double place, double stiffness, double damping, double most) {
  const double weight = weight_along(scene, scene.links[index], frame_of(drawing_.stage()));
  const double frequency = std::min(30.0, std::sqrt(stiffness / weight) / (2 * std::numbers::pi));
  scene.links[index].drive = {Drive::Aim::place, place, most, frequency, damping};
  set_drive(drawing_.stage(), scene.links[index]);
}

void Builder::deed(double time, Deed::What what, std::size_t who, double value) {
  scene.deeds.push_back({time, what, who, {}, value});
}

void Builder::deed(double time, Deed::What what, std::size_t who, const State& state) {
  scene.deeds.push_back({time, what, who, state, 0});
}

void Builder::lead(std::size_t link, double from, double to, double begin, double end) {
  const int steps = static_cast<int>(std::ceil((end - begin) * 60));
  for (int i = 1; i <= steps; ++i) {
    const double u = static_cast<double>(i) / steps;
    deed(begin + (end - begin) * u, Deed::What::drive, link, from + (to - from) * u * u * (3 - 2 * u));
  }
}

void Builder::ask_to_stay(const std::string& what, const std::vector<std::size_t>& members, double borne,
                          double plain) {
  Goal goal;
  goal.what = what, goal.until = scene.seconds, goal.plain = plain;
  goal.missed_by = [members, borne](const Frame& start, const Frame& now) {
    double most = 0;
    for (const std::size_t i : members) most = std::max(most, (now[i].position - start[i].position).norm());
    return most - borne;
  };
  ask(std::move(goal));
}

void Builder::make_late(std::size_t member, double time, const State& state) {
  scene.members[member].is_late = true;
  carom_body& body = drawing_.stage().actors[member].body;
  Call call;
  call.done(carom_body_destroy(drawing_.stage().world.get(), body, call), "leaving a body for later");
  body = CAROM_NULL_HANDLE;
  deed(time, Deed::What::add, member, state);
}

std::vector<std::size_t> Builder::since(std::size_t first) const {
  std::vector<std::size_t> members;
  for (std::size_t i = first; i < scene.members.size(); ++i)
    if (scene.members[i].moves()) members.push_back(i);
  return members;
}

}  // namespace carom::tools::jury

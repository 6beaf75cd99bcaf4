// Joints of a scene file: sets of limits and drives, told as one of our kinds.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "scenefile/axes.h"
#include "scenefile/reader.h"

namespace carom::tools::scenefile {
namespace {

constexpr double kUnbounded = 1e30;  // N or N m
constexpr double kZero = 1e-9;       // m or rad: a limit as narrow is a lock

void put(double (&out)[3], const Vec& v) { std::copy(v.data(), v.data() + 3, out); }
void put(double (&out)[4], const Quat& q) { std::copy(q.coeffs().data(), q.coeffs().data() + 4, out); }

/// @param name_of  (k) -> the name of number k, for k below count
template <class NameOf>
std::uint32_t which_of(std::uint32_t count, const NameOf& name_of, const Value& at, const std::string& name) {
  std::string all;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (name == name_of(k)) return k;
    all += (k ? ", " : "") + std::string(name_of(k));
  }
  at.fail("is '" + name + "'", "write one of: " + all);
}

/// What a pulley's rope runs over, or how a gear's wheels turn.
void read_transmission(carom_world* world, carom_joint joint, const Value& mine) {
  if (!mine.has("ratio")) return;
  carom_joint_transmission t;
  carom_joint_transmission_init(&t, sizeof t);
  t.ratio = mine["ratio"].number();
  put(t.anchor_a, mine.vector_or("anchorA", Vec::Zero())), put(t.anchor_b, mine.vector_or("anchorB", Vec::Zero()));
  if (mine.has("length")) t.length = mine["length"].number(), t.fields = CAROM_JOINT_FIELD_LENGTH;
  Call call;
  call.done(carom_joint_set_transmission(world, joint, &t, call), mine.place());
}

/// Turns the frame so that its x is axis `x` of the file's, y the next one.
Quat turned_to(int x) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) axes((x + k) % 3, k) = 1;
  return Quat(axes);
}

}  // namespace

/// What the limits of a joint leave free.
struct Reader::Plan {
  std::uint32_t kind = 0;
  int axis = 0;  // of the file, that is the frame's x
  std::uint32_t coordinate = UINT32_MAX;
  bool limited = false;
  double lower = 0, upper = 0;
};

void Reader::make_joints() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent == kNone) continue;
    const auto extension = Document::extension(node(i), "KHR_physics_rigid_bodies");
    if (const auto joint = extension ? extension->get("joint") : std::nullopt) make_joint(i, *joint);
    if (const auto omi = Document::extension(node(i), "OMI_physics_joint");
        omi && !(extension && extension->has("joint"))) {
      if (omi->has("joint"))
        make_joint(i, *omi);
      else
        remark(omi->place() + ": a joint without 'joint', of an earlier draft");
    }
  }
  for (const LateCoupling& late : late_couplings_) make_coupling(late.number, late.own, true);
}

bool Reader::make_coupling(std::size_t number, const Value& mine, bool last) {
  carom_joint_coupling c;
  carom_joint_coupling_init(&c, sizeof c);
  for (const auto& [name, to] : {std::pair("follower", &c.follower), std::pair("leader", &c.leader)}) {
    const Value which = mine[name];
    const auto found = joint_of_.find(static_cast<std::size_t>(which.number()));
    if (found != joint_of_.end()) *to = found->second;
    if (*to != CAROM_NULL_HANDLE) continue;
    if (last) which.fail("is no joint of a node", "name a hinge or a slider of physicsJoints by its number");
    return false;
  }
  const Value polynomial = mine["polynomial"];
  if (polynomial.size() > 5) polynomial.fail("has more than five numbers", "write a polynomial of degree 4 at most");
  std::fill(c.polynomial, c.polynomial + 5, 0.0);
  for (std::size_t k = 0; k < polynomial.size(); ++k) c.polynomial[k] = polynomial.at(k).number();
  carom_joint made = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_joint_couple(stage_.world.get(), &c, &made, call), mine.place());
  joint_of_[number] = made;
  return true;
}

bool Reader::plan_joint(const Value& joint, Plan& plan) {
  struct Range {
    bool limited = false, locked = false, soft = false;
    double lower = -kUnbounded, upper = kUnbounded;
  };
  Range linear[3], angular[3];
  struct Several : Range {
    bool given = false;
    explicit operator bool() const { return given; }
    const Range& operator*() const { return *this; }
    Several& operator=(const Range& r) { return static_cast<Range&>(*this) = r, given = true, *this; }
  } distance, cone;
  if (const auto limits = joint.get("limits"))
    for (std::size_t k = 0; k < limits->size(); ++k) {
      const Value limit = limits->at(k);
      Range r;
      r.limited = true;
      r.lower = limit.number_or("min", -kUnbounded), r.upper = limit.number_or("max", kUnbounded);
      r.locked = std::fabs(r.lower) < kZero && std::fabs(r.upper) < kZero;
      r.soft = is_soft_limit(limit);
      if (r.soft) remark(limit.place() + ": stiffness of a limit; it is hard"), r.locked = false;
      const bool turns = limit.has("angularAxes");
      const Value axes = limit[turns ? "angularAxes" : "linearAxes"];
      bool named[3] = {};
      for (std::size_t a = 0; a < axes.size(); ++a) {
        const std::size_t axis = axes.at(a).index(3, "axes");
        if (std::exchange(named[axis], true)) axes.at(a).fail("is named twice", "name each axis once");
        if (r.locked || axes.size() == 1) (turns ? angular : linear)[axis] = r;
      }
      if (!r.locked && axes.size() == 3 && !turns)
        distance = r;
      else if (!r.locked && axes.size() == 2 && turns)
        cone = r, plan.axis = 3 - static_cast<int>(axes.at(0).index(3, "axes") + axes.at(1).index(3, "axes"));
      else if (!r.locked && axes.size() > 1)
        return remark(limit.place() + ": a limit over several axes"), false;
    }
  const auto count = [](const Range(&r)[3], bool Range::*what) {
    return std::count_if(r, r + 3, [what](const Range& x) { return x.*what; });
  };
  const auto first = [](const Range(&r)[3], bool locked) {
    for (int k = 0; k < 3; ++k)
      if (r[k].locked == locked) return k;
    return 0;
  };
  const auto held = count(linear, &Range::locked), turns_held = count(angular, &Range::locked);
  const auto bound = [&](std::uint32_t coordinate, const Range& r) {
    plan.coordinate = coordinate;
    plan.limited = r.limited;
    plan.lower = r.lower, plan.upper = r.upper;
  };
  const bool many = count(angular, &Range::limited) > turns_held + 1 || (cone && turns_held > 0);
  if (held == 3 && turns_held == 3) {
    plan.kind = CAROM_JOINT_WELD;
  } else if (held == 3 && turns_held == 2) {
    plan.kind = CAROM_JOINT_HINGE, plan.axis = first(angular, false);
    bound(CAROM_COORDINATE_TWIST, angular[plan.axis]);
  } else if (held == 3 && turns_held == 1 && !many) {
    plan.kind = CAROM_JOINT_UNIVERSAL, plan.axis = first(angular, true);
    if (count(angular, &Range::limited) > 1) remark(joint.place() + ": a limit of one pin of a cross");
  } else if (held == 3 && turns_held == 0) {
    plan.kind = CAROM_JOINT_BALL;
    if (cone)
      bound(CAROM_COORDINATE_SWING, *cone), plan.lower = std::max(plan.lower, 0.0);
    else if (count(angular, &Range::limited) == 1)
      for (int k = 0; k < 3; ++k)
        if (angular[k].limited) plan.axis = k, bound(CAROM_COORDINATE_TWIST, angular[k]);
    if (count(angular, &Range::limited) > 1 || (cone && count(angular, &Range::limited) > 0))
      remark(joint.place() + ": more limits of a ball joint than one cone or one twist");
  } else if (held == 2 && turns_held == 3) {
    plan.kind = CAROM_JOINT_SLIDER, plan.axis = first(linear, false);
    bound(CAROM_COORDINATE_SLIDE, linear[plan.axis]);
  } else if (held == 0 && turns_held == 0 && distance) {
    plan.kind = CAROM_JOINT_DISTANCE;
    bound(CAROM_COORDINATE_DISTANCE, *distance), plan.lower = std::max(plan.lower, 0.0);
  } else {
    remark(joint.place() + ": a joint that leaves free " + std::to_string(3 - held) + " ways and " +
           std::to_string(3 - turns_held) + " turns");
    return false;
  }
  return true;
}

bool Reader::fits(const Value& drive, const Plan& plan) const {
  const bool turns = drive["type"].text() == "angular";
  return plan.coordinate == (turns ? CAROM_COORDINATE_TWIST : CAROM_COORDINATE_SLIDE) &&
         static_cast<int>(drive["axis"].index(3, "axes")) == plan.axis &&
         (plan.kind == CAROM_JOINT_HINGE || plan.kind == CAROM_JOINT_SLIDER);
}

/// Whether axes say all of a joint, and none of our other kinds does.
bool Reader::wants_axes(const Value& joint) {
  if (!is_told_by_axes(joint)) return false;
  const std::vector<std::string> before = stage_.remarks;
  const std::size_t told = told_;
  Plan plan;
  bool rest = !plan_joint(joint, plan) || told_ != told;
  stage_.remarks = before, told_ = told;
  const auto drives = joint.get("drives");
  for (std::size_t k = 0; drives && k < drives->size(); ++k) {
    const Value drive = drives->at(k);
    const bool pulls = stiffness_of_drive(drive) > 0;
    rest |=
        !fits(drive, plan) || (pulls ? drive.number_or("velocityTarget", 0) != 0 : drive.number_or("damping", 0) > 0);
  }
  return rest;
}

bool Reader::read_own_joint(const Value& mine, carom_joint_desc& d) const {
  const auto kind = mine.get("kind");
  if (!kind) return false;
  d.kind = which_of(CAROM_JOINT_COUNT, carom_joint_kind_name, *kind, kind->text());
  if (mine.has("length") && d.kind == CAROM_JOINT_DISTANCE)
    d.length = mine["length"].number(), d.fields |= CAROM_JOINT_FIELD_LENGTH;
  if (mine.has("accelerations") && mine["accelerations"].boolean()) d.fields |= CAROM_JOINT_ACCELERATIONS;
  d.break_force = mine.number_or("breakForce", 0), d.break_torque = mine.number_or("breakTorque", 0);
  return true;
}

void Reader::make_joint(std::size_t i, const Value& at) {
  const auto extension = of_document(at);
  if (!extension) at.fail("needs its extension in the document", "add the extension with physicsJoints");
  const Value all = (*extension)["physicsJoints"];
  const std::size_t number = at["joint"].index(all.size(), "physicsJoints");
  const Value joint = all.at(number);
  const std::size_t other = at["connectedNode"].index(nodes_.size(), "nodes");
  const auto mine = own(joint);
  if (mine && mine->has("kind") && (*mine)["kind"].text() == carom_joint_kind_name(CAROM_JOINT_COUPLING)) {
    if (!make_coupling(number, *mine, false)) late_couplings_.push_back({number, *mine});
    return;
  }
  if (!mine && make_soft_distance(i, other, joint)) return;
  carom_joint_desc d;
  carom_joint_desc_init(&d, sizeof d);
  Plan plan;
  const bool exact = mine && read_own_joint(*mine, d), by_axes = !exact && wants_axes(joint);
  if (by_axes) {
    d.kind = CAROM_JOINT_SIX_AXIS;
  } else if (!exact) {
    if (!plan_joint(joint, plan)) return;
    d.kind = plan.kind;
  }
  const auto end = [&](std::size_t n, double(&position)[3], double(&orientation)[4]) {
    const Place place = nodes_[n].body == kNone ? nodes_[n].world : nodes_[n].in_body;
    const bool is_body = nodes_[n].body == n;  // its own frame, whose scale is not the place of anything
    put(position, is_body ? Vec(Vec::Zero()) : place.p);
    const Quat q = is_body ? Quat::Identity() : place.q;
    put(orientation, exact ? q : Quat((q * turned_to(plan.axis)).normalized()));
    return nodes_[n].body == kNone ? carom_body(CAROM_NULL_HANDLE) : stage_.actors[actor_of_node_[nodes_[n].body]].body;
  };
  d.body_a = end(i, d.position_a, d.orientation_a);
  d.body_b = end(other, d.position_b, d.orientation_b);
  if (at.has("enableCollision") && at["enableCollision"].boolean()) d.fields |= CAROM_JOINT_COLLIDE;
  const auto moves = [&](std::size_t n) {
    return nodes_[n].body != kNone && stage_.actors[actor_of_node_[nodes_[n].body]].type == CAROM_BODY_DYNAMIC;
  };
  if (!moves(i) && !moves(other)) return remark(at.place() + ": a joint between two that do not move");
  if (d.body_a == d.body_b) return remark(at.place() + ": a joint of a body with itself");
  carom_joint handle = CAROM_NULL_HANDLE;
  try {
    handle = stage_.join(d, at.place());
  } catch (const Error& e) {
    at.fail(std::string("cannot be made: ") + e.what(), e.remedy);
  }
  joint_of_[number] = handle;
  carom_world* const world = stage_.world.get();
  if (by_axes) {
    const auto limits = joint.get("limits");
    for (std::size_t k = 0; limits && k < limits->size(); ++k)
      if (holds_nothing(limits->at(k)))
        remark(limits->at(k).place() + ": a limit of no stiffness, which holds nothing");
    return read_khr_axes(world, handle, joint);
  }
  if (!exact) return drive_joint(joint, plan, handle, d);
  read_own_axes(world, handle, *mine);
  read_transmission(world, handle, *mine);
  Call call;
  const auto coordinate = [&](const std::string& name, const Value& v) {
    return which_of(
        CAROM_COORDINATE_COUNT, [](std::uint32_t k) { return kCoordinates[k]; }, v, name);
  };
  if (const auto limits = mine->get("limits"))
    for (const auto& [name, value] : limits->items()) {
      carom_joint_limit limit;
      carom_joint_limit_init(&limit, sizeof limit);
      limit.enabled = 1, limit.lower = value.at(0).number(), limit.upper = value.at(1).number();
      call.done(carom_joint_set_limit(world, handle, coordinate(name, value), &limit, call), value.place());
    }
  if (const auto motors = mine->get("motors"))
    for (const auto& [name, value] : motors->items()) {
      carom_joint_motor motor;
      carom_joint_motor_init(&motor, sizeof motor);
      motor.enabled = 1, motor.speed = value["speed"].number(),
      motor.max_force = value.number_or("maxForce", kUnbounded);
      call.done(carom_joint_set_motor(world, handle, coordinate(name, value), &motor, call), value.place());
    }
  if (const auto springs = mine->get("springs"))
    for (const auto& [name, value] : springs->items()) {
      carom_joint_spring spring;
      carom_joint_spring_init(&spring, sizeof spring);
      spring.enabled = 1, spring.target = value.number_or("target", 0), spring.frequency = value["frequency"].number();
      spring.damping = value.number_or("damping", 1), spring.max_force = value.number_or("maxForce", kUnbounded);
      call.done(carom_joint_set_spring(world, handle, coordinate(name, value), &spring, call), value.place());
    }
}

void Reader::drive_joint(const Value& joint, const Plan& plan, carom_joint handle, const carom_joint_desc& d) {
  carom_world* const world = stage_.world.get();
  Call call;
  if (plan.limited) {
    const bool angle = plan.coordinate == CAROM_COORDINATE_TWIST || plan.coordinate == CAROM_COORDINATE_SWING;
    const double most = plan.coordinate == CAROM_COORDINATE_SWING ? std::numbers::pi : angle ? kMostTurned : 1e9;
    carom_joint_limit limit;
    carom_joint_limit_init(&limit, sizeof limit);
    limit.enabled = 1, limit.lower = std::clamp(plan.lower, -most, most),
    limit.upper = std::clamp(plan.upper, -most, most);
    call.done(carom_joint_set_limit(world, handle, plan.coordinate, &limit, call), joint.place() + "/limits");
  }
  const auto drives = joint.get("drives");
  for (std::size_t k = 0; drives && k < drives->size(); ++k) {
    const Value drive = drives->at(k);
    const bool turns = drive["type"].text() == "angular";
    if (!fits(drive, plan)) {
      remark(drive.place() + ": a drive along what the joint does not leave free, or of a ball joint");
      continue;
    }
    // What the driven coordinate weighs, were the two bodies alone.
    double inverse = 0;
    for (const bool b : {false, true}) {
      const carom_body body = b ? d.body_b : d.body_a;
      if (body == CAROM_NULL_HANDLE) continue;
      carom_body_desc now;
      carom_body_desc_init(&now, sizeof now);
      call.done(carom_body_get(world, body, &now, call), drive.place());
      if (now.type != CAROM_BODY_DYNAMIC) continue;
      const Eigen::Map<const Eigen::Matrix3d> inertia(now.inertia);
      const Quat frame(Eigen::Map<const Eigen::Vector4d>(b ? d.orientation_b : d.orientation_a));
      const Vec x = frame * Vec::UnitX();
      inverse += turns ? (inertia.norm() > 0 ? x.dot(inertia.inverse() * x) : 0) : 1 / now.mass;
    }
    const bool force = !drive.has("mode") || drive["mode"].text() == "force";
    const double per_mass = force ? inverse : 1, stiffness = stiffness_of_drive(drive);
    const double damping = drive.number_or("damping", 0, 0, 1e300), most = std::min(most_of_drive(drive), kUnbounded);
    if (stiffness > 0) {
      carom_joint_spring spring;
      carom_joint_spring_init(&spring, sizeof spring);
      const double omega = std::sqrt(stiffness * per_mass);
      spring.enabled = 1, spring.target = drive.number_or("positionTarget", 0), spring.max_force = most;
      spring.frequency = std::min(omega / (2 * std::numbers::pi), 1e4);
      spring.damping = omega > 0 ? std::min(damping * per_mass / (2 * omega), 1e3) : 0;
      call.done(carom_joint_set_spring(world, handle, plan.coordinate, &spring, call), drive.place());
      if (drive.number_or("velocityTarget", 0) != 0) remark(drive.place() + "/velocityTarget beside a stiffness");
    } else if (damping > 0) {
      carom_joint_motor motor;
      carom_joint_motor_init(&motor, sizeof motor);
      motor.enabled = 1, motor.speed = drive.number_or("velocityTarget", 0), motor.max_force = most;
      call.done(carom_joint_set_motor(world, handle, plan.coordinate, &motor, call), drive.place());
      remark(drive.place() + "/damping: a drive to a velocity is as strong as its maxForce");
    }
  }
}

}  // namespace carom::tools::scenefile

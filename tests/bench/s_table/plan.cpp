// Bodies by their principal axes: Bullet and ODE place a body's origin at its centre of mass, Bullet keeps its inertia
// diagonal.
#include "plan.h"

#include <Eigen/Eigenvalues>

namespace carom::bench {
namespace {

/// @param of_all  only what every engine of the S-table has
Solid solid_of(const std::string& shape, bool of_all) {
  if (shape == "half_space") return Solid::half_space;
  if (shape == "sphere") return Solid::sphere;
  if (shape == "box") return Solid::box;
  if (shape == "hull") return Solid::hull;
  if (!of_all && shape == "capsule") return Solid::capsule;
  if (!of_all && shape == "cylinder") return Solid::cylinder;
  if (!of_all && shape == "cone") return Solid::cone;
  throw tools::Error("not every engine has the shape " + shape, "choose a scene of boxes, spheres and hulls");
}

}  // namespace

Plan::Plan(tools::Stage& stage, bool as_given) : stage_(stage), as_given_(as_given) {
  for (const tools::Actor& actor : stage.actors) add(actor);
  if (!as_given) {
    for (const tools::Tie& tie : stage.ties) add(tie);
    return;
  }
  tools::Call call;
  call.done(carom_world_get_gravity(stage.world.get(), gravity_, call), "asking for gravity");
  std::uint64_t count = 0;
  call.done(carom_world_get_joints(stage.world.get(), nullptr, 0, &count, call), "counting joints");
  std::vector<carom_joint> joints(count);
  call.done(carom_world_get_joints(stage.world.get(), joints.data(), count, &count, call), "listing joints");
  for (const carom_joint joint : joints) add(joint);
}

void Plan::add(carom_joint handle) {
  carom_joint_desc joint;
  tools::Call call;
  call.done(carom_joint_desc_init(&joint, sizeof joint), "asking for a joint");
  call.done(carom_joint_get(stage_.world.get(), handle, &joint, call), "asking for a joint");
  if (joint.kind != CAROM_JOINT_BALL && joint.kind != CAROM_JOINT_SLIDER)
    throw tools::Error("a joint is neither ball joint nor slider", "choose a scene whose joints every engine has");
  const auto index_of = [&](carom_body body) {
    for (std::size_t i = 0; i < stage_.actors.size(); ++i)
      if (body != CAROM_NULL_HANDLE && stage_.actors[i].body == body) return i;
    return kWorldBody;
  };
  JointPlan plan;
  plan.a = index_of(joint.body_a), plan.b = index_of(joint.body_b);
  const auto place = [&](std::size_t i, const double(&at)[3], double(&on)[3]) {
    if (i == kWorldBody) return Vec::Map(on) = vec(at), void();
    Vec::Map(on) = members_[i].axes.conjugate() * (vec(at) - members_[i].center);
  };
  place(plan.a, joint.position_a, plan.on_a), place(plan.b, joint.position_b, plan.on_b);
  if (joint.kind == CAROM_JOINT_SLIDER) place_slider(joint, plan), drive_slider(handle, plan);
  joints_.push_back(plan);
}

void Plan::add(const tools::Tie& tie) {
  if (tie.kind != CAROM_JOINT_BALL)
    throw tools::Error("a joint is not a ball joint", "choose a scene whose joints every engine has");
  JointPlan plan;
  plan.a = tie.a, plan.b = tie.b;
  const auto place = [&](std::size_t i, double(&on)[3]) {
    const BodyState& start = plans_[i].start;
    Vec::Map(on) = quat(start.orientation).conjugate() * (tie.at - vec(start.position));
  };
  place(tie.a, plan.on_a), place(tie.b, plan.on_b);
  joints_.push_back(plan);
}

void Plan::add(const tools::Actor& actor) {
  if (actor.parts.size() > 1 ||
      (!actor.parts.empty() && !(actor.parts[0].position.isZero(0) && actor.parts[0].orientation.vec().isZero(0))))
    throw tools::Error("'" + actor.name + "' is not one shape at its body's origin",
                       "choose a scene whose bodies have one part each");
  if (actor.type == CAROM_BODY_KINEMATIC)
    throw tools::Error("'" + actor.name + "' is moved by its host", "choose a scene of bodies that move by themselves");
  tools::Call call;
  carom_body_desc body;
  call.done(carom_body_desc_init(&body, sizeof body), "asking for masses");
  body.mass = actor.mass;
  if (actor.particles == CAROM_NULL_HANDLE)
    call.done(carom_body_get(stage_.world.get(), actor.body, &body, call), "asking for masses");
  Member member;
  BodyPlan plan;
  member.is_static = plan.is_static = actor.type == CAROM_BODY_STATIC;
  member.mass = plan.mass = body.mass;
  member.center = vec(body.center);
  member.inertia = Eigen::Map<const Eigen::Matrix3d>(body.inertia);
  if (!actor.parts.empty() && actor.parts[0].collider != CAROM_NULL_HANDLE) {  // else a part is there for the eye alone
    const tools::Part& part = actor.parts[0];
    tools::Engine& engine = stage_.engine();
    member.solid = plan.solid = solid_of(part.shape, !as_given_);
    member.shape = member.solid == Solid::half_space ? engine.half_space(part.params.data(), part.params.at(3))
                                                     : engine.shape(part.shape, part.params);
    member.radius = engine.info(member.shape).bounding_radius;
    if (member.solid == Solid::hull) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(member.inertia);
      Eigen::Matrix3d axes = principal.eigenvectors();
      if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
      member.axes = Quat(axes);
    } else if (!member.is_static) {
      Vec::Map(plan.shape_at) = -member.center;
    }
    plan.friction = part.friction;
    if (as_given_) plan.restitution = part.restitution;
    describe_shape(part, member, plan);
  }
  const Eigen::Matrix3d axes = member.axes.toRotationMatrix();
  for (int i = 0; i < 3; ++i) {
    plan.inertia[i] = axes.col(i).dot(member.inertia * axes.col(i));
    if (plan.inertia[i] == 0) plan.inertia[i] = plan.mass;  // a particle: it will not turn, and no engine takes 0
  }
  Vec::Map(plan.start.position) = actor.position + actor.orientation * member.center;
  Eigen::Vector4d::Map(plan.start.orientation) = (actor.orientation * member.axes).coeffs();
  Vec::Map(plan.start.velocity) = actor.linear_velocity;
  Vec::Map(plan.start.omega) = actor.angular_velocity;
  members_.push_back(member);
  plans_.push_back(plan);
}

void Plan::describe_shape(const tools::Part& part, const Member& member, BodyPlan& plan) {
  if (member.solid != Solid::hull) {
    const double*& params = params_[member.shape];
    if (!params) params = part.params.data();  // the stage keeps its actors
    plan.params = params;
    plan.param_count = part.params.size();
    return;
  }
  Hull& hull = hulls_[member.shape];
  if (hull.xyz.empty()) {
    std::vector<Vec> points;
    for (std::size_t i = 0; i + 3 <= part.params.size(); i += 3)
      points.push_back(member.axes.conjugate() * (Vec(&part.params[i]) - member.center));
    const tools::Mesh mesh = tools::convex_hull(points);
    for (const Vec& p : mesh.points) hull.xyz.insert(hull.xyz.end(), p.data(), p.data() + 3);
    for (const auto& face : mesh.faces) hull.triangles.insert(hull.triangles.end(), face.begin(), face.end());
  }
  plan.params = hull.xyz.data();
  plan.param_count = hull.xyz.size();
  plan.triangles = hull.triangles.data();
  plan.triangle_count = hull.triangles.size() / 3;
}

WorldPlan Plan::world(bool sleeping) const {
  WorldPlan plan;
  plan.bodies = plans_.data();
  plan.count = plans_.size();
  plan.joints = joints_.data();
  plan.joint_count = joints_.size();
  for (int i = 0; i < 3; ++i) plan.gravity[i] = gravity_[i];
  plan.sleeping = sleeping;
  return plan;
}

void Plan::start_at(const std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Quat q = quat(states[i].orientation);
    BodyState start;
    Vec::Map(start.position) = vec(states[i].position) + q * members_[i].center;
    Eigen::Vector4d::Map(start.orientation) = (q * members_[i].axes).coeffs();
    plans_[i].start = start;
  }
}

void Plan::to_body_frames(std::vector<BodyState>& states) const {
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Quat q = quat(states[i].orientation) * members_[i].axes.conjugate();
    Eigen::Vector4d::Map(states[i].orientation) = q.coeffs();
    Vec::Map(states[i].position) -= q * members_[i].center;
  }
}

}  // namespace carom::bench

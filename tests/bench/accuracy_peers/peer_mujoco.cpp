// MuJoCo in a module. What hangs together by joints is a tree of ball and slide joints, as its users build it, in
// coordinates that cannot gape; a ball joint that would close a loop is an equality constraint. A motor is a force that
// falls to nothing at its speed: by its joint's damping, which is implicit. Friction and restitution are those of the
// comparison, put into each contact after it is found: MuJoCo itself takes the larger coefficient of two, and knows
// springs and dampers where others know restitution. Dials: integrator (0 Euler, 1 RK4: for scenes without contacts, as
// it asks for contacts behind our back), substeps, solref (s, of contacts that do not bounce), impratio, noslip
// (iterations), iterations, bounce_steps (steps that a bounce takes).
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "peer.h"

namespace carom::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::string numbers(const double* x, std::size_t n) {
  std::string text;
  char one[40];
  for (std::size_t i = 0; i < n; ++i) {
    std::snprintf(one, sizeof one, "%s%.17g", i ? " " : "", x[i]);
    text += one;
  }
  return text;
}
/// w first, as MuJoCo has it.
std::array<double, 4> quat_of(const double (&xyzw)[4]) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

/// Who hangs on whom, and by what: a forest, whose roots are free or hang on the world.
struct Forest {
  struct Node {
    std::size_t parent = kWorldBody;
    const JointPlan* joint = nullptr;  // to its parent; null: it is free
    std::array<double, 3> pivot{};     // m, own frame
    std::vector<std::size_t> children;
  };
  std::vector<Node> nodes;
  std::vector<std::size_t> roots;
  std::vector<const JointPlan*> loops;

  explicit Forest(const WorldPlan& plan) : nodes(plan.count) {
    std::vector<bool> placed(plan.count, false), used(plan.joint_count, false);
    const auto grow = [&](std::size_t from) {  // from a body, or the world, through joints not yet used
      std::vector<std::size_t> queue = {from};
      for (std::size_t k = 0; k < queue.size(); ++k)
        for (std::size_t j = 0; j < plan.joint_count; ++j) {
          const JointPlan& joint = plan.joints[j];
          const std::size_t at = queue[k];
          if (used[j] || (joint.a != at && joint.b != at)) continue;
          const std::size_t other = joint.a == at ? joint.b : joint.a;
          if (other == kWorldBody || plan.bodies[other].is_static || placed[other]) continue;
          used[j] = placed[other] = true;
          Node& node = nodes[other];
          node.parent = at, node.joint = &joint;
          const double* const pivot = other == joint.b ? joint.on_b : joint.on_a;
          std::copy_n(pivot, 3, node.pivot.begin());
          (at == kWorldBody ? roots : nodes[at].children).push_back(other);
          queue.push_back(other);
        }
    };
    grow(kWorldBody);
    for (std::size_t i = 0; i < plan.count; ++i) {
      if (placed[i] || plan.bodies[i].is_static) continue;
      placed[i] = true;
      roots.push_back(i);
      grow(i);
    }
    for (std::size_t j = 0; j < plan.joint_count; ++j)
      if (!used[j]) loops.push_back(&plan.joints[j]);
  }
};

/// What `child`, A or B of a slider, moves along where B moves along A's x.   @return own frame
std::array<double, 3> slider_axis(const JointPlan& j, std::size_t child) {
  const double x[3] = {child == j.b ? 1.0 : -1.0, 0, 0};
  std::array<double, 3> axis;
  mju_rotVecQuat(axis.data(), x, quat_of(child == j.b ? j.axes_on_b : j.axes_on_a).data());
  return axis;
}

std::string name_of(std::size_t body) { return "b" + std::to_string(body); }

/// A plan as MJCF.
class Text {
 public:
  Text(const WorldPlan& plan, const Forest& forest) : plan_(plan), forest_(forest) {
    const std::size_t contacts = 6 * plan.count + 64;
    const bool rk4 = plan.dial("integrator", 0) == 1;
    text_ = "<mujoco><compiler angle='radian' balanceinertia='false' inertiafromgeom='false'/><size nconmax='" +
            std::to_string(contacts) + "' njmax='" + std::to_string(4 * contacts + 6 * plan.joint_count) + "'/>";
    text_ += "<option cone='elliptic' gravity='" + numbers(plan.gravity, 3) + "' integrator='" +
             (rk4 ? "RK4" : "Euler") + "' iterations='" +
             std::to_string(static_cast<int>(plan.dial("iterations", 100))) + "' noslip_iterations='" +
             std::to_string(static_cast<int>(plan.dial("noslip", 0))) + "' impratio='" +
             std::to_string(plan.dial("impratio", 1)) + "'/>";
    text_ += "<worldbody>";
    for (std::size_t i = 0; i < plan.count; ++i)
      if (plan.bodies[i].is_static) add_geom(i, true);
    for (const std::size_t root : forest.roots) add_body(root);
    text_ += "</worldbody><equality>";
    for (const JointPlan* j : forest.loops) add_loop(*j);
    text_ += "</equality><actuator>" + motors_ + "</actuator><contact>";
    for (std::size_t i = 0; i < plan.joint_count; ++i) {
      const JointPlan& j = plan.joints[i];
      if (j.a != kWorldBody && j.b != kWorldBody && !plan.bodies[j.a].is_static && !plan.bodies[j.b].is_static)
        text_ += "<exclude body1='" + name_of(j.a) + "' body2='" + name_of(j.b) + "'/>";
    }
    text_ += "</contact></mujoco>";
  }
  const std::string& text() const { return text_; }

 private:
  /// A pose, in the frame of a body or of the world.
  std::string pose(const BodyState& s, std::size_t parent) const {
    std::array<double, 4> q = quat_of(s.orientation);
    std::array<double, 3> x = {s.position[0], s.position[1], s.position[2]};
    if (parent != kWorldBody) {
      const BodyState& p = plan_.bodies[parent].start;
      const std::array<double, 4> q_p = quat_of(p.orientation);
      double back[4], apart[3], turned[4];
      mju_negQuat(back, q_p.data());
      mju_sub3(apart, s.position, p.position);
      mju_rotVecQuat(x.data(), apart, back);
      mju_mulQuat(turned, back, q.data());
      std::copy_n(turned, 4, q.begin());
    }
    return "pos='" + numbers(x.data(), 3) + "' quat='" + numbers(q.data(), 4) + "'";
  }

  void add_geom(std::size_t i, bool in_world) {
    const BodyPlan& b = plan_.bodies[i];
    if (b.solid == Solid::none) return;
    text_ += "<geom name='g" + std::to_string(i) + "' condim='3' ";
    const double* const p = b.params;
    if (b.solid == Solid::half_space) {
      const double up[3] = {0, 0, 1}, at[3] = {p[0] * p[3], p[1] * p[3], p[2] * p[3]};
      double axis[3], q[4] = {1 + mju_dot3(up, p), 0, 0, 0};
      mju_cross(axis, up, p);
      std::copy_n(axis, 3, q + 1);
      if (!(q[0] > 1e-9)) q[0] = 0, q[1] = 1;
      mju_normalize4(q);
      text_ += "type='plane' size='100 100 1' pos='" + numbers(at, 3) + "' quat='" + numbers(q, 4) + "'/>";
      return;
    }
    if (in_world) text_ += pose(b.start, kWorldBody) + " ";
    const bool is_round = b.solid == Solid::capsule || b.solid == Solid::cylinder;
    if (b.solid == Solid::sphere)
      text_ += "type='sphere' size='" + numbers(p, 1) + "'/>";
    else if (b.solid == Solid::box)
      text_ += "type='box' size='" + numbers(p, 3) + "'/>";
    else if (is_round && !in_world)  // MuJoCo's are along z
      text_ += std::string("type='") + (b.solid == Solid::capsule ? "capsule" : "cylinder") + "' size='" +
               numbers(p, 2) + "' pos='" + numbers(b.shape_at, 3) + "' zaxis='0 1 0'/>";
    else
      throw std::runtime_error("MuJoCo's module has no hulls or cones, and no capsule or cylinder that stands still");
  }

  void add_body(std::size_t i) {
    const BodyPlan& b = plan_.bodies[i];
    const Forest::Node& node = forest_.nodes[i];
    text_ += "<body name='" + name_of(i) + "' " + pose(b.start, node.parent) + ">";
    if (!node.joint)
      text_ += "<freejoint/>";
    else if (node.joint->kind == JointKind::ball)
      text_ += "<joint type='ball' pos='" + numbers(node.pivot.data(), 3) + "'/>";
    else
      add_slider(i, *node.joint);
    text_ += "<inertial pos='0 0 0' mass='" + numbers(&b.mass, 1) + "' diaginertia='" + numbers(b.inertia, 3) + "'/>";
    add_geom(i, false);
    for (const std::size_t child : node.children) add_body(child);
    text_ += "</body>";
  }

  void add_slider(std::size_t i, const JointPlan& j) {
    const std::array<double, 3> axis = slider_axis(j, i);
    const double resistance = j.motor_force > 0 ? j.motor_force / std::fabs(j.motor_speed) : 0;  // N s/m
    const double damping = j.damping + resistance;
    const std::string name = "j" + std::to_string(i);
    text_ += "<joint name='" + name + "' type='slide' axis='" + numbers(axis.data(), 3) + "' damping='" +
             numbers(&damping, 1) + "' stiffness='" + numbers(&j.stiffness, 1) + "' springref='" +
             numbers(&j.target, 1) + "'/>";
    if (resistance == 0) return;
    const double force = j.motor_speed > 0 ? j.motor_force : -j.motor_force;
    motors_ += "<motor joint='" + name + "' gear='" + numbers(&force, 1) + "'/>";  // for a control of 1
  }

  void add_loop(const JointPlan& j) {
    if (j.kind != JointKind::ball) throw std::runtime_error("MuJoCo's module has no slider that closes a loop");
    const bool of_a = j.a != kWorldBody;
    text_ += "<connect body1='" + name_of(of_a ? j.a : j.b) + "'";
    if (of_a && j.b != kWorldBody) text_ += " body2='" + name_of(j.b) + "'";
    text_ += " anchor='" + numbers(of_a ? j.on_a : j.on_b, 3) + "'/>";
  }

  const WorldPlan& plan_;
  const Forest& forest_;
  std::string text_, motors_;
};

struct FreeModel {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
};
struct FreeData {
  void operator()(mjData* d) const { mj_deleteData(d); }
};

mjModel* compile(const std::string& text) {
  const auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
#if mjVERSION_HEADER >= 4000000
  mj_addBufferVFS(vfs.get(), "scene.xml", text.data(), static_cast<int>(text.size()));
#else
  mj_makeEmptyFileVFS(vfs.get(), "scene.xml", static_cast<int>(text.size()));
  std::memcpy(vfs->filedata[mj_findFileVFS(vfs.get(), "scene.xml")], text.data(), text.size());
#endif
  char error[500] = "";
  mjModel* const model = mj_loadXML("scene.xml", vfs.get(), error, sizeof error);
  mj_deleteVFS(vfs.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

class MujocoWorld : public PeerWorld {
 public:
  explicit MujocoWorld(const WorldPlan& plan)
      : forest_(plan),
        model_(compile(Text(plan, forest_).text())),
        data_(mj_makeData(model_.get())),
        substeps_(static_cast<int>(plan.dial("substeps", 1))),
        solref_(plan.dial("solref", 0.02)),
        bounce_steps_(plan.dial("bounce_steps", 20)),
        rk4_(plan.dial("integrator", 0) == 1) {
    for (std::size_t i = 0; i < plan.count; ++i) {
      const BodyPlan& b = plan.bodies[i];
      const int geom = mj_name2id(model_.get(), mjOBJ_GEOM, ("g" + std::to_string(i)).c_str());
      if (geom >= 0) {
        if (of_geom_.size() <= static_cast<std::size_t>(geom)) of_geom_.resize(static_cast<std::size_t>(geom) + 1);
        of_geom_[static_cast<std::size_t>(geom)] = {b.friction, b.restitution};
      }
      members_.push_back({b.is_static ? -1 : mj_name2id(model_.get(), mjOBJ_BODY, name_of(i).c_str()), b.start});
    }
    for (std::size_t i = 0; i < plan.count; ++i)
      if (!plan.bodies[i].is_static) start(plan, i);
    std::fill_n(data_->ctrl, model_->nu, 1.0);
    mj_forward(model_.get(), data_.get());
  }

  void step(double dt) override {
    mjModel* const m = model_.get();
    mjData* const d = data_.get();
    m->opt.timestep = dt / substeps_;
    try {
      for (int i = 0; i < substeps_ && is_sane_; ++i) advance(m, d);
    } catch (const std::exception&) {  // what MuJoCo would have ended the process for
      is_sane_ = false;
    }
    std::fill_n(d->xfrc_applied, 6 * m->nbody, 0.0);
  }

  void push(std::size_t body, const double* force) override {
    for (int k = 0; k < 3; ++k) data_->xfrc_applied[6 * members_[body].body + k] += force[k];
  }

  void read(BodyState* states) const override {
    const mjModel* const m = model_.get();
    mjData* const d = data_.get();
    mj_kinematics(m, d), mj_comPos(m, d), mj_comVel(m, d);
    for (const Member& member : members_) {
      BodyState& s = *states++;
      s = member.start;
      if (member.body < 0) continue;
      double velocity[6];  // rotation first
      mj_objectVelocity(m, d, mjOBJ_BODY, member.body, velocity, 0);
      for (int k = 0; k < 3; ++k) {
        s.position[k] = is_sane_ ? d->xpos[3 * member.body + k] : NAN;
        s.orientation[k] = d->xquat[4 * member.body + 1 + k];
        s.omega[k] = velocity[k], s.velocity[k] = velocity[3 + k];
      }
      s.orientation[3] = d->xquat[4 * member.body];
    }
  }

  std::size_t contact_points() const override { return static_cast<std::size_t>(data_->ncon); }

 private:
  void advance(const mjModel* m, mjData* d) {
    if (rk4_) {
      mj_forward(m, d);
      mj_RungeKutta(m, d, 4);
    } else {
      // mj_fwdPosition(), with the law put in between.
      mj_kinematics(m, d), mj_comPos(m, d), mj_tendon(m, d), find_masses(m, d);
      mj_collision(m, d);
      for (int k = 0; k < d->ncon; ++k) set_law(d->contact[k]);
      mj_makeConstraint(m, d), find_islands(m, d), mj_transmission(m, d), mj_projectConstraint(m, d);
      mj_fwdVelocity(m, d), mj_fwdActuation(m, d), mj_fwdAcceleration(m, d), mj_fwdConstraint(m, d);
      mj_Euler(m, d);
    }
    for (int k = 0; k < m->nq; ++k) is_sane_ &= std::fabs(d->qpos[k]) < 1e10;
  }

#if mjVERSION_HEADER >= 4000000
  static void find_masses(const mjModel* m, mjData* d) { mj_makeM(m, d), mj_factorM(m, d); }
  static void find_islands(const mjModel* m, mjData* d) { mj_island(m, d); }
#else
  static void find_masses(const mjModel* m, mjData* d) { mj_crb(m, d), mj_factorM(m, d); }
  static void find_islands(const mjModel*, mjData*) {}
#endif

  struct Member {
    int body;  // -1: static
    BodyState start;
  };
  struct Law {
    double friction = 0, restitution = 0;
  };

  /// Velocities as a plan has them, in the coordinates of a body's joint. Parents come before their children in none of
  /// this: only relative velocities count, and both are known.
  void start(const WorldPlan& plan, std::size_t i) {
    const BodyState& s = plan.bodies[i].start;
    const Forest::Node& node = forest_.nodes[i];
    const int joint = model_->body_jntadr[members_[i].body], at = model_->jnt_dofadr[joint];
    double omega[3] = {s.omega[0], s.omega[1], s.omega[2]}, back[4];
    const std::array<double, 4> q = quat_of(s.orientation);
    mju_negQuat(back, q.data());
    if (node.joint && node.joint->kind == JointKind::slider) {
      static const BodyState rest;
      const BodyState& p = node.parent == kWorldBody ? rest : plan.bodies[node.parent].start;
      double apart[3], way[3], relative[3], axis[3];
      mju_sub3(apart, s.position, p.position), mju_cross(way, p.omega, apart);  // of the parent's point
      mju_sub3(relative, s.velocity, p.velocity), mju_subFrom3(relative, way);
      mju_rotVecQuat(axis, slider_axis(*node.joint, i).data(), q.data());
      data_->qvel[at] = mju_dot3(relative, axis);
      return;
    }
    if (!node.joint) {
      std::copy_n(s.velocity, 3, &data_->qvel[at]);
      mju_rotVecQuat(&data_->qvel[at + 3], omega, back);
      return;
    }
    if (node.parent != kWorldBody) mju_subFrom3(omega, plan.bodies[node.parent].start.omega);
    mju_rotVecQuat(&data_->qvel[at], omega, back);
  }

  /// What the comparison asks of every engine: the geometric mean of frictions, the larger restitution. A spring and
  /// damper return the share e of a speed if their damping ratio is -ln e / sqrt(pi^2 + ln^2 e).
  void set_law(mjContact& contact) const {
    const Law &a = of_geom_[static_cast<std::size_t>(contact.geom1)],
              &b = of_geom_[static_cast<std::size_t>(contact.geom2)];
    const double friction = std::sqrt(a.friction * b.friction), e = std::max(a.restitution, b.restitution);
    contact.friction[0] = contact.friction[1] = std::max(friction, mjMINMU);
    if (!(friction > 0)) contact.dim = 1;
    if (!(e > 0)) {
      contact.solref[0] = std::max(solref_, 2 * model_->opt.timestep);
      return;
    }
    const double ln = std::log(e), damping = -ln / std::sqrt(kPi * kPi + ln * ln);
    const double w = kPi / (bounce_steps_ * model_->opt.timestep);
    contact.solref[0] = -w * w, contact.solref[1] = -2 * damping * w;
  }

  Forest forest_;
  std::unique_ptr<mjModel, FreeModel> model_;
  std::unique_ptr<mjData, FreeData> data_;
  std::vector<Member> members_;  // in the plan's order
  std::vector<Law> of_geom_;
  int substeps_;
  double solref_, bounce_steps_;
  bool rk4_, is_sane_ = true;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) PeerEngine carom_bench_engine() {
  mju_user_warning = [](const char*) {};
  mju_user_error = [](const char* what) { throw std::runtime_error(std::string("MuJoCo: ") + what); };
  static const std::string name = "MuJoCo " + std::string(mj_versionString()) + " (double)";
  return {name.c_str(), make_or_tell<MujocoWorld>, [] { return std::size_t(0); }};
}

}  // namespace carom::bench

// ODE in a module: its iterative stepper with default settings, except for what the comparison asks of every engine, and
// for dials: stepper (0 QuickStep, 1 the exact one: Dantzig's), iterations, erp, cfm, substeps, bounce_speed.
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <stdexcept>
#include <vector>

#include "counted_memory.h"
#include "peer.h"

namespace carom::bench {
namespace {

constexpr int kPointsPerPair = 4;  // as many as the other engines keep

/// A hull as ODE wants it: planes, points, and polygons (here triangles) with their counts.
struct Convex {
  std::vector<dReal> planes, points;
  std::vector<unsigned int> polygons;

  explicit Convex(const BodyPlan& plan) : points(plan.params, plan.params + plan.param_count) {
    for (std::size_t t = 0; t < plan.triangle_count; ++t) {
      const std::uint32_t* corner = plan.triangles + 3 * t;
      const dReal *a = &points[3 * corner[0]], *b = &points[3 * corner[1]], *c = &points[3 * corner[2]];
      const dVector3 u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      dVector3 normal;
      dCalcVectorCross3(normal, u, v);
      if (!dSafeNormalize3(normal)) continue;  // a sliver of qhull's has no plane
      planes.insert(planes.end(), {normal[0], normal[1], normal[2], dCalcVectorDot3(normal, a)});
      polygons.insert(polygons.end(), {3, corner[0], corner[1], corner[2]});
    }
  }
};

class OdeWorld : public PeerWorld {
 public:
  explicit OdeWorld(const WorldPlan& plan)
      : world_(dWorldCreate()),
        space_(dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY)),
        group_(dJointGroupCreate(0)) {
    dRandSetSeed(0);  // its stepper shuffles constraints: each repeat the same way
    dWorldSetGravity(world_, plan.gravity[0], plan.gravity[1], plan.gravity[2]);
    dWorldSetAutoDisableFlag(world_, plan.sleeping);
    dWorldSetQuickStepNumIterations(world_,
                                    static_cast<int>(plan.dial("iterations", dWorldGetQuickStepNumIterations(world_))));
    dWorldSetERP(world_, plan.dial("erp", dWorldGetERP(world_)));
    dWorldSetCFM(world_, plan.dial("cfm", dWorldGetCFM(world_)));
    exact_ = plan.dial("stepper", 0) == 1;
    substeps_ = static_cast<int>(plan.dial("substeps", 1));
    bounce_speed_ = plan.dial("bounce_speed", bounce_speed_);
    for (std::size_t i = 0; i < plan.count; ++i) add(plan.bodies[i]);
    for (std::size_t i = 0; i < plan.joint_count; ++i) {
      const JointPlan& j = plan.joints[i];
      const dBodyID a = j.a == kWorldBody ? nullptr : members_[j.a].body;
      const dBodyID b = j.b == kWorldBody ? nullptr : members_[j.b].body;
      if (j.kind == JointKind::slider) {
        add_slider(j, a, b);
        continue;
      }
      const dJointID joint = dJointCreateBall(world_, nullptr);
      dJointAttach(joint, a, b);
      dVector3 at;
      dBodyGetRelPointPos(a ? a : b, a ? j.on_a[0] : j.on_b[0], a ? j.on_a[1] : j.on_b[1], a ? j.on_a[2] : j.on_b[2],
                          at);
      dJointSetBallAnchor(joint, at[0], at[1], at[2]);
    }
  }

  ~OdeWorld() override {
    dJointGroupDestroy(group_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void step(double dt) override {
    for (int i = 0; i < substeps_; ++i) {
      contacts_ = 0;
      for (const Spring& spring : springs_) set_spring(spring, dt / substeps_);
      for (const Push& p : pushes_)
        dBodyAddForce(p.body, p.force[0], p.force[1], p.force[2]);  // forgotten after a step
      dSpaceCollide(space_, this,
                    [](void* self, dGeomID a, dGeomID b) { static_cast<OdeWorld*>(self)->collide(a, b); });
      if (exact_)
        dWorldStep(world_, dt / substeps_);
      else
        dWorldQuickStep(world_, dt / substeps_);
      dJointGroupEmpty(group_);
    }
    pushes_.clear();
  }

  void push(std::size_t body, const double* force) override {
    pushes_.push_back({members_[body].body, {force[0], force[1], force[2]}});
  }

  void read(BodyState* states) const override {
    for (const Member& member : members_) {
      *states = member.start;
      if (member.body) {
        const dReal* q = dBodyGetQuaternion(member.body);  // w first
        for (int i = 0; i < 3; ++i) {
          states->position[i] = dBodyGetPosition(member.body)[i];
          states->orientation[i] = q[i + 1];
          states->velocity[i] = dBodyGetLinearVel(member.body)[i];
          states->omega[i] = dBodyGetAngularVel(member.body)[i];
        }
        states->orientation[3] = q[0];
      }
      ++states;
    }
  }

  std::size_t contact_points() const override { return contacts_; }

 private:
  struct Member {
    dBodyID body;  // null: static
    double friction, restitution;
    BodyState start;
  };
  struct Push {
    dBodyID body;
    double force[3];  // N, for the next step
  };

  struct Spring {
    dJointID joint;
    double stiffness, damping;  // N/m, N s/m
  };

  /// Its position is that of its first body, from where the other one is now.
  void add_slider(const JointPlan& j, dBodyID a, dBodyID b) {
    const double* q = j.axes_on_b;
    const dQuaternion turn = {q[3], q[0], q[1], q[2]};
    dMatrix3 axes;
    dQtoR(turn, axes);
    dVector3 axis;
    dBodyVectorToWorld(b, axes[0], axes[4], axes[8], axis);
    const dJointID joint = dJointCreateSlider(world_, nullptr);
    dJointAttach(joint, b, a);
    dJointSetSliderAxis(joint, axis[0], axis[1], axis[2]);
    if (j.motor_force > 0)
      dJointSetSliderParam(joint, dParamVel, j.motor_speed), dJointSetSliderParam(joint, dParamFMax, j.motor_force);
    if (j.stiffness > 0) {
      dJointSetSliderParam(joint, dParamLoStop, j.target), dJointSetSliderParam(joint, dParamHiStop, j.target);
      springs_.push_back({joint, j.stiffness, j.damping});
    }
  }

  /// ODE's springs are stops at one place, as soft as its manual says for a step of dt.
  static void set_spring(const Spring& spring, double dt) {
    const double give = 1 / (dt * spring.stiffness + spring.damping);
    dJointSetSliderParam(spring.joint, dParamStopERP, dt * spring.stiffness * give);
    dJointSetSliderParam(spring.joint, dParamStopCFM, give);
  }

  void collide(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
    const auto sleeps = [](dBodyID body) { return !body || !dBodyIsEnabled(body); };
    if (sleeps(body_a) && sleeps(body_b)) return;
    dContactGeom found[kPointsPerPair];
    const int n = dCollide(a, b, kPointsPerPair, found, sizeof(dContactGeom));
    const auto friction = [](dGeomID geom) { return static_cast<const Member*>(dGeomGetData(geom))->friction; };
    const auto restitution = [](dGeomID geom) { return static_cast<const Member*>(dGeomGetData(geom))->restitution; };
    for (int i = 0; i < n; ++i) {
      dContact contact{};
      contact.geom = found[i];
      contact.surface.mode = dContactApprox1;  // friction in proportion to the normal force
      contact.surface.mu = std::sqrt(friction(a) * friction(b));
      contact.surface.bounce = std::max(restitution(a), restitution(b));
      if (contact.surface.bounce > 0) {
        contact.surface.mode |= dContactBounce;
        contact.surface.bounce_vel = bounce_speed_;
      }
      dJointAttach(dJointCreateContact(world_, group_, &contact), body_a, body_b);
    }
    contacts_ += static_cast<std::size_t>(n);
  }

  dGeomID geom(const BodyPlan& plan) {
    const double* p = plan.params;
    switch (plan.solid) {
      case Solid::none:
        return nullptr;
      case Solid::half_space:
        return dCreatePlane(space_, p[0], p[1], p[2], p[3]);
      case Solid::sphere:
        return dCreateSphere(space_, p[0]);
      case Solid::box:
        return dCreateBox(space_, 2 * p[0], 2 * p[1], 2 * p[2]);
      case Solid::capsule:
        return dCreateCapsule(space_, p[0], 2 * p[1]);
      case Solid::cylinder:
        return dCreateCylinder(space_, p[0], 2 * p[1]);
      case Solid::cone:
        throw std::runtime_error("ODE has no cones");
      case Solid::hull:
        break;
    }
    const Convex& hull = hulls_.try_emplace(p, plan).first->second;
    return dCreateConvex(space_, hull.planes.data(), static_cast<unsigned>(hull.planes.size() / 4), hull.points.data(),
                         static_cast<unsigned>(hull.points.size() / 3), hull.polygons.data());
  }

  void add(const BodyPlan& plan) {
    const BodyState& start = plan.start;
    const double* q = start.orientation;
    const dQuaternion turn = {q[3], q[0], q[1], q[2]};
    // ODE's capsules and cylinders are along z.
    const bool is_round = plan.solid == Solid::capsule || plan.solid == Solid::cylinder;
    const dQuaternion y_of_z = {M_SQRT1_2, -M_SQRT1_2, 0, 0};
    dBodyID body = nullptr;
    if (!plan.is_static) {
      body = dBodyCreate(world_);
      dMass mass;
      dMassSetParameters(&mass, plan.mass, 0, 0, 0, plan.inertia[0], plan.inertia[1], plan.inertia[2], 0, 0, 0);
      dBodySetMass(body, &mass);
      dBodySetPosition(body, start.position[0], start.position[1], start.position[2]);
      dBodySetQuaternion(body, turn);
      dBodySetLinearVel(body, start.velocity[0], start.velocity[1], start.velocity[2]);
      dBodySetAngularVel(body, start.omega[0], start.omega[1], start.omega[2]);
    }
    members_.push_back({body, plan.friction, plan.restitution, start});
    const dGeomID shape = geom(plan);
    if (!shape) return;
    dGeomSetData(shape, &members_.back());
    if (body) {
      dGeomSetBody(shape, body);
      if (is_round) dGeomSetOffsetQuaternion(shape, y_of_z);
      const double* at = plan.shape_at;
      if (at[0] != 0 || at[1] != 0 || at[2] != 0) dGeomSetOffsetPosition(shape, at[0], at[1], at[2]);
    } else if (plan.solid != Solid::half_space) {
      dQuaternion whole;
      dQMultiply0(whole, turn, y_of_z);
      dGeomSetPosition(shape, start.position[0], start.position[1], start.position[2]);
      dGeomSetQuaternion(shape, is_round ? whole : turn);
    }
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID group_;
  std::size_t contacts_ = 0;
  bool exact_ = false;
  int substeps_ = 1;
  double bounce_speed_ = 0.25;  // m/s, below which nothing bounces: Carom's default; ODE asks for one and has none
  std::vector<Push> pushes_;
  std::vector<Spring> springs_;
  std::deque<Member> members_;  // in the plan's order; geoms point to them
  std::map<const double*, Convex> hulls_;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) PeerEngine carom_bench_engine() {
  dSetAllocHandler(counted_alloc);
  dSetReallocHandler([](void* block, dsizeint, dsizeint size) { return counted_realloc(block, size); });
  dSetFreeHandler([](void* block, dsizeint) { counted_free(block); });
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  return {"ODE 0.16 (double)", make_or_tell<OdeWorld>, [] { return live_bytes.load(); }};
}

}  // namespace carom::bench

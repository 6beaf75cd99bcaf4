// Bullet 3 in a module: default settings, except for what the comparison asks of every engine, and for dials:
// iterations, erp, substeps, split_impulse (0, 1), warm_start (0, 1), solver (0 sequential impulses, 1 nonsmooth conjugate
// gradients, 2 Dantzig's direct method), bounce_speed.
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "counted_memory.h"
#include "peer.h"

namespace carom::bench {
namespace {

btVector3 vec(const double* v) { return btVector3(btScalar(v[0]), btScalar(v[1]), btScalar(v[2])); }
btQuaternion quat(const double* q) {
  return btQuaternion(btScalar(q[0]), btScalar(q[1]), btScalar(q[2]), btScalar(q[3]));
}
void put(double* out, const btVector3& v) {
  for (int i = 0; i < 3; ++i) out[i] = v[i];
}

class BulletWorld : public PeerWorld {
 public:
  explicit BulletWorld(const WorldPlan& plan)
      : sleeping_(plan.sleeping),
        substeps_(static_cast<int>(plan.dial("substeps", 1))),
        dispatcher_(&configuration_),
        solver_(solver(static_cast<int>(plan.dial("solver", 0)))),
        world_(&dispatcher_, &broadphase_, solver_.get(), &configuration_) {
    world_.setGravity(vec(plan.gravity));
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = static_cast<int>(plan.dial("iterations", info.m_numIterations));
    info.m_erp = info.m_erp2 = btScalar(plan.dial("erp", info.m_erp2));
    info.m_splitImpulse = static_cast<int>(plan.dial("split_impulse", info.m_splitImpulse));
    if (plan.dial("warm_start", 1) == 0) info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    info.m_restitutionVelocityThreshold = btScalar(plan.dial("bounce_speed", info.m_restitutionVelocityThreshold));
    for (std::size_t i = 0; i < plan.count; ++i) add(plan.bodies[i]);
    for (std::size_t i = 0; i < plan.joint_count; ++i) {
      const JointPlan& j = plan.joints[i];
      joints_.push_back(j.kind == JointKind::slider ? slider(j) : ball_joint(j));
      world_.addConstraint(joints_.back().get(), true);
    }
    world_.updateAabbs();
  }

  ~BulletWorld() override {
    for (auto& joint : joints_) world_.removeConstraint(joint.get());
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  /// Steps of exactly dt, or dt over `substeps`, no interpolation.
  void step(double dt) override {
    for (int i = 0; i < substeps_; ++i) {
      for (const auto& [body, force] : pushes_) bodies_[body]->applyCentralForce(force);  // forgotten after a step
      world_.stepSimulation(btScalar(dt / substeps_), 0);
    }
    pushes_.clear();
  }

  void push(std::size_t body, const double* force) override { pushes_.emplace_back(body, vec(force)); }

  void read(BodyState* states) const override {
    for (const auto& body : bodies_) {
      const btTransform& pose = body->getWorldTransform();
      const btQuaternion q = pose.getRotation();
      put(states->position, pose.getOrigin());
      for (int i = 0; i < 4; ++i) states->orientation[i] = q[i];
      put(states->velocity, body->getLinearVelocity());
      put(states->omega, body->getAngularVelocity());
      ++states;
    }
  }

  std::size_t contact_points() const override {
    std::size_t n = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
      n += static_cast<std::size_t>(dispatcher_.getInternalManifoldPointer()[i]->getNumContacts());
    return n;
  }

  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    for (std::size_t i = 0; i < n; ++i) {
      const btVector3 from = vec(ends + 6 * i), to = vec(ends + 6 * i + 3);
      btCollisionWorld::ClosestRayResultCallback first(from, to);
      world_.rayTest(from, to, first);
      fractions[i] = first.hasHit() ? double(first.m_closestHitFraction) : 2;
    }
    return true;
  }

 private:
  static std::unique_ptr<btConstraintSolver> solver(int kind) {
    if (kind == 1) return std::make_unique<btNNCGConstraintSolver>();
    if (kind == 2) {
      static btDantzigSolver direct;  // holds no state between steps
      return std::make_unique<btMLCPSolver>(&direct);
    }
    return std::make_unique<btSequentialImpulseConstraintSolver>();
  }

  std::unique_ptr<btTypedConstraint> ball_joint(const JointPlan& j) {
    if (j.a == kWorldBody) return std::make_unique<btPoint2PointConstraint>(*bodies_[j.b], vec(j.on_b));
    if (j.b == kWorldBody) return std::make_unique<btPoint2PointConstraint>(*bodies_[j.a], vec(j.on_a));
    return std::make_unique<btPoint2PointConstraint>(*bodies_[j.a], *bodies_[j.b], vec(j.on_a), vec(j.on_b));
  }

  std::unique_ptr<btTypedConstraint> slider(const JointPlan& j) {
    using Joint = btGeneric6DofSpring2Constraint;
    const btTransform in_b(quat(j.axes_on_b), vec(j.on_b)), in_a(quat(j.axes_on_a), vec(j.on_a));
    auto joint = j.a == kWorldBody ? std::make_unique<Joint>(*bodies_[j.b], in_b)
                                   : std::make_unique<Joint>(*bodies_[j.a], *bodies_[j.b], in_a, in_b);
    joint->setLinearLowerLimit(btVector3(1, 0, 0)), joint->setLinearUpperLimit(btVector3(-1, 0, 0));  // x is free
    joint->setAngularLowerLimit(btVector3(0, 0, 0)), joint->setAngularUpperLimit(btVector3(0, 0, 0));
    if (j.motor_force > 0) {
      joint->enableMotor(0, true);
      joint->setTargetVelocity(0, btScalar(-j.motor_speed));  // its motors drive A along B
      joint->setMaxMotorForce(0, btScalar(j.motor_force));
    }
    if (j.stiffness > 0) {
      joint->enableSpring(0, true);
      joint->setStiffness(0, btScalar(j.stiffness)), joint->setDamping(0, btScalar(j.damping));
      joint->setEquilibriumPoint(0, btScalar(j.target));
    }
    return joint;
  }

  std::unique_ptr<btCollisionShape> make_shape(const BodyPlan& plan) {
    const double* p = plan.params;
    switch (plan.solid) {
      case Solid::none:
        break;
      case Solid::half_space:
        return std::make_unique<btStaticPlaneShape>(vec(p), btScalar(p[3]));
      case Solid::sphere:
        return std::make_unique<btSphereShape>(btScalar(p[0]));
      case Solid::box:
        return std::make_unique<btBoxShape>(vec(p));
      case Solid::hull: {
        auto hull = std::make_unique<btConvexHullShape>();
        for (std::size_t i = 0; i + 3 <= plan.param_count; i += 3) hull->addPoint(vec(p + i), false);
        hull->recalcLocalAabb();
        return hull;
      }
      case Solid::capsule:
        return std::make_unique<btCapsuleShape>(btScalar(p[0]), btScalar(2 * p[1]));
      case Solid::cylinder:
        return std::make_unique<btCylinderShape>(btVector3(btScalar(p[0]), btScalar(p[1]), btScalar(p[0])));
      case Solid::cone: {
        auto cone = std::make_unique<btConeShape>(btScalar(p[0]), btScalar(2 * p[1]));
        cone->setMargin(btScalar(1e-4 * p[1]));  // its usual 4 cm are around it, not within as a box's are
        return cone;
      }
    }
    return std::make_unique<btEmptyShape>();
  }

  btCollisionShape* shape(const BodyPlan& plan) {
    std::unique_ptr<btCollisionShape>& shared = shapes_[{plan.solid, plan.params}];
    if (shared) return shared.get();
    shared = make_shape(plan);
    const btVector3 at = vec(plan.shape_at);
    if (at.isZero()) return shared.get();
    parts_.push_back(std::move(shared));
    auto moved = std::make_unique<btCompoundShape>();
    moved->addChildShape(btTransform(btQuaternion::getIdentity(), at), parts_.back().get());
    shared = std::move(moved);
    return shared.get();
  }

  void add(const BodyPlan& plan) {
    const BodyState& start = plan.start;
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(plan.is_static ? 0 : plan.mass), nullptr, shape(plan),
                                                  plan.is_static ? btVector3(0, 0, 0) : vec(plan.inertia));
    info.m_startWorldTransform = btTransform(quat(start.orientation), vec(start.position));
    info.m_friction = btScalar(std::sqrt(plan.friction));  // Bullet multiplies the two coefficients of a pair
    info.m_restitution = btScalar(plan.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    if (!sleeping_) body.setActivationState(DISABLE_DEACTIVATION);
    body.setLinearVelocity(vec(start.velocity));
    body.setAngularVelocity(vec(start.omega));
    if (plan.solid == Solid::none)
      world_.addRigidBody(&body, 0, 0);  // meets nobody
    else
      world_.addRigidBody(&body);
  }

  bool sleeping_;
  int substeps_;
  std::vector<std::pair<std::size_t, btVector3>> pushes_;  // N, for the next step
  btDefaultCollisionConfiguration configuration_;
  mutable btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btConstraintSolver> solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> parts_;  // of shapes that are not at their bodies' origins
  std::map<std::pair<Solid, const double*>, std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  // in the plan's order
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

#ifdef BT_USE_DOUBLE_PRECISION
constexpr const char* kName = "Bullet 3.24 (double)";
#else
constexpr const char* kName = "Bullet 3.24 (float)";
#endif
static_assert(BT_BULLET_VERSION == 324, "the name above says another version");

}  // namespace

extern "C" __attribute__((visibility("default"))) PeerEngine carom_bench_engine() {
  btAlignedAllocSetCustomAligned(
      [](std::size_t size, int alignment) { return counted_aligned_alloc(size, static_cast<std::size_t>(alignment)); },
      counted_free);
  // Of two surfaces the livelier counts; Bullet's own rule multiplies.
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject* a, const btCollisionObject* b) {
    return btMax(a->getRestitution(), b->getRestitution());
  };
  return {kName, [](const WorldPlan& plan) -> PeerWorld* { return new BulletWorld(plan); },
          [] { return live_bytes.load(); }};
}

}  // namespace carom::bench

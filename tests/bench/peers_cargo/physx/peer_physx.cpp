// PhysX 5 on the CPU in a module: its newer solver, TGS, since by PGS, the default of scenes, the joints of S8 gape by 2.3 m
// (by TGS 66 mm); else default settings (patch friction, 4 iterations for positions and 1 for velocities), except for what the
// comparison asks of every engine.
#include "sdk.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include "counted_memory.h"
#include "peer.h"

namespace carom::bench {
namespace {

constexpr std::size_t kMostThreads = 64;
using namespace physx;

PxVec3 vec(const double* v) { return PxVec3(float(v[0]), float(v[1]), float(v[2])); }
PxQuat quat(const double* q) { return PxQuat(float(q[0]), float(q[1]), float(q[2]), float(q[3])).getNormalized(); }
void put(double* out, const PxVec3& v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }

class Allocator final : public PxAllocatorCallback {
 public:
  void* allocate(std::size_t size, const char*, const char*, int) override { return counted_aligned_alloc(size, 16); }
  void deallocate(void* block) override { counted_free(block); }
};

class Complaints final : public PxErrorCallback {
 public:
  void reportError(PxErrorCode::Enum, const char* message, const char*, int) override {
    std::fprintf(stderr, "PhysX: %s\n", message);
  }
};

}  // namespace

physx::PxPhysics& physx_sdk() {
  static Allocator allocator;
  static Complaints complaints;
  static PxFoundation* const foundation = PxCreateFoundation(PX_PHYSICS_VERSION, allocator, complaints);
  static PxPhysics* const physics = PxCreatePhysics(PX_PHYSICS_VERSION, *foundation, PxTolerancesScale());
  return *physics;
}

physx::PxConvexMesh* make_physx_hull(const double* xyz, std::size_t count) {
  std::vector<PxVec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(vec(xyz + 3 * i));
  PxConvexMeshDesc desc;
  desc.points.count = static_cast<PxU32>(points.size());
  desc.points.stride = sizeof(PxVec3);
  desc.points.data = points.data();
  desc.flags = PxConvexFlag::eCOMPUTE_CONVEX;
  PxPhysics& sdk = physx_sdk();
  return PxCreateConvexMesh(PxCookingParams(sdk.getTolerancesScale()), desc, sdk.getPhysicsInsertionCallback());
}

namespace {

class PhysxWorld final : public PeerWorld {
 public:
  explicit PhysxWorld(const WorldPlan& plan) {
    PxPhysics& sdk = physx_sdk();  // first: all else needs what it sets up
    // Without workers the caller's thread does all.
    dispatcher_ = PxDefaultCpuDispatcherCreate(plan.threads == 1 ? 0 : static_cast<PxU32>(plan.threads));
    PxSceneDesc desc(sdk.getTolerancesScale());
    desc.gravity = vec(plan.gravity);
    desc.cpuDispatcher = dispatcher_;
    desc.solverType = PxSolverType::eTGS;
    desc.filterShader = PxDefaultSimulationFilterShader;
    scene_ = sdk.createScene(desc);
    for (std::size_t i = 0; i < plan.count; ++i) add(plan.bodies[i], plan.sleeping);
    for (std::size_t i = 0; i < plan.joint_count; ++i) add(plan.joints[i]);
  }

  ~PhysxWorld() override {
    for (PxJoint* joint : joints_) joint->release();
    for (PxRigidActor* body : bodies_) body->release();
    for (auto& [params, hull] : hulls_) hull->release();
    for (auto& [params, material] : materials_) material->release();
    scene_->release();
    dispatcher_->release();
  }

  void step(double dt) override {
    scene_->simulate(float(dt));
    scene_->fetchResults(true);
  }

  void read(BodyState* states) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i, ++states) {
      *states = starts_[i];  // a plane has a pose of its own, and stays there
      const PxRigidDynamic* const body = bodies_[i]->is<PxRigidDynamic>();
      if (!body) continue;
      const PxTransform pose = body->getGlobalPose();
      put(states->position, pose.p);
      put(states->orientation, pose.q.getImaginaryPart());
      states->orientation[3] = pose.q.w;
      put(states->velocity, body->getLinearVelocity());
      put(states->omega, body->getAngularVelocity());
    }
  }

  std::size_t contact_points() const override { return kNotTold; }

  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    for (std::size_t i = 0; i < n; ++i) {
      PxVec3 way = vec(ends + 6 * i + 3) - vec(ends + 6 * i);
      const float length = way.normalize();
      PxRaycastBuffer hit;
      fractions[i] = scene_->raycast(vec(ends + 6 * i), way, length, hit) ? double(hit.block.distance) / length : 2;
    }
    return true;
  }

 private:
  void add(const BodyPlan& plan, bool sleeping) {
    PxTransform pose(vec(plan.start.position), quat(plan.start.orientation));
    if (plan.solid == Solid::half_space)
      pose = PxTransformFromPlaneEquation(PxPlane(vec(plan.params), -float(plan.params[3])));
    if (plan.is_static) {
      bodies_.push_back(physx_sdk().createRigidStatic(pose));
      add_shape(plan);
    } else {
      PxRigidDynamic* const body = physx_sdk().createRigidDynamic(pose);
      bodies_.push_back(body);
      add_shape(plan);
      body->setMass(float(plan.mass));
      body->setMassSpaceInertiaTensor(vec(plan.inertia));
      body->setLinearDamping(0);
      body->setAngularDamping(0);
      body->setLinearVelocity(vec(plan.start.velocity));
      body->setAngularVelocity(vec(plan.start.omega));
      if (!sleeping) body->setSleepThreshold(0);
    }
    scene_->addActor(*bodies_.back());
    starts_.push_back(plan.start);
  }

  /// The bodies of one scene have few frictions.
  PxMaterial& material(const BodyPlan& plan) {
    PxMaterial*& shared = materials_[{plan.friction, plan.restitution}];
    if (!shared) {
      const float friction = std::sqrt(float(plan.friction));  // of a pair the product counts
      shared = physx_sdk().createMaterial(friction, friction, float(plan.restitution));
      shared->setFrictionCombineMode(PxCombineMode::eMULTIPLY);
      shared->setRestitutionCombineMode(PxCombineMode::eMAX);
    }
    return *shared;
  }

  void add_shape(const BodyPlan& plan) {
    const double* p = plan.params;
    PxRigidActor& body = *bodies_.back();
    const auto attach = [&](const PxGeometry& solid) {
      PxRigidActorExt::createExclusiveShape(body, solid, material(plan));
    };
    switch (plan.solid) {
      case Solid::none:
      default:  // no plan of s_table has the others
        break;
      case Solid::half_space:
        return attach(PxPlaneGeometry());
      case Solid::sphere:
        return attach(PxSphereGeometry(float(p[0])));
      case Solid::box:
        return attach(PxBoxGeometry(vec(p)));
      case Solid::hull:
        return attach(PxConvexMeshGeometry(&hull(plan)));
    }
  }

  PxConvexMesh& hull(const BodyPlan& plan) {
    PxConvexMesh*& shared = hulls_[plan.params];
    if (!shared) shared = make_physx_hull(plan.params, plan.param_count / 3);
    return *shared;
  }

  void add(const JointPlan& plan) {
    const auto end = [&](std::size_t i) { return i == kWorldBody ? nullptr : bodies_[i]; };
    joints_.push_back(PxSphericalJointCreate(physx_sdk(), end(plan.a), PxTransform(vec(plan.on_a)), end(plan.b),
                                             PxTransform(vec(plan.on_b))));
  }

  PxDefaultCpuDispatcher* dispatcher_;
  PxScene* scene_;
  std::vector<PxRigidActor*> bodies_;  // in the plan's order
  std::vector<BodyState> starts_;      // likewise
  std::vector<PxJoint*> joints_;
  std::map<std::pair<double, double>, PxMaterial*> materials_;
  std::map<const double*, PxConvexMesh*> hulls_;
};

static_assert(PX_PHYSICS_VERSION_MAJOR == 5 && PX_PHYSICS_VERSION_MINOR == 1 && PX_PHYSICS_VERSION_BUGFIX == 3,
              "the name below says another version");

}  // namespace

extern "C" PeerEngine carom_peer_engine() {
  return {"PhysX 5.1.3 (float)", [](const WorldPlan& plan) -> PeerWorld* { return new PhysxWorld(plan); },
          [] { return live_bytes.load(); }, kMostThreads};
}

}  // namespace carom::bench

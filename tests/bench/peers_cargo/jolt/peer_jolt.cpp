// Jolt in a module: default settings, one collision step, except for what the comparison asks of every engine. This version
// has neither a half-space nor a body without shape: a box that is wide and thick enough, and a small ball that meets nobody.
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/JobSystemThreadPool.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/CastResult.h>
#include <Jolt/Physics/Collision/GroupFilterTable.h>
#include <Jolt/Physics/Collision/RayCast.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Constraints/PointConstraint.h>
#include <Jolt/Physics/PhysicsSettings.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <vector>

#include "counted_memory.h"
#include "ground.h"
#include "peer.h"

namespace carom::bench {
namespace {

constexpr std::size_t kMostThreads = 64;
constexpr JPH::ObjectLayer kFixed = 0, kMoving = 1, kAlone = 2;

JPH::Vec3 vec(const double* v) { return JPH::Vec3(float(v[0]), float(v[1]), float(v[2])); }
JPH::Quat quat(const double* q) { return JPH::Quat(float(q[0]), float(q[1]), float(q[2]), float(q[3])).Normalized(); }
void put(double* out, JPH::Vec3 v) {
  for (std::uint32_t i = 0; i < 3; ++i) out[i] = v[i];
}

/// Two trees, of what moves and what doesn't.
class Trees final : public JPH::BroadPhaseLayerInterface {
 public:
  JPH::uint GetNumBroadPhaseLayers() const override { return 2; }
  JPH::BroadPhaseLayer GetBroadPhaseLayer(JPH::ObjectLayer layer) const override {
    return JPH::BroadPhaseLayer(layer == kFixed ? 0 : 1);
  }
};

class TreeFilter final : public JPH::ObjectVsBroadPhaseLayerFilter {
 public:
  bool ShouldCollide(JPH::ObjectLayer layer, JPH::BroadPhaseLayer tree) const override {
    return layer == kMoving || (layer == kFixed && tree == JPH::BroadPhaseLayer(1));
  }
};

class PairFilter final : public JPH::ObjectLayerPairFilter {
 public:
  bool ShouldCollide(JPH::ObjectLayer a, JPH::ObjectLayer b) const override {
    return a != kAlone && b != kAlone && (a == kMoving || b == kMoving);
  }
};

/// What a step needs for itself, last in, first out. Not counted: how much there is of it, the host chooses.
class Stack final : public JPH::TempAllocator {
 public:
  explicit Stack(std::size_t bodies) : size_((16u << 20) + 32u * 1024 * bodies), block_(std::malloc(size_)) {}
  ~Stack() override { std::free(block_); }
  void* Allocate(JPH::uint size) override {
    if (size == 0) return nullptr;
    const std::size_t from = top_;
    top_ += (size + kAlignment - 1) / kAlignment * kAlignment;
    if (top_ + kAlignment > size_) std::fprintf(stderr, "Jolt: out of scratch memory\n"), std::abort();
    return start() + from;
  }
  void Free(void* block, JPH::uint) override {
    if (block) top_ = static_cast<std::size_t>(static_cast<char*>(block) - start());
  }

 private:
  static constexpr std::size_t kAlignment = 64;
  char* start() const {
    return static_cast<char*>(block_) + (kAlignment - reinterpret_cast<std::uintptr_t>(block_) % kAlignment);
  }
  std::size_t size_, top_ = 0;
  void* block_;
};

std::unique_ptr<JPH::JobSystem> jobs_for(std::size_t threads) {
  if (threads == 1) return std::make_unique<JPH::JobSystemSingleThreaded>(JPH::cMaxPhysicsJobs);
  return std::make_unique<JPH::JobSystemThreadPool>(JPH::cMaxPhysicsJobs, JPH::cMaxPhysicsBarriers,
                                                    static_cast<int>(threads) - 1);
}

class JoltWorld final : public PeerWorld {
 public:
  explicit JoltWorld(const WorldPlan& plan)
      : stack_(plan.count), jobs_(jobs_for(plan.threads)), ground_half_width_(float(ground_half_width(plan))) {
    const auto count = static_cast<JPH::uint>(plan.count);
    system_.Init(count, 0, 12 * count + 4096, 8 * count + 1024, trees_, tree_filter_, pair_filter_);
    system_.SetGravity(vec(plan.gravity));
    if (plan.joint_count) group_ = new JPH::GroupFilterTable(count);
    for (std::size_t i = 0; i < plan.count; ++i) add(plan.bodies[i], plan.sleeping);
    for (std::size_t i = 0; i < plan.joint_count; ++i) add(plan.joints[i]);
    system_.OptimizeBroadPhase();
  }

  ~JoltWorld() override {
    for (JPH::Constraint* joint : joints_) system_.RemoveConstraint(joint);
    JPH::BodyInterface& made = system_.GetBodyInterface();
    for (JPH::Body* body : bodies_) {
      const JPH::BodyID id = body->GetID();
      made.RemoveBody(id);
      made.DestroyBody(id);
    }
  }

  void step(double dt) override {
    const JPH::EPhysicsUpdateError error = system_.Update(float(dt), 1, &stack_, jobs_.get());
    if (error != JPH::EPhysicsUpdateError::None && !told_) {
      std::fprintf(stderr, "Jolt: error %u in a step: a buffer is too small\n", static_cast<unsigned>(error));
      told_ = true;
    }
  }

  void read(BodyState* states) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i, ++states) {
      const JPH::Body* const body = bodies_[i];
      *states = starts_[i];  // a half-space is a box elsewhere, which stays there
      if (body->IsStatic()) continue;
      put(states->position, body->GetPosition());
      const JPH::Quat q = body->GetRotation();
      put(states->orientation, q.GetXYZ());
      states->orientation[3] = q.GetW();
      put(states->velocity, body->GetLinearVelocity());
      put(states->omega, body->GetAngularVelocity());
    }
  }

  std::size_t contact_points() const override { return kNotTold; }

  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    const JPH::NarrowPhaseQuery& query = system_.GetNarrowPhaseQuery();
    for (std::size_t i = 0; i < n; ++i) {
      const JPH::Vec3 from = vec(ends + 6 * i);
      JPH::RayCastResult hit;
      fractions[i] = query.CastRay({from, vec(ends + 6 * i + 3) - from}, hit) ? double(hit.mFraction) : 2;
    }
    return true;
  }

 private:
  using Settings = JPH::BodyCreationSettings;

  void add(const BodyPlan& plan, bool sleeping) {
    JPH::Vec3 position = vec(plan.start.position);
    JPH::Quat turn = quat(plan.start.orientation);
    if (plan.solid == Solid::half_space) {
      const JPH::Vec3 normal = turn * vec(plan.params);
      position += normal * (float(plan.params[3] - kGroundHalfDepth));
      turn = JPH::Quat::sFromTo(JPH::Vec3::sAxisY(), normal);
    }
    const JPH::ObjectLayer layer = plan.is_static ? kFixed : plan.solid == Solid::none ? kAlone : kMoving;
    Settings made(shape(plan), position, turn, plan.is_static ? JPH::EMotionType::Static : JPH::EMotionType::Dynamic,
                  layer);
    made.mFriction = float(plan.friction);
    made.mRestitution = float(plan.restitution);
    if (group_) made.mCollisionGroup = {group_, 0, static_cast<JPH::CollisionGroup::SubGroupID>(bodies_.size())};
    if (!plan.is_static) {
      made.mLinearVelocity = vec(plan.start.velocity);
      made.mAngularVelocity = vec(plan.start.omega);
      made.mLinearDamping = made.mAngularDamping = 0;
      made.mAllowSleeping = sleeping;
      made.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
      made.mMassPropertiesOverride.mMass = float(plan.mass);
      made.mMassPropertiesOverride.mInertia = JPH::Mat44::sScale(vec(plan.inertia));
    }
    JPH::BodyInterface& bodies = system_.GetBodyInterface();
    bodies_.push_back(bodies.CreateBody(made));
    starts_.push_back(plan.start);
    bodies.AddBody(bodies_.back()->GetID(),
                   plan.is_static ? JPH::EActivation::DontActivate : JPH::EActivation::Activate);
  }

  const JPH::Shape* shape(const BodyPlan& plan) {
    JPH::RefConst<JPH::Shape>& shared = shapes_[plan.params];
    if (!shared) shared = make_shape(plan);
    return shared;
  }

  JPH::RefConst<JPH::Shape> make_shape(const BodyPlan& plan) const {
    const double* p = plan.params;
    const auto box = [](JPH::Vec3 half) {
      return new JPH::BoxShape(half, std::min(JPH::cDefaultConvexRadius, half.ReduceMin()));
    };
    switch (plan.solid) {
      case Solid::none:
        return new JPH::SphereShape(0.01f);
      case Solid::half_space:
        return box({ground_half_width_, float(kGroundHalfDepth), ground_half_width_});
      case Solid::sphere:
        return new JPH::SphereShape(float(p[0]));
      case Solid::box:
        return box(vec(p));
      case Solid::hull:
      default:  // no plan of s_table has the others
        break;
    }
    JPH::Array<JPH::Vec3> points;
    for (std::size_t i = 0; i + 3 <= plan.param_count; i += 3) points.push_back(vec(p + i));
    return JPH::ConvexHullShapeSettings(points).Create().Get();
  }

  void add(const JointPlan& plan) {
    const auto end = [&](std::size_t i) -> JPH::Body& {
      return i == kWorldBody ? JPH::Body::sFixedToWorld : *bodies_[i];
    };
    JPH::PointConstraintSettings settings;
    settings.mSpace = JPH::EConstraintSpace::LocalToBodyCOM;
    settings.mPoint1 = vec(plan.on_a);
    settings.mPoint2 = vec(plan.on_b);
    joints_.push_back(settings.Create(end(plan.a), end(plan.b)));
    system_.AddConstraint(joints_.back());
    if (plan.a == kWorldBody || plan.b == kWorldBody) return;
    group_->DisableCollision(static_cast<std::uint32_t>(plan.a), static_cast<std::uint32_t>(plan.b));
  }

  Trees trees_;
  TreeFilter tree_filter_;
  PairFilter pair_filter_;
  Stack stack_;
  std::unique_ptr<JPH::JobSystem> jobs_;
  float ground_half_width_;  // m
  std::map<const double*, JPH::RefConst<JPH::Shape>> shapes_;
  JPH::Ref<JPH::GroupFilterTable> group_;
  JPH::PhysicsSystem system_;
  std::vector<JPH::Body*> bodies_;  // in the plan's order
  std::vector<BodyState> starts_;   // likewise
  std::vector<JPH::Constraint*> joints_;
  bool told_ = false;
};

}  // namespace

/// Before anything else is asked of it.
void set_up_jolt() {
  if (JPH::Factory::sInstance) return;
  JPH::Allocate = counted_alloc;
  JPH::Free = counted_free;
  JPH::AlignedAllocate = counted_aligned_alloc;
  JPH::AlignedFree = counted_free;
  JPH::Factory::sInstance = new JPH::Factory;
  JPH::RegisterTypes();
}

extern "C" PeerEngine carom_peer_engine() {
  set_up_jolt();
  return {"Jolt 5.0.0 (float)", [](const WorldPlan& plan) -> PeerWorld* { return new JoltWorld(plan); },
          [] { return live_bytes.load(); }, kMostThreads};
}

}  // namespace carom::bench

// Box3D in a module: default settings and four substeps, as its samples step, except for what the comparison asks of
// every engine. Box3D has no half-space: a box that is wide and thick enough takes its place.
#include <box3d/box3d.h>

#include <map>
#include <vector>

#include "counted_memory.h"
#include "ground.h"
#include "peer.h"

namespace carom::bench {
namespace {

constexpr std::size_t kMostThreads = B3_MAX_WORKERS;
constexpr int kSubsteps = 4;

b3Vec3 vec(const double* v) { return {float(v[0]), float(v[1]), float(v[2])}; }
b3Quat quat(const double* q) { return {vec(q), float(q[3])}; }
void put(double* out, b3Vec3 v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }

class Box3dWorld final : public PeerWorld {
 public:
  explicit Box3dWorld(const WorldPlan& plan) : ground_half_width_(float(ground_half_width(plan))) {
    b3WorldDef def = b3DefaultWorldDef();
    def.gravity = vec(plan.gravity);
    def.enableSleep = plan.sleeping;
    def.workerCount = static_cast<std::uint32_t>(plan.threads);
    world_ = b3CreateWorld(&def);
    for (std::size_t i = 0; i < plan.count; ++i) add(plan.bodies[i]);
    for (std::size_t i = 0; i < plan.joint_count; ++i) add(plan.joints[i]);
  }

  ~Box3dWorld() override {
    b3DestroyWorld(world_);
    for (auto& [params, hull] : hulls_) b3DestroyHull(hull);
  }

  void step(double dt) override { b3World_Step(world_, float(dt), kSubsteps); }

  void read(BodyState* states) const override {
    for (const b3BodyId body : bodies_) {
      const b3WorldTransform pose = b3Body_GetTransform(body);
      put(states->position, pose.p);
      put(states->orientation, pose.q.v);
      states->orientation[3] = pose.q.s;
      put(states->velocity, b3Body_GetLinearVelocity(body));
      put(states->omega, b3Body_GetAngularVelocity(body));
      ++states;
    }
  }

  std::size_t contact_points() const override {
    std::size_t n = 0;
    std::vector<b3ContactData> contacts;
    for (const b3BodyId body : bodies_) {
      contacts.resize(static_cast<std::size_t>(b3Body_GetContactCapacity(body)));
      const int count = b3Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()));
      for (int i = 0; i < count; ++i) {
        const b3ContactData& contact = contacts[static_cast<std::size_t>(i)];
        if (b3Shape_GetBody(contact.shapeIdA).index1 != body.index1) continue;  // the other body counts it
        for (int k = 0; k < contact.manifoldCount; ++k) n += static_cast<std::size_t>(contact.manifolds[k].pointCount);
      }
    }
    return n;
  }

  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    for (std::size_t i = 0; i < n; ++i) {
      const double* e = ends + 6 * i;
      const double way[3] = {e[3] - e[0], e[4] - e[1], e[5] - e[2]};
      const b3RayResult hit = b3World_CastRayClosest(world_, vec(e), vec(way), b3DefaultQueryFilter());
      fractions[i] = hit.hit ? double(hit.fraction) : 2;
    }
    return true;
  }

 private:
  void add(const BodyPlan& plan) {
    b3BodyDef def = b3DefaultBodyDef();
    def.type = plan.is_static ? b3_staticBody : b3_dynamicBody;
    def.position = vec(plan.start.position);
    def.rotation = quat(plan.start.orientation);
    def.linearVelocity = vec(plan.start.velocity);
    def.angularVelocity = vec(plan.start.omega);
    const b3BodyId body = b3CreateBody(world_, &def);
    bodies_.push_back(body);
    add_shape(body, plan);
    if (plan.is_static) return;
    b3MassData mass{};
    mass.mass = float(plan.mass);
    mass.inertia.cx.x = float(plan.inertia[0]);
    mass.inertia.cy.y = float(plan.inertia[1]);
    mass.inertia.cz.z = float(plan.inertia[2]);
    b3Body_SetMassData(body, mass);
  }

  void add_shape(b3BodyId body, const BodyPlan& plan) {
    b3ShapeDef def = b3DefaultShapeDef();
    def.baseMaterial.friction = float(plan.friction);
    def.baseMaterial.restitution = float(plan.restitution);
    def.updateBodyMass = false;
    const double* p = plan.params;
    switch (plan.solid) {
      case Solid::none:
      default:  // no plan of s_table has the others
        break;
      case Solid::half_space: {
        const b3BoxHull ground = ground_below(vec(p), float(p[3]));
        b3CreateHullShape(body, &def, &ground.base);
        break;
      }
      case Solid::sphere: {
        const b3Sphere sphere = {{0, 0, 0}, float(p[0])};
        b3CreateSphereShape(body, &def, &sphere);
        break;
      }
      case Solid::box: {
        const b3BoxHull box = b3MakeBoxHull(float(p[0]), float(p[1]), float(p[2]));
        b3CreateHullShape(body, &def, &box.base);
        break;
      }
      case Solid::hull: {
        b3HullData*& hull = hulls_[p];
        if (!hull) {
          std::vector<b3Vec3> points;
          for (std::size_t i = 0; i + 3 <= plan.param_count; i += 3) points.push_back(vec(p + i));
          const int count = static_cast<int>(points.size());
          hull = b3CreateHull(points.data(), count, count);
        }
        b3CreateHullShape(body, &def, hull);
      }
    }
  }

  b3BoxHull ground_below(b3Vec3 normal, float offset) const {
    const float depth = kGroundHalfDepth, width = ground_half_width_;
    const b3Transform pose = {b3MulSV(offset - depth, normal), b3ComputeQuatBetweenUnitVectors({0, 1, 0}, normal)};
    return b3MakeTransformedBoxHull(width, depth, width, pose);
  }

  void add(const JointPlan& plan) {
    b3SphericalJointDef def = b3DefaultSphericalJointDef();
    def.base.bodyIdA = plan.a == kWorldBody ? ground() : bodies_[plan.a];
    def.base.bodyIdB = plan.b == kWorldBody ? ground() : bodies_[plan.b];
    def.base.localFrameA.p = vec(plan.on_a);
    def.base.localFrameB.p = vec(plan.on_b);
    b3CreateSphericalJoint(world_, &def);
  }

  b3BodyId ground() {
    if (B3_IS_NULL(ground_)) {
      const b3BodyDef def = b3DefaultBodyDef();
      ground_ = b3CreateBody(world_, &def);
    }
    return ground_;
  }

  float ground_half_width_;  // m
  b3WorldId world_;
  b3BodyId ground_ = b3_nullBodyId;
  std::vector<b3BodyId> bodies_;  // in the plan's order
  std::map<const double*, b3HullData*> hulls_;
};

}  // namespace

extern "C" PeerEngine carom_peer_engine() {
  b3SetAllocator(
      [](std::int32_t size, std::int32_t alignment) {
        return counted_aligned_alloc(static_cast<std::size_t>(size), static_cast<std::size_t>(alignment));
      },
      counted_free);
  return {"Box3D 0.1.0 (float)", [](const WorldPlan& plan) -> PeerWorld* { return new Box3dWorld(plan); },
          [] { return live_bytes.load(); }, kMostThreads};
}

}  // namespace carom::bench

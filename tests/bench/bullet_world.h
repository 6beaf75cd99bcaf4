// The bodies of a stage in a Bullet world of default settings, except for what the comparison asks of both engines.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "judge.h"

namespace carom::bench {

class BulletWorld {
 public:
  BulletWorld(const tools::Stage& stage, const Judge& judge, int iterations)
      : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity(btVector3(0, btScalar(-9.81), 0));
    if (iterations > 0) world_.getSolverInfo().m_numIterations = iterations;
    for (std::size_t i = 0; i < stage.actors.size(); ++i) add(stage.actors[i], judge.mass(i));
  }

  ~BulletWorld() {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  /// One step of exactly dt, no substeps, no interpolation.
  void step(double dt) { world_.stepSimulation(btScalar(dt), 0); }

  void read(std::vector<BodyState>& states) const {
    states.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const btTransform& pose = bodies_[i]->getWorldTransform();
      const btQuaternion q = pose.getRotation();
      states[i].position = vec(pose.getOrigin());
      states[i].orientation = Quat(q.w(), q.x(), q.y(), q.z());
      states[i].velocity = vec(bodies_[i]->getLinearVelocity());
      states[i].omega = vec(bodies_[i]->getAngularVelocity());
    }
  }

  int iterations() { return world_.getSolverInfo().m_numIterations; }

  std::size_t contact_points() {
    std::size_t n = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
      n += static_cast<std::size_t>(dispatcher_.getManifoldByIndexInternal(i)->getNumContacts());
    return n;
  }

 private:
  static Vec vec(const btVector3& v) { return Vec(v.x(), v.y(), v.z()); }
  static btVector3 vec(const Vec& v) { return btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z())); }

  void add(const tools::Actor& actor, double mass) {
    const tools::Part& part = actor.parts.at(0);
    const std::vector<double>& p = part.params;
    if (part.shape == "half_space") {
      shapes_.push_back(std::make_unique<btStaticPlaneShape>(vec(Vec(p[0], p[1], p[2])), btScalar(p[3])));
    } else if (part.shape == "sphere") {
      shapes_.push_back(std::make_unique<btSphereShape>(btScalar(p[0])));
    } else {
      shapes_.push_back(std::make_unique<btBoxShape>(vec(Vec(p[0], p[1], p[2]))));
    }
    const bool is_static = actor.type == CAROM_BODY_STATIC;
    btVector3 inertia(0, 0, 0);
    if (!is_static) shapes_.back()->calculateLocalInertia(btScalar(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(is_static ? btScalar(0) : btScalar(mass), nullptr,
                                                  shapes_.back().get(), inertia);
    const Quat& q = actor.orientation;
    info.m_startWorldTransform = btTransform(
        btQuaternion(btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())), vec(actor.position));
    // Bullet multiplies the two coefficients; the root makes a pair's friction the one that Carom's mean gives.
    info.m_friction = btScalar(std::sqrt(part.friction));
    info.m_restitution = btScalar(part.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    bodies_.back()->setLinearVelocity(vec(actor.linear_velocity));
    bodies_.back()->setAngularVelocity(vec(actor.angular_velocity));
    world_.addRigidBody(bodies_.back().get());
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  // in the order of the stage's actors
};

}  // namespace carom::bench

// What is constant while a step runs: masses, materials, dials, gravity. Structure of arrays, indexed by body slot.
#pragma once

#include "collision/colliders.h"
#include "core/pair_counts.h"
#include "core/pool.h"
#include "dynamics/body_attributes.h"
#include "dynamics/dials.h"
#include "dynamics/effect_rows.h"
#include "dynamics/force/sources.h"

namespace carom::dynamics {

enum class BodyType : std::uint8_t { fixed, kinematic, dynamic };  // as CAROM_BODY_*
/// As Colliders::movable has it.
constexpr std::uint8_t how_moved(BodyType type) {
  return type == BodyType::fixed     ? 0
         : type == BodyType::dynamic ? collision::Colliders::kPushed
                                     : collision::Colliders::kDriven;
}
/// Whether a body is swept from pose to pose, @see dynamics/ccd/continuous.h; as CAROM_CONTINUOUS_*.
enum class SweepMode : std::uint8_t { automatic, always, never };
enum class Mix : std::uint32_t { geometric_mean, maximum, minimum, average, multiply, count };

struct Material {
  Real friction = 0.5;
  Real restitution = 0;
  Real rolling = 0, spinning = 0;  // m, resistance; mixed as friction is
  Mix friction_mix = Mix::geometric_mean;
  Mix restitution_mix = Mix::maximum;
};

/// What two materials are to each other where a host said so, and not as they mix.
struct MaterialPair {
  std::uint32_t a = 0, b = 0;  // material slots, a <= b
  Real friction = 0, restitution = 0;
  Real rolling = 0, spinning = 0;  // m
};

/// What a host says about a body (ABI: carom_body_desc), already validated, and what does not change in a step.
struct BodySettings {
  BodyType type = BodyType::dynamic;
  bool has_mass = false, has_center = false, has_inertia = false;
  bool stays_awake = false;  // it, and with it its island, never falls asleep
  SweepMode continuous = SweepMode::automatic;
  Real mass = 0;                                 // kg
  Vec3 center = Vec3::zero();                    // m, body frame
  Mat3 inertia = Mat3::zero();                   // kg m^2, body axes, about center
  Real linear_damping = 0, angular_damping = 0;  // 1/s
  std::uint64_t user = 0;
};

/// What a body is made with.
struct BodyDef : BodySettings {
  bool disabled = false;
  Pose pose;                     // body frame -> world
  Vec3 velocity = Vec3::zero();  // m/s, of the centre of mass
  Vec3 omega = Vec3::zero();     // rad/s, world
};

/// What a host says of a body's mass after it was made.
struct MassGiven {
  Real mass = 0;  // kg; 0: from the densities of its colliders
  bool has_center = false, has_inertia = false;
  Vec3 center = Vec3::zero();   // m, body frame
  Mat3 inertia = Mat3::zero();  // kg m^2, body axes, about center
};

/// How a collider's surface moves though the collider stays: a belt's, a turntable's. What lies on it feels this beside
/// the motion of the body.
struct SurfaceVelocity {
  Vec3 linear = Vec3::zero();   // m/s, axes of the shape
  Vec3 angular = Vec3::zero();  // rad/s, axes of the shape, about its origin
  bool any() const { return linear != Vec3::zero() || angular != Vec3::zero(); }
};

/// What a collider may be made with beyond what it cannot be without.
struct ColliderSettings {
  Filter filter;
  bool sensor = false;
  SurfaceVelocity surface;
};

/// What of a body's motion is held, in world axes: bits as CAROM_LOCK_*.
using Locks = std::uint8_t;
inline constexpr Locks kLinearLocks = 7, kAngularLocks = 56, kAllLocks = 63;

/// Numbers that tell what was made from a scene that it is stale. A step raises them too, where it takes somebody out.
struct Revisions {
  std::uint64_t revision = 1;           // raised by every change a host makes to the scene
  std::uint64_t collider_revision = 1;  // raised when the set of colliders, or who may touch whom, changed
  bool alarm = false;                   // something is disabled or in quarantine: all sleepers are to wake
};

struct Scene : Revisions {
  Scene(std::uint32_t tag, Memory* m)
      : bodies(Kind::body, tag, m),
        collider_slots(Kind::collider, tag, m),
        material_slots(Kind::material, tag, m),
        def(m),
        attributes(m),
        locks(m),
        type(m),
        inv_mass(m),
        mass(m),
        center(m),
        inertia(m),
        inv_inertia(m),
        first_collider(m),
        colliders(m),
        surface(m),
        material(m),
        material_pairs(m),
        apart(m),
        joined(m),
        modes(m),
        fields(tag, m),
        springs(tag, m),
        water(m) {}

  SlotPool bodies, collider_slots, material_slots;

  // by body slot
  Array<BodySettings> def;    // as the host gave it
  BodyAttributes attributes;  // what a host said of it beside that
  Array<Locks> locks;         // the first so many, 0 from there on; as they hold, @see settle_locks()
  Array<BodyType> type;
  Array<Real> inv_mass;                 // 1/kg; 0: static, kinematic, free slot
  Array<Real> mass;                     // kg; 0 where inv_mass is 0
  Array<Vec3> center;                   // m, body frame: centre of mass
  Array<Mat3> inertia;                  // kg m^2, body axes, about center; zero: does not rotate
  Array<Mat3> inv_inertia;              // inverse; zero where it does not rotate
  Array<std::uint32_t> first_collider;  // slot, or kInvalid; the others follow by Colliders::next

  Colliders colliders;             // by collider slot
  Array<SurfaceVelocity> surface;  // likewise, the first so many; the others stand still
  std::uint32_t moving_surfaces = 0;
  bool resists = false;                // some material, or pair of them, resists rolling or spinning
  Array<Material> material;            // by material slot
  Array<MaterialPair> material_pairs;  // by a, then b
  PairCounts apart;                    // of body slots: they do not touch, whatever their filters say
  PairCounts joined;                   // likewise, as joints hold them together

  Vec3 gravity = Vec3(0, -9.81, 0);  // m/s^2
  Vec3 wind = Vec3::zero();          // m/s, world: how the air moves

  EffectModes modes;  // effects that a host forbids or forces
  Fields fields;
  Springs springs;
  Water water;

  Real gravity_factor_of(std::uint32_t body) const { return attributes.number<AttributeId::gravity_factor>(body); }
  Locks locks_of(std::uint32_t body) const { return body < locks.size() ? locks[body] : Locks(0); }
  Locks given_locks_of(std::uint32_t body) const {
    return static_cast<Locks>(attributes.number<AttributeId::locks>(body));
  }
  Drag drag_of(std::uint32_t body) const {
    return {attributes.number<AttributeId::drag>(body, 0), attributes.number<AttributeId::drag>(body, 1)};
  }
  std::uint32_t field_mask_of(std::uint32_t body) const {
    return static_cast<std::uint32_t>(attributes.number<AttributeId::force_field_mask>(body));
  }
  SurfaceVelocity surface_of(std::uint32_t collider) const {
    return collider < surface.size() ? surface[collider] : SurfaceVelocity{};
  }

  Dials dials;
};

}  // namespace carom::dynamics

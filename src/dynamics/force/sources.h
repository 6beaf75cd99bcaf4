// What force effects are made from: air, fields, springs and water, as a host described them, already validated.
#pragma once

#include "core/pool.h"
#include "core/pose.h"

namespace carom::dynamics {

/// What air does to a body that moves through it: F = -(linear + quadratic |u|) u, u its velocity relative to the air.
struct Drag {
  Real linear = 0;     // kg/s
  Real quadratic = 0;  // kg/m: half the density of air times drag coefficient times area
  bool any() const { return linear > 0 || quadratic > 0; }
};

enum class FieldKind : std::uint32_t { uniform, radial, vortex, magnetic, count };  // as CAROM_FORCE_FIELD_*
struct FieldKindRow {
  FieldKind kind;
  const char* name;
  bool pushes;  // it is a force or an acceleration; else another effect reads it
};
inline constexpr FieldKindRow kFieldKinds[] = {
    {FieldKind::uniform, "uniform", true},
    {FieldKind::radial, "radial", true},
    {FieldKind::vortex, "vortex", true},
    {FieldKind::magnetic, "magnetic", false},  // force/magnetism.cpp
};
static_assert(std::size(kFieldKinds) == static_cast<std::size_t>(FieldKind::count));
constexpr bool pushes(FieldKind kind) { return kFieldKinds[static_cast<std::size_t>(kind)].pushes; }

/// A field of acceleration or force.
struct FieldDef {
  FieldKind kind = FieldKind::uniform;
  bool is_force = false;                  // what it says is N, not m/s^2
  Pose pose;                              // field -> world
  Vec3 half = Vec3::constant(kInfinity);  // m, where a uniform field ends, in its frame
  Vec3 vector = Vec3::zero();             // m/s^2 or N, world: a uniform field
  Real strength = 0, pull = 0, lift = 0;  // likewise: outward; of a vortex around, inward and along its y axis
  Real reference = 1;                     // m, where radial and vortex are as strong as that
  Real core = 0;                          // m, within which they no longer grow
  Real reach = kInfinity;                 // m, where they end
  int falloff = 0;                        // they go with (reference / distance)^falloff
  std::uint32_t mask = 1;                 // acts on bodies that share a bit of this
  std::uint64_t user = 0;
};

struct Fields {
  Fields(std::uint32_t tag, Memory* m) : slots(Kind::field, tag, m), def(m) {}
  SlotPool slots;
  Array<FieldDef> def;  // by slot
  /// f(definition) for all that there are.
  template <class F>
  void each(F&& f) const {
    for (std::uint32_t k = 0; k < slots.slots(); ++k)
      if (slots.alive(k)) f(def[k]);
  }
};

/// A spring as a force, between two bodies or one and the world.
struct SpringDef {
  std::uint32_t body_a = kInvalid, body_b = kInvalid;     // slots, or kInvalid
  Vec3 anchor_a = Vec3::zero(), anchor_b = Vec3::zero();  // m, body frame (origin as the host gave it), or world
  Real rest = 0;                                          // m
  Real stiffness = 0, damping = 0;                        // N/m, N s/m
  bool only_pulls = false;
  std::uint64_t user = 0;

  bool hangs_on(std::uint32_t body) const { return body_a == body || body_b == body; }
  /// f(slot, anchor) for its bodies.
  template <class F>
  void each_end(F&& f) const {
    if (body_a != kInvalid) f(body_a, anchor_a);
    if (body_b != kInvalid) f(body_b, anchor_b);
  }
};

/// What a substep can resolve of springs: made anew in each step.
struct SpringLoads {
  explicit SpringLoads(Memory* m) : stiffness(m), damping(m), load(m) {}
  Array<Real> stiffness, damping;  // by slot, N/m, N s/m, @see force/springs.cpp
  struct Load {
    Real stiffness = 0, damping = 0;  // N/m, N s/m, of all of them
  };
  Array<Load> load;            // by body slot, scratch
  std::uint64_t softened = 0;  // of the participants, those of which a substep can't resolve all
};

struct Springs : SpringLoads {
  Springs(std::uint32_t tag, Memory* m) : SpringLoads(m), slots(Kind::spring, tag, m), def(m), ends(m) {}
  SlotPool slots;
  Array<SpringDef> def;       // by slot
  Array<std::uint32_t> ends;  // by body slot: springs that hang on it

  bool hang_on(std::uint32_t body) const { return body < ends.size() && ends[body] > 0; }
  /// f(slot, definition) for all that there are.
  template <class F>
  void each(F&& f) const {
    for (std::uint32_t k = 0; k < slots.slots(); ++k)
      if (slots.alive(k)) f(k, def[k]);
  }
};

/// A plane of water: all of space where normal . x <= level.
struct WaterDef {
  Vec3 normal = Vec3::unit_y();  // unit, world, out of the water
  Real level = 0;                // m
  Real density = 1000;           // kg/m^3
  Vec3 current = Vec3::zero();   // m/s, world
  Real drag = 0;                 // 1/s: what a kg of displaced water takes of a body's velocity
};

/// The surface of a shape that floats, in triangles.
struct Float {
  explicit Float(Memory* m) : corner(m) {}
  const void* shape = nullptr;  // with this surface: address and handle, since an address may come to be another's
  std::uint64_t handle = 0;
  Array<Vec3> corner;  // [3k] m, shape frame, counter-clockwise seen from outside
};

/// What a plan and a step make for buoyancy.
struct Floats {
  explicit Floats(Memory* m) : floats(m), float_of(m) {}
  Array<Float> floats;            // of the shapes that need one
  Array<std::uint32_t> float_of;  // by collider slot: index of the above, or kInvalid
  Real most_rate = kInfinity;     // 1/s, that a substep can resolve
};

struct Water : Floats {
  explicit Water(Memory* m) : Floats(m) {}
  bool on = false;
  WaterDef def;
};

}  // namespace carom::dynamics

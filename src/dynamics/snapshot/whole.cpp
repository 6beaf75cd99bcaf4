#include "dynamics/snapshot/whole.h"

#include <algorithm>
#include <functional>

#include "collision/hull_of.h"
#include "dynamics/mass.h"
#include "dynamics/quarantine.h"
#include "dynamics/snapshot/section.h"
#include "dynamics/snapshot/whole_shapes.h"

namespace carom::dynamics::snapshot {
namespace {

constexpr std::uint8_t kVersion = 1;

bool is_turn(const Quat& q) { return std::fabs(q.squared_norm() - 1) < 1e-6; }
template <class Io>
Pose pose(Io& io, const Pose& now) {
  const Quat q = io.quat(now.q);
  const Vec3 p = io.vec(now.p);
  io.demand(is_turn(q) && sane_position(p));
  return {q, p};
}

// ---- slots ----
template <class W>
auto pools_of(W& w) {
  auto& s = w.scene;
  return std::array{&s.bodies,          &s.collider_slots, &s.material_slots, &w.joints.slots,
                    &w.particles.slots, &s.fields.slots,   &s.springs.slots};
}

/// Space in every array for the slots that there are now; whoever is alive is filled in later.
void reserve_all_slots(World& w) {
  Scene& s = w.scene;
  State& t = w.state;
  const std::size_t bodies = s.bodies.slots(), colliders = s.collider_slots.slots();
  BodyDef empty;
  empty.type = BodyType::fixed;
  s.def.resize(bodies, empty), s.type.resize(bodies, BodyType::fixed);
  s.inv_mass.resize(bodies, 0), s.mass.resize(bodies, 0), s.center.resize(bodies, Vec3::zero());
  s.inertia.resize(bodies, Mat3::zero()), s.inv_inertia.resize(bodies, Mat3::zero());
  s.first_collider.resize(bodies, kInvalid);
  for (Array<Vec3>* a : {&t.x, &t.placed_x, &t.v, &t.omega, &t.momentum, &t.force, &t.torque})
    a->resize(bodies, Vec3::zero());
  for (Array<Quat>* a : {&t.q, &t.held_q, &t.placed_q}) a->resize(bodies, Quat::identity());
  for (Array<std::uint8_t>* a : {&t.held_out, &t.loaded_steps, &t.cooldown_steps, &t.is_written}) a->resize(bodies, 0);
  t.accuracy.resize(bodies);
  t.written.reserve(bodies);
  Colliders& c = s.colliders;
  c.shape.resize(colliders, nullptr), c.local.resize(colliders), c.body.resize(colliders, 0);
  c.material.resize(colliders, Colliders::kNoMaterial), c.density.resize(colliders, 0), c.frame.resize(colliders);
  c.travel.resize(colliders, 0), c.bounds.resize(colliders), c.reach.resize(colliders, 0);
  c.movable.resize(colliders, 0), c.disabled.resize(colliders, 0), c.next.resize(colliders, kInvalid);
  c.live.reserve(colliders);
  s.material.resize(s.material_slots.slots());
  s.fields.def.resize(s.fields.slots.slots());
  const std::size_t springs = s.springs.slots.slots(), joints = w.joints.slots.slots();
  s.springs.def.resize(springs), s.springs.stiffness.resize(springs, 0), s.springs.damping.resize(springs, 0);
  if (springs > 0) s.springs.ends.resize(bodies, 0), s.springs.load.resize(bodies);
  w.joints.joint.resize(joints);
  if (joints > 0) w.joints.first.resize(bodies, kInvalid);
  w.particles.set.reserve(w.particles.slots.slots());
  for (std::uint32_t k = 0; k < w.particles.slots.slots(); ++k) w.particles.set.emplace_back(w.memory);
}

struct Slots {
  template <class Io, class W>
  static void go(Io& io, W& world, auto&&) {
    io.demand(io.value(kVersion) == kVersion);
    for (auto* pool : pools_of(world)) {
      if constexpr (Io::checks) {
        Array<std::uint32_t> generations(world.memory), free(world.memory);
        list(io, generations), list(io, free);
        if (!io.bad()) io.demand(pool->adopt(generations, free));
      } else {
        list(io, pool->generations()), list(io, pool->free_slots());
      }
    }
    if constexpr (Io::checks)
      if (!io.bad()) reserve_all_slots(world);
  }
};

/// f(slot) for those that live.
template <class F>
void each_alive(const SlotPool& pool, F&& f) {
  for (std::uint32_t i = 0; i < pool.slots(); ++i)
    if (pool.alive(i)) f(i);
}

// ---- bodies ----
enum WholeBodyBits : std::uint8_t {
  kType = 3,
  kMass = 4,
  kCenter = 8,
  kInertia = 16,
  kStaysAwake = 32,
  kDamping = 64,
  kUser = 128
};

template <class Io>
void describe(Io& io, BodyDef& d) {
  const auto bit = [](bool on, WholeBodyBits b) { return on ? unsigned(b) : 0u; };
  const bool damped = !same_bits(d.linear_damping, Real(0)) || !same_bits(d.angular_damping, Real(0));
  const unsigned bits = io.value(static_cast<std::uint8_t>(static_cast<unsigned>(d.type) | bit(d.has_mass, kMass) |
                                                           bit(d.has_center, kCenter) | bit(d.has_inertia, kInertia) |
                                                           bit(d.stays_awake, kStaysAwake) | bit(damped, kDamping) |
                                                           bit(d.user != 0, kUser)));
  io.demand((bits & kType) <= static_cast<unsigned>(BodyType::dynamic));
  io.demand((bits & kType) == static_cast<unsigned>(BodyType::dynamic) || !(bits & (kMass | kCenter | kInertia)));
  if (io.bad()) return;
  d.type = static_cast<BodyType>(bits & kType), d.stays_awake = bits & kStaysAwake;
  d.has_mass = bits & kMass, d.has_center = bits & kCenter, d.has_inertia = bits & kInertia;
  if (d.has_mass) d.mass = io.real(d.mass);
  if (d.has_center) d.center = io.vec(d.center);
  if (d.has_inertia) d.inertia = io.mat(d.inertia);
  if (bits & kDamping) d.linear_damping = io.real(d.linear_damping), d.angular_damping = io.real(d.angular_damping);
  if (bits & kUser) d.user = io.value(d.user);
  io.demand((!d.has_mass || d.mass >= kLeastMass) && (d.has_mass || !(d.has_center || d.has_inertia)));
  io.demand(sane_position(d.center) && d.linear_damping >= 0 && d.angular_damping >= 0);
  io.demand(d.inertia == Mat3(d.inertia.transpose()));
}

struct WholeBodies {
  template <class Io, class W>
  static void go(Io& io, W& world, auto&&) {
    each_alive(world.scene.bodies, [&](std::uint32_t i) {
      if (io.bad()) return;
      BodyDef def;
      if constexpr (Io::saves) static_cast<BodySettings&>(def) = world.scene.def[i];
      describe(io, def);
      if constexpr (Io::checks)
        if (!io.bad()) world.fill_body(i, def);
    });
  }
};

// ---- colliders ----
enum WholeColliderBits : std::uint8_t { kMaterial = 1, kLocal = 2, kBits = 3 };

struct Wearers {
  static bool fits(const Scene& s, std::uint32_t body, const Shape& shape) {
    if (shape.form == Form::half_space) return s.type[body] == BodyType::fixed;
    return !is_scenery(shape) || s.type[body] != BodyType::dynamic;
  }

  /// @param more  when saving, f(shape): its number; else the builder
  template <class Io, class W, class More>
  static void go(Io& io, W& world, More&& more) {
    auto& s = world.scene;
    auto& c = s.colliders;
    each_alive(s.collider_slots, [&](std::uint32_t i) {
      if (io.bad()) return;
      std::uint32_t shape = 0;
      Pose local;
      unsigned bits = 0;
      if constexpr (Io::saves) {
        const bool there = zero_bits(c.local[i].p) && same_bits(c.local[i].q, Quat::identity());
        bits = (c.material[i] == Colliders::kNoMaterial ? 0u : +kMaterial) | (there ? 0u : +kLocal);
        shape = more(c.shape[i]), local = c.local[i];
      }
      bits = io.value(static_cast<std::uint8_t>(bits));
      const std::uint32_t body = io.value(Io::saves ? c.body[i] : 0u);
      shape = io.value(shape);
      const Real density = io.real(Io::saves ? c.density[i] : 0);
      const std::uint32_t material =
          bits & kMaterial ? io.value(Io::saves ? c.material[i] : 0u) : Colliders::kNoMaterial;
      if (bits & kLocal) local = pose(io, local);
      io.demand(bits <= kBits && density >= 0 && s.bodies.alive(body));
      io.demand(material == Colliders::kNoMaterial || s.material_slots.alive(material));
      if constexpr (Io::checks) {
        io.demand(shape < more.shape.size());
        if (!io.bad()) io.demand(fits(s, body, *more.shape[shape]));
        if (io.bad()) return;
        world.fill_collider(i, body, more.shape[shape], local, density, material);
        c.local[i] = local;  // no further from unit length, nor nearer, than it was
      }
    });
    if constexpr (Io::checks) {
      if (io.bad()) return;
      each_alive(s.bodies, [&](std::uint32_t i) {
        world.settle_mass(i);
        io.demand(finite(s.mass[i]) && finite(s.inv_mass[i]) && s.center[i].all_finite() && s.inertia[i].all_finite() &&
                  s.inv_inertia[i].all_finite());
      });
    }
  }
};

// ---- joints, springs, fields ----
/// Not NaN: may be infinite.
template <class Io>
Real loose_end(Io& io, Real now) {
  const Real x = io.value(now);
  io.demand(x >= 0);
  return x;
}

/// Two bodies, or one and the world, of which one can be moved.
template <class Io, class Def>
void ends(Io& io, const Scene& s, Def& d) {
  d.body_a = io.value(d.body_a), d.body_b = io.value(d.body_b);
  if constexpr (Io::checks) {
    bool any = false;
    for (const std::uint32_t body : {d.body_a, d.body_b}) {
      io.demand(body == kInvalid || s.bodies.alive(body));
      any |= s.bodies.alive(body) && s.type[body] == BodyType::dynamic;
    }
    io.demand(any && d.body_a != d.body_b);
  }
}

struct WholeJoints {
  template <class Io, class W>
  static void go(Io& io, W& world, auto&&) {
    auto& all = world.joints;
    if constexpr (Io::checks) world.scene.joined.reserve(all.slots.alive_count());
    each_alive(all.slots, [&](std::uint32_t i) {
      if (io.bad()) return;
      JointDef d = Io::saves ? all.joint[i].def : JointDef();
      describe(io, world.scene, d);
      Coupling coupling = Io::saves && all.joint[i].coupling ? all.coupling_of(all.joint[i]) : Coupling();
      if (is_coupling(d.kind)) {
        coupling.follower = io.value(coupling.follower), coupling.leader = io.value(coupling.leader);
        io.demand(coupling.follower != coupling.leader);
      }
      const std::uint32_t next_a = io.value(all.joint[i].next_a), next_b = io.value(all.joint[i].next_b);
      if constexpr (Io::checks) {
        if (io.bad()) return;
        world.fill_joint(i, d);
        all.joint[i].def = d;  // frames as they were, to the bit
        if (is_coupling(d.kind)) world.fill_coupling(i, coupling);
        all.joint[i].next_a = next_a, all.joint[i].next_b = next_b;
      }
    });
    // Where the lists of bodies begin: their order is that in which joints came.
    if (all.slots.alive_count() > 0)
      each_alive(world.scene.bodies, [&](std::uint32_t body) {
        const std::uint32_t first = io.value(body < all.first.size() ? all.first[body] : kInvalid);
        if constexpr (Io::checks) all.first[body] = first;
      });
    if constexpr (Io::checks) {
      if (!io.bad()) check_couplings(io, world);
      if (!io.bad()) check_lists(io, world);
    }
  }

 private:
  /// Each couples two joints of one motion, and hangs on their bodies.
  static void check_couplings(Checker& io, const World& world) {
    const Joints& all = world.joints;
    for (const Coupling& c : all.couplings) {
      for (const std::uint32_t j : {c.follower, c.leader}) {
        if (!all.alive(j)) return io.demand(false);
        io.demand(all.joint[j].def.kind == JointKind::hinge || all.joint[j].def.kind == JointKind::slider);
      }
      const auto is_of = [&](std::uint32_t body, std::uint32_t j) {
        return body == kInvalid || body == all.joint[j].def.body_a || body == all.joint[j].def.body_b;
      };
      const JointDef& own = all.joint[c.owner].def;
      io.demand(is_of(own.body_a, c.follower) && is_of(own.body_b, c.leader) && own.collide);
    }
  }
  template <class Io>
  static void describe(Io& io, const Scene& scene, JointDef& d) {
    constexpr unsigned kMeasured = 128;
    const unsigned given = io.value(static_cast<std::uint8_t>((static_cast<unsigned>(d.kind) << 1) | d.collide |
                                                              (d.measured ? kMeasured : 0u))),
                   bits = given & ~kMeasured;
    io.demand(bits >> 1 < static_cast<unsigned>(JointKind::count));
    if (io.bad()) return;
    d.kind = static_cast<JointKind>(bits >> 1), d.collide = bits & 1, d.measured = given & kMeasured;
    ends(io, scene, d);
    d.frame_a = pose(io, d.frame_a), d.frame_b = pose(io, d.frame_b);
    d.length = io.real(d.length);
    d.break_force = loose_end(io, d.break_force), d.break_torque = loose_end(io, d.break_torque);
    d.user = io.value(d.user);
    io.demand(d.length >= 0);
  }

  /// Each end of each joint stands in the list of its body, once. So no list runs in a circle.
  static void check_lists(Checker& io, const World& world) {
    const Joints& all = world.joints;
    std::size_t wanted = 0, met = 0;
    each_alive(all.slots, [&](std::uint32_t i) {
      const JointDef& d = all.joint[i].def;
      wanted += (d.body_a != kInvalid) + (d.body_b != kInvalid);
    });
    for (std::uint32_t body = 0; body < all.first.size(); ++body)
      for (std::uint32_t j = all.first[body]; j != kInvalid;) {
        if (++met > wanted || !all.alive(j)) return io.demand(false);
        const JointDef& d = all.joint[j].def;
        if (d.body_a != body && d.body_b != body) return io.demand(false);
        j = d.body_a == body ? all.joint[j].next_a : all.joint[j].next_b;
      }
    io.demand(met == wanted);
  }
};

struct WholeSprings {
  template <class Io, class W>
  static void go(Io& io, W& world, auto&&) {
    auto& all = world.scene.springs;
    each_alive(all.slots, [&](std::uint32_t i) {
      if (io.bad()) return;
      SpringDef d = all.def[i];
      ends(io, world.scene, d);
      d.anchor_a = io.vec(d.anchor_a), d.anchor_b = io.vec(d.anchor_b);
      d.only_pulls = yes_or_no(io, d.only_pulls), d.user = io.value(d.user);
      io.demand(sane_position(d.anchor_a) && sane_position(d.anchor_b));
      if constexpr (Io::checks)
        if (!io.bad()) world.fill_spring(i, d);
    });
  }
};

struct WholeFields {
  template <class Io, class W>
  static void go(Io& io, W& world, auto&&) {
    auto& all = world.scene.fields;
    each_alive(all.slots, [&](std::uint32_t i) {
      const std::uint64_t user = io.value(all.def[i].user);
      if constexpr (Io::checks) all.def[i].user = user;
    });
  }
};

enum Number : std::size_t { kSlots, kShapes, kBodiesMade, kCollidersMade, kJointsMade, kSpringsMade, kFieldsMade };

}  // namespace

constinit const WholeSection kWhole[kWholeSections] = {
    {tag_of("wSLO"), "slots"},          {tag_of("wSHA"), "shapes"},      {tag_of("wBOD"), "bodies made"},
    {tag_of("wCOL"), "colliders made"}, {tag_of("wJOI"), "joints made"}, {tag_of("wSPR"), "springs made"},
    {tag_of("wFIE"), "fields made"}};

void save_whole(std::size_t section, Saver& io, const World& world, const ShapeNames& names) {
  const int nothing = 0;
  switch (section) {
    case kSlots:
      return Slots::go(io, world, nothing);
    case kShapes: {
      const Array<const Shape*> shapes = shapes_of(world, world.memory);
      io.value(static_cast<std::uint64_t>(shapes.size()));
      for (std::size_t k = 0; k < shapes.size(); ++k) save_shape(io, *shapes[k], {shapes.data(), k}, names);
      return;
    }
    case kBodiesMade:
      return WholeBodies::go(io, world, nothing);
    case kCollidersMade: {
      struct Known {
        const Shape* shape;
        std::uint32_t number;
      };
      Array<Known> known(world.memory);
      const Array<const Shape*> shapes = shapes_of(world, world.memory);
      for (const Shape* shape : shapes) known.push_back({shape, static_cast<std::uint32_t>(known.size())});
      std::ranges::sort(known, std::less<>(), &Known::shape);
      return Wearers::go(io, world, [&](const Shape* shape) {
        return std::ranges::lower_bound(known, shape, std::less<>(), &Known::shape)->number;
      });
    }
    case kJointsMade:
      return WholeJoints::go(io, world, nothing);
    case kSpringsMade:
      return WholeSprings::go(io, world, nothing);
    default:
      return WholeFields::go(io, world, nothing);
  }
}

bool build_whole(std::size_t section, Checker& io, Builder& b) {
  const int nothing = 0;
  switch (section) {
    case kSlots:
      Slots::go(io, b.world, nothing);
      break;
    case kShapes:
      for (std::uint64_t n = io.count(0, 1); n > 0 && !io.bad(); --n) build_shape(io, b);
      break;
    case kBodiesMade:
      WholeBodies::go(io, b.world, nothing);
      break;
    case kCollidersMade:
      Wearers::go(io, b.world, b);
      break;
    case kJointsMade:
      WholeJoints::go(io, b.world, nothing);
      break;
    case kSpringsMade:
      WholeSprings::go(io, b.world, nothing);
      break;
    default:
      WholeFields::go(io, b.world, nothing);
  }
  return !io.bad();
}

}  // namespace carom::dynamics::snapshot

namespace carom::dynamics {

Array<const Shape*> shapes_of(const World& world, Memory* memory) {
  Array<const Shape*> met(memory), in_order(memory);
  const auto meet = [&](const auto& self, const Shape* shape) -> void {
    const auto find = [&] { return std::lower_bound(met.begin(), met.end(), shape, std::less<>()); };
    if (const auto at = find(); at != met.end() && *at == shape) return;
    if (shape->hull_of)
      for (const HullOf::Part& part : shape->hull_of->parts) self(self, part.shape);
    met.insert(find(), shape);
    in_order.push_back(shape);
  };
  const Colliders& c = world.scene.colliders;
  for (const std::uint32_t slot : c.live) meet(meet, c.shape[slot]);
  return in_order;
}

bool is_untouched(const World& world) {
  return std::ranges::all_of(snapshot::pools_of(world), [](const SlotPool* pool) { return pool->slots() == 0; });
}

}  // namespace carom::dynamics

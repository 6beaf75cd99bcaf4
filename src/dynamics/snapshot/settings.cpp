// What a host sets of a world and of what is in it, and joints: their impulses, and what drives them.
#include <algorithm>
#include <cmath>

#include "dynamics/joint/turns.h"
#include "dynamics/quarantine.h"
#include "dynamics/snapshot/joint_axes.h"
#include "dynamics/snapshot/section.h"

namespace carom::dynamics::snapshot {
namespace {

struct DialsAndGravity {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& s = world.scene;
    const std::uint64_t n = io.count(kDialCount, sizeof(Real));
    if constexpr (Io::loads) s.dials = Dials();
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
      const bool known = k < kDialCount;  // else of a newer library
      const Real value = io.real(known ? s.dials.value[k] : 0);
      if (!known) continue;
      const DialRow& row = dial_table()[k];
      io.demand(value >= row.min && value <= row.max && (row.kind == DialRow::number || value == std::floor(value)));
      if constexpr (Io::loads) s.dials.value[k] = value;
    }
    const Vec3 gravity = io.vec(s.gravity), wind = io.vec(s.wind);
    keep(io, s.gravity, gravity), keep(io, s.wind, wind);
    auto& m = s.modes;
    const RowBits forbidden = io.value(m.forbidden), forced = io.value(m.forced), any = io.value(m.forbidden_anywhere);
    io.demand(((forbidden | forced | any) >> kEffectCount) == 0 && !(forbidden & forced) && !(forbidden & ~any));
    keep(io, m.forbidden, forbidden), keep(io, m.forced, forced), keep(io, m.forbidden_anywhere, any);
  }
};

struct Waters {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& w = world.scene.water;
    const bool on = yes_or_no(io, w.on);
    keep(io, w.on, on);
    if (!on) return;
    const Vec3 normal = io.vec(w.def.normal), current = io.vec(w.def.current);
    const Real level = io.real(w.def.level), density = io.real(w.def.density), drag = io.real(w.def.drag);
    io.demand(std::fabs(normal.squared_norm() - 1) < 1e-3 && density >= 0 && drag >= 0);
    keep(io, w.def, WaterDef{normal, level, density, current, drag});
  }
};

struct Materials {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& s = world.scene;
    if constexpr (Io::loads) s.resists = false;
    for (std::uint32_t i = 0; i < s.material_slots.slots() && !io.bad(); ++i) {
      if (!s.material_slots.alive(i)) continue;
      io.begin_item();
      io.name_item(Item::material, i);
      const Material& now = s.material[i];
      Material m;
      m.friction = io.real(now.friction), m.restitution = io.real(now.restitution);
      m.rolling = io.real(now.rolling), m.spinning = io.real(now.spinning);
      const auto mix = [&](Mix of) {
        const auto v = io.value(static_cast<std::uint8_t>(of));
        io.demand(v < static_cast<std::uint8_t>(Mix::count));
        return static_cast<Mix>(v);
      };
      m.friction_mix = mix(now.friction_mix), m.restitution_mix = mix(now.restitution_mix);
      io.demand(m.friction >= 0 && m.restitution >= 0 && m.restitution <= 1 && m.rolling >= 0 && m.spinning >= 0);
      if constexpr (Io::loads) s.material[i] = m, s.resists |= m.rolling > 0 || m.spinning > 0;
    }
  }
};

/// Not NaN: some of these may be infinite.
template <class Io>
Real loose(Io& io, Real now) {
  const Real x = io.value(now);
  io.demand(x == x);
  return x;
}

struct AllFields {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& all = world.scene.fields;
    for (std::uint32_t i = 0; i < all.slots.slots() && !io.bad(); ++i)
      if (all.slots.alive(i)) io.begin_item(), io.name_item(Item::field, i), field(io, all.def[i]);
  }

 private:
  template <class Io, class F>
  static void field(Io& io, F& now) {
    FieldDef f;
    const auto kind = io.value(static_cast<std::uint8_t>(now.kind));
    io.demand(kind < static_cast<std::uint8_t>(FieldKind::count));
    f.kind = static_cast<FieldKind>(kind);
    f.is_force = yes_or_no(io, now.is_force);
    f.pose.q = io.quat(now.pose.q), f.pose.p = io.vec(now.pose.p);
    for (int k = 0; k < 3; ++k) f.half[k] = loose(io, now.half[k]);
    f.vector = io.vec(now.vector);
    f.strength = io.real(now.strength), f.pull = io.real(now.pull), f.lift = io.real(now.lift);
    f.reference = io.real(now.reference), f.core = io.real(now.core), f.reach = loose(io, now.reach);
    f.falloff = io.value(now.falloff), f.mask = io.value(now.mask), f.user = now.user;
    const Real n2 = f.pose.q.squared_norm();
    io.demand(n2 > 0.9 && n2 < 1.1 && f.half.min_entry() >= 0 && f.reference > 0 && f.core >= 0 && f.reach >= 0 &&
              f.falloff >= -8 && f.falloff <= 8);
    keep(io, now, f);
  }
};

struct AllSprings {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& all = world.scene.springs;
    for (std::uint32_t i = 0; i < all.slots.slots() && !io.bad(); ++i) {
      if (!all.slots.alive(i)) continue;
      io.begin_item();
      io.name_item(Item::spring, i);
      auto& def = all.def[i];
      const Real rest = io.real(def.rest), stiffness = io.real(def.stiffness), damping = io.real(def.damping);
      io.demand(rest >= 0 && stiffness >= 0 && damping >= 0);
      keep(io, def.rest, rest), keep(io, def.stiffness, stiffness), keep(io, def.damping, damping);
    }
  }
};

// ---- joints ----
enum JointBits : std::uint8_t {
  kBroken = 1,
  kWithoutLimits = 2,
  kWithoutMotors = 4,
  kActed = 8,        // it has impulses
  kFirstDrive = 16,  // a bit for each coordinate whose drive is not as it was made
  kOwnAxis = 32,     // of hinges and sliders, which have no swing: their axis has properties
  kTurnDrive = 128   // of kinds that turn any way, which have no distance: so is their drive to an orientation
};
static_assert(kOwnAxis == kFirstDrive << static_cast<unsigned>(Coordinate::swing));
static_assert(kCoordinates <= 4 && kTurnDrive == kFirstDrive << static_cast<unsigned>(Coordinate::distance));

bool may_have_axis(JointKind kind) { return kind == JointKind::hinge || kind == JointKind::slider; }
bool turns_any_way(JointKind kind) { return kind == JointKind::ball || kind == JointKind::six_axis; }

bool same_drive(const JointDrive& a, const JointDrive& b) {
  return a.limit.on == b.limit.on && same_bits(a.limit.lower, b.limit.lower) &&
         same_bits(a.limit.upper, b.limit.upper) && a.motor.on == b.motor.on &&
         same_bits(a.motor.speed, b.motor.speed) && same_bits(a.motor.max_force, b.motor.max_force) &&
         a.spring.on == b.spring.on && same_bits(a.spring.target, b.spring.target) &&
         same_bits(a.spring.frequency, b.spring.frequency) && same_bits(a.spring.damping, b.spring.damping) &&
         same_bits(a.spring.max_force, b.spring.max_force);
}

std::uint8_t bits_of(const Joint& j) {
  bool acted = !same_bits(j.p_h, Real(0)) || !zero_bits(j.force) || !zero_bits(j.torque);
  for (const Real p : j.p) acted |= !same_bits(p, Real(0));
  for (const Real p : j.drive_p) acted |= !same_bits(p, Real(0));
  const auto bit = [](bool on, JointBits b) { return on ? unsigned(b) : 0u; };
  unsigned bits = bit(j.broken, kBroken) | bit(j.without_limits, kWithoutLimits) |
                  bit(j.without_motors, kWithoutMotors) | bit(acted, kActed);
  for (std::size_t k = 0; k < kCoordinates; ++k)
    if (!same_drive(j.drive[k], JointDrive{})) bits |= unsigned(kFirstDrive) << k;
  if (may_have_axis(j.def.kind) && j.axes) bits |= kOwnAxis;
  if (turns_any_way(j.def.kind) && !same_turn_drive(j.turn, TurnDrive{})) bits |= kTurnDrive;
  return static_cast<std::uint8_t>(bits);
}

template <class Io>
JointDrive drive(Io& io, const JointDrive& now) {
  JointDrive d;
  const unsigned on =
      io.value(static_cast<std::uint8_t>((now.limit.on ? 1 : 0) | (now.motor.on ? 2 : 0) | (now.spring.on ? 4 : 0)));
  io.demand(on < 8);
  d.limit.on = on & 1, d.motor.on = on & 2, d.spring.on = on & 4;
  d.limit.lower = loose(io, now.limit.lower), d.limit.upper = loose(io, now.limit.upper);
  d.motor.speed = io.real(now.motor.speed), d.motor.max_force = loose(io, now.motor.max_force);
  d.spring.target = io.real(now.spring.target), d.spring.frequency = io.real(now.spring.frequency);
  d.spring.damping = io.real(now.spring.damping), d.spring.max_force = loose(io, now.spring.max_force);
  io.demand(d.limit.lower <= d.limit.upper && d.motor.max_force >= 0 && d.spring.frequency >= 0 &&
            d.spring.damping >= 0 && d.spring.max_force >= 0);
  return d;
}

bool parts_its_bodies(const JointDef& def) { return !def.collide && def.body_a != kInvalid && def.body_b != kInvalid; }

struct AllJoints {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& all = world.joints;
    for (std::uint32_t i = 0; i < all.slots.slots() && !io.bad(); ++i)
      if (all.slots.alive(i)) io.begin_item(), io.name_item(Item::joint, i), joint(io, world, all.joint[i]);
  }

 private:
  template <class Io, class W, class J>
  static void joint(Io& io, [[maybe_unused]] W& world, J& j) {
    const auto bits = io.value(Io::saves ? bits_of(j) : std::uint8_t(0));
    const bool broken = bits & kBroken;
    if constexpr (Io::checks) io.needs.unbroken += j.broken && !broken;
    if constexpr (Io::loads) {
      PairCounts& joined = world.scene.joined;
      if (parts_its_bodies(j.def) && j.broken != broken)
        broken ? joined.remove(j.def.body_a, j.def.body_b) : joined.add(j.def.body_a, j.def.body_b);
      j.broken = broken, j.without_limits = bits & kWithoutLimits, j.without_motors = bits & kWithoutMotors;
      j.p.fill(0), j.drive_p.fill(0), j.p_h = 0, j.force = j.torque = Vec3::zero();
    }
    if (bits & kActed) {
      for (auto& p : j.p) {
        const Real v = io.real(p);
        keep(io, p, v);
      }
      for (auto& p : j.drive_p) {
        const Real v = io.real(p);
        keep(io, p, v);
      }
      const Real h = io.real(j.p_h);
      const Vec3 force = io.vec(j.force), torque = io.vec(j.torque);
      io.demand(h >= 0);
      keep(io, j.p_h, h), keep(io, j.force, force), keep(io, j.torque, torque);
    }
    if (j.def.measured)
      for (auto& rate : j.acceleration) {
        const Real v = io.real(rate);
        keep(io, rate, v);
      }
    if (has_transmission(j.def.kind)) transmission(io, j.transmission);
    if (is_coupling(j.def.kind))
      for (auto& factor : world.joints.couplings[j.coupling - 1].polynomial) {
        const Real v = io.real(factor);
        keep(io, factor, v);
      }
    const bool own_axis = may_have_axis(j.def.kind) && bits & kOwnAxis;
    if constexpr (Io::checks) io.needs.axes += own_axis && !j.axes;
    if constexpr (Io::loads)
      if (may_have_axis(j.def.kind))
        world.keep_axes(static_cast<std::uint32_t>(&j - world.joints.joint.data()), own_axis);
    if (own_axis || j.def.kind == JointKind::six_axis) {
      if (j.axes) {
        all_axes(io, world.joints.axes[j.axes - 1]);
      } else if constexpr (!Io::saves) {
        JointAxes none;
        all_axes(io, none);
      }
    }
    const bool turns = turns_any_way(j.def.kind);
    if constexpr (Io::loads) j.turn = TurnDrive{};
    if (turns && bits & kTurnDrive) turn_drive(io, j.turn);
    for (std::size_t k = 0; k < (turns ? kCoordinates - 1 : kCoordinates); ++k) {
      const bool given = (own_axis ? bits & ~unsigned(kOwnAxis) : bits) & unsigned(kFirstDrive) << k;
      const JointDrive d = given ? drive(io, j.drive[k]) : JointDrive{};
      keep(io, j.drive[k], d);
    }
  }

  template <class Io, class T>
  static void transmission(Io& io, T& now) {
    const Vec3 anchor_a = io.vec(now.anchor_a), anchor_b = io.vec(now.anchor_b);
    const Real ratio = io.real(now.ratio), length = io.real(now.length), phase = io.real(now.phase);
    io.demand(sane_position(anchor_a) && sane_position(anchor_b) && length >= 0);
    keep(io, now.anchor_a, anchor_a), keep(io, now.anchor_b, anchor_b);
    keep(io, now.ratio, ratio), keep(io, now.length, length), keep(io, now.phase, phase);
  }
};

/// Turns that joints have counted. A joint whose angles are what its pose tells says so by a zero.
struct Turns {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& all = world.joints;
    for (std::uint32_t i = 0; i < all.slots.slots() && !io.bad(); ++i) {
      if (!all.slots.alive(i) || !counts_turns(all.joint[i].def.kind)) continue;
      io.begin_item(), io.name_item(Item::joint, i);
      auto& j = all.joint[i];
      bool counted = false;
      if constexpr (Io::saves) counted = !(j.turned == told_angles(world, j));
      if (!yes_or_no(io, counted)) {
        if constexpr (Io::loads) start_count(world, j);
        continue;
      }
      const Vec3 turned = io.vec(j.turned);
      io.demand(turned.squared_norm() <= kMostCounted * kMostCounted);
      keep(io, j.turned, turned);
    }
  }
};

struct HeldApart {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& apart = world.scene.apart;
    const std::uint64_t n = io.count(apart.size(), 12);
    if constexpr (Io::checks) io.needs.apart = n;
    if constexpr (Io::loads) apart.clear();
    std::size_t at = 0;
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
      PairCounts::Entry entry;
      if constexpr (Io::saves) entry = apart.next(at);
      const std::uint64_t key = io.value(entry.key);
      const std::uint32_t count = io.value(entry.count);
      if constexpr (Io::checks) {
        const auto a = static_cast<std::uint32_t>(key >> 32), b = static_cast<std::uint32_t>(key);
        const SlotPool& bodies = world.scene.bodies;
        io.demand(a < b && bodies.alive(a) && bodies.alive(b) && count > 0);
      }
      if constexpr (Io::loads) apart.put(key, count);
    }
  }
};

struct MaterialPairs {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& s = world.scene;
    const std::uint64_t n = io.count(s.material_pairs.size(), 8 + 4 * sizeof(Real));
    if constexpr (Io::checks) io.needs.material_pairs = n;
    if constexpr (Io::loads) s.material_pairs.clear();
    MaterialPair before;
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
      MaterialPair now;
      if constexpr (Io::saves) now = s.material_pairs[k];
      MaterialPair pair;
      pair.a = io.value(now.a), pair.b = io.value(now.b);
      pair.friction = io.real(now.friction), pair.restitution = io.real(now.restitution);
      pair.rolling = io.real(now.rolling), pair.spinning = io.real(now.spinning);
      io.demand(pair.a <= pair.b && (k == 0 || before.a < pair.a || (before.a == pair.a && before.b < pair.b)) &&
                pair.friction >= 0 && pair.restitution >= 0 && pair.restitution <= 1 && pair.rolling >= 0 &&
                pair.spinning >= 0);
      if constexpr (Io::checks) io.demand(s.material_slots.alive(pair.a) && s.material_slots.alive(pair.b));
      if constexpr (Io::loads) s.material_pairs.push_back(pair), s.resists |= pair.rolling > 0 || pair.spinning > 0;
      before = pair;
    }
  }
};

}  // namespace

constinit const Section kDials = section<DialsAndGravity>("DIAL", "dials");
constinit const Section kWater = section<Waters>("WATR", "water");
constinit const Section kMaterials = section<Materials>("MATE", "materials");
constinit const Section kMaterialPairs = section<MaterialPairs>("MAPA", "pairs of materials");
constinit const Section kFields = section<AllFields>("FIEL", "force fields");
constinit const Section kSprings = section<AllSprings>("SPRI", "springs");
constinit const Section kJoints = section<AllJoints>("JOIN", "joints");
constinit const Section kTurns = section<Turns>("TURN", "turns of joints");
constinit const Section kApart = section<HeldApart>("APAR", "pairs held apart");

}  // namespace carom::dynamics::snapshot

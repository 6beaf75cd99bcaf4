// Bodies and colliders: what a step changes of them, and what a host can set of them.
#include <algorithm>

#include "dynamics/accuracy/control.h"
#include "dynamics/events/events.h"
#include "dynamics/force/force.h"
#include "dynamics/quarantine.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/snapshot/section.h"

namespace carom::dynamics::snapshot {
namespace {

// Of a body: which of the things that are mostly as one would guess are not.
enum BodyBits : std::uint16_t {
  kMoves = 1,  // it has velocities
  kTop = 2,    // a momentum
  kHeld = 4,   // held_q is not q
  kPlacedElsewhere = 8,
  kPushed = 16,
  kSolverMemory = 32,
  kQuarantined = 64,
  kWritten = 128,
  kAsleep = 256,
  kInactive = 512,
  kRests = 1024,
  kSleptBefore = 2048,
  kSettings = 4096,
  kAccuracy = 8192,
  kDisabled = 16384,
  kBodyBits = 32767
};
// Of its settings, those that are not as they usually are: a bit each. Seven to a byte, the eighth says that a byte follows.
// Attributes came in between: 0 to 3 are those of the first version, 4 and 5 the two here, all others come after them.
constexpr unsigned kModes = 4, kContinuous = 5;
constexpr unsigned bit_of(AttributeId id) { return static_cast<unsigned>(+id < 4 ? +id : +id + 2); }
constexpr unsigned kSettingBits = 6 + (kAttributeCount > 4 ? kAttributeCount - 4 : 0);
static_assert(kSettingBits <= 14, "two bytes");

RowBits bits_of(const Array<RowBits>& of, std::uint32_t i) { return i < of.size() ? of[i] : 0; }

bool same_value(const AttributeValue& a, const AttributeValue& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

std::uint16_t settings_of(const Scene& s, std::uint32_t i) {
  unsigned bits = 0;
  for (const AttributeRow& row : kAttributeTable)
    if (i < s.attributes.bodies(row.id) && !same_value(s.attributes.of(row.id, i), row.usual))
      bits |= 1u << bit_of(row.id);
  if (bits_of(s.modes.forbidden_of, i) || bits_of(s.modes.forced_of, i)) bits |= 1u << kModes;
  if (s.def[i].continuous != SweepMode::automatic) bits |= 1u << kContinuous;
  return static_cast<std::uint16_t>(bits);
}

template <class Io>
unsigned setting_bits(Io& io, std::uint16_t now) {
  const auto first = io.value(static_cast<std::uint8_t>((now & 127) | (now >> 7 ? 128 : 0)));
  unsigned bits = first & 127;
  if (first & 128) bits |= unsigned(io.value(static_cast<std::uint8_t>(now >> 7))) << 7;
  io.demand(bits >> kSettingBits == 0);
  return bits;
}

template <class Io>
Real number(Io& io, StoredAs as, Real now) {
  switch (as) {
    case StoredAs::real:
      return io.real(now);
    case StoredAs::byte:
      return io.value(static_cast<std::uint8_t>(now));
    case StoredAs::word:
      return io.value(static_cast<std::uint32_t>(now));
  }
  return now;
}

template <class Io, class S>
void attribute(Io& io, S& s, std::uint32_t i, const AttributeRow& row) {
  if constexpr (Io::checks) io.needs.attributes |= 1u << +row.id;
  AttributeValue value = s.attributes.of(row.id, i);
  for (std::uint32_t k = 0; k < row.numbers; ++k) value[k] = number(io, row.stored, value[k]);
  io.demand(fault_of(row, value).kind == AttributeFault::Kind::none);
  io.demand(!row.of_dynamic || s.type[i] == BodyType::dynamic);
  if constexpr (Io::loads) s.attributes.set(row.id, i, value);
}

template <class Io, class S>
void settings(Io& io, S& s, std::uint32_t i) {
  const unsigned bits = setting_bits(io, Io::saves ? settings_of(s, i) : std::uint16_t(0));
  for (const AttributeRow& row : kAttributeTable)
    if (bits >> bit_of(row.id) & 1) attribute(io, s, i, row);
  if (bits >> kModes & 1) {
    if constexpr (Io::checks) io.needs.modes = true;
    const RowBits forbidden = io.value(bits_of(s.modes.forbidden_of, i));
    const RowBits forced = io.value(bits_of(s.modes.forced_of, i));
    io.demand(((forbidden | forced) >> kEffectCount) == 0 && !(forbidden & forced));
    if constexpr (Io::loads) s.modes.forbidden_of[i] = forbidden, s.modes.forced_of[i] = forced;
  }
  if (bits >> kContinuous & 1) {
    const auto mode = io.value(static_cast<std::uint8_t>(s.def[i].continuous));
    io.demand(mode <= static_cast<std::uint8_t>(SweepMode::never));
    if constexpr (Io::loads) s.def[i].continuous = static_cast<SweepMode>(mode);
  }
}

std::uint16_t bits_of_body(const World& world, std::uint32_t i) {
  const State& s = world.state;
  const Sleep& z = *world.sleep;
  const auto bit = [](bool on, BodyBits b) { return on ? b : 0; };
  const bool sleeps = i < z.sleep_timer.size();
  const bool rests = sleeps && !(same_bits(z.sleep_timer[i], Real(0)) && same_bits(z.anchor_x[i], s.x[i]) &&
                                 same_bits(z.anchor_q[i], s.q[i]));
  return static_cast<std::uint16_t>(
      bit(!zero_bits(s.v[i]) || !zero_bits(s.omega[i]), kMoves) | bit(!zero_bits(s.momentum[i]), kTop) |
      bit(!same_bits(s.held_q[i], s.q[i]), kHeld) |
      bit(!same_bits(s.placed_x[i], s.x[i]) || !same_bits(s.placed_q[i], s.q[i]), kPlacedElsewhere) |
      bit(!zero_bits(s.force[i]) || !zero_bits(s.torque[i]), kPushed) |
      bit(s.loaded_steps[i] | s.cooldown_steps[i], kSolverMemory) | bit(s.is_lost(i), kQuarantined) |
      bit(s.is_disabled(i), kDisabled) | bit(s.is_written[i], kWritten) | bit(world.state.sleeps(i), kAsleep) |
      bit(sleeps && z.inactive[i], kInactive) | bit(rests, kRests) |
      bit(i < world.events->slept.size() && world.events->slept[i], kSleptBefore) |
      bit(settings_of(world.scene, i), kSettings) | bit(s.accuracy[i] != AccuracyMemory(), kAccuracy));
}

bool sane_turn(const Quat& q) {
  const Real n2 = q.squared_norm();
  return n2 > 0.5 && n2 < 2;
}

/// One body of the state.
template <class Io, class W>
void body(Io& io, W& world, std::uint32_t i) {
  auto& s = world.state;
  auto& z = *world.sleep;
  io.begin_item();
  io.name_item(Item::body, i);
  const auto bits = io.value(Io::saves ? bits_of_body(world, i) : std::uint16_t(0));
  io.demand(bits <= kBodyBits);
  const Vec3 x = io.vec(s.x[i]);
  const Quat q = io.quat(s.q[i]);
  const bool written = bits & kWritten;  // then the next step looks at it before anybody else
  io.demand(sane_turn(q) && (sane_position(x) || written));
  keep(io, s.x[i], x), keep(io, s.q[i], q);
  const Vec3 zero = Vec3::zero();
  const auto vector_if = [&](BodyBits bit, auto& v) {
    const Vec3 now = bits & bit ? io.vec(v) : zero;
    keep(io, v, now);
    return now;
  };
  const Vec3 v = vector_if(kMoves, s.v[i]), omega = vector_if(kMoves, s.omega[i]);
  io.demand(written || (v.squared_norm() <= kMaxSpeed * kMaxSpeed && omega.squared_norm() <= kMaxSpin * kMaxSpin));
  io.demand(world.scene.type[i] != BodyType::fixed || (v.is_zero() && omega.is_zero()));
  vector_if(kTop, s.momentum[i]);
  const Quat held = bits & kHeld ? io.quat(s.held_q[i]) : q;
  io.demand(sane_turn(held));
  keep(io, s.held_q[i], held);
  const Vec3 placed_x = bits & kPlacedElsewhere ? io.vec(s.placed_x[i]) : x;
  const Quat placed_q = bits & kPlacedElsewhere ? io.quat(s.placed_q[i]) : q;
  io.demand(sane_turn(placed_q));
  keep(io, s.placed_x[i], placed_x), keep(io, s.placed_q[i], placed_q);
  vector_if(kPushed, s.force[i]), vector_if(kPushed, s.torque[i]);
  const auto loaded = bits & kSolverMemory ? io.value(s.loaded_steps[i]) : std::uint8_t(0);
  const auto cooldown = bits & kSolverMemory ? io.value(s.cooldown_steps[i]) : std::uint8_t(0);
  keep(io, s.loaded_steps[i], loaded), keep(io, s.cooldown_steps[i], cooldown);
  AccuracyMemory memory;
  if (bits & kAccuracy) {
    memory.level = io.value(s.accuracy[i].level), memory.wait = io.value(s.accuracy[i].wait),
    memory.met = io.value(s.accuracy[i].met);
    const AccuracyMemory& saved = s.accuracy[i];
    const auto flags = io.value(
        static_cast<std::uint8_t>(saved.softly | saved.stalled << 1 | saved.order / 2 << 2 | saved.patience << 4));
    memory.softly = flags & 1, memory.stalled = flags >> 1 & 1;
    memory.order = static_cast<std::uint8_t>(2 * (flags >> 2 & 3)), memory.patience = flags >> 4;
    memory.place = io.value(s.accuracy[i].place), memory.turn = io.value(s.accuracy[i].turn);
    io.demand(memory.level <= accuracy::kMostLevel && memory.place >= 0 && memory.turn >= 0);
  }
  keep(io, s.accuracy[i], memory);
  const std::uint32_t ring = bits & kAsleep ? io.value(Io::saves ? z.ring[i] : 0u) : kInvalid;
  const Real sleep_timer = bits & kRests ? io.real(Io::saves ? z.sleep_timer[i] : Real(0)) : Real(0);
  const Vec3 anchor_x = bits & kRests ? io.vec(Io::saves ? z.anchor_x[i] : zero) : x;
  const Quat anchor_q = bits & kRests ? io.quat(Io::saves ? z.anchor_q[i] : q) : q;
  if (bits & kSettings) settings(io, world.scene, i);
  if constexpr (Io::checks) {
    const bool arrays = i < io.needs.sleepers;
    io.demand(arrays || !(bits & (kAsleep | kInactive | kRests)));
    io.demand(!(bits & (kAsleep | kInactive)) || world.scene.inv_mass[i] > 0);
    io.demand(!(bits & kAsleep) ||
              (ring < io.needs.sleepers && world.scene.bodies.alive(ring) && world.scene.inv_mass[ring] > 0));
    io.demand(sleep_timer >= 0 && sane_turn(anchor_q));
  }
  if constexpr (Io::loads) {
    s.held_out[i] = static_cast<std::uint8_t>((bits & kQuarantined ? Quarantine::kNotFinite : 0) |
                                              (bits & kDisabled ? Quarantine::kDisabled : 0));
    s.quarantined_count += s.is_lost(i);
    if (bits & kWritten) s.mark_written(i);
    if (i < world.events->slept.size()) world.events->slept[i] = (bits & kSleptBefore) != 0;
    if (i >= z.sleep_timer.size()) return;
    world.state.asleep[i] = (bits & kAsleep) != 0, z.inactive[i] = (bits & kInactive) != 0;
    z.ring[i] = ring, z.sleep_timer[i] = sleep_timer, z.anchor_x[i] = anchor_x, z.anchor_q[i] = anchor_q;
    z.count += world.state.asleep[i];
  }
}

/// What bodies begin from: none is in quarantine, asleep or written to, nothing is set.
void clear_bodies(World& world, std::size_t sleepers) {
  Scene& c = world.scene;
  State& s = world.state;
  Sleep& z = *world.sleep;
  for (const std::uint32_t i : s.written) s.is_written[i] = 0;
  s.written.clear();
  s.quarantined_count = 0;
  c.attributes.reset_all();
  std::fill(c.modes.forbidden_of.begin(), c.modes.forbidden_of.end(), RowBits(0));
  std::fill(c.modes.forced_of.begin(), c.modes.forced_of.end(), RowBits(0));
  for (std::uint32_t i = 0; i < c.bodies.slots(); ++i)
    if (c.bodies.alive(i)) c.def[i].continuous = SweepMode::automatic;
  world.state.asleep.assign(sleepers, 0), z.inactive.assign(sleepers, 0), z.ring.assign(sleepers, kInvalid);
  z.sleep_timer.assign(sleepers, 0), z.anchor_x.assign(sleepers, Vec3::zero()),
      z.anchor_q.assign(sleepers, Quat::identity());
  z.radius.assign(sleepers, 0), z.rows.assign(sleepers, 0), z.kept_first.assign(sleepers, kInvalid);
  z.root.assign(sleepers, 0), z.restless.assign(sleepers, 0);
  z.count = 0;
}

struct Bodies {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    const auto sleepers = io.value(static_cast<std::uint32_t>(world.sleep->sleep_timer.size()));
    io.demand(sleepers <= world.scene.bodies.slots());
    if constexpr (Io::checks) io.needs.sleepers = sleepers;
    if constexpr (Io::loads) clear_bodies(world, sleepers);
    for (std::uint32_t i = 0; i < world.scene.bodies.slots() && !io.bad(); ++i)
      if (world.scene.bodies.alive(i)) body(io, world, i);
    if constexpr (Io::loads) {
      for (std::uint32_t i = 0; i < world.scene.locks.size(); ++i) settle_locks(world.scene, i);
    }
  }
};

// ---- colliders ----
enum ColliderBits : std::uint8_t {
  kFrameOfPose = 0,   // as its body stands now
  kFrameOfPlace = 1,  // as its body stood when it was placed
  kFrameItself = 2,
  kFrameNone = 3,  // it has not been placed yet
  kFrameBits = 3,
  kTravelled = 4,
  kFiltered = 8,
  kSensor = 16,
  kSurface = 32,
  kColliderBits = 63
};

bool same(const Frame& a, const Frame& b) { return same_bits(a.r, b.r) && same_bits(a.p, b.p); }

/// As place_collider() makes it.
Frame frame_at(const World& world, std::uint32_t slot, const Quat& q, const Vec3& x) {
  const Scene& s = world.scene;
  const Frame local(s.colliders.local[slot].q.matrix(), s.colliders.local[slot].p - s.center[s.colliders.body[slot]]);
  return Frame(q.matrix(), x) * local;
}
Frame frame_of_pose(const World& world, std::uint32_t slot) {
  const std::uint32_t i = world.scene.colliders.body[slot];
  return frame_at(world, slot, world.state.q[i], world.state.x[i]);
}
Frame frame_of_place(const World& world, std::uint32_t slot) {
  const std::uint32_t i = world.scene.colliders.body[slot];
  return frame_at(world, slot, world.state.placed_q[i], world.state.placed_x[i]);
}

std::uint8_t bits_of_collider(const World& world, std::uint32_t slot) {
  const Colliders& c = world.scene.colliders;
  const Frame& f = c.frame[slot];
  const bool placed = same(f, frame_of_place(world, slot));
  const int frame = placed                                ? kFrameOfPlace
                    : same(f, frame_of_pose(world, slot)) ? kFrameOfPose
                    : same(f, Frame())                    ? kFrameNone
                                                          : kFrameItself;
  const SurfaceVelocity surface = world.scene.surface_of(slot);
  const bool still = zero_bits(surface.linear) && zero_bits(surface.angular);
  return static_cast<std::uint8_t>(frame | (same_bits(c.travel[slot], Real(0)) ? 0 : kTravelled) |
                                   (c.filter_of(slot) == Filter() ? 0 : kFiltered) | (c.is_sensor(slot) ? kSensor : 0) |
                                   (still ? 0 : kSurface));
}

template <class Io, class W>
void collider(Io& io, W& world, std::uint32_t slot) {
  auto& c = world.scene.colliders;
  io.begin_item();
  io.name_item(Item::collider, slot);
  const std::uint8_t bits = io.value(Io::saves ? bits_of_collider(world, slot) : std::uint8_t(0));
  io.demand(bits <= kColliderBits);
  if ((bits & kFrameBits) == kFrameItself) {
    const Frame f(io.mat(c.frame[slot].r), io.vec(c.frame[slot].p));
    io.demand(f.r.abs().sum() < 6 && f.p.abs().sum() < 1e100);
    keep(io, c.frame[slot], f);
  }
  if constexpr (Io::loads) {
    if ((bits & kFrameBits) == kFrameOfPose) c.frame[slot] = frame_of_pose(world, slot);
    if ((bits & kFrameBits) == kFrameOfPlace) c.frame[slot] = frame_of_place(world, slot);
    if ((bits & kFrameBits) == kFrameNone) c.frame[slot] = Frame();
  }
  const Real travel = bits & kTravelled ? io.value(c.travel[slot]) : Real(0);  // of any value: not even NaN misleads
  keep(io, c.travel[slot], travel);
  if constexpr (Io::checks)
    io.needs.filter |= bits & kFiltered, io.needs.sensor |= bits & kSensor, io.needs.surface |= bits & kSurface;
  if (bits & kFiltered) {
    const Filter now = c.filter_of(slot);
    const Filter filter{io.value(now.category), io.value(now.mask), io.value(now.group)};
    if constexpr (Io::loads) c.filter[slot] = filter;
  }
  if constexpr (Io::loads)
    if (bits & kSensor) c.sensor[slot] = 1;
  if (bits & kSurface) {
    const SurfaceVelocity now = world.scene.surface_of(slot);
    const SurfaceVelocity surface{io.vec(now.linear), io.vec(now.angular)};
    io.demand(surface.linear.abs().max_entry() <= 1e6 && surface.angular.abs().max_entry() <= 1e6);
    if constexpr (Io::loads) world.scene.surface[slot] = surface, world.scene.moving_surfaces += surface.any();
  }
}

struct Shells {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& c = world.scene.colliders;
    if constexpr (Io::loads) {
      std::fill(c.filter.begin(), c.filter.end(), Filter());
      std::fill(c.sensor.begin(), c.sensor.end(), std::uint8_t(0));
      std::fill(world.scene.surface.begin(), world.scene.surface.end(), SurfaceVelocity{});
      world.scene.moving_surfaces = 0;
    }
    for (std::size_t k = 0; k < c.live.size() && !io.bad(); ++k) collider(io, world, c.live[k]);
    faulty(io, world);
  }

 private:
  /// Shapes in quarantine, by the first collider that wears one.
  template <class Io, class W>
  static void faulty(Io& io, W& world) {
    const auto& c = world.scene.colliders;
    auto& shapes = world.plan->faulty;
    io.begin_item();
    io.name_item(Item::none);
    const std::uint64_t n = io.count(shapes.size(), 4);
    if constexpr (Io::checks) io.needs.faulty = n;
    if constexpr (Io::loads) shapes.clear();
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
      std::uint32_t slot = 0;
      if constexpr (Io::saves)
        slot = *std::ranges::find_if(c.live, [&](std::uint32_t s) { return c.shape[s] == shapes[k]; });
      slot = io.value(slot);
      io.demand(world.scene.collider_slots.alive(slot));
      if constexpr (Io::loads) shapes.push_back(c.shape[slot]);
    }
  }
};

/// How bodies that a host moves went in the last step. Of what is gone since nothing is kept.
struct Leads {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& driven = world.state.driven;
    const SlotPool& bodies = world.scene.bodies;
    const auto is_there = [&](const DrivenMemory& d) { return bodies.handle(handle_slot(d.body)) == d.body; };
    const std::uint64_t n = io.count(
        Io::saves ? static_cast<std::uint64_t>(std::ranges::count_if(driven, is_there)) : std::uint64_t(0), 108);
    if constexpr (Io::checks) io.needs.driven = n;
    if constexpr (Io::loads) driven.resize(n);
    std::uint32_t next = 0, at = 0;
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k, ++at) {
      if constexpr (Io::saves)
        while (!is_there(driven[at])) ++at;
      const DrivenMemory now = Io::saves ? driven[at] : DrivenMemory();
      const std::uint32_t slot = io.value(handle_slot(now.body));
      io.begin_item(), io.name_item(Item::body, slot);
      io.demand(slot >= next && bodies.alive(slot));
      next = slot + 1;
      DrivenMemory d{0, io.real(now.dt), io.vec(now.v), io.vec(now.omega), io.vec(now.a), io.vec(now.alpha)};
      io.demand(d.dt > 0);
      if constexpr (Io::loads) d.body = bodies.handle(slot), driven[k] = d;
    }
  }
};

}  // namespace

constinit const Section kDriven = section<Leads>("LEAD", "driven bodies");
constinit const Section kBodies = section<Bodies>("BODY", "bodies");
constinit const Section kColliders = section<Shells>("COLL", "colliders");

}  // namespace carom::dynamics::snapshot

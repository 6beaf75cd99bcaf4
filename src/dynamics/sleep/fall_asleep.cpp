// Who has been slow for long enough, and which islands are so altogether.
#include "dynamics/force/force.h"
#include "dynamics/island.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

/// Count on a body's time of being slow, or start it anew. Comparisons are such that NaN is not slow.
void count_calm(const World& world, Sleep& z, std::uint32_t i, Real speed, Real dt) {
  const State& s = world.state;
  const bool slow = s.v[i].norm() + z.radius[i] * s.omega[i].norm() <= speed && !s.held_out[i] &&
                    !world.scene.def[i].stays_awake && !world.scene.modes.forbids(+EffectId::sleep, i);
  if (slow) {
    // A turn by angle a moves a point at radius r by 2 r sin(a/2), which is 2 r times the vector part of its
    // quaternion.
    const Vec3 turn = (s.q[i] * z.anchor_q[i].conjugate()).vec();
    const Real come = (s.x[i] - z.anchor_x[i]).norm() + 2 * z.radius[i] * turn.norm();
    if (come <= speed * (z.sleep_timer[i] + dt)) {
      z.sleep_timer[i] += dt;
      return;
    }
  }
  z.sleep_timer[i] = 0;
  z.anchor_x[i] = s.x[i];
  z.anchor_q[i] = s.q[i];
}

bool rolls_by(const World& world, std::uint32_t i) {
  return world.scene.type[i] == BodyType::kinematic &&
         (world.state.v[i] != Vec3::zero() || world.state.omega[i] != Vec3::zero());
}

/// Who hangs on one spring falls asleep together.
void join_sprung(const World& world, Array<std::uint32_t>& root) {
  const Springs& springs = world.scene.springs;
  const auto root_of = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  const PlannedEffect& row = world.plan->effects[+EffectId::springs];
  row.participants.each([&](std::uint32_t k) {
    const std::uint32_t a = springs.def[k].body_a, b = springs.def[k].body_b;
    if (a == kInvalid || b == kInvalid || !responds(world.scene, world.state, a) ||
        !responds(world.scene, world.state, b))
      return;
    const std::uint32_t one = root_of(a), other = root_of(b);
    root[std::max(one, other)] = std::min(one, other);  // the lowest slot is the root
  });
}

/// The island of every participant, and which islands something keeps awake.
void find_islands(const World& world, Sleep& z, const Participants& participants, Real time) {
  Contacts& c = *world.contacts;
  participants.each([&](std::uint32_t i) { z.root[i] = i, z.restless[i] = 0; });
  const bool met = world.plan->runs[static_cast<std::size_t>(Stage::group)];
  if (met) {
    const bool grouped = world.scene.dials.choice(Dial::groups) != 0;
    for (const std::uint32_t i : c.bodies) z.root[i] = grouped ? island_of(c, i) : c.bodies[0];
    if (world.rattle)
      rattle::each_held(*world.rattle, [&](const RattleIsland& island) {  // no other body is in these
        for (std::uint32_t k = island.body; k < island.body + island.movers; ++k)
          z.root[world.rattle->bodies[k].slot] = world.rattle->bodies[island.body].slot;
      });
  }
  const PlannedEffect& sprung = world.plan->effects[+EffectId::springs];
  if (sprung.participants.count > 0) {
    join_sprung(world, z.root);
    participants.each([&](std::uint32_t i) {  // ascending, and roots are lower: they stand already
      z.root[i] = z.root[z.root[i]];
    });
  }
  participants.each([&](std::uint32_t i) { z.restless[z.root[i]] |= !(z.sleep_timer[i] >= time); });
  sprung.participants.each([&](std::uint32_t k) {
    const SpringDef& def = world.scene.springs.def[k];
    const std::uint32_t a = def.body_a, b = def.body_b;
    if (a == kInvalid || b == kInvalid) return;
    if (rolls_by(world, b)) z.restless[z.root[a]] = 1;
    if (rolls_by(world, a)) z.restless[z.root[b]] = 1;
  });
  if (!met) return;
  for (const Row& row : c.rows) {
    if (row.moves_a && rolls_by(world, row.b)) z.restless[z.root[row.a]] = 1;
    if (row.moves_b && rolls_by(world, row.a)) z.restless[z.root[row.b]] = 1;
  }
  for (const Driven& driven : c.driven) {
    const Row& row = c.rows[driven.row];
    if (row.moves_a) z.restless[z.root[row.a]] = 1;
    if (row.moves_b) z.restless[z.root[row.b]] = 1;
  }
  if (world.rattle)
    rattle::each_held(*world.rattle, [&](const RattleIsland& island) {
      for (std::uint32_t k = island.body + island.movers; k < island.body + island.bodies; ++k)
        if (rolls_by(world, world.rattle->bodies[k].slot)) z.restless[world.rattle->bodies[island.body].slot] = 1;
    });
  for (const Link& link : c.links) {
    if (link.moves_a && link.b != kInvalid && rolls_by(world, link.b)) z.restless[z.root[link.a]] = 1;
    if (link.moves_b && link.a != kInvalid && rolls_by(world, link.a)) z.restless[z.root[link.b]] = 1;
  }
}

void lie_down(Velocities& s, SleepFlags& flags, Sleep& z, std::uint32_t i) {
  s.v[i] = s.omega[i] = s.momentum[i] = Vec3::zero();
  flags.asleep[i] = 1;
  z.ring[i] = i;
  if (const std::uint32_t first = z.root[i]; first != i) {
    // The root has the lowest slot of its island, so it lies already.
    z.ring[i] = z.ring[first];
    z.ring[first] = i;
  }
  z.fallen.push_back(i);
  ++z.count;
}

}  // namespace

void sleeping::find(const Scene& scene, const State& state, Participants& participants) {
  if (scene.dials.choice(Dial::sleep) == 0) return;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i)) participants.add(i);
}

void fall_asleep(const World& world, Velocities& motion, Sleepers to, StepReport& report, const StepTime& time) {
  PlannedEffect& row = world.plan->effects[+EffectId::sleep];
  if (row.participants.count == 0) return;
  Sleep& z = to;
  const Dials& dials = world.scene.dials;
  const Real speed = dials[Dial::sleep_speed], need = dials[Dial::sleep_time];
  bool anyone = false;
  row.participants.each([&](std::uint32_t i) {
    count_calm(world, z, i, speed, time.dt);
    anyone |= z.sleep_timer[i] >= need;
  });
  row.evaluations += row.participants.count;
  if (!anyone) return;
  find_islands(world, z, row.participants, need);
  row.participants.each([&](std::uint32_t i) {
    if (!z.restless[z.root[i]]) lie_down(motion, to, z, i);
  });
  report.fell_asleep = z.fallen.size();
  report.asleep_bodies = z.count;
}

}  // namespace carom::dynamics

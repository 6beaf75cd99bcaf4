// The pool of particles: what an edit does against a slow twin, who runs and who does not, quarantine, same bits for any
// width of registers and any way of sharing the work, no memory in a step.
#include <random>

#include "carom_test.h"
#include "dynamics/quarantine.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

std::uint32_t add_set(World& world, const ParticleDef& def = {}) { return handle_slot(world.particles.create(def, 0)); }

/// n particles that fly apart. The numbers are those of a small generator: all different, same everywhere.
void fill(World& world, std::uint32_t set, std::size_t n) {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<Real>(random() % 2001) / 100 - 10; };
  const std::size_t first = world.particles.extend(set, n);
  for (std::size_t i = first; i < first + n; ++i) {
    const Real x = number(), y = number(), z = number(), u = number(), v = number(), w = number();
    world.particles.place(set, i, Vec3(x, y, z));
    world.particles.set_velocity(set, i, Vec3(u, v, w));
  }
}

/// Counts what is asked of it; refuses from the call of number `fail_at` on.
class CountingMemory : public std::pmr::memory_resource {
 public:
  std::uint64_t calls = 0, fail_at = ~std::uint64_t(0);

 private:
  void* do_allocate(std::size_t bytes, std::size_t align) override {
    if (calls++ >= fail_at) throw std::bad_alloc();
    return std::pmr::new_delete_resource()->allocate(bytes, align);
  }
  void do_deallocate(void* p, std::size_t bytes, std::size_t align) override {
    std::pmr::new_delete_resource()->deallocate(p, bytes, align);
  }
  bool do_is_equal(const memory_resource& o) const noexcept override { return this == &o; }
};

/// Deals out parts one by one, from the last to the first.
class Backwards : public Jobs {
 public:
  void run(Task task, void* context, std::uint32_t count, std::uint32_t grain) override {
    for (std::uint32_t parts = (count + grain - 1) / grain; parts-- > 0; ++dealt)
      task(context, parts * grain, std::min(count, (parts + 1) * grain));
  }
  int dealt = 0;
};

}  // namespace

static void a_world_of_particles_integrates_and_one_without_does_not(void**) {
  TestWorld t;
  PlannedEffect& row = *t.world.plan->find("particles");
  const auto runs = [&](Stage s) { return t.world.plan->runs[static_cast<std::size_t>(s)]; };
  const std::uint32_t s = add_set(t.world);
  t.run(2, 1.0 / 60);
  assert_false(runs(Stage::integrate));
  assert_int_equal(row.participants.count, 0);
  assert_int_equal(row.evaluations, 0);
  fill(t.world, s, 100);
  const std::uint64_t plans = t.world.plan->revision;
  t.run(3, 1.0 / 60);
  assert_true(runs(Stage::integrate));
  assert_int_equal(t.world.plan->revision, plans);  // what comes and goes makes no plan anew
  assert_int_equal(row.participants.count, 100);
  assert_int_equal(row.evaluations, 300);
  assert_true(t.world.report.stage_seconds[static_cast<std::size_t>(Stage::integrate)] > 0);
  for (const PlannedEffect& other : t.world.plan->effects)
    if (&other != &row) assert_int_equal(other.evaluations, 0);
  for (const Stage stage : {Stage::broad, Stage::narrow, Stage::group, Stage::solve, Stage::relax})
    assert_false(runs(stage));
  t.world.particles.clear(s);
  t.run(1, 1.0 / 60);
  assert_false(runs(Stage::integrate));
  assert_int_equal(row.participants.count, 0);
}

static void islands_asleep_stay_asleep_beside_particles(void**) {
  TestWorld t;
  t.world.set_dial(Dial::integrator, 1);
  t.world.set_dial(Dial::substeps, 1);
  t.world.set_dial(Dial::sleep, 1);
  t.ground();
  const std::uint32_t box_body = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  const std::uint32_t s = add_set(t.world);
  t.run(120, 1.0 / 60);
  assert_true(t.world.asleep(box_body));
  fill(t.world, s, 10);
  const Vec3 x = t.world.particles.set[s].position(0), v = t.world.particles.set[s].velocity(0);
  t.run(1, 1.0 / 60);
  assert_true(t.world.asleep(box_body));
  assert_true(t.world.particles.set[s].position(0) == Vec3(x + (v + t.world.scene.gravity / 60) / 60));
}

/// Random edits of a set and of a list of structs, which end alike.
static void edits_do_what_they_do_to_a_plain_list(void**) {
  struct Plain {
    Vec3 x, v;
    Real mass;
    bool held;
  };
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    TestWorld t(Vec3::zero());
    Particles& p = t.world.particles;
    ParticleDef def;
    const std::uint32_t s = add_set(t.world, def);
    std::vector<Plain> plain;
    for (int edit = 0; edit < 60; ++edit) {
      const Real a = static_cast<Real>(below(1000)), b = static_cast<Real>(below(1000));
      switch (below(7)) {
        case 0:
        case 1:
          for (std::size_t n = below(200), k = p.extend(s, n); k < p.set[s].size(); ++k) {
            plain.push_back({Vec3(a, b, static_cast<Real>(k)), Vec3::zero(), def.mass, false});
            p.place(s, k, plain.back().x);
          }
          break;
        case 2: {
          std::vector<std::uint32_t> gone;
          const std::size_t one_in = 1 + below(5);
          for (std::size_t i = 0; i < plain.size(); ++i)
            if (below(one_in) == 0) gone.push_back(static_cast<std::uint32_t>(i));
          p.remove(s, gone.data(), gone.size());
          for (std::size_t k = gone.size(); k-- > 0;) plain.erase(plain.begin() + gone[k]);
          break;
        }
        case 3:
          if (!plain.empty()) {
            const std::size_t i = below(plain.size());
            p.hold(s, i);
            plain[i].held = true, plain[i].v = Vec3::zero();
          }
          break;
        case 4:
          if (!plain.empty()) {
            const std::size_t i = below(plain.size());
            p.place(s, i, Vec3(a, a, b));
            plain[i].held = false, plain[i].x = Vec3(a, a, b);
          }
          break;
        case 5:
          if (!plain.empty()) {
            const std::size_t i = below(plain.size());
            p.reserve_masses(s);
            p.set_mass(s, i, 1 + a);
            plain[i].mass = 1 + a;
          }
          break;
        default:
          def.mass = 1 + b;
          p.update(s, def);
          if (below(10) == 0) p.clear(s), plain.clear();
      }
      const ParticleSet& set = p.set[s];
      assert_int_equal(set.size(), plain.size());
      assert_int_equal(p.count(), plain.size());
      std::size_t held = 0;
      for (std::size_t i = 0; i < plain.size(); ++i) {
        assert_true(set.position(i) == plain[i].x && set.velocity(i) == plain[i].v);
        assert_true(set.mass_of(i) == plain[i].mass);
        assert_int_equal(set.is_held(i), plain[i].held);
        held += plain[i].held;
      }
      assert_int_equal(p.held_count(), held);
    }
  }
}

static void who_leaves_the_world_is_held_and_reported_and_the_others_fly_on(void**) {
  for (const Real integrator : {0.0, 1.0, 2.0, 3.0})
    for (const bool weighed : {false, true})
      for (const int how : {0, 1}) {
        TestWorld t, alone;
        for (TestWorld* world : {&t, &alone}) {
          world->world.set_dial(Dial::integrator, integrator);
          add_set(world->world);
          fill(world->world, 0, 1000);
          if (weighed) world->world.particles.reserve_masses(0), world->world.particles.set_mass(0, 3, 2);
        }
        Particles& p = t.world.particles;
        t.run(1, 1.0 / 60), alone.run(1, 1.0 / 60);
        for (const std::size_t sick : {std::size_t(130), std::size_t(700)}) {
          if (how == 0) p.place(0, sick, Vec3(0, kMaxPosition, 0)), p.set_velocity(0, sick, Vec3(0, 900, 0));
          if (how == 1) p.set_velocity(0, sick, Vec3(0, -kMaxSpeed, 0));  // and gravity adds to it
        }
        t.run(1, 1.0 / 60), alone.run(1, 1.0 / 60);
        assert_int_equal(t.world.fault_views.size(), 1);
        assert_int_equal(t.world.fault_views[0].particles, 0);
        assert_int_equal(t.world.fault_views[0].particle, 130);
        assert_int_equal(t.world.report.quarantined_particles, 2);
        assert_int_equal(t.world.report.faults, 1);
        const Vec3 held = p.set[0].position(130);
        assert_true(held.norm() <= kMaxPosition * (1 + 4 * kEpsilon));
        t.run(5, 1.0 / 60), alone.run(5, 1.0 / 60);
        assert_int_equal(t.world.report.faults, 0);
        assert_true(p.set[0].position(130) == held && p.set[0].velocity(130) == Vec3::zero());
        Real energy = 0;
        for (std::size_t i = 0; i < 1000; ++i) {
          if (i == 130 || i == 700) continue;
          assert_true(p.set[0].position(i) == alone.world.particles.set[0].position(i));
          energy += 0.5 * p.set[0].mass_of(i) * p.set[0].velocity(i).squared_norm();
        }
        assert_true(std::fabs(t.world.report.linear_energy - energy) <= 2 * 1010 * kEpsilon * energy);
        assert_int_equal(t.world.plan->find("particles")->participants.count, 998);
        // Given a place, it is back in the world.
        p.place(0, 130, Vec3(3, 5, 0));
        t.run(5, 1.0 / 60);
        assert_int_equal(t.world.report.quarantined_particles, 1);
        assert_true(p.set[0].position(130).y() < 5);
      }
}

static void in_the_step_in_which_it_strays_energy_leaves_it_out(void**) {
  TestWorld t(Vec3::zero());
  const std::uint32_t s = add_set(t.world, {1, 0, 4});
  fill(t.world, s, 3);
  for (std::size_t i = 0; i < 3; ++i) t.world.particles.set_velocity(s, i, Vec3(2, 0, 0));
  t.world.particles.place(s, 1, Vec3(kMaxPosition, 0, 0));
  t.world.particles.set_velocity(s, 1, Vec3(1e3, 0, 0));
  t.run(1, 1.0);
  assert_int_equal(t.world.report.quarantined_particles, 1);
  assert_true(t.world.report.linear_energy == 16);
  // Nor is anything left of those that are removed, though nobody flies any more.
  const std::uint32_t others[] = {0, 2};
  t.world.particles.remove(s, others, 2);
  t.run(1, 1.0);
  assert_int_equal(t.world.plan->find("particles")->participants.count, 0);
  assert_true(t.world.report.linear_energy == 0);
}

static std::uint64_t hash_after(const FlightKernels* kernels, Jobs* jobs, Real integrator, bool weighed) {
  TestWorld t;
  t.world.jobs = jobs;
  if (kernels) t.world.particles.kernels = kernels;
  t.world.set_dial(Dial::integrator, integrator);
  for (const std::size_t n : {1, 3, 511, 513, 6001}) {
    const std::uint32_t s = add_set(t.world, {0.5, 0.3, 2});
    fill(t.world, s, n);
    for (std::size_t i = 0; i < n; i += 97) t.world.particles.hold(s, i);
    if (weighed) t.world.particles.reserve_masses(s), t.world.particles.set_mass(s, 0, 3);
  }
  t.run(20, 1.0 / 60);
  std::uint64_t energy;
  std::memcpy(&energy, &t.world.report.linear_energy, sizeof energy);
  return t.world.hash() ^ energy;
}

static void every_width_and_every_way_to_share_gives_the_same_bits(void**) {
  for (const Real integrator : {0.0, 1.0, 2.0, 3.0})
    for (const bool weighed : {false, true}) {
      const std::uint64_t baseline = hash_after(all_flight_kernels().front(), nullptr, integrator, weighed);
      for (const FlightKernels* kernels : all_flight_kernels())
        assert_true(hash_after(kernels, nullptr, integrator, weighed) == baseline);
      Backwards backwards;
      assert_true(hash_after(nullptr, &backwards, integrator, weighed) == baseline);
      assert_true(backwards.dealt >= 2 * 20);  // the largest set is shared
    }
}

static void the_hash_sees_places_velocities_and_who_is_held(void**) {
  TestWorld t;
  const std::uint32_t s = add_set(t.world);
  fill(t.world, s, 5);
  const std::uint64_t first = t.world.hash();
  const Vec3 x = t.world.particles.set[s].position(4);
  t.world.particles.place(s, 4, x + Vec3(0, 0, 1e-15));
  assert_true(t.world.hash() != first);
  t.world.particles.place(s, 4, x);
  assert_true(t.world.hash() == first);
  t.world.particles.set_velocity(s, 2, Vec3::zero());
  const std::uint64_t still = t.world.hash();
  assert_true(still != first);
  t.world.particles.hold(s, 2);
  assert_true(t.world.hash() != still);
}

static void a_step_allocates_nothing(void**) {
  CountingMemory memory;
  World world(1, Vec3(0, -9.81, 0), 0, &memory);
  const std::uint32_t s = add_set(world, {1, 0.1, 1});
  fill(world, s, 3000);
  world.step(1.0 / 60);
  const std::uint64_t before = memory.calls;
  for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
  world.particles.place(s, 7, Vec3(0, kMaxPosition, 0));
  world.particles.set_velocity(s, 7, Vec3(0, 900, 0));
  world.step(1.0 / 60);  // nor when something goes wrong
  assert_int_equal(world.report.faults, 1);
  assert_int_equal(memory.calls, before);
}

static void running_out_of_memory_at_any_point_changes_nothing(void**) {
  void (*const edits[])(World&) = {[](World& w) { w.particles.create({}, 5000); },
                                   [](World& w) { w.particles.extend(0, 700); },
                                   [](World& w) {
                                     w.particles.update(0, {1, 0, 3});
                                   }};
  for (const auto edit : edits) {
    std::uint64_t k = 0;
    for (bool failed = true; failed; ++k) {
      CountingMemory memory;
      World world(1, Vec3::zero(), 0, &memory);
      add_set(world);
      fill(world, 0, 100);
      world.step(0.01);
      const std::uint64_t hash = world.hash();
      memory.fail_at = memory.calls + k;
      failed = false;
      try {
        edit(world);
      } catch (const std::bad_alloc&) {
        failed = true;
        assert_true(world.hash() == hash);
        assert_int_equal(world.particles.count(), 100);
        assert_int_equal(world.particles.slots.alive_count(), 1);
        assert_true(world.particles.set[0].mass.empty());
      }
      memory.fail_at = ~std::uint64_t(0);
      world.particles.extend(0, 1000);  // and it goes on
      world.particles.reserve_masses(0);
      world.particles.set_mass(0, 1099, 3);
      world.step(0.01);
      assert_true(world.particles.set[0].mass_of(1099) == 3);
    }
    assert_true(k >= 2);  // each of them allocates
  }
}

static void a_particle_takes_fifty_bytes(void**) {
  TestWorld t;
  const std::uint32_t s = handle_slot(t.world.particles.create({}, 20000));
  fill(t.world, s, 20000);
  const ParticleSet& p = t.world.particles.set[s];
  std::size_t bytes = p.mass.capacity() * sizeof(Real) + p.held.capacity() * 8 + p.sums.capacity() * sizeof(FlightSums);
  for (int axis = 0; axis < 3; ++axis) bytes += (p.x[axis].capacity() + p.v[axis].capacity()) * sizeof(Real);
  assert_true(bytes <= 50 * 20000);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_world_of_particles_integrates_and_one_without_does_not),
      cmocka_unit_test(islands_asleep_stay_asleep_beside_particles),
      cmocka_unit_test(edits_do_what_they_do_to_a_plain_list),
      cmocka_unit_test(who_leaves_the_world_is_held_and_reported_and_the_others_fly_on),
      cmocka_unit_test(in_the_step_in_which_it_strays_energy_leaves_it_out),
      cmocka_unit_test(every_width_and_every_way_to_share_gives_the_same_bits),
      cmocka_unit_test(the_hash_sees_places_velocities_and_who_is_held),
      cmocka_unit_test(a_step_allocates_nothing),
      cmocka_unit_test(running_out_of_memory_at_any_point_changes_nothing),
      cmocka_unit_test(a_particle_takes_fifty_bytes),
  };
  return cmocka_run_group_tests_name("dynamics/particles", tests, nullptr, nullptr);
}

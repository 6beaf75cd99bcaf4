// Who is swept and who pays for it; modes, filters, sensors, sleepers and events; the same bits under every broad phase
// and any number of threads.
#include <numbers>

#include "carom_test.h"
#include "core/job_pool.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/detect.h"
#include "dynamics/events/events.h"
#include "random_pairs.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kDt = 1.0 / 60;
constexpr Real kEverything = 2;  // kSweepFast

/// A thin static wall at x = 0 and a ball that flies at it, weightless.
struct Range : TestWorld {
  explicit Range(Real speed = 200, Real restitution = 1) : TestWorld(Vec3::zero()) {
    const std::uint32_t m = material(0, restitution);
    wall = add(keep(box(Vec3(0.005, 2, 2))), Vec3::zero(), BodyType::fixed, Quat::identity(), m);
    ball = add(keep(sphere(0.1)), Vec3(-1, 0, 0), BodyType::dynamic, Quat::identity(), m);
    world.set_velocity(ball, Vec3(speed, 0, 0), Vec3::zero());
  }
  Real x() const { return world.state.x[ball].x(); }
  bool passed() const { return x() > 0; }
  std::uint32_t collider(std::uint32_t body) const { return world.scene.first_collider[body]; }
  std::uint32_t wall, ball;
};

/// Balls at rest on a plate, n by n.
void pave(TestWorld& t, int n) {
  t.add(t.keep(box(Vec3(50, 1, 50))), Vec3(0, -1, 0), BodyType::fixed);
  const Shape* ball = t.keep(sphere(0.25));
  for (int i = 0; i < n * n; ++i) t.add(ball, Vec3(i % n - n / 2, 0.25, i / n - n / 2));
}

std::uint64_t evaluations(const World& w) { return w.plan->effects[+EffectId::continuous].evaluations; }

}  // namespace

static void a_rotation_vector_turns_as_its_quaternion(void**) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const Real angle = random.uniform(0, 20);
    const Vec3 axis = random.direction(), phi = angle * axis;
    // Nearest to something up to half a turn off: the vector itself.
    const Vec3 near = phi + random.uniform(-3, 3) * axis;
    assert_true((rotation_vector(exp_map(phi), near) - phi).norm() < 1e-13 * (1 + angle));
    // From wherever: the same rotation.
    const Vec3 other = rotation_vector(exp_map(phi), 10 * random.direction());
    const Quat back = exp_map(other) * exp_map(phi).conjugate();
    assert_true(back.vec().norm() < 1e-13 * (1 + angle));
  }
  const Vec3 whole = rotation_vector(Quat::identity(), Vec3(0, 6.5, 0));  // of no turn: a whole one
  assert_true((whole - Vec3(0, 2 * std::numbers::pi, 0)).norm() < 1e-14);
  assert_true(rotation_vector(Quat::identity(), Vec3(0, 3, 0)) == Vec3::zero());
}

static void who_is_slow_pays_nothing(void**) {
  const auto run = [](Real dial) {
    TestWorld t;
    t.world.set_dial(Dial::continuous, dial);
    pave(t, 4);
    t.add(t.keep(box(Vec3(0.3, 0.1, 0.2))), Vec3(0.2, 3, 0.1));
    t.run(120, kDt);
    const Continuous& c = *t.world.continuous;
    assert_int_equal(evaluations(t.world), 0);
    assert_int_equal(t.world.report.swept_bodies, 0);
    assert_int_equal(c.index.capacity() + c.bodies.capacity() + c.boxes.capacity() + c.hits.capacity() +
                         c.found.capacity() + c.loose.capacity(),
                     0);
    return t.world.hash();
  };
  assert_true(run(0) == run(kEverything));
}

// A ball beside whatever else there is: one body swept, nobody else known, and as many queries as if it were alone.
static void one_participant_is_one_participants_work(void**) {
  std::uint64_t calls[2];
  for (const int n : {0, 40}) {
    Range t(200, 1);
    if (n > 0) {
      const Shape* ball = t.keep(sphere(0.25));
      for (int i = 0; i < n * n; ++i) t.add(ball, Vec3(i % n - n / 2, -30, i / n - n / 2));
    }
    t.run(2, kDt);
    assert_int_equal(t.world.report.swept_bodies, 1);
    assert_int_equal(evaluations(t.world), 2);
    assert_int_equal(t.world.continuous->bodies.size(), 1);
    assert_false(t.passed());
    calls[n > 0] = t.world.report.narrow.support_calls + t.world.continuous->found.size();
  }
  assert_int_equal(calls[0], calls[1]);
}

static void a_host_has_its_say(void**) {
  const struct {
    Real dial;
    SweepMode mode;
    Real speed;
    std::uint64_t swept;
    bool passes;
  } cases[] = {
      {0, SweepMode::automatic, 200, 0, true},  {0, SweepMode::always, 200, 0, true},
      {1, SweepMode::automatic, 200, 0, true},  {1, SweepMode::always, 200, 2, false},
      {2, SweepMode::automatic, 200, 2, false}, {2, SweepMode::never, 200, 0, true},
      {2, SweepMode::automatic, 5, 0, false},   {2, SweepMode::always, 5, 2, false},
  };
  for (const auto& c : cases) {
    Range t(c.speed);
    t.world.set_dial(Dial::continuous, c.dial);
    t.world.set_continuous(t.ball, c.mode);
    t.run(2, kDt);
    assert_int_equal(evaluations(t.world), c.swept);
    assert_true(t.passed() == c.passes);
  }
}

static void who_may_not_touch_is_passed(void**) {
  for (int how = 0; how < 5; ++how) {
    Range t;
    if (how == 1) t.world.set_filter(t.collider(t.ball), {2, 2, 0});
    if (how == 2) t.world.ignore_collision(t.ball, t.wall);
    if (how == 3) t.world.set_sensor(t.collider(t.wall), true);
    if (how == 4) t.world.set_sensor(t.collider(t.ball), true);
    t.run(2, kDt);
    assert_true(t.passed() == (how > 0));
    if (how > 0) assert_true(t.x() == -1 + 2 * kDt * 200 || std::fabs(t.x() - (-1 + 2 * kDt * 200)) < 1e-14);
  }
}

// In the step in which it is hit, a sleeper wakes and goes; where it was not in the way it sleeps on.
static void sleepers_wake_when_they_are_hit(void**) {
  for (const bool in_the_way : {true, false}) {
    TestWorld t(Vec3::zero());
    const std::uint32_t m = t.material(0, 1);
    t.world.set_dial(Dial::sleep, 1);
    const Shape* ball = t.keep(sphere(0.1));
    const std::uint32_t rests = t.add(ball, Vec3(0, in_the_way ? 0 : 0.22, 0), BodyType::dynamic, Quat::identity(), m);
    t.run(60, kDt);
    assert_true(t.world.asleep(rests));
    const std::uint32_t comes = t.add(ball, Vec3(-1.2, 0, 0), BodyType::dynamic, Quat::identity(), m);
    t.world.set_velocity(comes, Vec3(200, 0, 0), Vec3::zero());
    t.run(1, kDt);
    assert_true(t.world.asleep(rests) == !in_the_way);
    if (!in_the_way) continue;
    // Equal masses, head on: they change places after 1 m.
    assert_true(std::fabs(t.world.state.x[rests].x() - (kDt * 200 - 1)) < 1e-9 * 200);
    assert_true(std::fabs(t.world.state.x[comes].x() + 0.2) < 1e-9 * 200);
  }
}

static void events_tell_of_hits(void**) {
  for (const Real speed : {200.0, 0.9 * 200}) {
    Range t(speed);
    collect(t.world, Events::contact, 190);
    t.run(1, kDt);
    const Array<ContactEvent>& told = t.world.events->contacts;
    assert_int_equal(told.size(), speed > 190 ? 2 : 1);
    assert_int_equal(told[0].kind, ContactEvent::begin);
    if (speed > 190) assert_int_equal(told[1].kind, ContactEvent::hit);
    const ContactEvent& e = told.back();
    assert_true(std::fabs(e.impulse - 2 * speed * t.world.scene.mass[t.ball]) < 1e-9 * e.impulse);
    assert_true(std::fabs(e.speed - speed) < 1e-9 * speed);
    assert_true((e.point - Vec3(-0.005, 0, 0)).norm() < 1e-8);
    // From A, the lower slot, to B: the wall was first.
    assert_true((e.normal - Vec3(-1, 0, 0)).norm() < 1e-8);
    t.run(1, kDt);
    assert_int_equal(told.size(), 1);
    assert_int_equal(told[0].kind, ContactEvent::end);
  }
}

// A kinematic bat comes at a ball at rest: it is thrown ahead, and the bat goes on as if nothing were there.
static void a_bat_that_is_fast_hits(void**) {
  for (const Real e : {0.0, 1.0}) {
    TestWorld t(Vec3::zero());
    const std::uint32_t m = t.material(0, e);
    const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3::zero(), BodyType::dynamic, Quat::identity(), m);
    const std::uint32_t bat =
        t.add(t.keep(box(Vec3(0.01, 0.3, 0.3))), Vec3(-1.11, 0, 0), BodyType::kinematic, Quat::identity(), m);
    t.world.set_velocity(bat, Vec3(100, 0, 0), Vec3::zero());
    t.run(1, kDt);
    const Real rest = kDt - 1 / 100.0, v = (1 + e) * 100;
    assert_true(std::fabs(t.world.state.x[bat].x() - (100 * kDt - 1.11)) < 1e-13);
    assert_true(std::fabs(t.world.state.v[ball].x() - v) < 1e-8 * v);
    assert_true(std::fabs(t.world.state.x[ball].x() - v * rest) < 1e-8);
  }
}

// What it hits can't give way along its path, or not at all: it stays where it is, and finite.
static void what_is_hit_along_its_locks_stays(void**) {
  for (const Locks locks : {Locks(kLinearLocks), Locks(1), Locks(kAllLocks)})
    for (const Real friction : {0.0, 0.5})
      for (const Real e : {0.0, 1.0}) {
        TestWorld t(Vec3::zero());
        const std::uint32_t m = t.material(friction, e);
        const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3::zero(), BodyType::dynamic, Quat::identity(), m);
        t.world.set_attribute(ball, AttributeId::locks, {Real(locks)});
        const std::uint32_t bat =
            t.add(t.keep(box(Vec3(0.01, 0.3, 0.3))), Vec3(-1.11, 0, 0), BodyType::kinematic, Quat::identity(), m);
        t.world.set_velocity(bat, Vec3(100, 0, 0), Vec3::zero());
        t.run(1, kDt);
        assert_int_equal(t.world.report.quarantined_bodies, 0);
        assert_true(t.world.report.sweep_hits > 0);
        assert_true(t.world.state.x[ball] == Vec3::zero() && t.world.state.v[ball] == Vec3::zero());
      }
}

// What a ball hits is swept itself from then on: a light ball behind it does not leave through the wall behind.
static void who_is_hit_is_swept_too(void**) {
  for (int k = 0; k < 8; ++k) {
    Range t(0, 0.5);
    const Shape* heavy = t.keep(sphere(0.2));
    t.world.set_velocity(t.ball, Vec3::zero(), Vec3::zero());
    const std::uint32_t hammer = t.add(heavy, Vec3(-2 - 0.3 * k, 0, 0));
    t.world.set_velocity(hammer, Vec3(300, 0, 0), Vec3::zero());
    for (int i = 0; i < 10; ++i) {
      t.world.step(kDt);
      assert_true(!t.passed() && t.world.state.x[hammer].x() < 0);
    }
    assert_true(t.world.state.v[hammer].x() < 300);
  }
}

// A support function that fails while it is swept disables its shape and moves nobody out of the world.
static void a_shape_that_misbehaves_is_disabled(void**) {
  static int calls, patience;
  calls = 0, patience = 1 << 30;
  const SupportFn tired = [](void* user, const double* p, std::uint64_t n, const double d[3],
                             double out[3]) -> std::int32_t {
    if (++calls > patience) return 1;
    return box_support(user, p, n, d, out);
  };
  for (int after = 0; after < 60; after += 3) {
    Range t;
    Shape odd = make_shape(Form::none, tired, {0.1, 0.1, 0.1}, Vec3::constant(0.1), 0.174);
    patience = 1 << 30;
    const std::uint32_t body = t.add(nullptr, Vec3(-1, 0.5, 0));
    t.world.add_collider(body, t.keep(std::move(odd)), Pose{}, 0, Colliders::kNoMaterial);
    t.world.set_velocity(body, Vec3(200, 0, 0), Vec3::zero());
    calls = 0, patience = after;
    std::size_t faults = 0;
    for (int i = 0; i < 4; ++i) t.world.step(kDt), faults += t.world.fault_views.size();
    assert_true(faults <= 1 && finite(t.world.state.x[body]));
    assert_true(faults == 1 || t.world.state.x[body].x() < 0);
    assert_false(t.passed());
  }
}

/// The k-th allocation of a step with participants fails: nobody has moved, and the next steps go as if it had not.
static void running_out_of_memory_moves_nobody(void**) {
  struct Failing : std::pmr::memory_resource {
    std::uint64_t calls = 0, fail_at = ~std::uint64_t{0};
    void* do_allocate(std::size_t bytes, std::size_t align) override {
      if (calls++ == fail_at) throw std::bad_alloc();
      return std::pmr::new_delete_resource()->allocate(bytes, align);
    }
    void do_deallocate(void* p, std::size_t bytes, std::size_t align) override {
      std::pmr::new_delete_resource()->deallocate(p, bytes, align);
    }
    bool do_is_equal(const memory_resource& o) const noexcept override { return this == &o; }
  };
  TestWorld shapes;
  const Shape *ball = shapes.keep(sphere(0.1)), *sheet = shapes.keep(box(Vec3(0.005, 2, 2)));
  std::uint64_t failures = 0;
  for (std::uint64_t k = 0;; ++k) {
    Failing memory;
    World world(1, Vec3::zero(), 0, &memory);
    const auto add = [&](const Shape* shape, const Vec3& p, BodyType type) {
      BodyDef def;
      def.type = type;
      def.pose.p = p;
      const std::uint32_t body = handle_slot(world.add_body(def));
      world.add_collider(body, shape, Pose{}, 1000, Colliders::kNoMaterial);
      return body;
    };
    add(sheet, Vec3::zero(), BodyType::fixed);
    const std::uint32_t bullet = add(ball, Vec3(-1, 0, 0), BodyType::dynamic);
    add(ball, Vec3(-0.3, 0.05, 0), BodyType::dynamic);
    world.step(kDt);
    world.set_velocity(bullet, Vec3(200, 0, 0), Vec3::zero());
    memory.fail_at = memory.calls + k;
    bool failed = false;
    try {
      world.step(kDt);
    } catch (const std::bad_alloc&) {
      failed = true;
      assert_true(world.state.x[bullet] == Vec3(-1, 0, 0));
      world.step(kDt);
    }
    assert_true(world.report.sweep_hits > 0 && world.state.x[bullet].x() < -0.1 && world.state.x[bullet].x() > -1);
    failures += failed;
    if (!failed) break;
  }
  assert_true(failures > 5);
}

/// Fast balls, boxes and spinning rods among slow ones in a walled room: whatever can meet meets.
static std::uint64_t skirmish(int broad, std::uint32_t threads, Real sleep) {
  TestWorld t;
  JobPool pool(
      threads, [] {}, std::pmr::new_delete_resource());
  if (threads > 1) t.world.jobs = &pool;
  t.world.set_dial(Dial::broad_phase, broad);
  t.world.set_dial(Dial::sleep, sleep);
  const std::uint32_t m = t.material(0.3, 0.8);
  for (int k = 0; k < 6; ++k) {
    Vec3 half = Vec3::constant(3.01), at = Vec3::zero();
    half[k / 2] = 0.01, at[k / 2] = k % 2 ? 3.01 : -3.01;
    t.add(t.keep(box(half)), at, BodyType::fixed, Quat::identity(), m);
  }
  Random random(3);
  const Shape* shapes[] = {t.keep(sphere(0.1)), t.keep(box(Vec3(0.1, 0.2, 0.15))), t.keep(box(Vec3(0.5, 0.02, 0.02))),
                           t.keep(capsule(0.05, 0.1))};
  for (int i = 0; i < 40; ++i) {
    const std::uint32_t body =
        t.add(shapes[i % 4], 2.4 * random.in_cube(1), BodyType::dynamic, exp_map(3 * random.direction()), m);
    const Real speed = i % 3 == 0 ? 150 : 2;
    t.world.set_velocity(body, speed * random.direction(), (i % 5 == 0 ? 80 : 3) * random.direction());
  }
  std::uint64_t hits = 0;
  for (int i = 0; i < 60; ++i) {
    t.world.step(kDt);
    hits += t.world.report.sweep_hits;
    for (std::uint32_t b = 6; b < 46; ++b) assert_true(t.world.state.x[b].abs().max_entry() < 3.02);
  }
  assert_true(hits > 100);
  return t.world.hash();
}

static void the_same_bits_however_it_is_run(void**) {
  for (const Real sleep : {0.0, 1.0}) {
    const std::uint64_t first = skirmish(0, 1, sleep);
    for (const int broad : {1, 2, 3}) assert_true(skirmish(broad, 1, sleep) == first);
    for (const std::uint32_t threads : {2u, 3u}) assert_true(skirmish(0, threads, sleep) == first);
  }
}

// The tree's answer is that of going through all.
static void a_broad_phase_finds_what_is_near(void**) {
  for (int broad = 0; broad < 4; ++broad) {
    TestWorld t;
    t.world.set_dial(Dial::broad_phase, broad);
    t.ground();
    Random random(11);
    const Shape* shape = t.keep(sphere(0.3));
    for (int i = 0; i < 200; ++i) t.add(shape, 5 * random.in_cube(1), i % 3 ? BodyType::dynamic : BodyType::fixed);
    Array<std::uint32_t> found(std::pmr::new_delete_resource());
    for (int step = 0; step < 5; ++step) {
      t.run(1, kDt);
      const Colliders& c = t.world.scene.colliders;
      for (int i = 0; i < 50; ++i) {
        const Vec3 at = 6 * random.in_cube(1), half = random.uniform(0, 2) * Vec3(1, 0.5, 2);
        const Aabb box{at - half, at + half};
        found.clear();
        broad_phase(t.world, t.world.broad).find_near(c, box, found);
        std::sort(found.begin(), found.end());
        std::size_t k = 0;
        for (const std::uint32_t slot : c.live)
          if (c.bounds[slot].overlaps(box)) assert_true(k < found.size() && found[k++] == slot);
        assert_int_equal(k, found.size());
      }
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_rotation_vector_turns_as_its_quaternion),
      cmocka_unit_test(who_is_slow_pays_nothing),
      cmocka_unit_test(one_participant_is_one_participants_work),
      cmocka_unit_test(a_host_has_its_say),
      cmocka_unit_test(who_may_not_touch_is_passed),
      cmocka_unit_test(sleepers_wake_when_they_are_hit),
      cmocka_unit_test(events_tell_of_hits),
      cmocka_unit_test(a_bat_that_is_fast_hits),
      cmocka_unit_test(what_is_hit_along_its_locks_stays),
      cmocka_unit_test(who_is_hit_is_swept_too),
      cmocka_unit_test(a_shape_that_misbehaves_is_disabled),
      cmocka_unit_test(running_out_of_memory_moves_nobody),
      cmocka_unit_test(the_same_bits_however_it_is_run),
      cmocka_unit_test(a_broad_phase_finds_what_is_near),
  };
  return cmocka_run_group_tests_name("unit/dynamics/ccd", tests, nullptr, nullptr);
}

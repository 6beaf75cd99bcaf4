// Events beside closed forms: when a falling ball meets the ground and how fast, when it passes a sensor, when bodies
// sleep and wake; what is not asked for; and the same lists for any number of threads.
#include "carom_test.h"
#include "core/job_pool.h"
#include "dynamics/events/events.h"
#include "dynamics/query/query.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kDt = 1.0 / 120;

std::size_t count(const World& w, ContactEvent::Kind kind) {
  std::size_t n = 0;
  for (const ContactEvent& e : w.events->contacts) n += e.kind == kind;
  return n;
}

struct Fall : TestWorld {
  explicit Fall(Real height, Real restitution = 0) {
    const std::uint32_t m = material(0.5, restitution);
    floor = ground(m);
    ball = add(keep(sphere(0.5)), Vec3(0, 0.5 + height, 0), BodyType::dynamic, Quat::identity(), m);
  }
  std::uint32_t floor, ball;
};

}  // namespace

static void a_fall_begins_hits_and_ends(void**) {
  Fall f(2);
  collect(f.world, Events::contact, 1);
  const Real meets = std::sqrt(2 * 2 / 9.81);  // s
  int begun = 0, hit = 0;
  for (int i = 1; i <= 240; ++i) {
    f.world.step(kDt);
    for (const ContactEvent& e : f.world.events->contacts) {
      assert_true(e.kind != ContactEvent::end);
      assert_true(e.body_a == f.world.scene.bodies.handle(f.floor) && e.body_b == f.world.scene.bodies.handle(f.ball));
      // The step in which it meets: the one that ends after that moment, or the next if only rounding is left.
      assert_true(i * kDt >= meets - kDt && i * kDt <= meets + 2 * kDt);
      // It approached with g t as the step began, and was stopped: m g t, and the weight of a step.
      const Real mass = f.world.scene.mass[f.ball], speed = 9.81 * (i - 1) * kDt;
      assert_true(std::fabs(e.speed - speed) < 1e-9 * speed);
      assert_true(e.impulse > 0 && e.impulse < mass * (speed + 2 * 9.81 * kDt));
      assert_true(e.normal.y() == 1 && std::fabs(e.point.y()) < 0.1);
      begun += e.kind == ContactEvent::begin;
      hit += e.kind == ContactEvent::hit;
    }
  }
  assert_int_equal(begun, 1);
  assert_int_equal(hit, 1);  // what rests does not flicker
  f.world.set_velocity(f.ball, Vec3(0, 3, 0), Vec3::zero());
  int ended = 0;
  for (int i = 0; i < 20; ++i) {
    f.world.step(kDt);
    assert_int_equal(count(f.world, ContactEvent::begin), 0);
    ended += static_cast<int>(count(f.world, ContactEvent::end));
  }
  assert_int_equal(ended, 1);
}

static void each_bounce_is_a_hit_until_it_is_slow(void**) {
  // At restitution e the k-th impact comes with e^k sqrt(2 g h): hits are those above 2 m/s.
  const Real e = 0.8, first = std::sqrt(2 * 9.81 * 2);
  Fall f(2, e);
  collect(f.world, Events::contact, 2);
  std::vector<Real> speeds;
  for (int i = 0; i < 120 * 8; ++i) {
    f.world.step(kDt);
    for (const ContactEvent& x : f.world.events->contacts)
      if (x.kind == ContactEvent::hit) speeds.push_back(x.speed);
  }
  std::size_t expected = 0;
  for (Real v = first; v > 2 * 1.06; v *= e) ++expected;
  assert_int_equal(speeds.size(), expected);
  for (std::size_t k = 0; k < speeds.size(); ++k)  // measured as the step began, at most a step's gravity before
    assert_true(std::fabs(speeds[k] - first * std::pow(e, Real(k))) < 1.01 * 9.81 * kDt + 0.02);
}

static void what_is_gone_ends(void**) {
  for (int how = 0; how < 3; ++how) {
    Fall f(0.001);
    collect(f.world, Events::contact, 1);
    f.run(10, kDt);
    assert_int_equal(f.world.events->touching.size(), 1);
    const Handle body = f.world.scene.bodies.handle(f.ball);
    if (how == 0) f.world.remove_body(f.ball);
    if (how == 1) f.world.ignore_collision(f.ball, f.floor);
    if (how == 2) {  // another takes its place, in the same slots
      f.world.remove_body(f.ball);
      assert_int_equal(f.add(f.keep(sphere(0.5)), Vec3(0, 0.499, 0)), f.ball);
    }
    f.world.step(kDt);
    const Array<ContactEvent>& told = f.world.events->contacts;
    assert_int_equal(told.size(), how == 2 ? 2 : 1);
    assert_true(told[0].kind == ContactEvent::end && told[0].body_b == body);
    if (how == 2) assert_true(told[1].kind == ContactEvent::begin && told[1].body_b != body);
  }
}

static void sleepers_stay_in_touch_and_are_told_of(void**) {
  Fall f(0.001);
  f.world.set_dial(Dial::sleep, 1);
  const std::uint32_t other = f.add(f.keep(sphere(0.5)), Vec3(0, 30, 0));
  collect(f.world, Events::every, 1);
  int asleep = 0, awake = 0, ends = 0, begins = 0;
  Real time = 0;
  for (int i = 0; i < 1200 && awake == 0; ++i) {
    f.world.step(kDt);
    time += kDt;
    ends += static_cast<int>(count(f.world, ContactEvent::end));
    begins += static_cast<int>(count(f.world, ContactEvent::begin));
    for (const SleepEvent& e : f.world.events->sleep) {
      if (e.body != f.world.scene.bodies.handle(f.ball)) continue;
      assert_true(e.woke == f.world.asleep(f.ball) ? false : true);
      (e.woke ? awake : asleep) += 1;
    }
  }
  (void)other;
  assert_int_equal(asleep, 1);
  assert_int_equal(awake, 1);  // the other one fell on it
  assert_true(std::fabs(time - std::sqrt(2 * 28.5 / 9.81)) < 0.1);
  assert_int_equal(ends, 0);
  assert_true(begins >= 1 && begins <= 2);
}

static void a_sensor_tells_who_passes_and_stops_nobody(void**) {
  // A ball of radius 0.5 falls through a slab 4 to 6 m below it: enters when it has come 4 - 0.5, leaves after 6 + 0.5.
  for (int broad = 0; broad < 4; ++broad) {
    TestWorld t, alone;
    t.world.set_dial(Dial::broad_phase, broad);
    alone.world.set_dial(Dial::broad_phase, broad);
    const Shape* slab = t.keep(box(Vec3(3, 1, 3)));
    const std::uint32_t gate = t.add(slab, Vec3(0, -5, 0), BodyType::fixed);
    t.world.set_sensor(t.world.scene.first_collider[gate], true);
    const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3::zero());
    const std::uint32_t twin = alone.add(alone.keep(sphere(0.5)), Vec3::zero());
    collect(t.world, Events::sensor, 1);
    std::vector<int> entered, left;
    for (int i = 1; i <= 180; ++i) {
      t.world.step(kDt), alone.world.step(kDt);
      for (const SensorEvent& e : t.world.events->sensors) {
        assert_true(e.sensor_body == t.world.scene.bodies.handle(gate) &&
                    e.other_body == t.world.scene.bodies.handle(ball));
        (e.entered ? entered : left).push_back(i);
      }
      // Substeps, for contacts that may be, and one step for a world that can have none: the same to rounding.
      assert_true((t.world.state.x[ball] - alone.world.state.x[twin]).norm() < 1e-12);
      assert_int_equal(t.world.report.contact_points, 0);
    }
    assert_true(entered.size() == 1 && left.size() == 1);
    // The first step whose end is within: velocity Verlet falls as the closed form does.
    assert_int_equal(entered[0], static_cast<int>(std::ceil(std::sqrt(2 * 3.5 / 9.81) / kDt)));
    assert_int_equal(left[0], static_cast<int>(std::ceil(std::sqrt(2 * 6.5 / 9.81) / kDt)));
    // Rays pass it unless they ask.
    const Ray down{Vec3(0, 0, 0), Vec3(0, -1, 0), 10};
    QueryOptions options;
    options.filter.ignore = ball;
    assert_int_equal(cast_ray(t.world, down, options).collider, kInvalid);
    options.filter.sensors = true;
    assert_true(std::fabs(cast_ray(t.world, down, options).cast.time - 4) < 1e-9);
  }
}

static void sensors_and_sleepers(void**) {
  TestWorld t;
  t.world.set_dial(Dial::sleep, 1);
  t.ground();
  const Shape* zone = t.keep(box(Vec3(2, 1, 2)));
  const std::uint32_t gate = t.add(zone, Vec3(0, 1, 0), BodyType::fixed);
  t.world.set_sensor(t.world.scene.first_collider[gate], true);
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0));
  collect(t.world, Events::every, 1);
  int entered = 0, left = 0, fell = 0;
  const auto step = [&](int n) {
    for (int i = 0; i < n; ++i) {
      t.world.step(kDt);
      for (const SensorEvent& e : t.world.events->sensors) (e.entered ? entered : left) += 1;
      for (const SleepEvent& e : t.world.events->sleep) fell += !e.woke;
    }
  };
  step(240);
  assert_true(entered == 1 && left == 0 && fell == 1 && t.world.asleep(ball));
  // Moved away from the sleeper, and back over it: it is told of, and sleeps on.
  t.world.set_pose(gate, {Quat::identity(), Vec3(20, 1, 0)});
  step(2);
  assert_true(entered == 1 && left == 1 && t.world.asleep(ball));
  t.world.set_pose(gate, {Quat::identity(), Vec3(0, 1, 0)});
  step(2);
  assert_true(entered == 2 && left == 1 && t.world.asleep(ball));
  // A sensor no longer: what was within leaves.
  t.world.set_sensor(t.world.scene.first_collider[gate], false);
  step(1);
  assert_int_equal(left, 2);
}

/// A gate that a bullet is past within a step, at any phase of it: it enters and leaves, once; where a wall turns it round,
/// between two steps or in the middle of one, it is heard on the way there and back.
static void a_sensor_hears_what_passes_it_swept(void**) {
  for (const bool wall : {false, true})
    for (const Real thin : {1e-3, 0.05})
      for (int phase = 0; phase < 12; ++phase) {
        TestWorld t(Vec3::zero());
        const std::uint32_t m = t.material(0, 1);
        const std::uint32_t gate = t.add(t.keep(box(Vec3(thin, 2, 2))), Vec3::zero(), BodyType::fixed);
        t.world.set_sensor(t.world.scene.first_collider[gate], true);
        const std::uint32_t aside = t.add(t.keep(box(Vec3(thin, 2, 2))), Vec3(0, 10, 0), BodyType::fixed);
        t.world.set_sensor(t.world.scene.first_collider[aside], true);
        if (wall) t.add(t.keep(box(Vec3(0.1, 5, 5))), Vec3(1.3, 0, 0), BodyType::fixed, Quat::identity(), m);
        const std::uint32_t bullet =
            t.add(t.keep(sphere(0.05)), Vec3(-5 - 0.2 * phase, 0, 0), BodyType::dynamic, Quat::identity(), m);
        t.world.set_velocity(bullet, Vec3(300, 0, 0), Vec3::zero());
        collect(t.world, Events::sensor, 1);
        int entered = 0, left = 0;
        for (int i = 0; i < 12; ++i) {
          t.run(1, kDt);
          for (const SensorEvent& e : t.world.events->sensors) {
            assert_true(e.sensor_body == t.world.scene.bodies.handle(gate));
            assert_true(e.other_body == t.world.scene.bodies.handle(bullet));
            (e.entered ? entered : left) += 1;
            assert_true(entered == left || entered == left + 1);
          }
        }
        assert_int_equal(entered, left);
        // There and back within one step is heard once: a step tells whether, not how often.
        assert_true(entered >= 1 && entered <= (wall ? 2 : 1));
        assert_true(wall == (t.world.state.v[bullet].x() < 0));
      }
}

static void nobody_asked_nothing_kept(void**) {
  Fall f(0.1);
  const std::uint32_t gate = f.add(f.keep(box(Vec3(2, 1, 2))), Vec3(0, 1, 0), BodyType::fixed);
  f.world.set_sensor(f.world.scene.first_collider[gate], true);
  f.run(60, kDt);
  const Events& e = *f.world.events;
  assert_true(e.contacts.empty() && e.sensors.empty() && e.sleep.empty() && e.touching.empty() && e.within.empty());
  assert_true(e.spare.capacity() == 0 && e.approach.capacity() == 0 && e.sensor_pairs.capacity() == 0);
  // Asked for and no longer.
  collect(f.world, Events::every, 0);
  f.world.step(kDt);
  assert_true(!e.contacts.empty() && !e.sensors.empty());
  collect(f.world, 0, 0);
  assert_true(e.contacts.empty() && e.sensors.empty());
  f.world.step(kDt);
  assert_true(e.contacts.empty() && e.sensors.empty());
}

static void observing_changes_nothing_and_threads_nothing(void**) {
  const std::size_t bodies = sliced<std::size_t>(300, 300, 60);
  const auto run = [bodies](std::uint32_t kinds, std::uint32_t threads, std::vector<Real>& told) {
    TestWorld t;
    JobPool pool(
        threads, [] {}, std::pmr::new_delete_resource());
    if (threads > 1) t.world.jobs = &pool;
    t.world.set_dial(Dial::sleep, 1);
    t.ground();
    const Shape *ball = t.keep(sphere(0.5)), *crate = t.keep(box(Vec3(0.5, 0.5, 0.5)));
    Random random(3);
    for (std::size_t i = 0; i < bodies; ++i)
      t.add(i % 2 ? ball : crate, random.in_cube(4) + Vec3(0, 6, 0), BodyType::dynamic);
    collect(t.world, kinds, 0.5);
    for (int i = 0; i < 60; ++i) {
      t.world.step(1.0 / 60);
      for (const ContactEvent& e : t.world.events->contacts) {
        told.insert(told.end(), {Real(e.kind), Real(handle_slot(e.collider_a)), Real(handle_slot(e.collider_b)),
                                 e.impulse, e.speed, e.point.x(), e.normal.z()});
      }
    }
    return t.world.hash();
  };
  std::vector<Real> none, one, four;
  const std::uint64_t hash = run(0, 1, none);
  assert_true(run(Events::every, 1, one) == hash);
  assert_true(run(Events::every, 4, four) == hash);
  assert_true(none.empty() && one.size() > 7 * bodies && one == four);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_fall_begins_hits_and_ends),
      cmocka_unit_test(each_bounce_is_a_hit_until_it_is_slow),
      cmocka_unit_test(what_is_gone_ends),
      cmocka_unit_test(sleepers_stay_in_touch_and_are_told_of),
      cmocka_unit_test(a_sensor_tells_who_passes_and_stops_nobody),
      cmocka_unit_test(sensors_and_sleepers),
      cmocka_unit_test(a_sensor_hears_what_passes_it_swept),
      cmocka_unit_test(nobody_asked_nothing_kept),
      cmocka_unit_test(observing_changes_nothing_and_threads_nothing),
  };
  return cmocka_run_group_tests_name("unit/dynamics/events", tests, nullptr, nullptr);
}

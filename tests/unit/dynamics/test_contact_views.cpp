// Contact views: made for the first who asks, whatever was done to the world since the step, and whoever asks with him.
#include <cstring>
#include <thread>

#include "carom_test.h"
#include "dynamics/contact_views.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Boxes on each other and on a platform that moves, after some steps; nobody has asked for contacts yet.
struct Heap {
  TestWorld t;
  std::vector<std::uint32_t> bodies;
  std::uint32_t ground, platform;
  explicit Heap(Real solver)
      : ground(t.ground()), platform(t.add(t.keep(box(Vec3(3, 0.1, 3))), Vec3(0, 0.1, 0), BodyType::kinematic)) {
    t.world.set_dial(Dial::solver, solver);
    t.world.set_velocity(platform, Vec3(0.1, 0, 0), Vec3::zero());
    for (int i = 0; i < 12; ++i)
      bodies.push_back(t.add(t.keep(box(Vec3::constant(0.25))), Vec3(0.6 * (i % 3), 0.5 + 0.51 * (i / 3), 0.01 * i)));
    bodies.push_back(t.add(t.keep(sphere(0.3)), Vec3(-6, 0.3, 0)));
    t.run(40, 1.0 / 60);
  }
  World* operator->() { return &t.world; }
};

bool same(const Array<ContactView>& a, const Array<ContactView>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].collider_a != b[i].collider_a || a[i].collider_b != b[i].collider_b || a[i].point != b[i].point ||
        a[i].normal != b[i].normal || a[i].separation != b[i].separation ||
        a[i].normal_impulse != b[i].normal_impulse || a[i].friction_impulse != b[i].friction_impulse)
      return false;
  return true;
}

void what_was_done_since_the_step_does_not_show(void**) {
  for (const Real solver : {kSeverityChoice, kSoftChoice, kDirectChoice, kAutoChoice}) {
    Heap at_once(solver);
    const Array<ContactView>& seen = at_once->contact_views();
    assert_true(seen.size() > 30);
    const std::vector<void (*)(Heap&)> edits = {
        [](Heap& h) {
          h->set_pose(h.bodies[2], Pose{Quat::identity(), Vec3(0, 9, 0)});
        },
        [](Heap& h) {
          h->set_pose(h.platform, Pose{Quat::identity(), Vec3(0, -2, 0)});
        },
        [](Heap& h) {
          h->set_pose(h.ground, Pose{exp_map(Vec3(0.1, 0, 0)), Vec3(0, 0.1, 0)});
        },
        [](Heap& h) {
          h->add_collider(h.bodies[4], h.t.keep(sphere(0.5)), Pose{Quat::identity(), Vec3(1, 0, 0)}, 1000,
                          Colliders::kNoMaterial);
        },
        [](Heap& h) { h->set_velocity(h.bodies[5], Vec3(7, 7, 7), Vec3(1, 2, 3)); },
        [](Heap& h) { h.t.add(h.t.keep(box(Vec3::constant(0.3))), Vec3(0, 3, 0)); },
        [](Heap& h) { h->set_dial(Dial::manifold, 0); },
    };
    for (const auto edit : edits) {
      Heap later(solver);
      edit(later);
      assert_true(same(later->contact_views(), seen));
    }
  }
}

void those_of_a_collider_that_has_gone_go_with_it(void**) {
  Heap whole(kAutoChoice), less(kAutoChoice);
  const std::uint32_t gone = less->scene.first_collider[less.bodies[1]];
  std::vector<ContactView> stay;
  for (const ContactView& v : whole->contact_views())
    if (v.collider_a != gone && v.collider_b != gone) stay.push_back(v);
  assert_true(stay.size() < whole->contact_views().size());
  less->remove_collider(gone);
  Array<ContactView> expected(std::pmr::new_delete_resource());
  expected.assign(stay.begin(), stay.end());
  assert_true(same(less->contact_views(), expected));
}

void there_are_none_before_a_step_nor_after_one_without(void**) {
  TestWorld t;
  assert_true(t.world.contact_views().empty());
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0));
  t.ground();
  t.run(1, 1.0 / 60);
  assert_int_equal(t.world.contact_views().size(), 1);
  t.world.set_pose(ball, Pose{Quat::identity(), Vec3(0, 50, 0)});
  assert_int_equal(t.world.contact_views().size(), 1);
  t.run(1, 1.0 / 60);
  assert_true(t.world.contact_views().empty());
}

void readers_may_all_come_first(void**) {
  const Heap once(kSoftChoice);
  for (int k = 0; k < 20; ++k) {
    Heap heap(kSoftChoice);
    const World& world = heap.t.world;
    bool good[4] = {};
    std::vector<std::thread> readers;
    for (bool& g : good) readers.emplace_back([&] { g = same(world.contact_views(), once.t.world.contact_views()); });
    for (std::thread& r : readers) r.join();
    for (const bool g : good) assert_true(g);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_was_done_since_the_step_does_not_show),
      cmocka_unit_test(those_of_a_collider_that_has_gone_go_with_it),
      cmocka_unit_test(there_are_none_before_a_step_nor_after_one_without),
      cmocka_unit_test(readers_may_all_come_first),
  };
  return cmocka_run_group_tests_name("dynamics/contact_views", tests, nullptr, nullptr);
}

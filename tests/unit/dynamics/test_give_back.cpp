// Memory that was laid out for many contacts goes back once bodies have slept for a while, and no bit depends on it.
#include <functional>
#include <memory_resource>
#include <vector>

#include "carom_test.h"
#include "dynamics/contact/contact.h"
#include "dynamics/give_back.h"
#include "dynamics/sleep/sleep.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

class CountedMemory final : public std::pmr::memory_resource {
 public:
  std::size_t bytes = 0;

 private:
  void* do_allocate(std::size_t n, std::size_t alignment) override {
    void* const p = std::pmr::new_delete_resource()->allocate(n, alignment);
    bytes += n;
    return p;
  }
  void do_deallocate(void* p, std::size_t n, std::size_t alignment) override {
    bytes -= n;
    std::pmr::new_delete_resource()->deallocate(p, n, alignment);
  }
  bool do_is_equal(const memory_resource& o) const noexcept override { return this == &o; }
};

/// Towers of cubes far from each other, which come to rest; and, if asked for, a ball that slides on for ever.
struct Towers {
  Towers(int towers, int cubes, Real solver, bool with_ball, bool is_joined = false)
      : world(1, Vec3(0, -9.81, 0), 0, &memory) {
    world.set_dial(Dial::sleep, 1), world.set_dial(Dial::solver, solver), world.set_dial(Dial::substeps, 4);
    Material smooth;
    smooth.friction = 0;
    add(&ground.shapes.front(), Vec3::zero(), BodyType::fixed, handle_slot(world.add_material(Material())));
    for (int i = 0; i < towers; ++i)
      for (int k = 0; k < cubes; ++k) bodies.push_back(add(cube, Vec3(3 * (i % 40), k + 0.5, 3 * (i / 40))));
    for (std::size_t i = 0; is_joined && i + 1 < bodies.size(); ++i)
      if (static_cast<int>(i + 1) % cubes > 0) {
        JointDef def;
        def.kind = JointKind::ball, def.body_a = bodies[i], def.body_b = bodies[i + 1];
        def.frame_a.p = Vec3(0, 0.5, 0), def.frame_b.p = Vec3(0, -0.5, 0);
        world.add_joint(def);
      }
    if (!with_ball) return;
    ball = add(globe, Vec3(-5, 0.5, 0), BodyType::dynamic, handle_slot(world.add_material(smooth)));
    world.set_velocity(ball, Vec3(-1, 0, 0), Vec3::zero());
  }
  std::uint32_t add(const Shape* shape, const Vec3& at, BodyType type = BodyType::dynamic,
                    std::uint32_t material = Colliders::kNoMaterial) {
    BodyDef def;
    def.type = type, def.pose = {Quat::identity(), at};
    const std::uint32_t body = handle_slot(world.add_body(def));
    world.add_collider(body, shape, Pose{}, 1000, material);
    return body;
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) world.step(kStep);
  }
  bool all_sleep() const {
    return std::all_of(bodies.begin(), bodies.end(), [&](std::uint32_t body) { return world.asleep(body); });
  }
  void fall_asleep() {
    for (int i = 0; i < 900 && !all_sleep(); ++i) run(1);
    assert_true(all_sleep());
  }

  CountedMemory memory;
  TestWorld ground;  // owns shapes
  World world;
  const Shape *cube = (ground.ground(), ground.keep(box(Vec3::constant(0.5)))), *globe = ground.keep(sphere(0.5));
  std::vector<std::uint32_t> bodies;
  std::uint32_t ball = kInvalid;
};

void wake_up(Towers& t) {
  for (const std::uint32_t body : t.bodies) t.world.wake_body(body);
}

/// Poses and velocities of those that slept are the same, whether they slept for a moment or until memory went back.
void compare(int towers, int cubes, Real solver, bool with_ball, bool is_joined = false) {
  Towers moment(towers, cubes, solver, with_ball, is_joined), long_since(towers, cubes, solver, with_ball, is_joined);
  moment.fall_asleep(), long_since.fall_asleep();
  const std::size_t before = long_since.memory.bytes, room = long_since.world.contacts->rows.capacity();
  assert_true(room > kRowsKept + 4);
  long_since.run(static_cast<int>(kStepsBeforeGivingBack) + 2);
  assert_true(long_since.all_sleep());
  assert_true(long_since.world.contacts->rows.capacity() <= kRowsKept);
  assert_true(before - long_since.memory.bytes >= (room - kRowsKept) * (sizeof(Row) + sizeof(RowGeometry)));
  wake_up(moment), wake_up(long_since);
  moment.run(40), long_since.run(40);
  const State &a = moment.world.state, &b = long_since.world.state;
  for (const std::uint32_t i : moment.bodies)
    assert_true(a.x[i] == b.x[i] && a.q[i] == b.q[i] && a.v[i] == b.v[i] && a.omega[i] == b.omega[i]);
}

}  // namespace

static void memory_of_sleepers_goes_back(void**) { compare(400, 1, kAutoChoice, false); }
static void of_towers_too(void**) { compare(90, 4, kAutoChoice, false); }
static void under_soft_contacts_too(void**) { compare(300, 2, kSoftChoice, false); }
static void under_the_direct_solver_too(void**) { compare(350, 1, kDirectChoice, false); }
static void while_somebody_is_awake(void**) { compare(400, 1, kAutoChoice, true); }

static void joints_wake_up_in_new_lanes(void**) {
  compare(400, 2, kSoftChoice, false, true);
  compare(400, 2, kAutoChoice, false, true);
}

static void a_small_world_keeps_its_memory(void**) {
  Towers t(20, 3, kAutoChoice, false);
  t.fall_asleep();
  t.run(2);  // lists of who fell asleep are settled
  const std::size_t room = t.world.contacts->rows.capacity(), bytes = t.memory.bytes;
  t.run(3 * static_cast<int>(kStepsBeforeGivingBack));
  assert_true(t.world.contacts->rows.capacity() == room && t.memory.bytes == bytes);
}

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(memory_of_sleepers_goes_back),   cmocka_unit_test(of_towers_too),
      cmocka_unit_test(under_soft_contacts_too),        cmocka_unit_test(under_the_direct_solver_too),
      cmocka_unit_test(while_somebody_is_awake),        cmocka_unit_test(joints_wake_up_in_new_lanes),
      cmocka_unit_test(a_small_world_keeps_its_memory),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

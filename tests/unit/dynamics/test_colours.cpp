// Colours of rows: whoever shares one, joint or contact, moves nobody else of it; so a sweep that does a colour's rows
// at once, on any number of threads, does what one after the other would.
#include <array>

#include "carom_test.h"
#include "dynamics/joint/wide_joints.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kJoined = 40, kLoad = 45;  // more than kColours together

/// A hub to which many balls are joined and on which many boxes lie, and beside it a table with as many boxes: the hub's
/// rows have more colours than there are, and its joints share theirs with contacts of the table.
struct Crowd : TestWorld {
  Crowd() {
    world.set_dial(Dial::solver, kSoftChoice);
    ground();
    const Shape* slab = keep(box(Vec3(5, 0.25, 5)));
    const Shape* cube = keep(box(Vec3::constant(0.2)));
    const Shape* ball = keep(sphere(0.1));
    const std::uint32_t hub = add(slab, Vec3(0, 0.25, 0));
    add(slab, Vec3(20, 0.25, 0));  // the table
    for (int i = 0; i < kJoined; ++i) {
      const Vec3 at(0.24 * i - 4.7, 0.25, 5.3);
      JointDef def;
      def.body_a = hub, def.body_b = add(ball, at);
      def.frame_a = {Quat::identity(), Vec3(at.x(), 0, 5)};
      def.frame_b = {Quat::identity(), Vec3(0, 0, -0.3)};
      world.add_joint(def);
    }
    for (int i = 0; i < kLoad; ++i) {
      const Vec3 at((i % 9) - 4.0, 0.7, (i / 9) - 2.0);
      add(cube, at + Vec3(20, 0, 0));
      add(cube, at);
    }
  }
};

std::uint32_t first_joint_of(const WideJoints& w, std::uint32_t colour) {
  if (w.colours.empty()) return 0;
  return colour == 0 ? 0 : w.colours[std::min<std::size_t>(colour, w.colours.size()) - 1];
}

// No body that moves is in two rows of a colour, and a row is in one place alone.
void rows_of_a_colour_share_nobody(void**) {
  Crowd t;
  t.run(3, 1.0 / 60);
  const WideContacts& contacts = *t.world.wide;
  const WideJoints& joints = *t.world.wide_joints;
  assert_false(contacts.is_float);
  int with_both = 0;
  std::size_t seen_joints = 0, seen_pairs = 0;
  for (std::uint32_t colour = 0; colour < kColours; ++colour) {
    std::vector<int> times(contacts.slot.size(), 0);
    std::size_t in_joints = 0, in_pairs = 0;
    const auto see = [&](const auto& lanes, int lane) {
      for (const std::uint32_t body : {lanes.a[lane], lanes.b[lane]})
        if (body >= contacts.first_moved) assert_int_equal(times[body]++, 0);
    };
    for (std::uint32_t k = first_joint_of(joints, colour); k < first_joint_of(joints, colour + 1); ++k)
      for (std::uint32_t lane = 0; lane < joints.joints[k].occupied; ++lane, ++in_joints)
        see(joints.joints[k], static_cast<int>(lane));
    for (std::uint32_t k = contacts.first_of(colour); k < contacts.first_of(colour + 1); ++k)
      for (int lane = 0; lane < kLanes; ++lane) {
        const auto& pair = contacts.in_double.pairs[k];
        if (contacts.occupant[k * kLanes + static_cast<std::uint32_t>(lane)] == 0xFFFFFFFFu) continue;
        see(pair, lane), ++in_pairs;
      }
    with_both += in_joints > 0 && in_pairs > 0;
    seen_joints += in_joints, seen_pairs += in_pairs;
  }
  assert_int_equal(seen_joints, kJoined);
  // Joints leave the hub fewer colours than it has neighbours, its load and the ground: the rest stand alone.
  constexpr std::size_t kAlone = kLoad + 1 - (kColours - kJoined);
  assert_int_equal(seen_pairs, contacts.manifolds.size() - kAlone);
  assert_true(with_both >= kJoined + kLoad - static_cast<int>(kColours));
}

// Joints keep their colours from step to step, whatever contacts come and go.
void joints_keep_their_colours(void**) {
  Crowd t;
  t.run(1, 1.0 / 60);
  const WideJoints& joints = *t.world.wide_joints;
  const std::vector<std::uint32_t> before(joints.occupant.begin(), joints.occupant.end());
  const std::size_t contacts = t.world.wide->manifolds.size();
  for (std::uint32_t i = 0; i < t.world.scene.bodies.slots(); ++i)
    if (t.world.scene.mass[i] < 100) t.world.set_velocity(i, Vec3(0, 3, 0), Vec3::zero());
  t.run(10, 1.0 / 60);
  assert_true(t.world.wide->manifolds.size() < contacts);
  assert_true(std::ranges::equal(joints.occupant, before));
}

void the_outcome_does_not_depend_on_threads(void**) {
  assert_true(hash_of_run<Crowd>(kSoftChoice, 1, 60) == hash_of_run<Crowd>(kSoftChoice, 3, 60));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(rows_of_a_colour_share_nobody),
      cmocka_unit_test(joints_keep_their_colours),
      cmocka_unit_test(the_outcome_does_not_depend_on_threads),
  };
  return cmocka_run_group_tests_name("unit/dynamics/colours", tests, nullptr, nullptr);
}

// Contacts in lanes: whatever registers the machine has, the bits are those of the narrowest.
#include "carom_test.h"
#include "dynamics/solver/wide_contacts.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Pairs of one to four points, some that bounce, some on a moving floor with a belt, some locked, in numbers that
/// leave lanes empty.
struct Heap {
  TestWorld t;
  const Shape* const cube = t.keep(box(Vec3::constant(0.5)));
  const Shape* const ball = t.keep(sphere(0.4));
  const Shape* const rod = t.keep(capsule(0.2, 0.5));

  Heap(std::uint32_t solver, Precision precision, const ContactKernels& kernels) {
    t.world.wide->kernels = &kernels;
    t.world.set_dial(Dial::precision, static_cast<Real>(precision));
    t.world.set_dial(Dial::solver, solver);
    t.world.set_dial(Dial::substeps, 4);
    t.ground();
    const std::uint32_t lift = t.add(t.keep(box(Vec3(5, 0.1, 5))), Vec3(0, 0.1, 0), BodyType::kinematic);
    t.world.set_velocity(lift, Vec3(0.1, 0.2, 0), Vec3(0, 0.3, 0));
    t.world.set_surface_velocity(t.world.scene.first_collider[lift], {Vec3(0.3, 0, 0.1), Vec3(0, 0.5, 0)});
    const std::uint32_t rubber = t.material(0.3, 0.7);
    for (int i = 0; i < 8; ++i)  // more than few, or auto has none in lanes
      for (int k = 0; k < 8 - i; ++k) t.add(cube, Vec3(k + 0.5 * i - 3.5, 0.7 + i, 0.01 * k));
    for (int i = 0; i < 7; ++i) t.add(ball, Vec3(i - 3, 3 + 0.3 * i, 1.2), BodyType::dynamic, Quat::identity(), rubber);
    for (std::uint32_t body = 5; body < 15; body += 3)
      t.world.set_attribute(body, AttributeId::locks, {Real(body % 2 ? 0x1c : 0x09)});
    for (int i = 0; i < 3; ++i) t.add(rod, Vec3(i - 1, 2, -1.3), BodyType::dynamic, exp_map(Vec3(0.3, 0, 1.2)));
  }
};

void every_width_that_this_machine_has_gives_the_bits_of_the_baseline(void**) {
  for (const std::uint32_t solver : {kSoftChoice, kDirectChoice, kAutoChoice})
    for (const Precision precision : {Precision::in_double, Precision::in_float}) {
      if (solver == kDirectChoice && precision == Precision::in_float) continue;  // it has none
      std::uint64_t baseline = 0;
      for (const ContactKernels* kernels : all_contact_kernels()) {
        Heap heap(solver, precision, *kernels);
        heap.t.run(solver == kDirectChoice ? 12
                   : solver == kAutoChoice ? 60
                                           : 200,
                   1.0 / 60);  // the direct solver takes its time with heaps
        assert_true(heap.t.world.report.contact_points > 40);
        assert_true(heap.t.world.wide->is_float == (precision == Precision::in_float));
        const std::uint64_t hash = heap.t.world.hash();
        print_message("solver %u, %s, %s: 0x%016llx\n", solver, heap.t.world.wide->is_float ? "float" : "double",
                      kernels->name, static_cast<unsigned long long>(hash));
        if (kernels == all_contact_kernels().front()) baseline = hash;
        assert_true(hash == baseline);
      }
    }
}

void a_world_starts_with_the_widest(void**) {
  const TestWorld t;
  assert_ptr_equal(t.world.wide->kernels, all_contact_kernels().back());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_width_that_this_machine_has_gives_the_bits_of_the_baseline),
      cmocka_unit_test(a_world_starts_with_the_widest),
  };
  return cmocka_run_group_tests_name("dynamics/contact_kernels", tests, nullptr, nullptr);
}

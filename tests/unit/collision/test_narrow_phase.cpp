// The narrow phase as a whole: dispatch, records from step to step, faults, counters, allocations.
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "carom_test.h"
#include "collision/narrow/narrow_phase.h"
#include "pair_cases.h"

static bool counting = false;
static int allocations = 0;

void* operator new(std::size_t size) {
  if (counting) ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

using namespace carom;
using namespace carom::test;

namespace {

/// A table of colliders with all pairs among them.
struct Scene {
  Colliders table{std::pmr::get_default_resource()};
  Array<Pair> all;
  PairTable pairs{std::pmr::get_default_resource()};
  NarrowSettings settings;
  NarrowReport report;
  Array<SupportFault> faults;

  void add(const Shape& shape, const Frame& frame) {
    table.shape.push_back(&shape);
    table.frame.push_back(frame);
    table.travel.push_back(0);
    table.reach.push_back(0);
    const auto slot = static_cast<std::uint32_t>(table.shape.size() - 1);
    all.clear();
    for (std::uint32_t i = 0; i <= slot; ++i)
      for (std::uint32_t j = i + 1; j <= slot; ++j) all.push_back({i, j});
  }
  void step() {
    pairs.update(all);
    report = NarrowReport{};
    faults.clear();
    narrow_phase(table, settings, pairs, report, faults);
  }
};

Frame at(Real x, Real y, Real z, const Vec3& turn = Vec3::zero()) {
  return Frame(exp_map(turn).matrix(), Vec3(x, y, z));
}

bool whole(const Manifold& m) {
  for (int k = 0; k < m.count; ++k) {
    const ContactPoint& p = m.point[k];
    if (!finite(p.on_a) || !finite(p.on_b) || !finite(p.normal) || !std::isfinite(p.separation)) return false;
    if (!(std::fabs(p.normal.norm() - 1) < 16 * kEpsilon)) return false;
  }
  return true;
}

std::int32_t nan_support(void*, const double*, std::uint64_t, const double*, double* out) {
  out[0] = out[1] = out[2] = std::nan("");
  return 0;
}

}  // namespace

static void a_resting_box_keeps_its_four_points_through_a_jitter(void**) {
  const Shape ground = half_space(Vec3::unit_y(), 0), slab = box(Vec3(2, 0.5, 2)), brick = box(Vec3(0.3, 0.2, 0.4));
  for (const bool on_box : {false, true}) {
    for (const Real turn : {0.0, 0.3, 0.785398163397}) {
      Scene s;
      s.add(on_box ? slab : ground, at(0, on_box ? -0.5 : 0, 0));
      Random random(3);
      s.add(brick, at(0, 0.2, 0));
      for (std::uint32_t step = 0; step < 200; ++step) {
        // A micrometre and some ten microradians: what a solver leaves of a resting body's motion.
        s.table.place(1, at(0.1 + random.uniform(-1e-6, 1e-6), 0.2 + random.uniform(-1e-6, 1e-6), 0,
                            Vec3(0, turn, 0) + 1e-5 * random.direction()));
        s.step();
        const Manifold& m = s.pairs[0].manifold;
        assert_int_equal(m.count, 4);
        for (int k = 0; k < 4; ++k) {
          assert_int_equal(m.point[k].age, step);
          assert_true(m.point[k].normal.y() > 1 - 1e-9);
          // The lowest corner lies a jitter, and the tilt's share of half a metre, off the plane.
          assert_true(std::fabs(m.point[k].separation) < 2e-6 + 1e-5 * 1.0);
        }
      }
    }
  }
}

static void without_routines_a_rocking_box_gathers_its_corners(void**) {
  const Shape ground = half_space(Vec3::unit_y(), 0), slab = box(Vec3(2, 0.5, 2)), brick = box(Vec3(0.3, 0.2, 0.4));
  for (const bool on_box : {false, true}) {
    Scene s;
    s.settings.query.routines = false;
    s.add(on_box ? slab : ground, at(0, on_box ? -0.5 : 0, 0));
    s.add(brick, at(0, 0.2, 0));
    for (int step = 0; step < 40; ++step) {
      const SinCos round = sin_cos(1.7 * step);  // leans a little more than rounding, another way each time
      s.table.place(1, at(0, 0.2, 0, 1e-4 * Vec3(round.cos, 0, round.sin)));
      s.step();
    }
    const Manifold& m = s.pairs[0].manifold;
    assert_int_equal(m.count, 4);
    for (int k = 0; k < 4; ++k) assert_true(std::fabs(m.point[k].on_b.y() + 0.2) < 1e-6);  // on the face below
    // They carry: the hull reaches halfway to the box's narrower side in every direction.
    for (int i = 0; i < 32; ++i) {
      const SinCos u = sin_cos(i * 0.19634954084936207740);
      Real reach = -kInfinity;
      for (int k = 0; k < 4; ++k) reach = std::max(reach, u.cos * m.point[k].on_b.x() + u.sin * m.point[k].on_b.z());
      assert_true(reach > 0.15);
    }
  }
}

static void both_orders_find_the_same_points(void**) {
  Random random(5);
  NarrowSettings settings;
  settings.manifold.contact_distance = 0.5;  // wide, so that most poses touch
  for (const auto& [form_a, form_b] : kRoutinePairs) {
    for (int i = 0; i < 200; ++i) {
      const Shape a = random_shape(form_a, 1, random), b = random_shape(form_b, 1, random);
      const Frame frame_a = at(3, -2, 1, random.direction()), frame_b = frame_a * random_pose(a, b, random);
      QueryMemory memory;
      Candidates one, two;
      NarrowReport report;
      SupportFault fault;
      collide(a, frame_a, b, frame_b, settings, memory, nullptr, one, report, fault);
      collide(b, frame_b, a, frame_a, settings, memory, nullptr, two, report, fault);
      assert_int_equal(report.gjk_calls, 0);
      const Real rounding = 64 * kUnitRoundoff * (pair_size(a, b, relative(frame_a, frame_b)) + frame_a.p.norm());
      for (int k = 0; k < one.count; ++k) {
        const ContactPoint& p = one.point[k];
        const Vec3 gap = frame_b.apply(p.on_b) - frame_a.apply(p.on_a);
        assert_true(std::fabs(p.normal.dot(gap) - p.separation) <= rounding);
        assert_true(p.separation <= settings.manifold.contact_distance);
      }
      if (form_a == form_b) continue;  // equal depths may then be told apart by who is called A
      assert_int_equal(one.count, two.count);
      for (int k = 0; k < one.count; ++k) {
        assert_true(one.point[k].on_a == two.point[k].on_b && one.point[k].on_b == two.point[k].on_a);
        assert_true(one.point[k].normal == -two.point[k].normal);
        assert_true(one.point[k].separation == two.point[k].separation);
      }
    }
  }
}

static void the_generic_path_finds_what_routines_find(void**) {
  Random random(6);
  NarrowSettings with, without;
  without.query.routines = false;
  without.query.tolerance = 1e-9;
  for (const auto& [form_a, form_b] : kRoutinePairs) {
    if (form_a == Form::box && form_b == Form::box) continue;  // prefers faces: see test_pairs_box_box
    for (int i = 0; i < 300; ++i) {
      const Shape a = random_shape(form_a, 1, random), b = random_shape(form_b, 1, random);
      const Frame frame_a, frame_b = random_pose(a, b, random);
      Candidates one, two;
      NarrowReport report;
      SupportFault fault;
      for (const bool routines : {true, false}) {
        QueryMemory memory;
        collide(a, frame_a, b, frame_b, routines ? with : without, memory, nullptr, routines ? one : two, report,
                fault);
      }
      // Both stop at the contact distance; only a pair on the very limit may be seen by one of them alone.
      if (one.count == 0 || two.count == 0) {
        const Real limit = with.manifold.contact_distance;
        if (one.count > 0) assert_true(std::fabs(deepest(one)->separation - limit) < 1e-7);
        if (two.count > 0) assert_true(std::fabs(deepest(two)->separation - limit) < 1e-7);
        continue;
      }
      assert_int_equal(two.count, 1);
      // The routines' stated 4e-8 of a size of at most 6, and the generic tolerance.
      assert_true(std::fabs(deepest(one)->separation - two.point[0].separation) < 3e-7);
    }
  }
}

static void a_misbehaving_support_function_costs_its_pair_only(void**) {
  Shape broken = ellipsoid(Vec3(1, 1, 1)), poisoned = cone(1, 1);
  broken.support = failing_support;
  broken.form = Form::none;
  poisoned.support = nan_support;
  poisoned.form = Form::none;
  const Shape ground = half_space(Vec3::unit_y(), 0), ball = sphere(1);
  Scene s;
  s.add(ground, at(0, 0, 0));
  s.add(ball, at(0, 0.99, 0));
  s.add(broken, at(0.5, 0.99, 0));
  s.add(poisoned, at(0, 0.99, 0.5));
  s.step();
  for (std::size_t i = 0; i < s.pairs.size(); ++i)
    assert_int_equal(s.pairs[i].manifold.count, i == 0 ? 1 : 0);  // ground and ball
  assert_int_equal(s.faults.size(), 5);
  for (const SupportFault& f : s.faults) {
    assert_true(f.shape == &broken || f.shape == &poisoned);
    assert_int_equal(f.kind, f.shape == &broken ? SupportFault::returned : SupportFault::not_finite);
    assert_true(f.dir[0] * f.dir[0] + f.dir[1] * f.dir[1] + f.dir[2] * f.dir[2] > 0.5);
  }
  // It recovers when the function does.
  broken.support = sphere(1).support;
  broken.core_radius = 1;
  s.step();
  assert_int_equal(s.faults.size(), 3);
  assert_true(s.pairs[1].manifold.count > 0);
}

static void counters_say_which_path_was_taken(void**) {
  const Shape ground = half_space(Vec3::unit_y(), 0), ball = sphere(1), pin = cylinder(0.5, 1),
              odd = rounded_box(Vec3(1, 1, 1), 0.1);
  Scene s;
  s.add(ground, at(0, 0, 0));
  s.add(ball, at(0, 0.99, 0));
  s.step();
  assert_int_equal(s.report.gjk_calls + s.report.epa_calls + s.report.support_calls, 0);
  s.add(pin, at(1.4, 1, 0));  // deep in the ball's side, where both have no routine
  s.step();
  assert_int_equal(s.report.gjk_calls, 1);
  assert_true(s.report.support_calls > 1);
  Scene t;
  t.add(ground, at(0, 0, 0));
  t.add(odd, at(0, 1.1, 0));
  t.step();
  assert_int_equal(t.report.gjk_calls, 0);
  assert_true(t.report.support_calls > 0);
  assert_int_equal(t.pairs[0].manifold.count, 4);  // probing finds the corners of a face at once
}

static void two_half_spaces_make_no_contact(void**) {
  const Shape floor = half_space(Vec3::unit_y(), 0), wall = half_space(Vec3::unit_x(), 1);
  Scene s;
  s.add(floor, at(0, 0, 0));
  s.add(wall, at(0, 0, 0));
  for (const bool routines : {true, false}) {
    s.settings.query.routines = routines;
    s.step();
    assert_int_equal(s.pairs[0].manifold.count, 0);
    assert_int_equal(s.faults.size(), 0);
  }
}

static void poses_that_are_no_numbers_make_no_contacts(void**) {
  Random random(8);
  for (const auto& [form_a, form_b] : kRoutinePairs) {
    const Shape a = random_shape(form_a, 1, random), b = random_shape(form_b, 1, random);
    for (const Real bad : {std::nan(""), kInfinity, -kInfinity, 1e308}) {
      for (int where = 0; where < 2; ++where) {
        Scene s;
        s.add(a, at(0, 0, 0));
        s.add(b, at(0, 0.1, 0));
        if (where == 0)
          s.table.frame[1].p.x() = bad;
        else
          s.table.frame[1].r(1, 1) = bad;
        for (const bool routines : {true, false}) {
          s.settings.query.routines = routines;
          s.step();
          assert_true(whole(s.pairs[0].manifold));
        }
      }
    }
  }
}

/// Bodies that fly past each other, or into each other, with some wobble: what is left out for being out of reach would
/// have found nothing.
static void pairs_out_of_reach_are_left_alone_and_miss_no_contact(void**) {
  constexpr int kSteps = 300;
  Random random(21);
  for (const auto& [form_a, form_b] : kRoutinePairs) {
    int apart = 0, left_alone = 0, touching = 0;
    for (int i = 0; i < 12; ++i) {
      const Shape a = random_shape(form_a, 1, random), b = random_shape(form_b, 1, random);
      Scene lazy, eager;
      for (Scene* s : {&lazy, &eager}) s->add(a, at(0, 0, 0)), s->add(b, at(0, 0, 0));
      for (Scene* s : {&lazy, &eager})
        s->settings.query.routines = i % 2 == 0, s->settings.manifold.kind = ManifoldKind::clip;
      const Vec3 from = Vec3{random.uniform(-3, 3), random.uniform(0, 4), 5}, to = Vec3(random.uniform(-2, 2), -1, -4);
      const Vec3 turn = random.direction(), reach(0, random.uniform(0, 0.05), 0);
      for (int k = 0; k < kSteps; ++k) {
        const Real t = static_cast<Real>(k) / kSteps;
        const Frame now = at(0, 0, 0, 3 * t * turn + 0.01 * random.direction());
        const Real horizon = lazy.pairs.size() > 0 ? lazy.pairs.place(0).horizon : -kInfinity;
        for (Scene* s : {&lazy, &eager}) {
          s->table.place(1, Frame(now.r, from + t * (to - from)));
          s->table.reach[1] = k % 40 == 0 ? reach.y() : 0;
        }
        eager.pairs.ask_all();
        lazy.step(), eager.step();
        const Manifold &m = lazy.pairs[0].manifold, &n = eager.pairs[0].manifold;
        assert_int_equal(m.count, n.count);
        assert_int_equal(lazy.pairs.place(0).points, m.count);
        for (int p = 0; i % 2 == 0 && p < m.count; ++p)
          assert_memory_equal(&m.point[p].separation, &n.point[p].separation, 8);
        touching += m.count > 0;
        apart += m.count == 0;
        left_alone += horizon > -kInfinity && lazy.pairs.place(0).horizon == horizon;
      }
    }
    assert_true(touching > 100);
    assert_true(left_alone > apart / 2);
  }
}

static void a_pair_left_alone_is_asked_again_when_a_jump_or_a_dial_may_have_changed_it(void**) {
  const Shape a = box(Vec3(1, 1, 1)), b = box(Vec3(0.5, 0.5, 0.5));
  Scene s;
  s.settings.query.routines = false;
  s.add(a, at(0, 0, 0)), s.add(b, at(0, 2, 0));
  const auto queries = [&] {
    s.step();
    return s.report.gjk_calls;
  };
  assert_int_equal(queries(), 1);
  assert_int_equal(queries(), 0);
  s.table.place(1, at(0, 1.9, 0));  // of a gap of half a metre
  assert_int_equal(queries(), 0);
  s.pairs.ask_all();
  assert_int_equal(queries(), 1);
  s.settings.manifold.contact_distance = 0.5;
  assert_int_equal(queries(), 1);
  assert_true(s.pairs[0].manifold.count > 0);
  s.table.place(1, at(1e6, 1.5, 0));
  assert_int_equal(queries(), 1);
  s.table.place(1, at(0, 1.5, 0));
  assert_int_equal(queries(), 1);
  assert_true(s.pairs[0].manifold.count > 0);
}

static void a_steady_step_allocates_nothing(void**) {
  const Shape ground = half_space(Vec3::unit_y(), 0), brick = box(Vec3(0.5, 0.5, 0.5)), pin = cylinder(0.5, 0.5),
              ball = sphere(0.5);
  Scene s;
  s.add(ground, at(0, 0, 0));
  for (int i = 0; i < 4; ++i) s.add(brick, at(0.3 * i, 0.5 + 0.3 * i, 0, Vec3(0.1 * i, 0.2, 0)));
  s.add(pin, at(0, 0.5, 0.9));
  s.add(ball, at(0.9, 0.4, 0.2));
  for (int step = 0; step < 2; ++step) s.step();
  counting = true;
  for (int step = 0; step < 5; ++step) s.step();
  counting = false;
  assert_int_equal(allocations, 0);
}

static void the_same_scene_gives_the_same_bits(void**) {
  std::vector<Manifold> first;
  for (int run = 0; run < 2; ++run) {
    Random random(9);
    Scene s;
    std::vector<Shape> shapes;
    for (const Form f : {Form::half_space, Form::sphere, Form::box, Form::box, Form::capsule, Form::cylinder,
                         Form::cone, Form::ellipsoid, Form::polytope})
      shapes.push_back(random_shape(f, 1, random));
    for (const Shape& shape : shapes) s.add(shape, Frame(random_turn(random), random.in_cube(1)));
    for (int step = 0; step < 20; ++step) {
      for (Frame& f : s.table.frame) f.p += 1e-3 * random.direction();
      s.step();
      for (std::size_t i = 0; i < s.pairs.size(); ++i) {
        const Manifold& m = s.pairs[i].manifold;
        const std::size_t n = static_cast<std::size_t>(step) * s.pairs.size() + i;
        if (run == 0) {
          first.push_back(m);
          continue;
        }
        assert_int_equal(m.count, first[n].count);
        for (int k = 0; k < m.count; ++k) {
          assert_memory_equal(m.point[k].on_a.data(), first[n].point[k].on_a.data(), 24);
          assert_memory_equal(m.point[k].on_b.data(), first[n].point[k].on_b.data(), 24);
          assert_memory_equal(&m.point[k].separation, &first[n].point[k].separation, 8);
        }
      }
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_resting_box_keeps_its_four_points_through_a_jitter),
      cmocka_unit_test(without_routines_a_rocking_box_gathers_its_corners),
      cmocka_unit_test(both_orders_find_the_same_points),
      cmocka_unit_test(the_generic_path_finds_what_routines_find),
      cmocka_unit_test(a_misbehaving_support_function_costs_its_pair_only),
      cmocka_unit_test(counters_say_which_path_was_taken),
      cmocka_unit_test(two_half_spaces_make_no_contact),
      cmocka_unit_test(poses_that_are_no_numbers_make_no_contacts),
      cmocka_unit_test(pairs_out_of_reach_are_left_alone_and_miss_no_contact),
      cmocka_unit_test(a_pair_left_alone_is_asked_again_when_a_jump_or_a_dial_may_have_changed_it),
      cmocka_unit_test(a_steady_step_allocates_nothing),
      cmocka_unit_test(the_same_scene_gives_the_same_bits),
  };
  return cmocka_run_group_tests_name("collision/narrow_phase", tests, nullptr, nullptr);
}

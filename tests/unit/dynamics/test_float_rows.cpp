// Contacts in floats: what floats must not cost (momentum, places far out, flight side by side), and that what they
// can't bear is answered in doubles.
#include "carom_test.h"
#include "dynamics/solver/float_range.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;
constexpr Real kFloatRoundoff = 0x1p-24;

struct FloatWorld : TestWorld {
  explicit FloatWorld(Precision precision = Precision::in_float, const Vec3& gravity = Vec3(0, -9.81, 0))
      : TestWorld(gravity) {
    world.set_dial(Dial::solver, kSoftChoice);
    world.set_dial(Dial::precision, static_cast<Real>(precision));
  }
  /// A body of that mass, kg.
  std::uint32_t add_mass(const Shape* shape, const Vec3& position, Real mass) {
    BodyDef def;
    def.pose = {Quat::identity(), position};
    const std::uint32_t body = handle_slot(world.add_body(def));
    world.add_collider(body, shape, Pose{}, mass / shape->mass.volume, Colliders::kNoMaterial);
    return body;
  }
  bool is_finite() const {
    for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i)
      if (!world.state.x[i].all_finite() || !world.state.v[i].all_finite() || !world.state.omega[i].all_finite() ||
          !world.state.q[i].all_finite() || world.state.held_out[i])
        return false;
    return true;
  }
};

/// A column of boxes of edge `size`, that of number k of mass mass[k], on the ground, the lowest turned a little.
void pile(FloatWorld& t, Real size, const std::vector<Real>& mass) {
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(size / 2)));
  for (std::size_t k = 0; k < mass.size(); ++k)
    t.add_mass(cube, Vec3(0.1 * size * static_cast<Real>(k), size * (static_cast<Real>(k) + 0.5), 0), mass[k]);
}

// What one visit of a pair gives to A it takes from B, rounded once: relative to what changes hands, and not to what
// the heavy body has. A million times as heavy and fast, it must still feel each blow.
void momentum_is_kept_to_the_rounding_of_what_changes_hands(void**) {
  FloatWorld t(Precision::in_float, Vec3(0, -9.81, 0));
  const Shape* slab = t.keep(box(Vec3(40, 0.5, 40)));
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  const std::uint32_t truck = t.add_mass(slab, Vec3(0, 0, 0), 1e6);
  t.world.set_attribute(truck, AttributeId::gravity_factor, {0});  // it weighs too much for its load to press it down
  t.world.set_velocity(truck, Vec3(10, 0, 3), Vec3::zero());
  std::vector<std::uint32_t> load;
  for (int i = 0; i < 9; ++i) load.push_back(t.add_mass(cube, Vec3(3 * (i % 3) - 15, 1, 3 * (i / 3)), 1));
  const auto momentum = [&] {
    Vec3 sum = Vec3::zero();
    for (std::uint32_t i = 0; i < t.world.scene.bodies.slots(); ++i) sum += t.world.scene.mass[i] * t.world.state.v[i];
    return sum;
  };
  const Vec3 before = momentum();
  const Real fast = t.world.state.v[truck].x();
  t.run(120, kStep);
  assert_true(t.world.wide->is_float);
  const Real given = (fast - t.world.state.v[truck].x()) * 1e6;
  // Nine cubes of 1 kg ride at 10 m/s in the end, or are about to: friction 0.5 takes 2 s.
  assert_true(given > 40 && given < 91);
  // Nine pairs, four points, 120 steps of 12 visits, each off by some roundings of what it gives: loads of about
  // m g h = 0.04 N s a substep, of which friction is half. Rounding that had to do with the truck's 1e7 N s would be
  // 0.6 N s at each visit.
  const Real visits = 9 * 120 * 12.0, most = visits * 16 * kFloatRoundoff * 0.1;
  const Vec3 off = momentum() - before;
  assert_true(std::abs(off.x()) <= most && std::abs(off.z()) <= most);
}

// The same stack at the origin and 10,000 km away: rows know of differences alone, so places cost nothing but what
// doubles lose there.
void far_from_the_origin_a_stack_stands_as_at_home(void**) {
  const auto height_of_top = [](Precision precision, const Vec3& where) {
    FloatWorld t(precision);
    const Shape* slab = t.keep(box(Vec3(5, 0.5, 5)));
    const Shape* cube = t.keep(box(Vec3::constant(0.5)));
    t.add(slab, where, BodyType::fixed);
    std::uint32_t top = 0;
    for (int i = 0; i < 8; ++i) top = t.add(cube, where + Vec3(0, 1 + i, 0));
    t.run(300, kStep);
    return t.world.state.x[top].y() - where.y();
  };
  const Real home = height_of_top(Precision::in_float, Vec3::zero());
  assert_true(std::abs(home - height_of_top(Precision::in_double, Vec3::zero())) < 1e-5);
  assert_true(std::abs(home - height_of_top(Precision::in_float, Vec3(1e7, 1e7, -1e7))) < 1e-4);
}

// Two that fall side by side at a hair's breadth come as far to the last bit of a double; their shifts as floats would
// not, and push them.
void who_falls_beside_another_falls_as_in_doubles(void**) {
  Vec3 x[2][2];
  for (const Precision precision : {Precision::in_float, Precision::in_double}) {
    FloatWorld t(precision);
    const Shape* cube = t.keep(box(Vec3::constant(0.5)));
    std::uint32_t body[2];
    for (int i = 0; i < 2; ++i) {
      body[i] = t.add(cube, Vec3(i, 1000, 0));
      t.world.set_velocity(body[i], Vec3(0.3, -7, 0.1), Vec3::zero());
    }
    t.run(120, kStep);
    assert_true(t.world.report.contact_points > 0 && t.world.wide->is_float == (precision == Precision::in_float));
    for (int i = 0; i < 2; ++i) {
      x[precision == Precision::in_double][i] = t.world.state.x[body[i]];
      assert_true(t.world.state.omega[body[i]].norm() < 1e-15);
    }
  }
  // Shifts of 0.2 m a step as floats would be off by 1e-8 m, which parts them by micrometres a second.
  for (int i = 0; i < 2; ++i) assert_true((x[0][i] - x[1][i]).norm() < 1e-12);
}

// Near the double's answer: a float has 7 digits, contacts of like masses lose two or three of them.
void floats_and_doubles_agree_where_nothing_is_chaotic(void**) {
  for (const Real size : {1e-3, 1.0, 1e3})
    for (const Real ratio : {1e-3, 1.0, 1e3}) {
      Real y[2], slid[2];
      for (const Precision precision : {Precision::in_double, Precision::in_float}) {
        FloatWorld t(precision, Vec3(0, -9.81 * size, 0));
        t.world.set_dial(Dial::contact_distance, 0.01 * size);
        pile(t, size, {size, ratio * size});
        t.world.set_velocity(1, Vec3(0.2 * size, 0, 0), Vec3::zero());
        t.run(60, kStep);
        assert_true(t.is_finite());
        const std::size_t i = precision == Precision::in_double;
        assert_true(t.world.wide->is_float == (precision == Precision::in_float));
        y[i] = t.world.state.x[2].y() / size, slid[i] = t.world.state.x[1].x() / size;
      }
      assert_true(std::abs(y[0] - y[1]) < 1e-4 && std::abs(slid[0] - slid[1]) < 1e-4);
    }
}

// Masses, sizes and speeds that floats can't bear: finite, and to the bit what a world of doubles makes of them.
void what_floats_cannot_bear_is_answered_in_doubles(void**) {
  struct Case {
    Real size, light, heavy;
    bool in_float;
  };
  for (const Case& c :
       {Case{1, 1e-6, 1, true}, Case{1, 1, 1e6, true}, Case{1, 1e-3, 1e9, true}, Case{1, 1, 1e10, false},
        Case{1, 1e-10, 1, false}, Case{1, 1, 1e30, false}, Case{1, 1e-30, 1e30, false}, Case{1e-3, 1e-8, 1, true},
        Case{1e3, 1e3, 1e9, true}, Case{1e5, 1, 1, false}, Case{1e-3, 1, 1e30, false}}) {
    std::uint64_t hash[2];
    for (const Precision precision : {Precision::in_double, Precision::in_float}) {
      FloatWorld t(precision);
      pile(t, c.size, {c.light, c.heavy, c.light, c.heavy});
      for (int i = 0; i < 60; ++i) {
        t.world.step(kStep);
        assert_true(t.is_finite());
        if (precision == Precision::in_float && t.world.report.contact_points > 0)
          assert_true(t.world.wide->is_float == c.in_float);
      }
      hash[precision == Precision::in_double] = t.world.hash();
    }
    assert_true((hash[0] == hash[1]) == !c.in_float);
  }
}

void a_needle_is_answered_in_doubles_while_it_touches(void**) {
  FloatWorld t;
  t.ground();
  t.add(t.keep(box(Vec3(1, 1e-4, 1e-4))), Vec3(0, 1e-4, 0));
  const std::uint32_t brick = t.add(t.keep(box(Vec3(1, 0.1, 0.01))), Vec3(0, 0.1, 5));
  t.run(30, kStep);
  assert_true(!t.world.wide->is_float && t.is_finite());
  t.world.remove_body(1);
  t.run(30, kStep);
  assert_true(t.world.wide->is_float && t.world.state.x[brick].y() > 0.099);
}

// A host may push as hard as it likes: contacts in floats see no more than 1e9 m/s, and nobody is lost.
void speeds_beyond_the_range_stay_finite(void**) {
  for (const Real newton : {1e12, 1e20, 1e40, 1e100}) {
    FloatWorld t;
    pile(t, 1, {1, 1, 1});
    t.world.set_dial(Dial::continuous, 0);
    t.run(10, kStep);
    assert_true(t.world.wide->is_float);
    t.world.add_force(2, Vec3(newton, -newton, newton), Vec3(0, newton, 0));
    t.run(1, kStep);
    for (std::uint32_t i = 1; i <= 3; ++i)
      assert_true(t.world.state.v[i].all_finite() && t.world.state.omega[i].all_finite());
  }
}

// Settings that would leave the range: friction, belts, the length of a substep.
void so_are_settings_beyond_the_range(void**) {
  const auto stands_in_float = [](auto&& change, Real dt) {
    FloatWorld t;
    const std::uint32_t material = t.material(0.5, 0);
    const std::uint32_t ground = t.ground(material);
    t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0), BodyType::dynamic, Quat::identity(), material);
    change(t, ground, material);
    t.run(10, dt);
    assert_true(t.is_finite() && t.world.report.contact_points == 4);
    return t.world.wide->is_float;
  };
  const auto nothing = [](FloatWorld&, std::uint32_t, std::uint32_t) {};
  const auto rough = [](FloatWorld& t, std::uint32_t, std::uint32_t material) {
    Material m;
    m.friction = 1e30;
    t.world.set_material(material, m);
  };
  const auto belt = [](FloatWorld& t, std::uint32_t ground, std::uint32_t) {
    t.world.set_surface_velocity(t.world.scene.first_collider[ground], {Vec3(1e12, 0, 0), Vec3::zero()});
  };
  assert_true(stands_in_float(nothing, kStep));
  assert_true(!stands_in_float(rough, kStep));
  assert_true(!stands_in_float(nothing, 1e-9));
  assert_true(!stands_in_float(belt, kStep));
}

// Half the memory is what floats are for.
void rows_take_half_the_memory(void**) {
  static_assert(2 * sizeof(PointLanesOf<float>) == sizeof(PointLanes));
  static_assert(sizeof(PairLanesOf<float>) < 0.52 * sizeof(PairLanes));
  FloatWorld t;
  pile(t, 1, {1, 1, 1});
  t.run(2, kStep);
  assert_int_equal(t.world.wide->in_double.pairs.capacity(), 0);
  assert_true(t.world.wide->in_float->pairs.size() > 0);
}

/// `count` cubes on the ground, each with a pair of its own.
void lay_out(FloatWorld& t, std::uint32_t count) {
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  for (std::uint32_t i = 0; i < count; ++i) t.add_mass(cube, Vec3(2 * (i % 32), 0.5, 2 * (i / 32)), 1);
}

void left_to_itself_a_step_takes_floats_from_so_many_pairs(void**) {
  for (const std::uint32_t count : {kFloatsFrom - 1, kFloatsFrom + 0}) {
    const bool is_many = count == kFloatsFrom;
    std::uint64_t hash[2];
    for (const Precision precision : {Precision::by_size, is_many ? Precision::in_float : Precision::in_double}) {
      FloatWorld t(precision);
      lay_out(t, count);
      t.run(5, kStep);
      assert_int_equal(t.world.wide->manifolds.size(), count);
      assert_true(t.world.wide->is_float == is_many);
      hash[precision == Precision::by_size] = t.world.hash();
    }
    assert_true(hash[0] == hash[1]);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(momentum_is_kept_to_the_rounding_of_what_changes_hands),
      cmocka_unit_test(far_from_the_origin_a_stack_stands_as_at_home),
      cmocka_unit_test(who_falls_beside_another_falls_as_in_doubles),
      cmocka_unit_test(floats_and_doubles_agree_where_nothing_is_chaotic),
      cmocka_unit_test(what_floats_cannot_bear_is_answered_in_doubles),
      cmocka_unit_test(a_needle_is_answered_in_doubles_while_it_touches),
      cmocka_unit_test(speeds_beyond_the_range_stay_finite),
      cmocka_unit_test(so_are_settings_beyond_the_range),
      cmocka_unit_test(rows_take_half_the_memory),
      cmocka_unit_test(left_to_itself_a_step_takes_floats_from_so_many_pairs),
  };
  return cmocka_run_group_tests_name("unit/dynamics/float_rows", tests, nullptr, nullptr);
}

/* Distances through the interface: what their status claims of the bracket, for points and half-spaces too. */
#include "bench.h"
#include "carom_test.h"

static const double zero[3] = {0, 0, 0}, upright[4] = {0, 0, 0, 1};

static carom_distance ask(const Bench* b, carom_shape first, carom_shape second, double x, double y, double z) {
  const double at[3] = {x, y, z};
  carom_distance r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  assert_int_equal(carom_shape_distance(b->engine, first, zero, upright, second, at, upright, NULL, &r, NULL),
                   CAROM_OK);
  assert_true(r.lower <= r.separation && r.separation <= r.upper);
  return r;
}

static void a_point_is_exact_enough_against_anything_that_has_a_size(void** state) {
  Bench b;
  carom_shape point;
  const double none = 0;
  carom_distance r;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create(b.engine, b.sphere, &none, 1, &point, NULL), CAROM_OK);
  r = ask(&b, point, b.ball, 3, 0, 0);
  assert_true(r.lower <= 2.5 && 2.5 <= r.upper);
  assert_int_equal(r.status, CAROM_QUERY_EXACT_ENOUGH);
  r = ask(&b, b.crate, point, 0.5, 1.25, 0);
  assert_true(r.lower <= 1 && 1 <= r.upper);
  assert_int_equal(r.status, CAROM_QUERY_EXACT_ENOUGH);
  r = ask(&b, point, point, 3, 4, 0);
  assert_true(r.lower <= 5 && 5 <= r.upper);
  assert_int_equal(r.status, CAROM_QUERY_EXACT_ENOUGH);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void exact_enough_is_what_the_bracket_says_at_any_distance(void** state) {
  Bench b;
  const double asked = 1e-6 * 0.5; /* the default tolerance of the ball's radius, the smaller one of every pair */
  int exact = 0, rounded = 0;
  double y;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  for (y = 1; y < 1e10; y *= 1.05) {
    const carom_shape partners[3] = {b.floor, b.ball, b.crate};
    int i;
    for (i = 0; i < 3; ++i) {
      const carom_distance r = ask(&b, partners[i], b.ball, 0, y, 0);
      const double width = r.upper - r.lower;
      /* 1e-6: the engine's radius is 0.5 m to some epsilons, and its bounds are rounded when they are widened. */
      if (r.status == CAROM_QUERY_EXACT_ENOUGH)
        ++exact, assert_true(width <= asked * (1 + 1e-6));
      else
        ++rounded, assert_true(r.status == CAROM_QUERY_ROUNDING && width > asked * (1 - 1e-6));
    }
  }
  assert_true(exact > 300 && rounded > 60);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_point_is_exact_enough_against_anything_that_has_a_size),
      cmocka_unit_test(exact_enough_is_what_the_bracket_says_at_any_distance),
  };
  return cmocka_run_group_tests_name("abi/distance", tests, NULL, NULL);
}

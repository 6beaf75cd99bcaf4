// The sizes, densities and speeds for which contacts hold, as ABI.md says ("Limits"): a ball and a box come to rest where they
// should, on a plane and on a box, with the dials of a new world. What is smaller is told when its shape is made.
#include <carom/carom.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "carom_test.h"

namespace {

constexpr double kSmallest = 5e-5, kLargest = 100;  // m: half an edge, or a radius
constexpr double kTolerance = 1e-3;                 // m: dial position_tolerance, which a contact may leave
std::string g_told;
void listen(void*, std::uint32_t level, const char* text) {
  if (level == CAROM_LOG_WARNING) g_told = text;
}

struct Case {
  bool is_box, on_box;
  double size, density, speed;  // m, kg/m^3, m/s downwards at first
};

/// Sizes: how far from its place of rest it lies after 10 s.
double depth_at_rest(const Case& c) {
  carom_engine_desc engine_desc;
  carom_engine_desc_init(&engine_desc, sizeof engine_desc);
  engine_desc.log = listen;
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;
  assert_int_equal(carom_engine_create(&engine_desc, &engine, nullptr), CAROM_OK);
  assert_int_equal(carom_world_create(engine, nullptr, &world, nullptr), CAROM_OK);
  const auto shape_of = [&](const char* plugin_name, const double* params, std::uint64_t n) {
    carom_plugin plugin = 0;
    carom_shape shape = 0;
    const std::string path = std::string(CAROM_PLUGIN_DIR "/") + plugin_name + ".so";
    if (carom_plugin_find(engine, ("carom." + std::string(plugin_name)).c_str(), &plugin, nullptr) != CAROM_OK)
      assert_int_equal(carom_plugin_load(engine, path.c_str(), &plugin, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(engine, plugin, params, n, &shape, nullptr), CAROM_OK);
    return shape;
  };
  const auto body_with = [&](carom_shape shape, std::uint32_t type, double y, double vy) {
    carom_body_desc body;
    carom_collider_desc part;
    carom_body handle = 0;
    carom_collider collider = 0;
    carom_body_desc_init(&body, sizeof body), carom_collider_desc_init(&part, sizeof part);
    body.type = type, body.position[1] = y, body.linear_velocity[1] = vy;
    part.shape = shape, part.density = c.density;
    assert_int_equal(carom_body_create(world, &body, &handle, nullptr), CAROM_OK);
    assert_int_equal(carom_collider_create(world, handle, &part, &collider, nullptr), CAROM_OK);
    return handle;
  };
  const double half[3] = {c.size, c.size, c.size}, floor[3] = {50 * c.size, 5 * c.size, 50 * c.size}, up[3] = {0, 1, 0};
  carom_shape ground = 0;
  if (c.on_box)
    ground = shape_of("box", floor, 3);
  else
    assert_int_equal(carom_shape_create_half_space(engine, up, 0, &ground, nullptr), CAROM_OK);
  body_with(ground, CAROM_BODY_STATIC, c.on_box ? -5 * c.size : 0, 0);
  const carom_body body = body_with(c.is_box ? shape_of("box", half, 3) : shape_of("sphere", half, 1),
                                    CAROM_BODY_DYNAMIC, 1.5 * c.size, -c.speed);
  for (int i = 0; i < 600; ++i) assert_int_equal(carom_world_step(world, 1.0 / 60, nullptr), CAROM_OK);
  double x[3];
  assert_int_equal(carom_world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &body, 1, x, 0, nullptr), CAROM_OK);
  carom_world_destroy(world, nullptr), carom_engine_destroy(engine, nullptr);
  return (c.size - x[1]) / c.size;
}

void holds(const Case& c) {
  const double depth = depth_at_rest(c);
  const double most = std::min(0.5, kTolerance / c.size);
  if (!(std::fabs(depth) < most))
    print_error("a %s on a %s, %g m, %g kg/m^3, %g m/s: %g of its size from its place\n", c.is_box ? "box" : "ball",
                c.on_box ? "box" : "plane", c.size, c.density, c.speed, depth);
  assert_true(std::fabs(depth) < most);
}

}  // namespace

static void contacts_hold_from_the_smallest_to_the_largest(void**) {
  for (const bool is_box : {false, true})
    for (const bool on_box : {false, true})
      for (double size = kSmallest; size < 2 * kLargest; size *= std::sqrt(10)) holds({is_box, on_box, size, 1000, 0});
}

static void whatever_the_density_and_the_speed(void**) {
  for (const bool is_box : {false, true}) {
    for (const double density : {1e-9, 1e-3, 1e3, 1e9}) holds({is_box, true, 0.5, density, 0});
    for (const double speed : {1.0, 1e2, 1e4, 1e6, 1e8}) holds({is_box, true, 0.5, 1000, speed});
  }
}

/// Sizes that none of the above has.
static void so_it_is_for_others(void**) {
  for (const double size : {6e-5, 4e-4, 5e-3, 0.03, 7.0, 88.0}) holds({true, true, size, 300, 3 * std::sqrt(size)});
  for (const double size : {5.5e-5, 2e-4, 3e-3, 0.4, 70.0}) holds({false, false, size, 8000, 20 * std::sqrt(size)});
}

static void what_is_smaller_is_told(void**) {
  g_told.clear();
  depth_at_rest({true, false, kSmallest, 1000, 0});
  assert_true(g_told.empty());
  depth_at_rest({true, false, 0.1 * kSmallest, 1000, 0});
  assert_non_null(std::strstr(g_told.c_str(), "smaller than"));
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(contacts_hold_from_the_smallest_to_the_largest),
      cmocka_unit_test(whatever_the_density_and_the_speed),
      cmocka_unit_test(so_it_is_for_others),
      cmocka_unit_test(what_is_smaller_is_told),
  };
  return cmocka_run_group_tests_name("abi/sizes", tests, nullptr, nullptr);
}

// The same bits on every platform: hashes of a walk and of a drive, as numbers that any compiler has to give. Scenes are made of
// numbers that are exact, so that no library's sine is in them. Where hashes change, the commit says why.
#include <cstdio>

#include "car.h"

namespace {

using namespace kit;

struct Hash {
  uint64_t value = 0xcbf29ce484222325ull;  // FNV-1a
  template <class T>
  void add(const T& what) {
    unsigned char bytes[sizeof what];
    std::memcpy(bytes, &what, sizeof what);
    for (const unsigned char byte : bytes) value = (value ^ byte) * 0x100000001b3ull;
  }
};

bool is(const char* what, uint64_t value, uint64_t golden) {
  if (value == golden) return true;
  print_error("%s: 0x%016llxull, and not 0x%016llxull\n", what, static_cast<unsigned long long>(value),
              static_cast<unsigned long long>(golden));
  return false;
}

double rough(double x, double z) { return 0.125 * std::floor(2 * x) * 0.5 + 0.0625 * std::floor(3 * z); }

void a_walk(void**) {
  Stage s;
  s.body(CAROM_BODY_STATIC, s.field(48, 48, 0.5, rough), {-12, -2, -12});
  for (int i = 0; i < 8; ++i) s.box({1.5 * i - 6, -3, 2}, {1.5 * i - 5, 0.25 * i, 3});
  const carom_body lift = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {1.5, 0.25, 1.5}), {0, 2, 0});
  Walker w(s, {0, 3, 0});
  Hash hash;
  for (int i = 0; i < 900; ++i) {
    const V v = {0.125 * (i / 50 % 9 - 4), i / 100 % 2 ? -0.375 : 0.375, 0}, turn = {0, 0.25, 0};
    GOOD(carom_body_set_velocity(s.world, lift, v.data(), turn.data(), nullptr));
    s.step(0.015625);
    w.move({(i * 37 % 11 - 5) * 0.5, 0, (i / 7 * 17 % 13 - 6) * 0.5}, 0.015625, i % 90 == 0 ? 4 : 0);
    hash.add(w.position), hash.add(w.orientation), hash.add(w.velocity), hash.add(w.ground);
  }
  assert_true(is("walk", hash.value, 0xc9ba07979fafaecbull));
}

void a_drive(void**) {
  Stage s;
  s.body(CAROM_BODY_STATIC, s.field(96, 96, 1, [](double x, double z) { return 0.25 * rough(x, z); }), {-48, -1, -48});
  Car car(s, {0, 2, -20});
  car.wheel_descs[0].anti_roll_partner = 1, car.wheel_descs[0].anti_roll = 15000;
  Hash hash;
  for (int i = 0; i < 600; ++i) {
    car.input.throttle = i / 70 % 2 ? 0.75 : 0.25, car.input.steer = (i / 40 % 5 - 2) * 0.375;
    car.input.brake = i / 130 % 3 == 2 ? 0.75 : 0;
    car.frame(0.015625);
    const V p = car.place(), v = car.velocity(), w = car.spin();
    hash.add(p), hash.add(v), hash.add(w);
    for (const carom_wheel& wheel : car.wheels) hash.add(wheel.spin), hash.add(wheel.compression), hash.add(wheel.slip);
  }
  assert_true(is("drive", hash.value, 0x466a545674e0f870ull));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(a_walk), cmocka_unit_test(a_drive)};
  return cmocka_run_group_tests_name("kit/same_bits", tests, nullptr, nullptr);
}

// What tests of snapshots share: a stage with something of everything, bytes in and out, mutations, memory that runs out.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bench.h"
#include "carom_test.h"

using Bytes = std::vector<unsigned char>;

inline constexpr std::uint64_t kHeader = 32;

inline Bytes save(carom_world* world, std::uint32_t flags = CAROM_SNAPSHOT_STATE) {
  std::uint64_t size = 0;
  assert_int_equal(carom_world_save(world, flags, nullptr, 0, &size, nullptr), CAROM_OK);
  Bytes bytes(size);
  assert_int_equal(carom_world_save(world, flags, bytes.data(), size, &size, nullptr), CAROM_OK);
  return bytes;
}

inline int32_t restore(carom_world* world, const Bytes& bytes, carom_error* error = nullptr) {
  return carom_world_restore(world, bytes.data(), bytes.size(), error);
}

/// As the header has it: another implementation of what README.md and frame.cpp say.
inline void mend(Bytes& bytes) {
  if (bytes.size() < kHeader) return;
  const std::uint64_t n = bytes.size() - kHeader, whole = bytes.size();
  std::uint64_t h[4] = {n, ~n, 0x9E3779B97F4A7C15ull, 0xBF58476D1CE4E5B9ull}, at = 0;
  const auto mix = [](std::uint64_t a, std::uint64_t word) {
    a = (a ^ word) * 0x9E3779B97F4A7C15ull;
    return a ^ (a >> 32);
  };
  for (; at + 32 <= n; at += 32)
    for (int k = 0; k < 4; ++k) {
      std::uint64_t word;
      std::memcpy(&word, &bytes[kHeader + at + 8 * static_cast<std::uint64_t>(k)], 8);
      h[k] = mix(h[k], word);
    }
  for (; at < n; ++at) h[0] = mix(h[0], bytes[kHeader + at]);
  const std::uint64_t sum = mix(mix(mix(h[0], h[1]), h[2]), h[3]);
  std::memcpy(&bytes[16], &whole, 8);
  std::memcpy(&bytes[24], &sum, 8);
}

/// A stage with something of everything, some steps on: contacts, joints with a motor that may break, a spring, a
/// field, water, particles, sleep, events, filters.
inline void make(Bench& b, const carom_engine_desc* desc = nullptr) {
  assert_int_equal(bench_make(&b, desc, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
  assert_int_equal(bench_joint(&b, nullptr), CAROM_OK);
  carom_joint_motor motor;
  carom_joint_motor_init(&motor, sizeof motor);
  motor.speed = 2, motor.max_force = 5;
  assert_int_equal(carom_joint_set_motor(b.world, b.joint, CAROM_COORDINATE_TWIST, &motor, nullptr), CAROM_OK);
  carom_spring_desc spring;
  carom_spring_desc_init(&spring, sizeof spring);
  spring.body_a = b.bodies[1], spring.anchor_b[1] = 3, spring.stiffness = 40, spring.damping = 1, spring.rest = 1;
  carom_spring made;
  assert_int_equal(carom_spring_create(b.world, &spring, &made, nullptr), CAROM_OK);
  carom_force_field_desc field;
  carom_force_field_desc_init(&field, sizeof field);
  field.vector[0] = 0.25;
  carom_force_field wind;
  assert_int_equal(carom_force_field_create(b.world, &field, &wind, nullptr), CAROM_OK);
  assert_int_equal(carom_body_set_drag(b.world, b.bodies[2], 0.1, 0, nullptr), CAROM_OK);
  assert_int_equal(carom_body_set_gravity_factor(b.world, b.bodies[0], 0.5, nullptr), CAROM_OK);
  assert_int_equal(carom_body_ignore_collision(b.world, b.bodies[0], b.bodies[1], 1, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP, 1, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP_TIME, 0.1, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP_SPEED, 0.5, nullptr), CAROM_OK);
  assert_int_equal(carom_world_collect_events(b.world, 31, 0.5, nullptr), CAROM_OK);
}

/// What a host reads of a world; the hash is not all of it.
inline std::uint64_t seen(Bench& b) {
  const Bytes bytes = save(b.world);
  std::uint64_t h = bench_hash(b.world);
  for (const unsigned char c : bytes) h = (h ^ c) * 0x100000001B3ull;
  return h;
}

struct Random {
  std::uint64_t state;
  std::uint64_t operator()() {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
  }
  std::uint64_t below(std::uint64_t n) { return (*this)() % n; }
};

/// One of several good ones with up to three edits: bits, bytes, numbers, cuts, parts of another.
inline Bytes mutated(const std::vector<Bytes>& good, Random& random) {
  Bytes bytes = good[random.below(good.size())];
  const Bytes& other = good[random.below(good.size())];
  for (std::uint64_t edits = 1 + random.below(3); edits > 0; --edits) {
    const std::uint64_t at = kHeader + random.below(bytes.size() - kHeader);
    const std::uint64_t n = std::min<std::uint64_t>(bytes.size() - at, 1 + random.below(16));
    switch (random.below(8)) {
      case 0:
        bytes[at] ^= static_cast<unsigned char>(1u << random.below(8));
        break;
      case 1:
        bytes[at] = static_cast<unsigned char>(random());
        break;
      case 2:
        std::memset(&bytes[at], random.below(2) ? 0xFF : 0, n);
        break;
      case 3:
        if (bytes.size() > kHeader + 64) bytes.resize(kHeader + 1 + random.below(bytes.size() - kHeader - 1));
        break;
      case 4:
        if (at + n <= other.size()) std::memcpy(&bytes[at], &other[at], n);
        break;
      case 5: {  // a tail of another
        const std::uint64_t from = std::min<std::uint64_t>(at & ~7ull, other.size());
        bytes.resize(std::min<std::uint64_t>(bytes.size(), at & ~7ull));
        bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(from), other.end());
        break;
      }
      case 6: {  // a number that is one on its own
        const double numbers[] = {0, -0.0, 1e300, -1e300, 1e-300, 1.0 / 0.0, -1.0 / 0.0, 0.0 / 0.0, 1e15, 1};
        if (at + 8 <= bytes.size()) std::memcpy(&bytes[at & ~7ull], &numbers[random.below(10)], 8);
        break;
      }
      default:
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), n, static_cast<unsigned char>(random()));
    }
    if (bytes.size() <= kHeader + 1) break;
  }
  return bytes;
}

// ---- memory that runs out ----
struct Meter {
  std::int64_t left;  // allocations until one fails; negative: never
  std::int64_t alive;
};
inline void* metered_alloc(void* user, std::uint64_t size, std::uint64_t alignment) {
  auto* m = static_cast<Meter*>(user);
  if (m->left == 0) return nullptr;
  if (m->left > 0) --m->left;
  void* p = nullptr;
  if (posix_memalign(&p, alignment < sizeof(void*) ? sizeof(void*) : alignment, size)) return nullptr;
  ++m->alive;
  return p;
}
inline void metered_free(void* user, void* p, std::uint64_t, std::uint64_t) {
  if (p) --static_cast<Meter*>(user)->alive;
  std::free(p);
}

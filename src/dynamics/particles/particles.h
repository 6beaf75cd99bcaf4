// Sets of point masses that nothing touches: position, velocity, a mass, and nothing else. See README.md beside this.
#pragma once

#include <array>

#include "core/hash.h"
#include "core/pool.h"
#include "core/vec.h"
#include "dynamics/particles/flight_kernels.h"

namespace carom::dynamics {

/// What a host says about a set (ABI: carom_particles_desc), already validated.
struct ParticleDef {
  Real gravity_factor = 1;  // of the world's gravity
  Real linear_damping = 0;  // 1/s, dv/dt = -c v
  Real mass = 1;            // kg, of a particle that is added from now on
};

/// A set. Structure of arrays by index, which is all the name that a particle has: it moves up when one before it goes.
struct ParticleSet {
  explicit ParticleSet(Memory* m)
      : x{Array<Real>(m), Array<Real>(m), Array<Real>(m)},
        v{Array<Real>(m), Array<Real>(m), Array<Real>(m)},
        mass(m),
        held(m),
        sums(m) {}

  std::size_t size() const { return x[0].size(); }
  Vec3 position(std::size_t i) const { return Vec3(x[0][i], x[1][i], x[2][i]); }
  Vec3 velocity(std::size_t i) const { return Vec3(v[0][i], v[1][i], v[2][i]); }
  Real mass_of(std::size_t i) const { return mass.empty() ? def.mass : mass[i]; }
  bool is_held(std::size_t i) const { return (held[i / 64] >> (i % 64)) & 1; }
  /// The bit alone.
  void mark(std::size_t i, bool as_held) {
    const std::uint64_t bit = std::uint64_t(1) << (i % 64);
    as_held ? held[i / 64] |= bit : held[i / 64] &= ~bit;
  }

  ParticleDef def;
  std::array<Array<Real>, 3> x, v;  // m, m/s, world; by axis
  Array<Real> mass;                 // kg; empty: each weighs def.mass
  Array<std::uint64_t> held;        // bits, 64 a word: in quarantine, held still
  Array<FlightSums> sums;           // by block, of the last step
  std::size_t held_count = 0;
};

inline constexpr std::size_t kMostParticles = 0x7FFFFFFF;  // of a set: indices fit 32 bits, and so do sums of two
inline constexpr std::size_t kParticleBlock = 512;         // a sum of its own; a multiple of 64

/// All sets of a world.
class Particles {
 public:
  Particles(std::uint32_t tag, Memory* m) : slots(Kind::particles, tag, m), set(m), memory_(m) {}

  // ---- editing (between steps). Slots and indices are valid, numbers sane. Each reserves, then changes. ----
  Handle create(const ParticleDef& def, std::size_t capacity);  // 0: all slots taken
  void destroy(std::uint32_t s);
  void update(std::uint32_t s, const ParticleDef& def);
  void reserve(std::uint32_t s, std::size_t capacity);
  /// n more at the end, at rest in the origin. @return the first
  std::size_t extend(std::uint32_t s, std::size_t n);
  /// The others move up and keep their order. @param indices  ascending, each once
  void remove(std::uint32_t s, const std::uint32_t* indices, std::size_t n);
  void clear(std::uint32_t s);
  void place(std::uint32_t s, std::size_t i, const Vec3& x);  // takes it out of quarantine
  void set_velocity(std::uint32_t s, std::size_t i, const Vec3& v);
  void reserve_masses(std::uint32_t s);  // before the first set_mass()
  void set_mass(std::uint32_t s, std::size_t i, Real mass);

  void hold(std::uint32_t s, std::size_t i);  // stop it, until a host places it
  void recount();                             // after sets were given other sizes

  std::uint64_t count() const { return count_; }  // of all sets
  std::uint64_t held_count() const;
  void add_to(Hash& hash) const;
  Real linear_energy() const;  // J, after the last step, of those not held

  SlotPool slots;
  Array<ParticleSet> set;  // by slot
  const FlightKernels* kernels = &flight_kernels();

 private:
  Memory* memory_;
  std::uint64_t count_ = 0;
};

}  // namespace carom::dynamics

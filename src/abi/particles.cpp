// Sets of particles: made, filled, read and written in bulk.
#include <carom/particles.h>

#include <cstdio>

#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/records.h"
#include "abi/world.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

constexpr double kLargestFactor = 1e3, kLargestParticleDamping = 1e6, kLargestMass = 1e30;  // 1, 1/s, kg

bool resolve_set(Call& call, const World& world, carom_particles set) {
  return resolve(call, 2, "set", world.particles.slots, set);
}

const ParticleSet& set_of(const World& world, carom_particles handle) {
  return world.particles.set[handle_slot(handle)];
}

bool check_mass(Call& call, int argument, const char* name, double mass) {
  if (!in_range(call, argument, name, mass, 0, kLargestMass)) return false;
  return mass > 0 || call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is 0, must be greater", name);
}

bool check_capacity(Call& call, int argument, std::uint64_t capacity) {
  return capacity <= kMostParticles ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "desc->capacity is %llu, a set holds %zu particles",
                   static_cast<unsigned long long>(capacity), kMostParticles);
}

/// @param argument  where desc stands in the C signature
bool read_desc(Call& call, int argument, const carom_particles_desc* given, carom_particles_desc& d) {
  carom_particles_desc_init(&d, sizeof d);
  return (!given || read_struct(call, argument, "desc", given, d)) &&
         only_bits(call, argument, "desc->reserved", d.reserved, 0) &&
         in_range(call, argument, "desc->gravity_factor", d.gravity_factor, -kLargestFactor, kLargestFactor) &&
         in_range(call, argument, "desc->linear_damping", d.linear_damping, 0, kLargestParticleDamping) &&
         check_mass(call, argument, "desc->mass", d.mass) && check_capacity(call, argument, d.capacity);
}

ParticleDef def_of(const carom_particles_desc& d) { return {d.gravity_factor, d.linear_damping, d.mass}; }

/// A field of a particle. Whether a record is good is asked of thousands; what is wrong with one is put into words once.
struct ParticleFieldRow {
  const char* name;
  int scalars;
  void (*read)(const ParticleSet& set, std::size_t i, double record[]);
  void (*write)(Particles& particles, std::uint32_t s, std::size_t i, const double record[]);
  bool (*good)(const double record[]);
  bool (*blame)(Call& call, int argument, const char* name, const double record[]);  // of one that is not good
};

bool within(const double v[3], double most) { return to_vec3(v).squared_norm() <= most * most; }  // NaN is not
bool blame_length(Call& call, int argument, const char* name, const double v[3], double most) {
  return finite(call, argument, name, v, 3) &&
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is (%g, %g, %g), at most %g long", name, v[0], v[1], v[2], most);
}

constexpr ParticleFieldRow kPosition = {
    "position",
    3,
    [](const ParticleSet& p, std::size_t i, double* r) { from_vec3(p.position(i), r); },
    [](Particles& p, std::uint32_t s, std::size_t i, const double* r) { p.place(s, i, to_vec3(r)); },
    [](const double* r) { return within(r, kMaxPosition); },
    [](Call& call, int argument, const char* name, const double* r) {
      return blame_length(call, argument, name, r, kMaxPosition);
    }};
constexpr ParticleFieldRow kVelocity = {
    "linear_velocity",
    3,
    [](const ParticleSet& p, std::size_t i, double* r) { from_vec3(p.velocity(i), r); },
    [](Particles& p, std::uint32_t s, std::size_t i, const double* r) { p.set_velocity(s, i, to_vec3(r)); },
    [](const double* r) { return within(r, kMaxSpeed); },
    [](Call& call, int argument, const char* name, const double* r) {
      return blame_length(call, argument, name, r, kMaxSpeed);
    }};
constexpr ParticleFieldRow kMass = {
    "mass",
    1,
    [](const ParticleSet& p, std::size_t i, double* r) { *r = p.mass_of(i); },
    [](Particles& p, std::uint32_t s, std::size_t i, const double* r) { p.set_mass(s, i, *r); },
    [](const double* r) { return *r > 0 && *r <= kLargestMass; },
    [](Call& call, int argument, const char* name, const double* r) { return check_mass(call, argument, name, *r); }};

/// @return null, and noted in the call, if particles have no such field
const ParticleFieldRow* find_field(Call& call, std::uint32_t field) {
  if (!known(call, 3, "field", field, CAROM_FIELD_COUNT)) return nullptr;
  if (field == CAROM_FIELD_POSITION) return &kPosition;
  if (field == CAROM_FIELD_LINEAR_VELOCITY) return &kVelocity;
  if (field == CAROM_FIELD_MASS) return &kMass;
  call.fail(CAROM_E_UNSUPPORTED, 3, "field is %u; particles have position (%u), linear velocity (%u) and mass (%u)",
            field, CAROM_FIELD_POSITION, CAROM_FIELD_LINEAR_VELOCITY, CAROM_FIELD_MASS);
  return nullptr;
}

/// Which particles a call is about: indices[0..n), or all.
/// @param argument  where indices stand in the C signature; n stands after them
bool check_indices(Call& call, int argument, const ParticleSet& set, const std::uint32_t* indices, std::uint64_t n,
                   bool ascending) {
  if (!indices)
    return n == set.size() || call.fail(CAROM_E_OUT_OF_RANGE, argument + 1, "n is %llu, the set has %zu particles",
                                        static_cast<unsigned long long>(n), set.size());
  for (std::uint64_t k = 0; k < n; ++k) {
    if (indices[k] >= set.size())
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "indices[%llu] is %u, the set has %zu particles",
                       static_cast<unsigned long long>(k), indices[k], set.size());
    if (ascending && k > 0 && indices[k] <= indices[k - 1])
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "indices[%llu] is %u after %u; sort them, each once",
                       static_cast<unsigned long long>(k), indices[k], indices[k - 1]);
  }
  return true;
}

/// n records of a host's array, as numbers of ours.
struct Records {
  const char* bytes;
  std::uint64_t stride;
  std::uint32_t scalar;
  int scalars;

  void get(std::uint64_t k, double record[]) const {
    (scalar == CAROM_SCALAR_F32 ? load<float> : load<double>)(bytes + k * stride, scalars, record);
  }
};

bool check_records(Call& call, int argument, const ParticleFieldRow& field, const Records& records, std::uint64_t n) {
  for (std::uint64_t k = 0; k < n; ++k) {
    double record[kMostScalars];
    records.get(k, record);
    if (field.good(record)) continue;
    char name[64];
    std::snprintf(name, sizeof name, "%s of particle %llu", field.name, static_cast<unsigned long long>(k));
    return field.blame(call, argument, name, record);
  }
  return true;
}

void put_records(Particles& particles, std::uint32_t s, const ParticleFieldRow& field, const Records& records,
                 const std::uint32_t* indices, std::size_t first, std::uint64_t n) {
  for (std::uint64_t k = 0; k < n; ++k) {
    double record[kMostScalars];
    records.get(k, record);
    field.write(particles, s, indices ? indices[k] : first + k, record);
  }
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_particles_desc_init(carom_particles_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_particles_desc& d) { d.gravity_factor = d.mass = 1; });
}

int32_t carom_particles_create(carom_world* world, const carom_particles_desc* desc, carom_particles* set,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::particles_create(desc));
    carom_particles_desc d;
    if (!changing || !read_desc(call, 2, desc, d) || !present(call, 3, "set", set)) return;
    const Handle handle = changing->particles.create(def_of(d), d.capacity);
    if (handle)
      *set = handle;
    else
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u sets of particles", kMaxSlots);
  });
}

int32_t carom_particles_destroy(carom_world* world, carom_particles set, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::particles_destroy(set));
    if (!changing || !resolve_set(call, *changing, set)) return;
    const std::uint32_t slot = handle_slot(set);
    std::erase_if(changing->fault_views, [&](const FaultView& v) { return v.particles == slot; });
    changing->particles.destroy(slot);
  });
}

int32_t carom_particles_get(carom_world* world, carom_particles set, carom_particles_desc* desc, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_set(call, *reading, set) || !fillable(call, 3, "desc", desc)) return;
    const ParticleSet& p = set_of(*reading, set);
    carom_particles_desc full{};
    full.gravity_factor = p.def.gravity_factor;
    full.linear_damping = p.def.linear_damping;
    full.mass = p.def.mass;
    full.capacity = p.x[0].capacity();
    write_struct(full, desc);
  });
}

int32_t carom_particles_update(carom_world* world, carom_particles set, const carom_particles_desc* desc,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::particles_update(set, desc));
    carom_particles_desc d;
    if (!changing || !resolve_set(call, *changing, set) || !read_desc(call, 3, desc, d)) return;
    changing->particles.reserve(handle_slot(set), d.capacity);
    changing->particles.update(handle_slot(set), def_of(d));
  });
}

int32_t carom_particles_get_count(carom_world* world, carom_particles set, uint64_t* count, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_set(call, *reading, set) && present(call, 3, "count", count))
      *count = set_of(*reading, set).size();
  });
}

int32_t carom_particles_add(carom_world* world, carom_particles set, uint64_t n, uint32_t scalar, const void* positions,
                            uint64_t position_stride, const void* velocities, uint64_t velocity_stride,
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(
        call, world, record::particles_add(set, n, scalar, positions, position_stride, velocities, velocity_stride));
    if (!changing || !resolve_set(call, *changing, set) || !known(call, 4, "scalar", scalar, CAROM_SCALAR_F64 + 1) ||
        (n && !present(call, 5, "positions", positions)) ||
        !check_stride(call, 6, kPosition.name, 3, scalar, position_stride, std::min<std::uint64_t>(n, kMostParticles),
                      3) ||
        !check_stride(call, 8, kVelocity.name, 3, scalar, velocity_stride, std::min<std::uint64_t>(n, kMostParticles),
                      3))
      return;
    const std::uint32_t s = handle_slot(set);
    Particles& particles = changing->particles;
    if (n > kMostParticles - particles.set[s].size()) {
      call.fail(CAROM_E_LIMIT, 3, "n is %llu and the set has %zu particles already, it holds %zu",
                static_cast<unsigned long long>(n), particles.set[s].size(), kMostParticles);
      return;
    }
    const FloatScope scope;
    const Records x{static_cast<const char*>(positions), position_stride, scalar, 3},
        v{static_cast<const char*>(velocities), velocity_stride, scalar, 3};
    if (!check_records(call, 5, kPosition, x, n) || (velocities && !check_records(call, 7, kVelocity, v, n))) return;
    const std::size_t first = particles.extend(s, n);
    put_records(particles, s, kPosition, x, nullptr, first, n);
    if (velocities) put_records(particles, s, kVelocity, v, nullptr, first, n);
  });
}

int32_t carom_particles_remove(carom_world* world, carom_particles set, const uint32_t* indices, uint64_t n,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::particles_remove(set, indices, n));
    if (!changing || !resolve_set(call, *changing, set) ||
        !check_indices(call, 3, set_of(*changing, set), indices, n, true))
      return;
    if (indices)
      changing->particles.remove(handle_slot(set), indices, n);
    else
      changing->particles.clear(handle_slot(set));
  });
}

int32_t carom_particles_read(carom_world* world, carom_particles set, uint32_t field, uint32_t scalar,
                             const uint32_t* indices, uint64_t n, void* dst, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_set(call, *reading, set)) return;
    const ParticleFieldRow* const row = find_field(call, field);
    if (!row || !known(call, 4, "scalar", scalar, CAROM_SCALAR_F64 + 1) || (n && !present(call, 7, "dst", dst)) ||
        !check_stride(call, 8, row->name, row->scalars, scalar, stride, n, 6))
      return;
    const ParticleSet& p = set_of(*reading, set);
    if (!check_indices(call, 5, p, indices, n, false)) return;
    const auto put = scalar == CAROM_SCALAR_F32 ? store<float> : store<double>;
    for (std::uint64_t k = 0; k < n; ++k) {
      double record[kMostScalars];
      row->read(p, indices ? indices[k] : k, record);
      put(record, row->scalars, static_cast<char*>(dst) + k * stride);
    }
  });
}

int32_t carom_particles_write(carom_world* world, carom_particles set, uint32_t field, uint32_t scalar,
                              const uint32_t* indices, uint64_t n, const void* src, uint64_t stride,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::particles_write(set, field, scalar, indices, n, src, stride));
    if (!changing || !resolve_set(call, *changing, set)) return;
    const ParticleFieldRow* const row = find_field(call, field);
    if (!row || !known(call, 4, "scalar", scalar, CAROM_SCALAR_F64 + 1) || (n && !present(call, 7, "src", src)) ||
        !check_stride(call, 8, row->name, row->scalars, scalar, stride, n, 6) ||
        !check_indices(call, 5, set_of(*changing, set), indices, n, false))
      return;
    const FloatScope scope;
    const Records records{static_cast<const char*>(src), stride, scalar, row->scalars};
    if (!check_records(call, 7, *row, records, n)) return;
    const std::uint32_t s = handle_slot(set);
    if (row == &kMass && n) changing->particles.reserve_masses(s);
    put_records(changing->particles, s, *row, records, indices, 0, n);
  });
}

int32_t carom_particles_get_quarantined(carom_world* world, carom_particles set, uint32_t* indices, uint64_t capacity,
                                        uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_set(call, *reading, set) || (capacity && !present(call, 3, "indices", indices)) ||
        !present(call, 5, "count", count))
      return;
    const ParticleSet& p = set_of(*reading, set);
    *count = p.held_count;
    const std::uint64_t wanted = std::min<std::uint64_t>(capacity, p.held_count);
    for (std::uint64_t i = 0, k = 0; k < wanted; ++i)
      if (p.is_held(i)) indices[k++] = static_cast<std::uint32_t>(i);
  });
}

int32_t carom_world_get_particles(carom_world* world, carom_particles* sets, uint64_t capacity, uint64_t* count,
                                  carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !present(call, 4, "count", count)) return;
    const SlotPool& slots = reading->particles.slots;
    *count = slots.alive_count();
    if (!sets) return;
    for (std::uint32_t s = 0, k = 0; s < slots.slots() && k < capacity; ++s)
      if (slots.alive(s)) sets[k++] = slots.handle(s);
  });
}

}  // extern "C"

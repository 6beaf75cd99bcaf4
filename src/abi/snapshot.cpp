// Snapshots: saved and put back; worlds built of them, and forked.
#include "dynamics/snapshot/snapshot.h"

#include <carom/snapshot.h>

#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/snapshot_shapes.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

void save(Call& call, const Reading& world, std::uint32_t flags, void* buffer, std::uint64_t capacity,
          std::uint64_t* needed) {
  if (!only_bits(call, 2, "flags", flags, CAROM_SNAPSHOT_WHOLE) || (capacity && !present(call, 3, "buffer", buffer)) ||
      !present(call, 5, "needed", needed))
    return;
  const auto write = [&](std::byte* to, std::uint64_t space) {
    return flags & CAROM_SNAPSHOT_WHOLE ? save_world(*world, EngineNames(world.engine()), to, space)
                                        : save_state(*world, to, space);
  };
  // Known before the first byte is written, and counted once of a state: hosts ask for it first.
  const bool whole = flags & CAROM_SNAPSHOT_WHOLE;
  std::uint64_t size = world.snapshot_size(whole);
  if (size == 0) world.know_snapshot_size(whole, size = write(nullptr, 0));
  *needed = size;
  if (!buffer) return;
  if (size > capacity)
    call.fail(CAROM_E_BUFFER_TOO_SMALL, 4, "the snapshot takes %llu bytes, capacity is %llu",
              static_cast<unsigned long long>(size), static_cast<unsigned long long>(capacity));
  else
    write(static_cast<std::byte*>(buffer), capacity);
}

Owned<World> empty_world(carom_engine& engine, std::uint32_t tag) {
  Owned<World> world = make_owned<World>(&engine.memory, tag, Vec3::zero(), std::size_t(0), &engine.memory);
  world->jobs = engine.jobs.get();
  return world;
}

/// A world is built beside the one in which there is nothing, and takes its place.
bool build(const Changing& changing, const std::byte* bytes, std::uint64_t size, SnapshotFault& fault) {
  EngineShapes shapes(changing.engine());
  Owned<World> built = empty_world(changing.engine(), changing->scene.bodies.tag());
  if (!build_world(*built, bytes, size, shapes, fault)) return false;
  if (changing->ledger) built->keep_ledger(true);
  built->times_effects = changing->times_effects;
  wear_shapes(changing.engine(), *built);
  changing.replace(std::move(built));
  return true;
}

void restore(Call& call, const Changing& changing, const void* given, std::uint64_t size) {
  const FloatScope scope;
  const auto* const bytes = static_cast<const std::byte*>(given);
  SnapshotFault fault;
  if (is_untouched(*changing) && is_whole(bytes, size)) {
    if (build(changing, bytes, size, fault)) return;
  } else if (restore_state(*changing, bytes, size, fault)) {
    return;
  }
  const bool hint = fault.kind == SnapshotFault::mismatch && !is_untouched(*changing) && is_whole(bytes, size);
  call.fail(code_of(fault), 2, "%.200s%s", fault.text, hint ? "; it is whole: it goes into a new world" : "");
}

const SlotPool* pool_of(const World& world, Handle handle) {
  switch (static_cast<Kind>(handle >> 60)) {
    case Kind::material:
      return &world.scene.material_slots;
    case Kind::body:
      return &world.scene.bodies;
    case Kind::collider:
      return &world.scene.collider_slots;
    case Kind::particles:
      return &world.particles.slots;
    case Kind::joint:
      return &world.joints.slots;
    case Kind::field:
      return &world.scene.fields.slots;
    case Kind::spring:
      return &world.scene.springs.slots;
    default:
      return nullptr;
  }
}

/// What a handle of another world would be in this one.
bool translate(Call& call, const World& world, Handle handle, Handle& own) {
  own = handle;
  if (handle == CAROM_NULL_HANDLE) return true;
  const SlotPool* const pool = pool_of(world, handle);
  if (!pool)
    return call.fail(CAROM_E_WRONG_KIND, 2, "0x%016llx is of nothing that a world has",
                     static_cast<unsigned long long>(handle));
  own = with_tag(handle, pool->tag());
  return resolve(call, 2, "handles", *pool, own);
}

}  // namespace

carom_world* fork_world(Call& call, const Reading& world) {
  const FloatScope scope;
  carom_engine& engine = world.engine();
  const NumberNames names;
  NumberedShapes shapes(shapes_of(*world, &engine.memory));
  Array<std::byte> bytes(save_world(*world, names, nullptr, 0), std::byte(0), &engine.memory);
  save_world(*world, names, bytes.data(), bytes.size());
  carom_world* made = make_world(call, engine, Vec3::zero(), 0);
  if (!made) return nullptr;
  try {
    Owned<World> built = empty_world(engine, made->inner->scene.bodies.tag());
    SnapshotFault fault;
    if (!build_world(*built, bytes.data(), bytes.size(), shapes, fault)) {
      call.fail(CAROM_E_INTERNAL, 1, "the copy was refused: %s", fault.text);
      destroy_world(made);
      return nullptr;
    }
    wear_shapes(engine, *built);
    made->inner = std::move(built);
  } catch (...) {
    destroy_world(made);
    throw;
  }
  return made;
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_save(carom_world* world, uint32_t flags, void* buffer, uint64_t capacity, uint64_t* needed,
                         carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) save(call, reading, flags, buffer, capacity, needed);
  });
}

int32_t carom_world_restore(carom_world* world, const void* bytes, uint64_t size, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_restore(bytes, size));
    if (changing && present(call, 2, "bytes", bytes)) restore(call, changing, bytes, size);
  });
}

int32_t carom_world_fork(carom_world* world, carom_world** copy, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !present(call, 2, "copy", copy)) return;
    if (carom_world* const made = fork_world(call, reading)) *copy = made;
  });
}

int32_t carom_world_translate_handles(carom_world* world, const uint64_t* handles, uint64_t n, uint64_t* translated,
                                      carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || (n && (!present(call, 2, "handles", handles) || !present(call, 4, "translated", translated))))
      return;
    Handle own;
    for (std::uint64_t i = 0; i < n; ++i)
      if (!translate(call, *reading, handles[i], own)) return;
    for (std::uint64_t i = 0; i < n; ++i) translate(call, *reading, handles[i], own), translated[i] = own;
  });
}

}  // extern "C"

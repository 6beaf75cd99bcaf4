// Snapshots: saved and put back.
#include "dynamics/snapshot/snapshot.h"

#include <carom/snapshot.h>

#include "abi/world.h"

namespace carom::abi {
namespace {

void save(Call& call, const World& world, std::uint32_t flags, void* buffer, std::uint64_t capacity,
          std::uint64_t* needed) {
  if (!only_bits(call, 2, "flags", flags, CAROM_SNAPSHOT_STATE) || (capacity && !present(call, 3, "buffer", buffer)) ||
      !present(call, 5, "needed", needed))
    return;
  const std::uint64_t size = save_state(world, static_cast<std::byte*>(buffer), capacity);
  *needed = size;
  if (buffer && size > capacity)
    call.fail(CAROM_E_BUFFER_TOO_SMALL, 4, "the snapshot takes %llu bytes, capacity is %llu",
              static_cast<unsigned long long>(size), static_cast<unsigned long long>(capacity));
}

std::int32_t code_of(SnapshotFault::Kind kind) {
  switch (kind) {
    case SnapshotFault::newer:
      return CAROM_E_UNSUPPORTED;
    case SnapshotFault::mismatch:
      return CAROM_E_MISMATCH;
    default:
      return CAROM_E_CORRUPT;
  }
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_save(carom_world* world, uint32_t flags, void* buffer, uint64_t capacity, uint64_t* needed,
                         carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) save(call, *reading, flags, buffer, capacity, needed);
  });
}

int32_t carom_world_restore(carom_world* world, const void* bytes, uint64_t size, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Changing changing(call, world);
    if (!changing || !present(call, 2, "bytes", bytes)) return;
    SnapshotFault fault;
    if (!restore_state(*changing, static_cast<const std::byte*>(bytes), size, fault))
      call.fail(code_of(fault.kind), 2, "%s", fault.text);
  });
}

}  // extern "C"

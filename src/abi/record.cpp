// Recording begun and ended; a world compared with a snapshot.
#include <carom/record.h>

#include "abi/snapshot_shapes.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

void fail_as(Call& call, const Recorder& recorder) {
  if (recorder.code() == CAROM_E_WRITE_FAILED)
    call.fail(CAROM_E_WRITE_FAILED, 0, "the host's write function said that it failed; %llu bytes were written",
              static_cast<unsigned long long>(recorder.written()));
  else if (recorder.code() != CAROM_OK)
    call.fail(recorder.code(), 0, "no memory to record with; %llu bytes were written",
              static_cast<unsigned long long>(recorder.written()));
}

void begin(Call& call, const Changing& changing, std::uint32_t flags, carom_write_fn write, void* user) {
  if (!only_bits(call, 2, "flags", flags, CAROM_RECORD_STATES)) return;
  if (!write) {
    call.fail(CAROM_E_NULL_ARGUMENT, 3, "write is NULL");
    return;
  }
  if (changing.recorder()) {
    call.fail(CAROM_E_IN_USE, 1, "this world is being recorded");
    return;
  }
  carom_engine& engine = changing.engine();
  auto recorder = make_owned<Recorder>(&engine.memory, engine, flags, write, user);
  recorder->begin(*changing);
  fail_as(call, *recorder);
  if (call.ok()) changing.record(std::move(recorder));
}

void end(Call& call, const Changing& changing) {
  Recorder* const recorder = changing.recorder();
  if (!recorder) {
    call.fail(CAROM_E_NOT_FOUND, 1, "this world is not being recorded");
    return;
  }
  recorder->end();
  fail_as(call, *recorder);
  changing.record(nullptr);
}

void compare(Call& call, const World& world, const void* bytes, std::uint64_t size, carom_difference* out) {
  if (!present(call, 2, "bytes", bytes) || !fillable(call, 4, "difference", out)) return;
  SnapshotFault fault;
  Difference found;
  if (!compare_state(world, static_cast<const std::byte*>(bytes), size, found, fault)) {
    call.fail(code_of(fault), 2, "%s", fault.text);
    return;
  }
  carom_difference full{};
  full.differs = found.sections[0] != 0;
  full.first = found.first, full.second = found.second;
  static_assert(sizeof full.sections >= sizeof found.sections);
  std::memcpy(full.sections, found.sections, sizeof found.sections);
  write_struct(full, out);
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_record_begin(carom_world* world, uint32_t flags, carom_write_fn write, void* user,
                                 carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (const Changing changing(call, world); changing) begin(call, changing, flags, write, user);
  });
}

int32_t carom_world_record_end(carom_world* world, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (const Changing changing(call, world); changing) end(call, changing);
  });
}

int32_t carom_world_compare(carom_world* world, const void* bytes, uint64_t size, carom_difference* difference,
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) compare(call, *reading, bytes, size, difference);
  });
}

}  // extern "C"

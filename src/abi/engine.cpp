// The engine root: making and destroying it, its log, and pins that keep shapes alive while they are in use.
#include "abi/engine.h"

#include <cstdarg>
#include <cstdio>

#include "abi/jobs.h"
#include "abi/tags.h"

carom_engine::carom_engine(const carom_engine_desc& desc, std::uint32_t owner_tag)
    : memory(desc),
      log(desc.log),
      log_user(desc.log_user),
      tag(owner_tag),
      plugin_slots(carom::Kind::plugin, owner_tag, &memory),
      shape_slots(carom::Kind::shape, owner_tag, &memory),
      plugins(&memory),
      shapes(&memory) {}

carom_engine::~carom_engine() {
  for (const carom::abi::ShapeRecord& record : shapes) carom::abi::destroy_on(&memory, record.shape);
  for (carom::abi::PluginRecord* record : plugins) carom::abi::destroy_on(&memory, record);
}

void carom_engine::log_message(std::uint32_t level, const char* format, ...) const {
  if (!log) return;
  char text[512];
  std::va_list args;
  va_start(args, format);
  std::vsnprintf(text, sizeof text, format, args);
  va_end(args);
  carom::abi::call_host([&] { log(log_user, level, text); });
}

namespace carom::abi {

bool ShapePin::take(Call& call, int argument, const char* name, carom_shape handle) {
  const std::lock_guard lock(engine_.mutex);
  if (!resolve(call, argument, name, engine_.shape_slots, handle)) return false;
  slot_ = handle_slot(handle);
  shape_ = engine_.shapes[slot_].shape;
  engine_.shapes[slot_].uses += 1;
  return true;
}

bool ShapePin::take_convex(Call& call, int argument, const char* name, carom_shape handle) {
  return take(call, argument, name, handle) &&
         (!is_scenery(*shape_) ||
          call.fail(CAROM_E_UNSUPPORTED, argument, "%s is scenery: a convex shape is needed here", name));
}

bool one_is_convex(Call& call, int argument, const Shape& a, const Shape& b) {
  return !is_scenery(a) || !is_scenery(b) ||
         call.fail(CAROM_E_UNSUPPORTED, argument, "both are scenery: one of them has to be convex");
}

ShapePin::~ShapePin() {
  if (slot_ == kInvalid) return;
  const std::lock_guard lock(engine_.mutex);
  engine_.shapes[slot_].uses -= 1;
}

void unuse_shape(carom_engine& engine, const Shape& shape) {
  const std::lock_guard lock(engine.mutex);
  engine.shapes[handle_slot(shape.handle)].uses -= 1;
}

namespace {

/// Check what is given, take a tag, and build the engine on its own allocator.
void create(Call& call, const carom_engine_desc* given, carom_engine** engine) {
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  if ((given && !read_struct(call, 1, "desc", given, desc)) ||
      !only_bits(call, 1, "desc->reserved", desc.reserved, 0) || !present(call, 2, "engine", engine))
    return;
  if (!desc.alloc != !desc.free) {
    call.fail(CAROM_E_NULL_ARGUMENT, 1, "desc->%s is NULL but desc->%s is not: give both or neither",
              desc.alloc ? "free" : "alloc", desc.alloc ? "alloc" : "free");
    return;
  }
  const std::uint32_t tag = take_tag();
  if (!tag) {
    call.fail(CAROM_E_LIMIT, 0, "65,535 engines and worlds are alive in this process");
    return;
  }
  HostMemory memory(desc);  // until the engine has its own
  try {
    *engine = make_on<carom_engine>(&memory, desc, tag);
  } catch (...) {
    release_tag(tag);
    throw;
  }
}

/// New jobs before the old ones go: a call that fails has changed nothing.
void set_jobs(Call& call, carom_engine* engine, const carom_jobs_desc* given) {
  carom_jobs_desc desc;
  carom_jobs_desc_init(&desc, sizeof desc);
  if (!present(call, 1, "engine", engine) || (given && !read_struct(call, 2, "desc", given, desc))) return;
  Owned<Jobs> old;  // its threads end after the lock is given back
  const std::lock_guard lock(engine->mutex);
  if (const std::uint32_t worlds = engine->worlds.load(std::memory_order_relaxed)) {
    call.fail(CAROM_E_IN_USE, 1, "%u worlds, batches or devices of this engine are alive", worlds);
    call.advise("set jobs before the first world is made, or destroy the worlds first");
    return;
  }
  if (engine->loops > 0) {
    call.fail(CAROM_E_IN_USE, 1, "%u calls of carom_pairs_distance() are under way", engine->loops);
    call.advise("set jobs when they have returned");
    return;
  }
  Owned<Jobs> jobs;
  if (!make_jobs(call, desc, &engine->memory, jobs)) return;
  old = std::move(engine->jobs);
  engine->jobs = std::move(jobs);
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_engine_desc_init(carom_engine_desc* desc, uint32_t struct_size) { return init_struct(desc, struct_size); }

int32_t carom_engine_create(const carom_engine_desc* desc, carom_engine** engine, carom_error* error) {
  return guarded(error, [&](Call& call) { create(call, desc, engine); });
}

int32_t carom_jobs_desc_init(carom_jobs_desc* desc, uint32_t struct_size) { return init_struct(desc, struct_size); }

int32_t carom_engine_set_jobs(carom_engine* engine, const carom_jobs_desc* desc, carom_error* error) {
  return guarded(error, [&](Call& call) { set_jobs(call, engine, desc); });
}

int32_t carom_engine_destroy(carom_engine* engine, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine)) return;
    if (const std::uint32_t worlds = engine->worlds.load(std::memory_order_acquire)) {
      call.fail(CAROM_E_IN_USE, 1, "%u worlds, batches or devices of this engine are alive", worlds);
      call.advise("destroy its worlds, batches and devices first");
      return;
    }
    const std::uint32_t tag = engine->tag;
    HostMemory memory = engine->memory;  // outlives the engine that lies on it
    destroy_on(&memory, engine);
    release_tag(tag);
  });
}

}  // extern "C"

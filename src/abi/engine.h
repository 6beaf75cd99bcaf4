// What stands behind carom_engine*: the host's allocator and log, plugins, and shapes that worlds share.
#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "abi/check.h"
#include "abi/memory.h"
#include "collision/shape.h"
#include "core/jobs.h"

namespace carom::abi {

/// A plugin as the engine took it in: a copy of all that its author's struct says, so that nothing is read there again.
struct PluginRecord {
  explicit PluginRecord(Memory* memory) : id(memory), file(memory), text(memory), bounds(memory), rules(memory) {}

  const carom_shape_plugin* given = nullptr;  // the author's own, for carom_plugin_describe()
  carom_shape_plugin description{};           // brought to this library's size
  carom_geometry geometry{};                  // likewise; form and mass_form NONE where nothing is declared
  std::pmr::string id;
  std::pmr::string file;          // "box" of .../box.so; empty if it was registered by pointer
  std::pmr::string text;          // of its support function; empty: it has none
  Array<carom_param> bounds;      // [param_count]
  Array<carom_param_rule> rules;  // [rule_count]
  std::uint64_t uses = 0;         // shapes made, or being made, of it
};

/// The first rule that parameters break, or null.
const carom_param_rule* broken_rule(const PluginRecord& plugin, const double* params);

struct ShapeRecord {
  Shape* shape = nullptr;
  PluginRecord* plugin = nullptr;  // null: built in
  std::uint64_t plugin_handle = 0;
  std::uint64_t uses = 0;  // colliders in any world, and queries under way
};

}  // namespace carom::abi

struct carom_engine {
  carom_engine(const carom_engine_desc& desc, std::uint32_t owner_tag);
  ~carom_engine();
  carom_engine(const carom_engine&) = delete;
  carom_engine& operator=(const carom_engine&) = delete;

  void log_message(std::uint32_t level, const char* format, ...) const __attribute__((format(printf, 3, 4)));

  carom::abi::HostMemory memory;
  void (*log)(void* user, std::uint32_t level, const char* text);
  void* log_user;
  const std::uint32_t tag;
  std::atomic<std::uint32_t> worlds{0};

  // Guards everything below. Held for look-ups and edits only: never while a support function runs, never in a step.
  std::mutex mutex;
  carom::SlotPool plugin_slots, shape_slots;
  carom::Array<carom::abi::PluginRecord*> plugins;  // by slot; null: free
  carom::Array<carom::abi::ShapeRecord> shapes;     // by slot; shape null: free
  std::uint32_t loops = 0;                          // calls under way that use jobs, and no world or batch
  carom::Owned<carom::Jobs> jobs;  // null: steps share their loops with no threads; stays while there are worlds
};

namespace carom::abi {

/// A shape that cannot be destroyed as long as this lives, or for good once kept (a collider's).
class ShapePin {
 public:
  explicit ShapePin(carom_engine& engine) : engine_(engine) {}
  ~ShapePin();
  ShapePin(const ShapePin&) = delete;
  ShapePin& operator=(const ShapePin&) = delete;

  bool take(Call& call, int argument, const char* name, carom_shape handle);
  bool take_convex(Call& call, int argument, const char* name, carom_shape handle);  // scenery is refused
  void keep() { slot_ = kInvalid; }
  const Shape& operator*() const { return *shape_; }
  const Shape* operator->() const { return shape_; }

 private:
  carom_engine& engine_;
  const Shape* shape_ = nullptr;
  std::uint32_t slot_ = kInvalid;
};

/// Two sceneries cannot be asked about each other.
bool one_is_convex(Call& call, int argument, const Shape& a, const Shape& b);

/// Give back what a kept pin held.
void unuse_shape(carom_engine& engine, const Shape& shape);

}  // namespace carom::abi

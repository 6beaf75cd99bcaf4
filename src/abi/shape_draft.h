// A shape in the making, and how it becomes one of an engine's.
#pragma once

#include "abi/engine.h"

namespace carom::abi {

/// Gone unless an engine took it.
struct ShapeDraft {
  explicit ShapeDraft(Memory* m) : memory(m), shape(make_on<Shape>(m, m)) {}
  ~ShapeDraft() { destroy_on(memory, shape); }
  ShapeDraft(const ShapeDraft&) = delete;
  ShapeDraft& operator=(const ShapeDraft&) = delete;
  Memory* memory;
  Shape* shape;
};

/// Add a finished shape to the engine. Nothing has changed if it throws.
/// @param plugin  whose it is; null: built in
bool add_shape(Call& call, carom_engine& engine, ShapeDraft& draft, carom_shape* handle, PluginRecord* plugin = nullptr,
               carom_plugin plugin_handle = CAROM_NULL_HANDLE);

}  // namespace carom::abi

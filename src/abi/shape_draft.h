// A shape in the making, and how it becomes one of an engine's.
#pragma once

#include <carom/scenery.h>

#include <span>

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

/// Keeps a plugin from being unloaded while a shape is made of it; for good once kept.
class PluginPin {
 public:
  explicit PluginPin(carom_engine& engine) : engine_(engine) {}
  ~PluginPin();
  PluginPin(const PluginPin&) = delete;
  PluginPin& operator=(const PluginPin&) = delete;

  bool take(Call& call, int argument, carom_plugin handle);
  PluginRecord* get() const { return record_; }
  void keep() { record_ = nullptr; }

 private:
  carom_engine& engine_;
  PluginRecord* record_ = nullptr;
};

// Finish a shape, everything checked. @return false: noted
bool draft_of_plugin(Call& call, const PluginRecord& plugin, const double* params, std::uint64_t count,
                     ShapeDraft& draft);
/// Whether parts and numbers may be a hull of shapes.
bool check_hull_of(Call& call, std::span<const Shape* const> parts, std::span<const double> numbers);
/// @param parts    kept alive by the caller until the engine has the draft   @param numbers  as HullOf::numbers, checked
bool draft_hull_of(Call& call, std::span<const Shape* const> parts, std::span<const double> numbers, ShapeDraft& draft);
void draft_half_space(const Vec3& normal, double offset, ShapeDraft& draft);  // of a unit normal
/// @param dropped  triangles that are left out already
bool draft_mesh(Call& call, const carom_mesh_desc& desc, ShapeDraft& draft, std::uint32_t dropped = 0);
bool draft_height_field(Call& call, const carom_height_field_desc& desc, ShapeDraft& draft);

/// Add a finished shape to the engine. Nothing has changed if it throws.
/// @param plugin  whose it is; null: built in
bool add_shape(Call& call, carom_engine& engine, ShapeDraft& draft, carom_shape* handle, PluginRecord* plugin = nullptr,
               carom_plugin plugin_handle = CAROM_NULL_HANDLE);

/// Take a shape that nothing uses out of the engine, whose mutex is held.
void remove_shape(carom_engine& engine, std::uint32_t slot);

}  // namespace carom::abi

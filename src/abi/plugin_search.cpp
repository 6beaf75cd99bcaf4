// Shapes by name: plugins that the engine has, then files in the folders where plugins are kept.
#include <carom/body.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "abi/engine.h"
#include "abi/loader.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

constexpr std::string_view kOwn = "carom.";  // what ids of our own plugins begin with
constexpr std::string_view kHalfSpace = "half_space";
constexpr std::uint64_t kHalfSpaceParams = 4;
constexpr std::size_t kLongestName = 64;

bool is_name(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= kLongestName && plain(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return plain(c) || c == '.'; });
}

/// "box" and "carom.box" are one name.
std::string_view short_name(std::string_view name) { return name.starts_with(kOwn) ? name.substr(kOwn.size()) : name; }
bool is_called(const PluginRecord& plugin, std::string_view name) {
  const std::string_view id = plugin.id;
  return id == name || (id.starts_with(kOwn) && id.substr(kOwn.size()) == short_name(name));
}

/// The plugin of that name that the engine has, or 0: by its id, else by the file that it was loaded from. The engine's
/// mutex is held.
carom_plugin plugin_called(const carom_engine& engine, std::string_view name) {
  for (std::uint32_t slot = 0; slot < engine.plugins.size(); ++slot)
    if (engine.plugins[slot] && is_called(*engine.plugins[slot], name)) return engine.plugin_slots.handle(slot);
  const std::string_view file = short_name(name);
  for (std::uint32_t slot = 0; slot < engine.plugins.size() && !file.empty(); ++slot)
    if (engine.plugins[slot] && engine.plugins[slot]->file == file) return engine.plugin_slots.handle(slot);
  return CAROM_NULL_HANDLE;
}

struct Found {
  carom_plugin plugin = CAROM_NULL_HANDLE;
  PluginFile file;  // to load it from, if the engine does not have it
};

/// The plugin of a name, or its file.   @param engine, name  not null
std::int32_t find(carom_engine* engine, const char* name, Found& found, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!is_name({name, strnlen(name, kLongestName + 1)})) {
      call.fail(CAROM_E_OUT_OF_RANGE, 2, "\"%.80s\" is no name of a shape: 1 to 64 letters, digits, _, - and dots",
                name);
      return;
    }
    {
      const std::lock_guard lock(engine->mutex);
      found.plugin = plugin_called(*engine, name);
    }
    if (found.plugin) return;
    find_plugin_file(short_name(name), found.file);
    if (!found.file.path[0]) {
      call.fail(CAROM_E_NOT_FOUND, 2, "no plugin \"%.64s\" is registered, and no file of that name is in %s", name,
                found.file.searched[0] ? found.file.searched : "any folder: set CAROM_PLUGIN_PATH");
      call.advise("check the spelling, or add the folder of the plugin to $CAROM_PLUGIN_PATH");
    }
  });
}

/// A shape that the engine has, of a plugin of that name and with these parameters; else 0.
carom_shape shape_like(carom_engine& engine, const char* name, const double* params, std::uint64_t count) {
  const std::lock_guard lock(engine.mutex);
  const carom_plugin plugin = plugin_called(engine, name);
  for (const ShapeRecord& record : engine.shapes) {
    if (!plugin || !record.shape || record.plugin != engine.plugins[handle_slot(plugin)]) continue;
    const Array<double>& own = record.shape->params;
    if (own.size() == count && std::equal(own.begin(), own.end(), params)) return record.shape->handle;
  }
  return CAROM_NULL_HANDLE;
}

/// The same failure as argument number `argument` of the call that the host made.
std::int32_t blamed_on(std::int32_t result, std::int32_t argument, carom_error* error) {
  if (result != CAROM_OK && error && error->struct_size >= offsetof(carom_error, has_witness))
    error->argument = argument;
  return result;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_shape_create_named(carom_engine* engine, const char* name, const double* params, uint64_t count,
                                 carom_shape* shape, carom_error* error) {
  if (name && name == kHalfSpace) {
    const std::int32_t checked = guarded(error, [&](Call& call) {
      if (present(call, 1, "engine", engine) && present(call, 3, "params", params) && count != kHalfSpaceParams)
        call.fail(CAROM_E_OUT_OF_RANGE, 4, "count is %llu; half_space takes 4: normal x, y, z, offset",
                  static_cast<unsigned long long>(count));
    });
    return checked != CAROM_OK
               ? checked
               : blamed_on(carom_shape_create_half_space(engine, params, params[3], shape, error), 3, error);
  }
  Found found;
  std::int32_t result = guarded(error, [&](Call& call) {
    present(call, 1, "engine", engine) && present(call, 2, "name", name) && present(call, 3, "params", params) &&
        present(call, 5, "shape", shape);
  });
  if (result == CAROM_OK) result = find(engine, name, found, error);
  if (result == CAROM_OK && !found.plugin) {
    result = carom_plugin_load(engine, found.file.path, &found.plugin, error);
    if (result == CAROM_E_ALREADY_EXISTS) result = find(engine, name, found, error);  // another thread was faster
  }
  return result != CAROM_OK ? result : carom_shape_create(engine, found.plugin, params, count, shape, error);
}

int32_t carom_body_create_named(carom_world* world, uint32_t type, const char* name, const double* params,
                                uint64_t count, const double position[3], carom_body* body, carom_error* error) {
  std::int32_t result = guarded(error, [&](Call& call) {
    present(call, 1, "world", world) && known(call, 2, "type", type, CAROM_BODY_DYNAMIC + 1) &&
        present(call, 3, "name", name) && (count == 0 || present(call, 4, "params", params)) &&
        carom::abi::finite(call, 6, "position", position, 3) && present(call, 7, "body", body);
  });
  if (result != CAROM_OK) return result;
  carom_collider_desc collider_desc;
  carom_collider_desc_init(&collider_desc, sizeof collider_desc);
  collider_desc.shape = shape_like(world->engine, name, params, count);
  const bool is_new = !collider_desc.shape;
  if (is_new) {
    result = carom_shape_create_named(&world->engine, name, params, count, &collider_desc.shape, error);
    if (result != CAROM_OK) return blamed_on(result, error && error->argument > 1 ? error->argument + 1 : 0, error);
  }
  carom_body_desc desc;
  carom_body_desc_init(&desc, sizeof desc);
  desc.type = type;
  std::copy_n(position, 3, desc.position);
  carom_body made = CAROM_NULL_HANDLE;
  carom_collider collider = CAROM_NULL_HANDLE;
  result = carom_body_create(world, &desc, &made, error);
  if (result == CAROM_OK) {
    result = blamed_on(carom_collider_create(world, made, &collider_desc, &collider, error), 3, error);
    if (result != CAROM_OK) carom_body_destroy(world, made, nullptr);
  }
  if (result == CAROM_OK)
    *body = made;
  else if (is_new)
    carom_shape_destroy(&world->engine, collider_desc.shape, nullptr);
  return result;
}

}  // extern "C"

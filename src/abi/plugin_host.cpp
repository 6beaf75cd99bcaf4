// Taking in shape plugins: find the one data symbol, check what it says before anything is called, ask whether the
// support function is valid, and keep a copy. Nothing a plugin declares is believed later without this check.
#include <cmath>
#include <cstring>

#include "abi/engine.h"
#include "abi/forms.h"
#include "abi/loader.h"
#include "abi/standard_shapes.h"
#include "collision/verify.h"

namespace carom::abi {
namespace {

constexpr std::size_t kLongestId = 200;          // fits a message
constexpr std::size_t kLongestText = 1u << 16;   // of a support function
constexpr std::uint32_t kMostParams = 1u << 20;  // named parameters; a tail group repeats beyond
constexpr std::size_t kSmallestPlugin = offsetof(carom_shape_plugin, param_tail_group);  // up to and with `support`
constexpr std::size_t kSmallestGeometry = offsetof(carom_geometry, mass_form);           // form and core radius

/// A struct of a plugin: some version's size, nothing set that this library does not know. Unlike a host's struct it
/// may be in memory that the plugin's linker laid out, so `available` (0: unknown) bounds what is read.
template <class T>
bool take_in(Call& call, const char* name, const T* given, std::size_t smallest, std::size_t available, T& copy) {
  const std::uint32_t size = given->struct_size;
  if (size < smallest || size > kLargestStruct || size % alignof(T) || (available && size > available))
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: struct_size is %u, this library's is %zu", name, size, sizeof(T));
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  for (std::size_t i = sizeof(T); i < size; ++i)
    if (bytes[i])
      return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s sets a field at byte %zu, beyond the %zu that this library knows",
                       name, i, sizeof(T));
  std::memcpy(static_cast<void*>(&copy), given, std::min<std::size_t>(size, sizeof(T)));
  return true;
}

bool check_params(Call& call, const carom_shape_plugin& d) {
  if (d.param_count > kMostParams)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: param_count is %u, more than %u", d.id, d.param_count, kMostParams);
  if (d.param_count && !d.params) return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: params is NULL", d.id);
  if (d.param_tail_group > d.param_count)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: param_tail_group is %u of %u parameters", d.id, d.param_tail_group,
                     d.param_count);
  for (std::uint32_t i = 0; i < d.param_count; ++i) {
    const carom_param& p = d.params[i];
    if (!p.name || !p.name[0] || !p.unit || !p.unit[0])
      return call.fail(CAROM_E_PLUGIN_ABI, 2,
                       "%s: params[%u] lacks a name or a unit; the unit of a plain number is \"1\"", d.id, i);
    if (!(p.min <= p.max))
      return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: params[%u] has bounds [%g, %g]", d.id, i, p.min, p.max);
  }
  return true;
}

bool check_rules(Call& call, const carom_shape_plugin& d) {
  constexpr std::uint32_t kMostRules = 64;
  if (d.rule_count > kMostRules || (d.rule_count && !d.rules) || d.reserved)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: rule_count is %u (at most %u), rules %s, reserved %u", d.id,
                     d.rule_count, kMostRules, d.rules ? "given" : "NULL", d.reserved);
  for (std::uint32_t k = 0; k < d.rule_count; ++k) {
    const carom_param_rule& rule = d.rules[k];
    bool sound =
        rule.text && rule.term_count >= 1 && rule.term_count <= std::size(rule.param) && std::isfinite(rule.most);
    for (std::uint32_t i = 0; sound && i < rule.term_count; ++i)
      sound = rule.param[i] < d.param_count && std::isfinite(rule.weight[i]);
    if (!sound)
      return call.fail(CAROM_E_PLUGIN_ABI, 2,
                       "%s: rules[%u] needs a text, 1 to 4 terms of parameters there are, finite numbers", d.id, k);
  }
  return true;
}

bool check_geometry(Call& call, const carom_shape_plugin& d, carom_geometry& g) {
  for (std::uint32_t& a : g.form_arg) a = CAROM_NO_PARAM;
  for (std::uint32_t& a : g.mass_arg) a = CAROM_NO_PARAM;
  g.core_radius_param = CAROM_NO_PARAM;
  if (!d.geometry) return true;
  if (!take_in(call, "geometry", d.geometry, kSmallestGeometry, 0, g)) return false;
  if (g.core_radius_param != CAROM_NO_PARAM && g.core_radius_param >= d.param_count)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: core_radius_param is %u of %u parameters", d.id, g.core_radius_param,
                     d.param_count);
  return form_args_exist(call, d.id, "form", g.form, g.form_arg, d.param_count) &&
         form_args_exist(call, d.id, "mass", g.mass_form, g.mass_arg, d.param_count);
}

/// Everything about the struct that can be known without calling it.
bool check_description(Call& call, const carom_shape_plugin* given, std::size_t available, PluginRecord& record) {
  carom_shape_plugin& d = record.description;
  if (!take_in(call, "plugin", given, kSmallestPlugin, available, d)) return false;
  if (d.abi_major != CAROM_PLUGIN_ABI_MAJOR)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "the plugin has abi_major %u, this library has %u", d.abi_major,
                     CAROM_PLUGIN_ABI_MAJOR);
  if (d.flags & ~CAROM_PLUGIN_HOST_THREAD)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "flags is 0x%x; this library knows 0x%x", d.flags,
                     CAROM_PLUGIN_HOST_THREAD);
  if (!d.id || !d.id[0] || strnlen(d.id, kLongestId + 1) > kLongestId)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "id is %s", !d.id ? "NULL" : d.id[0] ? "longer than 200 bytes" : "empty");
  if (d.text && strnlen(d.text, kLongestText + 1) > kLongestText)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: text is longer than %zu bytes", d.id, kLongestText);
  if (!d.support) return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: support is NULL", d.id);
  if (!check_params(call, d) || !check_rules(call, d) || !check_geometry(call, d, record.geometry)) return false;
  record.given = given;
  record.id = d.id;
  d.id = record.id.c_str();
  if (d.text) record.text = d.text;
  d.text = nullptr;
  record.bounds.assign(d.params, d.params + d.param_count);
  record.rules.assign(d.rules, d.rules + d.rule_count);
  return true;
}

/// Parameters near 1 that the bounds allow, different from one another, of both signs where allowed; six groups of a
/// tail (a hull then has volume).
/// @param trial  0 the usual ones, then others
void sample_params(const PluginRecord& record, std::uint32_t trial, Array<double>& params) {
  params.clear();
  const carom_shape_plugin& d = record.description;
  const std::uint32_t group = d.param_tail_group;
  const std::uint32_t groups = group ? std::clamp(d.param_tail_min, 6u, 4096u) : 0;
  const std::uint32_t count = group ? d.param_count - group + group * groups : d.param_count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const carom_param& bound =
        record.bounds[i < d.param_count ? i : d.param_count - group + (i - d.param_count) % group];
    // Trials reach from 1/16 to 16 of the usual sizes, each parameter by itself: rules often compare two of them.
    const double scale =
        trial == 0 ? 1 : std::ldexp(1.0, static_cast<int>((trial * 0x9E3779B9u + i * 0x85EBCA6Bu) >> 28) % 9 - 4);
    const double size = scale * (0.5 + static_cast<double>((i * 7u) % 11u) / 11);
    const double wanted = bound.min < 0 && (i * 0x9E3779B9u) >> 31 ? -size : size;
    double value = std::clamp(wanted, bound.min, bound.max);
    if (value != wanted && std::isfinite(bound.min) && std::isfinite(bound.max))
      value = bound.min + (bound.max - bound.min) * (0.3 + 0.4 * size / scale / 1.5);  // inside, off the bounds
    params.push_back(value);
  }
}

/// 256 directions at sample parameters that fulfil the rules. Where none of them does, shapes are judged when they are made.
bool check_valid(Call& call, const PluginRecord& record, Memory* memory) {
  constexpr std::uint32_t kTrials = 256;
  Shape sample(memory);
  std::uint32_t trial = 0;
  do {
    if (trial == kTrials) return true;
    sample_params(record, trial++, sample.params);
  } while (broken_rule(record, sample.params.data()));
  sample.support = record.description.support, sample.user = record.description.user;
  return ask_valid(call, record.id.c_str(), 2, sample);
}

/// Add a checked plugin to the engine, unless one of its name is there.
void add(Call& call, carom_engine& engine, PluginRecord* record, carom_plugin* plugin) {
  const std::lock_guard lock(engine.mutex);
  for (const PluginRecord* other : engine.plugins)
    if (other && other->id == record->id) {
      call.fail(CAROM_E_ALREADY_EXISTS, 2, "a plugin with id \"%s\" is loaded", record->id.c_str());
      return;
    }
  engine.plugins.reserve(engine.plugins.size() + 1);
  const Handle handle = engine.plugin_slots.take();
  if (!handle) {
    call.fail(CAROM_E_LIMIT, 0, "%u plugins were loaded", kMaxSlots);
    return;
  }
  if (handle_slot(handle) == engine.plugins.size()) engine.plugins.push_back(nullptr);
  engine.plugins[handle_slot(handle)] = record;
  *plugin = handle;
}

/// "box" of "/usr/lib/carom/plugins/box.so".
std::string_view stem_of(std::string_view path) {
  path.remove_prefix(path.find_last_of(system::kSlashes) + 1);  // npos + 1 is 0
  return path.substr(0, path.rfind('.'));
}

/// @param path  of the file, or empty
void take_plugin(Call& call, carom_engine& engine, const carom_shape_plugin* given, std::size_t available,
                 std::string_view path, carom_plugin* plugin) {
  auto* record = make_on<PluginRecord>(&engine.memory, &engine.memory);
  try {
    record->file = stem_of(path);
    if (check_description(call, given, available, *record) && check_valid(call, *record, &engine.memory))
      add(call, engine, record, plugin);
  } catch (...) {
    destroy_on(&engine.memory, record);
    throw;
  }
  if (!call.ok()) {
    destroy_on(&engine.memory, record);
    return;
  }
  engine.log_message(CAROM_LOG_INFO, "plugin %s version %u ready", given->id, given->version);
}

}  // namespace

const carom_param_rule* broken_rule(const PluginRecord& plugin, const double* params) {
  for (const carom_param_rule& rule : plugin.rules) {
    double sum = 0;
    for (std::uint32_t i = 0; i < rule.term_count; ++i) sum += rule.weight[i] * params[rule.param[i]];
    if (!(sum <= rule.most)) return &rule;
  }
  return nullptr;
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_plugin_load(carom_engine* engine, const char* path, carom_plugin* plugin, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 2, "path", path) || !present(call, 3, "plugin", plugin))
      return;
    const EntrySymbol entry = load_entry_symbol(call, path, kSmallestPlugin);
    if (entry.description) take_plugin(call, *engine, entry.description, entry.bytes, path, plugin);
    call.name_file(path);
  });
}

int32_t carom_plugin_register(carom_engine* engine, const carom_shape_plugin* description, carom_plugin* plugin,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (present(call, 1, "engine", engine) && present(call, 2, "description", description) &&
        present(call, 3, "plugin", plugin))
      take_plugin(call, *engine, description, 0, {}, plugin);
  });
}

int32_t carom_plugin_unload(carom_engine* engine, carom_plugin plugin, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine)) return;
    const std::lock_guard lock(engine->mutex);
    if (!resolve(call, 2, "plugin", engine->plugin_slots, plugin)) return;
    PluginRecord*& record = engine->plugins[handle_slot(plugin)];
    if (record->uses) {
      call.fail(CAROM_E_IN_USE, 2, "%llu shapes of %s are alive", static_cast<unsigned long long>(record->uses),
                record->id.c_str());
      return;
    }
    destroy_on(&engine->memory, record);
    record = nullptr;
    engine->plugin_slots.release(handle_slot(plugin));
  });
}

int32_t carom_plugins_register_standard(carom_engine* engine, carom_error* error) {
  const auto shapes = standard_shapes();
  std::int32_t result = guarded(error, [&](Call& call) {
    if (present(call, 1, "engine", engine) && shapes.empty())
      call.fail(
          CAROM_E_UNSUPPORTED, 0,
          "no plugins are linked into this library: carom_shape_create_named() finds files, carom_plugin_load() loads one");
  });
  carom_plugin handle = CAROM_NULL_HANDLE;
  const auto has = [&](const carom_shape_plugin* shape) {
    return carom_plugin_find(engine, shape->id, &handle, nullptr) == CAROM_OK;
  };
  std::uint64_t made = 0;  // bit i: by this call
  for (std::size_t i = 0; i < shapes.size() && result == CAROM_OK; ++i) {
    if (has(shapes[i])) continue;
    result = carom_plugin_register(engine, shapes[i], &handle, error);
    if (result == CAROM_OK) made |= std::uint64_t(1) << i;
    if (result == CAROM_E_ALREADY_EXISTS) result = CAROM_OK;  // another thread was faster
  }
  for (std::size_t i = 0; i < shapes.size() && result != CAROM_OK; ++i)
    if (made >> i & 1 && has(shapes[i])) carom_plugin_unload(engine, handle, nullptr);
  return result;
}

int32_t carom_plugin_find(carom_engine* engine, const char* id, carom_plugin* plugin, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 2, "id", id) || !present(call, 3, "plugin", plugin))
      return;
    const std::lock_guard lock(engine->mutex);
    for (std::uint32_t slot = 0; slot < engine->plugins.size(); ++slot)
      if (engine->plugins[slot] && engine->plugins[slot]->id == id) {
        *plugin = engine->plugin_slots.handle(slot);
        return;
      }
    call.fail(CAROM_E_NOT_FOUND, 2, "no plugin with id \"%.180s\" is loaded", id);
  });
}

int32_t carom_plugin_describe(carom_engine* engine, carom_plugin plugin, const carom_shape_plugin** description,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 3, "description", description)) return;
    const std::lock_guard lock(engine->mutex);
    if (resolve(call, 2, "plugin", engine->plugin_slots, plugin))
      *description = engine->plugins[handle_slot(plugin)]->given;
  });
}

}  // extern "C"

// Owners of engine and world over the C ABI; every failed call becomes an Error with its remedy.
#include "host/host.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace carom::tools {

void Call::done(int32_t result, const std::string& doing) const {
  if (result == CAROM_OK) return;
  const std::string why = error_.code == result && error_.message[0] ? error_.message : carom_result_name(result);
  const std::string remedy = error_.code == result && error_.remedy[0] ? error_.remedy : carom_result_remedy(result);
  throw Error(doing + ": " + why, remedy, result);
}

Engine::Engine(PluginPath path, const carom_engine_desc* desc) : path_(std::move(path)) {
  Call call;
  call.done(carom_engine_create(desc, &engine_, call), "creating an engine");
}

void Engine::set_threads(std::uint32_t threads) {
  carom_jobs_desc desc;
  carom_jobs_desc_init(&desc, sizeof desc);
  desc.threads = threads;
  Call call;
  call.done(carom_engine_set_jobs(engine_, &desc, call), "starting threads");
}

void Engine::set_jobs(void (*run)(void*, carom_job_fn, void*, std::uint32_t), void* user) {
  carom_jobs_desc desc;
  carom_jobs_desc_init(&desc, sizeof desc);
  desc.run = run, desc.user = user;
  Call call;
  call.done(carom_engine_set_jobs(engine_, &desc, call), "lending threads");
}

Engine::~Engine() { carom_engine_destroy(engine_, nullptr); }

carom_plugin Engine::load(const std::string& absolute_path) {
  carom_plugin handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_plugin_load(engine_, absolute_path.c_str(), &handle, call), "loading " + absolute_path);
  return handle;
}

carom_plugin Engine::plugin(const std::string& name) {
  if (const auto found = plugins_.find(name); found != plugins_.end()) return found->second;
  const carom_plugin handle = load(path_.find(name));
  plugins_.emplace(name, handle);
  return handle;
}

void Engine::load_all() {
  for (const auto& file : path_.all()) {
    try {
      plugin(file.first);
    } catch (const Error&) {
      // Whoever needs it is told that it is missing.
    }
  }
}

std::vector<double> Engine::add(HullOf hull) {
  const auto at = std::find(hulls_.begin(), hulls_.end(), hull);
  const auto number = static_cast<double>(at - hulls_.begin());
  if (at == hulls_.end()) hulls_.push_back(std::move(hull));
  return {number};
}

carom_shape Engine::make(const HullOf& hull) {
  std::vector<carom_shape> parts;
  std::vector<double> positions, orientations, scales;
  for (const HullPart& part : hull.parts) {
    parts.push_back(shape(part.shape, part.params));
    positions.insert(positions.end(), part.position.begin(), part.position.end());
    orientations.insert(orientations.end(), part.orientation.begin(), part.orientation.end());
    scales.insert(scales.end(), part.scale.begin(), part.scale.end());
  }
  carom_shape handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_shape_create_hull_of(engine_, parts.data(), parts.size(), positions.data(), orientations.data(),
                                       scales.data(), hull.radius, &handle, call),
            "making a hull of shapes");
  return handle;
}

carom_shape Engine::shape(const std::string& plugin_name, const std::vector<double>& params) {
  auto key = std::make_pair(plugin_name, params);
  if (const auto found = shapes_.find(key); found != shapes_.end()) return found->second;
  if (plugin_name == "hull_of") {
    const HullOf hull = hull_of(params);
    return shapes_[key] = make(hull);
  }
  carom_shape handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_shape_create(engine_, plugin(plugin_name), params.data(), params.size(), &handle, call),
            "making a shape of plugin " + plugin_name);
  shapes_.emplace(std::move(key), handle);
  return handle;
}

carom_shape Engine::half_space(const double normal[3], double offset) {
  auto key = std::make_pair(std::string("half_space"), std::vector<double>{normal[0], normal[1], normal[2], offset});
  if (const auto found = shapes_.find(key); found != shapes_.end()) return found->second;
  carom_shape handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_shape_create_half_space(engine_, normal, offset, &handle, call), "making a half-space");
  shapes_.emplace(std::move(key), handle);
  return handle;
}

carom_shape Engine::height_field(const std::vector<double>& params) {
  auto key = std::make_pair(std::string("height_field"), params);
  if (const auto found = shapes_.find(key); found != shapes_.end()) return found->second;
  carom_height_field_desc field;
  carom_shape handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_height_field_desc_init(&field, sizeof field), "making a height field");
  for (const std::size_t k : {std::size_t(0), std::size_t(1)})
    if (!(params.at(k) >= 2 && params.at(k) <= 16384 && params.at(k) == std::floor(params.at(k))))
      throw Error("a height field of " + std::to_string(params[k]) + (k ? " rows" : " columns"),
                  "give whole numbers from 2 to 16384");
  field.columns = static_cast<std::uint32_t>(params[0]), field.rows = static_cast<std::uint32_t>(params[1]);
  field.spacing[0] = params.at(2), field.spacing[1] = params.at(3);
  if (params.size() != 4 + std::size_t(field.columns) * field.rows)
    throw Error("a height field of " + std::to_string(field.columns) + " by " + std::to_string(field.rows) +
                    " vertices has another number of heights",
                "give one height for each vertex");
  field.heights = params.data() + 4;
  call.done(carom_shape_create_height_field(engine_, &field, &handle, call), "making a height field");
  shapes_.emplace(std::move(key), handle);
  return handle;
}

carom_shape Engine::mesh(const std::vector<double>& params) {
  auto key = std::make_pair(std::string("mesh"), params);
  if (const auto found = shapes_.find(key); found != shapes_.end()) return found->second;
  const bool counted = params.size() > 1 && params[1] >= 0 && params[1] < 1e9 && params[1] == std::floor(params[1]);
  const std::size_t vertices = counted ? std::size_t(params[1]) : 0;
  if (!counted || !(params[0] >= 0 && params[0] < 4294967296.0 && params[0] == std::floor(params[0])))
    throw Error("a mesh whose flags or number of vertices are no whole numbers",
                "give flags, then how many vertices there are");
  if (params.size() < 2 + 3 * vertices || (params.size() - 2) % 3 != 0)
    throw Error("a mesh of " + std::to_string(params.size()) + " parameters",
                "give flags, the number of vertices, their x, y, z, then three indices a triangle");
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 2 + 3 * vertices; i < params.size(); ++i)
    corners.push_back(params[i] >= 0 && params[i] < 4294967295.0 ? static_cast<std::uint32_t>(params[i]) : UINT32_MAX);
  carom_mesh_desc desc;
  carom_shape handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_mesh_desc_init(&desc, sizeof desc), "making a mesh");
  desc.flags = static_cast<std::uint32_t>(params[0]);
  desc.vertices = params.data() + 2, desc.vertex_count = vertices;
  desc.triangles = corners.data(), desc.triangle_count = corners.size() / 3;
  call.done(carom_shape_create_mesh(engine_, &desc, &handle, call), "making a mesh");
  shapes_.emplace(std::move(key), handle);
  return handle;
}

carom_shape_info Engine::info(carom_shape shape_handle) const {
  carom_shape_info info{};
  info.struct_size = sizeof info;
  Call call;
  call.done(carom_shape_get_info(engine_, shape_handle, &info, call), "asking about a shape");
  return info;
}

std::vector<double> Engine::params(carom_shape shape_handle) const {
  std::vector<double> values(info(shape_handle).param_count);
  std::uint64_t count = values.size();
  Call call;
  call.done(carom_shape_get_params(engine_, shape_handle, values.data(), &count, call), "asking about a shape");
  return values;
}

const carom_shape_plugin& Engine::describe(carom_plugin handle) const {
  const carom_shape_plugin* description = nullptr;
  Call call;
  call.done(carom_plugin_describe(engine_, handle, &description, call), "asking a plugin for its description");
  return *description;
}

std::vector<std::string> Engine::loaded() const {
  std::vector<std::string> names;
  for (const auto& [name, handle] : plugins_) names.push_back(name);
  return names;
}

World::World(Engine& engine, const carom_world_desc* desc) {
  Call call;
  call.done(carom_world_create(engine.get(), desc, &world_, call), "creating a world");
}

World::~World() { carom_world_destroy(world_, nullptr); }

std::vector<char> World::save(std::uint32_t flags) const {
  std::uint64_t size = 0;
  Call call;
  call.done(carom_world_save(world_, flags, nullptr, 0, &size, call), "measuring the state");
  std::vector<char> bytes(size);
  call.done(carom_world_save(world_, flags, bytes.data(), size, &size, call), "saving the state");
  return bytes;
}

void World::restore(const std::vector<char>& state, const std::string& from) {
  Call call;
  call.done(carom_world_restore(world_, state.empty() ? "" : state.data(), state.size(), call),
            "going on from " + from);
}

void World::step(double dt) {
  Call call;
  call.done(carom_world_step(world_, dt, call), "stepping the world");
}

carom_step_report World::report() const {
  carom_step_report report{};
  report.struct_size = sizeof report;
  Call call;
  call.done(carom_world_get_report(world_, &report, call), "reading the step report");
  return report;
}

void World::keep_ledger() {
  Call call;
  call.done(carom_world_enable_ledger(world_, 1, call), "beginning a ledger");
}

std::vector<carom_ledger_entry> World::ledger() const {
  std::uint64_t count = 0;
  Call call;
  call.done(carom_world_get_ledger(world_, nullptr, 0, 0, &count, call), "counting causes");
  std::vector<carom_ledger_entry> list(count);
  call.done(carom_world_get_ledger(world_, list.data(), sizeof(carom_ledger_entry), count, &count, call),
            "reading the ledger");
  return list;
}

carom_ledger_state World::ledger_state() const {
  carom_ledger_state state{};
  state.struct_size = sizeof state;
  Call call;
  call.done(carom_world_get_ledger_state(world_, &state, call), "reading the ledger's sums");
  return state;
}

void World::collect_contact_events(double hit_speed) {
  Call call;
  call.done(carom_world_collect_events(world_, CAROM_EVENTS_CONTACT, hit_speed, call), "asking for events");
}

std::vector<carom_contact_event> World::contact_events() const {
  std::uint64_t count = 0;
  Call call;
  call.done(carom_world_get_contact_events(world_, nullptr, sizeof(carom_contact_event), 0, &count, call),
            "counting events");
  std::vector<carom_contact_event> list(count);
  call.done(carom_world_get_contact_events(world_, list.data(), sizeof(carom_contact_event), count, &count, call),
            "reading events");
  return list;
}

std::vector<carom_contact> World::contacts() const {
  std::uint64_t count = 0;
  Call call;
  call.done(carom_world_get_contacts(world_, nullptr, sizeof(carom_contact), 0, &count, call), "counting contacts");
  std::vector<carom_contact> list(count);
  call.done(carom_world_get_contacts(world_, list.data(), sizeof(carom_contact), count, &count, call),
            "reading contacts");
  return list;
}

std::vector<carom_fault> World::faults() const {
  std::uint64_t count = 0;
  Call call;
  call.done(carom_world_get_faults(world_, nullptr, sizeof(carom_fault), 0, &count, call), "counting faults");
  std::vector<carom_fault> list(count);
  call.done(carom_world_get_faults(world_, list.data(), sizeof(carom_fault), count, &count, call), "reading faults");
  return list;
}

std::vector<carom_body> World::bodies() const {
  std::uint64_t count = 0;
  Call call;
  call.done(carom_world_get_bodies(world_, nullptr, 0, &count, call), "counting bodies");
  std::vector<carom_body> list(count);
  call.done(carom_world_get_bodies(world_, list.data(), count, &count, call), "listing bodies");
  return list;
}

std::uint64_t World::hash() const {
  std::uint64_t hash = 0;
  Call call;
  call.done(carom_world_hash(world_, &hash, call), "hashing the world");
  return hash;
}

std::size_t field_width(std::uint32_t field) {
  constexpr std::size_t kWidths[CAROM_FIELD_COUNT] = {3, 4, 7, 3, 3, 6, 6, 3, 1};
  return field < CAROM_FIELD_COUNT ? kWidths[field] : 0;
}

std::size_t joint_bulk_width(std::uint32_t field) {
  std::uint32_t width = 0;
  return carom_joint_bulk_width(field, &width) == CAROM_OK ? width : 0;
}

void World::read(std::uint32_t field, const std::vector<carom_body>& which, std::vector<double>& dst) const {
  dst.resize(which.size() * field_width(field));
  if (which.empty()) return;
  Call call;
  call.done(carom_world_read(world_, field, CAROM_SCALAR_F64, which.data(), which.size(), dst.data(), 0, call),
            "reading the bodies");
}

void World::set_dial(std::uint32_t dial_index, double value) {
  Call call;
  call.done(carom_world_set_dial(world_, dial_index, value, call), "setting a dial");
}

double World::dial(std::uint32_t dial_index) const {
  double value = 0;
  Call call;
  call.done(carom_world_get_dial(world_, dial_index, &value, call), "reading a dial");
  return value;
}

void World::set_dial(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, equals);
  if (name == "preset" && equals != std::string::npos) return set_preset(assignment.substr(equals + 1));
  std::uint32_t index = 0;
  const std::int32_t found = carom_dial_find(name.c_str(), &index, nullptr);
  if (found == CAROM_E_READ_ONLY)
    throw Error("'" + name + "' is a constant, not a dial",
                "it is fixed: `carom dials` says why, and lists what can be set");
  if (found != CAROM_OK) {
    std::vector<std::string> names;
    for (const carom_dial_info& d : all_dials()) names.emplace_back(d.name);
    const std::string near = nearest_name(name, names);
    throw Error(name.empty() ? "--dial " + assignment + " names no dial" : "there is no dial called '" + name + "'",
                (near.empty() ? std::string() : "did you mean '" + near + "'? ") + "`carom dials` lists them all");
  }
  const carom_dial_info info = dial_info(index);
  if (equals == std::string::npos)
    throw Error("--dial " + name + " has no value", "write --dial " + name + "=VALUE; `carom dials` shows the bounds");
  const std::string text = assignment.substr(equals + 1);
  std::string choices;
  for (std::uint32_t i = 0; i < info.choice_count; ++i) {
    if (text == info.choices[i]) return set_dial(index, i);
    choices += (i ? ", " : "") + std::string(info.choices[i]);
  }
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size())
    throw Error("dial " + name + ": '" + text + "' is not a value of it",
                choices.empty() ? "give a number; `carom dials` shows the bounds" : "choose one of: " + choices);
  Call call;
  const std::int32_t result = carom_world_set_dial(world_, index, value, call);
  if (result != CAROM_E_OUT_OF_RANGE && result != CAROM_E_NOT_FINITE && result != CAROM_E_UNKNOWN_ENUM)
    return call.done(result, "dial " + name);
  std::ostringstream bounds;
  bounds << (info.kind == CAROM_DIAL_KIND_INTEGER ? "a whole number from " : "a number from ") << info.min << " to "
         << info.max << (info.unit[0] ? " " : "") << info.unit << "; a new world has " << info.initial;
  throw Error("dial " + name + " cannot be " + text,
              choices.empty() ? "give " + bounds.str() : "choose one of: " + choices);
}

std::vector<std::string> all_presets() {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < CAROM_PRESET_COUNT; ++i) names.emplace_back(carom_preset_name(i));
  return names;
}

void World::set_preset(const std::string& name) {
  const std::vector<std::string> names = all_presets();
  std::string list;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) {
      Call call;
      return call.done(carom_world_set_preset(world_, i, call), "preset " + name);
    }
    list += (i ? ", " : "") + names[i];
  }
  const std::string near = nearest_name(name, names);
  throw Error("there is no preset called '" + name + "'",
              (near.empty() ? std::string() : "did you mean '" + near + "'? ") + "the presets are: " + list);
}

carom_dial_info dial_info(std::uint32_t dial) {
  carom_dial_info info{};
  info.struct_size = sizeof info;
  Call call;
  call.done(carom_dial_get_info(dial, &info, call), "asking about a dial");
  return info;
}

std::vector<carom_dial_info> all_dials() {
  std::uint32_t count = 0;
  Call call;
  call.done(carom_dial_get_count(&count), "counting dials");
  std::vector<carom_dial_info> list;
  for (std::uint32_t i = 0; i < count; ++i) list.push_back(dial_info(i));
  return list;
}

std::vector<carom_constant_info> all_constants() {
  std::uint32_t count = 0;
  Call call;
  call.done(carom_constant_get_count(&count), "counting constants");
  std::vector<carom_constant_info> list(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    list[i].struct_size = sizeof list[i];
    call.done(carom_constant_get_info(i, &list[i], call), "asking about a constant");
  }
  return list;
}

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = name.size() / 2 + 2;  // further than this, a suggestion would only confuse
  for (const std::string& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= name.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t replace = diagonal + (name[i - 1] != candidate[j - 1]);
        diagonal = row[j];
        row[j] = std::min({row[j] + 1, row[j - 1] + 1, replace});
      }
    }
    if (row.back() < least) {
      least = row.back();
      best = candidate;
    }
  }
  return best;
}

}  // namespace carom::tools

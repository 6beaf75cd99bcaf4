// The C ABI as a C++ host likes it: owners that clean up, failed calls that throw. For tools only; it sees include/
// alone.
#pragma once

#include <carom/carom.h>

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace carom::tools {

/// Something went wrong, and what to do about it. what() is the message; the remedy is a sentence of its own.
class Error : public std::runtime_error {
 public:
  Error(const std::string& message, std::string remedy_text, int32_t result = 0)
      : std::runtime_error(message), remedy(std::move(remedy_text)), code(result) {}
  std::string remedy;
  int32_t code;  ///< CAROM_E_* if a call of the library failed, else 0
};

/// Details of one call: `Call c; c.done(carom_x(..., c), "doing x");`
class Call {
 public:
  operator carom_error*() { return &error_; }
  /// @throws Error with the library's message and remedy, prefixed by what we were doing, unless result is CAROM_OK
  void done(int32_t result, const std::string& doing) const;

 private:
  carom_error error_ = CAROM_ERROR_INIT;
};

/// Letters, digits, _ and -; dots within; at most 64 of them. A name is no path.
bool is_plugin_name(const std::string& name);

/// PREFIX or build/PRESET, whose bin/ holds the program that runs; empty where neither the kernel nor the loader says it.
/// @param link  the kernel's; where it is not mounted, the name by which the program was started counts
std::string own_base(const char* link = "/proc/self/exe");

/// Folders in which plugins are looked for, in order. Built once from the command line.
class PluginPath {
 public:
  /// @param explicit_dirs  --plugins DIR; searched first, then $CAROM_PLUGIN_PATH (colon-separated), then beside the
  ///                       executable: ../plugins (a build folder) and ../<libdir>/carom/plugins (an installation)
  explicit PluginPath(std::vector<std::string> explicit_dirs = {});
  /// Absolute path of NAME.so.   @throws Error that lists the folders searched
  std::string find(const std::string& name) const;
  /// Absolute paths of every .so in the folders, by name; the first folder that has a name wins.
  std::map<std::string, std::string> all() const;
  const std::vector<std::string>& folders() const { return folders_; }

 private:
  std::vector<std::string> folders_;
};

/// What a hull of shapes is made of.
struct HullPart {
  std::string shape;           ///< as of Engine::shape()
  std::vector<double> params;  ///< likewise
  std::array<double, 3> position{0, 0, 0};
  std::array<double, 4> orientation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};
  bool operator==(const HullPart&) const = default;
};
struct HullOf {
  std::vector<HullPart> parts;
  double radius = 0;  ///< m
  bool operator==(const HullOf&) const = default;
};

/// An engine, the plugins loaded into it by short name ("sphere"), and shapes shared by equal parameters.
class Engine {
 public:
  explicit Engine(PluginPath path = PluginPath(), const carom_engine_desc* desc = nullptr);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  carom_engine* get() const { return engine_; }
  void set_threads(std::uint32_t threads);  ///< of steps; before the first world   @throws Error
  /// Likewise, by a function that has the parts of each loop done, @see carom_jobs_desc.
  void set_jobs(void (*run)(void* user, carom_job_fn job, void* context, std::uint32_t count), void* user);
  const PluginPath& path() const { return path_; }
  carom_plugin plugin(const std::string& name);         ///< loads plugins/NAME.so on first use   @throws Error
  carom_plugin load(const std::string& absolute_path);  ///< @throws Error
  void load_all();                                      ///< of the path; what cannot be loaded is left out
  carom_shape shape(const std::string& plugin_name, const std::vector<double>& params);  ///< made once per params
  /// The params with which shape("hull_of") makes it.   @throws Error
  std::vector<double> add(HullOf hull);
  const HullOf& hull_of(const std::vector<double>& params) const {
    return hulls_.at(static_cast<std::size_t>(params.at(0)));
  }
  carom_shape half_space(const double normal[3], double offset);  ///< made once
  /// Made once. @param params  columns, rows, spacing along x and z (m), then heights row by row (m)
  carom_shape height_field(const std::vector<double>& params);
  /// Made once. @param params  flags, number of vertices, their x, y, z (m), then three indices a triangle
  carom_shape mesh(const std::vector<double>& params);
  carom_shape_info info(carom_shape shape) const;
  std::vector<double> params(carom_shape shape) const;
  const carom_shape_plugin& describe(carom_plugin plugin) const;
  std::vector<std::string> loaded() const;  ///< short names of plugins loaded so far, sorted

 private:
  carom_shape make(const HullOf& hull);

  PluginPath path_;
  carom_engine* engine_ = nullptr;
  std::map<std::string, carom_plugin> plugins_;
  std::map<std::pair<std::string, std::vector<double>>, carom_shape> shapes_;
  std::vector<HullOf> hulls_;
};

/// A world of an engine; the engine must outlive it.
class World {
 public:
  explicit World(Engine& engine, const carom_world_desc* desc = nullptr);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  carom_world* get() const { return world_; }
  void step(double dt);
  carom_step_report report() const;
  /// Collect what began to touch, parted or was hit, from the next step on.
  void collect_contact_events(double hit_speed);
  std::vector<carom_contact_event> contact_events() const;  ///< of the last step
  std::vector<carom_contact> contacts() const;
  /// How errors grow by themselves from here, in so many steps.   @param dt  s
  carom_growth growth(double dt, std::uint32_t steps) const;
  std::vector<carom_island> islands() const;  ///< worst first; none where no accuracy is asked for
  std::vector<carom_fault> faults() const;
  std::vector<carom_body> bodies() const;
  std::uint64_t hash() const;
  void keep_ledger();  ///< from now on
  std::vector<carom_ledger_entry> ledger() const;
  carom_ledger_state ledger_state() const;
  /// One field (CAROM_FIELD_*) of the bodies given, doubles, tightly packed into dst (resized).
  void read(std::uint32_t field, const std::vector<carom_body>& which, std::vector<double>& dst) const;
  void set_dial(std::uint32_t dial, double value);
  double dial(std::uint32_t dial) const;
  /// `name=value`, the value a number or the name of a choice; or `preset=fast`.   @throws Error naming the nearest dial or the choices
  void set_dial(const std::string& assignment);
  /// @param tolerance  m and rad per second of motion that are borne: carom/accuracy.h   @throws Error
  void ask(double tolerance);
  /// @throws Error naming the nearest preset and all of them
  void set_preset(const std::string& name);
  /// @param mode  CAROM_MODE_*   @throws Error naming the nearest effect and all of them
  void set_effect(const std::string& name, std::uint32_t mode);
  void time_effects(bool on);
  std::vector<carom_plan_line> plan() const;  ///< of the last step: stages, then effects
  std::vector<char> save(std::uint32_t flags = CAROM_SNAPSHOT_STATE) const;
  /// @param from  says in errors where the state came from   @throws Error; then nothing has changed
  void restore(const std::vector<char>& state, const std::string& from);

 private:
  carom_world* world_ = nullptr;
};

/// Number of doubles in one record of a CAROM_FIELD_*.
std::size_t field_width(std::uint32_t field);
/// Likewise of CAROM_JOINT_BULK_*; 0: there is no such field.
std::size_t joint_bulk_width(std::uint32_t field);

/// A dial's documentation, by index.   @throws Error
carom_dial_info dial_info(std::uint32_t dial);
std::vector<carom_dial_info> all_dials();
/// Numbers of the library that no host sets.
std::vector<carom_constant_info> all_constants();

/// Names of CAROM_PRESET_*, in order.
std::vector<std::string> all_presets();

/// The candidate that differs from `name` by the fewest edits (insert, delete, replace a letter); "" if none is close.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace carom::tools

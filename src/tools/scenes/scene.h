// Parametric scenes: one description, many uses (the command, tests, reports, benchmarks). A scene fills a Stage
// through the public C ABI and says what to look for.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/host.h"
#include "mesh/mesh.h"

namespace carom::tools {

using Vec = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;

/// The least turn from one direction to another; about some axis across where they are opposite. Neither is zero.
/// (Eigen's own brings a singular value decomposition into each file that calls it: 3 s of compile time.)
Quat turn_between(const Vec& from, const Vec& to);

/// A collider as a scene describes it.
struct Part {
  std::string shape;  ///< plugin name ("box"), or "half_space" with params nx, ny, nz, offset, or "height_field" or
      ///< "mesh" with those of Engine::height_field(), Engine::mesh(), or "hull_of" with Engine::add()'s
  std::vector<double> params;  ///< of the plugin
  Vec position = Vec::Zero();  ///< m, body frame
  Quat orientation = Quat::Identity();
  double density = 1000;  ///< kg/m^3
  double friction = 0.5;
  double restitution = 0;
  std::uint32_t friction_mix = CAROM_MIX_GEOMETRIC_MEAN, restitution_mix = CAROM_MIX_MAXIMUM;
  double rolling = 0, spinning = 0;    ///< m: carom_material_set_resistance()
  Vec surface_velocity = Vec::Zero();  ///< m/s, axes of the shape: of its surface, while it stays
  Vec surface_spin = Vec::Zero();      ///< rad/s, likewise, about its origin
  int mesh = -1;                       ///< index into Stage::meshes to draw instead of the shape, or -1
  carom_collider collider = CAROM_NULL_HANDLE;

  bool is_ground() const {  ///< no plugin's convex shape
    return shape == "half_space" || shape == "height_field" || shape == "mesh";
  }
};

/// A body or a particle as a scene describes it, and the handle it got.
struct Actor {
  std::string name;  ///< unique within the stage: "domino 3"
  std::string kind;  ///< what it is in summaries, colours and plots: "domino"
  std::uint32_t type = CAROM_BODY_DYNAMIC;
  Vec position = Vec::Zero();  ///< m, world
  Quat orientation = Quat::Identity();
  Vec linear_velocity = Vec::Zero();               ///< m/s, world
  Vec angular_velocity = Vec::Zero();              ///< rad/s, world
  double mass = 0;                                 ///< kg; 0: from the parts' densities
  std::optional<Vec> center;                       ///< m, body frame; needs a mass, as does the next
  std::optional<Eigen::Matrix3d> inertia;          ///< kg m^2, body axes, about the centre
  double linear_damping = 0, angular_damping = 0;  ///< 1/s
  std::vector<Part> parts;                         ///< none: a point
  carom_body body = CAROM_NULL_HANDLE;
  carom_particles particles = CAROM_NULL_HANDLE;  ///< instead of body: the set it is in, the actors of a set side by
  std::uint32_t index = 0;                        ///< side, and its place there
};

/// Two actors whose bodies a joint holds together.
struct Tie {
  std::uint32_t kind = CAROM_JOINT_BALL;
  std::size_t a = 0, b = 0;  ///< indices of actors
  Vec at = Vec::Zero();      ///< m, world, as they were joined
  carom_joint joint = CAROM_NULL_HANDLE;
};

/// A spring between two actors, or one and the world (carom/force.h).
struct Bungee {
  static constexpr std::size_t kWorld = static_cast<std::size_t>(-1);
  std::size_t a = kWorld, b = kWorld;           ///< indices of actors
  Vec at_a = Vec::Zero(), at_b = Vec::Zero();   ///< m, in the body's frame, or world
  double rest = 0, stiffness = 0, damping = 0;  ///< m, N/m, N s/m
  bool only_pulls = true;
  carom_spring spring = CAROM_NULL_HANDLE;
};

/// A world being set up and run, with what the scene knows of its bodies. Colliders of equal surface share a material.
class Stage {
 public:
  Stage(Engine& engine, const carom_world_desc* desc = nullptr) : engine_(engine), world(engine, desc) {}

  /// Create the body and its colliders.   @return index into actors   @throws Error
  std::size_t add(Actor actor);
  /// Make a set of particles, in the order of `start`: positions, velocities and names count, parts there are none.
  /// @param mass  kg, of each   @return index of the first into actors   @throws Error
  std::size_t add_particles(std::vector<Actor> start, double mass = 1);
  /// A static half-space { x : normal . x <= normal . point }.
  std::size_t add_half_space(const std::string& name, const Vec& normal, const Vec& point, double friction = 0.5);
  /// A square of ground, `half` to each side of the origin, between four walls of half-spaces. A body a metre beyond
  /// one of them has escaped: more than any contact may sink.
  void add_walled_ground(double half);

  /// Join two bodies as they stand.   @param axes  joint -> world   @throws Error
  carom_joint join(std::uint32_t kind, std::size_t a, std::size_t b, const Vec& at,
                   const Quat& axes = Quat::Identity());
  /// As a descriptor says, in body frames; one body may be the world.   @throws Error, which begins with `joining`
  carom_joint join(const carom_joint_desc& desc, const std::string& joining);

  void add_spring(Bungee bungee);  ///< @throws Error
  /// How air resists an actor.   @param linear  kg/s   @param quadratic  kg/m   @throws Error
  void set_drag(std::size_t actor, double linear, double quadratic);
  void set_wind(const Vec& velocity);                          ///< m/s   @throws Error
  void set_water(const carom_water& water);                    ///< @throws Error
  void add_field(const carom_force_field_desc& desc);          ///< @throws Error
  void set_field_mask(std::size_t actor, std::uint32_t mask);  ///< @throws Error
  void set_gravity_factor(std::size_t actor, double factor);   ///< @throws Error

  Engine& engine() { return engine_; }
  Vec position(std::size_t actor) const;  ///< m, world: origin of the body frame
  Quat orientation(std::size_t actor) const;
  Vec velocity(std::size_t actor) const;  ///< m/s, world, of the centre of mass
  /// One field of all actors, in order, tightly packed into dst (resized): CAROM_FIELD_POSITION, ORIENTATION, POSE,
  /// LINEAR_VELOCITY or VELOCITY. A particle is not turned and does not spin.
  void read(std::uint32_t field, std::vector<double>& dst) const;
  std::size_t particle_count() const;  ///< of the actors

 private:
  Engine& engine_;
  std::map<std::array<double, 6>, carom_material> materials_;  // by what a part says of its surface

 public:
  World world;
  std::vector<Actor> actors;
  std::vector<Tie> ties;
  std::vector<Bungee> bungees;
  std::vector<carom_force_field> fields;
  std::optional<double> water_level;     ///< m, y: where set_water() put level water
  std::vector<Mesh> meshes;              ///< for the eye only; the physics uses convex shapes
  std::vector<std::string> remarks;      ///< what a viewer of the run should know: credits, stand-ins
  Vec bounds_min = Vec(-1e3, -1, -1e3);  ///< m: a body whose origin leaves these bounds has escaped
  Vec bounds_max = Vec(1e3, 1e3, 1e3);
  double ground_half_width = 10;                             ///< m, floor drawn by viewers; 0: none
  Vec camera_from = Vec(0, 5, 15), camera_to = Vec::Zero();  ///< m, where viewers stand and what they look at
};

/// Watches a run and tells its story ("the bunny left the plank at 5.1 m/s").
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void watch(const Stage& stage, double time) = 0;              ///< after every step
  virtual std::vector<std::string> tell(const Stage& stage) const = 0;  ///< sentences, at the end
  /// Did what the scene is about happen? Judged by the same events that tell() reports.
  virtual bool came_off(const Stage& stage) const = 0;
};

/// A number that a scene can be asked to change.
struct Knob {
  std::string name;  ///< "n"
  std::string unit;  ///< "m", "" for counts
  std::string help;
  double initial, min, max;
  bool whole = false;
};

/// Values of a scene's knobs, plus the mesh file.
struct Settings {
  std::vector<std::pair<std::string, double>> values;  ///< overrides, by knob name
  std::string mesh_path;                               ///< "": the default search
};

struct Scene {
  std::string name;
  std::string summary;   ///< one sentence
  std::string look_for;  ///< one sentence: what to look for
  std::vector<Knob> knobs;
  double seconds;  ///< suggested duration
  double dt;       ///< s, suggested step
  std::unique_ptr<Observer> (*fill)(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path);
};

/// Every scene, in the order of `carom list`.
const std::vector<Scene>& all_scenes();
/// @throws Error with the nearest name and the list
const Scene& find_scene(const std::string& name);
/// Check the settings against the scene's knobs and fill the stage.
/// @return the observer, or null   @throws Error (unknown knob, out of bounds, plugin or mesh missing)
std::unique_ptr<Observer> build(const Scene& scene, const Settings& settings, Stage& stage);

}  // namespace carom::tools

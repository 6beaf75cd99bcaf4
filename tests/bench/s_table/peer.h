// What an engine under test is given and asked. Plain data: each engine lives in a link namespace of its own and shares
// no header, no allocator and no C++ library with the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>

namespace carom::bench {

/// The last three are asked of the engines of accuracy_peers alone.
enum class Solid { none, half_space, sphere, box, hull, capsule, cylinder, cone };

struct BodyState {
  double position[3] = {0, 0, 0};        // m, world: origin of the body frame
  double orientation[4] = {0, 0, 0, 1};  // x, y, z, w: body to world
  double velocity[3] = {0, 0, 0};        // m/s, world, of the centre of mass
  double omega[3] = {0, 0, 0};           // rad/s, world
};

/// A body in its principal axes about its centre of mass. Equal shapes share one `params`.
struct BodyPlan {
  Solid solid = Solid::none;
  // half-space: normal, offset; sphere: radius; box: half extents; hull: xyz each; capsule, cylinder, cone: radius, half
  // the height along y (a capsule's without its caps; a cone's apex is up)
  const double* params = nullptr;
  std::size_t param_count = 0;
  const std::uint32_t* triangles = nullptr;  // hull: three indices each, counter-clockwise seen from outside
  std::size_t triangle_count = 0;
  bool is_static = false;
  double mass = 0;                 // kg
  double inertia[3] = {0, 0, 0};   // kg m^2
  double friction = 0;             // of every pair it is in: the geometric mean of both
  double restitution = 0;          // likewise: the larger of both
  double shape_at[3] = {0, 0, 0};  // m, body frame: the shape's own origin
  BodyState start;
};

inline constexpr std::size_t kWorldBody = static_cast<std::size_t>(-1);

enum class JointKind { ball, slider };  // sliders are asked of the engines of accuracy_peers alone

/// The frames of a slider are one at the start. B slides along x of A's; it is a body that moves.
struct JointPlan {
  std::size_t a = 0, b = 0;                         // bodies, or kWorldBody
  double on_a[3] = {0, 0, 0}, on_b[3] = {0, 0, 0};  // m, body frames
  JointKind kind = JointKind::ball;
  double axes_on_a[4] = {0, 0, 0, 1}, axes_on_b[4] = {0, 0, 0, 1};  // x, y, z, w: of a slider's frame to the body's
  double motor_speed = 0, motor_force = 0;        // m/s of B along the axis; N at most, 0: there is no motor
  double stiffness = 0, damping = 0, target = 0;  // N/m, N s/m, m along the axis: of a spring, 0: there is none
};

/// Something that an engine can be asked to do otherwise than by default. Which names it has, its module says.
struct PeerDial {
  const char* name;
  double value;
};

struct WorldPlan {
  const BodyPlan* bodies = nullptr;
  std::size_t count = 0;
  const JointPlan* joints = nullptr;  // bodies that are joined do not touch each other
  std::size_t joint_count = 0;
  double gravity[3] = {0, -9.81, 0};  // m/s^2
  const PeerDial* dials = nullptr;
  std::size_t dial_count = 0;
  double dial(const char* name, double otherwise) const {
    for (std::size_t i = 0; i < dial_count; ++i) {
      const char *a = dials[i].name, *b = name;
      while (*a && *a == *b) ++a, ++b;
      if (*a == *b) return dials[i].value;
    }
    return otherwise;
  }
  bool sleeping = false;    // bodies at rest may be put to sleep, by the engine's own defaults
  std::size_t threads = 1;  // that a step may use; an engine without threads heeds none
};

inline constexpr std::size_t kNotTold = static_cast<std::size_t>(-1);

class PeerWorld {
 public:
  virtual ~PeerWorld() = default;
  virtual void step(double dt) = 0;
  virtual void read(BodyState* states) const = 0;  // [bodies]
  virtual std::size_t contact_points() const = 0;  // after the last step; kNotTold by an engine that doesn't count them
  /// A force on a body's centre of mass for the next step(); no scene of the S-table pushes.   @param force  [3] N, world
  virtual void push(std::size_t body, const double* force) { (void)body, (void)force; }
  /// CPU time of the last step() where another process took it, s; negative: this thread did.
  virtual double seconds_elsewhere() const { return -1; }
  /// What each ray meets first.
  /// @param ends       [6 n] m, world: where a ray starts and where it ends
  /// @param fractions  [n] out: of the way, at which something is met; 2: nothing
  /// @return           false: the engine is not asked
  virtual bool cast_rays(const double* ends, std::size_t n, double* fractions) {
    (void)ends, (void)n, (void)fractions;
    return false;
  }
};

/// What a shared object with an engine exports as `carom_bench_engine`.
struct PeerEngine {
  const char* name;  // with version and precision; null: it did not start, why is on stderr
  /// Null, and why on stderr, if it can't. The plan need not outlive the call; its params and triangles do.
  PeerWorld* (*make)(const WorldPlan& plan);
  std::size_t (*live_bytes)();  // held through the engine's own allocator now
  std::size_t threads = 1;      // as many as a step can use
};
using PeerModule = PeerEngine (*)();

/// PeerEngine::make of an engine whose world may throw: no exception crosses a link namespace.
template <class World>
PeerWorld* make_or_tell(const WorldPlan& plan) {
  try {
    return new World(plan);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return nullptr;
  }
}

}  // namespace carom::bench

// How a body moves that touches one or two flat surfaces: at a point each, or along a line.
//
// While what touches keeps touching, such a body is a smooth mechanical system, and any method of fourth order follows
// it. The places that touch travel over the body as it turns. The support function tells them of any orientation: the
// lowest point of a wheel, the two ends of the line on which a cone lies.
//
//   m a = F + f,   I w' + w x I w = T + r x f,   d . (a + w' x r + w x r') = d . s'
//
// F, T: all forces of the table of effects, asked at each stage where the body then is (force/trial.h). r: from the centre of mass to a place that touches; r': its change as the body turns; s: velocity of the surface
// there; d: the normal, and for what friction holds two tangents (at the far end of a line the one across it: along it
// both ends go alike). What slides has no tangents: f is against its slip, friction times the load.
#pragma once

#include "collision/shape.h"
#include "core/constant.h"
#include "core/pose.h"
#include "dynamics/force/trial.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kRollStep{
    "roll_step", 0.1, "rad",
    "by which a lone roller turns, its point travels around it, or forces on it swing it, in a step of the "
    "fourth-order method",
    "larger: spinning coins gain or lose energy; smaller: they cost more"};
inline constexpr Constant<Real> kRollProbe{
    "roll_probe", 1e-4, "rad", "of the two turns by whose support points the path of the touching point is found",
    "larger: their difference errs by its square; smaller: by rounding"};
inline constexpr Constant<Real> kRollTilt{
    "roll_tilt", 1e-3, "rad",
    "by which the normal is tilted to either side along a line that touches, to find its ends",
    "larger: bodies that lie aslant are taken to lie on a line; smaller: a line is lost as it sinks unevenly"};
inline constexpr Constant<Real> kRollTravel{
    "roll_travel", 1000, "1",
    "times the body's size that its point may travel for a radian: the rim of a coin that leans by 0.001 travels as "
    "far",
    "larger: what lies flat is taken to roll; smaller: coins are left to the solver before they lie down"};
inline constexpr Constant<Real> kRollBend{
    "roll_bend", 0.1, "1",
    "by which the ways of the point for the two probing turns may differ: at an edge one of them jumps",
    "larger: what tips from corner to corner is taken to roll; smaller: coins that spin fast are left to the solver"};
inline constexpr Constant<Real> kRollJump{
    "roll_jump", 0.25, "1",
    "of the way of the point in a step of the method, and of what its body's size turns by, that it may be elsewhere",
    "larger: what tips over is taken to roll; smaller: coins that spin fast are left to the solver"};
inline constexpr ConstantRow kTouchingMotionConstants[] = {kRollStep,   kRollProbe, kRollTilt,
                                                           kRollTravel, kRollBend,  kRollJump};

/// A body and a flat surface that it touches, as a step begins.
struct FlatTouch {
  std::uint32_t row, rows;           // of its pair: the first, how many
  std::uint32_t deepest, other_end;  // rows: where it stands; of a line the far end
  std::uint32_t collider, surface;   // of the body; below
  Vec3 n;                            // unit, world, from the surface into the body
  Vec3 on_plane;                     // m, a point of the surface
  Vec3 along;                        // unit, world: of the line that touches, from `deepest`; zero: a point touches
  Real friction, rolling = 0, spinning = 0;  // coefficients; m, of what resists
  bool is_open;                              // it is near, and does not touch yet
  Vec3 surface_x, surface_v, surface_spin;   // of the body below: its centre, m/s, rad/s
  bool is_line() const { return !along.is_zero(); }
};

/// A body that touches flat surfaces and nothing else, as its step begins.
struct TouchingBody {
  static constexpr int kMost = 2;
  std::uint32_t body;
  int count = 0;
  FlatTouch touches[kMost];
  Vec3 x, v, omega;
  Quat q;
  Vec3 accel, torque;   // m/s^2 of forces; N m, world: of those that are the same all step long
  ForcesOnOne varying;  // the others
};

/// Its equation of motion.
class TouchingMotion {
 public:
  static constexpr int kMostEnds = 2 * TouchingBody::kMost;  // touch k: 2 k, and of a line 2 k + 1

  struct At {
    Vec3 x, v, omega;
    Quat q;
  };
  /// What friction does at a touch; `opened`: it has come off.
  enum class Grip : std::uint8_t { holds, slides, opened };
  enum class Outcome : std::uint8_t { moved, fails, opens };

  /// @param trial  where forces are asked
  TouchingMotion(const World& world, const TouchingBody& of, Trial& trial);

  void grip(int touch, Grip grip) { grip_[touch] = grip; }
  Grip grip(int touch) const { return grip_[touch]; }
  int touches() const { return of_.count; }
  bool touches_anything() const { return is_active(0) || is_active(2); }
  Real mass() const { return mass_; }
  Real energy(const At& at) const;
  /// J, of forces, of all that was advanced.
  Real work() const { return work_; }
  /// m/s^2 of forces.
  Vec3 accel(const At& at) const;

  /// m, from the centre of mass to what touches, of all that has not come off.
  bool ends(const Quat& q, Vec3 r[kMostEnds]) const;
  /// @param t  s, since the step began: the surface has moved on by then
  Real gap(const Vec3& x, const Vec3& r, int touch, Real t) const {
    const FlatTouch& of = of_.touches[touch];
    return (x + r - of.on_plane - t * of.surface_v).dot(of.n);
  }
  /// m: how far from a surface the body is, t after the step began.
  bool clearance(const At& at, int touch, Real t, Real& gap) const;

  /// Of two touches, that which came off in the step before: it parts, and would have to be pulled.
  void open_what_parts(const At& at);
  /// What touches comes to rest on its surfaces (where it slides: along their normals), by impulses there.
  /// @param most  N s, that they may take
  bool settle(At& at, Real most);
  /// What slides is to go on the way that it does now.
  /// @param least  m/s, for each unit of friction. @return whether it slides faster
  bool note_slips(const At& at, Real least);
  /// s: how long it takes to turn, for its point to travel, or for forces to swing it, by a radian; at rest infinite.
  /// @param dt  s, over whose way forces are probed
  bool pace(const At& at, Real dt, Real& seconds) const;
  /// By the classical fourth-order method. `opens`: a touch is pulled by then; nothing has moved.
  Outcome advance(At& at, Real h, int& opened);
  /// The touch is pulled at the end of h: up to where its load is 0, which is h then.
  bool advance_to_opening(At& at, Real& h, int opened);
  /// Places what touches where it is to be t after the step began, m along the normals, by the least motion.
  bool correct(At& at, Real t, const Real want[kMostEnds]) const;
  /// N s, world, at an end, of all that was advanced and settled.
  const Vec3& impulse(int end) const { return impulse_[end]; }

 private:
  struct Ends {
    Vec3 r[kMostEnds], travel[kMostEnds];  // m; m/s, as the body turns
  };
  enum class Along : std::uint8_t { normal, line, across };
  struct Row {
    int end;
    Along along;
    Vec3 d, push, moment;  // of a force of 1: itself, and about the centre
  };
  struct Rows {
    int count = 0;
    Row at[6];
  };
  struct Rate {
    Vec3 x, v, omega;
    Quat q;
    Real work;  // W, of forces
    Vec3 force[kMostEnds];
    Real load[TouchingBody::kMost];  // N, the least of a touch's ends
  };
  bool is_active(int end) const {
    const int touch = end / 2;
    return touch < of_.count && grip_[touch] != Grip::opened && (end % 2 == 0 || of_.touches[touch].is_line());
  }
  /// m: how large the body is about its centre, by what touches.
  Real size(int touch) const { return size_[touch]; }
  bool support(const Mat3& turn, const FlatTouch& touch, const Vec3& direction, Vec3& r) const;
  bool line_ends(const Mat3& turn, const FlatTouch& touch, Vec3& near, Vec3& far) const;
  bool travelling(const At& at, Ends& ends) const;
  Mat3 inverse_inertia(const Quat& q) const;
  Vec3 surface_velocity(const FlatTouch& touch, const Vec3& p) const {
    return touch.surface_v + touch.surface_spin.cross(p - touch.surface_x);
  }
  Vec3 slip(const At& at, const Vec3& r, int touch) const;
  Real swing(const At& at, Real dt) const;
  Vec3 resistance(const FlatTouch& touch, const Vec3& omega) const;
  bool add_rows(const At& at, const Vec3 r[kMostEnds], bool with_friction, Rows& rows) const;
  bool respond(const Rows& rows, const Mat3& inv, const Vec3 r[kMostEnds], Real wanted[6]) const;
  bool rate(const At& at, Rate& to) const;
  bool rate(const At& at, const Ends& ends, Rate& to) const;
  bool friction_bears(const Rows& rows, const Real force[6]) const;
  bool run(At& at, Real h, Rate& mean, Ends& begun) const;
  void note(const Rate& mean, Real h);
  int pulled(const Real load[TouchingBody::kMost]) const;

  const World& world_;
  const TouchingBody& of_;
  Trial& trial_;
  const Real mass_;
  const Mat3& inertia_;
  const Mat3& inv_inertia_;
  Real size_[TouchingBody::kMost] = {0, 0}, work_ = 0;
  Grip grip_[TouchingBody::kMost] = {Grip::holds, Grip::holds};
  Vec3 slips_[kMostEnds], impulse_[kMostEnds];
};

}  // namespace carom::dynamics

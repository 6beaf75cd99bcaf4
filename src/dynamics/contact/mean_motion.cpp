#include "dynamics/contact/mean_motion.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/vec6.h"
#include "dynamics/body_state.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact/surface.h"
#include "dynamics/contact/turning_ground.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/solver/table.h"

namespace carom::dynamics {
namespace {

constexpr int kMostMeanBodies = 4;  // of a group
constexpr int kMostMeanPoints = 24;
constexpr std::size_t kMeanGroupsAPart = 16;
constexpr Real kSlides = 0.5;   // of the most that changed of a body's velocity: what goes slower at a point sticks
constexpr Real kTips = 0.03;    // likewise: what lifts or lowers a body's middle
constexpr Real kCurves = 0.5;   // likewise: what a contact opens or closes as a step begins
constexpr Real kNotice = 1e-3;  // of velocity_tolerance
constexpr Real kIndependent = 1e-20;  // of a row squared: what less is left of it by those before is rounding

using Body = MeanMotion::Body;
using Point = MeanMotion::Point;

/// v and omega of all bodies of a group, or an impulse and a moment on each.
struct Stacked {
  std::array<Vec6, kMostMeanBodies> of;
  std::size_t bodies;

  Stacked() = default;  // not initialised
  explicit Stacked(std::size_t count) : bodies(count) {
    for (std::size_t i = 0; i < bodies; ++i) of[i].set_zero();
  }
  /// One after the other, not by halves.
  Real dot(const Stacked& o) const {
    Real sum = 0;
    for (std::size_t i = 0; i < bodies; ++i)
      for (int k = 0; k < 6; ++k) sum += of[i][k] * o.of[i][k];
    return sum;
  }
  void add_scaled(Real s, const Stacked& o) {
    for (std::size_t i = 0; i < bodies; ++i) of[i] += s * o.of[i];
  }
  Stacked scaled(Real s) const {
    Stacked out(bodies);
    out.add_scaled(s, *this);
    return out;
  }
};

/// Takes from a velocity what moves along rows, in the metric of the masses: with rows J and inverse masses W,
///   c <- c - W J^T (J W J^T)^-1 J c,   by rows made independent one after the other.
class Projection {
 public:
  Projection(const World& world, std::span<const Body> bodies) : world_(world), bodies_(bodies) {
    // As bodies are turned now: Contacts::inv_inertia_w is as old as whoever asked for it last wants it.
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const std::uint32_t slot = bodies[i].slot;
      if (!rotates(world.scene, slot)) continue;
      const Mat3 r = world.state.q[slot].matrix();
      inv_inertia_[i] = world.scene.locks_of(slot) & kAngularLocks
                            ? inverse_of_free(r * world.scene.inertia[slot] * r.transpose(), world.scene.locks_of(slot))
                            : Mat3(r * world.scene.inv_inertia[slot] * r.transpose());
    }
  }

  /// @param row  an impulse: J c is its product with a velocity
  void take_out(Stacked row, Stacked& c) {
    if (held_ == 6 * row.bodies) return;
    Stacked v = solve(row);
    const Real whole = row.dot(v);
    for (std::size_t k = 0; k < held_; ++k) {
      const Real shared = row.dot(velocity_[k]);
      row.add_scaled(-shared, impulse_[k]), v.add_scaled(-shared, velocity_[k]);
    }
    const Real rest = row.dot(v);
    if (!(rest > kIndependent * whole)) return;
    const Real scale = 1 / std::sqrt(rest);
    impulse_[held_] = row.scaled(scale), velocity_[held_] = v.scaled(scale);
    c.add_scaled(-impulse_[held_].dot(c), velocity_[held_]);
    ++held_;
  }

 private:
  Stacked solve(const Stacked& row) const {
    Stacked v(row.bodies);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const std::uint32_t slot = bodies_[i].slot;
      v.of[i].set_linear(world_.scene.inv_mass[slot] *
                         free_axes(world_.scene.locks_of(slot)).times(row.of[i].linear()));
      if (rotates(world_.scene, slot)) v.of[i].set_angular(inv_inertia_[i] * row.of[i].angular());
    }
    return v;
  }

  const World& world_;
  std::span<const Body> bodies_;
  std::array<Mat3, kMostMeanBodies> inv_inertia_;  // 1/(kg m^2), world, of those that rotate
  std::size_t held_ = 0;
  std::array<Stacked, 6 * kMostMeanBodies> impulse_, velocity_;
};

/// One group of one substep.
class Group {
 public:
  Group(const World& world, std::size_t group)
      : world_(world),
        group_(world.mean_motion->groups[group]),
        bodies_(between(world.mean_motion->bodies, &MeanMotion::Group::body, group)),
        points_(between(world.mean_motion->points, &MeanMotion::Group::point, group)) {}

  /// @param dt, h  s, of the step, of the substep
  void find_motion(Real dt, Real h) {
    Stacked c(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      c.of[i] = {-0.5 * gained_v(bodies_[i]), -0.5 * gained_omega(bodies_[i])};
    const bool held = std::ranges::any_of(bodies_, [&](const Body& b) { return world_.state.held_out[b.slot] != 0; });
    const Real most = 2 * size_of(c);
    const bool is_worth_it = most > kNotice * world_.scene.dials[Dial::velocity_tolerance] && finite(most);
    if (held || group_.is_curved || !is_worth_it) return;
    group_.is_moved = hold(dt, h, most, c) && finite(c.dot(c));
    group_.is_first = false;
    if (!group_.is_moved) return;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i].v_change = c.of[i].linear(), bodies_[i].omega_change = c.of[i].angular();
    }
  }

 private:
  template <class T>
  std::span<T> between(Array<T>& all, std::uint32_t MeanMotion::Group::*begin, std::size_t group) const {
    const MeanMotion::Group* const g = &world_.mean_motion->groups[group];
    return {all.data() + g->*begin, g[1].*begin - g->*begin};
  }

  Vec3 gained_v(const Body& b) const { return world_.state.v[b.slot] - world_.plan->begun[b.slot].v; }
  /// Without what a rotation method did itself: it has turned the body by the mean of that.
  Vec3 gained_omega(const Body& b) const {
    const Plan& plan = *world_.plan;
    return world_.state.omega[b.slot] -
           (turns_by_method(plan, b.slot) ? plan.predicted.omega[b.slot] : plan.begun[b.slot].omega);
  }

  /// m/s, the most that a body's middle, or a ball of its mass and inertia at its rim, goes by; not finite if any is
  /// not.
  Real size_of(const Stacked& c) const {
    const Scene& scene = world_.scene;
    Real most2 = 0, all2 = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const std::uint32_t slot = bodies_[i].slot;
      const Real gyration2 = rotates(scene, slot) ? scene.inertia[slot].trace() * scene.inv_mass[slot] : 0;
      const Real size2 = c.of[i].linear().squared_norm() + gyration2 * c.of[i].angular().squared_norm();
      most2 = std::max(most2, size2), all2 += size2;
    }
    return finite(all2) ? std::sqrt(most2) : all2;
  }

  /// m, as bodies stand: what geometry and rotation matrices say may be of the step's beginning, or of now if other
  /// bodies asked.
  Real separation_now(const Row& row, const RowGeometry& g) const {
    const State& s = world_.state;
    const Vec3 apart = (s.x[row.b] - s.x[row.a]) + (s.q[row.b] * g.l_b - s.q[row.a] * g.l_a);
    return apart.dot(row.n) - (g.radius_a + g.radius_b);
  }

  /// m/s, of B's surface beside A's, where arms are now: the lead knows how belts bend at a body's middle.
  Vec3 surface_now(std::uint32_t row_index, const TurningPair* turning, const Arms& r) const {
    const Contacts& c = *world_.contacts;
    const Row& row = c.rows[row_index];
    if (!turning || !turning->has_belts) return c.surface[row_index];
    const collision::Pair& pair = world_.pairs.place(c.geometry[row_index].pair).pair;
    const Surface a(world_, pair.a, row.a), b(world_, pair.b, row.b);
    const Vec3 all = b.angular.cross(r.a) - a.angular.cross(r.b) - turning->belt;
    return all - all.dot(row.n) * row.n;
  }

  /// Take out what would move a point that is shut, or drag one that sticks.
  /// @param most  m/s, that a body's velocity changed by
  /// @return      whether what contacts bear depends so little on where bodies are that they may go by a mean
  bool hold(Real dt, Real h, Real most, Stacked& c) {
    Projection projection(world_, bodies_);
    const Stacked asked = c;
    std::array<const Point*, kMostMeanPoints> shut;
    std::size_t shuts = 0;
    for (const Point& p : points_) {
      const Row& row = world_.contacts->rows[p.row];
      const Arms r = Arms::now(world_, row, world_.contacts->geometry[p.row]);
      Vec3 u = relative_velocity(world_.state, row, r.a, r.b);
      const TurningPair* const turning = turning_pair_at(*world_.contacts, p.row);
      if (!world_.contacts->surface.empty()) u += surface_now(p.row, turning, r);
      if (turning) u += lead_of(world_, *turning, h).along(r.a - r.b, row.n);
      const Vec3 gained = -2 * (velocity(asked, p.b, r.b) - velocity(asked, p.a, r.a));
      const Real after = u.dot(row.n), opened = gained.dot(row.n);
      const Real closing = std::max(-std::min(after, after - opened), Real(0));
      if (separation_now(row, world_.contacts->geometry[p.row]) > dt * (closing + most)) continue;  // it stays open
      if (group_.is_first && std::fabs(opened) > kCurves * most) return group_.is_curved = true, false;
      const auto hold_along = [&](const Vec3& d) {
        Stacked j(c.bodies);
        add_impulse(j, p.a, r.a, -d), add_impulse(j, p.b, r.b, d);
        projection.take_out(j, c);
      };
      hold_along(row.n);
      shut[shuts++] = &p;
      const Vec3 sliding = u - after * row.n, slid = sliding - (gained - opened * row.n);
      if (std::min(slid.norm(), sliding.norm()) > kSlides * most) continue;
      const Vec3 t = any_perpendicular(row.n).normalized();
      hold_along(t), hold_along(row.n.cross(t));
    }
    return std::none_of(shut.begin(), shut.begin() + shuts, [&](const Point* p) {
      const Vec3& n = world_.contacts->rows[p->row].n;
      return lifts(c, p->a, n) > kTips * most || lifts(c, p->b, n) > kTips * most;
    });
  }

  /// m/s, of a body that tips its middle is lifted or lowered while no point is.
  static Real lifts(const Stacked& of, std::uint32_t body, const Vec3& n) {
    return body == kInvalid ? 0 : 2 * std::fabs(of.of[body].linear().dot(n));
  }
  static Vec3 velocity(const Stacked& of, std::uint32_t body, const Vec3& r) {
    if (body == kInvalid) return Vec3::zero();
    return of.of[body].linear() + of.of[body].angular().cross(r);
  }
  static void add_impulse(Stacked& to, std::uint32_t body, const Vec3& r, const Vec3& p) {
    if (body == kInvalid) return;
    to.of[body] = {p, r.cross(p)};
  }

  const World& world_;
  MeanMotion::Group& group_;
  std::span<Body> bodies_;
  std::span<const Point> points_;
};

/// The bodies and points of a group.
void gather(const Contacts& c, std::size_t group, MeanMotion& m) {
  const std::size_t first = m.bodies.size();
  const auto index = [&](bool moves, std::uint32_t slot) {
    if (!moves) return kInvalid;
    const auto at = std::find_if(m.bodies.begin() + static_cast<std::ptrdiff_t>(first), m.bodies.end(),
                                 [&](const Body& b) { return b.slot == slot; });
    const auto i = static_cast<std::uint32_t>(at - m.bodies.begin() - static_cast<std::ptrdiff_t>(first));
    if (at == m.bodies.end()) m.bodies.emplace_back().slot = slot;
    return i;
  };
  m.groups.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(m.points.size())});
  for (std::uint32_t k = c.group_begin[group]; k < c.group_begin[group + 1]; ++k) {
    const Row& row = c.rows[c.group_rows[k]];
    const std::uint32_t a = index(row.moves_a, row.a), b = index(row.moves_b, row.b);
    m.points.push_back({c.group_rows[k], a, b});
  }
}

/// f(body), of those groups that are moved so, of those that a solver moved.
template <class F>
void each_moved(const World& world, const F& f) {
  MeanMotion* const m = world.mean_motion.get();
  if (!m || m->groups.empty()) return;
  for (std::size_t g = 0; g + 1 < m->groups.size(); ++g) {
    if (!m->groups[g].is_moved) continue;
    for (std::uint32_t i = m->groups[g].body; i < m->groups[g + 1].body; ++i)
      if (world.plan->touched[m->bodies[i].slot]) f(m->bodies[i]);
  }
}

}  // namespace

void find_small_groups(const World& world, Owned<MeanMotion>& mean_motion) {
  Contacts& c = *world.contacts;
  if (mean_motion) mean_motion->bodies.clear(), mean_motion->points.clear(), mean_motion->groups.clear();
  const bool ends_at_end = world.plan->integrator->lag == 1;  // the velocity that is kept is that of the substep's end
  if (c.rows.empty() || !ends_at_end || world.plan->solver->row_by_row) return;
  if (!mean_motion) mean_motion = make_owned<MeanMotion>(world.memory, world.memory);
  MeanMotion& m = *mean_motion;
  constexpr std::size_t kSome = 16;  // capacity before there are any: a small world settles without allocating
  m.bodies.reserve(std::max(c.bodies.size(), kSome));
  m.points.reserve(std::max(c.rows.size(), 4 * kSome));
  m.groups.reserve(std::max(c.groups(), kSome) + 1);
  for (std::size_t g = 0; g < c.groups(); ++g) {
    const bool joined = c.has_joints(g);
    const std::uint32_t points = c.group_begin[g + 1] - c.group_begin[g];
    if (!joined && points > 0 && points <= kMostMeanPoints && c.group_size[g].bodies <= kMostMeanBodies)
      gather(c, g, m);
  }
  m.groups.push_back({static_cast<std::uint32_t>(m.bodies.size()), static_cast<std::uint32_t>(m.points.size())});
}

void find_mean_motion(const World& world, const StepTime& time) {
  MeanMotion* const m = world.mean_motion.get();
  if (!m || m->groups.empty()) return;
  in_parallel(world.jobs, m->groups.size() - 1, kMeanGroupsAPart,
              [&](std::uint32_t g) { Group(world, g).find_motion(time.dt, time.h); });
}

MeanVelocities::MeanVelocities(const World& world, Velocities& to) : world_(world), to_(to) {
  each_moved(world, [&](Body& b) {
    Vec3 &v = to.v[b.slot], &omega = to.omega[b.slot];
    b.v = v, b.omega = omega;
    v += b.v_change, omega += b.omega_change;
  });
}

MeanVelocities::~MeanVelocities() {
  each_moved(world_, [&](const Body& b) {
    if (!world_.state.held_out[b.slot]) to_.v[b.slot] = b.v, to_.omega[b.slot] = b.omega;
  });
  if (MeanMotion* const m = world_.mean_motion.get())
    for (MeanMotion::Group& g : m->groups) g.is_moved = false;
}

}  // namespace carom::dynamics

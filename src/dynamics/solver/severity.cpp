// Most severe contact first: velocities, then penetration.
#include "dynamics/solver/severity.h"

#include <algorithm>

#include "dynamics/contact/depth.h"
#include "dynamics/contact/impulse.h"
#include "dynamics/force/force.h"
#include "dynamics/quarantine.h"
#include "dynamics/solver/search.h"

namespace carom::dynamics {

Real velocity_severity_squared(const Row& row) {
  const Real v_n = row.u.dot(row.n);
  const Real lacking = row.target - v_n;  // m/s, > 0: closes too fast
  // To part too fast is no offence of a contact that does not push; of one that does, as far as its push goes.
  const Real normal = lacking >= 0 ? lacking : std::min(-lacking, row.p_n * row.k_n);
  if (!(row.slip_most2 > 0)) return normal * normal;
  const Vec3 slip = row.u - v_n * row.n;
  Real slip2 = slip.squared_norm();
  if (row.at_limit) {
    // On the circle of the disc, slipping against the friction impulse is what the law wants.
    const Real along = slip.dot(row.friction_p);
    if (along < 0) slip2 = std::max(Real(0), slip2 - along * along / row.friction_p2);
  }
  return std::max(normal * normal, std::min(slip2, row.slip_most2));
}

namespace {

template <class Search>
class VelocityPass {
 public:
  VelocityPass(const World& world, Search& search, Velocities& to)
      : world_(world), to_(to), c_(*world.contacts), search_(search) {}

  /// @return impulses applied
  std::uint64_t run(std::span<const std::uint32_t> rows, Real tolerance, std::uint64_t budget) {
    for (const std::uint32_t i : rows) c_.keys[i] = velocity_severity_squared(c_.rows[i]);
    search_.start(rows, tolerance * tolerance);
    std::uint64_t done = 0;
    for (std::uint32_t i; done < budget && (i = search_.top()) != kNoRow; ++done) {
      Row& row = c_.rows[i];
      const RowMass& m = c_.mass[i];
      const Vec3 p = resolved_impulse(row, m, row.target);
      const Vec3 dp = p - row.p;
      row.set_impulse(p);
      // First every relative velocity, then every severity: rows between the same two bodies are judged once.
      if (row.moves_a) spread(row.a, -dp, m.r_a);
      if (row.moves_b) spread(row.b, dp, m.r_b);
      if (row.moves_a) judge(row.a, i, row.moves_b ? row.b : row.a);
      if (row.moves_b) judge(row.b, i, row.b);
      search_.set(i, 0);
    }
    return done;
  }

 private:
  /// Change a body's velocity, and with it the relative velocities of its rows.
  void spread(std::uint32_t body, const Vec3& dp, const Vec3& r) {
    const Vec3 dv = world_.scene.inv_mass[body] * dp;
    const Vec3 dw = rotates(world_.scene, body) ? Vec3(c_.inv_inertia_w[body] * r.cross(dp)) : Vec3(Vec3::zero());
    to_.v[body] += dv;
    to_.omega[body] += dw;
    world_.plan->touched[body] = 1;
    for (const HalfContact& half : halves(body)) c_.rows[half.row].u += half.sign * (dv + dw.cross(half.r));
  }

  /// Tell the search how severe a body's rows are now, but for the resolved row and those that `other` will tell.
  void judge(std::uint32_t body, std::uint32_t resolved, std::uint32_t other) {
    for (const HalfContact& half : halves(body)) {
      const Row& row = c_.rows[half.row];
      if (half.row == resolved || (other != body && (row.a == other || row.b == other))) continue;
      search_.set(half.row, velocity_severity_squared(row));
    }
  }

  std::span<const HalfContact> halves(std::uint32_t body) const {
    return {c_.half.data() + c_.half_of[body].begin, c_.half_of[body].end - c_.half_of[body].begin};
  }

  const World& world_;
  Velocities& to_;
  Contacts& c_;
  Search& search_;
};

template <class Search>
class PositionPass {
 public:
  PositionPass(const World& world, Search& search) : world_(world), c_(*world.contacts), search_(search) {}

  std::uint64_t run(std::span<const std::uint32_t> rows, Real tolerance, std::uint64_t budget) {
    tolerance_ = tolerance;
    for (const std::uint32_t i : rows) c_.keys[i] = key(i);
    search_.start(rows, tolerance);
    std::uint64_t done = 0;
    for (std::uint32_t i; done < budget && (i = search_.top()) != kNoRow; ++done) {
      const Row& row = c_.rows[i];
      const RowMass& m = c_.mass[i];
      // Half the tolerance is left, so that a body at rest is not pushed out of touch.
      Real push = (-c_.geometry[i].separation - tolerable_depth(world_, c_.geometry[i]) / 2) / row.k_n;
      push *= std::min(turn_limit(row.moves_a, row.a, m.r_a, row.n, push),
                       turn_limit(row.moves_b, row.b, m.r_b, row.n, push));
      const Vec3 p = push * row.n;
      if (row.moves_a) spread(row.a, -p, m.r_a);
      if (row.moves_b) spread(row.b, p, m.r_b);
      search_.set(i, 0);
    }
    return done;
  }

 private:
  /// A turn is projected linearly; beyond 0.1 rad (error 1 - cos = 0.5 % of the arm) the rest is left for the next
  /// step.
  Real turn_limit(bool moves, std::uint32_t body, const Vec3& r, const Vec3& n, Real push) const {
    constexpr Real kMaxTurn = 0.1;  // rad
    if (!moves || !rotates(world_.scene, body)) return 1;
    const Real turn = push * (c_.inv_inertia_w[body] * r.cross(n)).norm();
    return turn > kMaxTurn ? kMaxTurn / turn : 1;
  }

  void spread(std::uint32_t body, const Vec3& p, const Vec3& r) {
    const Vec3 dx = world_.scene.inv_mass[body] * p;
    const Vec3 dt = rotates(world_.scene, body) ? Vec3(c_.inv_inertia_w[body] * r.cross(p)) : Vec3(Vec3::zero());
    c_.displaced[body].shift += dx;
    c_.displaced[body].turn += dt;
    for (std::uint32_t k = c_.half_of[body].begin; k < c_.half_of[body].end; ++k) {
      const HalfContact& half = c_.half[k];
      RowGeometry& g = c_.geometry[half.row];
      g.separation += half.sign * (dx + dt.cross(half.r)).dot(c_.rows[half.row].n);
      search_.set(half.row, key(half.row));
    }
  }

  /// m, how deep a row is, as of two that are thick: as many tolerances as it is tolerable depths.
  Real key(std::uint32_t i) const {
    const RowGeometry& g = c_.geometry[i];
    const Real depth = tolerable_depth(world_, g);
    return depth < tolerance_ ? -g.separation * (tolerance_ / depth) : -g.separation;
  }

  const World& world_;
  Contacts& c_;
  Search& search_;
  Real tolerance_ = 0;  // m
};

/// A pass over all groups with the search that the dial names. @return corrections applied
template <template <class> class Pass, class... To>
std::uint64_t over_groups(const World& world, Real tolerance, int iterations, To&... to) {
  Contacts& c = *world.contacts;
  const auto with = [&]<class Search>(Search search) {
    Pass<Search> pass(world, search, to...);
    std::uint64_t done = 0;
    for (std::size_t g = 0; g < c.groups(); ++g) {
      const std::span rows(c.group_rows.data() + c.group_begin[g], c.group_begin[g + 1] - c.group_begin[g]);
      done += pass.run(rows, tolerance, static_cast<std::uint64_t>(iterations) * rows.size());
    }
    return done;
  };
  const bool heap = world.scene.dials.choice(Dial::severity_search) == 1;
  return heap ? with(HeapSearch(c.keys, c.ranked, c.place)) : with(LinearSearch(c.keys, c.ranked, c.place));
}

}  // namespace

namespace {

void severity_begin(const World& world, Solver::Begins, const StepTime&) {
  world.contacts->mass.resize(world.contacts->rows.size());
  reserve_search(world);
}

void severity_velocities(const World& world, Solver::Solves to, const StepTime& time) {
  Velocities& motion = to;
  StepReport& report = to;
  Contacts& c = *world.contacts;
  prepare_rows(world, motion, time.h);
  const Dials& dials = world.scene.dials;
  report.velocity_impulses +=
      over_groups<VelocityPass>(world, dials[Dial::velocity_tolerance], dials.whole(Dial::velocity_iterations), motion);
  for (std::size_t i = 0; i < c.rows.size(); ++i) c.geometry[i].impulse += c.rows[i].p;
}

void severity_positions(const World& world, Solver::Relaxes to, const StepTime&) {
  Contacts& c = *world.contacts;
  StepReport& report = to;
  refresh_rotations(world);
  refresh_separations(world);
  const Dials& dials = world.scene.dials;
  report.position_moves +=
      over_groups<PositionPass>(world, dials[Dial::position_tolerance], dials.whole(Dial::position_iterations));
  for (const std::uint32_t i : c.bodies) {
    correct_pose(to, i, c.displaced[i].shift, c.displaced[i].turn);
    c.displaced[i].shift.set_zero(), c.displaced[i].turn.set_zero();
  }
  refresh_rotations(world);
  refresh_separations(world);
}

}  // namespace

extern constexpr Solver kSeverity = {"severity",         false,  true, true, severity_begin, severity_velocities,
                                     severity_positions, nullptr};

}  // namespace carom::dynamics

// Rows of the solver: one per contact point, made from the manifolds of a step.
//
// Signs: the normal points from A to B; u is the velocity of B's point relative to A's, so u.n < 0 closes; an impulse p
// acts on B as +p at r_b and on A as -p at r_a.
#pragma once

#include "dynamics/contact/old_impulses.h"
#include "dynamics/effects.h"
#include "dynamics/solver/search.h"

namespace carom::dynamics {

/// What the solver reads and writes most. The first two cache lines are all that a disturbance by a neighbour touches;
/// what depends on the row's own impulse alone (p_n, rub, ...) is kept there, since a row is disturbed ten times as
/// often as it is resolved.
struct alignas(64) Row {
  Vec3 u;       // m/s, relative velocity at the point, kept up to date as impulses spread
  Vec3 n;       // unit, world, A to B
  Real p_n;     // N s, normal part of p
  Real target;  // m/s, least normal velocity: 0, or -separation/h of an open contact

  Real k_n;         // 1/kg, n.K n: normal velocity per unit of normal impulse
  Real slip_most2;  // (m/s)^2, the most slip that friction could change, squared; 0: no friction impulse now
  Vec3 friction_p = Vec3::zero();  // N s, tangent part of p
  Real friction_p2;                // (N s)^2, |rub|^2
  bool at_limit;                   // the friction impulse is as large as the cone allows
  bool moves_a, moves_b;           // an impulse moves it
  bool one_normal;                 // all rows of its pair have the same
  bool rolls;                      // a body of its pair does, as on a ball: @see rolling.h
  // Of the first row of a pair alone, @see find_slide():
  bool loads_known;     // all loads of the pair's last step are those of points that it still has
  bool slides;          // it does as the step begins: friction acts at the middle of its loads
  bool slides_by_load;  // likewise, and starts from known loads and friction
  Real friction;        // mixed Coulomb coefficient

  Vec3 p;              // N s, impulse on B in this substep so far, world; between substeps, what the next starts from
  Real restitution;    // mixed; 0: does not bounce
  std::uint32_t a, b;  // body slots
  Real twist_share;    // of a pair that slides, in its first row, @see twist_share()

  /// Set the impulse and what follows from it.
  void set_impulse(const Vec3& impulse) {
    p = impulse;
    p_n = p.dot(n);
    const Real bound = friction * p_n;
    slip_most2 = 0, at_limit = false;
    if (!(bound > 0)) return;
    friction_p = p - p_n * n;
    friction_p2 = friction_p.squared_norm();
    at_limit = friction_p2 >= 0.999999 * bound * bound;
    const Real most = 2 * bound * k_n;
    slip_most2 = most * most;
  }
};
static_assert(sizeof(Row) == 192, "three cache lines");

/// What a row needs when it is resolved.
struct RowMass {
  Vec3 r_a, r_b;  // m, world axes: from the centres of mass to the point
  Mat3 k;         // 1/kg, change of u per impulse; positive definite
  Mat3 k_inv;     // kg
};

struct RowGeometry {
  // The surface points. What is round about a core keeps the point under its core while it rolls: a core's point turns
  // with its body, the core radius beyond it points along the normal all step long.
  Vec3 l_a, l_b;                // m, body axes about the centre of mass: the core's points
  Real radius_a, radius_b;      // m, core radii; 0: the surface turns with the body
  Vec3 impulse;                 // N s, of the whole step, world
  Vec3 place;                   // m, @see OldImpulse
  Real separation;              // m, as of the last refresh_separations()
  std::uint32_t pair;           // index in the pair table
  std::uint16_t point;          // index in its manifold
  bool is_asked_again;          // in each substep, @see asked_again.h
  std::uint32_t impact;         // in Contacts::impacts; rows that bounce only
  std::uint32_t turning_pairs;  // 1 + its place in Contacts::turning_pairs; 0: none
};

/// One end of a row, listed with the body it hangs on: all that is needed to tell the row that the body's velocity
/// changed.
struct HalfContact {
  Vec3 r;  // m, world axes
  std::uint32_t row;
  Real sign;  // +1: the body is B; -1: A
};

/// Rows of one pair, which stand together: what loops over bodies in touch need of them.
struct ContactPair {
  std::uint32_t row, count;
  std::uint32_t a, b;  // body slots
  bool moves_a, moves_b;
  bool one_normal;

  /// But for where their rows stand.
  bool is_like(const ContactPair& m) const {
    return count == m.count && a == m.a && b == m.b && moves_a == m.moves_a && moves_b == m.moves_b &&
           one_normal == m.one_normal;
  }
};

/// Two bodies that a joint holds together, or one and the world.
struct Link {
  std::uint32_t a, b;  // body slots, or kInvalid
  bool moves_a, moves_b;
};

/// Of a group: bodies that its contacts and joints move; pairs that touch.
struct GroupSize {
  std::uint32_t bodies = 0, pairs = 0;
};

/// From the centre of mass to the surface point. m, world axes, by plan.rotation
inline Vec3 arm_a(const World& world, const Row& row, const RowGeometry& g) {
  return world.plan->rotation[row.a] * g.l_a + g.radius_a * row.n;
}
inline Vec3 arm_b(const World& world, const Row& row, const RowGeometry& g) {
  return world.plan->rotation[row.b] * g.l_b - g.radius_b * row.n;
}
/// Where a point is, as a solver sees it: one place for both bodies, for impulses at one place keep the angular
/// momentum. While they slide or roll the two surface points part. The place stays with the body that moves, or with
/// the one that is round (the point of a flat one rolls away from under it), else halfway between the two.
struct Arms {
  Vec3 a, b;  // m, world axes, from the centres of mass
  Arms() = default;
  Arms(const World& world, const Row& row, const RowGeometry& g) {
    const Vec3 apart = world.state.x[row.b] - world.state.x[row.a];
    const Vec3 on_a = arm_a(world, row, g), on_b = apart + arm_b(world, row, g);
    a = on_a + to_b(row, g) * (on_b - on_a);
    b = a - apart;
  }
  /// Of bodies as they are turned now, whatever refresh_rotations() saw last: that is for others to ask for.
  static Arms now(const World& world, const Row& row, const RowGeometry& g) {
    const State& s = world.state;
    const Vec3 apart = s.x[row.b] - s.x[row.a];
    const Vec3 on_a = s.q[row.a] * g.l_a + g.radius_a * row.n, on_b = apart + (s.q[row.b] * g.l_b - g.radius_b * row.n);
    Arms arms;
    arms.a = on_a + to_b(row, g) * (on_b - on_a), arms.b = arms.a - apart;
    return arms;
  }
  /// How far it is from A's surface point towards B's: 0 to 1.
  static Real to_b(const Row& row, const RowGeometry& g) {
    const bool round_a = g.radius_a > 0, round_b = g.radius_b > 0;
    return row.moves_a != row.moves_b ? row.moves_b : (1 + round_b - round_a) / Real(2);
  }
};

/// A body whose masses are those of the substep's beginning, where its spin has been led on to its end.
struct ImpactSpin {
  std::uint32_t slot;
  Vec3 begun, end;  // rad/s, world: where the substep begins, and to where a rotation method led it
  bool is_led_back;
};

/// A row that bounces, within a substep.
struct Impact {
  std::uint32_t row;
  std::uint32_t count;  // of impacts
  Arms r;
  Vec3 before;  // m/s, relative velocity before the forces
  Vec3 accel;   // m/s^2, what they do to it
  Real gap;     // m, separation as the substep began
  Real leeway;  // m, that it may close beyond its separation

  /// Whether a solver has to know of it in this substep.
  bool concerns_solver() const { return count > 0 || leeway > 0; }
};

/// A pair that resists rolling or spinning.
struct Resistance {
  std::uint32_t row, points;  // its first row; how many
  Real rolling, spinning;     // m, mixed coefficients
  Vec3 moment;                // N m s, world, on B: of this substep; between substeps, what the next starts from
  Real normal_sum;            // N s, by its points since the step began, as this substep's contacts are yet unsolved
};

/// A pair whose surfaces move of themselves: a belt and what lies on it.
struct Driven {
  std::uint32_t row, points;  // its first row; how many
  Vec3 spin;                  // rad/s, world, of B's surface relative to A's, beside the bodies' own
};

/// A contact of a collider with a ground, @see seams.h
struct GroundContact {
  std::uint64_t key;     // collider, ground
  std::uint32_t record;  // in the pair table
  bool ground_is_a;
  std::uint32_t ghosts;  // of its points, a bit each
};

/// A pair whose ground turns, @see turning_ground.h
struct TurningPair {
  std::uint32_t row, points;  // its first row; how many
  bool has_belts = false;     // a surface moves of itself
  Vec3 belt = Vec3::zero();   // m/s, A's less B's, at the other's centre of mass, as rows have it
};

struct HalfPart {
  std::uint32_t begin, end;  // in Contacts::half
};

/// Of a pose.
struct Displacement {
  Vec3 shift, turn;  // m; rad, world
};

struct Contacts {
  explicit Contacts(Memory* m)
      : rows(m),
        mass(m),
        geometry(m),
        first_row(m),
        contact_pairs(m),
        links(m),
        link_label(m),
        group_links(m),
        group_link_begin(m),
        half(m),
        half_of(m),
        inv_inertia_w(m),
        displaced(m),
        bodies(m),
        is_bound(m),
        bouncing(m),
        impacts(m),
        spins(m),
        one_spin(m),
        last_impact(m),
        resisting(m),
        driven(m),
        turning_pairs(m),
        surface(m),
        group_rows(m),
        group_begin(m),
        group_size(m),
        direct(m),
        blocks(m),
        parent(m),
        label(m),
        pair_group(m),
        pair_begin(m),
        keys(m),
        cursor(m),
        ranked(m),
        place(m),
        load(m),
        grounds(m) {}

  // by row, in the order of the pair table
  Array<Row> rows;
  Array<RowMass> mass;  // of severity alone
  Array<RowGeometry> geometry;

  Array<std::uint32_t> first_row;    // [pairs + 1] by pair of the table
  Array<ContactPair> contact_pairs;  // of pairs that have rows, in their order

  Array<Link> links;                      // of active joints, in their order: @see WideJoints::active
  Array<std::uint32_t> link_label;        // by link: its group
  Array<std::uint32_t> group_links;       // links, ascending within a group
  Array<std::uint32_t> group_link_begin;  // [groups + 1]; empty where there are no links

  // by body slot
  Array<HalfContact> half;        // grouped by body; of who searches
  Array<HalfPart> half_of;        // by body that rows move: its part of half
  Array<Mat3> inv_inertia_w;      // 1/(kg m^2), world axes, of this substep; zero if it does not rotate
  Array<Displacement> displaced;  // corrections of the pose not yet applied

  Array<std::uint32_t> bodies;       // slots that have rows or joints and are moved by them, ascending
  Array<std::uint8_t> is_bound;      // by slot: it is one of them
  Array<std::uint32_t> bouncing;     // rows with a restitution, ascending
  Array<Impact> impacts;             // of each of them
  Array<ImpactSpin> spins;           // of bodies that bounce and turn far for their shape: scratch
  Participants one_spin;             // scratch, for rotation methods
  Array<Real> last_impact;           // s, by body slot, since the substep began: scratch
  Array<Resistance> resisting;       // ascending by row
  Array<Driven> driven;              // likewise
  Array<TurningPair> turning_pairs;  // likewise
  Array<Vec3> surface;  // m/s, by row: in its plane, of B's surface relative to A's, beside the bodies' own; empty
                        // where no pair is driven

  // contact groups
  Array<std::uint32_t> group_rows;     // rows, ascending within a group
  Array<std::uint32_t> group_begin;    // [groups + 1]
  Array<GroupSize> group_size;         // by group
  bool is_grouped = true;              // the dial
  bool any_rolls = false;              // Row::rolls
  bool any_asked_again = false;        // RowGeometry::is_asked_again
  std::uint32_t steps_with_spare = 0;  // @see give_back()
  Array<std::uint8_t> direct;  // by group, of a solver that chooses: whether the direct solver solves it; else empty

  /// What is summed up over rows, by blocks of kRowsAPart: the same sums whoever does which block.
  struct Block {
    std::uint32_t loaded;  // rows that leave an impulse
    std::uint32_t overlapping;
    Real depth, sum_of_depths, closing;  // m, m, m/s: the largest of those that overlap, their sum, the fastest
  };
  Array<Block> blocks;

  // scratch: union-find, search (@see reserve_search())
  Array<std::uint32_t> parent, label;           // by body slot; by row: its group
  Array<std::uint32_t> pair_group, pair_begin;  // by contact pair: its group; where its rows begin in group_rows
  Array<Real> keys;
  Array<std::uint32_t> cursor;  // next free place of each body or group while a list is filled
  Array<Ranked> ranked;
  Array<std::uint32_t> place;

  enum Load : std::uint8_t { kUnseen, kLight, kHeavy };
  Array<std::uint8_t> load;      // by body slot, scratch of a solver that chooses: kUnseen between steps
  Array<GroundContact> grounds;  // of this step, by key: scratch

  bool solved_directly(std::size_t group) const { return direct.empty() || direct[group]; }
  bool solved_in_lanes(std::size_t row) const { return direct.empty() || !direct[label[row]]; }
  bool has_joints(std::size_t group) const {
    return !group_link_begin.empty() && group_link_begin[group] < group_link_begin[group + 1];
  }
  std::size_t groups() const { return group_begin.empty() ? 0 : group_begin.size() - 1; }
};

/// Parts of a loop that threads share take some microseconds each.
inline constexpr std::size_t kRowsAPart = 256, kBodiesAPart = 256;

const Material& material_of(const Scene& scene, std::uint32_t collider);
/// What two colliders are to each other where they touch, without what a host forbids.
struct MixedMaterial {
  Real friction, restitution;
  Real rolling, spinning;  // m
};
/// Of two slots of materials, or Colliders::kNoMaterial: what a host said of the pair, or else what they mix to.
MixedMaterial mixed_materials(const Scene& scene, std::uint32_t slot_a, std::uint32_t slot_b);
/// The same of two colliders, less what effects are forbidden to do to their bodies.
MixedMaterial mixed(const Scene& scene, std::uint32_t collider_a, std::uint32_t collider_b);
/// Mixed coefficient of two, by the rule with the larger number.
Real mix(Mix rule_a, Real a, Mix rule_b, Real b);

/// Stage group: rows of this step from the pair table, with last step's impulses matched to them. Allocates.
void make_rows(const World& world, StepReport& report, const StepTime& time);
/// Stage group: who is moved by rows or joints, and capacity for all that the rest of the step needs of them.
/// Allocates.
void list_moved_bodies(const World& world, Impulses& impulses, const StepTime& time);
/// By what the impulses of the last step are multiplied, to start from: substep now over substep then; 0: start cold.
Real start_scale(const World& world, Real h);
/// For who goes from the most severe row to those of its bodies: where those of each will stand in `half`, and capacity
/// for keys and ranks. Allocates.
void reserve_search(const World& world);
/// Velocity of B's point relative to A's, from the present state.
/// @param r_a, r_b  m, world axes, from the centres of mass   @return m/s, world
inline Vec3 relative_velocity(const State& s, const Row& row, const Vec3& r_a, const Vec3& r_b) {
  return s.v[row.b] + s.omega[row.b].cross(r_b) - s.v[row.a] - s.omega[row.a].cross(r_a);
}
/// m, from the present state and plan.rotation; the normal keeps its direction
inline Real separation_of(const World& world, const Row& row, const RowGeometry& g) {
  const State& s = world.state;
  // The difference of the centres first: far from the origin they are large and nearly equal.
  return ((s.x[row.b] - s.x[row.a]) + (arm_b(world, row, g) - arm_a(world, row, g))).dot(row.n);
}
/// What an impulse on a body does to its velocities.
/// @param p  N s, world   @param r  m, world axes, from the centre of mass
void push_body(const World& world, Velocities& to, std::uint32_t body, const Vec3& p, const Vec3& r);
/// K, 1/kg, world: the change of the relative velocity at a point per impulse there.
Mat3 velocity_per_impulse(const World& world, const Row& row, const RowMass& m);
/// inv_inertia_w of bodies in contact, from their present rotation matrices.
void refresh_inertias(const World& world);
/// Arms, effective masses, targets and relative velocities for this substep; applies the starting impulses.
void prepare_rows(const World& world, Velocities& to, Real h);
/// Rotation matrices of bodies in contact, after their poses changed.
void refresh_rotations(const World& world);
/// Separations of all rows from the present poses (after refresh_rotations()). Normals keep their direction.
void refresh_separations(const World& world);
/// f(block, its first row, one past its last), on all threads.
template <class F>
void each_block(const World& world, const F& f) {
  Contacts& c = *world.contacts;
  in_parallel(world.jobs, c.blocks.size(), 1, [&](std::uint32_t b) {
    const std::size_t first = b * kRowsAPart;
    f(c.blocks[b], first, std::min(first + kRowsAPart, c.rows.size()));
  });
}
/// Whether the next step may start from a row's impulse. What put a body into quarantine is forgotten, and so is what
/// overflowed: a host that gives the body a pose would get it back.
inline bool leaves_impulse(const World& world, const Row& row) {
  const State& s = world.state;
  const bool lost = s.quarantined_count > 0 && (s.is_lost(row.a) || s.is_lost(row.b));
  return row.p != Vec3::zero() && finite(row.p) && !lost;
}
/// Keep the impulses for the next step; blocks know how many there are.
void remember_impulses(const World& world, Impulses& to, Real h);

}  // namespace carom::dynamics

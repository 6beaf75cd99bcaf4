// Contacts in lanes: four pairs side by side, point by point, in the order in which a solver visits them.
//
// Pairs of one region (regions.h) stand together, colour by colour; those of a colour share no body that an impulse
// moves. The four side by side share none, and are of one kind: none waits for a neighbour's points. The outcome
// depends on that order alone. Threads share the colours of the whole and, of smaller regions, those of one level.
#pragma once

#include <algorithm>
#include <array>

#include "core/jobs.h"
#include "dynamics/contact/contact.h"
#include "dynamics/solver/colours.h"
#include "dynamics/solver/contact_kernels.h"
#include "dynamics/solver/regions.h"

namespace carom::dynamics {

static_assert(kPairPoints == Manifold::kMaxPoints);
/// Pairs of one kind, by number of points and whether they have one normal, share lanes: so what is computed for a pair
/// does not depend, to the bit, on who stands beside it (but on whether one of them is locked).
inline constexpr int kPairKinds = 2 * kPairPoints;

/// Rows in lanes, as doubles or as floats.
template <class Number>
struct ContactLanes {
  explicit ContactLanes(Memory* m) : pairs(m), points(m), drives(m), locks(m) {}

  Array<PairLanesOf<Number>> pairs;    // in the order of solving
  Array<PointLanesOf<Number>> points;  // [pairs' points] likewise
  Array<DriveLanesOf<Number>> drives;  // of pairs some of which are driven
  Array<LockLanesOf<Number>> locks;    // of pairs with bodies that are locked
};

/// What place_pairs() works with. While no pair comes or goes pairs keep their places from step to step.
struct Placing {
  explicit Placing(Memory* m)
      : met(m), kinematic(m), movers(m), regions(m), members(m), by_colour(m), in_region(m), at(m), taken(m), turn(m) {}

  bool stands = false;             // places are those of `met` and `regions`
  Array<ContactPair> met;          // what is solved in lanes
  Array<std::uint32_t> kinematic;  // slots, as those name them
  Array<std::uint32_t> movers;     // slots of bodies that impulses move, ascending
  Regions regions;                 // of movers

  // scratch
  struct Member {
    std::uint32_t manifold;
    std::uint32_t a, b;    // solver bodies, 0 for one that impulses do not move
    std::uint32_t bucket;  // colour and kind
  };
  Array<Member> members;           // by region, ascending by manifold
  Array<Member> by_colour;         // by region
  Array<std::uint32_t> in_region;  // by manifold
  Array<std::uint32_t> at;         // likewise: its place in members
  Array<std::uint64_t> taken;      // [levels][solver bodies], @see BothColours, then AsTheyCome
  Array<BodyTurn> turn;            // by solver body, of lead_lanes()
};

/// A body that may turn far for its shape, @see far_turns.h
struct FarTurn {
  bool may = false;
  bool marked = false;    // its rows are made anew
  bool again = false;     // and are to be once more
  bool led_back = false;  // its velocity is that of the substep's beginning
  bool led_on = false;    // and was led on from there, over this substep
  bool waits = false;     // for that: scratch
  Real unlike = 0;        // bound of its misfit for a radian
  Vec3 begun, end;        // rad/s, world: that, and the one which a rotation method led it to
};

struct WideContacts {
  explicit WideContacts(Memory* m)
      : in_double(m),
        velocity(m),
        displacement(m),
        shift(m),
        slot(m),
        held_back(m),
        far_turn(m),
        one_turner(m),
        body(m),
        swept_again(m),
        start_x(m),
        start_q(m),
        manifolds(m),
        parts(m),
        colours(m),
        occupant(m),
        first_point(m) {}

  const ContactKernels* kernels = &contact_kernels();

  ContactLanes<double> in_double;
  Owned<ContactLanes<float>> in_float;  // null until a step wants it
  bool is_float = false;                // which of these has the rows of this step: @see float_range.h
  bool far_turners = false;             // there are any: far_turn below
  float longest_way = 0;  // of the thickness of a pair, what gravity moves it by in a substep; of soft contacts

  // by solver body; 0 is none, then those that move of themselves, then those that impulses move
  std::uint32_t first_moved = 1;
  std::uint32_t rows = 0;  // in lanes
  Array<BodyVelocity> velocity;
  Array<BodyVelocity> displacement;  // m, rad: of a pass over positions
  Array<BodyShift> shift;
  Array<std::uint32_t> slot;  // of the body
  Array<Mat3> held_back;      // @see held_arms.h
  Array<FarTurn> far_turn;    // @see far_turns.h
  Participants one_turner;    // scratch, for rotation methods

  Array<std::uint32_t> body;        // by slot: solver body, 0 where it does not matter
  Array<std::uint8_t> swept_again;  // by solver body: its joints were led back by more than contacts may do without
  Array<Vec3> start_x;              // m, by solver body: as the step began
  Array<Quat> start_q;

  /// Rows of one pair, and where they went.
  struct Manifold {
    std::uint32_t row, points, kind;
    std::uint32_t pair, lane;  // in pairs
  };
  Array<Manifold> manifolds;  // in the order of the rows
  const Manifold& manifold_of(std::uint32_t row) const {
    const auto later = [](std::uint32_t r, const Manifold& m) { return r < m.row; };
    return *(std::upper_bound(manifolds.begin(), manifolds.end(), row, later) - 1);
  }

  /// A region's rows: where they begin, in the order in which they are solved.
  struct Part {
    std::uint32_t pair, point;  // in pairs and points
    std::uint32_t member;       // in Placing::members
  };
  Array<Part> parts;  // [regions + 2], by region; the first is of none
  std::uint32_t regions_end() const { return static_cast<std::uint32_t>(parts.size()) - 1; }
  /// [kColours]: where in pairs those of the whole's rows end that have a colour, kind by kind; pairs after the last
  /// colour's stand alone. Empty: there are none
  Array<std::array<std::uint32_t, kPairKinds>> colours;
  std::uint32_t first_of(std::uint32_t colour) const { return colour == 0 ? 0 : colours[colour - 1].back(); }
  Array<std::uint32_t> occupant;     // [4 pairs] manifold, or kEmptyLane
  Array<std::uint32_t> first_point;  // [pairs]

  Owned<Placing> placing;  // null until a step has rows
};

inline bool has_one_normal(const WideContacts::Manifold& m) { return m.kind < kPairPoints; }

inline constexpr std::uint32_t kEmptyLane = 0xFFFFFFFFu;

/// f(lanes, sweeps): those that have the rows of this step.
template <class Wide, class F>
void with_lanes(Wide& wide, const F& f) {
  if (wide.is_float)
    f(*wide.in_float, wide.kernels->in_float);
  else
    f(wide.in_double, wide.kernels->in_double);
}

/// @param bodies  velocities, or displacements
template <class Number>
LaneRunOf<Number> everything(const WideContacts& wide, ContactLanes<Number>& lanes, BodyVelocity* bodies) {
  return {lanes.pairs.data(), lanes.pairs.size(), lanes.points.data(), bodies,
          wide.shift.data(),  wide.first_moved,   lanes.drives.data(), lanes.locks.data()};
}

/// Of a loop that threads share.
inline constexpr std::size_t kPairsAPart = 16;

template <class Run, class Kernel>
void over_part(const Run& run, std::size_t begin, std::size_t end, const Kernel& kernel) {
  Run part = run;
  part.pairs += begin, part.count = end - begin;
  kernel(part);
}

/// kernel(part of the run), for kernels that write bodies: pairs of one colour of the whole, in parts at once.
template <class Run, class Kernel>
void over_colour(Jobs* jobs, const WideContacts& wide, std::uint32_t colour, const Run& run, const Kernel& kernel) {
  const auto& ends = wide.colours[colour];
  const std::size_t first = wide.first_of(colour), count = ends.back() - first;
  if (!jobs && count > 0) return over_part(run, first, ends.back(), kernel);
  // A part is the same share of each kind: rows have an order in space, so that a thread which does the same share of
  // each colour finds in its cache the bodies that it moved before.
  in_parts(jobs, count, kPairsAPart, [&](std::size_t begin, std::size_t end) {
    std::size_t from = first;
    for (const std::uint32_t to : ends) {
      over_part(run, from + (to - from) * begin / count, from + (to - from) * end / count, kernel);
      from = to;
    }
  });
}

/// Likewise for pairs beyond the colours, one after the other; then for those of smaller regions.
template <class Run, class Kernel>
void after_colours(Jobs* jobs, const WideContacts& wide, const Run& run, const Kernel& kernel) {
  if (!jobs) return over_part(run, wide.first_of(kColours), run.count, kernel);
  const auto all_of = [&](std::uint32_t region, std::uint32_t from) {
    const std::uint32_t end = wide.parts[region + 1].pair;
    if (from < end) over_part(run, from, end, kernel);
  };
  all_of(1, wide.first_of(kColours));
  for (std::uint32_t first = 2; first < wide.regions_end(); first *= 2)
    in_parallel(jobs, first, 1, [&](std::uint32_t i) { all_of(first + i, wide.parts[first + i].pair); });
}

/// Likewise for all pairs, in the order in which they stand: one colour of the whole after the other, then region by
/// region.
template <class Run, class Kernel>
void in_order(Jobs* jobs, const WideContacts& wide, const Run& run, const Kernel& kernel) {
  if (run.count == 0) return;
  if (!jobs) return kernel(run);
  for (std::uint32_t colour = 0; colour < kColours; ++colour) over_colour(jobs, wide, colour, run, kernel);
  after_colours(jobs, wide, run, kernel);
}

/// Likewise for kernels that write pairs and points alone: all at once.
template <class Run, class Kernel>
void in_any_order(Jobs* jobs, const Run& run, const Kernel& kernel) {
  in_parts(jobs, run.count, kPairsAPart, [&](std::uint32_t begin, std::uint32_t end) {
    Run r = run;
    r.pairs += begin, r.count = end - begin;
    kernel(r);
  });
}

/// kernel(sweeps, part of the run), for sweeps that write bodies: in order.
/// @param bodies  velocities, or displacements
template <class Kernel>
void sweep_bodies(const World& world, BodyVelocity* bodies, const Kernel& kernel) {
  WideContacts& wide = *world.wide;
  with_lanes(wide, [&](auto& lanes, const auto& sweeps) {
    in_order(world.jobs, wide, everything(wide, lanes, bodies), [&](const auto& run) { kernel(sweeps, run); });
  });
}
template <class Kernel>
void sweep_contacts(const World& world, const Kernel& kernel) {
  sweep_bodies(world, world.wide->velocity.data(), kernel);
}
/// Likewise for those that write pairs and points alone.
template <class Kernel>
void over_contacts(const World& world, const Kernel& kernel) {
  WideContacts& wide = *world.wide;
  with_lanes(wide, [&](auto& lanes, const auto& sweeps) {
    in_any_order(world.jobs, everything(wide, lanes, wide.velocity.data()),
                 [&](const auto& run) { kernel(sweeps, run); });
  });
}

/// Number the bodies, give each pair its place in lanes. Allocates.
void place_pairs(const World& world, WideContacts& wide);
/// Lay this step's rows out in lanes, with the poses and velocities of the present, and their masses. Allocates.
/// @param h  s, substep
void pack(const World& world, SolverMemory& memory, WideContacts& wide, Real h);
/// Bodies' velocities from the state, and back. The first marks all bodies as untouched, the second those that a solver
/// moved as touched.
void load_velocities(const World& world, WideContacts& wide);
/// @param h  s, substep
void store_velocities(const World& world, Velocities& to, const WideContacts& wide, Real h);
/// How far bodies have come, from the state.
void load_shifts(const World& world, WideContacts& wide);
/// Separations of all points from the present poses.
void measure_lanes(const World& world);
inline BodyShift shift_since(const State& s, std::uint32_t slot, const Pose& start) {
  const Vec3 x = s.x[slot] - start.p;
  const Quat q = s.q[slot] * start.q.conjugate();
  return {.x = {x.x(), x.y(), x.z()}, .u = {q.x(), q.y(), q.z()}, .w = q.w()};
}
/// What impacts of this substep did to poses and impulses.
void heed_impacts(const World& world, WideContacts& wide);
/// What ground that turns does in this substep, from poses and velocities of the state.   @param h  s, substep
void lead_lanes(const World& world, WideContacts& wide, Real h);
/// Moves bodies by their displacements.
void displace(const World& world, Poses& to, const WideContacts& wide);
/// Impulses, separations and velocities back into the rows.
void unpack(const World& world, WideContacts& wide);

}  // namespace carom::dynamics

// The one table of dials: names, bounds, defaults, and what each trades.
#include "dynamics/dials.h"

namespace carom::dynamics {
namespace {

constexpr const char* kIntegrators[] = {"explicit_euler", "semi_implicit_euler", "rk4", "velocity_verlet"};
constexpr const char* kRotations[] = {"none",         "explicit",  "implicit",    "rk4",
                                      "lie_midpoint", "splitting", "splitting_4", "splitting_6"};
constexpr const char* kSolvers[] = {"severity", "soft_step", "direct", "auto"};
constexpr const char* kSearches[] = {"linear", "heap"};
constexpr const char* kOffOn[] = {"off", "on"};
constexpr const char* kBroadPhases[] = {"brute_force", "sweep_and_prune", "grid", "tree"};
constexpr const char* kNarrowPhases[] = {"hybrid", "gjk_epa"};
constexpr const char* kSimplices[] = {"johnson", "voronoi", "voronoi_last"};
constexpr const char* kContinuous[] = {"off", "flagged", "fast"};
constexpr const char* kPrecisions[] = {"float", "auto", "double"};
constexpr const char* kManifolds[] = {"single", "cache", "patch", "clip"};

template <std::uint32_t N>
constexpr DialRow choice(Dial d, const char* name, const char* summary, const char* const (&choices)[N], Real initial) {
  return {d, DialRow::choice, name, "", summary, choices, N, 0, Real(N - 1), initial};
}
constexpr DialRow integer(Dial d, const char* name, const char* summary, Real min, Real max, Real initial) {
  return {d, DialRow::integer, name, "", summary, nullptr, 0, min, max, initial};
}
constexpr DialRow number(Dial d, const char* name, const char* unit, const char* summary, Real min, Real max,
                         Real initial) {
  return {d, DialRow::number, name, unit, summary, nullptr, 0, min, max, initial};
}

constexpr std::array<DialRow, kDialCount> kDialTable = {{
    choice(Dial::integrator, "integrator",
           "order of the error in flight: 1, 1, 4, 2; cost 1, 1, 4, 2 force evaluations", kIntegrators, 3),
    choice(Dial::rotation, "rotation",
           "how bodies with unlike moments of inertia spin: no gyroscopic term, an explicit torque, one implicit "
           "Newton step, "
           "or exactly kept momentum by Runge-Kutta, midpoint, or splitting of order 2, 4, 6",
           kRotations, 5),
    integer(Dial::substeps, "substeps",
            "integrate-and-solve passes per step, where bodies can touch; error falls with each, cost grows", 1, 64, 4),
    choice(Dial::solver, "solver", "how contacts are resolved", kSolvers, 3),
    integer(Dial::velocity_iterations, "velocity_iterations",
            "solver severity: at most this many impulses per contact point of a group and substep", 1, 1000, 4),
    integer(
        Dial::position_iterations, "position_iterations",
        "solver severity: at most this many position corrections per contact point of a group and substep; 0: none, "
        "under direct, too",
        0, 1000, 2),
    number(Dial::velocity_tolerance, "velocity_tolerance", "m/s", "velocity error left unresolved at a contact", 0, 10,
           1e-4),
    number(Dial::position_tolerance, "position_tolerance", "m",
           "penetration left unresolved; of what is thin no more than 2 % of its thickness", 0, 1, 0.001),
    number(Dial::restitution_speed, "restitution_speed", "m/s", "below this approach speed a contact does not bounce",
           0, 100, 0.25),
    choice(Dial::severity_search, "severity_search", "find the most severe contact by scanning all, or from a heap",
           kSearches, 1),
    choice(Dial::groups, "groups", "resolve each contact group by itself, or all contacts as one", kOffOn, 1),
    choice(Dial::broad_phase, "broad_phase",
           "which bounds overlap: all pairs, sorted axes, cells, or a tree; same pairs", kBroadPhases, 3),
    number(Dial::grid_cell, "grid_cell", "m", "cell size of the uniform grid; 0 chooses it from the scene", 0, 1e6, 0),
    number(Dial::contact_distance, "contact_distance", "m", "pairs nearer than this make contacts before they touch", 0,
           10, 0.01),
    choice(Dial::pair_routines, "pair_routines", "specific routines for declared shapes, or the generic path for all",
           kOffOn, 1),
    choice(Dial::narrow_phase, "narrow_phase",
           "generic path: GJK on margin shells with EPA for deep contact, or exact GJK and EPA", kNarrowPhases, 1),
    choice(Dial::simplex, "simplex", "sub-algorithm of GJK; same results, different cost", kSimplices, 2),
    number(Dial::gjk_tolerance, "gjk_tolerance", "",
           "bracket width, relative to the pair's size, at which a query stops", 1e-14, 1e-1, 1e-6),
    integer(Dial::gjk_iterations, "gjk_iterations", "cap of GJK; a capped query still returns its bracket", 4, 10000,
            128),
    integer(Dial::epa_iterations, "epa_iterations", "cap of EPA; a capped query still returns its bracket", 4, 512,
            256),
    number(Dial::hybrid_margin, "hybrid_margin", "m",
           "shell around each shape in the hybrid: larger is faster, and wronger", 0, 1, 0.005),
    choice(Dial::warm_separation, "warm_separation", "start a query from the pair's last separating vector", kOffOn, 1),
    choice(Dial::manifold, "manifold",
           "contact points of a pair: the deepest, up to four gathered over steps, or the whole patch at once: probed "
           "for, or clipped from declared faces",
           kManifolds, 3),
    number(Dial::cache_distance, "cache_distance", "m", "a kept contact point that moved further than this is dropped",
           0, 10, 0.02),
    choice(Dial::warm_start, "warm_start", "solve each step from zero (the paper's), or from the last step's impulses",
           kOffOn, 1),
    number(Dial::carry_over, "carry_over", "",
           "bracket width, relative to the pair's size, up to which an earlier result stands in for a query; 0: never",
           0, 1e-1, 0),
    number(
        Dial::contact_frequency, "contact_frequency", "Hz",
        "stiffness of soft contacts: more sinks less and settles later; a quarter of the substep rate at most; what is thin "
        "has stiffer ones, and sinks by 0.1 % of its thickness under its own weight",
        0, 1e4, 30),
    number(Dial::contact_damping, "contact_damping", "",
           "damping ratio of soft contacts: above 1 they do not swing; more recovers slower from overlap", 0, 1e3, 10),
    number(Dial::push_speed, "push_speed", "m/s",
           "overlap of a contact is undone at this speed at most, by soft contacts and the direct solver", 0, 1e3, 0.5),
    choice(Dial::sleep, "sleep", "islands that came to rest are not simulated until something touches them", kOffOn, 0),
    number(Dial::sleep_speed, "sleep_speed", "m/s", "no point of a body that falls asleep moves faster than this", 0,
           10, 0.05),
    number(Dial::sleep_time, "sleep_time", "s", "for how long an island has been slow when it falls asleep", 0, 1e3,
           0.5),
    number(Dial::direct_sink, "direct_sink", "",
           "solver auto: a group where soft contacts would let a body sink by more than this share of its thickness "
           "goes to the direct solver",
           0, 1e3, 0.001),
    number(Dial::direct_ratio, "direct_ratio", "",
           "solver auto: so does one where masses of bodies that touch are further apart than this", 1, 1e12, 100),
    integer(
        Dial::direct_work, "direct_work",
        "solver auto: all such groups together take no more block products a step than this, about 0.1 us each, and one "
        "no more than 16 for each of its points; what was just built and stands is solved to the end, once",
        0, 1e9, 20000),
    number(Dial::hold_angle, "hold_angle", "rad",
           "arms of contacts turn with a body only when it has turned by this or turns fast: tall stacks do not "
           "buckle; 0: at once",
           0, 1, 0.02),
    number(Dial::joint_frequency, "joint_frequency", "Hz",
           "stiffness of joints outside the direct solver; a quarter of the substep rate at most", 0, 1e4, 1000),
    number(Dial::joint_damping, "joint_damping", "",
           "damping ratio of joints: more undoes a gap slower, less may swing", 0, 1e3, 1),
    choice(
        Dial::continuous, "continuous",
        "what is swept from pose to pose, so that it passes through nothing: no body, bodies that a host flagged, or "
        "also what moves far for its size in a step",
        kContinuous, 2),
    choice(
        Dial::precision, "precision",
        "numbers in which contacts are solved in lanes: float takes half the memory, auto takes it where that saves time: "
        "from 512 pairs in contact; poses, velocities and all else stay double",
        kPrecisions, 1),
    integer(
        Dial::joint_order, "joint_order",
        "order 2, 4 or 6 of the error of islands that joints alone hold, with gaps at rounding, in 1, 5 or 9 stages a "
        "substep (odd: the next), above 2 also of bodies that springs, drag and fields alone move; 0: as joints in contact "
        "are",
        0, 6, 2),
    number(Dial::accuracy_place, "accuracy_place", "m/s",
           "tolerance of places a second of motion: islands take the substeps that their error estimates call for; "
           "0: none",
           0, 1e6, 0),
    number(Dial::accuracy_turn, "accuracy_turn", "rad/s", "likewise of turns; both 0: all take the dial's substeps", 0,
           1e6, 0),
    integer(Dial::accuracy_substeps, "accuracy_substeps",
            "bound of work: substeps that an island may take in a step where an accuracy is set", 2, 4096, 256),
    number(Dial::accuracy_work, "accuracy_work", "1",
           "likewise of islands in contact: contact points times substeps, but no fewer substeps than without an "
           "accuracy",
           1, 1e12, 30000),
    number(
        Dial::keep_distance, "keep_distance", "m",
        "how far two bodies may move before contact points of flat faces and edges are looked for anew: off by less than "
        "its square over the smaller radius; 0: in each step",
        0, 1, 1e-3),
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kDialCount; ++i)
    if (static_cast<std::size_t>(kDialTable[i].dial) != i) return false;
  return true;
}
static_assert(in_order(), "rows stand in the order of enum Dial");

}  // namespace

const std::array<DialRow, kDialCount>& dial_table() { return kDialTable; }

Dials::Dials() {
  for (std::size_t i = 0; i < kDialCount; ++i) value[i] = kDialTable[i].initial;
}

}  // namespace carom::dynamics

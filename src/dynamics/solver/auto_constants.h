// Numbers by which solver auto chooses, beside its dials direct_sink, direct_ratio and direct_work.
#pragma once

#include <cstdint>

#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<std::uint32_t> kMostDirectBodies{
    "direct_most_bodies", 512, "bodies",
    "of a group that the direct solver solves: beyond, finding an order of elimination alone takes too long",
    "more: a large heap stalls the step in which it counts as heavy; fewer: long chains and tall walls of unlike "
    "masses are left to soft contacts, and sink"};
inline constexpr Constant<std::uint64_t> kMostFactor{
    "direct_most_factor", 400000, "block products",
    "of a step of Newton's method: pyramids and walls of 512 blocks take less, and stand as they were built",
    "more: a heap that comes to rest stalls the step in which it is tried; fewer: large walls and pyramids sink, or fall"};

inline constexpr Constant<Real> kImpactShare{
    "direct_impact_share", 0.1, "1",
    "share of the thickness: points that close as fast as after a fall through it are under impact; what was just piled up, "
    "or rocks and creaks under its load, stays well below",
    "larger: an impact sends the direct solver through all of a heap; smaller: a stack that rocks counts as under impact, and "
    "sinks under its load"};
// What bodies remember.
inline constexpr Constant<std::uint8_t> kBorneFor{
    "direct_borne_for", 2, "steps",
    "for so long must a load be borne to count: an impact is as heavy as a load, but passes",
    "1: every landing sends its group to the direct solver; more: a tall stack sinks for as long before it is held"};
inline constexpr Constant<std::uint8_t> kBearsFor{
    "direct_bears_for", 60, "steps",
    "for so long does a load count that is no longer borne: a second at 60 Hz, longer than a stack rocks",
    "fewer: groups go to and fro between two solvers, and jerk at each change; more: what was unloaded is solved "
    "exactly for as long, to no use"};
inline constexpr Constant<std::uint8_t> kCooldown{
    "direct_cooldown", 120, "steps",
    "for so long is a group left to soft contacts that came nowhere near its solution within direct_work: it moves too "
    "much, and goes on to",
    "fewer: what can't be solved in time is tried again and again, at the full price each time; more: a heap that came "
    "to rest sags for as long"};

inline constexpr ConstantRow kAutoConstants[] = {kMostDirectBodies, kMostFactor, kImpactShare,
                                                 kBorneFor,         kBearsFor,   kCooldown};

}  // namespace carom::dynamics

// Memory that steps laid out for many contacts, given back when there have long been few: bodies fell asleep, or went.
#pragma once

#include "core/constant.h"
#include "dynamics/world.h"

namespace carom::dynamics {

struct MeanMotion;

inline constexpr Constant<std::uint32_t> kStepsBeforeGivingBack{
    "steps_before_giving_back", 120, "steps",
    "with few contacts before memory that was laid out for many is given back to the host",
    "more: a scene that fell asleep keeps its memory longer; fewer: one that wakes now and then allocates in its "
    "steps"};
inline constexpr Constant<std::uint32_t> kRowsKept{
    "rows_kept", 1024, "contact points", "for which memory is kept in any case",
    "more: small worlds never allocate again; fewer: they may when they wake"};

inline constexpr ConstantRow kGiveBackConstants[] = {kStepsBeforeGivingBack, kRowsKept};

/// As a step begins: what follows makes it all anew. Does not throw, and no bit of a state depends on it.
void give_back(const World& world, Impulses& impulses, PairTable& pairs, Owned<MeanMotion>& means);

}  // namespace carom::dynamics

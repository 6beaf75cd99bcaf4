// Whether the rows of a step can be solved in floats.
//
// The dial `precision` asks for floats. They end at 1e38 and have 24 bits, so what they can't bear is solved in
// doubles: the step as a whole, since rows that share a body are solved together. That is so if
//  - a body that contacts move weighs less than 1e-9 kg or more than 1e9,
//  - a contact's place is further than 10 km from a body's centre of mass, or its friction beyond 1e6,
//  - a push at a contact turns a body so easily that it gives way 1e4 times as much as at the centre, or a twist there
//    finds 1e-5 of the response that another axis has (needles of 1 : 700): the masses are then differences of numbers
//    that are too unlike,
//  - a belt runs, or a substep is so short, that their numbers leave the range.
// A body that forces make faster than 1e9 m/s or rad/s within the step is not moved by contacts in that substep, and
// others see it at that speed.
#pragma once

#include "core/constant.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

// Floats save memory traffic: four of them take no less time than four doubles. The dial's `auto` asks for them where
// the rows of doubles would leave the second cache.
inline constexpr Constant<std::uint32_t> kFloatsFrom{
    "floats_from", 512, "pairs",
    "in contact in lanes: with what they are filled from, rows in doubles take about 2 kB each, so from here they fill "
    "a second cache of 1 MiB",
    "more: heaps of a thousand bodies take a third more time; fewer: small scenes lose digits and gain nothing"};

inline constexpr ConstantRow kFloatConstants[] = {kFloatsFrom};

/// Of what is known before there are lanes; ContactSweeps::prepare looks at these.
/// @param h  s, substep
bool bears_floats(const World& world, const WideContacts& wide, Real h);

inline constexpr Real kFastestInFloat = 1e9;  // m/s, rad/s
inline bool is_slow(const Vec3& v) { return v.squared_norm() <= kFastestInFloat * kFastestInFloat; }
inline bool is_slow_enough(const State& state, std::uint32_t body) {
  return is_slow(state.v[body]) && is_slow(state.omega[body]);
}
/// As fast as it may be.
void cap(BodyVelocity& velocity);

}  // namespace carom::dynamics

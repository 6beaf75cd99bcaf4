// Splitting: the kinetic energy is cut into parts under each of which the body's motion is one turn, known in closed
// form.
//
//   T = |L|^2 / (2 I_x)  +  dy p_y^2 / 2  +  dz p_z^2 / 2,      p = q^-1 L,  dy = 1/I_y - 1/I_x,  dz = 1/I_z - 1/I_x
//
//   first part     q' = exp(h L / I_x) q        about L in the world. |L| is the same for every orientation, so this
//   part
//                                               commutes with the others and is done once, for a whole composition
//   other parts    q' = q exp(h dy p_y e_y)     about a principal axis; p turns the other way, p_y stays
//
// The two that do not commute are composed symmetrically: y(h/2) z(h) y(h/2), of second order, and such steps of g_1 h,
// ..., g_n h into one of fourth (Suzuki) or sixth (Yoshida). Every turn keeps L and is symplectic, hence so is the
// step: energy errs by a bounded amount for ever. A body with two equal moments has dy = 0 or dz = 0: its motion is
// exact at any h.
// @source [McLachlan1993], [Touma1994], [Hairer2006 §V.3.2, §VII.5]
#include "dynamics/integrate/rotation/split_turn.h"
#include "dynamics/integrate/turn_kernels.h"

namespace carom::dynamics {
namespace {

template <std::size_t n>
auto split(const Real (&g)[n]) {
  return [&g](const Principal& top, Real step, const Vec3& l, Vec3& p, Quat& q) { turn_split(top, step, l, p, q, g); };
}

/// Four at a time, where lanes are for them.
void split_in_lanes(const World& world, Velocities& to, const Participants& participants, Real h) {
  const State& s = world.state;
  PredictedPose& predicted = world.plan->predicted;
  const Tops tops = {world.plan->principal.data(),     s.q.data()->data(),
                     s.omega.data()->data(),           s.momentum.data()->data(),
                     to.momentum.data()->data(),       to.omega.data()->data(),
                     predicted.q.data()->data(),       predicted.omega.data()->data(),
                     kMomentumAgrees * kMomentumAgrees};
  const auto in_lanes = turn_kernels().split;
  const auto all = [](std::uint32_t) { return true; };
  participants.each_four(world.jobs, all, [&](const std::uint32_t* body, std::uint32_t count) {
    if (count == 4 && in_lanes(tops, body, h)) return;
    for (std::uint32_t k = 0; k < count; ++k) carry_top(world, to, body[k], h, split(kOne));
  });
}

}  // namespace

const Rotation kSplitting = {"splitting", split_in_lanes};
const Rotation kSplitting4 = {"splitting_4", [](const World& w, Velocities& to, const Participants& c, Real h) {
                                carry_tops(w, to, c, h, split(kSuzuki4));
                              }};
const Rotation kSplitting6 = {"splitting_6", [](const World& w, Velocities& to, const Participants& c, Real h) {
                                carry_tops(w, to, c, h, split(kYoshida6));
                              }};

}  // namespace carom::dynamics

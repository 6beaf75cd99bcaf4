// Sets of particles: theirs is a state of columns.
#include "dynamics/particles/particles.h"

#include <bit>

#include "dynamics/snapshot/section.h"

namespace carom::dynamics::snapshot {
namespace {

template <class Io, class S>
void set(Io& io, S& p, [[maybe_unused]] std::uint32_t slot) {
  io.begin_item();
  io.name_item(Item::set, slot);
  const Real factor = io.real(p.def.gravity_factor), damping = io.real(p.def.linear_damping),
             mass = io.real(p.def.mass);
  io.demand(damping >= 0 && mass >= 0);
  keep(io, p.def, ParticleDef{factor, damping, mass});
  const std::uint64_t n = io.count(p.size(), 6 * sizeof(Real)), words = (n + 63) / 64;
  io.demand(n <= kMostParticles);
  const bool weighed = yes_or_no(io, !p.mass.empty());
  if (io.bad()) return;
  if constexpr (Io::checks) io.needs.sets.push_back({slot, n, weighed});
  if constexpr (Io::loads) {
    for (int axis = 0; axis < 3; ++axis) p.x[axis].resize(n), p.v[axis].resize(n);
    p.mass.resize(weighed ? n : 0), p.held.resize(words);
    p.sums.assign((n + kParticleBlock - 1) / kParticleBlock, FlightSums{});
  }
  for (int axis = 0; axis < 3; ++axis) io.column(p.x[axis].data(), n), io.column(p.v[axis].data(), n);
  if (weighed) io.column(p.mass.data(), n);
  io.column(p.held.data(), words);
  if constexpr (Io::loads) {
    if (n % 64) p.held.back() &= (std::uint64_t(1) << n % 64) - 1;
    p.held_count = 0;
    for (const std::uint64_t bits : p.held) p.held_count += static_cast<std::size_t>(std::popcount(bits));
  }
}

struct Sets {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& all = world.particles;
    for (std::uint32_t s = 0; s < all.slots.slots() && !io.bad(); ++s)
      if (all.slots.alive(s)) set(io, all.set[s], s);
    if constexpr (Io::loads) all.recount();
  }
};

}  // namespace

constinit const Section kSets = section<Sets>("PART", "particles");

}  // namespace carom::dynamics::snapshot

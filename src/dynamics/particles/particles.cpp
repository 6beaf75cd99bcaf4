// Particles come, go, are written to.
#include "dynamics/particles/particles.h"

#include <algorithm>

namespace carom::dynamics {
namespace {

template <class F>
void each_array(ParticleSet& set, F&& f) {
  for (int axis = 0; axis < 3; ++axis) f(set.x[axis]), f(set.v[axis]);
}

/// Capacity for `size` elements, and more if there was none.
template <class T>
void reserve_more(Array<T>& a, std::size_t size) {
  if (size > a.capacity()) a.reserve(std::max(size, a.size() + a.size() / 2));
}

std::size_t words(std::size_t particles) { return (particles + 63) / 64; }
std::size_t blocks(std::size_t particles) { return (particles + kParticleBlock - 1) / kParticleBlock; }

/// What is not in `indices` moves up. @param indices  ascending
template <class T>
void close_up(Array<T>& a, const std::uint32_t* indices, std::size_t n) {
  auto to = a.begin() + indices[0];
  for (std::size_t k = 0; k < n; ++k) {
    const auto from = a.begin() + indices[k] + 1, end = k + 1 < n ? a.begin() + indices[k + 1] : a.end();
    to = std::move(from, end, to);
  }
  a.erase(to, a.end());
}

}  // namespace

Handle Particles::create(const ParticleDef& def, std::size_t capacity) {
  if (set.capacity() <= slots.slots()) set.reserve(std::max<std::size_t>(4, 2 * set.size()));
  const std::uint32_t before = slots.slots();
  const Handle handle = slots.take();
  if (handle == 0) return 0;
  const std::uint32_t s = handle_slot(handle);
  if (slots.slots() > before) set.emplace_back(memory_);
  set[s].def = def;
  try {
    reserve(s, capacity);
  } catch (...) {
    destroy(s);
    throw;
  }
  return handle;
}

void Particles::destroy(std::uint32_t s) {
  clear(s);
  set[s] = ParticleSet(memory_);
  slots.release(s);
}

void Particles::update(std::uint32_t s, const ParticleDef& def) {
  ParticleSet& p = set[s];
  if (def.mass != p.def.mass && p.mass.empty()) {  // those that are there keep theirs
    reserve_masses(s);
    p.mass.assign(p.size(), p.def.mass);
  }
  p.def = def;
}

void Particles::reserve(std::uint32_t s, std::size_t capacity) {
  ParticleSet& p = set[s];
  each_array(p, [&](Array<Real>& a) { a.reserve(capacity); });
  if (!p.mass.empty()) p.mass.reserve(capacity);
  p.held.reserve(words(capacity));
  p.sums.reserve(blocks(capacity));
}

std::size_t Particles::extend(std::uint32_t s, std::size_t n) {
  ParticleSet& p = set[s];
  const std::size_t first = p.size(), size = first + n;
  each_array(p, [&](Array<Real>& a) { reserve_more(a, size); });
  if (!p.mass.empty()) reserve_more(p.mass, size);
  reserve_more(p.held, words(size));
  reserve_more(p.sums, blocks(size));
  each_array(p, [&](Array<Real>& a) { a.resize(size, Real(0)); });
  if (!p.mass.empty()) p.mass.resize(size, p.def.mass);
  p.held.resize(words(size), 0);
  p.sums.resize(blocks(size));
  count_ += n;
  return first;
}

void Particles::remove(std::uint32_t s, const std::uint32_t* indices, std::size_t n) {
  ParticleSet& p = set[s];
  if (n == 0) return;
  if (p.held_count > 0) {
    std::size_t k = 0, to = 0, kept = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const bool is_held = p.is_held(i);
      if (k < n && indices[k] == i) {
        ++k;
        continue;
      }
      p.mark(to, is_held);
      ++to, kept += is_held;
    }
    for (; to < p.size(); ++to) p.mark(to, false);
    p.held_count = kept;
  }
  each_array(p, [&](Array<Real>& a) { close_up(a, indices, n); });
  if (!p.mass.empty()) close_up(p.mass, indices, n);
  p.held.resize(words(p.size()));
  p.sums.resize(blocks(p.size()));
  count_ -= n;
}

void Particles::clear(std::uint32_t s) {
  ParticleSet& p = set[s];
  count_ -= p.size();
  each_array(p, [](Array<Real>& a) { a.clear(); });
  p.mass.clear(), p.held.clear(), p.sums.clear();
  p.held_count = 0;
}

void Particles::place(std::uint32_t s, std::size_t i, const Vec3& x) {
  ParticleSet& p = set[s];
  for (int axis = 0; axis < 3; ++axis) p.x[axis][i] = x[axis];
  p.held_count -= p.is_held(i);
  p.mark(i, false);
}

void Particles::set_velocity(std::uint32_t s, std::size_t i, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) set[s].v[axis][i] = v[axis];
}

void Particles::reserve_masses(std::uint32_t s) { set[s].mass.reserve(set[s].x[0].capacity()); }

void Particles::set_mass(std::uint32_t s, std::size_t i, Real mass) {
  ParticleSet& p = set[s];
  if (p.mass.empty()) p.mass.assign(p.size(), p.def.mass);
  p.mass[i] = mass;
}

void Particles::hold(std::uint32_t s, std::size_t i) {
  ParticleSet& p = set[s];
  set_velocity(s, i, Vec3::zero());
  p.held_count += !p.is_held(i);
  p.mark(i, true);
}

void Particles::recount() {
  count_ = 0;
  for (const ParticleSet& p : set) count_ += p.size();
}

std::uint64_t Particles::held_count() const {
  std::uint64_t n = 0;
  for (const ParticleSet& p : set) n += p.held_count;
  return n;
}

void Particles::add_to(Hash& hash) const {
  for (std::uint32_t s = 0; s < slots.slots(); ++s) {
    if (!slots.alive(s)) continue;
    const ParticleSet& p = set[s];
    hash.add((std::uint64_t(s) << 32) | p.size());
    for (int axis = 0; axis < 3; ++axis) {
      for (const Real x : p.x[axis]) hash.add(double(x));
      for (const Real v : p.v[axis]) hash.add(double(v));
    }
    for (const std::uint64_t bits : p.held) hash.add(bits);
  }
}

Real Particles::linear_energy() const {
  Real energy = 0;
  for (const ParticleSet& p : set) {
    Real vis_viva = 0;
    for (const FlightSums& block : p.sums) vis_viva += block.vis_viva;
    energy += (p.mass.empty() ? p.def.mass : 1) * vis_viva / 2;
  }
  return energy;
}

}  // namespace carom::dynamics

// Turns of four bodies side by side: the arithmetic behind TurnKernels. Included by one file for each width of registers,
// compiled for it; all that stands here is local to that file.
//
// The same operations in the same order as core/pose.h, core/turn.h, rotation/top.h and rotation/split_turn.h.
#pragma once

#include <cstddef>

#include "core/wide.h"
#include "dynamics/integrate/turn_kernels.h"

namespace carom::dynamics {
namespace {

struct LaneQuat {
  Lanes w;
  LaneVec v;
};
CAROM_LANES_INLINE LaneQuat operator*(const LaneQuat& a, const LaneQuat& b) {
  return {a.w * b.w - a.v.x * b.v.x - a.v.y * b.v.y - a.v.z * b.v.z,
          {a.w * b.v.x + a.v.x * b.w + a.v.y * b.v.z - a.v.z * b.v.y,
           a.w * b.v.y + a.v.y * b.w + a.v.z * b.v.x - a.v.x * b.v.z,
           a.w * b.v.z + a.v.z * b.w + a.v.x * b.v.y - a.v.y * b.v.x}};
}
CAROM_LANES_INLINE LaneVec operator*(const LaneQuat& q, const LaneVec& a) {
  const LaneVec u = cross(q.v, a), uu = u + u;
  return a + q.w * uu + cross(q.v, uu);
}
CAROM_LANES_INLINE LaneQuat conjugate(const LaneQuat& q) { return {q.w, {-q.v.x, -q.v.y, -q.v.z}}; }
CAROM_LANES_INLINE Lanes squared(const LaneVec& a) { return a.x * a.x + (a.y * a.y + a.z * a.z); }
CAROM_LANES_INLINE Lanes squared(const LaneQuat& q) {
  return (q.v.x * q.v.x + q.v.y * q.v.y) + (q.v.z * q.v.z + q.w * q.w);
}
CAROM_LANES_INLINE bool every(LaneMask m) { return (m[0] & m[1] & m[2] & m[3]) != 0; }
CAROM_LANES_INLINE LaneVec choose(LaneMask first, const LaneVec& a, const LaneVec& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}
CAROM_LANES_INLINE LaneQuat choose(LaneMask first, const LaneQuat& a, const LaneQuat& b) {
  return {first ? a.w : b.w, choose(first, a.v, b.v)};
}
CAROM_LANES_INLINE Lanes magnitude(Lanes a) { return a < 0 ? -a : a; }

/// Three or four numbers of each of four bodies, which begin at row[i].
CAROM_LANES_INLINE LaneVec vector_at(const double* const* row) {
  const LanePair xy = gather(row, 0), yz = gather(row, 1);
  return {xy.first, xy.second, yz.second};
}
CAROM_LANES_INLINE LaneQuat quaternion_at(const double* const* row) {
  const LanePair xy = gather(row, 0), zw = gather(row, 2);
  return {zw.second, {xy.first, xy.second, zw.first}};
}
CAROM_LANES_INLINE void put(const LaneVec& a, double* all_bodies, const std::uint32_t* body) {
  const LaneRows xy(a.x, a.y);
  for (int i = 0; i < kLanes; ++i) {
    double* const to = all_bodies + 3 * std::size_t(body[i]);
    xy.put(i, to), to[2] = a.z[i];
  }
}
CAROM_LANES_INLINE void put(const LaneQuat& q, double* all_bodies, const std::uint32_t* body) {
  const LaneRows xy(q.v.x, q.v.y), zw(q.v.z, q.w);
  for (int i = 0; i < kLanes; ++i) {
    double* const to = all_bodies + 4 * std::size_t(body[i]);
    xy.put(i, to), zw.put(i, to + 2);
  }
}

/// normalized(), of what has about that length: else false.
CAROM_LANES_INLINE bool normalize(LaneQuat& q) {
  const Lanes n2 = squared(q), s = 1 / square_root(n2);
  q = {q.w * s, {q.v.x * s, q.v.y * s, q.v.z * s}};
  return every((n2 > 0.5) & (n2 < 2));
}

/// exp_map(), of turns by less than half of a right angle or so: else false. sin_cos() reduces nothing then.
CAROM_LANES_INLINE bool exponential(const LaneVec& phi, LaneQuat& turn) {
  const Lanes angle2 = squared(phi);
  Lanes scale = 0.5 - angle2 / 48 + angle2 * angle2 / 3840, w = 1 - angle2 / 8 + angle2 * angle2 / 384;
  const LaneMask small = angle2 < 1e-6;
  if (!every(small)) {
    const Lanes angle = square_root(angle2), r = angle / 2, z = r * r;
    if (!every(r < 0.75)) return false;
    const Lanes s =
        r + r * z *
                (-1.0 / 6 +
                 z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880 +
                                                          z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 +
                                                                                      z * (-1.0 / 1307674368000.0 +
                                                                                           z / 355687428096000.0)))))));
    const Lanes c =
        1 - z * (0.5 - z * (1.0 / 24 -
                            z * (1.0 / 720 -
                                 z * (1.0 / 40320 - z * (1.0 / 3628800 - z * (1.0 / 479001600.0 -
                                                                              z * (1.0 / 87178291200.0 -
                                                                                   z * (1.0 / 20922789888000.0 -
                                                                                        z / 6402373705728000.0))))))));
    scale = small ? scale : s / angle;
    w = small ? w : c;
  }
  turn = {w, scale * phi};
  return true;
}

bool move(const Motions& all_bodies, const std::uint32_t* body, double h) {
  static constexpr double kNone[3] = {0, 0, 0};
  const double *x[kLanes], *v[kLanes], *q[kLanes], *omega[kLanes], *turned[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    const std::size_t at = body[i];
    const bool is_turned = all_bodies.turned && all_bodies.turned[at];
    x[i] = all_bodies.x + 3 * at, v[i] = all_bodies.v + 3 * at, omega[i] = all_bodies.omega + 3 * at;
    q[i] = (is_turned ? all_bodies.turned_q : all_bodies.q) + 4 * at;
    turned[i] = is_turned ? all_bodies.turned_omega + 3 * at : kNone;
  }
  const LaneVec to = vector_at(x) + all(h) * vector_at(v);
  const Lanes most = all(all_bodies.most_x);
  if (!every((magnitude(to.x) <= most) & (magnitude(to.y) <= most) & (magnitude(to.z) <= most))) return false;
  LaneQuat turn;
  if (!exponential(all(h) * (vector_at(omega) - vector_at(turned)), turn)) return false;
  turn = turn * quaternion_at(q);
  if (!normalize(turn)) return false;
  put(to, all_bodies.to_x, body), put(turn, all_bodies.to_q, body);
  return true;
}

/// Vectors and turns of four tops with axes in the order of the top, and back: @see Principal::sorted().
struct TopAxes {
  const std::uint8_t* axis[kLanes];
  Lanes sign;

  CAROM_LANES_INLINE LaneVec of(const double* const* row) const {
    const auto component = [&](int k) __attribute__((always_inline)) {
      return Lanes{row[0][axis[0][k]], row[1][axis[1][k]], row[2][axis[2][k]], row[3][axis[3][k]]};
    };
    return {sign * component(0), sign * component(1), sign * component(2)};
  }
  /// @param stride  numbers of a body
  CAROM_LANES_INLINE void put(const LaneVec& a, double* all_bodies, const std::uint32_t* body,
                              std::size_t stride) const {
    const LaneVec u = sign * a;
    for (int i = 0; i < kLanes; ++i) {
      double* const to = all_bodies + stride * body[i];
      to[axis[i][0]] = u.x[i], to[axis[i][1]] = u.y[i], to[axis[i][2]] = u.z[i];
    }
  }
};

/// turn_by(), of half an angle x: x^2 < 0.09.
struct LaneTurn {
  Lanes half_cos, half_sin, cos, sin;
  CAROM_LANES_INLINE explicit LaneTurn(Lanes angle) {
    const Lanes x = angle / 2, z = x * x;
    const Lanes s = x * (1 - z * (4.0 / 33 - z / 495));
    const Lanes c = 1 - z * (5.0 / 11 - z * (2.0 / 99 - z / 10395));
    const Lanes n = 1 / (c * c + s * s);
    half_cos = c, half_sin = s, cos = (c - s) * (c + s) * n, sin = 2 * c * s * n;
  }
};
CAROM_LANES_INLINE void turn_y(Lanes angle, LaneQuat& q, LaneVec& p) {
  const LaneTurn t(angle);
  const Lanes c = t.half_cos, s = t.half_sin;
  q = {q.w * c - q.v.y * s, {q.v.x * c - q.v.z * s, q.v.y * c + q.w * s, q.v.z * c + q.v.x * s}};
  p = {t.cos * p.x - t.sin * p.z, p.y, t.sin * p.x + t.cos * p.z};
}
CAROM_LANES_INLINE void turn_z(Lanes angle, LaneQuat& q, LaneVec& p) {
  const LaneTurn t(angle);
  const Lanes c = t.half_cos, s = t.half_sin;
  q = {q.w * c - q.v.z * s, {q.v.x * c + q.v.y * s, q.v.y * c - q.v.x * s, q.v.z * c + q.w * s}};
  p = {t.cos * p.x + t.sin * p.y, t.cos * p.y - t.sin * p.x, p.z};
}

bool split(const Tops& all_bodies, const std::uint32_t* body, double h) {
  const Principal* top[kLanes];
  const double *q_at[kLanes], *omega_at[kLanes], *momentum_at[kLanes], *numbers[kLanes], *frame_at[kLanes];
  TopAxes axes;
  LaneMask aligned = {0, 0, 0, 0};
  for (int i = 0; i < kLanes; ++i) {
    const std::size_t at = body[i];
    top[i] = all_bodies.principal + at;
    aligned[i] = -std::int64_t(top[i]->aligned);
    axes.axis[i] = top[i]->axis, axes.sign[i] = top[i]->sign;
    numbers[i] = &top[i]->base;
    q_at[i] = all_bodies.q + 4 * at, omega_at[i] = all_bodies.omega + 3 * at;
    momentum_at[i] = all_bodies.momentum + 3 * at;
  }
  static_assert(offsetof(Principal, dy) == offsetof(Principal, base) + sizeof(double) &&
                offsetof(Principal, dz) == offsetof(Principal, base) + 2 * sizeof(double) &&
                offsetof(Principal, moment) == offsetof(Principal, base) + 3 * sizeof(double));
  const LanePair n01 = gather(numbers, 0), n23 = gather(numbers, 2), n45 = gather(numbers, 4);
  const Lanes base = n01.first, dy = n01.second, dz = n23.first;
  const LaneVec moment = {n23.second, n45.first, n45.second};

  LaneQuat q = {Lanes{q_at[0][3], q_at[1][3], q_at[2][3], q_at[3][3]}, axes.of(q_at)}, frame;
  if (!every(aligned)) {
    for (int i = 0; i < kLanes; ++i) frame_at[i] = top[i]->frame.at;
    frame = quaternion_at(frame_at);
    q = choose(aligned, q, q * frame);
  }
  LaneVec l = axes.of(momentum_at);
  const LaneVec omega = axes.of(omega_at);
  const auto spin_of = [&](const LaneQuat& at, const LaneVec& p) __attribute__((always_inline)) {
    return base * l + at * LaneVec{all(0), dy * p.y, dz * p.z};
  };
  LaneVec p = conjugate(q) * l;
  const LaneMask kept = squared(spin_of(q, p) - omega) < all_bodies.agree2 * squared(omega);
  if (!every(kept)) {
    const LaneVec m = conjugate(q) * omega, new_p = {moment.x * m.x, moment.y * m.y, moment.z * m.z}, new_l = q * new_p;
    p = choose(kept, p, new_p), l = choose(kept, l, new_l);
  }
  // Turns by less than 0.6 rad, in one part.
  const Lanes step = all(h), rate = magnitude(step) * (magnitude(dy) + magnitude(dz));
  const LaneVec phi = (step * base) * l;
  const Lanes z = squared(phi) / 4;
  if (!every((rate * rate * squared(p) < 0.35) & (z < 0.09))) return false;
  const Lanes s = 0.5 * (1 - z * (4.0 / 33 - z / 495));
  const Lanes c = 1 - z * (5.0 / 11 - z * (2.0 / 99 - z / 10395));
  if (!every(kept)) axes.put(l, all_bodies.to_momentum, body, 3);
  q = LaneQuat{c, s * phi} * q;
  const Lanes y = step * dy, half = y * 0.5;
  turn_y(half * p.y, q, p);
  turn_z(step * dz * p.z, q, p);
  turn_y(half * p.y, q, p);
  const Lanes scale = 1 / square_root(squared(q));
  q = {q.w * scale, scale * q.v};
  const LaneVec spin = spin_of(q, conjugate(q) * l);
  if (!every(aligned)) q = choose(aligned, q, q * conjugate(frame));
  axes.put(q.v, all_bodies.predicted_q, body, 4);
  for (int i = 0; i < kLanes; ++i) all_bodies.predicted_q[4 * std::size_t(body[i]) + 3] = q.w[i];
  axes.put(spin, all_bodies.predicted_omega, body, 3), axes.put(spin, all_bodies.to_omega, body, 3);
  return true;
}

void shift(const Shifts& of, const std::uint32_t* body) {
  const double *x[kLanes], *q[kLanes], *start_x[kLanes], *start_q[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    x[i] = of.x + 3 * std::size_t(body[i]), q[i] = of.q + 4 * std::size_t(body[i]);
    start_x[i] = of.start_x + 3 * i, start_q[i] = of.start_q + 4 * i;
  }
  const LaneVec moved = vector_at(x) - vector_at(start_x);
  const LaneQuat turned = quaternion_at(q) * conjugate(quaternion_at(start_q));
  const LaneRows xy(moved.x, moved.y), z_u(moved.z, turned.v.x), u(turned.v.y, turned.v.z), w(turned.w, all(0));
  for (int i = 0; i < kLanes; ++i) {
    double* const to = of.to + 8 * i;
    xy.put(i, to), z_u.put(i, to + 2), u.put(i, to + 4), w.put(i, to + 6);
  }
}

bool lead(const Leads& of, const std::uint32_t* body, double h) {
  const double *x_at[kLanes], *omega_at[kLanes];
  for (int i = 0; i < kLanes; ++i)
    x_at[i] = of.x + 3 * std::size_t(body[i]), omega_at[i] = of.omega + 3 * std::size_t(body[i]);
  const LaneVec x = vector_at(x_at), omega = vector_at(omega_at);
  LaneQuat turn;
  if (!exponential(all(h) * omega, turn)) return false;
  const LaneRows xy(x.x, x.y), z_u(x.z, turn.v.x), u(turn.v.y, turn.v.z), w(turn.w, omega.x), last(omega.y, omega.z);
  for (int i = 0; i < kLanes; ++i) {
    double* const to = of.to + 10 * i;
    xy.put(i, to), z_u.put(i, to + 2), u.put(i, to + 4), w.put(i, to + 6), last.put(i, to + 8);
  }
  return true;
}

constexpr TurnKernels turn_kernels_named(const char* name) { return {name, move, split, shift, lead}; }

}  // namespace
}  // namespace carom::dynamics

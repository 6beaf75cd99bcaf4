// Rows into lanes when a step begins, and back when it ends. Part of contact_sweeps.h; all that stands here is
// local to the file that includes it.
#pragma once

#include "dynamics/solver/contact_kernels.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

template <class Number>
CAROM_LANES_INLINE LanesOf<Number> rounded(Lanes a) {
  if constexpr (sizeof(Number) == sizeof(double))
    return a;
  else
    return to_float(a);
}
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> rounded(const LaneVec& a) {
  return {rounded<Number>(a.x), rounded<Number>(a.y), rounded<Number>(a.z)};
}

CAROM_LANES_INLINE Lanes widened(Lanes a) { return a; }
CAROM_LANES_INLINE Lanes widened(LanesOf<float> a) { return to_double(a); }
template <class Number>
CAROM_LANES_INLINE LaneVec widened(const LaneVecOf<Number>& a) {
  return {widened(a.x), widened(a.y), widened(a.z)};
}

/// A number, a vector, a matrix of each of four: they begin at row[i][at].
CAROM_LANES_INLINE Lanes number_at(const double* const* row, int at) {
  return Lanes{row[0][at], row[1][at], row[2][at], row[3][at]};
}
CAROM_LANES_INLINE LaneVec vector_at(const double* const* row, int at) {
  const LanePair xy = gather(row, at), yz = gather(row, at + 1);
  return {xy.first, xy.second, yz.second};
}
struct LaneMatrix {
  LaneVec column[3];

  CAROM_LANES_INLINE explicit LaneMatrix(const double* const* row) {
    const LanePair p = gather(row, 0), q = gather(row, 2), r = gather(row, 4), s = gather(row, 6), t = gather(row, 7);
    column[0] = {p.first, p.second, q.first};
    column[1] = {q.second, r.first, r.second};
    column[2] = {s.first, s.second, t.second};
  }
  CAROM_LANES_INLINE LaneVec operator*(const LaneVec& a) const {
    return a.x * column[0] + (a.y * column[1] + a.z * column[2]);
  }
};
CAROM_LANES_INLINE Lanes inner(const LaneVec& a, const LaneVec& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }

/// any_perpendicular(), of unit length.
CAROM_LANES_INLINE LaneVec tangent_of(const LaneVec& n) {
  LaneMask bits;
  __builtin_memcpy(&bits, &n.z, sizeof bits);
  const Lanes sign = bits < 0 ? all(-1) : all(1), a = -1 / (sign + n.z);
  const LaneVec t = {1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
  const Lanes length = square_root(inner(t, t));
  return {t.x / length, t.y / length, t.z / length};
}

/// Four symmetric matrices of which `of` has all nine numbers.
template <class Number>
CAROM_LANES_INLINE LaneSymmetricOf<Number> symmetric(const double* const* of) {
  const LaneMatrix m(of);
  return {rounded<Number>(m.column[0].x), rounded<Number>(m.column[1].x), rounded<Number>(m.column[2].x),
          rounded<Number>(m.column[1].y), rounded<Number>(m.column[2].y), rounded<Number>(m.column[2].z)};
}

/// @param slide  @see LaneSources
template <class Lanes>
CAROM_LANES_INLINE bool some_slide(Lanes slide) {
  return slide[0] + slide[1] + slide[2] + slide[3] > 0;
}

/// Where friction of pairs that slide acts: at the middle of their loads. What bears nothing, as points in the air
/// under a cylinder that rolls, has no part in it. Where loads are not known those points count that are as near as the
/// nearest, to kTouching of their distance, all alike.
struct SlidingMiddle {
  LaneVec at = {all(0), all(0), all(0)};  // m, as `arm`
  Lanes slide = all(0);                   // above 0: known

  /// @param arm  [count] m
  CAROM_LANES_INLINE SlidingMiddle(const LaneSources& of, const LaneVec* arm, int count) {
    Lanes load[kPairPoints], gap[kPairPoints], whole = all(0), least = all(0), width2 = all(0);
    for (int k = 0; k < count; ++k) {
      const double *row[kLanes], *geometry[kLanes];
      for (int lane = 0; lane < kLanes; ++lane) {
        row[lane] = of.row[lane] + k * kRowNumbers;
        geometry[lane] = of.geometry[lane] + k * kGeometryNumbers;
      }
      const LaneVec apart = arm[k] - arm[0];
      load[k] = larger(inner(vector_at(row, kRowImpulse), vector_at(row, kRowNormal)), all(0));
      gap[k] = number_at(geometry, kGeometrySeparation);
      whole += load[k];
      least = k == 0 || gap[k] < least ? gap[k] : least;
      width2 = larger(inner(apart, apart), width2);
    }
    const auto bears = (whole > 0) & (of.slide > 1);
    const Lanes near = all(kTouching.value) * square_root(width2);
    Lanes sum = all(0), weight[kPairPoints];
    for (int k = 0; k < count; ++k) {
      const Lanes touches = gap[k] - least <= near ? all(1) : all(0);
      weight[k] = bears ? load[k] : touches;
      sum += weight[k];
    }
    slide = sum > 0 ? of.slide : all(0);
    const Lanes per = 1 / (sum > 0 ? sum : all(1));
    for (int k = 0; k < count; ++k) at = at + (per * weight[k]) * arm[k];
  }
  CAROM_LANES_INLINE LaneVec or_else(const LaneVec& middle, const LaneVec& moved) const {
    const auto known = slide > 0;
    return {known ? moved.x : middle.x, known ? moved.y : middle.y, known ? moved.z : middle.z};
  }
};

/// Points where Arms sees them, friction at their middle or that of their loads, from the impulses that rows start
/// with.
template <class Number>
void lay_out(const LaneRunOf<Number>& run, const LaneSources* sources) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanesOf<Number>& pair = run.pairs[i];
    PointLanesOf<Number>* const points = run.points + pair.first;
    const LaneSources& of = sources[i];
    const int count = static_cast<int>(pair.points);
    const LaneMatrix r_a(of.rotation_a), r_b(of.rotation_b);
    const LaneVec apart = vector_at(of.x_b, 0) - vector_at(of.x_a, 0);
    const Lanes radius_a = number_at(of.geometry, kGeometryRadiusA),
                radius_b = number_at(of.geometry, kGeometryRadiusB);
    const Lanes part = all(1.0 / count);
    const LaneVec zero = {all(0), all(0), all(0)};
    LaneVec arm[kPairPoints], middle_a = zero, middle_b = zero, l_a = zero, l_b = zero;
    const double *row[kLanes], *geometry[kLanes];
    const auto look_at = [&](int k) __attribute__((always_inline)) {
      for (int lane = 0; lane < kLanes; ++lane) {
        row[lane] = of.row[lane] + k * kRowNumbers;
        geometry[lane] = of.geometry[lane] + k * kGeometryNumbers;
      }
    };
    for (int k = 0; k < count; ++k) {
      look_at(k);
      const LaneVec n = vector_at(row, kRowNormal), at_a = vector_at(geometry, kGeometryA),
                    at_b = vector_at(geometry, kGeometryB);
      const LaneVec on_a = r_a * at_a + radius_a * n, on_b = apart + (r_b * at_b - radius_b * n);
      arm[k] = on_a + of.to_b * (on_b - on_a);
      middle_a = middle_a + part * arm[k];
      middle_b = middle_b + part * (arm[k] - apart);
      l_a = l_a + part * at_a;  // the points of a body are held as one, wherever its friction acts
      l_b = l_b + part * at_b;
    }
    Lanes reach_share = all(1);
    if (some_slide(of.slide)) {
      reach_share = of.slide > 0 ? number_at(of.row, kRowTwistShare) : reach_share;
      const SlidingMiddle sliding(of, arm, count);
      middle_a = sliding.or_else(middle_a, sliding.at);
      middle_b = sliding.or_else(middle_b, sliding.at - apart);
    }
    const LaneVec n = vector_at(of.row, kRowNormal), t = tangent_of(n);
    LaneVec force = zero;
    Lanes twist = all(0);
    for (int k = 0; k < count; ++k) {
      look_at(k);
      PointLanesOf<Number>& point = points[k];
      const LaneVec n_k = vector_at(row, kRowNormal), p = vector_at(row, kRowImpulse), d = arm[k] - middle_a;
      const Lanes p_n = inner(p, n_k);
      const LaneVec sideways = p - p_n * n_k;
      force = force + sideways;
      twist += inner(cross(d, sideways), n);
      point.d = rounded<Number>(d);
      point.gap = point.separation = rounded<Number>(number_at(geometry, kGeometrySeparation));
      point.reach = rounded<Number>(reach_share * square_root(inner(d, d)));
      point.p_n = rounded<Number>(p_n);
      point.sum_n = all<Number>(0);
      point.n = rounded<Number>(n_k);
    }
    pair.inv_mass_a = rounded<Number>(of.inv_mass_a), pair.inv_mass_b = rounded<Number>(of.inv_mass_b);
    pair.inv_inertia_a = symmetric<Number>(of.inv_inertia_a), pair.inv_inertia_b = symmetric<Number>(of.inv_inertia_b);
    pair.n = rounded<Number>(n);
    pair.t = rounded<Number>(t);
    pair.r_a = rounded<Number>(middle_a + LaneMatrix(of.held_a) * l_a);
    pair.r_b = rounded<Number>(middle_b + LaneMatrix(of.held_b) * l_b);
    pair.radius_a = rounded<Number>(radius_a), pair.radius_b = rounded<Number>(radius_b);
    pair.friction = rounded<Number>(of.friction);
    pair.slide = rounded<Number>(of.slide);
    pair.slides = some_slide(of.slide);
    pair.bounce_speed = rounded<Number>(of.bounce_speed);
    pair.thickness = rounded<Number>(of.thickness);
    pair.pull = rounded<Number>(of.pull);
    pair.p_t = rounded<Number>(inner(force, t));
    pair.p_s = rounded<Number>(inner(force, cross(n, t)));
    pair.p_w = rounded<Number>(twist);
    pair.sum_t = pair.sum_s = pair.sum_w = all<Number>(0);
  }
}

/// How friction of four pairs, a force and a twist about where it acts, is shared among them: by their loads,
/// turned about the point at which those loads act together. Added up again it is what it was.
class FrictionShares {
 public:
  /// @param load  [count] N s, normal impulses   @param twist  N m s, about where it acts
  template <class Number>
  CAROM_LANES_INLINE FrictionShares(const PointLanesOf<Number>* points, const Lanes* load, int count, const LaneVec& n,
                                    const LaneVec& force, Lanes twist)
      : n_(n) {
    Lanes whole = all(0), moment = all(0), most = all(0);
    LaneVec sum = {all(0), all(0), all(0)};
    for (int k = 0; k < count; ++k) {
      const Lanes reach = widened(points[k].reach);
      whole += load[k];
      sum = sum + load[k] * widened(points[k].d);
      most = larger(reach * reach, most);
    }
    const auto any = whole > 0;
    const Lanes weight = any ? whole : all(1);
    centre_ = {any ? sum.x / weight : all(0), any ? sum.y / weight : all(0), any ? sum.z / weight : all(0)};
    slide_ = {any ? force.x / weight : all(0), any ? force.y / weight : all(0), any ? force.z / weight : all(0)};
    for (int k = 0; k < count; ++k) {
      const LaneVec turn = cross(n, widened(points[k].d) - centre_);
      moment += load[k] * inner(turn, turn);
    }
    const auto turns = any & (moment > 1e-9 * whole * most);
    turn_ = turns ? (twist - inner(cross(centre_, force), n)) / (turns ? moment : all(1)) : all(0);
  }
  /// N s, friction at a point   @param d  m, from where it acts   @param load  N s
  CAROM_LANES_INLINE LaneVec at(const LaneVec& d, Lanes load) const {
    return load * (slide_ + turn_ * cross(n_, d - centre_));
  }

 private:
  LaneVec n_, centre_, slide_;
  Lanes turn_;
};

/// Of each of four: from at[i] on.
CAROM_LANES_INLINE void put(const LaneVec& a, double* const* at, int place) {
  const LaneRows xy(a.x, a.y);
  for (int i = 0; i < kLanes; ++i)
    if (at[i]) xy.put(i, at[i] + place), at[i][place + 2] = a.z[i];
}

/// Impulses of the last substep and of the step back into rows, and how points are apart and move now.
template <class Number>
void read_back(const LaneRunOf<Number>& run, const LaneTargets* targets) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanesOf<Number>& pair = run.pairs[i];
    const PointLanesOf<Number>* const points = run.points + pair.first;
    const LaneTargets& of = targets[i];
    const int count = static_cast<int>(pair.points);
    const LaneMatrix r_a(of.rotation_a), r_b(of.rotation_b);
    const LaneVec apart = vector_at(of.x_b, 0) - vector_at(of.x_a, 0), v_a = vector_at(of.v_a, 0),
                  v_b = vector_at(of.v_b, 0), omega_a = vector_at(of.omega_a, 0), omega_b = vector_at(of.omega_b, 0);
    const Lanes radius_a = number_at(of.geometry, kGeometryRadiusA),
                radius_b = number_at(of.geometry, kGeometryRadiusB);
    const LaneVec n = widened(pair.n), t = widened(pair.t), s = cross(n, t);
    Lanes load[kPairPoints], sum[kPairPoints];
    for (int k = 0; k < count; ++k) load[k] = widened(points[k].p_n), sum[k] = widened(points[k].sum_n);
    const FrictionShares now(points, load, count, n, widened(pair.p_t) * t + widened(pair.p_s) * s, widened(pair.p_w)),
        step(points, sum, count, n, widened(pair.sum_t) * t + widened(pair.sum_s) * s, widened(pair.sum_w));
    for (int k = 0; k < count; ++k) {
      const double *row[kLanes], *geometry[kLanes];
      double *to_row[kLanes], *to_geometry[kLanes];
      for (int lane = 0; lane < kLanes; ++lane) {
        row[lane] = of.row[lane] + k * kRowNumbers, geometry[lane] = of.geometry[lane] + k * kGeometryNumbers;
        to_row[lane] = of.to_row[lane] ? of.to_row[lane] + k * kRowNumbers : nullptr;
        to_geometry[lane] = of.to_geometry[lane] ? of.to_geometry[lane] + k * kGeometryNumbers : nullptr;
      }
      const LaneVec n_k = vector_at(row, kRowNormal), d = widened(points[k].d);
      put(load[k] * n_k + now.at(d, load[k]), to_row, kRowImpulse);
      put(vector_at(geometry, kGeometryImpulse) + (sum[k] * n_k + step.at(d, sum[k])), to_geometry, kGeometryImpulse);
      const LaneVec at_a = r_a * vector_at(geometry, kGeometryA) + radius_a * n_k,
                    at_b = r_b * vector_at(geometry, kGeometryB) - radius_b * n_k;
      put(v_b + cross(omega_b, at_b) - v_a - cross(omega_a, at_a), to_row, kRowVelocity);
      const Lanes separation = inner(apart + (at_b - at_a), n_k);
      for (int lane = 0; lane < kLanes; ++lane)
        if (to_geometry[lane]) to_geometry[lane][kGeometrySeparation] = separation[lane];
    }
  }
}

}  // namespace
}  // namespace carom::dynamics

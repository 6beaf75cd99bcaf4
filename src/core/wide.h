// Lanes: four reals that go through the same arithmetic side by side, doubles or floats.
//
// The width is part of the layout, not of the machine: on SSE2 four doubles are two registers, on AVX2 one. Every lane
// goes through the same operations in the same order whatever the registers, so results have the same bits anywhere.
// Everything here is inlined always: a file that includes it may be compiled for a newer machine than the rest, and no
// copy of a function made for that machine may be left for others to call.
#pragma once

#include <cstdint>

#include "core/layers.h"

// How such values are passed between functions depends on the machine: none is, everything below is inlined.
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpsabi"
#elif defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace carom::core {

inline constexpr int kLanes = 4;

/// Lanes of a kind of number. Aligned by hand: compilers align them by the widest registers that they know of, and
/// layouts must not differ.
template <class Number>
struct Wide;
template <>
struct Wide<double> {
  using Lanes = double __attribute__((vector_size(kLanes * sizeof(double)), aligned(kLanes * sizeof(double))));
};
template <>
struct Wide<float> {
  using Lanes = float __attribute__((vector_size(kLanes * sizeof(float)), aligned(kLanes * sizeof(float))));
};
template <class Number>
using LanesOf = typename Wide<Number>::Lanes;
using Lanes = LanesOf<double>;
using LaneMask =
    std::int64_t __attribute__((vector_size(kLanes * sizeof(double)), aligned(kLanes * sizeof(double))));  // 0 or -1

#define CAROM_LANES_INLINE [[gnu::always_inline]] inline

/// A part of a kernel of which one copy would do, where kernels are in few copies: then they find out in a loop what else the
/// compiler knows. A module that is downloaded (bindings/js/wasm/flags.cmake) has them so, and x86-64 (src/CMakeLists.txt).
#if defined(CAROM_FEW_COPIES)
#define CAROM_SHARED_PART [[gnu::noinline]]
constexpr bool kFewCopies = true;  // of this file: others may be compiled otherwise
#else
#define CAROM_SHARED_PART CAROM_LANES_INLINE
constexpr bool kFewCopies = false;
#endif
/// Likewise, but short: natively a call of it, with what it is given in memory, takes as long as the part itself.
#if defined(__wasm__)
#define CAROM_SHORT_PART CAROM_SHARED_PART
#else
#define CAROM_SHORT_PART CAROM_LANES_INLINE
#endif

/// A number that a compiler must have at hand before it spreads it over lanes. clang 14 for WebAssembly would load
/// and spread it at
/// once, and does so behind stores to where it was (bindings/js/wasm/flags.cmake).
template <class Number>
CAROM_LANES_INLINE Number at_hand(Number x) {
#if defined(__wasm_simd128__)
  asm("" : "+r"(x));
#endif
  return x;
}
CAROM_LANES_INLINE Lanes all(double x) {
  const double n = at_hand(x);
  return Lanes{n, n, n, n};
}
template <class Number>
CAROM_LANES_INLINE LanesOf<Number> all(double x) {
  const Number n = at_hand(static_cast<Number>(x));
  return LanesOf<Number>{n, n, n, n};
}
CAROM_LANES_INLINE Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }   // b where either is no number
CAROM_LANES_INLINE Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }  // likewise
CAROM_LANES_INLINE Lanes square_root(Lanes a) {
  return Lanes{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
}
/// 1 / a, 0 where a is not above 0.
CAROM_LANES_INLINE Lanes inverse_or_zero(Lanes a) {
  const auto positive = a > 0;
  const Lanes inverse = 1 / (positive ? a : all(1));
  return positive ? inverse : all(0);
}
// The same for floats.
CAROM_LANES_INLINE LanesOf<float> larger(LanesOf<float> a, LanesOf<float> b) { return a > b ? a : b; }
CAROM_LANES_INLINE LanesOf<float> smaller(LanesOf<float> a, LanesOf<float> b) { return a < b ? a : b; }
CAROM_LANES_INLINE LanesOf<float> square_root(LanesOf<float> a) {
  return LanesOf<float>{__builtin_sqrtf(a[0]), __builtin_sqrtf(a[1]), __builtin_sqrtf(a[2]), __builtin_sqrtf(a[3])};
}
CAROM_LANES_INLINE LanesOf<float> inverse_or_zero(LanesOf<float> a) {
  const auto positive = a > 0;
  const LanesOf<float> inverse = 1 / (positive ? a : all<float>(1));
  return positive ? inverse : all<float>(0);
}

/// Two numbers of each of four rows as two lanes, and back.
///   first[i] = row[i][0], second[i] = row[i][1]
struct LanePair {
  Lanes first, second;
};
using Half = double __attribute__((vector_size(2 * sizeof(double))));
// Two ways, by the machine that a file is compiled for, each in a namespace of its own: they are different types.
#if defined(__AVX__)
inline namespace by_shuffles {
CAROM_LANES_INLINE Half half_at(const double* from) {
  Half h;
  __builtin_memcpy(&h, from, sizeof h);
  return h;
}
CAROM_LANES_INLINE LanePair gather(const double* const* row, int at) {
  const Lanes even = __builtin_shufflevector(half_at(row[0] + at), half_at(row[2] + at), 0, 1, 2, 3),
              odd = __builtin_shufflevector(half_at(row[1] + at), half_at(row[3] + at), 0, 1, 2, 3);
  return {__builtin_shufflevector(even, odd, 0, 4, 2, 6), __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
}
struct LaneRows {
  Half row[kLanes];
  CAROM_LANES_INLINE LaneRows(Lanes first, Lanes second) {
    const Lanes even = __builtin_shufflevector(first, second, 0, 4, 2, 6),
                odd = __builtin_shufflevector(first, second, 1, 5, 3, 7);
    row[0] = __builtin_shufflevector(even, even, 0, 1), row[2] = __builtin_shufflevector(even, even, 2, 3);
    row[1] = __builtin_shufflevector(odd, odd, 0, 1), row[3] = __builtin_shufflevector(odd, odd, 2, 3);
  }
  CAROM_LANES_INLINE void put(int i, double* to) const { __builtin_memcpy(to, &row[i], sizeof row[i]); }
};
}  // namespace by_shuffles
#else  // compilers take such shuffles apart
inline namespace one_by_one {
CAROM_LANES_INLINE LanePair gather(const double* const* row, int at) {
  return {Lanes{row[0][at], row[1][at], row[2][at], row[3][at]},
          Lanes{row[0][at + 1], row[1][at + 1], row[2][at + 1], row[3][at + 1]}};
}
struct LaneRows {
  Lanes first, second;
  CAROM_LANES_INLINE LaneRows(Lanes a, Lanes b) : first(a), second(b) {}
  CAROM_LANES_INLINE void put(int i, double* to) const { to[0] = first[i], to[1] = second[i]; }
};
}  // namespace one_by_one
#endif

/// Four rows of four floats as lanes, or back: lane[k][i] = row[i][k].
struct FloatLanes {
  LanesOf<float> lane[kLanes];
};
CAROM_LANES_INLINE FloatLanes transpose(LanesOf<float> a, LanesOf<float> b, LanesOf<float> c, LanesOf<float> d) {
  const LanesOf<float> ac = __builtin_shufflevector(a, c, 0, 4, 1, 5), ac2 = __builtin_shufflevector(a, c, 2, 6, 3, 7),
                       bd = __builtin_shufflevector(b, d, 0, 4, 1, 5), bd2 = __builtin_shufflevector(b, d, 2, 6, 3, 7);
  return {{__builtin_shufflevector(ac, bd, 0, 4, 1, 5), __builtin_shufflevector(ac, bd, 2, 6, 3, 7),
           __builtin_shufflevector(ac2, bd2, 0, 4, 1, 5), __builtin_shufflevector(ac2, bd2, 2, 6, 3, 7)}};
}
/// @param from  aligned as Lanes are
CAROM_LANES_INLINE Lanes lanes_at(const double* from) { return *reinterpret_cast<const Lanes*>(from); }
CAROM_LANES_INLINE LanesOf<float> to_float(Lanes a) { return __builtin_convertvector(a, LanesOf<float>); }
#if defined(__AVX__) && !defined(__clang__)
CAROM_LANES_INLINE Lanes to_double(LanesOf<float> a) { return __builtin_ia32_cvtps2pd256(a); }  // gcc takes it apart
#else
CAROM_LANES_INLINE Lanes to_double(LanesOf<float> a) { return __builtin_convertvector(a, Lanes); }
#endif

/// Four vectors, component by component.
template <class Number>
struct LaneVecOf {
  LanesOf<Number> x, y, z;
};
using LaneVec = LaneVecOf<double>;
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> operator+(const LaneVecOf<Number>& a, const LaneVecOf<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> operator-(const LaneVecOf<Number>& a, const LaneVecOf<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> operator*(LanesOf<Number> s, const LaneVecOf<Number>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class Number>
CAROM_LANES_INLINE LanesOf<Number> dot(const LaneVecOf<Number>& a, const LaneVecOf<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> cross(const LaneVecOf<Number>& a, const LaneVecOf<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Four symmetric matrices.
template <class Number>
struct LaneSymmetricOf {
  LanesOf<Number> xx, xy, xz, yy, yz, zz;
};
using LaneSymmetric = LaneSymmetricOf<double>;
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> operator*(const LaneSymmetricOf<Number>& m, const LaneVecOf<Number>& a) {
  return {m.xx * a.x + m.xy * a.y + m.xz * a.z, m.xy * a.x + m.yy * a.y + m.yz * a.z,
          m.xz * a.x + m.yz * a.y + m.zz * a.z};
}

}  // namespace carom::core

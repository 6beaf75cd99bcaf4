// Six by six numbers, and what is done with them.
#pragma once

#include <cstring>
#include <type_traits>

#include "core/vec6.h"

namespace carom::dynamics {

inline constexpr int kDof = 6;  // of a body: velocity, angular velocity

/// Row by row.
struct alignas(16) Block {
  Real x[kDof][kDof];
};

/// Two numbers side by side. Each goes through the operations that it would go through alone, so bits are the same.
using TwoReals = double __attribute__((vector_size(2 * sizeof(double))));

/// A row of a block, or six numbers of a body, in registers: members by name, since compilers keep no array there. What was
/// written number by number is not to be read two at a time at once: that waits until it is in memory.
struct RowOfTwos {
  TwoReals a, b, c;

  explicit RowOfTwos(const Real* row) : a(two(row)), b(two(row + 2)), c(two(row + 4)) {}
  RowOfTwos(const Vec3& linear, const Vec3& angular)
      : a{linear.x(), linear.y()}, b{linear.z(), angular.x()}, c{angular.y(), angular.z()} {}
  static RowOfTwos zero() { return {Vec3::zero(), Vec3::zero()}; }

  Vec3 linear() const { return {a[0], a[1], b[0]}; }
  Vec3 angular() const { return {b[1], c[0], c[1]}; }
  void store(Real* row) const {
    std::memcpy(row, &a, sizeof a), std::memcpy(row + 2, &b, sizeof b), std::memcpy(row + 4, &c, sizeof c);
  }
  void add(Real s, const RowOfTwos& o) {
    const TwoReals both = {s, s};
    a += both * o.a, b += both * o.b, c += both * o.c;
  }
  void subtract(Real s, const RowOfTwos& o) {
    const TwoReals both = {s, s};
    a -= both * o.a, b -= both * o.b, c -= both * o.c;
  }
  void multiply(Real by) {
    const TwoReals both = {by, by};
    a *= both, b *= both, c *= both;
  }
  void multiply(const RowOfTwos& o) { a *= o.a, b *= o.b, c *= o.c; }
  void add(const RowOfTwos& o) { a += o.a, b += o.b, c += o.c; }
  void subtract(const RowOfTwos& o) { a -= o.a, b -= o.b, c -= o.c; }
  Real dot(const RowOfTwos& o) const {
    const TwoReals s = a * o.a + b * o.b + c * o.c;
    return s[0] + s[1];
  }

 private:
  static TwoReals two(const Real* at) {
    TwoReals v;
    std::memcpy(&v, at, sizeof v);
    return v;
  }
};

inline RowOfTwos row_of(const Vec6& v) { return RowOfTwos(v.at); }
inline void add_to(Vec6& sum, RowOfTwos v) {
  v.add(row_of(sum));
  v.store(sum.at);
}
inline RowOfTwos row_of(const Block& a, int row) { return RowOfTwos(a.x[row]); }

// Row by row, for copies and zeros by string instructions take longer than sums.
template <class F>
void each_row(const F& f) {
  f(0), f(1), f(2), f(3), f(4), f(5);
}
inline void copy(const Block& from, Block& to) {
  each_row([&](int i) { row_of(from, i).store(to.x[i]); });
}
inline void set_zero(Block& a) {
  each_row([&](int i) { RowOfTwos::zero().store(a.x[i]); });
}
inline void add_to_row(Block& a, int i, RowOfTwos row) {
  row.add(row_of(a, i));
  row.store(a.x[i]);
}
inline void add_transposed(Block& c, const Block& a) {
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j) c.x[i][j] += a.x[j][i];
}

// Sizes below are numbers or, where a compiler is to unroll loops, constants.
template <int kSize>
using Size = std::integral_constant<int, kSize>;
using WholeBlock = Size<kDof>;

/// c -= a^T b, of n rows of a and of b.
template <class N>
void subtract_product(Block& c, const Block& a, const Block& b, N n) {
  each_row([&](int i) {
    RowOfTwos row = row_of(c, i);
    for (int k = 0; k < n; ++k) row.subtract(a.x[k][i], row_of(b, k));
    row.store(c.x[i]);
  });
}
inline void subtract_product(Block& c, const Block& a, const Block& b, Size<1>) {
  const RowOfTwos first = row_of(b, 0);
  each_row([&](int i) {
    RowOfTwos row = row_of(c, i);
    row.subtract(a.x[0][i], first);
    row.store(c.x[i]);
  });
}
inline void subtract_product(Block& c, const Block& a, const Block& b, Size<3>) {
  const RowOfTwos first = row_of(b, 0), second = row_of(b, 1), third = row_of(b, 2);
  each_row([&](int i) {
    RowOfTwos row = row_of(c, i);
    row.subtract(a.x[0][i], first), row.subtract(a.x[1][i], second), row.subtract(a.x[2][i], third);
    row.store(c.x[i]);
  });
}

/// a v, of a symmetric block.
inline RowOfTwos product(const Block& a, const Vec6& v) {
  RowOfTwos sum = row_of(a, 0);
  sum.multiply(v[0]);
  for (int i = 1; i < kDof; ++i) sum.add(v[i], row_of(a, i));
  return sum;
}

/// a := its lower Cholesky factor, of the first n rows and columns, with what divides by its diagonal there; what is above it
/// is left.   @return whether it was definite
template <class N = WholeBlock>
bool factor_in_place(Block& a, N n = {}) {
  for (int j = 0; j < n; ++j) {
    Real d = a.x[j][j];
    for (int k = 0; k < j; ++k) d -= a.x[j][k] * a.x[j][k];
    // Rounding leaves d wrong by some units of the entry that it is what remains of.
    if (!(d > 4 * kEpsilon * a.x[j][j])) return false;
    const Real inverse = 1 / std::sqrt(d);
    a.x[j][j] = inverse;
    for (int i = j + 1; i < n; ++i) {
      Real s = a.x[i][j];
      for (int k = 0; k < j; ++k) s -= a.x[i][k] * a.x[j][k];
      a.x[i][j] = s * inverse;
    }
  }
  return true;
}

/// a := l^-1 a, of n rows, for a factor l.
template <class N>
void solve_rows(const Block& l, Block& a, N n) {
  for (int i = 0; i < n; ++i) {
    RowOfTwos row = row_of(a, i);
    for (int k = 0; k < i; ++k) row.subtract(l.x[i][k], row_of(a, k));
    row.multiply(l.x[i][i]);
    row.store(a.x[i]);
  }
}

/// The first n equations of a factor, or of its transpose.
template <class N = WholeBlock>
void solve_lower(const Block& l, Vec6& y, N n = {}) {
  for (int i = 0; i < n; ++i) {
    Real s = y[i];
    for (int k = 0; k < i; ++k) s -= l.x[i][k] * y[k];
    y[i] = s * l.x[i][i];
  }
}
template <class N = WholeBlock>
void solve_upper(const Block& l, Vec6& y, N n = {}) {
  for (int i = n; i-- > 0;) {
    Real s = y[i];
    for (int k = i + 1; k < n; ++k) s -= l.x[k][i] * y[k];
    y[i] = s * l.x[i][i];
  }
}

}  // namespace carom::dynamics

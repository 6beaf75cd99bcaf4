// Plain vectors, matrices and quaternions: the same numbers as Eigen's to the bit, whose order of additions golden hashes
// were made with, and what a formula must give whatever its order.
#include <random>

#include "carom_test.h"
#include "core/pose.h"
#include "core/vec6.h"
#include "eigen.h"

using namespace carom;
using namespace carom::test;

namespace {

class Numbers {
 public:
  Real one() { return spread_(engine_); }
  Vec3 three() { return {one(), one(), one()}; }
  Mat3 nine() { return Mat3::columns(three(), three(), three()); }
  Quat four() { return {one(), one(), one(), one()}; }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<Real> spread_{-2, 2};
};

Eigen::Quaterniond eigen(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }
using test::eigen;

void assert_same(Real ours, Real theirs) { assert_true(ours == theirs); }
void assert_same(const Vec3& ours, const Eigen::Vector3d& theirs) {
  for (int i = 0; i < 3; ++i) assert_true(ours[i] == theirs[i]);
}
void assert_same(const Mat3& ours, const Eigen::Matrix3d& theirs) {
  for (int i = 0; i < 3; ++i) assert_same(ours.col(i), theirs.col(i));
}
void assert_same(const Quat& ours, const Eigen::Quaterniond& theirs) {
  for (int i = 0; i < 4; ++i) assert_true(ours.at[i] == theirs.coeffs()[i]);
}

void vectors_add_up_as_eigens(void**) {
  Numbers n;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = n.three(), b = n.three();
    const Eigen::Vector3d ea = eigen(a), eb = eigen(b);
    const Real s = n.one();
    assert_same(a.dot(b), ea.dot(eb)), assert_same(a.cross(b), ea.cross(eb)), assert_same(a.norm(), ea.norm());
    assert_same(a.normalized(), ea.normalized()), assert_same(a.sum(), ea.sum()), assert_same(a.product(), ea.prod());
    assert_same(a / s, ea / s), assert_same(s * a + (1 - s) * b, s * ea + (1 - s) * eb);
    assert_same(a.min(b), ea.cwiseMin(eb)), assert_same(a.max(b), ea.cwiseMax(eb));
    assert_same(a.over(b), ea.cwiseQuotient(eb)), assert_same(a.reciprocal(), ea.cwiseInverse());
    assert_same(a.max_entry(), ea.maxCoeff()), assert_same(a.min_entry(), ea.minCoeff());
    int most, least;
    ea.maxCoeff(&most), ea.minCoeff(&least);
    assert_int_equal(a.max_axis(), most), assert_int_equal(a.min_axis(), least);
  }
}

void matrices_add_up_as_eigens(void**) {
  Numbers n;
  for (int i = 0; i < 2000; ++i) {
    const Mat3 p = n.nine(), q = n.nine();
    const Eigen::Matrix3d ep = eigen(p), eq = eigen(q);
    const Vec3 a = n.three(), b = n.three();
    const Eigen::Vector3d ea = eigen(a), eb = eigen(b);
    assert_same(p * a, ep * ea), assert_same(p * q, ep * eq), assert_same(p * q * a, ep * eq * ea);
    assert_same(p.transpose() * a, ep.transpose() * ea), assert_same(p.transpose() * q, ep.transpose() * eq);
    assert_same(a - p * b, ea - ep * eb), assert_same(p - q * p * q, ep - eq * ep * eq);
    assert_same(outer(a, b), ea * eb.transpose()), assert_same(scale_rows(a, p), ea.asDiagonal() * ep);
    assert_same(scale_columns(p, a), ep * ea.asDiagonal()), assert_same(Mat3::diagonal(a), ea.asDiagonal());
    assert_same(p.inverse(), ep.inverse()), assert_same(p.determinant(), ep.determinant());
    assert_same(p.trace(), ep.trace()), assert_same(p.norm(), ep.norm()), assert_same((p - q).norm(), (ep - eq).norm());
    assert_same(p.abs().sum(), ep.cwiseAbs().sum()), assert_same(p.max_entry(), ep.maxCoeff());
    assert_same(p.row(1), ep.row(1)), assert_same(p.diagonal(), ep.diagonal());
  }
}

void quaternions_turn_as_eigens(void**) {
  Numbers n;
  for (int i = 0; i < 2000; ++i) {
    const Quat p = n.four(), q = n.four();
    const Vec3 a = n.three();
    assert_same(p * q, eigen(p) * eigen(q)), assert_same(p * a, eigen(p) * eigen(a));
    assert_same(p.matrix(), eigen(p).toRotationMatrix()), assert_same(p.conjugate(), eigen(p).conjugate());
    assert_same(p.squared_norm(), eigen(p).squaredNorm()), assert_same(p.normalized(), eigen(p).normalized());
    const Mat3 r = p.normalized().matrix();
    assert_same(Quat(r), Eigen::Quaterniond(eigen(r)));
  }
}

/// A scalar times a product is the product first, then the scalar. (Eigen scales the matrix first.)
void formulas_are_computed_as_they_are_written(void**) {
  Numbers n;
  for (int i = 0; i < 200; ++i) {
    const Mat3 m = n.nine();
    const Vec3 a = n.three(), product = m * a;
    const Real s = n.one();
    const Vec3 scaled = s * (m * a);
    for (int k = 0; k < 3; ++k) assert_true(scaled[k] == s * product[k]);
  }
}

void what_is_written_to_may_stand_in_the_formula(void**) {
  Numbers n;
  const Mat3 m = n.nine();
  const Vec3 a = n.three(), b = n.three();
  Vec3 x = a;
  x = m * x;
  assert_true(x == m * a);
  x = a, x += x.cross(b);
  assert_true(x == a + a.cross(b));
  Mat3 t = m;
  t = t.transpose();
  for (int i = 0; i < 3; ++i) assert_true(t.row(i) == m.col(i));
  Quat q(1, 2, 3, 4);
  q = q * q;
  assert_true(q == Quat(1, 2, 3, 4) * Quat(1, 2, 3, 4));
}

void zero_and_what_is_no_number_have_no_direction(void**) {
  assert_true(Vec3::zero().normalized() == Vec3::zero() && Quat::zero().normalized() == Quat::zero());
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  for (int i = 0; i < 3; ++i) {
    Vec3 v(1, 2, 3);
    v[i] = none;
    assert_false(v.all_finite() || finite(v) || v.all_within(Vec3::constant(9)) || v.all_below(Vec3::constant(9)));
    assert_false(v == v);
    assert_true(std::isnan(v.normalized()[i]));
  }
  assert_true(Vec3(1, 2, 3).all_within(Vec3(1, 2, 3)) && !Vec3(1, 2, 3).all_below(Vec3(1, 9, 9)));
  assert_true(Vec3(0, -0.0, 0).is_zero() && !Vec3(0, 0, 1e-300).is_zero());
}

/// Six numbers are two vectors: sums are those of the two.
void six_numbers_are_two_vectors(void**) {
  Numbers n;
  for (int i = 0; i < 200; ++i) {
    const Vec6 a(n.three(), n.three()), b(n.three(), n.three());
    Eigen::Matrix<double, 6, 1> ea, eb;
    ea << eigen(a.linear()), eigen(a.angular()), eb << eigen(b.linear()), eigen(b.angular());
    assert_same(a.dot(b), ea.dot(eb)), assert_same(a.squared_norm(), ea.squaredNorm());
    const Vec6 c = a - 0.5 * b;
    for (int k = 0; k < 6; ++k) assert_true(c[k] == a[k] - 0.5 * b[k]);
  }
}

void the_least_turn_takes_one_direction_to_another(void**) {
  Numbers n;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = n.three(), to = i % 10 ? n.three() : Vec3(-from + (i % 20 ? 1e-9 : 0) * n.three());
    const Quat q = turn_between(from, to);
    // Opposite within d rad: the middle of the two is known to 4 eps / d, and the turn is twice as far off.
    const Real d = (from.normalized() + to.normalized()).norm(), blur = 4 * kEpsilon / d;
    assert_true((q * from.normalized() - to.normalized()).norm() < 8 * kEpsilon + (d > 1e-8 ? 2 * blur : 1.01 * d));
    assert_true(std::fabs(q.norm() - 1) < 4 * kEpsilon);
    // The least: its axis is across both.
    if (d > 1e-3) assert_true(std::fabs(q.vec().dot(from.normalized())) < 8 * kEpsilon + blur);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(vectors_add_up_as_eigens),
      cmocka_unit_test(matrices_add_up_as_eigens),
      cmocka_unit_test(quaternions_turn_as_eigens),
      cmocka_unit_test(formulas_are_computed_as_they_are_written),
      cmocka_unit_test(what_is_written_to_may_stand_in_the_formula),
      cmocka_unit_test(zero_and_what_is_no_number_have_no_direction),
      cmocka_unit_test(six_numbers_are_two_vectors),
      cmocka_unit_test(the_least_turn_takes_one_direction_to_another),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

// Bodies that move and turn in lanes: whatever registers the machine has, the bits are those of one body at a time.
#include "carom_test.h"
#include "dynamics/integrate/rotation/split_turn.h"
#include "dynamics/integrate/turn_kernels.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr std::uint32_t kCount = 4;
constexpr Real kMost = 1e15;

/// Four bodies, and what becomes of them.
struct Four {
  Principal principal[kCount];
  Vec3 x[kCount], v[kCount], omega[kCount], momentum[kCount];
  Quat q[kCount];
  std::uint8_t turned[kCount];
  Vec3 turned_omega[kCount], to_x[kCount], to_momentum[kCount], to_omega[kCount], predicted_omega[kCount];
  Quat turned_q[kCount], to_q[kCount], predicted_q[kCount];

  Four(Random& random, Real fastest) {
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const auto vector = [&](Real most) { return Vec3(most * random.direction()); };
      const auto part = [&] { return random.uniform(0.5, 1.5); };
      const Mat3 inertia = Mat3::diagonal(Vec3(part(), part(), part())), r = exp_map(vector(2)).matrix();
      principal[i] = principal_axes(random.uniform(0, 1) < 0.7 ? inertia : Mat3(r * inertia * r.transpose()));
      x[i] = vector(10), v[i] = vector(3);
      omega[i] = vector(fastest * random.uniform(0, 1)), turned_omega[i] = omega[i] + vector(0.01);
      q[i] = exp_map(vector(2)), turned_q[i] = exp_map(vector(2));
      turned[i] = random.uniform(0, 1) < 0.5;
      const Principal& top = principal[i];
      const Quat at = top.sorted(q[i]);
      // Every other one has kept its momentum.
      momentum[i] = i % 2 ? Vec3(1, 2, 3) : top.unsorted(at * top.moment.times(at.conjugate() * top.sorted(omega[i])));
      clear(i);
    }
  }
  void clear(std::uint32_t i) {
    to_x[i] = to_momentum[i] = to_omega[i] = predicted_omega[i] = Vec3::zero();
    to_q[i] = predicted_q[i] = Quat::zero();
  }
  Motions motions() {
    return {x->data(),    v->data(),    q->data(), omega->data(), turned, turned_q->data(), turned_omega->data(),
            to_x->data(), to_q->data(), kMost};
  }
  Tops tops() {
    return {principal,
            q->data(),
            omega->data(),
            momentum->data(),
            to_momentum->data(),
            to_omega->data(),
            predicted_q->data(),
            predicted_omega->data(),
            kMomentumAgrees * kMomentumAgrees};
  }
  /// From where they were moved and turned to.
  Shifts shifts_from_there(double* to) const { return {x->data(), q->data(), to_x->data(), predicted_q->data(), to}; }
  bool is_moved(std::uint32_t i, Real h) const {
    const Vec3 turn = turned[i] ? Vec3(omega[i] - turned_omega[i]) : omega[i];
    return to_x[i] == x[i] + h * v[i] && to_q[i] == normalized(exp_map(h * turn) * (turned[i] ? turned_q[i] : q[i]));
  }
  bool is_split(std::uint32_t i, Real h) const {
    const Principal& top = principal[i];
    Quat at = top.sorted(q[i]);
    Vec3 l = top.sorted(momentum[i]), p = at.conjugate() * l;
    const Vec3 w = top.sorted(omega[i]), off = spin_of(top, at, l, p) - w;
    if (!(off.squared_norm() < kMomentumAgrees * kMomentumAgrees * w.squared_norm()))
      p = top.moment.times(at.conjugate() * w), l = at * p;
    turn_split(top, h, l, p, at, kOne);
    at = normalized(at);
    const Vec3 spin = top.unsorted(spin_of(top, at, l));
    return predicted_q[i] == top.unsorted(at) && predicted_omega[i] == spin && to_omega[i] == spin;
  }
  /// Of the four in their order.
  bool is_shifted(const std::uint32_t* body, const double* to) const {
    for (std::uint32_t k = 0; k < kCount; ++k, to += 8) {
      const Quat turn = q[body[k]] * predicted_q[k].conjugate();
      if (Vec3::from(to) != x[body[k]] - to_x[k] || Vec3::from(to + 3) != turn.vec() || to[6] != turn.w() || to[7] != 0)
        return false;
    }
    return true;
  }
  bool is_led(const std::uint32_t* body, const double* to, Real h) const {
    for (std::uint32_t k = 0; k < kCount; ++k, to += 10) {
      const std::uint32_t i = body[k];
      const Quat turn = exp_map(h * omega[i]);
      if (Vec3::from(to) != x[i] || Vec3::from(to + 3) != turn.vec() || to[6] != turn.w() ||
          Vec3::from(to + 7) != omega[i])
        return false;
    }
    return true;
  }
  bool is_untouched(std::uint32_t i) const {
    return to_x[i].is_zero() && to_q[i] == Quat::zero() && predicted_q[i] == Quat::zero() && to_momentum[i].is_zero() &&
           to_omega[i].is_zero() && predicted_omega[i].is_zero();
  }
};

constexpr std::uint32_t kBody[kCount] = {2, 0, 3, 1};
constexpr Real kStep = 1.0 / 240;

void every_width_gives_the_bits_of_one_body_at_a_time(void**) {
  for (const TurnKernels* kernels : all_turn_kernels()) {
    Random random(5);
    for (const Real fastest : {0.0, 0.1, 1.0, 10.0}) {  // rad/s: below and above where exp_map() changes its way
      for (int k = 0; k < 500; ++k) {
        Four four(random, fastest);
        assert_true(kernels->move(four.motions(), kBody, kStep));
        assert_true(kernels->split(four.tops(), kBody, kStep));
        for (std::uint32_t i = 0; i < kCount; ++i) assert_true(four.is_moved(i, kStep) && four.is_split(i, kStep));
        double to[10 * kCount];
        kernels->shift(four.shifts_from_there(to), kBody);
        assert_true(four.is_shifted(kBody, to));
        assert_true(kernels->lead({four.x->data(), four.omega->data(), to}, kBody, kStep));
        assert_true(four.is_led(kBody, to, kStep));
      }
    }
  }
}

void lanes_leave_what_they_are_not_for_and_write_nothing(void**) {
  for (const TurnKernels* kernels : all_turn_kernels()) {
    Random random(6);
    const auto is_left = [&](auto&& spoil, bool to_move, bool to_split) {
      Four four(random, 1);
      spoil(four);
      assert_int_equal(kernels->move(four.motions(), kBody, kStep), !to_move);
      if (!to_move)
        for (std::uint32_t i = 0; i < kCount; ++i) four.clear(i);
      assert_int_equal(kernels->split(four.tops(), kBody, kStep), !to_split);
      for (std::uint32_t i = 0; to_split && i < kCount; ++i) assert_true(four.is_untouched(i));
    };
    is_left([](Four& f) { f.omega[3] = Vec3(0, 900, 0), f.turned[3] = 0; }, true, true);
    is_left([](Four& f) { f.v[1] = Vec3(0, 0, 300e15); }, true, false);
    is_left([](Four& f) { f.omega[0] = Vec3(kInfinity, 0, 0), f.turned[0] = 0; }, true, true);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_width_gives_the_bits_of_one_body_at_a_time),
      cmocka_unit_test(lanes_leave_what_they_are_not_for_and_write_nothing),
  };
  return cmocka_run_group_tests_name("dynamics/turn_kernels", tests, nullptr, nullptr);
}

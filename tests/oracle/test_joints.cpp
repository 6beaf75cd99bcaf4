// Joints against closed forms: pendulums, springs, motors, limits, what a clamp bears, momentum.
#include "carom_test.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/wide_joints.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = 3.14159265358979323846;
constexpr Real kG = 9.81;

enum SolverChoice { kSequentialChoice = 1, kSoftChoice = 2, kDirectChoice = 3, kAutoChoice = 4 };

/// A body with mass and inertia of its own and no shape.
std::uint32_t add_body(TestWorld& t, const Vec3& at, Real mass, const Vec3& inertia, BodyType type = BodyType::dynamic) {
  BodyDef def;
  def.type = type;
  def.pose.p = at;
  def.has_mass = def.has_inertia = true;
  def.mass = mass;
  def.inertia = inertia.asDiagonal();
  return handle_slot(t.world.add_body(def));
}

/// A joint whose frames coincide at a place in the world.
std::uint32_t join(TestWorld& t, JointKind kind, std::uint32_t a, std::uint32_t b, const Vec3& at,
                   const Quat& axes = Quat::Identity()) {
  JointDef def;
  def.kind = kind;
  def.body_a = a, def.body_b = b;
  const Pose frame = {axes, at};
  const auto in = [&](std::uint32_t body) { return body == kTheWorld ? frame : t.world.pose(body).inverse() * frame; };
  def.frame_a = in(a), def.frame_b = in(b);
  return handle_slot(t.world.add_joint(def));
}

const Joint& joint(const TestWorld& t, std::uint32_t slot) { return t.world.joints.joint[slot]; }

/// Period of a pendulum of amplitude a: 4 K(sin a/2) / w0, by the arithmetic-geometric mean.
Real period(Real w0, Real amplitude) {
  Real a = 1, b = std::cos(amplitude / 2);
  for (int i = 0; i < 40; ++i) {
    const Real m = (a + b) / 2;
    b = std::sqrt(a * b), a = m;
  }
  return 2 * kPi / (w0 * a);
}

struct PendulumErrors {
  Real place, energy, gap;
};

/// A thin rod of 1 m and 1 kg hung by one end, let go from the horizontal; after one period it is there again.
PendulumErrors swing_rod(int solver, int substeps, int steps) {
  TestWorld t;
  t.world.set_dial(Dial::solver, solver);
  t.world.set_dial(Dial::substeps, substeps);
  const Real inertia = 1.0 / 12;
  const std::uint32_t rod = add_body(t, Vec3(0.5, 0, 0), 1, Vec3(inertia, inertia, inertia));
  join(t, JointKind::ball, kTheWorld, rod, Vec3::Zero());
  const Real w0 = std::sqrt(1 * kG * 0.5 / (inertia + 0.25)), all = period(w0, kPi / 2);
  PendulumErrors worst{0, 0, 0};
  for (int i = 0; i < steps; ++i) {
    t.world.step(all / steps);
    const Vec3& x = t.world.state.x[rod];
    const Real energy = kG * x.y() + 0.5 * t.world.state.v[rod].squaredNorm() +
                        0.5 * inertia * t.world.state.omega[rod].squaredNorm();
    worst.energy = std::max(worst.energy, std::fabs(energy) / (kG * 0.5));
    worst.gap = std::max(worst.gap, joint(t, 0).gap);
  }
  worst.place = (t.world.state.x[rod] - Vec3(0.5, 0, 0)).norm();
  return worst;
}

void a_pendulum(void**) {
  for (const int solver : {kSoftChoice, kSequentialChoice, kDirectChoice, kAutoChoice})
    for (const int substeps : {1, 2, 4, 8, 16}) {
      const PendulumErrors e = swing_rod(solver, substeps, 97);
      std::printf("solver %d, %2d substeps: place %.3e m, energy %.3e, gap %.3e m\n", solver, substeps, e.place, e.energy,
                  e.gap);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_pendulum),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

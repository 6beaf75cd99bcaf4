#include "dynamics/joint/speeds.h"

#include "dynamics/joint/parts.h"
#include "dynamics/joint/turns.h"

namespace carom::dynamics {
namespace {

constexpr Real kAgree = 1e-12;  // sine of an angle between axes below which it has no direction

/// Of a joint's end: its point and its body.
struct EndSpeed {
  Vec3 v, omega;  // m/s, rad/s, world
};

EndSpeed speed_of_end(const World& world, std::uint32_t body, const Vec3& arm) {
  if (body == kInvalid) return {Vec3::zero(), Vec3::zero()};
  const State& s = world.state;
  return {s.v[body] + s.omega[body].cross(arm), s.omega[body]};
}

/// Rate of the length of a vector.
Real lengthening(const Vec3& r, const Vec3& rate) {
  const Real length = r.norm();
  return length > 0 ? r.dot(rate) / length : rate.norm();
}

}  // namespace

JointSpeeds speeds_of(const World& world, const Joint& joint) {
  const JointDef& def = joint.def;
  const JointEnds ends = ends_of(world, def);
  const EndSpeed a = speed_of_end(world, def.body_a, ends.arm_a), b = speed_of_end(world, def.body_b, ends.arm_b);
  const Quat to_a = ends.a.q.conjugate(), t = to_a * ends.b.q;
  const Vec3 r = to_a * ends.apart, parting = b.v - a.v;
  const Vec3 place = to_a * parting - (to_a * a.omega).cross(r), w = to_a * (b.omega - a.omega);
  const Vec3 n = t * Vec3::unit_x(), n_rate = w.cross(n);
  const Real sine = std::sqrt(n.y() * n.y() + n.z() * n.z());
  Real swing = n_rate.norm();
  if (sine > kAgree) swing = n.x() * ((n.y() * n_rate.y() + n.z() * n_rate.z()) / sine) - sine * n_rate.x();
  const SwingPlane plane = joint.axes ? swing_plane(world.joints.axes_of(joint)) : SwingPlane::none;
  const bool swings = plane == SwingPlane::none && sine > kAgree;  // else nothing hangs on where it is
  const Vec3 turning = rates_of_angles(t, plane, swings ? counted_angles(world, joint, ends) : Vec3(Vec3::zero()), w);
  JointSpeeds speeds;
  speeds.coordinate = {turning.x(), swing, place.x(), lengthening(ends.apart, parting)};
  if (def.kind == JointKind::pulley) {
    const Ropes ropes = ropes_of(world, joint, ends);
    speeds.coordinate[3] = lengthening(ropes.a, a.v) + joint.transmission.ratio * lengthening(ropes.b, b.v);
  }
  speeds.axis = {place.x(), place.y(), place.z(), turning.x(), turning.y(), turning.z()};
  return speeds;
}

namespace {

/// f(slot)
template <class F>
void each_measured(const Joints& joints, F&& f) {
  for (std::uint32_t j = 0; j < joints.slots.slots(); ++j)
    if (joints.alive(j) && joints.joint[j].def.measured) f(j);
}

}  // namespace

void measure_rates(const World& world, Array<AxisRates>& rates) {
  rates.reserve(world.joints.measured);
  each_measured(world.joints, [&](std::uint32_t j) { rates.push_back(speeds_of(world, world.joints.joint[j]).axis); });
}

void note_accelerations(const World& world, const Array<AxisRates>& begun, Real dt, Joints& joints) {
  std::size_t i = 0;
  each_measured(joints, [&](std::uint32_t j) {
    const AxisRates now = speeds_of(world, joints.joint[j]).axis, &was = begun[i++];
    for (std::size_t k = 0; k < kAxes; ++k) {
      const Real rate = (now[k] - was[k]) / dt;
      joints.joint[j].acceleration[k] = finite(rate) ? rate : 0;
    }
  });
}

}  // namespace carom::dynamics

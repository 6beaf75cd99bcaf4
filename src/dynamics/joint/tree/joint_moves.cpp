// Joints moved by a host, and what hangs on them.
#include "dynamics/joint/tree/joint_moves.h"

#include <algorithm>
#include <cmath>

#include "core/wide_angle.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/speeds.h"
#include "dynamics/joint/turns.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {
namespace {

using Numbers = std::array<Real, kAxes>;

bool is_free(const World& world, const Joint& joint, std::uint32_t axis) {
  const auto of_kind = [&] {
    switch (joint.def.kind) {
      case JointKind::hinge:
        return axis == kPlaces;
      case JointKind::slider:
        return axis == 0;
      case JointKind::ball:
        return axis >= kPlaces;
      case JointKind::universal:
        return axis > kPlaces;  // its twist follows
      default:
        return true;
    }
  };
  return of_kind() && !world.joints.axes_of(joint).axis[axis].is_locked();
}

Numbers numbers_now(const World& world, const Joint& joint, bool speeds) {
  if (speeds) return speeds_of(world, joint).axis;
  const JointEnds ends = ends_of(world, joint.def);
  return axes_at(ends, counted_angles(world, joint, ends));
}

std::uint32_t root_of(Array<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}
bool join(Array<std::uint32_t>& parent, std::uint32_t a, std::uint32_t b) {
  a = root_of(parent, a), b = root_of(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
  return a != b;
}

Vec3 first(const Numbers& n) { return {n[0], n[1], n[2]}; }

/// rad/s, A's frame: of B relative to A, as its angles change.
Vec3 turning_of(const Numbers& at, const Numbers& rates) {
  return omega_of_angles({0, at[4], at[5]}, Vec3(rates[3], rates[4], rates[5]));
}

/// Of a universal joint, whose B is turned about A's y axis, then about its own z axis: the twist that goes with a swing, and
/// how fast where that changes. Alone where B's x axis lies along A's y, any twist does: then it is 0.
void twist_universal(Numbers& at, Numbers& rates) {
  const Quat swing = exp_map(Vec3(0, at[4], at[5]));
  const Vec3 x = swing * Vec3::unit_x();
  const Real across = std::sqrt(x.x() * x.x() + x.z() * x.z());
  const Quat pins = exp_map(Vec3(0, across > 0 ? angle_of<double>(-x.z(), x.x()) : Real(0), 0)) *
                    exp_map(Vec3(0, 0, angle_of<double>(x.y(), across)));
  const Quat twist = swing.conjugate() * pins;
  const Real sign = twist.w() < 0 ? -1 : 1;
  at[3] = 2 * angle_of<double>(sign * twist.x(), sign * twist.w());
  // Nothing turns about what is at right angles to both pins.
  const Vec3 locked = Vec3(0, 1, 0).cross(pins * Vec3(0, 0, 1));
  const Real by_twist = x.dot(locked);
  rates[3] = 0;
  if (by_twist != 0) rates[3] = -turning_of(at, rates).dot(locked) / by_twist;
}

}  // namespace

std::uint32_t JointMoves::node(const World& world, std::uint32_t body) const {
  return is_held(world, body) ? static_cast<std::uint32_t>(part_.size() - 1) : body;
}

void JointMoves::ask(const World& world, const JointMove& move) {
  const Joint& joint = world.joints.joint[move.joint];
  asked_.push_back({move, static_cast<std::uint32_t>(asked_.size())});
  Asked& asked = asked_.back();
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (!is_free(world, joint, k)) {
      const JointAxis& axis = world.joints.axes_of(joint).axis[k];
      asked.move.to[k] = axis.is_locked() ? axis.lower : 0;
    }
}

/// What is not moved, and what has no place to be moved along with.
void JointMoves::join_parts(const World& world) {
  const std::uint32_t bodies = world.scene.bodies.slots();
  part_.resize(bodies + 1), is_b_.assign(bodies, 0);
  for (std::uint32_t i = 0; i <= bodies; ++i) part_[i] = i;
  std::size_t next = 0;
  for (std::uint32_t j = 0; j < world.joints.slots.slots(); ++j) {
    const bool is_asked = next < asked_.size() && asked_[next].move.joint == j;
    next += is_asked;
    if (!world.joints.alive(j)) continue;
    const Joint& joint = world.joints.joint[j];
    if (joint.broken || joint.def.kind == JointKind::gear || is_coupling(joint.def.kind)) continue;
    if (joint.def.body_b != kInvalid) is_b_[joint.def.body_b] = 1;
    if (is_asked) continue;
    join(part_, node(world, joint.def.body_a), node(world, joint.def.body_b));
    if (joint.def.kind == JointKind::pulley) join(part_, node(world, joint.def.body_a), bodies);  // it hangs there
  }
  for (std::uint32_t i = 0; i <= bodies; ++i) part_[i] = root_of(part_, i);
}

MoveFault JointMoves::join_wholes(const World& world) {
  whole_ = part_;
  for (const Asked& asked : asked_) {
    const Joint& joint = world.joints.joint[asked.move.joint];
    const JointDef& def = joint.def;
    joint_at_fault_ = asked.move.joint;
    if (joint.broken) return MoveFault::broken;
    if (is_held(world, def.body_a) && is_held(world, def.body_b)) return MoveFault::held;
    if (!join(whole_, node(world, def.body_a), node(world, def.body_b))) return MoveFault::loop;
  }
  for (std::uint32_t i = 0; i < whole_.size(); ++i) whole_[i] = root_of(whole_, i);
  return MoveFault::none;
}

JointMoves::Body JointMoves::moved(const World& world, std::uint32_t body) const {
  const State& s = world.state;
  if (body == kInvalid) return {Vec3::zero(), Vec3::zero(), Vec3::zero(), Quat::identity()};
  const bool rests = is_held(world, body) && (world.scene.type[body] != BodyType::kinematic || s.held_out[body]);
  const Body was = rests ? Body{s.x[body], Vec3::zero(), Vec3::zero(), s.q[body]}
                         : Body{s.x[body], s.v[body], s.omega[body], s.q[body]};
  const PartMove& m = move_[part_[node(world, body)]];
  if (!m.moves || is_held(world, body)) return was;
  Body b = was;
  const Vec3 arm_was = was.x - m.from, arm = m.turn * arm_was;
  if (!speeds_) b.x = m.to + arm, b.q = normalized(m.turn * was.q);
  b.omega = m.omega + m.turn * (was.omega - m.omega_was);
  b.v = m.v + m.omega.cross(arm) + m.turn * (was.v - m.v_was - m.omega_was.cross(arm_was));
  return b;
}

/// Of the part that a joint holds to one which has been moved.
JointMoves::PartMove JointMoves::led(const World& world, const JointMove& asked, bool child_is_a) const {
  const Joint& joint = world.joints.joint[asked.joint];
  const JointDef& def = joint.def;
  const JointEnds ends = ends_of(world, def);
  const std::uint32_t child = child_is_a ? def.body_a : def.body_b, parent = child_is_a ? def.body_b : def.body_a;
  const Pose& frame = child_is_a ? def.frame_b : def.frame_a;
  const Body held = moved(world, parent);
  const Vec3 arm = parent == kInvalid ? Vec3(Vec3::zero()) : held.q * (frame.p - world.scene.center[parent]);
  const Pose at = parent == kInvalid ? frame : Pose{held.q * frame.q, held.x + arm};
  const Numbers now = numbers_now(world, joint, false), rates_now = numbers_now(world, joint, true);
  Numbers places = speeds_ ? now : asked.to;

  Vec3 turning;  // rad/s, A's frame
  Numbers rates = speeds_ ? asked.to : rates_now;
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (!is_free(world, joint, k)) rates[k] = 0;
  if (def.kind == JointKind::universal) twist_universal(places, rates);
  const bool any_way = is_free(world, joint, 3) && is_free(world, joint, 4) && is_free(world, joint, 5);
  if (any_way && !speeds_) {
    const auto spin = [&](std::uint32_t body) {
      return body == kInvalid ? Vec3(Vec3::zero()) : world.state.omega[body];
    };
    turning = ends.a.q.conjugate() * (spin(def.body_b) - spin(def.body_a));
  } else {
    turning = turning_of(places, rates);
  }

  PartMove m;
  m.moves = true;
  m.from = child_is_a ? ends.a.p : ends.b.p;
  const Body was = {world.state.x[child], world.state.v[child], world.state.omega[child], world.state.q[child]};
  m.omega_was = was.omega, m.v_was = was.v + was.omega.cross(m.from - was.x);
  Pose to_a, to_b;
  if (speeds_) {
    to_a = ends.a, to_b = ends.b, m.to = m.from;
  } else {
    const Quat turned = exp_map(Vec3(0, places[4], places[5])) * exp_map(Vec3(places[3], 0, 0));
    if (child_is_a) {
      to_b = at, to_a.q = to_b.q * turned.conjugate();
      to_a.p = to_b.p - to_a.q * first(places);
    } else {
      to_a = at, to_b = {to_a.q * turned, to_a.p + to_a.q * first(places)};
    }
    const Pose &was_at = child_is_a ? ends.a : ends.b, &to = child_is_a ? to_a : to_b;
    m.turn = normalized(to.q * was_at.q.conjugate()), m.to = to.p;
  }
  const Vec3 turns = to_a.q * turning, slides = to_a.q * first(rates);
  const auto of_parent = [&](const Vec3& point) { return held.v + held.omega.cross(point - held.x); };
  if (child_is_a) {  // what of A is where B's point is slides back from it
    m.omega = held.omega - turns;
    m.v = of_parent(to_b.p) - slides + m.omega.cross(to_a.p - to_b.p);
  } else {
    m.omega = held.omega + turns, m.v = of_parent(to_b.p) + slides;
  }
  return m;
}

bool JointMoves::fits(const World& world) const {
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) {
    if (!world.scene.bodies.alive(i) || is_held(world, i) || !move_[part_[i]].moves) continue;
    const Body b = moved(world, i);
    const bool sane = sane_position(b.x) && b.v.squared_norm() <= kMaxSpeed * kMaxSpeed &&
                      b.omega.squared_norm() <= kMaxSpin * kMaxSpin && b.q.all_finite();
    if (!sane) return false;
  }
  return true;
}

MoveFault JointMoves::find(const World& world, bool speeds) {
  speeds_ = speeds;
  std::ranges::sort(asked_, [](const Asked& a, const Asked& b) {
    return a.move.joint != b.move.joint ? a.move.joint < b.move.joint : a.order > b.order;
  });
  const auto same = [](const Asked& a, const Asked& b) { return a.move.joint == b.move.joint; };
  asked_.erase(std::unique(asked_.begin(), asked_.end(), same), asked_.end());
  std::erase_if(asked_, [&](const Asked& a) {  // is there already
    const Joint& joint = world.joints.joint[a.move.joint];
    const Numbers now = numbers_now(world, joint, speeds);
    for (std::uint32_t k = 0; k < kAxes; ++k)
      if (is_free(world, joint, k) && now[k] != a.move.to[k]) return false;
    return true;
  });
  if (asked_.empty()) return MoveFault::none;
  join_parts(world);
  if (const MoveFault fault = join_wholes(world); fault != MoveFault::none) return fault;

  // Where each whole begins: at the world, else at a body that is B of no joint, else at its first.
  const auto none = static_cast<std::uint32_t>(part_.size());
  Array<std::uint32_t> base(none, none, part_.get_allocator());  // by whole: a node
  base[whole_[none - 1]] = none - 1;
  for (const bool as_b : {false, true})
    for (std::uint32_t i = 0; i < none - 1; ++i)
      if (world.scene.bodies.alive(i) && base[whole_[i]] == none && is_b_[i] == as_b) base[whole_[i]] = i;
  move_.assign(part_.size(), PartMove());
  Array<std::uint8_t> reached(none, 0, is_b_.get_allocator());
  for (const Asked& asked : asked_) {
    const JointDef& def = world.joints.joint[asked.move.joint].def;
    reached[part_[base[whole_[node(world, def.body_a)]]]] = 1;
  }
  // Joints of each part, in a list.
  struct End {
    std::uint32_t part, asked;
    bool is_a;
  };
  Array<End> ends(asked_.get_allocator());
  for (std::uint32_t i = 0; i < asked_.size(); ++i) {
    const JointDef& def = world.joints.joint[asked_[i].move.joint].def;
    ends.push_back({part_[node(world, def.body_a)], i, true});
    ends.push_back({part_[node(world, def.body_b)], i, false});
  }
  std::ranges::sort(ends,
                    [](const End& a, const End& b) { return a.part != b.part ? a.part < b.part : a.asked < b.asked; });
  Array<std::uint32_t> wave(part_.get_allocator());
  for (std::uint32_t i = 0; i < none; ++i)
    if (reached[i]) wave.push_back(i);
  for (std::size_t at = 0; at < wave.size(); ++at) {
    const std::uint32_t part = wave[at];
    for (auto next = std::ranges::lower_bound(ends, part, {}, &End::part); next != ends.end() && next->part == part;
         ++next) {
      const End& end = *next;
      const JointDef& def = world.joints.joint[asked_[end.asked].move.joint].def;
      const std::uint32_t other = part_[node(world, end.is_a ? def.body_b : def.body_a)];
      if (reached[other]) continue;
      reached[other] = 1;
      move_[other] = led(world, asked_[end.asked].move, !end.is_a);
      wave.push_back(other);
    }
  }
  return fits(world) ? MoveFault::none : MoveFault::far;
}

}  // namespace carom::dynamics

// Bodies that joints hold together, as a tree.
#include "dynamics/joint/tree/joint_tree.h"

#include <algorithm>

#include "dynamics/body_state.h"

namespace carom::dynamics {
namespace {

/// All that turns a body's acceleration into force: of mass points at y from a place, the sums of m, m y and
/// m (y^2 - y y^T).
struct Composite {
  Real mass = 0;
  Vec3 first = Vec3::zero();
  Mat3 second = Mat3::zero();

  Vec3 force(const Vec3& acceleration, const Vec3& alpha) const { return mass * acceleration + alpha.cross(first); }
  Vec3 moment(const Vec3& acceleration, const Vec3& alpha) const { return second * alpha + first.cross(acceleration); }
  /// @param r  m, of the other's place beyond this one
  void add(const Composite& other, const Vec3& r) {
    const Vec3 both = 2 * other.first + other.mass * r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        second(i, j) += other.second(i, j) + (i == j ? r.dot(both) : 0) - r[i] * other.first[j] -
                        other.first[i] * r[j] - other.mass * r[i] * r[j];
    first += other.first + other.mass * r, mass += other.mass;
  }
};

/// Whether a host moves it.
bool is_driven(const World& world, std::uint32_t body) {
  return body != kInvalid && world.scene.type[body] == BodyType::kinematic && !world.state.held_out[body];
}

struct Speed {
  Vec3 v, omega;  // m/s, rad/s, world
};

void put(const Vec3& v, Real* to) { to[0] = v.x(), to[1] = v.y(), to[2] = v.z(); }

}  // namespace

/// Of a body, in an inertial frame; its velocity is not needed.
struct JointTree::Motion {
  Vec3 omega = Vec3::zero(), alpha = Vec3::zero();  // rad/s, rad/s^2
  Vec3 acceleration = Vec3::zero();                 // m/s^2, of its centre
};

TreeFault JointTree::find(const World& world, std::uint32_t body) {
  place_.assign(world.scene.bodies.slots(), kInvalid);
  if (is_held(world, body)) return TreeFault::not_moved;
  const TreeFault fault = walk(world, body);
  if (fault != TreeFault::none) return fault;
  if (held_ != kInvalid && held_ != body) {
    for (const Node& node : nodes_) place_[node.body] = kInvalid;
    walk(world, held_);
  }
  number(world);
  return TreeFault::none;
}

/// Breadth first from a body, by all joints that hold. The one that something holds is noted.
TreeFault JointTree::walk(const World& world, std::uint32_t root) {
  const auto add = [&](std::uint32_t body, std::uint32_t parent, std::uint32_t joint, bool child_is_a) {
    place_[body] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({body, parent, joint, kInvalid, child_is_a, 0, {}});
  };
  TreeFault fault = TreeFault::none;
  const auto fail = [&](TreeFault why, std::uint32_t& culprit, std::uint32_t slot) {
    if (fault == TreeFault::none) fault = why, culprit = slot;
  };
  held_ = kInvalid;
  nodes_.clear();
  add(root, kInvalid, kInvalid, false);
  for (std::uint32_t i = 0; i < nodes_.size() && fault == TreeFault::none; ++i) {
    const std::uint32_t body = nodes_[i].body, came_by = nodes_[i].joint;
    if (world.scene.locks_of(body) || !rotates(world.scene, body)) fail(TreeFault::locked, body_at_fault_, body);
    world.joints.each_of(body, [&](std::uint32_t slot, std::uint32_t other) {
      const Joint& joint = world.joints.joint[slot];
      if (joint.broken || is_coupling(joint.def.kind) || slot == came_by || fault != TreeFault::none) return;
      if (!has_freedom(joint.def.kind)) return fail(TreeFault::kind, joint_at_fault_, slot);
      const bool is_a = joint.def.body_a == body;
      if (!is_held(world, other)) {
        if (place_[other] != kInvalid) return fail(TreeFault::loop, joint_at_fault_, slot);
        return add(other, i, slot, !is_a);
      }
      if (held_ != kInvalid) return fail(TreeFault::loop, joint_at_fault_, slot);
      held_ = body;
      if (i == 0) nodes_[0].joint = slot, nodes_[0].support = other, nodes_[0].child_is_a = is_a;
    });
  }
  return fault;
}

/// Where each joint's speeds stand, and what they are.
void JointTree::number(const World& world) {
  Array<std::uint32_t> order(place_.get_allocator().resource());
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (!nodes_[i].is_base()) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return nodes_[a].joint < nodes_[b].joint; });
  size_ = nodes_[0].is_base() ? kAxes : 0;
  for (const std::uint32_t i : order) {
    Node& node = nodes_[i];
    node.freedom = freedom_of(world, world.joints.joint[node.joint]);
    node.first = size_, size_ += static_cast<std::size_t>(node.freedom.count);
  }
}

void JointTree::read_speeds(const World& world, Real* speeds) const {
  const Velocities& at = world.state;
  for (const Node& node : nodes_) {
    if (node.is_base()) {
      put(at.v[node.body], speeds), put(at.omega[node.body], speeds + 3);
      continue;
    }
    const JointDef& def = world.joints.joint[node.joint].def;
    const auto speed = [&](std::uint32_t body) {
      return body == kInvalid || (is_held(world, body) && !is_driven(world, body)) ? Speed{Vec3::zero(), Vec3::zero()}
                                                                                   : Speed{at.v[body], at.omega[body]};
    };
    const Speed a = speed(def.body_a), b = speed(def.body_b);
    const Vec3 parting = (b.v - a.v) + (b.omega.cross(node.freedom.from_b) - a.omega.cross(node.freedom.from_a));
    node.freedom.measure(parting, b.omega - a.omega, speeds + node.first);
  }
}

JointTree::Motion JointTree::held(const World& world, const Node& node) const {
  Motion at;
  if (is_driven(world, node.support)) at.omega = world.state.omega[node.support];
  return at;
}

/// @param from  of what holds it
/// @param rates  accelerations of its coordinates
JointTree::Motion JointTree::moved(const Node& node, const Motion& from, const Real* speeds, const Real* rates) const {
  const Freedom& f = node.freedom;
  const Real sign = node.child_is_a ? -1 : 1;
  Motion to;
  to.omega = from.omega + sign * f.turn(speeds);
  const Vec3 &omega_a = node.child_is_a ? to.omega : from.omega, &omega_b = node.child_is_a ? from.omega : to.omega;
  to.alpha = from.alpha + sign * (f.turn(rates) + f.turning_bias(omega_a, omega_b, speeds));
  const auto with_body = [](const Motion& m, const Vec3& r) {
    return m.alpha.cross(r) + m.omega.cross(m.omega.cross(r));
  };
  const Vec3 slides = f.move(rates) + 2 * omega_a.cross(f.move(speeds));
  // B's point as a point of B is where it is as one that slides on A.
  to.acceleration = from.acceleration + with_body(from, node.child_is_a ? f.from_b : f.from_a) + sign * slides -
                    with_body(to, node.child_is_a ? f.from_a : f.from_b);
  return to;
}

Real JointTree::armature_of(const World& world, const Node& node, int k) {
  return world.joints.axes_of(world.joints.joint[node.joint]).axis[node.freedom.axis[k]].armature;
}

void JointTree::find_forces(const World& world, const Real* speeds, const Real* accelerations, Real* forces) const {
  struct Load {
    Vec3 force, moment;  // N, N m about its centre: what its parent gives it
  };
  Memory* const memory = place_.get_allocator().resource();
  Array<Motion> motion(memory);
  Array<Load> load(memory);
  motion.reserve(nodes_.size()), load.reserve(nodes_.size());
  for (const Node& node : nodes_) {
    Motion at;
    if (node.is_base())
      at = {Vec3::from(speeds + 3), Vec3::from(accelerations + 3), Vec3::from(accelerations)};
    else
      at = moved(node, node.parent == kInvalid ? held(world, node) : motion[node.parent], speeds + node.first,
                 accelerations + node.first);
    motion.push_back(at);
    const Mat3 inertia = inertia_at(world.scene, node.body, world.state.q[node.body]);
    Vec3 acceleration = at.acceleration;
    if (!world.scene.modes.forbids(static_cast<std::size_t>(EffectId::gravity), node.body))
      acceleration -= world.scene.gravity_factor_of(node.body) * world.scene.gravity;
    load.push_back(
        {world.scene.mass[node.body] * acceleration, inertia * at.alpha + at.omega.cross(inertia * at.omega)});
  }
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    const Load& l = load[i];
    if (node.is_base()) {
      put(l.force, forces), put(l.moment, forces + 3);
      continue;
    }
    for (int k = 0; k < node.freedom.count; ++k)
      forces[node.first + static_cast<std::size_t>(k)] =
          work(node, k, l.force, l.moment) +
          armature_of(world, node, k) * accelerations[node.first + static_cast<std::size_t>(k)];
    if (node.parent == kInvalid) continue;
    Load& of_parent = load[node.parent];
    of_parent.force += l.force, of_parent.moment += l.moment + node.offset().cross(l.force);
  }
}

/// The rows of a column: what a force on a node and its moment about the node's centre ask of it and of what holds it.
void JointTree::add_column(std::size_t i, std::size_t column, Vec3 force, Vec3 moment, Real* mass) const {
  const auto set = [&](std::size_t row, Real value) {
    mass[row * size_ + column] = mass[column * size_ + row] = value;
  };
  for (;; i = nodes_[i].parent) {
    const Node& node = nodes_[i];
    if (node.is_base()) {
      for (std::size_t k = 0; k < 3; ++k) set(k, force[k]), set(3 + k, moment[k]);
      return;
    }
    for (int k = 0; k < node.freedom.count; ++k) {
      const std::size_t row = node.first + static_cast<std::size_t>(k);
      set(row, work(node, k, force, moment));
    }
    if (node.parent == kInvalid) return;
    moment += node.offset().cross(force);
  }
}

void JointTree::find_mass(const World& world, Real* mass) const {
  Array<Composite> all(place_.get_allocator().resource());
  all.reserve(nodes_.size());
  for (const Node& node : nodes_)
    all.push_back(
        {world.scene.mass[node.body], Vec3::zero(), inertia_at(world.scene, node.body, world.state.q[node.body])});
  std::fill(mass, mass + size_ * size_, Real(0));
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    const Composite& c = all[i];
    if (node.is_base()) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 along = Vec3::unit(k), none = Vec3::zero();
        add_column(i, static_cast<std::size_t>(k), c.force(along, none), c.moment(along, none), mass);
        add_column(i, static_cast<std::size_t>(3 + k), c.force(none, along), c.moment(none, along), mass);
      }
      continue;
    }
    for (int k = 0; k < node.freedom.count; ++k) {
      const Vec3 turning = node.freedom.turns(k) ? node.turning(k) : Vec3(Vec3::zero());
      add_column(i, node.first + static_cast<std::size_t>(k), c.force(node.moving(k), turning),
                 c.moment(node.moving(k), turning), mass);
      mass[(node.first + static_cast<std::size_t>(k)) * (size_ + 1)] += armature_of(world, node, k);
    }
    if (node.parent != kInvalid) all[node.parent].add(c, node.offset());
  }
}

}  // namespace carom::dynamics

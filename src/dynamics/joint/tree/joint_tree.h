// Bodies that joints hold together without a loop, as a tree: its coordinates, the forces that accelerations take, its
// mass matrix. It reads a world between steps. A step knows nothing of it.
//
// Coordinates are speeds: six of the base, where nothing holds the tree (the velocity of its centre of mass, then its
// angular velocity, both in world axes); then those of each joint (freedom.h), joints by ascending slot. What does not move
// by forces (the world, static, kinematic and disabled bodies) may hold one body of the tree.
// @source [Featherstone2008]: recursive Newton-Euler, composite rigid bodies; @oracle tests/oracle/test_joint_tree
#pragma once

#include "dynamics/joint/tree/freedom.h"

namespace carom::dynamics {

/// Why some bodies are no tree.
enum class TreeFault : std::uint8_t {
  none,
  not_moved,  // the body asked for is static, kinematic, disabled or in quarantine
  loop,       // a joint closes a loop, the world counted as one body
  kind,       // a joint couples what is no coordinate: a distance joint, a pulley, a gear
  locked      // a body has locked axes, or no inertia
};

class JointTree {
 public:
  explicit JointTree(Memory* m) : nodes_(m), place_(m) {}

  /// The tree that a body belongs to.
  TreeFault find(const World& world, std::uint32_t body);
  std::uint32_t joint_at_fault() const { return joint_at_fault_; }  // slot, of a loop or a kind
  std::uint32_t body_at_fault() const { return body_at_fault_; }    // slot, of locked axes

  std::size_t size() const { return size_; }  // coordinates

  struct Coordinate {
    std::uint32_t joint = kInvalid, body = 0;  // slots; kInvalid: of the base
    std::uint8_t axis = 0;
  };
  /// f(number, Coordinate)
  template <class F>
  void each_coordinate(F&& f) const {
    for (const Node& node : nodes_) {
      for (std::uint8_t k = 0; node.is_base() && k < kAxes; ++k) f(std::size_t(k), Coordinate{kInvalid, node.body, k});
      for (int k = 0; k < node.freedom.count; ++k)
        f(node.first + static_cast<std::size_t>(k), Coordinate{node.joint, node.body, node.freedom.axis[k]});
    }
  }

  /// The speeds that its bodies have now.   @param speeds out, [size()]
  void read_speeds(const World& world, Real* speeds) const;
  /// Inverse dynamics: what gives these accelerations, against gravity and inertia.
  ///   forces = M accelerations + what speeds and gravity ask
  /// @param speeds, accelerations  [size()]   @param forces  out, [size()] N and N m: those of a base about its centre
  /// @accuracy  1e-15 of the largest moment in the sum, times the bodies in a chain
  void find_forces(const World& world, const Real* speeds, const Real* accelerations, Real* forces) const;
  /// M, symmetric: v^T M v / 2 is the energy of motion.   @param mass out, [size()][size()] kg, kg m, kg m^2
  void find_mass(const World& world, Real* mass) const;

 private:
  struct Node {
    std::uint32_t body, parent;  // slot; number of the node that holds it, or kInvalid
    std::uint32_t joint;         // slot of what it hangs on, or kInvalid: a base
    std::uint32_t support;       // of the root: slot of what holds it, or kInvalid
    bool child_is_a;             // of the joint
    std::size_t first;           // number of its first coordinate
    Freedom freedom;

    bool is_base() const { return joint == kInvalid; }
    // Of the child, as a speed of one moves it: turning, rad/s, and its centre, m/s.
    Vec3 turning(int k) const { return child_is_a ? -freedom.way[k] : freedom.way[k]; }
    Vec3 moving(int k) const {
      return freedom.turns(k) ? (child_is_a ? freedom.from_a : freedom.from_b).cross(turning(k)) : turning(k);
    }
    /// m, from its parent's centre to its own.
    Vec3 offset() const { return child_is_a ? freedom.from_b - freedom.from_a : freedom.from_a - freedom.from_b; }
  };
  struct Motion;

  static Real work(const Node& node, int k, const Vec3& force, const Vec3& moment) {
    return node.moving(k).dot(force) + (node.freedom.turns(k) ? node.turning(k).dot(moment) : 0);
  }
  /// kg or kg m^2, of a rotor; where a joint turns several ways, about its axes as they stand in A.
  static Real armature_of(const World& world, const Node& node, int k);
  TreeFault walk(const World& world, std::uint32_t root);
  void number(const World& world);
  Motion held(const World& world, const Node& node) const;
  Motion moved(const Node& node, const Motion& from, const Real* speeds, const Real* rates) const;
  void add_column(std::size_t node, std::size_t column, Vec3 force, Vec3 moment, Real* mass) const;

  Array<Node> nodes_;           // parents first
  Array<std::uint32_t> place_;  // by body slot: its node, or kInvalid
  std::size_t size_ = 0;
  std::uint32_t held_ = kInvalid;  // slot of the body that something holds
  std::uint32_t joint_at_fault_ = kInvalid, body_at_fault_ = kInvalid;
};

}  // namespace carom::dynamics

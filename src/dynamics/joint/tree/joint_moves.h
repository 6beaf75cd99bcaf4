// A host says where joints are, or how fast they go: bodies are moved along with them. Between steps.
//
// A joint moves the side of it that nothing holds, and with it all that hangs on that side, as one part. What a host does
// not move is one part, too: bodies that other joints hold together, and all that the world holds. So a joint may be
// moved if taking it away leaves its bodies apart.
#pragma once

#include "dynamics/joint/tree/freedom.h"

namespace carom::dynamics {

/// What a host asks of one joint.
struct JointMove {
  std::uint32_t joint = 0;       // slot
  std::array<Real, kAxes> to{};  // m and rad, or their rates: where B's frame is in A's, @see axes_at()
};

enum class MoveFault : std::uint8_t {
  none,
  broken,  // it holds nothing
  held,    // neither of its bodies is moved by forces
  loop,    // other joints, or those asked for together, hold its bodies together, too
  far      // a body would be out of the finite world, or too fast for it
};

class JointMoves {
 public:
  explicit JointMoves(Memory* m) : asked_(m), part_(m), whole_(m), is_b_(m), move_(m) {}

  /// Of one joint asked for twice the last counts. Numbers along what the joint locks are not read.
  void ask(const World& world, const JointMove& move);
  /// Find what follows; nothing changes yet.
  /// @param speeds  `to` are rates; else places. Where places change, rates stay
  MoveFault find(const World& world, bool speeds);
  std::uint32_t joint_at_fault() const { return joint_at_fault_; }  // slot
  /// What that moves. f(body, pose, velocity of its centre, omega, whether its pose changes)
  template <class F>
  void each_body(const World& world, F&& f) const {
    if (asked_.empty()) return;
    for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) {
      if (!world.scene.bodies.alive(i) || is_held(world, i) || !move_[part_[i]].moves) continue;
      const Body b = moved(world, i);
      f(i, Pose{b.q, b.x - b.q * world.scene.center[i]}, b.v, b.omega, !speeds_);
    }
  }
  /// f(joint, its angles, whole turns counted), where places change.
  template <class F>
  void each_count(F&& f) const {
    for (const Asked& a : asked_)
      if (!speeds_) f(a.move.joint, Vec3(a.move.to[3], a.move.to[4], a.move.to[5]));
  }

  /// Whether a kind can be moved so.
  static bool can_move(JointKind kind) {
    return kind == JointKind::hinge || kind == JointKind::slider || kind == JointKind::ball ||
           kind == JointKind::universal || kind == JointKind::six_axis;
  }

 private:
  struct Asked {
    JointMove move;
    std::uint32_t order;
  };
  /// How a part is moved: places from -> to, turned; then it goes on as its velocities were, beyond those at `from`.
  struct PartMove {
    bool moves = false;
    Quat turn = Quat::identity();
    Vec3 from, to;          // m
    Vec3 v_was, omega_was;  // m/s, rad/s, of a body of it at `from`
    Vec3 v = Vec3::zero(), omega = Vec3::zero();
  };
  struct Body {
    Vec3 x, v, omega;
    Quat q;
  };
  std::uint32_t node(const World& world, std::uint32_t body) const;
  void join_parts(const World& world);
  MoveFault join_wholes(const World& world);
  Body moved(const World& world, std::uint32_t body) const;
  PartMove led(const World& world, const JointMove& asked, bool child_is_a) const;
  bool fits(const World& world) const;

  Array<Asked> asked_;
  Array<std::uint32_t> part_, whole_;  // by node: bodies by slot, then the world; what they are joined to
  Array<std::uint8_t> is_b_;           // by body: of some joint
  Array<PartMove> move_;               // by node, of parts
  bool speeds_ = false;
  std::uint32_t joint_at_fault_ = kInvalid;
};

}  // namespace carom::dynamics

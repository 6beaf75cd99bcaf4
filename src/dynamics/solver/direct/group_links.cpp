// Rows of joints in the direct solver's groups.
#include "dynamics/solver/direct/group_links.h"

#include <algorithm>
#include <array>

#include "dynamics/force/force.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/fill_lanes.h"

namespace carom::dynamics {
namespace {

// Of f r h^2 / 2 over an inertia, beyond which a body is stiffened: f r h^2 < 4 I is where turns across a force hold.
constexpr Real kSwing = 2;
constexpr std::uint32_t kLeastLocks = 3;  // of a joint of a forest: fewer leave so much free that a row costs less
constexpr Real kNowhere = 1e30;           // m/s or rad/s, where nothing gets
constexpr Real kLeastDrag = 1e-9;         // of a spring: with less its give is beyond measure

/// One lane alone: groups that share lanes are solved by several threads.
Real& at(Lanes& to, std::uint32_t lane) { return reinterpret_cast<Real*>(&to)[lane]; }
void add(LaneVec& to, std::uint32_t lane, const Vec3& v) {
  at(to.x, lane) += v.x(), at(to.y, lane) += v.y(), at(to.z, lane) += v.z();
}

const JointRowLanes& row_at(const WideJoints& w, const DirectGroups::LinkRow& r) {
  return r.is_drive ? w.drives[r.row].row : w.rows[r.row];
}
JointRowLanes& row_at(WideJoints& w, const DirectGroups::LinkRow& r) {
  return r.is_drive ? w.drives[r.row].row : w.rows[r.row];
}

bool is_rotor(const DirectGroups::LinkRow& r) { return r.is_drive && r.kind == DriveKind::rotor; }

void lock(ConeLink& c, Real at) { c.low = c.high = at, c.give = 0, c.most = kInfinity; }
void leave(ConeLink& c) { c.low = c.high = 0, c.give = 0, c.most = 0; }

Real drag_of(const JointDriveLanes& drive, std::uint32_t lane) { return std::max(get(drive.drag, lane), kLeastDrag); }
/// 1/kg or 1/(kg m^2), of what is pulled and dragged.
Real give_of(const JointDriveLanes& drive, std::uint32_t lane) {
  const Real drag = drag_of(drive, lane);
  return (1 - drag) / (drag * get(drive.m, lane));
}

/// What is asked of a limit, a motor, a spring, a rotor.
/// @param most    m or rad, of an error that is undone
/// @param halved  half of the loads come after the move, so half of what motors do
void ask(ConeLink& c, const JointDriveLanes& drive, const DirectGroups::LinkRow& row, LinkPhase phase, Real h,
         Real most, bool halved) {
  const Real x = get(drive.row.error, row.lane);
  switch (row.kind) {
    case DriveKind::limit: {
      const Real above = x - get(drive.lower, row.lane), below = get(drive.upper, row.lane) - x;
      c.give = 0, c.most = kInfinity;
      if (phase == LinkPhase::part)
        c.low = std::min(-above, most), c.high = std::max(below, -most);
      else
        c.low = above > 0 ? -above / h : 0, c.high = below > 0 ? below / h : 0;
      return;
    }
    case DriveKind::pace:
      if (phase == LinkPhase::part) return leave(c);
      c.low = get(drive.lower, row.lane) / h, c.high = get(drive.upper, row.lane) / h;
      c.give = 0, c.most = kInfinity;
      return;
    case DriveKind::motor:
      if (phase != LinkPhase::move && !halved) return leave(c);
      lock(c, get(drive.speed, row.lane));
      c.most = (halved ? 0.5 : 1) * get(drive.max_impulse, row.lane);
      return;
    case DriveKind::rotor:
      if (phase == LinkPhase::part) return leave(c);
      lock(c, get(drive.speed, row.lane));
      c.give = give_of(drive, row.lane);
      return;
    case DriveKind::spring: {
      const Real m = get(drive.m, row.lane), pull = get(drive.pull, row.lane);
      if (phase != LinkPhase::move || !(m > 0) || !(pull > 0 || get(drive.drag, row.lane) > 0)) return leave(c);
      const Real drag = drag_of(drive, row.lane);
      lock(c, get(drive.speed, row.lane) - (pull / drag) * (x - get(drive.lower, row.lane)));
      c.give = give_of(drive, row.lane);
      c.most = get(drive.max_impulse, row.lane);
      return;
    }
    case DriveKind::stop: {
      const Real m = get(drive.m, row.lane), pull = get(drive.pull, row.lane);
      const Real above = x - get(drive.lower, row.lane), below = get(drive.upper, row.lane) - x;
      if (phase != LinkPhase::move || !(m > 0) || (above >= 0 && below >= 0)) return leave(c);
      const Real drag = drag_of(drive, row.lane);
      c.low = above < 0 ? -(pull / drag) * above : -kNowhere;
      c.high = below < 0 ? (pull / drag) * below : kNowhere;
      c.give = give_of(drive, row.lane);
      c.most = kInfinity;
    }
  }
}

/// Arms of rows are those of a substep's beginning. So a drive leads what hangs on an arm no faster than rows follow: else
/// it leaves its joint, and the gap throws it. What moves along its joints knows no such bound. What gives way leads its
/// bodies, were they alone, to a share of what is asked: to k / (k + give) of it.
void lead_no_farther(ConeLink& c, Real h) {
  const Real most = kBends / h * (c.k > 0 ? (c.k + c.give) / c.k : 1);
  if (c.most > 0 && c.low == c.high) c.low = c.high = std::clamp(c.low, -most, most);
}

/// m, the longer of a joint's arms across an axis that moves with a body.
Real arm_across(const ConeLink& c, const JointLanes& joint, std::uint32_t lane) {
  const auto across = [](std::uint32_t body, const Vec3& arm, const Vec3& axis) {
    return body == kInvalid ? Real(0) : (arm - arm.dot(axis) * axis).norm();
  };
  return std::max(across(c.a, get(joint.r_a, lane), c.w_a), across(c.b, get(joint.r_b, lane), c.w_b));
}

/// 1/kg or 1/(kg m^2); 0 where locks leave but rounding.
Real locked_response(const ConeBody& b, const Vec3& d, const Vec3& turn) {
  constexpr Real kRounding = 1e-9;
  const Real moves = b.inv_mass * free_axes(b.locks).times(d).squared_norm(), turns = turn.dot(b.inv_inertia * turn);
  const Real whole = b.inv_mass * d.squared_norm() + b.inv_inertia.trace() * turn.squared_norm();
  return moves + turns > kRounding * whole ? moves + turns : 0;
}

/// The row of a coupling, from the bodies of the problem that it acts on: the first two are A and B.
void load_coupling(const World& world, ConeProblem& problem, const CoupledRow& from, LinkMore& more, ConeLink& c) {
  const BodyVelocity* const velocity = world.wide->velocity.data();
  std::uint32_t met = 0;
  c.surface = c.k = 0;
  c.d_a = c.d_b = c.w_a = c.w_b = Vec3::zero();
  for (const CoupledBody& b : from.ends()) {
    if (!b.moves) {
      const BodyVelocity& v = velocity[b.solver];
      c.surface += b.d.dot(Vec3(v.v[0], v.v[1], v.v[2])) + b.w.dot(Vec3(v.omega[0], v.omega[1], v.omega[2]));
      continue;
    }
    const Vec3 w = rotates(world.scene, b.body) ? b.w : Vec3(Vec3::zero());
    const std::uint32_t k = met++;
    const std::uint32_t body = k == 0 ? c.a : k == 1 ? c.b : more.body[k - 2];
    if (k == 0)
      c.d_a = -b.d, c.w_a = -w;
    else if (k == 1)
      c.d_b = b.d, c.w_b = w;
    else
      more.d[k - 2] = b.d, more.w[k - 2] = w;
    const ConeBody& own = problem.bodies[body];
    c.k += own.locks ? locked_response(own, b.d, w) : response_of(own, b.d, w);
  }
  c.more = met > 2 ? &more : nullptr;
}

}  // namespace

namespace {

/// Whether a joint may be one of a forest: it locks enough to be worth it, of bodies that impulses move as they like.
bool may_be_of_forest(const World& world, const Link& link, const JointLanes& joint) {
  const auto is_free = [&](bool moves, std::uint32_t body) {
    return !moves || (rotates(world.scene, body) && world.scene.locks_of(body) == 0);
  };
  return joint.layout.equalities >= kLeastLocks && is_free(link.moves_a, link.a) && is_free(link.moves_b, link.b);
}

/// Of a tree that is being joined: bodies of the group, from 1 on; 0 is what impulses do not move.
class Roots {
 public:
  Roots(Array<std::uint32_t>& root, std::uint32_t first, std::uint32_t bodies) : root_(root), first_(first) {
    root_.resize(bodies + 1);
    for (std::uint32_t i = 0; i <= bodies; ++i) root_[i] = i;
  }
  /// @return whether the two were not yet of one tree
  bool join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    root_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::uint32_t root(std::uint32_t body) {
    std::uint32_t i = body == kInvalid ? 0 : body - first_ + 1;
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  Array<std::uint32_t>& root_;
  std::uint32_t first_;
};

}  // namespace

void gather_links(const World& world, DirectGroups& d, std::size_t group) {
  const Contacts& c = *world.contacts;
  WideJoints& w = *world.wide_joints;
  DirectGroups::Begin& begin = d.begin.back();
  if (c.group_link_begin.empty()) return;
  const std::span<const std::uint32_t> joints(c.group_links.data() + c.group_link_begin[group],
                                              c.group_link_begin[group + 1] - c.group_link_begin[group]);
  const auto lanes_of = [&](std::uint32_t i) -> const JointLanes& { return w.joints[w.place[i].lanes]; };
  const auto add_rows = [&](std::uint32_t i, std::uint32_t first, std::uint32_t count, bool drives) {
    const Link& link = c.links[i];
    const WideJoints::Place& place = w.place[i];
    for (std::uint32_t r = 0; r < count; ++r) {
      ConeLink& to = d.links.emplace_back();
      to.a = d.node(link.moves_a, link.a), to.b = d.node(link.moves_b, link.b);
      d.link_row.push_back(
          {first + r, place.lane, place.lanes, drives, drives ? lanes_of(i).layout.drive[r].kind : DriveKind::limit});
    }
  };
  // All bodies of a coupling are of the group: its joints are.
  const auto add_coupling = [&](std::uint32_t i) {
    d.forest().more.resize(w.coupled().size());
    const auto at = static_cast<std::uint32_t>(&coupled_at(w, i) - w.coupled().data());
    d.link_row.push_back({at, w.place[i].lane, w.place[i].lanes, false, DriveKind::limit, true});
    ConeLink& to = d.links.emplace_back();
    LinkMore& more = d.forest().more[at];
    more = {};
    std::array<std::uint32_t, CoupledRow::kMostBodies> nodes;
    std::uint32_t count = 0;
    for (const CoupledBody& b : w.coupled()[at].ends())
      if (b.moves) nodes[count++] = d.node(true, b.body);
    to.a = count > 0 ? nodes[0] : kInvalid, to.b = count > 1 ? nodes[1] : kInvalid;
    for (std::uint32_t k = 2; k < count; ++k) more.body[k - 2] = nodes[k];
    for (std::uint32_t k = 0; k < count; ++k)
      for (std::uint32_t l = 0; l < k; ++l) d.elimination.scratch().edges.push_back({nodes[l], nodes[k]});
  };
  for (const std::uint32_t i : joints)
    d.node(c.links[i].moves_a, c.links[i].a), d.node(c.links[i].moves_b, c.links[i].b);
  // What locks most is of the forest first: fewer rows are left.
  Roots roots(d.forest().root, begin.body, static_cast<std::uint32_t>(d.bodies.size()) - begin.body);
  Array<std::uint32_t>& of_forest = d.elimination.scratch().member;
  of_forest.clear();
  for (std::uint32_t locks = kDof; locks >= kLeastLocks; --locks)
    for (const std::uint32_t i : joints) {
      const Link& link = c.links[i];
      if (lanes_of(i).layout.equalities == locks && may_be_of_forest(world, link, lanes_of(i)) &&
          roots.join(d.node(link.moves_a, link.a), d.node(link.moves_b, link.b)))
        of_forest.push_back(i);
    }
  std::ranges::sort(of_forest);
  const bool without_drives = d.rest.back().in_lanes;
  for (const std::uint32_t i : joints) {
    const JointLanes& joint = lanes_of(i);
    const Link& link = c.links[i];
    const bool is_of_forest = std::ranges::binary_search(of_forest, i);
    if (world.joints.joint[w.active[i]].coupling) {
      add_coupling(i);
      continue;
    }
    if (!is_of_forest) {
      add_rows(i, joint.first, joint.layout.equalities, false);
      const std::uint32_t a = d.node(link.moves_a, link.a), b = d.node(link.moves_b, link.b);
      if (a != kInvalid && b != kInvalid) d.elimination.scratch().edges.push_back({a, b});
    } else {
      d.forest().joints.push_back({.a = d.node(link.moves_a, link.a),
                                   .b = d.node(link.moves_b, link.b),
                                   .first_row = 0,
                                   .rows = joint.layout.equalities,
                                   .first_drive = static_cast<std::uint32_t>(d.links.size()) - begin.link,
                                   .drives = without_drives ? 0 : joint.layout.drives});
    }
    if (!without_drives) add_rows(i, joint.first_drive, joint.layout.drives, true);
  }
  begin.lock = static_cast<std::uint32_t>(d.links.size());
  TreeJoint* of = d.forest().joints.data() + begin.forest;
  for (const std::uint32_t i : joints) {
    if (!std::ranges::binary_search(of_forest, i)) continue;
    of++->first_row = static_cast<std::uint32_t>(d.links.size()) - begin.lock;
    add_rows(i, lanes_of(i).first, lanes_of(i).layout.equalities, false);
  }
}

void load_links(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, LinkPhase phase, Real h,
                Real most) {
  const WideJoints& w = *world.wide_joints;
  const BodyVelocity* const velocity = world.wide->velocity.data();
  // A lock asks for the bend of its arm where nothing else bears it. In contact that target gives energy: a taut chain
  // under loads feeds itself.
  const bool bends = phase == LinkPhase::move && problem.contacts.empty();
  const bool is_far = rattle::is_given_up(world, problem.bodies[problem.first].slot);
  const bool halved = phase != LinkPhase::part && is_kicked(w, problem.bodies[problem.first].slot);
  for (std::size_t i = 0; i < problem.joint_rows().size(); ++i) {
    ConeLink& c = problem.joint_rows()[i];
    const DirectGroups::LinkRow& at_row = rows[i];
    if (at_row.is_coupling) {
      const CoupledRow& from = w.coupled()[at_row.row];
      load_coupling(world, problem, from, world.direct->forest().more[at_row.row], c);
      if (phase == LinkPhase::part) c.surface = 0;
      c.p = c.start_p = phase == LinkPhase::move ? from.p : 0;
      lock(c, phase == LinkPhase::part ? std::clamp(-from.error, -most, most) : bends ? -from.curve : 0);
      c.bends = bends;
      continue;
    }
    const JointRowLanes& row = row_at(w, at_row);
    const JointLanes& joint = w.joints[at_row.joint];
    const std::uint32_t lane = at_row.lane;
    const auto turns = [&](std::uint32_t body) {
      return body != kInvalid && rotates(world.scene, problem.bodies[body].slot);
    };
    const Vec3 w_a = get(row.w_a, lane), w_b = get(row.w_b, lane);
    c.d_a = get(pull_at_a(w, joint, row), lane), c.d_b = get(row.d, lane);
    c.w_a = turns(c.a) ? w_a : Vec3::zero();
    c.w_b = turns(c.b) ? w_b : Vec3::zero();
    // Whom impulses do not move: a kinematic body, or solver body 0, whose velocities are 0.
    const auto of = [&](std::uint32_t solver_body, const Vec3& d, const Vec3& turn) {
      const BodyVelocity& v = velocity[solver_body];
      return d.dot(Vec3(v.v[0], v.v[1], v.v[2])) + turn.dot(Vec3(v.omega[0], v.omega[1], v.omega[2]));
    };
    c.surface = 0;
    if (phase != LinkPhase::part)
      c.surface =
          (c.b == kInvalid ? of(joint.b[lane], c.d_b, w_b) : 0) - (c.a == kInvalid ? of(joint.a[lane], c.d_a, w_a) : 0);
    const auto response = [&](std::uint32_t body, const Vec3& d, const Vec3& turn) {
      if (body == kInvalid) return Real(0);
      const ConeBody& b = problem.bodies[body];
      if (b.locks) return locked_response(b, d, turn);
      return response_of(b, d, turn);
    };
    const bool is_of_forest = i >= problem.links.size();
    c.k = is_of_forest ? 1
                       : response(c.a, c.d_a, c.w_a) + response(c.b, c.d_b, c.w_b);  // locks there hold, whatever it is
    c.bends = false, c.curve = 0;
    c.p = c.start_p = phase == LinkPhase::move ? get(row.p, lane) : 0;
    if (at_row.is_drive)
      ask(c, w.drives[at_row.row], at_row, phase, h, most, halved);
    else if (phase == LinkPhase::part)
      lock(c, std::clamp(-get(row.error, lane), -most, most));
    else
      c.curve = phase == LinkPhase::move ? get(row.curve, lane) : 0, lock(c, bends ? -c.curve : 0), c.bends = bends;
    const bool leads =
        at_row.is_drive && phase == LinkPhase::move && c.d_b == Vec3::zero() &&
        (at_row.kind == DriveKind::spring ? is_far || !bends : at_row.kind == DriveKind::motor && is_far);
    if (leads && arm_across(c, joint, lane) > world.scene.dials[Dial::position_tolerance]) lead_no_farther(c, h);
  }
}

namespace {

/// ConeBody::swing: force, arm and h^2 of each joint, across the arm.
/// @param impulses  (first row of a joint, one past its last) -> N s, on A and on B
template <class F>
void find_swings(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h, F&& impulses) {
  const WideJoints& w = *world.wide_joints;
  for (ConeBody& b : bodies_of(problem)) b.swing.set_zero();
  const auto add_to = [&](std::uint32_t body, const Vec3& r, Real force) {
    const Real r2 = r.squared_norm();
    if (body == kInvalid || !(r2 > 0) || !rotates(world.scene, problem.bodies[body].slot)) return;
    const Real r1 = std::sqrt(r2);
    problem.bodies[body].swing += (force * r1) * (Mat3::identity() - outer(r, r) / r2);
  };
  for (std::size_t i = 0, next; i < problem.joint_rows().size(); i = next) {
    const JointLanes& joint = w.joints[rows[i].joint];
    const std::uint32_t lane = rows[i].lane;
    for (next = i + 1;
         next < problem.joint_rows().size() && rows[next].joint == rows[i].joint && rows[next].lane == lane;)
      ++next;
    const auto [p_a, p_b] = impulses(i, next);
    // Half of the load comes after the move.
    add_to(problem.joint_rows()[i].a, get(joint.r_a, lane), 2 * p_a * h);
    add_to(problem.joint_rows()[i].b, get(joint.r_b, lane), 2 * p_b * h);
  }
}

/// Of rows of one joint.   @param impulse  (row of the problem) -> N s   @return N s, on A and on B
template <class F>
std::pair<Real, Real> sum_of(const WideJoints& w, const DirectGroups::LinkRow* rows, std::size_t first,
                             std::size_t last, F&& impulse) {
  Vec3 p_a = Vec3::zero(), p_b = Vec3::zero();
  for (std::size_t i = first; i < last; ++i) {
    if (rows[i].is_coupling) continue;  // it is told what its joints bear
    const JointRowLanes& row = row_at(w, rows[i]);
    const Real p = impulse(i, row);
    p_a += p * get(pull_at_a(w, w.joints[rows[i].joint], row), rows[i].lane);
    p_b += p * get(row.d, rows[i].lane);
  }
  return {p_a.norm(), p_b.norm()};
}

}  // namespace

bool is_jerked(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h) {
  find_swings(world, problem, rows, h, [&](std::size_t first, std::size_t last) {
    return sum_of(*world.wide_joints, rows, first, last,
                  [&](std::size_t i, const JointRowLanes&) { return problem.joint_rows()[i].p; });
  });
  return std::ranges::any_of(bodies_of(problem), [](const ConeBody& b) {
    return b.swing.trace() / 4 > 2 * b.inertia.trace() / 3;  // as it is now, stiffer perhaps
  });
}

void stiffen(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h, Borne borne) {
  const WideJoints& w = *world.wide_joints;
  find_swings(world, problem, rows, h, [&](std::size_t first, std::size_t last) {
    if (borne == Borne::in_substep)
      return sum_of(w, rows, first, last,
                    [&](std::size_t i, const JointRowLanes& row) { return get(row.p, rows[i].lane); });
    const std::uint32_t index = w.occupant[std::size_t{rows[first].joint} * kLanes + rows[first].lane];
    const Real p = h * world.joints.joint[w.active[index]].force.norm();
    return std::pair(p, p);
  });
  for (ConeBody& b : bodies_of(problem)) {
    const Real needed = b.swing.trace() / 4, own = b.inertia.trace() / 3;
    if (!(needed > kSwing * own)) continue;
    const Vec3 momentum = b.inertia * b.v.angular();
    b.inertia += (0.5 * (1 - kSwing * own / needed)) * b.swing;
    b.inv_inertia = b.locks & kAngularLocks ? inverse_of_free(b.inertia, b.locks) : b.inertia.inverse();
    b.v.set_angular(b.inv_inertia * momentum);
  }
}

namespace {

/// Whether a row of a joint is of a place along an axis of A, at which B's point stays.
bool holds_place(const JointLayout& layout, std::uint32_t row) {
  for (std::uint32_t k = 0, next = 0; k < layout.parts; ++k) {
    const JointPart part = layout.part[k];
    if ((next += rows_of(part)) <= row) continue;
    return part == JointPart::line || part == JointPart::place_x || part == JointPart::place_y ||
           part == JointPart::place_z;
  }
  return false;
}

}  // namespace

// A row's error d.g, of which d turns with A, bends by h/2 of its second derivative and h^2/6 of its third, in velocity. A rail takes
// in what slides along it by 2 d'.g' in the former and 3 d'.g'' + d.g''' in the latter, where g'' is by how much more B's point is
// flung outwards. Lanes have the former, by velocities of which rails have not had their share yet, and less of it the farther
// bodies turn.
void bend_as_gripped(const World& world, ConeProblem& problem, const DirectGroups::LinkRow* rows, Real h) {
  const WideJoints& w = *world.wide_joints;
  const DirectGroups::LinkRow* const row = rows + problem.links.size();
  for (std::size_t i = 0, next; i < problem.locks.size(); i = next) {
    const JointLanes& joint = w.joints[row[i].joint];
    const std::uint32_t lane = row[i].lane;
    const auto holds = [&](std::size_t k) { return holds_place(joint.layout, row[k].row - joint.first); };
    const auto velocity = [&](std::uint32_t solver_body) {
      const BodyVelocity& v = world.wide->velocity[solver_body];
      return Vec6{Vec3(v.v[0], v.v[1], v.v[2]), Vec3(v.omega[0], v.omega[1], v.omega[2])};
    };
    const Vec6 a = velocity(joint.a[lane]), b = velocity(joint.b[lane]);
    const Vec3 w_a = a.angular(), w_b = b.angular(), r_a = get(joint.r_a, lane), r_b = get(joint.r_b, lane);
    const Quat turn_a = exp_map(h * w_a), turn_b = exp_map(h * w_b);
    const Vec3 v = b.linear() - a.linear(), parts = v + w_b.cross(r_b) - w_a.cross(r_a);
    const Vec3 parted = turn_a * Vec3(v + w_b.cross(turn_b.conjugate() * r_b) - w_a.cross(turn_a.conjugate() * r_a));
    const Vec3 flung = w_b.cross(w_b.cross(r_b)) - w_a.cross(w_a.cross(r_a));
    Vec3 slides = parted - parts + h / 3 * flung;
    for (next = i; next < problem.locks.size() && row[next].joint == row[i].joint && row[next].lane == lane; ++next)
      if (holds(next)) slides -= problem.locks[next].d_b.dot(slides) * problem.locks[next].d_b;
    const Real whole = 1 + h * h / 4 * (w_a.squared_norm() + w_b.squared_norm());
    for (std::size_t k = i; k < next; ++k) {
      ConeLink& lock = problem.locks[k];
      lock.curve *= whole;
      if (holds(k)) lock.curve += h * w_a.cross(lock.d_b).dot(slides);
    }
  }
}

void measure_links(ConeProblem& problem) {
  for (ConeLink& c : problem.links) c.u = c.surface + relative<&ConeBody::v>(problem.bodies, c);
}

void accumulate_links(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows) {
  WideJoints& w = *world.wide_joints;
  for (std::size_t i = 0; i < problem.joint_rows().size(); ++i) {
    if (is_rotor(rows[i])) continue;  // what turns with an axis is on neither side of the joint
    const ConeLink& c = problem.joint_rows()[i];
    if (rows[i].is_coupling) {
      w.coupled()[rows[i].row].effort += c.p;
      continue;
    }
    JointLanes& joint = w.joints[rows[i].joint];
    const std::uint32_t lane = rows[i].lane;
    const Vec3 turn = get(row_at(w, rows[i]).w_b, lane) - get(joint.r_b, lane).cross(c.d_b);
    add(joint.force, lane, c.p * c.d_b);
    add(joint.torque, lane, c.p * turn);
  }
}

void keep_links(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows) {
  WideJoints& w = *world.wide_joints;
  for (std::size_t i = 0; i < problem.joint_rows().size(); ++i)
    (rows[i].is_coupling ? w.coupled()[rows[i].row].p : at(row_at(w, rows[i]).p, rows[i].lane)) =
        problem.joint_rows()[i].next_p;
}

void turn_rotors(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows) {
  WideJoints& w = *world.wide_joints;
  for (std::size_t i = 0; i < problem.links.size(); ++i) {
    const ConeLink& c = problem.links[i];
    if (!is_rotor(rows[i])) continue;
    JointDriveLanes& drive = w.drives[rows[i].row];
    at(drive.speed, rows[i].lane) -= c.give * c.p;
    at(drive.row.p, rows[i].lane) = 0;
  }
}

Real worst_error(const World& world, const ConeProblem& problem, const DirectGroups::LinkRow* rows) {
  const WideJoints& w = *world.wide_joints;
  Real worst = 0;
  for (std::size_t i = 0; i < problem.joint_rows().size(); ++i) {
    if (rows[i].is_coupling) {
      worst = std::max(worst, std::fabs(w.coupled()[rows[i].row].error));
      continue;
    }
    const Real x = get(row_at(w, rows[i]).error, rows[i].lane);
    if (!rows[i].is_drive) {
      worst = std::max(worst, std::fabs(x));
    } else if (rows[i].kind == DriveKind::limit) {
      const JointDriveLanes& drive = w.drives[rows[i].row];
      worst = std::max({worst, get(drive.lower, rows[i].lane) - x, x - get(drive.upper, rows[i].lane)});
    }
  }
  return worst;
}

}  // namespace carom::dynamics

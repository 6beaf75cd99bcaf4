// What the impulses of contacts and joints gave, row by row, taken from what their solver did.
#include <algorithm>

#include "dynamics/contact/contact.h"
#include "dynamics/force/force.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/solver/direct.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/solver/table.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

/// Impulses of one row, by what they give its bodies.
class Gift {
 public:
  /// @param at_once  they acted since the last account, and not throughout the phase that ends
  explicit Gift(const World& world, bool at_once = false) : world_(world), at_once_(at_once) {}

  /// @param p  N s, world   @param moment  N m s, world, about the centre of mass
  void add(bool moves, std::uint32_t i, const Vec3& impulse, const Vec3& moment) {
    if (!moves) return;
    const Ledger::Body& b = world_.ledger->body[i];
    const State& s = world_.state;
    const Locks locks = world_.scene.locks_of(i);
    const Vec3 p = locks ? Vec3(free_axes(locks).times(impulse)) : impulse;
    Amount a{p.dot((at_once_ ? b.seen_v : b.v) + s.v[i]) / 2, 0, p, b.x.cross(p)};
    if (rotates(world_.scene, i)) {
      Vec3 turn = moment;
      if (locks & kAngularLocks) turn = borne(i, b.q, locks, moment);
      a.kinetic += turn.dot((at_once_ ? b.seen_omega : b.omega) + s.omega[i]) / 2;
      a.angular += turn;
    }
    amount_ += a;
  }
  /// An impulse at a point, on B and the other way on A.   @param r_a, r_b  m, world axes, from the centres of mass
  void add(const Link& link, const Vec3& p, const Vec3& r_a, const Vec3& r_b) {
    add(link.moves_a, link.a, -p, -r_a.cross(p));
    add(link.moves_b, link.b, p, r_b.cross(p));
  }
  void twist(const Link& link, const Vec3& moment) {
    add(link.moves_a, link.a, Vec3::zero(), -moment);
    add(link.moves_b, link.b, Vec3::zero(), moment);
  }
  const Amount& amount() const { return amount_; }

 private:
  /// What of a moment its locks leave.
  Vec3 borne(std::uint32_t i, const Quat& q, Locks locks, const Vec3& moment) const {
    const Mat3 inertia = inertia_at(world_.scene, i, q);
    return inertia * (inverse_of_free(inertia, locks) * moment);
  }

  const World& world_;
  const bool at_once_;
  Amount amount_;
};

/// Shares of what a solver did, by cause, taken out of what is unassigned (or, of impacts, from restitution).
class Shares {
 public:
  Shares(const World& world, Cause from = Cause::unassigned) : world_(world), from_(from) {}
  /// What is not finite comes of bodies that are about to be put in quarantine.
  void give(Cause cause, const Gift& gift) {
    const Amount& a = gift.amount();
    if (finite(a.kinetic) && finite(a.linear) && finite(a.angular)) by_cause_[index_of(cause)] += a;
  }
  ~Shares() {
    for (const Cause cause : {Cause::contact, Cause::friction, Cause::joints, Cause::drives}) {
      const Amount& a = by_cause_[index_of(cause)];
      world_.ledger->account(cause, a);
      world_.ledger->account(from_, -a);
    }
  }
  Shares(const Shares&) = delete;
  Shares& operator=(const Shares&) = delete;
  const World& world() const { return world_; }

 private:
  const World& world_;
  const Cause from_;
  std::array<Amount, kFixedCauses> by_cause_;  // as many roundings as rows: accounts close all the same
};

Link link_of(const Row& row) { return {row.a, row.b, row.moves_a, row.moves_b}; }

// ---- contacts ----

/// A point's impulse, split along the normal and across.
/// @param spread  null, or of whose spread contact: its normal impulse has a moment of its own
void share_point(Shares& shares, const Row& row, const Vec3& p, const Vec3& r_a, const Vec3& r_b,
                 const ConeContact* spread = nullptr) {
  if (p == Vec3::zero()) return;
  const Link link = link_of(row);
  Gift normal(shares.world()), friction(shares.world());
  const Vec3 along = p.dot(row.n) * row.n;
  normal.add(link, along, r_a, r_b);
  if (spread) {
    normal.add(link.moves_a, link.a, Vec3::zero(), -p.dot(row.n) * spread->n_a);
    normal.add(link.moves_b, link.b, Vec3::zero(), p.dot(row.n) * spread->n_b);
  }
  friction.add(link, p - along, r_a, r_b);
  shares.give(Cause::contact, normal);
  shares.give(Cause::friction, friction);
}

/// @param old  impulses are those since save_impulses()
template <class Number>
void share_lanes(Shares& shares, const ContactLanes<Number>& lanes, bool old) {
  const World& world = shares.world();
  const WideContacts& wide = *world.wide;
  const Contacts& c = *world.contacts;
  const Ledger& l = *world.ledger;
  for (const WideContacts::Manifold& m : wide.manifolds) {
    const PairLanesOf<Number>& pair = lanes.pairs[m.pair];
    const std::uint32_t lane = m.lane;
    const Link link = link_of(c.rows[m.row]);
    const Vec3 n = get(pair.n, lane), t = get(pair.t, lane), r_a = get(pair.r_a, lane), r_b = get(pair.r_b, lane);
    Gift normal(world), friction(world);
    for (std::uint32_t k = 0; k < m.points; ++k) {
      const PointLanesOf<Number>& point = lanes.points[pair.first + k];
      const Real p = point.p_n[lane] - (old ? l.old_points[(pair.first + k) * kLanes + lane] : 0);
      const Vec3 d = get(point.d, lane);
      if (p != 0) normal.add(link, p * (pair.one_normal ? n : get(point.n, lane)), r_a + d, r_b + d);
    }
    const Real* const was = &l.old_pairs[(m.pair * kLanes + lane) * 3];
    const auto since = [&](Real now, int i) { return old ? now - was[i] : now; };
    friction.add(link, since(pair.p_t[lane], 0) * t + since(pair.p_s[lane], 1) * n.cross(t), r_a, r_b);
    friction.twist(link, since(pair.p_w[lane], 2) * n);
    shares.give(Cause::contact, normal);
    shares.give(Cause::friction, friction);
  }
}

void share_lanes(Shares& shares, bool old) {
  with_lanes(*shares.world().wide, [&](const auto& lanes, const auto&) { share_lanes(shares, lanes, old); });
}

void share_rows(Shares& shares) {
  const Contacts& c = *shares.world().contacts;
  for (std::size_t i = 0; i < c.rows.size(); ++i)
    share_point(shares, c.rows[i], c.rows[i].p, c.mass[i].r_a, c.mass[i].r_b);
}

void share_groups(Shares& shares) {
  const World& world = shares.world();
  const DirectGroups& d = *world.direct;
  for (std::size_t i = 0; i < d.contacts.size(); ++i) {
    const ConeContact& contact = d.contacts[i];
    share_point(shares, world.contacts->rows[d.row[i]], contact.p, contact.r_a, contact.r_b,
                contact.is_spread ? &contact : nullptr);
  }
}

// ---- joints ----

/// What a row does at its two ends, per impulse.
struct RowEnds {
  Vec3 d_a, d_b, w_a, w_b;
};
void share_joint_row(Shares& shares, const Link& link, const RowEnds& row, Real p, bool drives) {
  if (p == 0) return;
  Gift gift(shares.world());
  gift.add(link.moves_a, link.a, -p * row.d_a, -p * row.w_a);
  gift.add(link.moves_b, link.b, p * row.d_b, p * row.w_b);
  shares.give(drives ? Cause::drives : Cause::joints, gift);
}

void share_joint_lanes(Shares& shares, bool old) {
  const World& world = shares.world();
  const WideJoints& w = *world.wide_joints;
  const Contacts& c = *world.contacts;
  const Ledger& l = *world.ledger;
  for (std::uint32_t i = 0; i < w.active.size(); ++i) {
    if (!w.is_swept(i)) continue;
    const std::uint32_t lane = w.place[i].lane;
    const JointLanes& joint = w.joints[w.place[i].lanes];
    const auto share = [&](const JointRowLanes& row, Real before, bool again, bool drives) {
      const Real p = row.p[lane];
      const Real gave = old ? (again ? joint.again[lane] * before : 0) + (p - before) : p;
      const RowEnds ends = {get(pull_at_a(w, joint, row), lane), get(row.d, lane), get(row.w_a, lane),
                            get(row.w_b, lane)};
      share_joint_row(shares, c.links[i], ends, gave, drives);
    };
    for (std::uint32_t k = joint.first; k < joint.first + joint.layout.equalities; ++k)
      share(w.rows[k], l.old_rows[k * kLanes + lane], true, false);
    for (std::uint32_t k = 0; k < joint.layout.drives; ++k) {
      const std::uint32_t at = joint.first_drive + k;
      share(w.drives[at].row, l.old_drives[at * kLanes + lane], !acts_once(joint.layout.drive[k].kind), true);
    }
  }
}

void share_couplings(Shares& shares, bool old) {
  const World& world = shares.world();
  for (const CoupledRow& row : world.wide_joints->coupled()) {
    if (!world.wide_joints->is_swept(row.link)) continue;
    const Real p = old ? row.again * row.old_p + (row.p - row.old_p) : row.p;
    if (p == 0) continue;
    Gift gift(world);
    for (const CoupledBody& b : row.ends()) gift.add(b.moves, b.body, p * b.d, p * b.w);
    shares.give(Cause::joints, gift);
  }
}

/// @param settled  of groups that were settled after the move: those without contacts
void share_group_links(Shares& shares, bool settled) {
  const World& world = shares.world();
  const DirectGroups& d = *world.direct;
  for (std::size_t g = 0; g < d.groups(); ++g) {
    const DirectGroups::Begin &from = d.begin[g], &to = d.begin[g + 1];
    if (settled && from.contact < to.contact) continue;
    for (std::uint32_t i = from.link; i < to.link; ++i) {
      const ConeLink& c = d.links[i];
      const auto slot = [&](std::uint32_t body) { return body == kInvalid ? 0 : d.bodies[body].slot; };
      share_joint_row(shares, {slot(c.a), slot(c.b), c.a != kInvalid, c.b != kInvalid}, {c.d_a, c.d_b, c.w_a, c.w_b},
                      c.p, d.link_row[i].is_drive);
      c.each_more([&](std::uint32_t body, const Vec3& along, const Vec3& w) {
        Gift gift(world);
        gift.add(true, slot(body), c.p * along, c.p * w);
        shares.give(Cause::joints, gift);
      });
    }
  }
}

bool solves_directly(const World& world) { return world.direct->groups() > 0; }

}  // namespace

void reserve_shares(const World& world) {
  Ledger& l = *world.ledger;
  with_lanes(*world.wide, [&](const auto& lanes, const auto&) {
    l.old_points.resize(lanes.points.size() * kLanes);
    l.old_pairs.resize(lanes.pairs.size() * kLanes * 3);
  });
  l.old_rows.resize(world.wide_joints->rows.size() * kLanes);
  l.old_drives.resize(world.wide_joints->drives.size() * kLanes);
  l.old_impacts.resize(world.contacts->impacts.size());
}

void save_impulses(const World& world) {
  Ledger& l = *world.ledger;
  const WideContacts& wide = *world.wide;
  const WideJoints& w = *world.wide_joints;
  const auto note = [](Real* to, std::size_t stride, const auto& from) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) to[lane * stride] = from[lane];
  };
  if (world.plan->solver->in_lanes) {
    with_lanes(wide, [&](const auto& lanes, const auto&) {
      for (std::size_t i = 0; i < lanes.points.size(); ++i) note(&l.old_points[i * kLanes], 1, lanes.points[i].p_n);
      for (std::size_t i = 0; i < lanes.pairs.size(); ++i) {
        const auto& pair = lanes.pairs[i];
        Real* const to = &l.old_pairs[i * kLanes * 3];
        note(to, 3, pair.p_t), note(to + 1, 3, pair.p_s), note(to + 2, 3, pair.p_w);
      }
    });
  }
  for (std::size_t i = 0; i < w.rows.size(); ++i) note(&l.old_rows[i * kLanes], 1, w.rows[i].p);
  for (std::size_t i = 0; i < w.drives.size(); ++i) note(&l.old_drives[i * kLanes], 1, w.drives[i].row.p);
  for (CoupledRow& row : world.wide_joints->coupled()) row.old_p = row.p;
}

void clear_friction(const World& world, std::uint32_t pair, std::uint32_t lane) {
  Real* const was = &world.ledger->old_pairs[(std::size_t(pair) * kLanes + lane) * 3];
  std::fill(was, was + 3, Real(0));
}

void save_impacts(const World& world) {
  const Contacts& c = *world.contacts;
  if (!world.plan->runs[static_cast<std::size_t>(Stage::solve)]) return;
  for (std::size_t k = 0; k < c.impacts.size(); ++k)
    world.ledger->old_impacts[k] = c.geometry[c.impacts[k].row].impulse;
}

void share_solved(const World& world) {
  const Solver* const solver = world.plan->solver;
  Shares shares(world);
  if (solver->in_lanes) share_lanes(shares, false);
  if (solver->row_by_row) share_rows(shares);
  if (solves_directly(world)) share_groups(shares), share_group_links(shares, false);
  if (world.wide_joints->any()) share_joint_lanes(shares, false), share_couplings(shares, false);
}

void share_relaxed(const World& world) {
  Shares shares(world);
  if (world.plan->solver->in_lanes) share_lanes(shares, true);
  if (solves_directly(world)) share_group_links(shares, true);
  if (world.wide_joints->any()) share_joint_lanes(shares, true), share_couplings(shares, true);
}

/// Friction of impacts; their normal impulses are what is left.
void share_impacts(const World& world) {
  Shares shares(world, Cause::restitution);
  const Contacts& c = *world.contacts;
  for (std::size_t k = 0; k < c.impacts.size(); ++k) {
    const Impact& at = c.impacts[k];
    const Row& row = c.rows[at.row];
    const Vec3 p = c.geometry[at.row].impulse - world.ledger->old_impacts[k];
    if (p == Vec3::zero()) continue;
    Gift friction(world, true);
    friction.add(link_of(row), p - p.dot(row.n) * row.n, at.r.a, at.r.b);
    shares.give(Cause::friction, friction);
  }
}

}  // namespace carom::dynamics

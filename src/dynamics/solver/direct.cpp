// Stage functions of the direct solver.
#include "dynamics/solver/direct.h"

#include <algorithm>

#include "dynamics/contact/held_arms.h"
#include "dynamics/force/force.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/quarantine.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/round.h"
#include "dynamics/solver/solver.h"

namespace carom {
namespace {

constexpr std::size_t kGroupsAPart = 1;  // a group takes as long as many bodies of other loops
// Of the tolerance, for few bodies that lie still: what may roll has no contact against it, and takes each push for
// good.
constexpr Real kStillShare = 1e-3;
constexpr Real kShare = 1e-3;              // of the fastest contact, that is good enough where work is bounded
constexpr Real kRest = 10;                 // tolerances: contacts that move slower, in any direction, are at rest
constexpr Real kJoinedShare = 1e-3;        // of the tolerance, where there are joints: velocities add up to gaps
constexpr int kJerks = 3;                  // times that a group is answered anew because a joint was jerked
constexpr Real kLongest = 30;              // of the largest overlap to be undone, that a body is displaced at most
constexpr Real kGap = 1e-9;                // m or rad, of a joint that needs no parting
constexpr std::uint32_t kAlways = 2;       // steps of Newton, a group and substep, however little work is left
constexpr std::uint32_t kMostSteps = 200;  // of Newton, a group and substep: impacts of many bodies take that many

/// Room for some groups before there are any: a small world that settles goes on without allocating when one of its
/// bodies comes to rest late, and that group is the first to be answered here.
void make_room(DirectGroups& d) {
  constexpr std::size_t kSome = 64;
  if (d.contacts.capacity() >= kSome) return;
  const auto reserve = [](auto&... arrays) { (arrays.reserve(kSome), ...); };
  Elimination& e = d.elimination;
  reserve(d.contacts, d.row, d.begin, d.bodies, d.edges, d.edge_begin, d.ordered_edges, d.ordered_begin, d.scratch,
          d.work, d.still, d.answer, d.rest, d.factor.diagonal, d.factor.below, e.place, e.column, e.rows);
  Elimination::Scratch& s = e.scratch;
  reserve(s.neighbour_begin, s.neighbour, s.degree, s.mark, s.first, s.next, s.element, s.begin, s.member);
}

/// Bodies, contacts and edges of each group.
void gather(World& world, DirectGroups& d) {
  const Contacts& c = *world.contacts;
  make_room(d);
  d.links.clear(), d.link_row.clear();
  d.still.clear(), d.contacts.clear(), d.row.clear(), d.begin.clear();
  d.bodies.clear(), d.edges.clear(), d.edge_begin.clear();
  d.body.resize(world.scene.bodies.slots());
  for (const std::uint32_t slot : c.bodies) d.body[slot] = kNobody;
  const auto mark = [&] {
    d.begin.push_back({static_cast<std::uint32_t>(d.contacts.size()), static_cast<std::uint32_t>(d.bodies.size()),
                       static_cast<std::uint32_t>(d.links.size())});
    d.edge_begin.push_back(static_cast<std::uint32_t>(d.edges.size()));
  };
  for (std::size_t g = 0; g < c.groups(); ++g) {
    if (!c.answered_directly(g)) continue;
    mark();
    d.still.push_back(!c.direct.empty() && c.direct[g] == Contacts::kStill);
    for (std::uint32_t k = c.group_begin[g]; k < c.group_begin[g + 1]; ++k) {
      const std::uint32_t i = c.group_rows[k];
      const Row& row = c.rows[i];
      ConeContact& contact = d.contacts.emplace_back();
      contact.a = d.node(row.moves_a, row.a);
      contact.b = d.node(row.moves_b, row.b);
      const bool coupled = contact.a != kNobody && contact.b != kNobody;
      if (coupled && (d.edges.size() == d.edge_begin.back() || d.edges.back() != Edge{contact.a, contact.b}))
        d.edges.push_back({contact.a, contact.b});
      d.row.push_back(i);
    }
    gather_links(world, d, g);
  }
  mark();
}

/// Find an order of elimination, unless the bodies hang together as they did in the last step.
void order(DirectGroups& d) {
  if (d.edges == d.ordered_edges && d.edge_begin == d.ordered_begin && d.bodies.size() == d.elimination.place.size())
    return;
  d.elimination.clear();
  d.work.resize(d.groups());
  for (std::size_t g = 0; g < d.groups(); ++g)
    d.work[g] = eliminate(d.begin[g].body, d.begin[g + 1].body - d.begin[g].body,
                          {d.edges.data() + d.edge_begin[g], d.edge_begin[g + 1] - d.edge_begin[g]}, d.elimination);
  d.factor.diagonal.resize(d.bodies.size());
  d.factor.below.resize(d.elimination.rows.size());
  d.scratch.resize(d.bodies.size());
  d.ordered_edges = d.edges, d.ordered_begin = d.edge_begin;
}

/// Where in the factor each contact and each row of a joint couples its bodies.
void place_contacts(DirectGroups& d) {
  const auto place = [&](auto& c) {
    c.below = kNobody;
    if (c.a == kNobody || c.b == kNobody) return;
    const std::uint32_t a = d.elimination.place[c.a], b = d.elimination.place[c.b];
    c.a_later = a > b;
    c.below = static_cast<std::uint32_t>(d.factor.at(d.elimination, std::max(a, b), std::min(a, b)));
  };
  std::ranges::for_each(d.contacts, place);
  std::ranges::for_each(d.links, place);
}

/// Masses, in the body's present orientation.
void load_mass(const World& world, ConeBody& b) {
  b.mass = world.scene.mass[b.slot], b.inv_mass = world.scene.inv_mass[b.slot];
  b.locks = world.scene.locks_of(b.slot);
  b.inertia.setIdentity(), b.inv_inertia.setZero(), b.held_back.setZero();
  if (!rotates(world.scene, b.slot)) return;
  const Mat3& r = world.plan->rotation[b.slot];
  b.held_back = held_back(world, b.slot);
  b.inertia = r * world.scene.inertia[b.slot] * r.transpose();
  b.inv_inertia = b.locks & kAngularLocks ? inverse_of_free(b.inertia, b.locks)
                                          : Mat3(r * world.scene.inv_inertia[b.slot] * r.transpose());
}

/// Mean of the eigenvalues of what an impulse at a point does to the velocity there.
Real mean_response(const ConeBody* bodies, const ConeContact& c) {
  const auto of = [&](std::uint32_t body, const Vec3& r) {
    if (body == kNobody) return Real(0);
    const Mat3& w = bodies[body].inv_inertia;
    return bodies[body].inv_mass + (r.squaredNorm() * w.trace() - r.dot(w * r)) / 3;  // -trace([r]x w [r]x) = ...
  };
  return of(c.a, c.r_a) + of(c.b, c.r_b);
}

bool is_curved(const Shape& s) {
  return s.form != Form::box && s.form != Form::polytope && s.form != Form::half_space && !is_scenery(s);
}

/// Where a contact is, and what depends on that. Bodies have the velocities of the state.
void load_contact(const World& world, std::uint32_t row_index, const ConeBody* bodies, ConeContact& contact) {
  const Row& row = world.contacts->rows[row_index];
  const RowGeometry& g = world.contacts->geometry[row_index];
  Arms arms(world, row, g);
  if (contact.a != kNobody) arms.a += bodies[contact.a].held_back * g.l_a;
  if (contact.b != kNobody) arms.b += bodies[contact.b].held_back * g.l_b;
  const auto turns = [&](std::uint32_t body) { return body != kNobody && rotates(world.scene, bodies[body].slot); };
  contact.n = row.n;
  contact.r_a = turns(contact.a) ? arms.a : Vec3::Zero();
  contact.r_b = turns(contact.b) ? arms.b : Vec3::Zero();
  contact.k = mean_response(bodies, contact);
  contact.carried = relative_velocity(world.state, row, arms.a, arms.b) - relative<&ConeBody::v>(bodies, contact);
  if (const Array<Vec3>& surface = world.contacts->surface; !surface.empty()) contact.carried += surface[row_index];
}

/// Bodies and contacts, as the step begins.
void load(World& world, DirectGroups& d) {
  for (ConeBody& b : d.bodies) {
    hold_orientation(world, b.slot);
    load_mass(world, b);
    b.v << world.state.v[b.slot], world.state.omega[b.slot];
  }
  for (std::size_t i = 0; i < d.contacts.size(); ++i) {
    load_contact(world, d.row[i], d.bodies.data(), d.contacts[i]);
    const Pair& pair = world.pairs.place(world.contacts->geometry[d.row[i]].pair).pair;
    const Array<const Shape*>& shape = world.scene.colliders.shape;
    d.contacts[i].is_curved = is_curved(*shape[pair.a]) || is_curved(*shape[pair.b]);
  }
}

/// What contacts start from in the next substep. Impulses that are off let velocities grow, substep by substep, until
/// the solver undoes all that has gathered. Taken over whole that would throw the bodies back in the next substep, and
/// a group at rest would be solved for ever: what the loads need of it is as much as undoes what velocities gained in
/// this substep alone. It stays within the cones, which are convex.
void start_from_loads(ConeProblem& problem) {
  Real along = 0, size2 = 0;
  for (const ConeBody& b : bodies_of(problem)) {
    const Vec6 undone = b.start - b.v, momentum = momentum_of(b, undone);
    along += momentum.dot(b.gained), size2 += momentum.dot(undone);
  }
  const Real share = size2 > 0 ? std::clamp(along / size2, Real(0), Real(1)) : 1;
  for (ConeContact& c : problem.contacts) c.next_p = c.start_p + share * (c.p - c.start_p);
  for (ConeLink& c : problem.links) c.next_p = c.start_p + share * (c.p - c.start_p);
}

/// What was never solved before takes the time it takes, once.
bool starts_from_nothing(const ConeProblem& problem) {
  return std::ranges::all_of(problem.contacts, [](const ConeContact& c) { return c.start_p == Vec3::Zero(); }) &&
         std::ranges::all_of(problem.links, [](const ConeLink& c) { return c.start_p == 0; });
}

/// m/s, well above what rounding leaves of a residual.
Real rounding(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeContact& c : problem.contacts) most = std::max(most, c.k * c.p.norm());
  for (const ConeLink& c : problem.links) most = std::max(most, c.k * std::fabs(c.p));
  return 1e3 * kEpsilon * most;
}

/// m/s, the most that two points close or part, with impulses as they are.
Real fastest(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeContact& c : problem.contacts) most = std::max(most, std::fabs(c.u.dot(c.n)));
  return most;
}

/// m/s, likewise, in any direction.
Real fastest_any_way(const ConeProblem& problem) {
  Real most2 = 0;
  for (const ConeContact& c : problem.contacts) most2 = std::max(most2, c.u.squaredNorm());
  return std::sqrt(most2);
}

/// One group of one substep.
class Group {
 public:
  Group(World& world, std::size_t group)
      : world_(world),
        c_(*world.contacts),
        s_(world.state),
        rest_(world.direct->rest[group]),
        answer_(world.direct->answer[group]),
        problem_(world.direct->problem(group)),
        row_(world.direct->row.data() + world.direct->begin[group].contact),
        link_row_(world.direct->link_row.data() + world.direct->begin[group].link),
        work_(world.direct->work[group]),
        still_(world.direct->still[group]) {}

  /// @param work  @see solve_groups()
  void solve(Real h, std::uint64_t work, int substeps) {
    const Real tolerance = kDirectShare * world_.scene.dials[Dial::velocity_tolerance];
    if (rest_.lasts && repeat(tolerance)) return;
    book_repeats();
    if (rest_.has_moved) look();
    const Real least = start(h);
    rest_.is_bounded = work && !starts_from_nothing(problem_);
    if (rest_.is_first) rest_.work = work;
    const Real enough = still_ ? std::max(kStillShare * tolerance, rounding(problem_))
                        : work ? std::max(tolerance, kShare * fastest(problem_))
                               : tolerance;
    const Real goal = is_joined() ? std::min(enough, std::max(kJoinedShare * tolerance, rounding(problem_))) : enough;
    const bool lies = !is_joined() && fastest_any_way(problem_) < world_.scene.dials[Dial::velocity_tolerance];
    const std::uint32_t most_steps = allowed_steps(lies ? rest_.work : work / static_cast<std::uint64_t>(substeps));
    answer_ = solve_cones(problem_, goal, most_steps);
    for (int i = 0; i < kJerks && is_joined() && is_jerked(world_, problem_, link_row_, h); ++i) {
      if (has_ring(problem_, link_row_)) {
        shed_self_stress(problem_);
        if (!is_jerked(world_, problem_, link_row_, h)) break;
      }
      for (ConeLink& link : problem_.links) link.next_p = link.p;
      keep_links(world_, problem_, link_row_);
      start(h);
      answer_ = solve_cones(problem_, goal, most_steps);
    }
    book_work();
    start_from_loads(problem_);
    keep();
    rest_.is_first = false;
    rest_.lasts = !is_joined() && answer_.factorisations == 0 &&
                  least >= -world_.scene.dials[Dial::position_tolerance] && !rest_.resists &&
                  fastest_any_way(problem_) < kRest * tolerance;
    rest_.has_moved = rest_.lasts;  // or part() measures
  }

  /// A group that overlaps more than the tolerance is parted, to half of it, so that what rests keeps in touch.
  void part(Real h) {
    if (rest_.lasts) return;
    const Real tolerance = world_.scene.dials[Dial::position_tolerance];
    const Real most = world_.scene.dials[Dial::push_speed] * h;
    answer_ = {};
    const bool overlaps = measure() < -tolerance;
    if (!overlaps && !(is_joined() && worst_error(world_, problem_, link_row_) > kGap)) return;
    each([&](ConeContact& contact, std::uint32_t row) {
      contact.p.setZero(), contact.u.setZero();
      contact.friction = 0;
      contact.want = std::min(-(c_.geometry[row].separation + tolerance / 2), most);
    });
    for (ConeBody& b : bodies_of(problem_)) b.v.setZero();
    load_links(world_, problem_, link_row_, LinkPhase::part, h);
    measure_links(problem_);
    if (is_joined()) {
      answer_ = solve_cones(problem_, 0.1 * kGap, kMostSteps);
    } else {
      answer_ = solve_cones(problem_, 0.01 * tolerance, allowed_steps(rest_.work));
      book_work();
    }
    const Real share = displacement_share();
    for (const ConeBody& b : bodies_of(problem_)) {
      const Vec3 turn = share * angular(b.v);
      correct_pose(s_, b.slot, share * linear(b.v), turn);
      if (turn == Vec3::Zero()) continue;
      world_.plan->rotation[b.slot] = s_.q[b.slot].toRotationMatrix();
    }
    for (ConeBody& b : bodies_of(problem_)) load(b);
    measure();
  }

  /// Velocities along what is locked, where the move has ended. Of groups that nothing touches: contacts, whose poses
  /// the solved velocities were to make good, are not asked twice.
  void settle(Real h) {
    if (!is_joined() || !problem_.contacts.empty()) return;
    const Real tolerance = kDirectShare * world_.scene.dials[Dial::velocity_tolerance];
    for (ConeBody& b : bodies_of(problem_)) {
      world_.plan->rotation[b.slot] = s_.q[b.slot].toRotationMatrix();
      load_mass(world_, b);
      load(b);
    }
    load_links(world_, problem_, link_row_, LinkPhase::settle, h);
    measure_links(problem_);
    const ConeAnswer answer = solve_cones(problem_, kJoinedShare * tolerance, kMostSteps);
    answer_.factorisations += answer.factorisations;
    book_links(world_, problem_, link_row_);
    for (const ConeBody& b : bodies_of(problem_)) store(b);
  }

  bool is_joined() const { return !problem_.links.empty(); }
  Real error() const { return worst_error(world_, problem_, link_row_); }

  void end() {
    book_repeats();
    measure();
  }

 private:
  /// Of Newton's method.   @param work  block products, beyond those of kAlways
  std::uint32_t allowed_steps(std::uint64_t work) const {
    if (!rest_.is_bounded) return kMostSteps;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(kAlways + work / work_, kMostSteps));
  }
  void book_work() {
    if (!rest_.is_bounded) return;
    const std::uint32_t beyond = std::max(answer_.factorisations, kAlways) - kAlways;
    rest_.work -= std::min(rest_.work, beyond * work_);
  }

  /// Impulses of substeps that repeated the one before, into those of the step.
  void book_repeats() {
    if (rest_.repeats == 0) return;
    each([&](const ConeContact& contact, std::uint32_t row) { c_.geometry[row].impulse += rest_.repeats * contact.p; });
    rest_.repeats = 0;
  }

  template <class F>
  void each(F&& f) {
    for (std::size_t i = 0; i < problem_.contacts.size(); ++i) f(problem_.contacts[i], row_[i]);
  }

  /// Where contacts were found at rest and every impulse in order, the next substep's are the same, as long as that
  /// leaves the bodies' velocities as they are: what has changed is looked for once a step.
  bool repeat(Real tolerance) {
    for (const ConeBody& b : bodies_of(problem_)) {
      const Vec3 dv = s_.v[b.slot] + linear(b.change) - linear(b.v);
      const Vec3 turn = s_.omega[b.slot] + angular(b.change) - angular(b.v);
      const Real radius2 = b.inertia.trace() * b.inv_mass;
      if (!(dv.squaredNorm() + radius2 * turn.squaredNorm() < kRest * kRest * tolerance * tolerance)) return false;
    }
    for (ConeBody& b : bodies_of(problem_)) {
      load(b);
      b.v += b.change;
      store(b);
    }
    ++rest_.repeats;
    return true;
  }

  /// Contacts go with the bodies within a step. But not where a shape is curved: points that turned with it would stay
  /// behind the place where it touches as it rolls, and drive it on.
  void follow_bodies() {
    for (ConeBody& b : bodies_of(problem_)) load_mass(world_, b);
    each([&](ConeContact& contact, std::uint32_t row) {
      if (!contact.is_curved) load_contact(world_, row, problem_.bodies, contact);
    });
  }

  /// Velocities with the impulses that contacts start from.   @return m, the least separation
  Real start(Real h) {
    Real least = kInfinity;
    for (ConeBody& b : bodies_of(problem_)) {
      b.gained = -b.v;
      load(b);
      b.gradient.setZero();
    }
    if (!rest_.is_first) follow_bodies();
    each([&](ConeContact& contact, std::uint32_t i) {
      const Row& row = c_.rows[i];
      const Real separation = c_.geometry[i].separation;
      least = std::min(least, separation);
      contact.friction = row.friction;
      contact.want = separation > 0 ? -separation / h : 0;
      contact.p = contact.start_p = row.p;
      add_impulse<&ConeBody::gradient>(problem_, contact, contact.p);
    });
    if (is_joined()) stiffen(world_, problem_, link_row_, h);
    load_links(world_, problem_, link_row_, LinkPhase::move, h);
    for (const ConeLink& link : problem_.links) add_impulse<&ConeBody::gradient>(problem_, link, link.p);
    for (ConeBody& b : bodies_of(problem_)) {
      b.change = velocity_of(b, b.gradient);
      b.start = b.v += b.change;
      b.gained += b.v;
    }
    for (ConeContact& contact : problem_.contacts)
      contact.u = contact.carried + relative<&ConeBody::v>(problem_.bodies, contact);
    measure_links(problem_);
    return least;
  }

  void keep() {
    each([&](const ConeContact& contact, std::uint32_t i) {
      c_.rows[i].p = contact.next_p;
      c_.rows[i].u = contact.u;
      c_.geometry[i].impulse += contact.p;
    });
    keep_links(world_, problem_, link_row_);
    book_links(world_, problem_, link_row_);
    for (const ConeBody& b : bodies_of(problem_)) store(b);
  }

  void load(ConeBody& b) const { b.v << s_.v[b.slot], s_.omega[b.slot]; }
  void store(const ConeBody& b) {
    const Vec3 v = linear(b.v), omega = angular(b.v);
    world_.plan->touched[b.slot] = v != s_.v[b.slot] || omega != s_.omega[b.slot];
    s_.v[b.slot] = v, s_.omega[b.slot] = omega;
  }

  /// Of the displacements that were found, how much is taken. What is wedged between walls that nearly face each other,
  /// or is pushed at from all sides, would be moved by metres to be parted by millimetres.
  Real displacement_share() const {
    Real asked = 0, moved2 = 0;
    for (const ConeContact& c : problem_.contacts) asked = std::max(asked, c.want);
    for (const ConeLink& c : problem_.links) asked = std::max(asked, std::min(std::fabs(c.low), std::fabs(c.high)));
    for (const ConeBody& b : bodies_of(problem_)) moved2 = std::max(moved2, linear(b.v).squaredNorm());
    const Real most = kLongest * asked;
    return moved2 > most * most ? most / std::sqrt(moved2) : 1;
  }

  /// At where the bodies of a group at rest are by now, should it not lie still any more.
  void look() {
    for (const ConeBody& b : bodies_of(problem_)) world_.plan->rotation[b.slot] = s_.q[b.slot].toRotationMatrix();
    measure();
  }

  Real measure() {
    Real least = kInfinity;
    each([&](const ConeContact&, std::uint32_t row) {
      Real& separation = c_.geometry[row].separation;
      separation = separation_of(world_, c_.rows[row], c_.geometry[row]);
      least = std::min(least, separation);
    });
    return least;
  }

  World& world_;
  Contacts& c_;
  State& s_;
  GroupRest& rest_;
  ConeAnswer& answer_;
  ConeProblem problem_;
  const std::uint32_t* row_;
  const DirectGroups::LinkRow* link_row_;
  std::uint64_t work_;
  bool still_;
};

void begin(World& world, const StepTime& time) {
  if (world.wide_joints->any()) {  // their rows are made in lanes, as are numbers of bodies
    world.contacts->direct.assign(world.contacts->groups(), Contacts::kDirectly);
    pack(world, *world.wide, time.h);
    begin_joints(world, time.h);
  }
  gather_groups(world);
}

void velocities(World& world, const StepTime& time) {
  if (world.wide_joints->any()) load_velocities(world, *world.wide);
  bend_joints(world, time.h);
  solve_groups(world, time.h, 0, world.plan->substeps);
}

void positions(World& world, const StepTime& time) {
  part_groups(world, time.h);
  settle_joints(world, time.h);
}

void end(World& world, const StepTime&) {
  refresh_rotations(world);
  end_groups(world);
}

/// Of the group that a row is in; null: another solver answers it.
GroupRest* rest_of(DirectGroups& d, const Row& row) {
  const std::uint32_t node = d.body[row.moves_a ? row.a : row.b];
  if (node == kNobody) return nullptr;
  const auto after = std::ranges::upper_bound(d.begin, node, {}, [](const auto& begin) { return begin.body; });
  return &d.rest[static_cast<std::size_t>(after - d.begin.begin()) - 1];
}

}  // namespace

void gather_groups(World& world) {
  DirectGroups& d = *world.direct;
  gather(world, d);
  order(d);
  place_contacts(d);
  load(world, d);
  d.answer.resize(d.groups());
  d.rest.assign(d.groups(), {});
  for (const Resistance& r : world.contacts->resisting)
    if (GroupRest* const rest = rest_of(d, world.contacts->rows[r.row])) rest->resists = true;
}

void solve_groups(World& world, Real h, std::uint64_t work, int substeps) {
  DirectGroups& d = *world.direct;
  for (const Impact& at : world.contacts->impacts)
    if (GroupRest* const rest = at.concerns_solver() ? rest_of(d, world.contacts->rows[at.row]) : nullptr)
      rest->lasts = false;
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) { Group(world, g).solve(h, work, substeps); });
  for (std::size_t g = 0; g < d.groups(); ++g) {
    if (d.rest[g].repeats > 0) continue;
    world.report.velocity_impulses += d.answer[g].factorisations;
    world.report.solver_residual = std::max<double>(world.report.solver_residual, d.answer[g].residual);
  }
}

void part_groups(World& world, Real h) {
  DirectGroups& d = *world.direct;
  if (!d.links.empty()) place_joints(world);
  if (std::ranges::all_of(d.rest, [](const GroupRest& rest) { return rest.lasts; })) return;
  refresh_rotations(world);
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) { Group(world, g).part(h); });
  for (const ConeAnswer& answer : d.answer) world.report.position_moves += answer.factorisations;
}

void settle_joints(World& world, Real h) {
  DirectGroups& d = *world.direct;
  if (d.links.empty()) return;
  // Parting follows tangents: a second time, from where the first has led, where that is not close enough.
  constexpr int kTimes = 8;
  for (int k = 0; k < kTimes; ++k) {
    place_joints(world);
    bool any = false;
    for (std::size_t g = 0; g < d.groups() && !any; ++g) any = Group(world, g).error() > kGap;
    if (!any) break;
    in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) {
      if (Group(world, g).error() > kGap) Group(world, g).part(h);
    });
    if (k + 1 == kTimes) place_joints(world);
  }
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) { Group(world, g).settle(h); });
}

void end_groups(World& world) {
  DirectGroups& d = *world.direct;
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) { Group(world, g).end(); });
}

extern constexpr Solver kDirect = {"direct", false, true, begin, velocities, positions, end};

}  // namespace carom

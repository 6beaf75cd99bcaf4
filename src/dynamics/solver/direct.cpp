// Stage functions of the direct solver.
#include "dynamics/solver/direct.h"

#include <algorithm>

#include "dynamics/force/force.h"
#include "dynamics/solver/solver.h"

namespace carom {
namespace {

constexpr std::size_t kGroupsAPart = 1;  // a group takes as long as many bodies of other loops
// Of the tolerance, for few bodies that lie still: what may roll has no contact against it, and takes each push for
// good.
constexpr Real kStillShare = 1e-3;
constexpr Real kShare = 1e-3;              // of the fastest contact, that is good enough where work is bounded
constexpr std::uint32_t kMostSteps = 200;  // of Newton, a group and substep: impacts of many bodies take that many

/// Bodies, contacts and edges of each group.
void gather(World& world, DirectGroups& d) {
  const Contacts& c = *world.contacts;
  d.still.clear(), d.contacts.clear(), d.row.clear(), d.begin.clear();
  d.bodies.clear(), d.edges.clear(), d.edge_begin.clear();
  d.body.resize(world.scene.bodies.slots());
  for (const std::uint32_t slot : c.bodies) d.body[slot] = kNobody;
  const auto node = [&](bool moves, std::uint32_t slot) {
    if (!moves) return kNobody;
    if (d.body[slot] == kNobody) {
      d.body[slot] = static_cast<std::uint32_t>(d.bodies.size());
      d.bodies.emplace_back().slot = slot;
    }
    return d.body[slot];
  };
  const auto mark = [&] {
    d.begin.push_back({static_cast<std::uint32_t>(d.contacts.size()), static_cast<std::uint32_t>(d.bodies.size())});
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
      contact.a = node(row.moves_a, row.a);
      contact.b = node(row.moves_b, row.b);
      const bool coupled = contact.a != kNobody && contact.b != kNobody;
      if (coupled && (d.edges.size() == d.edge_begin.back() || d.edges.back() != Edge{contact.a, contact.b}))
        d.edges.push_back({contact.a, contact.b});
      d.row.push_back(i);
    }
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

/// Where in the factor each contact couples its bodies.
void place_contacts(DirectGroups& d) {
  for (ConeContact& c : d.contacts) {
    c.below = kNobody;
    if (c.a == kNobody || c.b == kNobody) continue;
    const std::uint32_t a = d.elimination.place[c.a], b = d.elimination.place[c.b];
    c.a_later = a > b;
    c.below = static_cast<std::uint32_t>(d.factor.at(d.elimination, std::max(a, b), std::min(a, b)));
  }
}

void load_bodies(World& world, DirectGroups& d) {
  const State& s = world.state;
  for (ConeBody& b : d.bodies) {
    b.v << s.v[b.slot], s.omega[b.slot];
    b.mass = world.scene.mass[b.slot], b.inv_mass = world.scene.inv_mass[b.slot];
    b.inertia.setIdentity(), b.inv_inertia.setZero();
    if (!rotates(world.scene, b.slot)) continue;
    const Mat3& r = world.plan->rotation[b.slot];
    b.inertia = r * world.scene.inertia[b.slot] * r.transpose();
    b.inv_inertia = r * world.scene.inv_inertia[b.slot] * r.transpose();
  }
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

void load_contacts(World& world, DirectGroups& d, Real h) {
  Contacts& c = *world.contacts;
  for (std::size_t i = 0; i < d.contacts.size(); ++i) {
    ConeContact& contact = d.contacts[i];
    Row& row = c.rows[d.row[i]];
    const RowGeometry& g = c.geometry[d.row[i]];
    const Arms arms(world, row, g);
    const auto turns = [&](std::uint32_t body) { return body != kNobody && rotates(world.scene, d.bodies[body].slot); };
    contact.n = row.n;
    contact.u = relative_velocity(world.state, row, arms.a, arms.b);
    contact.r_a = turns(contact.a) ? arms.a : Vec3::Zero();
    contact.r_b = turns(contact.b) ? arms.b : Vec3::Zero();
    contact.friction = row.friction;
    contact.k = mean_response(d.bodies.data(), contact);
    contact.want = g.separation > 0 ? -g.separation / h : 0;
    contact.p = contact.start_p = row.p;
  }
}

/// What contacts start from in the next substep. Impulses that were off by da let velocities grow by da in each of n
/// substeps; those that the solver finds when that becomes too much undo n da and, beside it, the da of this substep.
/// Taken over whole they would throw the bodies back by n da in the next one, and a group at rest would be solved for
/// ever. One part in n + 1 of the change is what the loads need; it stays within the cones, which are convex.
/// @param solved  else they go on as they are
void start_from_loads(State& s, ConeProblem& problem, bool solved) {
  constexpr std::uint8_t kLongest = 255;
  std::uint8_t calm = kLongest;
  for (const ConeBody& b : bodies_of(problem)) calm = std::min(calm, s.calm_steps[b.slot]);
  const Real share = solved ? Real(1) / (1 + calm) : 1;
  for (ConeContact& c : problem.contacts) c.next_p = c.start_p + share * (c.p - c.start_p);
  for (const ConeBody& b : bodies_of(problem))
    s.calm_steps[b.slot] = solved ? 0 : static_cast<std::uint8_t>(std::min<int>(calm + 1, kLongest));
}

/// What was never solved before takes the time it takes, once.
bool starts_from_nothing(const ConeProblem& problem) {
  return std::ranges::all_of(problem.contacts, [](const ConeContact& c) { return c.start_p == Vec3::Zero(); });
}

/// m/s, well above what rounding leaves of a residual.
Real rounding(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeContact& c : problem.contacts) most = std::max(most, c.k * c.p.norm());
  return 1e3 * kEpsilon * most;
}

/// m/s, the most that two points close or part, with impulses as they are.
Real fastest(const ConeProblem& problem) {
  Real most = 0;
  for (const ConeContact& c : problem.contacts) most = std::max(most, std::fabs(c.u.dot(c.n)));
  return most;
}

/// Groups that overlap more than the tolerance are parted, to half of it, so that what rests keeps in touch.
void part(World& world, DirectGroups& d, std::size_t group, Real h) {
  const Contacts& c = *world.contacts;
  State& s = world.state;
  const Real tolerance = world.scene.dials[Dial::position_tolerance];
  const Real most = world.scene.dials[Dial::push_speed] * h;
  ConeProblem problem = d.problem(group);
  const std::uint32_t first = d.begin[group].contact, last = d.begin[group + 1].contact;
  Real least = 0;
  for (std::uint32_t i = first; i < last; ++i) least = std::min(least, c.geometry[d.row[i]].separation);
  d.answer[group] = {};
  if (!(least < -tolerance)) return;
  for (std::uint32_t i = first; i < last; ++i) {
    ConeContact& contact = d.contacts[i];
    contact.p.setZero(), contact.u.setZero();
    contact.friction = 0;
    contact.want = std::min(-(c.geometry[d.row[i]].separation + tolerance / 2), most);
  }
  for (std::uint32_t i = problem.first; i < problem.last; ++i) d.bodies[i].v.setZero();
  d.answer[group] = solve_cones(problem, 0.01 * tolerance, kMostSteps);
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    const ConeBody& b = d.bodies[i];
    s.x[b.slot] += b.v.head<3>();
    const Vec3 turn = b.v.tail<3>();
    if (turn != Vec3::Zero()) s.q[b.slot] = normalized(exp_map(turn) * s.q[b.slot]);
  }
}

void begin(World& world, const StepTime&) { gather_groups(world); }

void velocities(World& world, const StepTime& time) { solve_groups(world, time.h, 0); }

void positions(World& world, const StepTime& time) {
  refresh_rotations(world);
  refresh_separations(world);
  part_groups(world, time.h);
  refresh_rotations(world);
  refresh_separations(world);
}

}  // namespace

void gather_groups(World& world) {
  DirectGroups& d = *world.direct;
  gather(world, d);
  order(d);
  place_contacts(d);
  d.answer.resize(d.groups());
}

void solve_groups(World& world, Real h, std::uint64_t work) {
  DirectGroups& d = *world.direct;
  Contacts& c = *world.contacts;
  State& s = world.state;
  const Real tolerance = kDirectShare * world.scene.dials[Dial::velocity_tolerance];
  load_bodies(world, d);
  load_contacts(world, d, h);
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) {
    ConeProblem problem = d.problem(g);
    apply_impulses(problem);
    const bool bounded = work && !starts_from_nothing(problem);
    const std::uint64_t most = bounded ? 2 + work / d.work[g] : kMostSteps;
    const Real goal = d.still[g] ? std::max(kStillShare * tolerance, rounding(problem))
                      : work     ? std::max(tolerance, kShare * fastest(problem))
                                 : tolerance;
    d.answer[g] = solve_cones(problem, goal, static_cast<std::uint32_t>(std::min<std::uint64_t>(most, kMostSteps)));
    start_from_loads(s, problem, d.answer[g].factorisations > 0);
  });
  for (const ConeAnswer& answer : d.answer) {
    world.report.velocity_impulses += answer.factorisations;
    world.report.solver_residual = std::max<double>(world.report.solver_residual, answer.residual);
  }
  for (std::size_t i = 0; i < d.contacts.size(); ++i) {
    Row& row = c.rows[d.row[i]];
    row.p = d.contacts[i].next_p;
    row.u = d.contacts[i].u;
    c.geometry[d.row[i]].impulse += d.contacts[i].p;
  }
  for (const ConeBody& b : d.bodies) {
    const Vec3 v = linear(b.v), omega = angular(b.v);
    world.plan->touched[b.slot] = v != s.v[b.slot] || omega != s.omega[b.slot];
    s.v[b.slot] = v, s.omega[b.slot] = omega;
  }
}

void part_groups(World& world, Real h) {
  DirectGroups& d = *world.direct;
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) { part(world, d, g, h); });
  for (const ConeAnswer& answer : d.answer) world.report.position_moves += answer.factorisations;
}

extern constexpr Solver kDirect = {"direct", false, true, begin, velocities, positions, nullptr};

}  // namespace carom

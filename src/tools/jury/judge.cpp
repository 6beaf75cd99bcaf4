// The verdict on a scene, step by step: each kind of failure, its bound and the first time that it was passed.
#include "jury/judge.h"

#include <algorithm>
#include <cmath>

#include "jury/energy.h"
#include "jury/gaps.h"
#include "jury/jitter.h"

namespace carom::tools::jury {
namespace {

constexpr double kLasting = 1.0 / 6;      // s that a body may be too deep: an impact is over by then
constexpr double kPlainTime = 0.5;        // s after which anybody sees that a body is where it should not be
constexpr double kPlainGain = 5;          // times the limit: a tenth of all energy there was
constexpr double kPlainGap = 3;           // times the limit
constexpr double kPlainThickness = 0.02;  // m: who went through this went through something
constexpr double kStallRatio = 3;         // of the mean of the scene
constexpr double kUnit = 2e-8;            // s: of a support call, an impulse or a move
constexpr double kTornTime = 1;           // s that a joint has to close after its body was moved by a host

bool is_sane(const State& s) {
  const auto bounded = [](const Vec& v) { return v.allFinite() && v.cwiseAbs().maxCoeff() < 1e6; };
  return bounded(s.position) && bounded(s.velocity) && bounded(s.omega) && s.orientation.coeffs().allFinite() &&
         std::fabs(s.orientation.norm() - 1) < 1e-3;
}

/// m: how deep two bodies may be in each other, by the thinner of them.
double depth_limit(const Member& a, const Member& b) { return 0.001 + 0.02 * std::min(a.thickness, b.thickness); }
double plain_depth(const Member& a, const Member& b) { return 5 * depth_limit(a, b); }

/// What goes wrong for a while, and with whom.
enum class Trouble { deep, plainly_deep, within, gape };

}  // namespace

const char* name_of(Kind kind) {
  static constexpr const char* kNames[] = {"fault", "gain", "throw", "gape", "sink", "pass", "stall", "jitter", "task"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* meaning_of(Kind kind) {
  static constexpr const char* kMeanings[] = {"a state that is not finite, or a fault of a shape",
                                              "energy from nowhere",
                                              "faster than fall, throw and paddle can make it",
                                              "a joint that does not hold",
                                              "deep in another for ten steps",
                                              "through another, or below the ground",
                                              "a step that takes far longer than the others",
                                              "to and fro in one place for two seconds",
                                              "what it was built for is not done"};
  return kMeanings[static_cast<std::size_t>(kind)];
}

const Failure* Verdict::of(Kind kind) const {
  for (const Failure& failure : failures)
    if (failure.kind == kind) return &failure;
  return nullptr;
}

struct Judge::Inside {
  carom_engine* engine;
  const Case& c;
  double dt;
  Frame before;
  std::vector<Near> pairs_before;
  std::unique_ptr<Energies> energies;
  Frame at_start;
  double time = 0;             // s, at the end of the step
  std::vector<Drive> drives;   // by link, as the host last set them
  std::vector<double> torn;    // s, by link: until when it may gape
  std::vector<double> misses;  // by goal that asks for once: the least so far
  Jitters jitters;
  std::map<std::tuple<Trouble, std::size_t, std::size_t>, std::size_t> troubles, troubles_before;  // steps in a row
  std::map<Kind, Failure> failures;
  std::array<double, kKinds> worst_ratio{};  // beyond its limit, by kind
  std::vector<bool> over_edge;               // by member: left the hills, whatever is above it now
  std::vector<Cost> costs;
  Reading reading;
  bool over = false;  // a state that is not finite: there is nothing more to judge

  Inside(carom_engine* e, const Case& the_case, double step)
      : engine(e), c(the_case), dt(step), torn(c.links.size(), c.grace), misses(c.goals.size(), HUGE_VAL) {
    for (const Link& link : c.links) drives.push_back(link.drive);
  }

  std::size_t now() const { return costs.size(); }
  const std::string& name(std::size_t i) const { return c.members[i].name; }
  void fail(Kind kind, const std::string& who, double value, double limit, const char* unit, bool plain);
  double lasts(Trouble trouble, std::size_t a, std::size_t b);
  Sets islands(const std::vector<Near>& pairs) const;
  void judge_energy(const Frame& frame, const std::vector<Near>& pairs, const Sets& together);
  void judge_depth(const std::vector<Near>& pairs, const Frame& frame, const std::vector<bool>& stirred);
  void judge_pair_depth(std::size_t a, std::size_t b, double depth, const Frame& frame);
  void judge_passing(const Frame& frame, const std::vector<bool>& stirred);
  void judge_joints(const Frame& frame);
  void judge_jitter(const Frame& frame, const std::vector<bool>& stirred);
  void judge_goals(const Frame& frame);
  std::vector<bool> stirred(const std::vector<Near>& pairs, const Sets& together) const;
  bool are_joined(std::size_t a, std::size_t b) const;
};

/// @return s, for how long a trouble has lasted, this step included; to be asked once in each step in which it is there
double Judge::Inside::lasts(Trouble trouble, std::size_t a, std::size_t b) {
  const auto known = troubles_before.find({trouble, a, b});
  const std::size_t steps = known == troubles_before.end() ? 1 : known->second + 1;
  troubles[{trouble, a, b}] = steps;
  return static_cast<double>(steps) * dt;
}

/// @param plain  whether anybody would see it
void Judge::Inside::fail(Kind kind, const std::string& who, double value, double limit, const char* unit, bool plain) {
  Failure& f =
      failures.emplace(kind, Failure{kind, now(), who, value, limit, unit, 0, now(), who, value}).first->second;
  if (plain && !f.plain_step) f.plain_step = now();
  const double beyond = value / std::max(limit, 1e-12);
  double& most = worst_ratio[static_cast<std::size_t>(kind)];
  if (beyond <= most) return;
  most = beyond;
  f.worst_step = now(), f.worst_who = who, f.worst = value;
}

bool Judge::Inside::are_joined(std::size_t a, std::size_t b) const {
  return std::any_of(c.links.begin(), c.links.end(),
                     [&](const Link& link) { return std::minmax(link.a, link.b) == std::minmax(a, b); });
}

/// Bodies that move and may act on each other in this step.
Sets Judge::Inside::islands(const std::vector<Near>& pairs) const {
  Sets sets(c.members.size());
  for (const Near& near : pairs)
    if (c.members[near.a].moves() && c.members[near.b].moves()) sets.merge(near.a, near.b);
  for (const Link& link : c.links)
    if (c.members[link.a].moves() && c.members[link.b].moves()) sets.merge(link.a, link.b);
  return sets;
}

/// On whom a paddle may act in this step, through others too.
std::vector<bool> Judge::Inside::stirred(const std::vector<Near>& pairs, const Sets& together) const {
  std::vector<bool> sets(c.members.size()), members(c.members.size());
  for (const Near& near : pairs)
    for (const auto& [paddle, body] : {std::pair(near.a, near.b), std::pair(near.b, near.a)})
      if (c.members[paddle].type == CAROM_BODY_KINEMATIC) sets[together.of(body)] = true;
  for (std::size_t i = 0; i < members.size(); ++i) members[i] = sets[together.of(i)];
  return members;
}

void Judge::Inside::judge_energy(const Frame& frame, const std::vector<Near>& pairs, const Sets& together) {
  energies->step(before, frame, pairs, together, drives, dt);
  const std::size_t worst = reading.gainer = energies->worst();
  reading.excess = energies->excess_of(worst), reading.excess_limit = energies->limit(worst);
  reading.given = energies->given();
  if (reading.excess > reading.excess_limit)
    fail(Kind::gain, name(worst), reading.excess, reading.excess_limit, "J",
         reading.excess > kPlainGain * reading.excess_limit);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (!c.members[i].moves() || !frame[i].is_there) continue;
    reading.kinetic += kinetic(c.members[i], frame[i]);
    reading.potential += potential(c.members[i], frame[i], c.gravity);
    const double speed = frame[i].velocity.norm(), limit = energies->speed_limit(i);
    if (speed > reading.speed) reading.speed = speed, reading.fastest = i;
    if (speed > limit) fail(Kind::throws, name(i), speed, limit, "m/s", true);
  }
}

void Judge::Inside::judge_pair_depth(std::size_t a, std::size_t b, double depth, const Frame& frame) {
  const double limit = depth_limit(c.members[a], c.members[b]);
  if (depth > reading.depth) reading.depth = depth, reading.deep_a = a, reading.deep_b = b;
  if (!(depth > limit)) return;
  const std::string who = name(a) + " in " + name(b);
  const bool plain =
      depth > plain_depth(c.members[a], c.members[b]) && lasts(Trouble::plainly_deep, a, b) >= kPlainTime;
  if (lasts(Trouble::deep, a, b) >= kLasting) fail(Kind::sink, who, depth, limit, "m", plain);
  if (!c.members[b].is_heights &&
      (is_within(engine, c, a, b, frame) || (c.members[b].moves() && is_within(engine, c, b, a, frame))))
    fail(Kind::pass, who, depth, limit, "m", lasts(Trouble::within, a, b) >= kPlainTime);
}

/// What a paddle presses on the ground may sink: there is nowhere to go.
void Judge::Inside::judge_depth(const std::vector<Near>& pairs, const Frame& frame,
                                const std::vector<bool>& is_stirred) {
  for (const Near& near : pairs) {
    if (is_stirred[near.a] || is_stirred[near.b] || are_joined(near.a, near.b)) continue;
    const bool a_moves = c.members[near.a].moves();
    judge_pair_depth(a_moves ? near.a : near.b, a_moves ? near.b : near.a, -near.separation, frame);
  }
  if (!c.heights) return;
  std::size_t hills = 0;
  while (!c.members[hills].is_heights) ++hills;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (!c.members[i].moves()) continue;
    const UnderHills under = under_hills(engine, c, i, frame[i]);
    over_edge[i] = over_edge[i] || under.is_beyond;
    if (is_stirred[i] || over_edge[i]) continue;
    if (under.is_through)
      fail(Kind::pass, name(i) + " in hills", under.depth, c.members[i].thickness / 2, "m",
           lasts(Trouble::within, i, hills) >= kPlainTime);
    else
      judge_pair_depth(i, hills, under.depth, frame);
  }
}

/// By centres: what went from one side of another body to the other within the step. Also if it was put there, without
/// speed.
void Judge::Inside::judge_passing(const Frame& frame, const std::vector<bool>& is_stirred) {
  for (std::size_t a = 0; a < frame.size(); ++a)
    for (std::size_t b = 0; b < frame.size() && c.members[a].moves() && !is_stirred[a]; ++b)
      if (b != a && !is_stirred[b] && went_through(engine, c, a, b, before, frame) && !are_joined(a, b))
        fail(Kind::pass, name(a) + " through " + name(b), (frame[a].position - before[a].position).norm(), 0, "m",
             !c.members[b].moves() || c.members[b].thickness > kPlainThickness);
}

void Judge::Inside::judge_joints(const Frame& frame) {
  for (std::size_t k = 0; k < c.links.size(); ++k) {
    const Link& link = c.links[k];
    if (!frame[link.a].is_there || !frame[link.b].is_there || time < torn[k]) continue;
    const double gap = gap_of(c, link, frame), limit = gap_limit(c, link);
    reading.gap = std::max(reading.gap, gap);
    if (!(gap > limit)) continue;
    const bool plain = gap > kPlainGap * limit && lasts(Trouble::gape, link.a, link.b) >= kLasting;
    fail(Kind::gape, name(link.a) + " and " + name(link.b), gap, limit, "m", plain);
  }
}

/// What moves to and fro in one place, by itself.
void Judge::Inside::judge_jitter(const Frame& frame, const std::vector<bool>& is_stirred) {
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (!c.members[i].moves()) continue;
    if (is_stirred[i] || !frame[i].is_there || time < c.grace) {
      jitters.forget(i);
      continue;
    }
    const double shakes = jitters.step(i, c.members[i], frame[i], dt);
    if (shakes > kShakes) fail(Kind::jitter, name(i), shakes, kShakes, "m", shakes > kPlainShakes);
  }
}

void Judge::Inside::judge_goals(const Frame& frame) {
  for (std::size_t k = 0; k < c.goals.size(); ++k) {
    const Goal& goal = c.goals[k];
    if (time < goal.from - dt / 2 || time > goal.until + dt / 2) continue;
    const double miss = goal.missed_by(at_start, frame);
    misses[k] = std::min(misses[k], miss);
    const bool is_last = time > goal.until - dt / 2;
    if (goal.once ? is_last && misses[k] > 0 : miss > 0)
      fail(Kind::task, goal.what, goal.once ? misses[k] : miss, 0, goal.unit,
           (goal.once ? misses[k] : miss) > goal.plain);
  }
}

Judge::Judge(carom_engine* engine, const Case& the_case, double dt) : inside_(new Inside(engine, the_case, dt)) {}
Judge::~Judge() = default;

void Judge::start(const Frame& frame) {
  inside_->before = inside_->at_start = frame;
  inside_->jitters.start(frame.size());
  inside_->over_edge.assign(frame.size(), false);
  inside_->pairs_before = near_pairs(inside_->engine, inside_->c, frame, inside_->dt);
  inside_->energies = std::make_unique<Energies>(inside_->c, inside_->dt, frame);
}

void Judge::begin(double dt, const std::vector<std::size_t>& deeds, const Frame& now) {
  Inside& in = *inside_;
  in.dt = dt;
  if (deeds.empty()) return;
  for (const std::size_t k : deeds) {
    const Deed& deed = in.c.deeds[k];
    if (deed.what == Deed::What::pace) continue;
    if (deed.what == Deed::What::drive) {
      in.drives[deed.who].goal = deed.value;
      for (std::size_t i = 0; i < now.size(); ++i)  // what a host leads to and fro does not shake
        if (in.energies->have_met(i, in.c.links[deed.who].b)) in.jitters.forget(i);
      continue;
    }
    in.jitters.forget(deed.who);
    for (std::size_t i = 0; i < in.c.links.size() && deed.what == Deed::What::put; ++i)
      if (in.c.links[i].a == deed.who || in.c.links[i].b == deed.who) in.torn[i] = in.time + kTornTime;
  }
  in.energies->meddled(in.before, now);
  in.before = now;
  in.pairs_before = near_pairs(in.engine, in.c, now, dt);
}

const Reading& Judge::step(const Frame& frame, const Cost& cost) {
  Inside& in = *inside_;
  in.time += in.dt;
  in.costs.push_back(cost);
  in.reading = Reading{};
  in.troubles_before.swap(in.troubles);
  in.troubles.clear();
  if (cost.faults)
    in.fail(Kind::fault, cost.faulty.empty() ? "a shape or a body" : cost.faulty, static_cast<double>(cost.faults), 0,
            "faults", true);
  for (std::size_t i = 0; i < frame.size() && !in.over; ++i)
    if (!is_sane(frame[i])) in.fail(Kind::fault, in.name(i), 1, 0, "states", true), in.over = true;
  if (in.over) return in.reading;
  const std::vector<Near> pairs = near_pairs(in.engine, in.c, frame, in.dt);
  std::vector<Near> either = in.pairs_before;  // may have acted during the step
  either.insert(either.end(), pairs.begin(), pairs.end());
  const Sets together = in.islands(either);
  const std::vector<bool> is_stirred = in.stirred(either, together);
  in.judge_energy(frame, either, together);
  if (in.time >= in.c.grace) in.judge_depth(pairs, frame, is_stirred);
  in.judge_passing(frame, is_stirred);
  in.judge_joints(frame);
  if (in.c.built) in.judge_jitter(frame, is_stirred);
  in.judge_goals(frame);
  in.before = frame;
  in.pairs_before = pairs;
  return in.reading;
}

void Judge::retime(std::size_t step, double seconds) {
  double& known = inside_->costs.at(step - 1).seconds;
  known = std::min(known, seconds);
}

bool Judge::may_stall() const {
  const Verdict v = verdict();
  return v.worst_seconds > std::max(kStallRatio * v.mean_seconds, inside_->c.least_stall);
}

Verdict Judge::verdict() const {
  Verdict v;
  const Inside& in = *inside_;
  std::size_t worst_work_step = 0;
  for (std::size_t i = 0; i < in.costs.size(); ++i) {
    const Cost& cost = in.costs[i];
    v.seconds.push_back(cost.seconds);
    v.mean_seconds += cost.seconds / static_cast<double>(in.costs.size());
    v.mean_work += cost.work / static_cast<double>(in.costs.size());
    if (cost.seconds > v.worst_seconds) v.worst_seconds = cost.seconds, v.worst_step = i + 1;
    if (cost.work > v.worst_work) v.worst_work = cost.work, worst_work_step = i + 1;
  }
  for (const auto& [kind, failure] : in.failures) v.failures.push_back(failure);
  const double most_seconds = std::max(kStallRatio * v.mean_seconds, in.c.least_stall);
  const double most_work = std::max(kStallRatio * v.mean_work, in.c.least_stall / kUnit);
  if (v.worst_seconds > most_seconds)
    v.failures.push_back({Kind::stall, v.worst_step, "step", 1e3 * v.worst_seconds, 1e3 * most_seconds, "ms",
                          v.worst_step, v.worst_step, "step", 1e3 * v.worst_seconds});
  else if (v.worst_work > most_work)
    v.failures.push_back({Kind::stall, worst_work_step, "step", v.worst_work, most_work, "units of work",
                          worst_work_step, worst_work_step, "step", v.worst_work});
  return v;
}

}  // namespace carom::tools::jury

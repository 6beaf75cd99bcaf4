// References by Carom's own bracket at 1e-13, checked by a sweep that shares no code with it, and the errors of others.
#include "score.h"

#include <algorithm>

#include "collision/narrow/query.h"
#include "random_pairs.h"

namespace carom::bench {

namespace {

/// Largest n . x over a solid, hulls scanned: no climb can be at fault here.
Real reach(const Solid& solid, const Placement& at, const Vec3& unit) {
  Vec3 d, p;
  at.rotate_inverse(unit.data(), d.data());
  solid.scan(nullptr, solid.params, solid.param_count, d.data(), p.data());
  return d.dot(p) + solid.core_radius;
}

double quantile(std::vector<double>& sorted, double q) {
  if (sorted.empty()) return NAN;
  const auto at = static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1) + 0.5);
  return sorted[at];
}

/// The largest bound that any direction gives, as far as looking around can tell: slow and obvious.
double climb(const Query& q, test::Random& random) {
  double most = -HUGE_VAL;
  for (int start = 0; start < 3; ++start) {
    Vec3 best = Vec3::unit_x();
    double value = -HUGE_VAL;
    const auto look = [&](const Vec3& n) {
      const double found = separation_along(q, n);
      if (!(found > value)) return false;
      value = found, best = n.normalized();
      return true;
    };
    for (int k = 0; k < 1000; ++k) look(random.direction());
    // Random steps that shrink when nothing is gained for long; bounds of polytopes rise along narrow ridges.
    int idle = 0;
    for (double step = 0.1; step > 1e-7;) {
      if (look(best + step * random.direction()))
        idle = 0;
      else if (++idle == 300)
        idle = 0, step *= 0.85;
    }
    most = std::max(most, value);
  }
  return most;
}

bool given(const double* v) { return !(std::isnan(v[0]) && std::isnan(v[1]) && std::isnan(v[2])); }

}  // namespace

double separation_along(const Query& q, const Vec3& n) {
  const Real most = n.abs().max_entry();  // scaled first: no square overflows
  const Real length = most > 0 ? most * (n / most).norm() : most;
  if (!(length > 0) || !std::isfinite(length)) return NAN;
  const Vec3 unit = n / length;
  const Vec3 offset(q.at_b.p[0] - q.at_a.p[0], q.at_b.p[1] - q.at_a.p[1], q.at_b.p[2] - q.at_a.p[2]);
  return unit.dot(offset) - reach(*q.b, q.at_b, -unit) - reach(*q.a, q.at_a, unit);
}

std::vector<Reference> references(const Set& set) {
  QuerySettings settings;
  settings.tolerance = 1e-13;
  settings.simplex = Simplex::voronoi;
  settings.gjk_cap = 1000;
  settings.epa_cap = 512;
  std::vector<Reference> found;
  for (const Query& q : set.queries) {
    QueryResult r;
    SupportFault fault;
    generic_distance(*q.a->shape, *q.b->shape, relative(frame_of(q.at_a), frame_of(q.at_b)), settings, nullptr, r,
                     fault);
    found.push_back({0.5 * (r.lower + r.upper), 0.5 * (r.upper - r.lower)});
  }
  return found;
}

SweepCheck sweep(const Set& set, const std::vector<Reference>& reference, int stride) {
  SweepCheck check;
  test::Random random(4000);
  for (std::size_t i = 0; i < set.queries.size(); i += static_cast<std::size_t>(stride)) {
    const double value = climb(set.queries[i], random);
    ++check.queries;
    check.worst_above = std::max(check.worst_above, value - (reference[i].separation + reference[i].half_width));
    check.worst_below = std::max(check.worst_below, reference[i].separation - reference[i].half_width - value);
  }
  return check;
}

bool wrong_verdict(const Answer& answer, double truth, double tolerance) {
  return std::fabs(truth) > tolerance && answer.overlap != (truth < 0);
}

double waste(const Query& query, const Answer& answer, double truth) {
  if (!given(answer.normal)) return 0;
  const double along = separation_along(query, Vec3(answer.normal[0], answer.normal[1], answer.normal[2]));
  return std::isnan(along) ? HUGE_VAL : truth - along;
}

Score score(Peer& peer, const Set& set, const std::vector<Reference>& reference) {
  Score s;
  std::vector<double> errors;
  double calls = 0;
  for (std::size_t i = 0; i < set.queries.size(); ++i) {
    Answer answer;
    peer.ask(i, answer);
    calls += answer.calls;
    const double truth = reference[i].separation;
    const bool wrong = wrong_verdict(answer, truth, 1e-6);
    const double error = std::fabs(answer.separation - truth);
    if (!std::isnan(error)) errors.push_back(error);
    s.verdicts += wrong;
    s.failures += wrong || error > kWrong;
    if (!given(answer.normal)) continue;
    ++s.normals;
    s.wasteful += !(waste(set.queries[i], answer, truth) <= kWaste);
  }
  s.queries = static_cast<int>(set.queries.size());
  s.values = static_cast<int>(errors.size());
  std::sort(errors.begin(), errors.end());
  s.median = quantile(errors, 0.5);
  s.most = quantile(errors, 0.999);
  s.worst = errors.empty() ? NAN : errors.back();
  s.calls = calls / static_cast<double>(std::max(s.queries, 1));
  return s;
}

}  // namespace carom::bench

// The bracket [lower, upper] of the signed distance s* against what a few looks along directions prove.
//
// With s(n) = min over B of n.b - max over A of n.a, s* is the largest s(n) over unit n. So
//   - the reported normal must prove the lower bound itself: s(normal) >= lower. That is all of the lower bound.
//   - no direction may prove more than the upper bound: s(n) <= upper. In overlap nothing shorter than a sweep refutes
//     an upper bound; one along fixed directions, faces and edges of boxes, and uphill from the normal is made.
//   - apart, the witness points prove the upper bound: both in their shapes, no farther from each other than it says.
// Whoever judges rounds, too, and as much as the core does when it looks along a direction:
// collision/narrow/rounding.h.
#include "judge.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "collision/directions.h"
#include "collision/narrow/carry_over.h"
#include "collision/narrow/hybrid.h"
#include "collision/narrow/pair.h"
#include "collision/narrow/rounding.h"

namespace carom::fuzz {
namespace {

constexpr Real kU = kUnitRoundoff;

/// One answer, and all that is needed to judge it.
struct Answer {
  const Shape &a, &b;
  Frame b_in_a;
  QuerySettings settings;
  bool invalid_plugin;
  QueryResult r;
  SupportFault fault;
  Real size = 0;               // m, of the pair
  Real least = 0;              // m, what a tolerance is relative to
  Real radii = 0;              // m, added to the cores: core radii and shells
  bool asked_generic = false;  // GJK answered
  Real shell = 0;              // m, the hybrid's, on both shapes together: a pair that has a routine wears none

  bool known() const { return usable(b_in_a) && r.status != QueryStatus::fault && finite(r.lower); }
  Real width() const { return r.upper - r.lower; }
  Real slack() const { return kBracketRounding * kU * size; }

  /// Lowest n . w over the difference of the shapes, and the point w of the cores that attains it.
  Real along(const Vec3& n, Vec3& w) const {
    const Vec3 n_b = -b_in_a.rotate_inverse(n);
    Vec3 on_a, on_b;
    a.support(a.user, a.params.data(), a.params.size(), n.data(), on_a.data());
    b.support(b.user, b.params.data(), b.params.size(), n_b.data(), on_b.data());
    w = b_in_a.apply(on_b) - on_a;
    return n.dot(w) - radii;
  }
  /// How far a point lies outside the supporting plane of a shape along n.
  static Real outside(const Shape& s, const Vec3& n, const Vec3& x, Real shell) {
    Vec3 on;
    s.support(s.user, s.params.data(), s.params.size(), n.data(), on.data());
    return n.dot(x - on) - s.core_radius - shell;
  }
};

class Judge {
 public:
  explicit Judge(std::uint32_t sweep) : sweep_(sweep) {}
  Verdict verdict;

  void answer(const Answer& x, const char* which);
  /// An answer carried over from another pose: its points are the old ones, moved with the bodies.
  void carried(const Answer& x);
  /// Two brackets of one number, each off by `slack` at most.
  void same(const Answer& x, const Answer& y, Real slack, const char* which);

 private:
  void form(const Answer& x);
  void effort(const Answer& x);
  void half_space(const Answer& x);
  void normal(const Answer& x);
  void witness(const Answer& x);
  void look(const Answer& x, const Vec3& n);
  void sweep(const Answer& x);
  void box_axes(const Answer& x);
  void uphill(const Answer& x);
  [[gnu::format(printf, 3, 4)]] void demand(bool truth, const char* format, ...);

  std::uint32_t sweep_;
  const char* which_ = "";
  const Answer* judged_ = nullptr;
};

void Judge::demand(bool truth, const char* format, ...) {
  if (truth || !verdict.good) return;
  verdict.good = false;
  const int at = std::snprintf(verdict.reason, sizeof verdict.reason, "%s: ", which_);
  va_list rest;
  va_start(rest, format);
  std::vsnprintf(verdict.reason + at, sizeof verdict.reason - static_cast<std::size_t>(at), format, rest);
  va_end(rest);
  if (!judged_) return;
  const QueryResult& r = judged_->r;
  const std::size_t end = std::strlen(verdict.reason);
  std::snprintf(verdict.reason + end, sizeof verdict.reason - end,
                " (status %u, %d + %d iterations, [%.9g, %.9g], asked %.3g)", static_cast<unsigned>(r.status),
                r.gjk_iterations, r.epa_iterations, r.lower, r.upper, judged_->settings.tolerance * judged_->least);
}

/// What holds for every answer, however bad the question was.
void Judge::form(const Answer& x) {
  const QueryResult& r = x.r;
  demand(finite(r.separation) && finite(r.normal) && finite(r.point_a) && finite(r.point_b), "not finite");
  demand(r.lower <= r.upper && r.lower <= r.separation && r.separation <= r.upper, "%.17g not in [%.17g, %.17g]",
         r.separation, r.lower, r.upper);
  demand(std::fabs(r.normal.squared_norm() - 1) <= 64 * kU, "normal of length %.17g", r.normal.norm());
  if (!x.known()) {
    demand(r.lower == -kInfinity && r.upper == kInfinity, "half a bracket [%g, %g]", r.lower, r.upper);
    demand(r.status != QueryStatus::exact_enough, "exact enough about nothing");
    return;
  }
  const Real asked = x.settings.tolerance * x.least;
  const bool narrow = x.width() <= asked || (r.farther && r.lower > x.settings.max_distance * (1 - 4 * kU) - x.slack());
  demand(narrow == (r.status == QueryStatus::exact_enough), "status %u, width %.17g, asked %.17g",
         static_cast<unsigned>(r.status), x.width(), asked);
}

/// Each attempt (there are two) ends at its cap or one look later; starting EPA takes 15 looks at most.
void Judge::effort(const Answer& x) {
  const int gjk = x.r.gjk_iterations, epa = x.r.epa_iterations;
  demand(gjk <= x.settings.gjk_cap + 2 && epa <= x.settings.epa_cap, "%d + %d iterations, caps %d + %d", gjk, epa,
         x.settings.gjk_cap, x.settings.epa_cap);
  demand(x.r.support_calls <= gjk + epa + 32, "%d calls for %d iterations", x.r.support_calls, gjk + epa);
}

/// One of the two is a half-space: its normal is the only direction, and s* is one look away.
void Judge::half_space(const Answer& x) {
  const bool flat_a = x.a.form == Form::half_space;
  const Shape &plane = flat_a ? x.a : x.b, &other = flat_a ? x.b : x.a;
  const Vec3 n = flat_a ? plane.normal : Vec3(x.b_in_a.r * plane.normal);
  const Vec3 down = flat_a ? Vec3(-x.b_in_a.rotate_inverse(n)) : Vec3(-n);
  Vec3 lowest;
  other.support(other.user, other.params.data(), other.params.size(), down.data(), lowest.data());
  const Real height = flat_a ? n.dot(x.b_in_a.apply(lowest)) : n.dot(lowest - x.b_in_a.p);
  const Real s = height - other.core_radius - plane.offset;
  demand(x.r.lower <= s + x.slack() && s - x.slack() <= x.r.upper, "half-space %.17g not in [%.17g, %.17g]", s,
         x.r.lower, x.r.upper);
}

void Judge::normal(const Answer& x) {
  Vec3 w;
  const Real s = x.along(x.r.normal, w);
  demand(s >= x.r.lower - x.slack(), "normal proves %.17g, lower %.17g", s, x.r.lower);
  demand(std::fabs(s - x.r.separation) <= (x.asked_generic ? 0 : x.width()) + x.slack(),
         "normal proves %.17g, separation %.17g", s, x.r.separation);
}

void Judge::witness(const Answer& x) {
  const Vec3 v = x.b_in_a.apply(x.r.point_b) - x.r.point_a;
  const Real along = x.r.normal.dot(v);
  demand(std::fabs(along - x.r.separation) <= x.width() + x.slack(),
         "points %.17g apart along the normal, separation %.17g", along, x.r.separation);
  const Real gap = (v - x.r.separation * x.r.normal).norm();
  // Cores overlap: the points are where the way out ends. A point of the surface that is too low by e at most can be
  // sqrt(e size) aside, where the surface is as curved as the pair is large; and slivers a millionth as wide as long
  // know the height of their points, but not the place, to more than some millionths of their length.
  if (x.r.upper + x.radii < 0 && x.asked_generic && x.r.status == QueryStatus::exact_enough)
    demand(gap <= 2 * std::sqrt((x.width() + x.slack()) * x.size) + 1e-5 * x.size, "points %.17g off the way out", gap);
  // A routine answers with points of a patch: along the normal they are right, across it they need not lie opposite.
  if (x.r.lower + x.radii <= 0 || !x.asked_generic) return;
  // Cores apart: the points of the cores prove the upper bound.
  const Real core = (v + x.radii * x.r.normal).norm();
  demand(core - x.radii <= x.r.upper + x.slack(), "core points %.17g apart, radii %.17g, upper %.17g", core, x.radii,
         x.r.upper);
}

/// One direction: may it prove more than the upper bound? Do the witness points lie on its inner side?
void Judge::look(const Answer& x, const Vec3& n) {
  Vec3 w;
  const Real s = x.along(n, w);
  demand(s <= x.r.upper + x.slack(), "direction (%a, %a, %a) proves %.17g, upper %.17g", n.x(), n.y(), n.z(), s,
         x.r.upper);
  // Whatever lies in the difference is at least s* away, radii taken off.
  demand(x.r.lower <= w.norm() - x.radii + x.slack(), "a point %.17g away, lower %.17g", w.norm() - x.radii, x.r.lower);
  const Vec3 n_b = -x.b_in_a.rotate_inverse(n);
  const Real out_a = Answer::outside(x.a, n, x.r.point_a, 0.5 * x.shell);
  const Real out_b = Answer::outside(x.b, Vec3(n_b / n_b.norm()), x.r.point_b, 0.5 * x.shell);
  const Real allowed = x.slack() + (x.asked_generic ? 0 : x.width());

  demand(out_a <= allowed && out_b <= allowed, "witness points %g and %g outside", out_a, out_b);
}

const std::array<Vec3, kDirections>& directions() {
  static const std::array<Vec3, kDirections> all = asking_directions();
  return all;
}

void Judge::sweep(const Answer& x) {
  if (sweep_ % 128 == 0) {
    for (const Vec3& n : directions()) look(x, n);
    return;
  }
  // 15 is coprime to 256: the first twelve wander over all of them, case by case.
  for (std::uint32_t i = 0; i < 12; ++i) look(x, directions()[(sweep_ + 15 * i) % kDirections]);
}

/// Of two boxes in overlap, one of these fifteen directions is the best there is.
void Judge::box_axes(const Answer& x) {
  const Mat3& r = x.b_in_a.r;
  const auto both = [&](const Vec3& n) {
    look(x, n);
    look(x, Vec3(-n));
  };
  for (int i = 0; i < 3; ++i) {
    both(Vec3::unit(i));
    both(Vec3(r.col(i).normalized()));
    for (int j = 0; j < 3; ++j) {
      const Vec3 c = Vec3::unit(i).cross(r.col(j));
      if (c.squared_norm() > 1e-24) both(c.normalized());
    }
  }
}

/// From the normal, towards the point of the difference found along it: the way along which s(n) grows.
void Judge::uphill(const Answer& x) {
  Vec3 best = x.r.normal, w;
  Real most = x.along(best, w);
  Real step = 1;
  for (int i = 0; i < 8; ++i) {
    const Vec3 across = w - w.dot(best) * best;
    const Real size = across.norm();
    if (!(size > 1e-12 * w.norm())) return;  // nothing across but rounding
    const Vec3 n = (best + step / size * across).normalized();
    look(x, n);
    Vec3 at;
    const Real s = x.along(n, at);
    if (s > most) {
      most = s;
      best = n;
      w = at;
    } else {
      step *= 0.1;
    }
  }
}

void Judge::answer(const Answer& x, const char* which) {
  which_ = which;
  judged_ = &x;
  form(x);
  if (x.invalid_plugin) return;
  demand(x.r.status != QueryStatus::fault, "a valid function was blamed, kind %u", static_cast<unsigned>(x.fault.kind));
  if (!x.known()) return;
  effort(x);
  if (x.a.form == Form::half_space || x.b.form == Form::half_space) return half_space(x);
  if (!x.r.farther) {
    normal(x);
    witness(x);
  }
  sweep(x);
  if (x.a.params.size() == 3 && x.b.params.size() == 3 && sweep_ % 4 == 0) box_axes(x);
  uphill(x);
}

void Judge::carried(const Answer& x) {
  which_ = "carried";
  judged_ = &x;
  form(x);
  normal(x);
  sweep(x);
  uphill(x);
}

void Judge::same(const Answer& x, const Answer& y, Real slack, const char* which) {
  which_ = which;
  judged_ = nullptr;
  if (x.invalid_plugin || !x.known() || !y.known()) return;
  demand(x.r.lower <= y.r.upper + slack && y.r.lower <= x.r.upper + slack, "[%.17g, %.17g] and [%.17g, %.17g]",
         x.r.lower, x.r.upper, y.r.lower, y.r.upper);
}

/// Sizes of the pair. @param shell  m, what both shapes wear together
void measure(Answer& x, Real shell) {
  const Shape &a = x.a, &b = x.b;
  x.shell = shell;
  x.size = x.b_in_a.p.abs().sum() + a.bounding_radius + b.bounding_radius + std::fabs(a.offset) + std::fabs(b.offset) +
           shell;
  x.radii = a.core_radius + b.core_radius + shell;
  const auto radius = [](const Shape& s) { return s.form == Form::half_space ? kInfinity : s.bounding_radius; };
  const bool flat = a.form == Form::half_space || b.form == Form::half_space;
  x.least = flat ? std::min(radius(a), radius(b)) : size_of_pair(a, b, x.b_in_a);
}

Answer ask(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings, QueryMemory* memory,
           bool invalid_plugin) {
  Answer x{a, b, b_in_a, settings, invalid_plugin, {}, {}};
  distance(a, b, b_in_a, settings, memory, x.r, x.fault);
  x.asked_generic = x.r.gjk_iterations > 0;
  const bool routine = settings.routines && pair_entry(a.form, b.form).routine;
  measure(x, x.asked_generic && !routine ? shells(settings) : 0);
  return x;
}

/// What is left of an answer after the pair has moved, where enough is: as true as a fresh one.
void carried(const Answer& before, const Answer& fresh, Real share, Judge& judge) {
  if (before.invalid_plugin || !before.known() || !fresh.known() || !before.asked_generic) return;
  Certificate certificate;
  certify(before.r, before.b_in_a, before.shell, certificate);
  Answer x{before.a, before.b, fresh.b_in_a, fresh.settings, false, {}, {}};
  measure(x, before.shell);
  x.settings.tolerance = share;
  x.settings.max_distance = kInfinity;
  if (!carry_over(x.a, x.b, x.b_in_a, share * x.least, x.shell, certificate, x.r)) return;
  judge.carried(x);
  if (fresh.shell == x.shell) judge.same(x, fresh, x.slack(), "carried against fresh");
}

}  // namespace

Verdict judge(const PairCase& c) {
  const Shape a = make(c.a), b = make(c.b);
  const bool invalid_plugin = c.a.lie != Lie::none || c.b.lie != Lie::none;
  Judge judge(c.sweep);
  QueryMemory memory;
  const bool warm = c.twist == Twist::warm || c.twist == Twist::warm_far;
  const Answer first = ask(a, b, c.b_in_a, c.settings, warm ? &memory : nullptr, invalid_plugin);
  judge.answer(first, "answer");
  QuerySettings other = c.settings;
  const auto again = [&](const char* which, const char* both) {
    const Answer second = ask(a, b, c.b_in_a, other, nullptr, invalid_plugin);
    judge.answer(second, which);
    if (first.shell == second.shell) judge.same(first, second, first.slack(), both);
  };
  switch (c.twist) {
    case Twist::swapped: {
      // The inverse of a rounded rotation is its transpose up to 12 u, its product with the offset rounds by another 3.
      const Frame a_in_b(c.b_in_a.r.transpose(), -(c.b_in_a.r.transpose() * c.b_in_a.p));
      const Answer second = ask(b, a, a_in_b, c.settings, nullptr, invalid_plugin);
      judge.answer(second, "swapped");
      judge.same(first, second, 32 * kU * first.size, "swapped against straight");
      break;
    }
    case Twist::other_simplex:
      other.simplex = static_cast<Simplex>((static_cast<unsigned>(other.simplex) + 1) % 3);
      again("other simplex", "other simplex against first");
      break;
    case Twist::other_tolerance:
      other.tolerance = c.settings.tolerance > 1e-9 ? 1e-12 : 1e-4;
      again("other tolerance", "other tolerance against first");
      break;
    case Twist::other_path:
      other.routines = !other.routines;
      again("other path", "routine against generic");
      break;
    case Twist::warm:
    case Twist::warm_far: {
      const Answer second = ask(a, b, c.next, c.settings, &memory, invalid_plugin);
      judge.answer(second, "warm");
      carried(first, second, c.sweep % 2 ? 0.05 : 4, judge);
      break;
    }
    default:
      break;
  }
  return judge.verdict;
}

}  // namespace carom::fuzz

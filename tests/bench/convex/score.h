// What an answer is worth: the reference of every query, and a library's errors against it.
#pragma once

#include "sets.h"

namespace carom::bench {

/// The best lower bound of the signed distance that a direction gives, from support points alone.
/// @param n  world, any length; @return NaN if n is no direction
double separation_along(const Query& query, const Vec3& n);

struct Reference {
  double separation, half_width;  // m; the truth is within half_width, by Carom's bracket at 1e-13
};
std::vector<Reference> references(const Set& set);

/// The independent check of `references`: directions over the whole sphere, then a climb from the best of them, on
/// every `stride`-th query. No code of the convex core takes part.
struct SweepCheck {
  int queries = 0;
  double worst_above = 0;  // m: the sweep beat the reference's upper bound by that much (rounding, or a lie)
  double worst_below = 0;  // m: the climb ended that far below the reference
};
SweepCheck sweep(const Set& set, const std::vector<Reference>& reference, int stride);

/// A right answer is within this of the truth, and its normal gives away no more.
inline constexpr double kWrong = 1e-3, kWaste = 1e-2;  // m, of bodies of about 1 m

struct Score {
  int queries = 0, values = 0;             // answers with a number
  double median = 0, most = 0, worst = 0;  // m: 50 %, 99.9 %, 100 % of the absolute error where a number was given
  int verdicts = 0;                        // overlap where there is none, or none where there is (beyond 1e-6 m)
  int failures = 0;                        // verdicts, no number where one was due, errors beyond kWrong
  int normals = 0, wasteful = 0;  // answers with a direction; those whose direction gives away more than kWaste
  double calls = 0;               // pairs of support calls a query; 0: not counted
};

/// What a single answer is worth. @param scale  m: of the features, 1 for the random pairs
bool wrong_verdict(const Answer& answer, double truth, double tolerance);
double waste(const Query& query, const Answer& answer, double truth);

Score score(Peer& peer, const Set& set, const std::vector<Reference>& reference);

}  // namespace carom::bench

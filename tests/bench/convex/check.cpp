// Verdict, number and normal of every library, two gaps and two depths of each stack.
#include "check.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "closed_forms.h"
#include "score.h"

namespace carom::bench {

namespace {

/// A mistake of a module costs centimetres; coarse tolerances in float cost millimetres.
constexpr double kSlop = 5e-3;  // m

/// What libraries get wrong where a line through both centres meets both surfaces at right angles.
struct Known {
  const char* name;  // a part of it
  Kind kind;
};
constexpr Known kKnown[] = {
    {"FCL GJK + EPA", Kind::sphere},         {"FCL GJK + EPA", Kind::capsule}, {"FCL GJK + EPA", Kind::ellipsoid},
    {"Bullet f64 GJK + EPA", Kind::capsule}, {"parry", Kind::capsule},         {"PhysX f32 GJK query", Kind::ellipsoid},
};
bool known(const std::string& name, Kind kind) {
  return std::any_of(std::begin(kKnown), std::end(kKnown),
                     [&](const Known& k) { return k.kind == kind && name.find(k.name) != std::string::npos; });
}

std::string complaint(const Query& query, const Answer& answer, double gap) {
  if (answer.overlap != (gap < 0)) return answer.overlap ? "overlap" : "no overlap";
  if (std::isnan(answer.separation)) return "";  // yes or no is all it tells of such a pair
  if (!(std::fabs(answer.separation - gap) <= kSlop)) return std::to_string(answer.separation) + " m";
  return waste(query, answer, gap) <= kWaste ? "" : "another normal";
}

}  // namespace

int check(const Peers& peers) {
  int wrong = 0;
  for (const Stack& stack : stacks())
    for (const double gap : {0.2, 0.01, -0.01, -0.05}) {
      const Query query{&stack.upper.solid, &stack.lower.solid, stack.upper_at(gap, 0.3), stack.lower_at(-0.5)};
      for (const std::unique_ptr<Peer>& peer : peers) {
        if (peer->lacks(*query.a) || peer->lacks(*query.b)) continue;
        Answer answer;
        peer->prepare(&query, 1);
        peer->ask(0, answer);
        const std::string said = complaint(query, answer, gap);
        if (said.empty()) continue;
        const bool as_ever = known(peer->name(), query.a->kind);
        std::printf("%s: two of %s, %g m apart: %s%s\n", peer->name(), kKinds[static_cast<int>(query.a->kind)], gap,
                    said.c_str(), as_ever ? " (known)" : "");
        wrong += !as_ever;
      }
    }
  return wrong;
}

}  // namespace carom::bench

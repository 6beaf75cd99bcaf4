// Is an answer about a pair valid? Looked at from outside, through the support functions alone.
#pragma once

#include "pair_case.h"

namespace carom::fuzz {

struct Verdict {
  bool good = true;
  char reason[480] = "";  // of a violation: what was claimed, and what refutes it
};

/// Ask the question of a case and its twist, and judge every answer and how they agree.
Verdict judge(const PairCase& c);

}  // namespace carom::fuzz

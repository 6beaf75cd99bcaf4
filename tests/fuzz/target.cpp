// The two targets, and what a fuzzer that knows only crashes makes of a verdict.
#include "target.h"

#include <cstdio>
#include <cstdlib>

#include "cast_case.h"

namespace carom::fuzz {

std::unique_ptr<Target> pair_target() { return std::make_unique<TargetOf<PairCase>>(); }
std::unique_ptr<Target> cast_target() { return std::make_unique<TargetOf<CastCase>>(); }

void judge_or_abort(Target& target, const std::uint8_t* bytes, std::size_t size) {
  target.take(bytes, size);
  const Verdict verdict = target.verdict();
  if (verdict.good) return;
  std::fprintf(stderr, "VIOLATION %s\n%s\n", verdict.reason, target.line().c_str());
  std::abort();
}

}  // namespace carom::fuzz

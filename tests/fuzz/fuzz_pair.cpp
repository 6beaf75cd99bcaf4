// libFuzzer's target: bytes to a pair, and abort with a reproducer where an answer is dishonest.
#include <cstdio>
#include <cstdlib>

#include "judge.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static carom::fuzz::PairCase c;
  carom::fuzz::decode(bytes, size, c);
  const carom::fuzz::Verdict verdict = carom::fuzz::judge(c);
  if (!verdict.good) {
    std::fprintf(stderr, "VIOLATION %s\n%s\n", verdict.reason, carom::fuzz::to_text(c).c_str());
    std::abort();
  }
  return 0;
}

// libFuzzer's target for sequences of calls.
#include <cstdio>
#include <cstdlib>

#include "calls.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const carom::fuzz::Heard heard = carom::fuzz::run_calls(bytes, size, false);
  if (heard.complaint.empty()) return 0;
  std::fprintf(stderr, "VIOLATION %s\n%s", heard.complaint.c_str(),
               carom::fuzz::run_calls(bytes, size, true).trace.c_str());
  std::abort();
}

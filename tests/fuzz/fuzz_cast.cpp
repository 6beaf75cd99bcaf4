// libFuzzer's target for casts.
#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::unique_ptr<carom::fuzz::Target> target = carom::fuzz::cast_target();
  carom::fuzz::judge_or_abort(*target, bytes, size);
  return 0;
}

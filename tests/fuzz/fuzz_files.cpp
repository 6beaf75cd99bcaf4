// libFuzzer's target for files of one format: CAROM_FUZZ_FORMAT, as fuzz_gltf, fuzz_ply and so on.
#include <cstdio>
#include <cstdlib>

#include "files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto heard =
      carom::fuzz::read_as(carom::fuzz::FileFormat::CAROM_FUZZ_FORMAT, {reinterpret_cast<const char*>(bytes), size});
  if (heard.violation.empty()) return 0;
  std::fprintf(stderr, "VIOLATION %s\n", heard.violation.c_str());
  std::abort();
}

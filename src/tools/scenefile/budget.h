// What reading a file may take: memory in proportion to what was read, so that a small file can't ask for a large machine.
#pragma once

#include <cstdint>

#include "host/files.h"
#include "host/host.h"

namespace carom::tools::scenefile {

class Budget {
 public:
  /// Bytes of the file, or of one that it refers to, have been read: what may be made of them grows.
  void earn(std::size_t bytes) { read_ += bytes; }

  /// To be called before memory is taken.   @param count, each  elements, bytes of one   @param for_what  "nodes"
  /// @throws Error
  void charge(std::uint64_t count, std::uint64_t each, const std::string& for_what) {
    const FileLimits& limits = file_limits();
    const std::uint64_t all = limits.always + limits.factor * std::uint64_t(read_);
    if (each != 0 && count > (all - spent_) / each)
      throw Error(for_what + ": the file asks for more than " + std::to_string(all >> 20) + " MiB, " +
                      std::to_string(limits.factor) + " bytes for each that was read of it and " +
                      std::to_string(limits.always >> 20) + " MiB",
                  "make the file smaller, or raise the limit: --file-factor N");
    spent_ += count * each;
  }

 private:
  std::uint64_t read_ = 0, spent_ = 0;  // bytes
};

}  // namespace carom::tools::scenefile

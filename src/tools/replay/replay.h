// A recorded session (carom/record.h), done again: does the same come out, and where does it part if not?
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/host.h"

namespace carom::tools::replay {

/// Where a replay is no longer what was recorded.
struct Parting {
  std::uint64_t step = 0;               ///< of the world's steps, the first whose outcome is another
  std::vector<std::string> calls;       ///< since the step before it, in order; the last eight of them
  std::string sections;                 ///< what differs then: "bodies, pairs"; empty: the states were not recorded
  std::uint64_t first = 0, second = 0;  ///< a body of the replayed world; the two colliders of a pair; 0: none
  std::vector<std::string> details;     ///< what was recorded of it and what came out, one line each
  std::string refused;                  ///< or a call that went well then is refused now: why
};

struct Outcome {
  std::uint64_t steps = 0, calls = 0;  ///< made again
  bool ended = false;                  ///< the recording was ended, not cut off
  std::optional<Parting> parting;
};

/// @param engine  with every plugin that the recording names
/// @param watch   if given, called with the world after each step
/// @throws Error: it is no recording, damaged within a record, or of plugins that are not loaded
Outcome play(carom_engine* engine, const std::vector<std::byte>& recording,
             const std::function<void(carom_world*, std::uint64_t step)>& watch = {});

std::vector<std::byte> read_file(const std::string& path);  ///< @throws Error

/// A recording that goes to a file.
class FileRecorder {
 public:
  /// Begin.   @throws Error
  FileRecorder(const World& world, const std::string& path, bool states);
  ~FileRecorder();
  FileRecorder(const FileRecorder&) = delete;
  FileRecorder& operator=(const FileRecorder&) = delete;
  void end();  ///< @throws Error: not all of it was written

 private:
  carom_world* world_;
  std::string path_;
  std::FILE* file_;
};

}  // namespace carom::tools::replay

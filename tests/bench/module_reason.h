// A peer that could not be built leaves word where its module would be (peers_cargo/build_peer.cmake).
#pragma once

#include <fstream>
#include <string>

namespace carom::bench {

/// Why there is no module at a path; empty: there is one.
inline std::string reason_missing(const std::string& path) {
  std::string reason;
  std::ifstream word(path + ".reason");
  if (word) std::getline(word, reason);
  if (reason.empty() && !std::ifstream(path)) reason = "it was not built";
  return reason;
}

}  // namespace carom::bench

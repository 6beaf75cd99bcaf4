// A folder of files, and some that are made in memory, for browsers on this machine alone.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace carom::tools::serve {

using Question = std::multimap<std::string, std::string>;  ///< what stands behind the ? of an address

struct Site {
  std::string folder;                           ///< what lies below it is served; "/" is its index.html
  std::map<std::string, std::string> in_place;  ///< path ("/scenes/index.json") -> content, instead of the folder's
  /// Responses to "/scenes/make", one at a time; an Error is told to whoever asks. Asked by the page itself alone.
  std::function<std::string(const Question&)> make;
};

/// Serve until SIGINT or SIGTERM comes. Binds 127.0.0.1; serves requests that name this machine as their host, so that
/// no page of another site can read along under a name of its own.
/// @param port   0: any that is free
/// @param ready  called with the port once connections are taken; nothing is served before
/// @throws Error: the port is taken; this build has no HTTP library (then what to install)
void run(const Site& site, std::uint16_t port, const std::function<void(std::uint16_t)>& ready);

}  // namespace carom::tools::serve

// Loads peers that can't be linked into the program.
#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "peer.h"

namespace carom::bench {

void add_module(Peers& peers, const char* path) {
  void* const object = dlmopen(LM_ID_NEWLM, path, RTLD_NOW | RTLD_LOCAL);
  if (!object) throw std::runtime_error(dlerror());
  void* const symbol = dlsym(object, "carom_bench_peer");
  if (!symbol) throw std::runtime_error(std::string(path) + " exports no carom_bench_peer");
  const auto make = reinterpret_cast<PeerModule>(symbol);
  for (int i = 0; Peer* const peer = make(i); ++i) peers.emplace_back(peer);
}

}  // namespace carom::bench

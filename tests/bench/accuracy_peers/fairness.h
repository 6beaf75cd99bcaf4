// Is every engine told the same? Free fall, mass, inertia, friction, bounce and a joint, each against its closed form.
#pragma once

#include <string>
#include <vector>

#include "peer_mover.h"

namespace carom::bench {

/// @return  a sentence for each that an engine does not answer as it must; empty: it is set up right
std::vector<std::string> unfair(tools::Engine& engine, const PeerEngine& peer);

}  // namespace carom::bench

// At which settings other engines run: as they come, and over their own dials.
#pragma once

#include "peer_mover.h"

namespace carom::bench {

struct PeerSetting {
  std::string name;
  std::vector<NamedDial> dials;
  bool (*takes)(const std::string& scene) = nullptr;  // null: all that are made of what every engine has
};
/// @param engine  the name that its module gives, "Bullet 3.24 (double)"
std::vector<PeerSetting> settings_of(const std::string& engine);
std::string note_on(const std::string& engine);

/// Scenes of boxes, balls, half-spaces and ball joints, which every engine has, and of capsules, cylinders, cones and
/// sliders: what an engine lacks it refuses, and is left out.
const std::vector<std::string>& scenes_for_peers();
/// Whether joints are all there is in one of them.
bool is_of_joints_alone(const std::string& scene);

}  // namespace carom::bench

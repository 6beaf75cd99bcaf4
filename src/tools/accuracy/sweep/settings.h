// Which settings of Carom a sweep tries on which scenes: one table, and what each scene has that makes a setting
// matter.
#pragma once

#include <string>
#include <vector>

#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

/// What a scene has in it, so that a setting matters to it or does not; values are bits of a set.
enum Trait : unsigned {
  kBounces = 1,  ///< impacts with restitution
  kTouches = 2,  ///< contacts that last: slides, stacks
  kJoined = 4,   ///< joints
  kFlies = 8,    ///< bodies in free flight
  kTurns = 16,   ///< bodies with unlike moments of inertia that turn about changing axes
  kSolved = 32,  ///< problems for the direct solver alone, which says how well it solved them
  kAny = 31
};

/// How a sweep treats a scene.
struct SceneTraits {
  unsigned has = kAny;
  double seconds = 0;  ///< simulated at most, where the scene asks for minutes; 0: what it asks for
};
SceneTraits traits_of(const Challenge& challenge);

/// Headings of a report, in their order; and that which a scene stands under.
const std::vector<std::string>& topics();
std::string topic_of(const Challenge& challenge);

/// A line of a work-precision diagram.
struct Setting {
  std::string name;                ///< "auto, 4 substeps"
  std::vector<std::string> dials;  ///< "solver=auto"
  unsigned matters_to = kAny;      ///< scenes that have any of these
};
/// Among them the library's own defaults, called kDefaultSetting.
const std::vector<Setting>& carom_settings();
inline constexpr const char* kDefaultSetting = "auto, 4 substeps";
/// The preset that a setting of the table is; "" for others.
std::string preset_of(const std::string& setting);
/// What `carom accuracy run SCENE` takes to run so: "--dial solver=auto --dial substeps=1"; "" for what is not in the
/// table.
std::string options_of(const std::string& setting);

/// Steps of a sweep, s, from 1/30 to 1/960.
const std::vector<double>& sweep_steps();

}  // namespace carom::tools::accuracy

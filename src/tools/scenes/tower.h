// Does what was built still stand? Told from poses alone, so that any engine's can be asked.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// What became of the actors of kind "block", boxes that stood one on the other at the start.
struct Standing {
  std::size_t blocks = 0;
  std::size_t fallen = 0;  ///< sank or strayed by more than half their least edge and 1 % of the height they stood at
  double drop = 0;         ///< m, the most that a block sank
  double drift = 0;        ///< m, the most that a block strayed sideways
};

/// The 1 % is for a tower that settles: its height is the sum of its joints.
/// @param positions  [actors] m, world, of the stage's actors in order; a block without a finite one has fallen
Standing standing(const Stage& stage, const std::vector<Vec>& positions);
/// As the stage's world has them now.
Standing standing(const Stage& stage);

/// Watches towers: when did the first block fall, and how far did they settle?
class TowerStory : public Observer {
 public:
  void watch(const Stage& stage, double time) override;
  std::vector<std::string> tell(const Stage& stage) const override;
  bool came_off(const Stage& stage) const override { return standing(stage).fallen == 0; }

 private:
  double fell_at_ = -1, next_look_ = 0;
};

}  // namespace carom::tools

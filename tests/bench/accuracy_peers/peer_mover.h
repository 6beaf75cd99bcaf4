// Another engine as the mover of an accuracy scene: it gets the bodies of the filled stage, and after each step its
// poses and velocities are written into the stage's own world, which is never stepped, so that the scene's trial judges
// them as it judges Carom's.
#pragma once

#include "../s_table/engines.h"
#include "accuracy/run.h"

namespace carom::bench {

struct NamedDial {
  std::string name;
  double value;
};

class PeerMover : public tools::accuracy::Mover {
 public:
  /// @throws Error if the stage has what not every engine has, or if this engine refuses it (CAROM_E_UNSUPPORTED)
  PeerMover(tools::Stage& stage, const PeerEngine& engine, const std::vector<NamedDial>& dials);
  void push(const tools::Stage& stage, const tools::accuracy::Push& push) override;
  void step(tools::Stage& stage, double dt) override;
  double seconds_elsewhere() const override { return world_->seconds_elsewhere(); }
  bool show(tools::Stage& stage) override;

 private:
  Plan plan_;
  std::unique_ptr<PeerWorld> world_;
  std::vector<BodyState> states_;
  std::vector<carom_body> moved_;  // dynamic bodies, and where they stand among the actors
  std::vector<std::size_t> places_;
  std::vector<double> poses_, velocities_;
};

}  // namespace carom::bench

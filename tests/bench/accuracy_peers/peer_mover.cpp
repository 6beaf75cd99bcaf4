// Bodies out of a stage, states back into it.
#include "peer_mover.h"

#include <cmath>

namespace carom::bench {

PeerMover::PeerMover(tools::Stage& stage, const PeerEngine& engine, const std::vector<NamedDial>& dials)
    : plan_(stage, true), states_(stage.actors.size()) {
  std::vector<PeerDial> list;
  for (const NamedDial& dial : dials) list.push_back({dial.name.c_str(), dial.value});
  WorldPlan world = plan_.world(false);
  world.dials = list.data(), world.dial_count = list.size();
  world_.reset(engine.make(world));
  if (!world_)
    throw tools::Error(std::string(engine.name) + " can't build this scene", "leave it to the others",
                       CAROM_E_UNSUPPORTED);
  for (std::size_t i = 0; i < stage.actors.size(); ++i)
    if (stage.actors[i].type == CAROM_BODY_DYNAMIC) moved_.push_back(stage.actors[i].body), places_.push_back(i);
  poses_.resize(7 * moved_.size()), velocities_.resize(6 * moved_.size());
}

void PeerMover::push(const tools::Stage&, const tools::accuracy::Push& push) {
  world_->push(push.actor, push.force.data());
}

void PeerMover::step(tools::Stage&, double dt) { world_->step(dt); }

bool PeerMover::show(tools::Stage& stage) {
  world_->read(states_.data());
  plan_.to_body_frames(states_);
  for (std::size_t k = 0; k < moved_.size(); ++k) {
    const BodyState& s = states_[places_[k]];
    const double length = std::sqrt(s.orientation[0] * s.orientation[0] + s.orientation[1] * s.orientation[1] +
                                    s.orientation[2] * s.orientation[2] + s.orientation[3] * s.orientation[3]);
    for (int i = 0; i < 3; ++i) {
      poses_[7 * k + i] = s.position[i];
      velocities_[6 * k + i] = s.velocity[i], velocities_[6 * k + 3 + i] = s.omega[i];
    }
    for (int i = 0; i < 4; ++i) poses_[7 * k + 3 + i] = s.orientation[i] / length;  // floats are off by 1e-7
  }
  carom_world* world = stage.world.get();
  // What the library refuses is not finite, or so far away that nothing can be said of it.
  return carom_world_write(world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, moved_.data(), moved_.size(), poses_.data(), 0,
                           nullptr) == CAROM_OK &&
         carom_world_write(world, CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, moved_.data(), moved_.size(),
                           velocities_.data(), 0, nullptr) == CAROM_OK;
}

}  // namespace carom::bench

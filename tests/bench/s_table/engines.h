// The engines of a comparison: Carom through its public headers, others from their modules, behind one interface.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plan.h"
#include "scenes.h"

namespace carom::bench {

/// A scene to be run, as the scene library knows it.
struct SceneChoice {
  std::string scene;
  tools::Settings settings;
};

class CaromWorld : public PeerWorld {
 public:
  CaromWorld(tools::Engine& engine, const SceneChoice& choice, const std::vector<std::string>& dials);
  void step(double dt) override { stage_.world.step(dt); }
  void read(BodyState* states) const override;
  std::size_t contact_points() const override { return stage_.world.report().contact_points; }
  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    cast_rays(ends, n, fractions, 0);
    return true;
  }
  /// @param flags  CAROM_ASK_*
  void cast_rays(const double* ends, std::size_t n, double* fractions, std::uint32_t flags);
  carom_step_report report() const { return stage_.world.report(); }

 private:
  tools::Stage stage_;
};

/// Allocator callbacks that count.
carom_engine_desc counted_engine();
std::size_t carom_live_bytes();

/// Load a module into a link namespace of its own: the two Bullets bear the same names.
/// @throws Error with what the loader said
PeerEngine load_engine(const char* path);

}  // namespace carom::bench

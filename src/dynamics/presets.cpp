// The table of presets. Where each lies on the front: src/tools/accuracy/README.md.
#include "dynamics/presets.h"

namespace carom::dynamics {
namespace {

constexpr const char* kNames[] = {"fast", "balanced", "accurate", "reference"};

struct PresetRow {
  Dial dial;
  Real fast, accurate, reference;  // balanced: the dial's initial value
};
// Choices, as dials.cpp numbers them.
constexpr Real kAuto = 3, kBySize = 1, kDouble = 2, kVerlet = 3, kSplitting = 5, kSplitting4 = 6, kSplitting6 = 7;
constexpr PresetRow kPresetRows[] = {
    {Dial::integrator, kVerlet, kVerlet, kVerlet},
    {Dial::rotation, kSplitting, kSplitting4, kSplitting6},
    {Dial::joint_order, 2, 4, 6},
    {Dial::substeps, 1, 8, 32},
    {Dial::solver, kAuto, kAuto, kAuto},
    {Dial::precision, kBySize, kDouble, kDouble},
    {Dial::velocity_tolerance, 1e-3, 1e-6, 1e-9},
    {Dial::direct_work, 2e4, 2e4, 1e6},  // a tolerance of 1e-9 takes many rounds in each substep
    {Dial::restitution_speed, 0.25, 0.05, 0.01},
    {Dial::contact_frequency, 30, 120, 480},
    {Dial::direct_sink, 1e-3, 6.25e-5, 3.9e-6},
    {Dial::keep_distance, 3e-3, 2e-4, 0},
    {Dial::gjk_tolerance, 1e-4, 1e-8, 1e-12},
};

}  // namespace

const char* name_of(Preset preset) { return kNames[static_cast<std::size_t>(preset)]; }

std::optional<Real> preset_value(Preset preset, Dial dial) {
  for (const PresetRow& row : kPresetRows) {
    if (row.dial != dial) continue;
    switch (preset) {
      case Preset::fast:
        return row.fast;
      case Preset::accurate:
        return row.accurate;
      case Preset::reference:
        return row.reference;
      default:
        return dial_table()[static_cast<std::size_t>(dial)].initial;
    }
  }
  return std::nullopt;
}

}  // namespace carom::dynamics

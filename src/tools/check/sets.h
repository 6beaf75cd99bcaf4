// Directions and parameter sets that a plugin is tried with.
#pragma once

#include <carom/plugin.h>

#include <array>
#include <vector>

namespace carom::tools {

using Direction = std::array<double, 3>;

/// Unit directions: axes, diagonals, tilts of 1e-3 and 1e-9 off the axes, then uniform ones up to `count`.
std::vector<Direction> trial_directions(std::size_t count);

/// Whether parameters fulfil what a plugin declares of several of them together.
bool keeps_rules(const carom_shape_plugin& plugin, const std::vector<double>& params);

/// Parameter sets within the bounds that keep the rules: ones, then log-uniform over the sizes that scenes use (1e-3 to 1e3), then the
/// bounds themselves. Deterministic.
/// @param ordinary  out: how many of the sets, from the front, are of ordinary size
std::vector<std::vector<double>> trial_params(const carom_shape_plugin& plugin, std::size_t* ordinary);

}  // namespace carom::tools

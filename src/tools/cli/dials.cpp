// `carom dials`: the library's own table of dials: name, default, bounds or choices, and what each trades. After it
// presets, and the numbers that are no dials.
#include <cstdio>

#include "cli/commands.h"
#include "cli/table.h"

namespace carom::tools {
namespace {

std::string value_text(const carom_dial_info& dial, double value) {
  return dial.choice_count ? dial.choices[static_cast<std::uint32_t>(value)] : format("%g", value);
}

std::string bounds_text(const carom_dial_info& dial) {
  if (!dial.choice_count) return format("%g..%g", dial.min, dial.max);
  std::string text;
  for (std::uint32_t i = 0; i < dial.choice_count; ++i) text += (i ? "|" : "") + std::string(dial.choices[i]);
  return text;
}

/// What presets set, dial by dial; where each lies on the front: src/tools/accuracy/README.md.
void print_presets() {
  std::vector<std::vector<std::string>> rows = {{"preset"}};
  for (const std::string& name : all_presets()) rows[0].push_back(name);
  for (const carom_dial_info& dial : all_dials()) {
    std::vector<std::string> row = {dial.name};
    for (std::uint32_t preset = 0; preset < CAROM_PRESET_COUNT; ++preset) {
      double value = 0;
      if (carom_preset_get_dial(preset, dial.dial, &value, nullptr) == CAROM_OK) row.push_back(value_text(dial, value));
    }
    if (row.size() > 1) rows.push_back(row);
  }
  std::printf("%s\nSet one with: carom run SCENE --preset fast\n", table(rows).c_str());
}

/// Fixed numbers: each with two lines of prose, so no table.
void print_constants() {
  std::printf("\nConstants: fixed, each for a reason.\n\n");
  for (const carom_constant_info& c : all_constants())
    std::printf("%s = %g%s%s\n    %s\n    If it moves: %s\n", c.name, c.value, std::string(c.unit) == "1" ? "" : " ",
                std::string(c.unit) == "1" ? "" : c.unit, c.reason, c.consequence);
}

void print_dials() {
  std::vector<std::vector<std::string>> rows = {{"dial", "default", "unit", "bounds or choices", "what it trades"}};
  for (const carom_dial_info& dial : all_dials())
    rows.push_back({dial.name, value_text(dial, dial.initial), dial.unit, bounds_text(dial), dial.summary});
  std::printf("%s\nSet one with: carom run SCENE --dial name=value\n\n", table(rows).c_str());
  print_presets();
  print_constants();
}

}  // namespace

void add_dials_command(CLI::App& app, Context&) {
  app.add_subcommand("dials", "List every dial of a world: default, bounds, what it trades; and what is fixed, and why")
      ->callback(print_dials);
}

}  // namespace carom::tools

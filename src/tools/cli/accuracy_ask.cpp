// `carom accuracy ask`: what is got of what is asked for, and at which cost.
#include "cli/accuracy_ask.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "accuracy/ask.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "host/drawings.h"

namespace carom::tools {
namespace {

using accuracy::Challenge;
using accuracy::Got;
using accuracy::Mixed;

struct AskOptions {
  std::vector<std::string> scenes;
  std::vector<double> tolerances = {1e-2, 1e-3, 1e-4, 1e-5};
  double patience = 20;
  std::string svg;
};

double median(std::vector<double> of) {
  if (of.empty()) return std::nan("");
  std::sort(of.begin(), of.end());
  return of[of.size() / 2];
}

void print_got(const std::vector<Got>& all) {
  std::vector<std::vector<std::string>> rows = {{"scene", "what", "asked/s", "asked", "got", "got/asked", "ms/s",
                                                 "fixed ms/s", "cost ratio", "cheapest fixed that errs no more"}};
  std::vector<double> shares, costs;
  for (const Got& g : all) {
    const bool has_rival = g.fixed_ms > 0;
    rows.push_back({g.scene, g.what + ", " + g.unit, format("%.0e", g.tolerance), format("%.1e", g.asked),
                    format("%.1e", g.got), format("%.2g", g.got / g.asked), format("%.2g", g.ms),
                    has_rival ? format("%.2g", g.fixed_ms) : "", has_rival ? format("%.2f", g.ms / g.fixed_ms) : "",
                    has_rival ? g.fixed : "none"});
    shares.push_back(g.got / g.asked);
    if (has_rival) costs.push_back(g.ms / g.fixed_ms);
  }
  std::printf("%s", table(rows, {false, false, true, true, true, true, true, true, true}).c_str());
  const auto over = [&](double bound) {
    return std::count_if(shares.begin(), shares.end(), [&](double s) { return s > bound; });
  };
  std::printf("\ngot over asked: median %.2g; over 3 in %td, over 10 in %td of %zu\n", median(shares), over(3),
              over(10), shares.size());
  std::printf("cost over the cheapest fixed setting that errs no more: median %.2f, at worst %.1f, of %zu\n",
              median(costs), costs.empty() ? std::nan("") : *std::max_element(costs.begin(), costs.end()),
              costs.size());
}

void print_mixed(const Mixed& m) {
  std::printf(
      "mixed scene at %.0e: linkage alone %.3g ms/s, with a pile at rest and a flying top %.3g ms/s: %.2f of it\n"
      "  substeps a step, mean: linkage %.1f, pile %.1f, top %.1f; the linkage's for all: %.3g ms/s\n",
      m.tolerance, m.linkage_ms, m.all_ms, m.all_ms / m.linkage_ms, m.linkage_substeps, m.pile_substeps, m.top_substeps,
      m.all_fixed_ms);
}

void ask(const AskOptions& options, Context& context) {
  for (const double t : options.tolerances)
    if (!(t > 0 && t <= 1e6))
      throw Error("--tolerance is out of range", "give m and rad per second of motion, more than 0");
  std::vector<const Challenge*> scenes;
  const std::vector<const Challenge*> askable = accuracy::scenes_to_ask();
  for (const std::string& name : options.scenes) {
    if (name == "mixed") continue;
    scenes.push_back(&accuracy::find_challenge(name));
    if (std::find(askable.begin(), askable.end(), scenes.back()) != askable.end()) continue;
    std::string names = "mixed";
    for (const Challenge* challenge : askable) names += ", " + challenge->scene.name;
    throw Error("scene " + name + " has no place or turn whose truth is known", "ask one of " + names);
  }
  if (options.scenes.empty()) scenes = askable;
  const bool mixes = options.scenes.empty() ||
                     std::find(options.scenes.begin(), options.scenes.end(), "mixed") != options.scenes.end();
  if (!mixes && !options.svg.empty()) throw Error("--svg draws the scene mixed", "add mixed to the scenes");
  if (!options.svg.empty()) check_drawing_path(options.svg);
  Engine engine(context.plugins());
  std::vector<Got> all;
  ShareOfProgress share(scenes.size() + (mixes ? 1 : 0));
  for (const Challenge* challenge : scenes) {
    share.begins(challenge->scene.name);
    for (Got& g : accuracy::ask(engine, *challenge, options.tolerances, options.patience)) all.push_back(std::move(g));
  }
  if (mixes) share.begins("mixed");
  share.clear();
  if (!all.empty()) print_got(all);
  bool is_drawn = options.svg.empty();
  for (const double t : options.tolerances) {
    if (!mixes) break;
    const Mixed mixed = accuracy::ask_mixed(engine, t, 3);
    print_mixed(mixed);
    if (!is_drawn) write_drawing(options.svg, accuracy::draw_mixed(mixed)), is_drawn = true;
  }
}

}  // namespace

void add_ask_command(CLI::App& command, Context& context) {
  const auto options = std::make_shared<AskOptions>();
  CLI::App* ask_command = command.add_subcommand(
      "ask", "Ask for accuracies: what is got of them, and what that costs beside fixed substeps");
  ask_command->add_option("SCENE", options->scenes,
                          "Which scenes, and mixed: a pile, a linkage and a top; default: all of both");
  ask_command->add_option("--tolerance", options->tolerances, "m and rad per second of motion, repeatable")
      ->type_name("X");
  ask_command->add_option("--patience", options->patience, "Runs that compute for longer are left out")
      ->type_name("S")
      ->capture_default_str();
  ask_command->add_option("--svg", options->svg, "A drawing of what the islands of mixed take, at the first tolerance")
      ->type_name("FILE");
  ask_command->footer(
      "Scenes whose error is a place or a turn and whose truth is known. The tolerance that is set is the option's times the "
      "duration.");
  ask_command->callback([options, &context] { ask(*options, context); });
}

}  // namespace carom::tools

// The results of the 2011 paper that this engine grew from, measured again: one function a figure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/measure.h"
#include "report/page.h"

namespace carom::report {

/// What a figure needs to run.
struct PaperRun {
  tools::Engine& engine;
  bool quick = false;     ///< smaller N and shorter runs: shapes of curves, not their ends
  std::string mesh_path;  ///< the bunny; "": the default search
  /// Told before and during each run: what runs, and how far it is (0..1).
  std::function<void(const std::string& what, double done)> progress;
};

/// How bodies meet, which the paper leaves open: in one walled heap, where nearly all touch in the end, or spread out
/// over the ground in small heaps that never meet.
struct Crowd {
  const char* label;
  tools::Settings (*settings)(double n);
};
inline constexpr Crowd kHeap = {"one heap", [](double n) { return tools::Settings{{{"n", n}}, ""}; }};
inline constexpr Crowd kSpread = {"spread out", [](double n) {
                                    return tools::Settings{{{"n", n}, {"layers", 4}, {"spacing", 2}}, ""};
                                  }};

/// A figure with its numbers, and what is to be said about them.
struct Figure {
  std::string heading;
  std::string file_name;  ///< of the drawing
  std::string drawing;    ///< SVG
  Table table;
  std::vector<std::string> remarks;  ///< sentences, made from the numbers: where our shape of result is another
};

/// How many runs each figure below takes: how often it tells progress() of a done of 0.
std::size_t broad_phase_runs();
std::size_t size_runs(bool quick);
std::size_t scene_runs();

/// Share of a step spent in the broad phase: brute force, grid, sweep-and-prune.
Figure broad_phase_shares(PaperRun& run);
/// Total time against the number of bodies, with contact groups and without, linear search and heap.
Figure cost_of_size(PaperRun& run);
/// Steps per second of scenes A to D.
Figure scene_speeds(PaperRun& run);

}  // namespace carom::report

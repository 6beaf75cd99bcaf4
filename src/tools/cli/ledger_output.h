// What `carom run --ledger` says, and draws: where energy and momentum came from and went to, by cause.
#pragma once

#include <string>
#include <vector>

#include "scenes/run.h"

namespace carom::tools {

/// The causes that gave anything, as a table, and how far their sum is from the change of the state.
void print_ledger(const World& world);

/// Energy by cause over a run.
class LedgerPlot {
 public:
  void add(const World& world, double time);  ///< after a step
  /// The causes that gave most, each as a line, and the state.
  std::string draw(const std::string& title) const;

 private:
  struct Line {
    std::string name;
    std::vector<double> energy;  // J, by time
  };
  std::vector<double> times_;  // s
  std::vector<Line> causes_;
  std::vector<double> state_;  // J, change of the kinetic energy since the ledger began
};

}  // namespace carom::tools

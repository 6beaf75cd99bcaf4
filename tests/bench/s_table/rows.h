// The rows of the S-table: which scene, how long, and where Carom wants to be.
#pragma once

#include <string>
#include <vector>

#include "engines.h"

namespace carom::bench {

struct Row {
  std::string id;  ///< "S1-1024"
  SceneChoice choice;
  double seconds = 0;        ///< simulated
  double quick_n = 0;        ///< bodies (what the scene calls n) of a quick run; 0: as they are
  double settle = 0;         ///< s at the start that count in no time
  bool sleeping = false;     ///< bodies may sleep
  bool memory = false;       ///< what is asked for is bytes a body, not time
  double aim = 0;            ///< of Carom: mean step over that of the best peer that stands; bytes a body; 0: none
  bool is_to_stand = false;  ///< an engine in which a block falls is no peer here
  std::size_t rays = 0;      ///< cast into what lies there at the end, and timed in place of the steps; ms of all
};

const std::vector<Row>& s_table();
/// A row by its id, or any scene of the library: `SCENE` or `SCENE:knob=value,knob=value`.
/// @throws Error with the names there are
Row find_row(const std::string& text);

}  // namespace carom::bench

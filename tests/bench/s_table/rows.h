// The rows of the S-table: which scene, how long, and where the design wants Carom to be.
#pragma once

#include <string>
#include <vector>

#include "engines.h"

namespace carom::bench {

struct Row {
  std::string id;  ///< "S1-1024"
  SceneChoice choice;
  double seconds = 0;     ///< simulated
  double quick_n = 0;     ///< bodies (what the scene calls n) of a quick run; 0: as they are
  double settle = 0;      ///< s at the start that count in no time
  bool sleeping = false;  ///< bodies may sleep
  bool memory = false;    ///< what is asked for is bytes a body, not time
  double target = 0;      ///< the design's aim on the machine on which its table was made, ms (bytes); 0: none
  double bullet = 0;      ///< Bullet's figure in that table; 0: none
  std::size_t rays = 0;   ///< cast into what lies there at the end, and timed in place of the steps; ms of all
};

const std::vector<Row>& s_table();
/// A row by its id, or any scene of the library: `SCENE` or `SCENE:knob=value,knob=value`.
/// @throws Error with the names there are
Row find_row(const std::string& text);

}  // namespace carom::bench

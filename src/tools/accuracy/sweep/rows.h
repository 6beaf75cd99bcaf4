// What a sweep measured, in memory and as a file: one row a run. JSON keeps everything and is read back; CSV is for
// other people's tools.
#pragma once

#include <string>
#include <vector>

#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

/// One run.
struct Row {
  std::string engine;                                 ///< "Carom"
  std::string setting;                                ///< "auto, 4 substeps"
  std::string scene;                                  ///< of `carom accuracy list`
  std::vector<std::pair<std::string, double>> knobs;  ///< of the scene, where a map changes one
  double dt = 0;                                      ///< s
  std::vector<double> errors;                         ///< one per metric of the scene; infinite: none
  double fell_at = -1;                                ///< s, or -1: it stood
  double simulated = 0;                               ///< s
  double cost = 0;                                    ///< s of CPU time in steps, per simulated second
  bool left_out = false;                              ///< it would have taken, or took, longer than the sweep has time
  bool usable() const { return !left_out && fell_at < 0; }
};

/// Whom rows are of, and how it was set up.
struct EngineNote {
  std::string name, version, note;
};

struct Sweep {
  std::string machine, date;
  std::vector<EngineNote> engines;
  std::vector<Row> rows;
};

/// @throws Error (the file can't be written; it is no such file; a scene is not known)
void write_json(const std::string& path, const Sweep& sweep);
void write_csv(const std::string& path, const Sweep& sweep);
Sweep read_json(const std::string& path);
/// Rows of both; the machine and the date of the first.
void merge(Sweep& into, const Sweep& other);

/// "Xeon ..., 2 processors", and today, both as the operating system tells.
std::string this_machine();
std::string today();

}  // namespace carom::tools::accuracy

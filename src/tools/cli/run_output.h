// What `carom run` says and writes after a run: the summary as text or JSON, tables as CSV.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>

#include "scenes/run.h"
#include "visual/recording.h"

namespace carom::tools {

/// Bodies not finite or escaped, bodies quarantined, or shapes at fault.
bool run_went_wrong(const RunSummary& run, const std::vector<KindSummary>& kinds);

/// @param observer  may be null
void print_summary(const Stage& stage, const Observer* observer, const RunSummary& run,
                   const std::vector<KindSummary>& kinds);
nlohmann::json summary_json(const Scene& scene, const Stage& stage, const Observer* observer, const RunSummary& run,
                            const std::vector<KindSummary>& kinds, double dt);

/// A CSV file that complains when it cannot be opened or written.
class CsvFile {
 public:
  explicit CsvFile(const std::string& path);  ///< @throws Error
  std::ofstream& out() { return out_; }
  void close();  ///< @throws Error (disk full)

 private:
  std::string path_;
  std::ofstream out_;
};

/// One row per step: time, seconds of every stage, counts, residuals, energies.
class StepTable {
 public:
  explicit StepTable(const std::string& path) : file_(path) {}
  void add(const carom_step_report& report);
  void finish() { file_.close(); }

 private:
  CsvFile file_;
  bool header_ = false;
};

/// One row per body and frame: time, body, kind, pose.
class MotionTable {
 public:
  explicit MotionTable(const std::string& path) : file_(path) {}
  void write(const Stage& stage, const Recording& recording);

 private:
  CsvFile file_;
};

}  // namespace carom::tools

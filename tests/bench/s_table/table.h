// Writes what was measured: as a table for people, and as lines for tests/bench/compare_engines.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "rays.h"

namespace carom::bench {

std::string format(const char* pattern, double value);

/// The fastest peer in which a row holds and no joint gapes farther than Carom's; of rows of memory the one that takes
/// least. Null: there is none.
const Record* best_peer(const Row& row, const std::vector<Record>& records);
const RayRecord* best_peer(const std::vector<RayRecord>& records);

class Table {
 public:
  /// @param csv    null, or file for one line a row and engine
  /// @param steps  null, or file for one line a step
  Table(const char* csv, const char* steps);
  void add(const Row& row, const std::vector<Record>& records);
  void add(const Row& row, const std::vector<RayRecord>& records);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  void print(const Row& row, const Record& record, const Record* best);
  void write(const Row& row, const Record& record, const Record* best);

  File csv_, steps_;
  bool has_steps_ = false, has_rays_ = false;  // heads of the tables are printed
};

}  // namespace carom::bench

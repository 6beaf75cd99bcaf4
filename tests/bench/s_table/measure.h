// Runs every engine through a row of the table in turn: the time of each step, and the judge's word on where bodies
// are.
#pragma once

#include "judge.h"
#include "rows.h"

namespace carom::bench {

struct Options {
  int repeats = 3;
  double budget = 60;  // s of CPU time that one engine may take for one repeat of a row; then it is cut short
  double seconds = 0;  // simulated; 0: the row's
  bool quick = false;
  std::vector<std::string> dials;    // name=value, of Carom's worlds
  std::vector<std::string> plugins;  // folders
  std::vector<PeerEngine> peers;     // the other engines
  bool carom = true;
  std::uint32_t threads = 1;  // that a step may use; with several, time is of the clock on the wall
};

/// What one engine did with one row.
struct Record {
  std::string engine;
  bool is_carom = false;
  std::vector<double> best;     // s, by step: least CPU time over the repeats
  std::size_t planned = 0;      // steps; fewer in `best`: cut short by the budget
  Verdict end;                  // of the last repeat
  double peak_penetration = 0;  // m, over every tenth step of the last repeat
  double peak_gap = 0;          // m, of joints, likewise
  double mean_gap = 0;          // m, mean of the means, likewise
  std::size_t looks = 0;
  double fell_by = -1;             // s, at which look a block was first seen fallen; -1: never
  std::size_t contact_points = 0;  // at the end
  std::vector<double> stages;      // s of wall clock in the last repeat, by CAROM_STAGE_*; Carom alone
  double bytes_per_body = 0;       // held for the world at the end

  /// It took more CPU time than there was, and what would have come of it is not known.
  bool was_cut() const { return best.size() < planned; }
  /// It went through, lost nobody, and what is built stands if it should.
  bool holds(const Row& row) const {
    return !was_cut() && !end.escaped && !end.lost && !(row.is_to_stand && end.standing.fallen);
  }
  double first_ms() const { return 1e3 * best.front(); }
  /// Of the steps [from, all): the time that no more than one of a hundred exceeds, ms.
  double p99_ms(std::size_t from) const;
  double worst_ms(std::size_t from) const;
  /// Mean of the steps [from, to), ms.
  double mean_ms(std::size_t from, std::size_t to) const;
};

inline constexpr double kDt = 1.0 / 60;  // s

/// CPU time of this process; of several threads the time on the wall, since a step of theirs is over when the last has done
/// its part.   @return s
double seconds_now(std::uint32_t threads);

/// @return one record an engine: Carom, then the others in order   @throws Error
std::vector<Record> measure(const Row& row, const Options& options);

}  // namespace carom::bench

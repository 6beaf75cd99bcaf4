#include "table.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace carom::bench {
namespace {

/// What became of the scene, in words.
std::string outcome(const Row& row, const Record& record) {
  std::string text;
  const auto say = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  const tools::Standing& s = record.end.standing;
  if (s.blocks && !s.fallen)
    say("stands, drop " + format("%.1f", 1e3 * s.drop) + " mm, drift " + format("%.1f mm", 1e3 * s.drift));
  if (s.fallen)
    say(std::to_string(s.fallen) + " of " + std::to_string(s.blocks) + " fallen, the first by " +
        format("%.1f s", record.fell_by) + ", drop " + format("%.1f", s.drop) + " m, drift " +
        format("%.1f m", s.drift));
  if (record.end.flight_error > 0) say(format("%.3f m off the parabola", record.end.flight_error));
  if (record.peak_gap > 0)
    say("joints gape by " + format("%.2f", 1e3 * record.mean_gap) + " mm, at most " +
        format("%.1f mm", 1e3 * record.peak_gap));
  if (row.memory) say(format("%.0f bytes a body", record.bytes_per_body));
  if (record.best.size() < record.planned)
    say("cut after " + std::to_string(record.best.size()) + " of " + std::to_string(record.planned) + " steps");
  return text;
}

/// First of the steps that count.
std::size_t counted_from(const Row& row, const Record& record) {
  return std::min(static_cast<std::size_t>(std::lround(row.settle / kDt)), record.best.size() - 1);
}

/// What a row compares: ms a step, or bytes a body.
double cost(const Row& row, const Record& record) {
  return row.memory ? record.bytes_per_body : record.mean_ms(counted_from(row, record), record.best.size());
}

/// Over the steps that both did, where one was cut short.   @return 0 where there is no best
double of_best(const Row& row, const Record& record, const Record* best) {
  if (!best) return 0;
  if (row.memory) return cost(row, record) / cost(row, *best);
  const std::size_t both = std::min(record.best.size(), best->best.size());
  const std::size_t from = std::min(counted_from(row, record), both - 1);
  return record.mean_ms(from, both) / best->mean_ms(from, both);
}

/// @throws Error
std::FILE* opened(const char* path, const char* head) {
  if (!path) return nullptr;
  std::FILE* const file = std::fopen(path, "w");
  if (!file)
    throw tools::Error(std::string("cannot write ") + path + ": " + std::strerror(errno),
                       "name a file in a folder that exists and may be written");
  std::fputs(head, file);
  return file;
}

}  // namespace

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

const Record* best_peer(const Row& row, const std::vector<Record>& records) {
  const auto carom = std::find_if(records.begin(), records.end(), [](const Record& r) { return r.is_carom; });
  const Record* best = nullptr;
  for (const Record& record : records) {
    if (record.is_carom || !record.holds(row)) continue;
    if (carom != records.end() && record.peak_gap > carom->peak_gap) continue;
    if (row.memory && !(record.bytes_per_body > 0)) continue;  // has no hook that counts
    if (!best || cost(row, record) < cost(row, *best)) best = &record;
  }
  return best;
}

const RayRecord* best_peer(const std::vector<RayRecord>& records) {
  const RayRecord* best = nullptr;
  for (const RayRecord& record : records)
    if (!record.is_own && (!best || record.best < best->best)) best = &record;
  return best;
}

Table::Table(const char* csv, const char* steps)
    : csv_(opened(csv,
                  "row,engine,is_carom,cost,unit,last_third_ms,p99_ms,worst_ms,first_ms,holds,of_best,aim,"
                  "peak_penetration_mm,peak_gap_mm\n")),
      steps_(opened(steps, "row,engine,step,ms\n")) {}

void Table::add(const Row& row, const std::vector<Record>& records) {
  if (!has_steps_)
    std::printf(
        "| row | engine | ms/step | last third | p99 | worst | first | of the best peer | aim | penetration max / "
        "mean mm | peak mm | J/body | points | escaped, not finite | outcome |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  has_steps_ = true;
  const Record* const best = best_peer(row, records);
  for (const Record& record : records) {
    print(row, record, best);
    write(row, record, best);
  }
  std::fflush(stdout);
}

void Table::print(const Row& row, const Record& record, const Record* best) {
  const std::size_t steps = record.best.size(), from = counted_from(row, record);
  const std::string points = record.contact_points == kNotTold ? "-" : std::to_string(record.contact_points);
  const double ratio = of_best(row, record, best);
  std::printf(
      "| %s | %s | %.3f | %.3f | %.2f | %.2f | %.2f | %s | %s | %.1f / %.2f | %.0f | %.1e | %s | %zu, %zu | %s |\n",
      row.id.c_str(), record.engine.c_str(), record.mean_ms(from, steps),
      record.mean_ms(steps - (steps - from + 2) / 3, steps), record.p99_ms(from), record.worst_ms(from),
      record.first_ms(), ratio > 0 ? format("%.3g", ratio).c_str() : "-",
      record.is_carom && row.aim > 0 ? format("%g", row.aim).c_str() : "-", 1e3 * record.end.max_penetration,
      1e3 * record.end.mean_penetration, 1e3 * record.peak_penetration, record.end.mean_energy, points.c_str(),
      record.end.escaped, record.end.lost, outcome(row, record).c_str());
}

void Table::write(const Row& row, const Record& record, const Record* best) {
  const std::size_t steps = record.best.size(), from = counted_from(row, record);
  if (csv_)
    std::fprintf(csv_.get(), "%s,\"%s\",%d,%.6g,%s,%.6g,%.6g,%.6g,%.6g,%s,%.6g,%g,%.6g,%.6g\n", row.id.c_str(),
                 record.engine.c_str(), record.is_carom, cost(row, record), row.memory ? "bytes a body" : "ms",
                 record.mean_ms(steps - (steps - from + 2) / 3, steps), record.p99_ms(from), record.worst_ms(from),
                 record.first_ms(),
                 record.was_cut()    ? "cut"
                 : record.holds(row) ? "1"
                                     : "0",
                 of_best(row, record, best), row.aim, 1e3 * record.peak_penetration, 1e3 * record.peak_gap);
  for (std::size_t i = 0; steps_ && i < steps; ++i)
    std::fprintf(steps_.get(), "%s,\"%s\",%zu,%.6g\n", row.id.c_str(), record.engine.c_str(), i, 1e3 * record.best[i]);
}

void Table::add(const Row& row, const std::vector<RayRecord>& records) {
  if (!has_rays_)
    std::printf(
        "\n| row | engine | ms, all rays | first time | of the best peer | aim | hits | unlike Carom's | "
        "apart from Carom's, max mm | rays apart by 1 mm |\n|---|---|---|---|---|---|---|---|---|---|\n");
  has_rays_ = true;
  const RayRecord* const best = best_peer(records);
  for (const RayRecord& r : records) {
    const double ratio = best ? r.best / best->best : 0;
    std::printf("| %s | %s | %.1f | %.1f | %s | %s | %zu | %zu | %.2g | %zu |\n", row.id.c_str(), r.engine.c_str(),
                1e3 * r.best, 1e3 * r.first, best ? format("%.3g", ratio).c_str() : "-",
                r.is_carom && row.aim > 0 ? format("%g", row.aim).c_str() : "-", r.hits, r.unlike, 1e3 * r.farthest,
                r.apart);
    if (csv_ && (r.is_carom || !r.is_own))
      std::fprintf(csv_.get(), "%s,\"%s\",%d,%.6g,ms of all rays,,,,%.6g,1,%.6g,%g,,\n", row.id.c_str(),
                   r.engine.c_str(), r.is_carom, 1e3 * r.best, 1e3 * r.first, ratio, row.aim);
  }
  std::fflush(stdout);
}

}  // namespace carom::bench

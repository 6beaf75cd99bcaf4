// Lines of the plan as tables and as JSON.
#include "cli/plan_output.h"

#include <cmath>

#include "cli/table.h"

namespace carom::tools {
namespace {

bool is_stage(const carom_plan_line& line) { return line.effect == CAROM_PLAN_NO_EFFECT; }

std::string time_text(double seconds) {
  if (seconds >= 1e-3) return format("%.3f ms", 1e3 * seconds);
  return seconds >= 1e-5 ? format("%.1f us", 1e6 * seconds) : format("%.0f ns", 1e9 * seconds);
}

std::string difference_text(const Difference& d) {
  if (std::fabs(d.seconds) <= d.spread) return "< " + time_text(d.spread);
  return (d.seconds < 0 ? "~ -" : "~ ") + time_text(std::fabs(d.seconds));
}

std::string time_of(const carom_plan_line& line, const Differences& differences = {}) {
  const auto found = differences.find(line.effect);
  if (found != differences.end()) return difference_text(found->second);
  if (line.timing == CAROM_TIME_IN_STAGE) return std::string("in ") + carom_stage_name(line.stage);
  return line.timing == CAROM_TIME_OFF ? "not timed" : time_text(line.seconds);
}

std::string bytes_text(std::uint64_t bytes) {
  return bytes < 10000 ? format("%llu B", static_cast<unsigned long long>(bytes))
                       : format("%.1f kB", 1e-3 * static_cast<double>(bytes));
}

std::string count_text(std::uint64_t n) { return format("%llu", static_cast<unsigned long long>(n)); }

const char* mode_name(std::uint32_t mode) {
  return mode == CAROM_MODE_FORBID ? "forbidden" : mode == CAROM_MODE_FORCE ? "forced" : "as_needed";
}

}  // namespace

std::string plan_text(const std::vector<carom_plan_line>& plan, const Differences& differences) {
  std::vector<std::vector<std::string>> stages = {{"stage", "runs", "time", "why"}},
                                        ran = {{"effect", "stage", "participants", "", "evaluations", "time", "memory",
                                                "why"}},
                                        left_out = {{"left out", "why"}};
  for (const carom_plan_line& line : plan) {
    if (is_stage(line))
      stages.push_back({line.name, line.runs ? "yes" : "no", line.runs ? time_of(line) : "", line.reason});
    else if (line.runs)
      ran.push_back({line.name, carom_stage_name(line.stage), count_text(line.participants), line.unit,
                     count_text(line.evaluations), time_of(line, differences), bytes_text(line.bytes), line.reason});
    else
      left_out.push_back({line.name, line.reason});
  }
  std::string text = "the plan of the last step; evaluations are those of all steps\n\n";
  text += table(stages, {false, false, true}) + "\n";
  text += table(ran, {false, false, true, false, true, true, true}) + "\n";
  if (!differences.empty())
    text +=
        "~: it works within its stage's loops; by the difference to steps without it, from this state, all awake\n\n";
  return text + table(left_out);
}

nlohmann::json plan_json(const std::vector<carom_plan_line>& plan, const Differences& differences) {
  nlohmann::json stages = nlohmann::json::array(), effects = nlohmann::json::array();
  for (const carom_plan_line& line : plan) {
    nlohmann::json out = {{"name", line.name}, {"runs", line.runs != 0}, {"reason", line.reason}};
    // null: it has no time of its own, or it was not asked for
    out["seconds"] = line.timing == CAROM_TIME_OWN ? nlohmann::json(line.seconds) : nlohmann::json();
    if (!is_stage(line)) {
      out["stage"] = carom_stage_name(line.stage);
      out["mode"] = mode_name(line.mode);
      out["participants"] = line.participants;
      out["wanted"] = line.wanted;
      out["unit"] = line.unit;
      out["evaluations"] = line.evaluations;
      out["bytes"] = line.bytes;
      if (const auto found = differences.find(line.effect); found != differences.end())
        out["difference"] = {{"seconds", found->second.seconds}, {"spread", found->second.spread}};
    }
    (is_stage(line) ? stages : effects).push_back(std::move(out));
  }
  return {{"stages", stages}, {"effects", effects}};
}

}  // namespace carom::tools

// Rows as JSON and CSV.
#include "accuracy/sweep/rows.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "host/files.h"

namespace carom::tools::accuracy {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "carom accuracy sweep 1";

json number(double value) { return std::isfinite(value) ? json(value) : json(); }
double number(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

/// What rows mean, for whoever reads the file without this program.
json scenes_json(const Sweep& sweep) {
  json scenes = json::array();
  for (const Challenge& c : all_challenges()) {
    if (std::none_of(sweep.rows.begin(), sweep.rows.end(), [&](const Row& r) { return r.scene == c.scene.name; }))
      continue;
    json metrics = json::array();
    for (const Metric& m : c.metrics)
      metrics.push_back({{"what", m.what}, {"unit", m.unit}, {"bound", number(m.bound)}});
    scenes.push_back(
        {{"name", c.scene.name}, {"summary", c.scene.summary}, {"truth", c.reference}, {"metrics", metrics}});
  }
  return scenes;
}

json row_json(const Row& row) {
  json errors = json::array(), knobs = json::object();
  for (const double e : row.errors) errors.push_back(number(e));
  for (const auto& [name, value] : row.knobs) knobs[name] = value;
  json j = {{"engine", row.engine}, {"setting", row.setting},     {"scene", row.scene},
            {"dt", row.dt},         {"errors", errors},           {"fell_at", row.fell_at},
            {"cost", row.cost},     {"simulated", row.simulated}, {"left_out", row.left_out}};
  if (!row.knobs.empty()) j["knobs"] = knobs;
  return j;
}

Row row_of(const json& j) {
  Row row;
  row.engine = j.at("engine"), row.setting = j.at("setting"), row.scene = j.at("scene");
  row.dt = j.at("dt"), row.fell_at = j.at("fell_at"), row.cost = j.at("cost"), row.simulated = j.at("simulated");
  row.left_out = j.at("left_out");
  for (const json& e : j.at("errors")) row.errors.push_back(number(e));
  if (j.contains("knobs"))
    for (const auto& [name, value] : j.at("knobs").items()) row.knobs.emplace_back(name, value.get<double>());
  if (row.errors.size() != find_challenge(row.scene).metrics.size())
    throw Error("a row of " + row.scene + " has another number of errors than the scene has",
                "the file was written by another version: sweep again");
  return row;
}

}  // namespace

void write_json(const std::string& path, const Sweep& sweep) {
  json engines = json::array(), rows = json::array();
  for (const EngineNote& e : sweep.engines)
    engines.push_back({{"name", e.name}, {"version", e.version}, {"note", e.note}});
  for (const Row& row : sweep.rows) rows.push_back(row_json(row));
  std::ostringstream file;
  // One row a line: such files are compared and searched.
  file << "{\"format\": " << json(kFormat) << ",\n\"machine\": " << json(sweep.machine)
       << ",\n\"date\": " << json(sweep.date) << ",\n\"engines\": " << engines << ",\n\"scenes\": [";
  const auto lines = [&](const json& list) {
    for (std::size_t i = 0; i < list.size(); ++i) file << (i ? ",\n" : "\n") << list[i];
    file << "]";
  };
  lines(scenes_json(sweep));
  file << ",\n\"rows\": [";
  lines(rows);
  file << "}\n";
  write_file(path, file.str());
}

void write_csv(const std::string& path, const Sweep& sweep) {
  std::ostringstream file;
  file.precision(17);
  file << "engine,setting,scene,knobs,dt,metric,unit,error,bound,fell_at,simulated,cost,left_out\n";
  for (const Row& row : sweep.rows) {
    const Challenge& challenge = find_challenge(row.scene);
    std::string knobs;
    for (const auto& [name, value] : row.knobs)
      knobs += (knobs.empty() ? "" : " ") + name + "=" + std::to_string(value);
    for (std::size_t i = 0; i < row.errors.size(); ++i) {
      const Metric& m = challenge.metrics[i];
      file << '"' << row.engine << "\",\"" << row.setting << "\"," << row.scene << ",\"" << knobs << "\"," << row.dt
           << ",\"" << m.what << "\"," << m.unit << ',';
      if (std::isfinite(row.errors[i])) file << row.errors[i];
      file << ',';
      if (std::isfinite(m.bound)) file << m.bound;
      file << ',' << row.fell_at << ',' << row.simulated << ',' << row.cost << ',' << row.left_out << '\n';
    }
  }
  write_file(path, file.str());
}

Sweep read_json(const std::string& path) {
  const std::string text = read_file(path, "give --from a file that `carom accuracy sweep --out FILE.json` wrote");
  try {
    const json j = json::parse(text);
    if (j.at("format") != kFormat) throw Error(path + " is of another version", "sweep again");
    Sweep sweep;
    sweep.machine = j.at("machine"), sweep.date = j.at("date");
    for (const json& e : j.at("engines")) sweep.engines.push_back({e.at("name"), e.at("version"), e.at("note")});
    for (const json& row : j.at("rows")) sweep.rows.push_back(row_of(row));
    return sweep;
  } catch (const json::exception& e) {
    throw Error(path + " is not a sweep: " + e.what(),
                "give --from a file that `carom accuracy sweep --out FILE.json` wrote");
  }
}

void merge(Sweep& into, const Sweep& other) {
  if (into.machine.empty()) into.machine = other.machine, into.date = other.date;
  for (const EngineNote& e : other.engines)
    if (std::none_of(into.engines.begin(), into.engines.end(), [&](const EngineNote& k) { return k.name == e.name; }))
      into.engines.push_back(e);
  into.rows.insert(into.rows.end(), other.rows.begin(), other.rows.end());
}

std::string this_machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string model = "a processor";
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  return model + ", " + std::to_string(std::max(1u, std::thread::hardware_concurrency())) + " hardware threads";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  const std::tm utc = *std::gmtime(&now);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
  return text;
}

}  // namespace carom::tools::accuracy

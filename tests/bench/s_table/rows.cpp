// The S-table itself.
#include "rows.h"

#include <cstdlib>

namespace carom::bench {

const std::vector<Row>& s_table() {
  static const std::vector<Row> rows = {
      {"S1-64", {"falling", {{{"n", 64}}, ""}}, 15, 30},
      {"S1-256", {"falling", {{{"n", 256}}, ""}}, 15, 50},
      {"S1-1024", {"falling", {{{"n", 1024}}, ""}}, 15, 100, 0, false, false, 2.7, 7.65},
      {"S1-2048", {"falling", {{{"n", 2048}}, ""}}, 10, 100},
      {"S1-4096", {"falling", {{{"n", 4096}}, ""}}, 5, 200},
      {"S1-8192", {"falling", {{{"n", 8192}}, ""}}, 5, 200, 0, false, false, 30, 86.5},
      {"S2", {"wall", {}}, 5, 0, 0, false, false, 0.4, 0.77},
      {"S2-40x20", {"wall", {{{"columns", 40}, {"rows", 20}}, ""}}, 5},
      {"S3-100", {"bunnies", {{{"n", 100}, {"boxes", 2}, {"spheres", 0}}, ""}}, 10, 10, 0, false, false, 0.9, 3.7},
      {"S3-1000", {"bunnies", {{{"n", 1000}, {"boxes", 2}, {"spheres", 0}}, ""}}, 5, 20, 0, false, false, 11, 57.5},
      {"S4", {"particles", {{{"n", 20000}, {"spread", 50}}, ""}}, 3, 500, 0, false, false, 0.1, 40.5},
      {"S5-30", {"pyramid", {{{"n", 30}}, ""}}, 10, 6, 0, false, false, 1.1, 2.66},
      {"S5-100", {"pyramid", {{{"n", 100}}, ""}}, 10, 10, 0, false, false, 17, 0},
      {"S5m-25", {"pyramids", {{{"n", 25}}, ""}}, 5, 2},
      {"S5m-100", {"pyramids", {{{"n", 100}}, ""}}, 5, 3},
      {"S6", {"stacks", {{{"n", 16}, {"height", 40}}, ""}}, 10, 2, 0, false, false, 0.7, 0},
      {"S7", {"dominoes", {{{"n", 1000}}, ""}}, 10, 20},
      {"S8", {"net", {{{"n", 30}}, ""}}, 5, 6, 0, false, false, 1.3, 3.7},
      {"S8-60", {"net", {{{"n", 60}}, ""}}, 5, 8},
      {"dolls", {"dolls", {{{"n", 20}}, ""}}, 8, 2},
      {"S9", {"sleepers", {{{"n", 10000}, {"moving", 10}}, ""}}, 5, 200, 4, true, false, 0.015, 3.6},
      {"S10", {"falling", {{{"n", 8192}}, ""}}, 5, 200, 0, false, false, 100, 9400, 100000},
      {"S11", {"sleepers", {{{"n", 10000}, {"moving", 0}}, ""}}, 0.5, 200, 0, false, true, 1600, 10400},
      {"S11-piled", {"falling", {{{"n", 1024}}, ""}}, 8, 100, 0, false, true},
  };
  return rows;
}

Row find_row(const std::string& text) {
  std::string ids;
  for (const Row& row : s_table()) {
    if (row.id == text) return row;
    ids += (ids.empty() ? "" : ", ") + row.id;
  }
  const std::size_t colon = text.find(':');
  Row row;
  row.id = text;
  row.choice.scene = text.substr(0, colon);
  try {
    row.seconds = find_scene(row.choice.scene).seconds;
  } catch (const tools::Error& error) {
    throw tools::Error("there is no row '" + text + "': " + error.what(), "the rows are: " + ids + "; " + error.remedy);
  }
  for (std::size_t at = colon; at != std::string::npos;) {
    const std::size_t end = text.find(',', at + 1);
    const std::string setting = text.substr(at + 1, end == std::string::npos ? end : end - at - 1);
    const std::size_t equals = setting.find('=');
    const char* const number = equals == std::string::npos ? "" : setting.c_str() + equals + 1;
    char* stop = nullptr;
    const double value = std::strtod(number, &stop);
    if (stop == number || *stop)
      throw tools::Error("'" + setting + "' is not name=number", "write SCENE:name=value,name=value");
    row.choice.settings.values.emplace_back(setting.substr(0, equals), value);
    at = end;
  }
  return row;
}

}  // namespace carom::bench

// The S-table itself.
#include "rows.h"

#include <cstdlib>

namespace carom::bench {

const std::vector<Row>& s_table() {
  static const std::vector<Row> rows = {
      {.id = "S1-64", .choice = {"falling", {{{"n", 64}}, ""}}, .seconds = 15, .quick_n = 30, .aim = 0.95},
      {.id = "S1-256", .choice = {"falling", {{{"n", 256}}, ""}}, .seconds = 15, .quick_n = 50, .aim = 0.95},
      {.id = "S1-1024", .choice = {"falling", {{{"n", 1024}}, ""}}, .seconds = 15, .quick_n = 100, .aim = 0.95},
      {.id = "S1-2048", .choice = {"falling", {{{"n", 2048}}, ""}}, .seconds = 10, .quick_n = 100, .aim = 0.95},
      {.id = "S1-4096", .choice = {"falling", {{{"n", 4096}}, ""}}, .seconds = 5, .quick_n = 200, .aim = 0.95},
      {.id = "S1-8192", .choice = {"falling", {{{"n", 8192}}, ""}}, .seconds = 5, .quick_n = 200, .aim = 0.95},
      {.id = "S2", .choice = {"wall", {}}, .seconds = 5, .aim = 1},
      {.id = "S2-40x20", .choice = {"wall", {{{"columns", 40}, {"rows", 20}}, ""}}, .seconds = 5, .aim = 1},
      {.id = "S3-100",
       .choice = {"bunnies", {{{"n", 100}, {"boxes", 2}, {"spheres", 0}}, ""}},
       .seconds = 10,
       .quick_n = 10,
       .aim = 1},
      {.id = "S3-1000",
       .choice = {"bunnies", {{{"n", 1000}, {"boxes", 2}, {"spheres", 0}}, ""}},
       .seconds = 5,
       .quick_n = 20,
       .aim = 1},
      {.id = "S4", .choice = {"particles", {{{"n", 20000}, {"spread", 50}}, ""}}, .seconds = 3, .quick_n = 500},
      {.id = "S5-30",
       .choice = {"pyramid", {{{"n", 30}}, ""}},
       .seconds = 10,
       .quick_n = 6,
       .aim = 0.9,
       .is_to_stand = true},
      {.id = "S5-100",
       .choice = {"pyramid", {{{"n", 100}}, ""}},
       .seconds = 10,
       .quick_n = 10,
       .aim = 0.9,
       .is_to_stand = true},
      {.id = "S5m-25",
       .choice = {"pyramids", {{{"n", 25}}, ""}},
       .seconds = 5,
       .quick_n = 2,
       .aim = 0.6,
       .is_to_stand = true},
      {.id = "S5m-100",
       .choice = {"pyramids", {{{"n", 100}}, ""}},
       .seconds = 5,
       .quick_n = 3,
       .aim = 0.6,
       .is_to_stand = true},
      {.id = "S6",
       .choice = {"stacks", {{{"n", 16}, {"height", 40}}, ""}},
       .seconds = 10,
       .quick_n = 2,
       .aim = 0.9,
       .is_to_stand = true},
      {.id = "S7", .choice = {"dominoes", {{{"n", 1000}}, ""}}, .seconds = 10, .quick_n = 20, .aim = 1},
      {.id = "S8", .choice = {"net", {{{"n", 30}}, ""}}, .seconds = 5, .quick_n = 6, .aim = 1},
      {.id = "S8-60", .choice = {"net", {{{"n", 60}}, ""}}, .seconds = 5, .quick_n = 8, .aim = 1},
      {.id = "dolls", .choice = {"dolls", {{{"n", 20}}, ""}}, .seconds = 8, .quick_n = 2, .aim = 1},
      {.id = "S9",
       .choice = {"sleepers", {{{"n", 10000}, {"moving", 10}}, ""}},
       .seconds = 5,
       .quick_n = 200,
       .settle = 4,
       .sleeping = true,
       .aim = 1,
       .is_to_stand = true},
      {.id = "S10",
       .choice = {"falling", {{{"n", 8192}}, ""}},
       .seconds = 5,
       .quick_n = 200,
       .aim = 0.9,
       .rays = 100000},
      {.id = "S11",
       .choice = {"sleepers", {{{"n", 10000}, {"moving", 0}}, ""}},
       .seconds = 0.5,
       .quick_n = 200,
       .memory = true,
       .aim = 1800,
       .is_to_stand = true},
      {.id = "S11-piled",
       .choice = {"falling", {{{"n", 1024}}, ""}},
       .seconds = 8,
       .quick_n = 100,
       .memory = true,
       .aim = 5000},
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

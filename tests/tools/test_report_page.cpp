// The report as a reader meets it: filters, the order, the budget and the look, in a browser without a window. Skipped
// where there is no Chromium.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "accuracy/page/controls.h"
#include "accuracy/page/report.h"
#include "accuracy/sweep/settings.h"
#include "carom_test.h"
#include "host/files.h"

using namespace carom::tools;
using namespace carom::tools::accuracy;

namespace {

Row row(const std::string& engine, const std::string& setting, const std::string& scene, double hz, double cost,
        double error) {
  Row r;
  r.engine = engine, r.setting = setting, r.scene = scene, r.dt = 1 / hz, r.cost = cost, r.simulated = 1;
  r.errors.assign(find_challenge(scene).metrics.size(), error);
  return r;
}

/// Costs are s a second: 6e-3 is 0.1 ms a frame.
Sweep made_up() {
  Sweep sweep;
  sweep.machine = "none", sweep.date = "2026-01-01";
  sweep.engines = {{"Carom", "1.0", ""}, {"Other", "2.0", ""}};
  sweep.rows = {row("Carom", kDefaultSetting, "slide", 60, 3e-3, 1e-3),
                row("Carom", kDefaultSetting, "slide", 120, 7e-3, 1e-5),
                row("Carom", "preset fast", "slide", 60, 1e-3, 5e-3),
                row("Carom", "direct, 1 substep", "slide", 60, 5e-3, 1e-4),
                row("Other", "best", "slide", 60, 4e-3, 1e-2),
                row("Carom", kDefaultSetting, "skid", 60, 4e-3, 1e-2),
                row("Other", "best", "skid", 60, 1e-3, 1e-5)};
  return sweep;
}

/// What a reader does, and what he sees: written into the page by a script of the test's own.
constexpr const char* kReader = R"(<script>
var seen={};
function turn(id,value){get(id).value=value;get(id).dispatchEvent(new Event('input'));}
function shown(q){return all(q).filter(function(e){return e.getClientRects().length!==0;}).length;}
function cell(scene,i){return all('#budget-table tr[data-scene="'+scene+'"] td')[i].textContent;}
seen.first=[cell('slide',1),cell('slide',4),cell('skid',1)];
seen.text=get('budget-text').textContent;
turn('my-budget',80);seen.rich=[cell('slide',1),cell('slide',2),cell('slide',3),cell('slide',4)];
turn('my-budget',0);seen.poor=cell('slide',1);
turn('my-budget',80);turn('by-engine','Other');
seen.other=[shown('g.setting[data-engine="Carom"]'),shown('g.setting[data-engine="Other"]'),cell('skid',1),cell('skid',4)];
turn('by-engine','');turn('by-setting','fast');
seen.fast=[shown('g.setting[data-name="preset fast"]'),shown('g.setting[data-name="direct, 1 substep"]'),cell('slide',1)];
turn('by-setting','presets');
seen.presets=[shown('g.setting[data-preset]'),shown('g.setting[data-name="direct, 1 substep"]')];
turn('by-setting','');turn('by-scene','Ski');
seen.scene=[shown('.scene[data-scene="slide"] svg'),shown('.scene[data-scene="skid"] svg'),shown('#budget-table tr[data-scene="slide"]')];
turn('by-scene','');
function order(){return all('#peers-table tr[data-scene]').map(function(e){return e.getAttribute('data-scene');}
).join();}
function figures(){return all('.scene').map(function(e){return e.getAttribute('data-scene');}).join();}
seen.order=[order(),figures()];turn('by-order','red');seen.red=[order(),figures()];turn('by-order','');
seen.back=[order(),figures()];
function ground(){return getComputedStyle(document.body).backgroundColor;}
turn('look','light');seen.light=ground();turn('look','dark');seen.dark=ground();
seen.printed=matchMedia('print').matches;
seen.names=all('text').filter(function(t){return t.textContent==='fast';}).length;
var out=document.createElement('pre');out.id='seen';out.textContent='SEEN'+JSON.stringify(seen)+'NEES';
document.body.appendChild(out);
</script></body>)";

std::string run_browser(const std::string& arguments) {
  const std::string home =
      (std::filesystem::temp_directory_path() / ("carom_browser_" + std::to_string(getpid()))).string();
  FILE* pipe = popen(("timeout 120 chromium --headless --no-sandbox --disable-gpu --user-data-dir=" + home + " " +
                      arguments + " 2>/dev/null")
                         .c_str(),
                     "r");
  assert_non_null(pipe);
  std::string text;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
  pclose(pipe);
  std::filesystem::remove_all(home);
  return text;
}

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("carom_page_" + std::to_string(getpid()) + "_" + name);
}

}  // namespace

static void a_reader_filters_sorts_and_has_a_budget(void**) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0) skip();
  std::string page = report_page(made_up(), {});
  page.replace(page.rfind("</body>"), 7, kReader);
  const auto path = temporary("report.html");
  write_file(path.string(), page);
  const std::string dom = run_browser("--dump-dom file://" + path.string());
  std::filesystem::remove(path);
  const std::size_t begin = dom.find("SEEN{"), end = dom.find("}NEES");
  if (begin == std::string::npos || end == std::string::npos) std::printf("%s\n", dom.c_str());
  assert_true(begin != std::string::npos && end != std::string::npos);
  std::string text = dom.substr(begin + 4, end - begin - 3);
  for (std::size_t at; (at = text.find("&amp;")) != std::string::npos;) text.replace(at, 5, "&");
  const nlohmann::json seen = nlohmann::json::parse(text);
  std::printf("%s\n", seen.dump().c_str());
  using nlohmann::json;
  // 0.1 ms a frame: the direct solver's 1e-4 at 5e-3 s a second; the finer default costs 7e-3.
  assert_true(seen["first"] == json({"direct, 1 substep, 1/60 s",
                                     "carom accuracy run slide --dial solver=direct --dial substeps=1 --dt 1/60",
                                     "auto, 4 substeps, 1/60 s"}));
  assert_true(seen["text"] == "0.1 ms a frame");
  assert_true(seen["rich"] == json({"auto, 4 substeps, 1/120 s", "0.00001 m", "0.12 ms",
                                    "carom accuracy run slide --preset balanced --dt 1/120"}));
  assert_true(seen["poor"] == "nothing is as cheap");
  assert_true(seen["other"] == json({0, 2, "Other: best, 1/60 s", ""}));
  assert_true(seen["fast"] == json({1, 0, "preset fast, 1/60 s"}));
  assert_true(seen["presets"][0] == 3 && seen["presets"][1] == 0);
  assert_true(seen["scene"] == json({0, 1, 0}));
  assert_true(seen["order"] == json({"slide,skid", "slide,skid"}));
  assert_true(seen["red"] == json({"skid,slide", "skid,slide"}));  // skid is where another is ahead
  assert_true(seen["back"] == seen["order"]);
  assert_true(seen["light"] != seen["dark"]);
  assert_true(seen["names"] == 1);
}

static void the_page_prints(void**) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0) skip();
  const auto path = temporary("print.html"), pdf = temporary("print.pdf");
  write_file(path.string(), report_page(made_up(), {}));
  run_browser("--print-to-pdf=" + pdf.string() + " file://" + path.string());
  assert_true(std::filesystem::exists(pdf) && std::filesystem::file_size(pdf) > 10000);
  std::filesystem::remove(path), std::filesystem::remove(pdf);
}

static void without_a_script_the_budget_is_that_at_which_a_page_opens(void**) {
  const std::string page = report_page(made_up(), {});
  assert_true(page.find("carom accuracy run slide --dial solver=direct --dial substeps=1 --dt 1/60") !=
              std::string::npos);
  assert_true(page.find("carom accuracy run skid --preset balanced --dt 1/60") != std::string::npos);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(without_a_script_the_budget_is_that_at_which_a_page_opens),
      cmocka_unit_test(a_reader_filters_sorts_and_has_a_budget),
      cmocka_unit_test(the_page_prints),
  };
  return cmocka_run_group_tests_name("tools/report_page", tests, nullptr, nullptr);
}

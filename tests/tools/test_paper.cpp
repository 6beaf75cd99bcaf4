// `carom paper --quick`, run as a person would: it ends well, and what it draws is well-formed and shows what it says.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "carom_test.h"
#include "tools/xml_check.h"

namespace {

namespace fs = std::filesystem;

XmlCheck load(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return XmlCheck(std::string(std::istreambuf_iterator<char>(in), {}));
}

fs::path folder() { return fs::temp_directory_path() / ("carom_paper_" + std::to_string(getpid())); }

}  // namespace

static int run_it(void**) {
  const std::string line = std::string(CAROM_COMMAND) + " paper --quick --out " + folder().string() + " 2>/dev/null";
  return std::system(line.c_str());
}

static int clean_up(void**) {
  std::error_code ignored;
  fs::remove_all(folder(), ignored);
  return 0;
}

static void shares_of_three_broad_phases_in_two_crowds_stand_beside_the_papers_marks(void**) {
  const XmlCheck svg = load(folder() / "broad_phase.svg");
  assert_true(svg.well_formed());
  assert_int_equal(svg.with_class("rect", "f0 edge").size(), 6);
  assert_int_equal(svg.with_class("line", "ref").size(), 4);
  double widths[6];
  for (std::size_t i = 0; i < 6; ++i)
    widths[i] = std::atof(svg.with_class("rect", "f0 edge")[i].attributes.at("width").c_str());
  // Half a million pair tests a step against a few thousand: no load of the machine turns that round.
  assert_true(widths[0] > widths[2] && widths[2] > 0);
  assert_true(widths[3] > widths[5] && widths[5] > 0);
}

static void five_curves_run_through_all_sizes(void**) {
  const XmlCheck svg = load(folder() / "groups.svg");
  assert_true(svg.well_formed());
  std::size_t curves = 0, points = 0;
  for (const Element& e : svg.elements()) {
    curves += e.name == "polyline";
    points += e.name == "circle";
  }
  assert_int_equal(curves, 5);
  assert_int_equal(points, 20);
}

static void four_scenes_stand_beside_four_marks_of_the_paper(void**) {
  const XmlCheck svg = load(folder() / "scenes.svg");
  assert_true(svg.well_formed());
  assert_int_equal(svg.with_class("rect", "f0 edge").size(), 4);
  assert_int_equal(svg.with_class("line", "ref").size(), 4);
}

static void the_page_shows_the_three_drawings_with_their_numbers(void**) {
  const XmlCheck page = load(folder() / "index.html");
  assert_true(page.well_formed());
  int pictures = 0, cells = 0;
  for (const Element& e : page.elements()) {
    if (e.name == "img") {
      assert_true(fs::exists(folder() / e.attributes.at("src")));
      ++pictures;
    }
    if (e.name != "td") continue;
    ++cells;
    assert_true(e.text != "n/a" && !e.text.empty());
  }
  assert_int_equal(pictures, 3);
  assert_int_equal(cells, 6 * 7 + 4 * 7 + 4 * 9);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(shares_of_three_broad_phases_in_two_crowds_stand_beside_the_papers_marks),
      cmocka_unit_test(five_curves_run_through_all_sizes),
      cmocka_unit_test(four_scenes_stand_beside_four_marks_of_the_paper),
      cmocka_unit_test(the_page_shows_the_three_drawings_with_their_numbers),
  };
  return cmocka_run_group_tests_name("tools/paper", tests, run_it, clean_up);
}

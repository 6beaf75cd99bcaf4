// Drawings and tables of the report library: well-formed, and every datum stands where its axis says.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "carom_test.h"
#include "host/drawings.h"
#include "host/files.h"
#include "host/host.h"
#include "report/axis.h"
#include "report/filmstrip.h"
#include "report/page.h"
#include "report/perspective.h"
#include "report/plot.h"
#include "report/silhouette.h"
#include "tools/xml_check.h"

using namespace carom::report;

namespace {

constexpr double kPixel = 0.01;  // coordinates are written with two decimals

double value(const Element& e, const char* attribute) { return std::atof(e.attributes.at(attribute).c_str()); }

LinePlot powers_of_two() {
  LinePlot plot;
  plot.title = "time & <size>";
  plot.x = {"bodies", Scale::log, false, {64, 128, 256, 512, 1024}};
  plot.y = {"ms \"a step\"", Scale::log, false, {}};
  plot.series = {{"ours", {{64, 0.5}, {256, 5}, {1024, 50}}, 0, false}, {"paper", {{64, 1}, {1024, 100}}, 0, true}};
  plot.note = "a > b";
  return plot;
}

}  // namespace

static void the_checker_itself_refuses_what_is_not_well_formed(void**) {
  assert_true(XmlCheck("<a b=\"1\"><c/>x &amp; y</a>").well_formed());
  for (const char* bad : {"<a>", "<a></b>", "<a><b></a></b>", "<a b=1/>", "<a>x & y</a>", "<a b=\"<\"/>", "<a/><b/>",
                          "", "text", "<a b=\"1\" b=\"2\"/>", "<a>>"})
    assert_false(XmlCheck(bad).well_formed());
}

static void a_linear_axis_covers_the_data_with_four_to_eleven_round_ticks(void**) {
  for (double max : {1e-6, 0.3, 1.0, 7.0, 97.0, 1024.0, 3.2e8}) {
    const Axis axis = fit_axis({"", Scale::linear, true, {}}, 0, max);
    assert_true(axis.low <= 0 && axis.high >= max);
    assert_in_range(axis.ticks.size(), 4, 11);
    assert_true(std::fabs(axis.at(axis.low)) < 1e-12 && std::fabs(axis.at(axis.high) - 1) < 1e-12);
    assert_true(std::fabs(axis.at((axis.low + axis.high) / 2) - 0.5) < 1e-12);
  }
}

static void a_log_axis_gives_equal_ratios_equal_lengths(void**) {
  const Axis axis = fit_axis({"", Scale::log, false, {}}, 0.02, 700);
  assert_true(axis.low <= 0.02 && axis.high >= 700);
  const double decade = axis.at(10) - axis.at(1);
  assert_true(decade > 0);
  assert_true(std::fabs((axis.at(100) - axis.at(10)) - decade) < 1e-12);
  assert_true(std::fabs((axis.at(0.2) - axis.at(0.02)) - decade) < 1e-12);
  assert_true(axis.at(0) == 0 && axis.at(-5) == 0);
}

static void a_datum_on_a_tick_is_drawn_on_the_tick(void**) {
  const XmlCheck svg(draw(powers_of_two()));
  assert_true(svg.well_formed());
  const auto dots = svg.with_class("circle", "f0 edge");
  assert_int_equal(dots.size(), 3);
  const auto ticks = svg.with_class("line", "axis");  // five of x, then the axis itself
  assert_int_equal(ticks.size(), 6);
  for (int i = 0; i < 3; ++i)
    assert_true(std::fabs(value(dots[static_cast<std::size_t>(i)], "cx") -
                          value(ticks[static_cast<std::size_t>(2 * i)], "x1")) <= kPixel);
  // Each datum is ten times the one before it and four times as far along x: the dots lie on a line that climbs.
  assert_true(std::fabs((value(dots[1], "cy") - value(dots[0], "cy")) -
                        (value(dots[2], "cy") - value(dots[1], "cy"))) <= 2 * kPixel);
  assert_true(value(dots[2], "cy") < value(dots[0], "cy"));
}

static void a_reference_is_dashed_and_grey_and_labelled(void**) {
  const XmlCheck svg(draw(powers_of_two()));
  assert_int_equal(svg.with_class("polyline", "ref").size(), 1);
  assert_int_equal(svg.with_class("text", "reft").size(), 1);
  assert_string_equal(svg.with_class("text", "reft")[0].text.c_str(), "paper");
  LinePlot marked = powers_of_two();
  marked.marks = {{256, "here"}};
  const XmlCheck again(draw(marked));
  const auto line = again.with_class("line", "ref");
  assert_int_equal(line.size(), 1);
  assert_true(std::fabs(value(line[0], "x1") - value(again.with_class("circle", "f0 edge")[1], "cx")) <= kPixel);
}

static void labels_of_lines_that_end_together_do_not_touch(void**) {
  LinePlot plot = powers_of_two();
  plot.series.clear();
  for (int i = 0; i < 6; ++i) plot.series.push_back({"line", {{64, 1}, {1024, 2}}, i, false});
  const XmlCheck svg(draw(plot));
  double last = -1;
  for (int i = 0; i < 6; ++i) {
    const auto label = svg.with_class("text", "t" + std::to_string(i));
    assert_int_equal(label.size(), 1);
    assert_true(last < 0 || value(label[0], "y") - last >= 12);  // the height of the font
    last = value(label[0], "y");
  }
}

static void a_datum_that_is_not_finite_is_left_out(void**) {
  LinePlot plot = powers_of_two();
  plot.series[0].points.push_back({std::nan(""), 1});
  plot.series[0].points.push_back({2048, std::numeric_limits<double>::infinity()});
  plot.series[0].points.push_back({2048, -1});
  const std::string text = draw(plot);
  assert_true(XmlCheck(text).well_formed());
  assert_int_equal(XmlCheck(text).with_class("circle", "f0 edge").size(), 3);
  assert_true(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos);
  plot.series.clear();
  assert_true(XmlCheck(draw(plot)).well_formed());
}

static void bars_have_the_length_of_their_value_and_the_mark_its_place(void**) {
  BarChart chart;
  chart.title = "share";
  chart.value = {"%", Scale::linear, true, {0, 20, 40, 60, 80, 100}};
  chart.rows = {{"brute", {{"broad", 90, 0}, {"rest", 10, 1}}, "90 %", 97, "paper 97 %"},
                {"sweep", {{"broad", 30, 0}, {"rest", 70, 1}}, "30 %", 16, "paper 16 %"}};
  const XmlCheck svg(draw(chart));
  assert_true(svg.well_formed());
  const auto broad = svg.with_class("rect", "f0 edge"), rest = svg.with_class("rect", "f1 edge");
  assert_int_equal(broad.size(), 2);
  const double unit = value(broad[0], "width") / 90;
  assert_true(std::fabs(value(broad[1], "width") - 30 * unit) <= 2 * kPixel);
  assert_true(std::fabs(value(rest[0], "x") - (value(broad[0], "x") + 90 * unit)) <= 2 * kPixel);
  const auto marks = svg.with_class("line", "ref");
  assert_int_equal(marks.size(), 2);
  assert_true(std::fabs(value(marks[1], "x1") - (value(broad[1], "x") + 16 * unit)) <= 2 * kPixel);
}

static void log_bars_grow_by_equal_lengths_for_equal_ratios(void**) {
  BarChart chart;
  chart.value = {"steps/s", Scale::log, false, {}};
  for (double v : {10.0, 100.0, 1000.0}) chart.rows.push_back({"row", {{"ours", v, 0}}, "", 0, ""});
  const auto bars = XmlCheck(draw(chart)).with_class("rect", "f0 edge");
  assert_int_equal(bars.size(), 3);
  assert_true(value(bars[0], "width") > 0);
  assert_true(std::fabs((value(bars[1], "width") - value(bars[0], "width")) -
                        (value(bars[2], "width") - value(bars[1], "width"))) <= 3 * kPixel);
}

static void a_panel_shows_metres_in_true_proportion_with_up_upward(void**) {
  Filmstrip strip;
  strip.left = -2;
  strip.right = 2;
  strip.bottom = 0;
  strip.top = 2;
  strip.panels = {{"t = 0", {{{{-1, 0}, {1, 0}, {0, 1}}, 3, false}}}};
  const XmlCheck svg(draw(strip));
  assert_true(svg.well_formed());
  const auto shapes = svg.with_class("polygon", "f3 edge");
  assert_int_equal(shapes.size(), 1);
  double x[3], y[3];
  assert_int_equal(std::sscanf(shapes[0].attributes.at("points").c_str(), "%lf,%lf %lf,%lf %lf,%lf", &x[0], &y[0],
                               &x[1], &y[1], &x[2], &y[2]),
                   6);
  assert_true(std::fabs(y[0] - y[1]) <= kPixel);
  assert_true(std::fabs((x[1] - x[0]) - 2 * (y[0] - y[2])) <= 3 * kPixel);
  assert_true(y[2] < y[0]);
}

static double area(const std::vector<Point>& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point a = p[i], b = p[(i + 1) % p.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

static void the_hull_keeps_the_corners_and_drops_the_rest(void**) {
  const auto corners = hull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0}, {0, 0}});
  assert_int_equal(corners.size(), 4);
  assert_true(area(corners) == 1);  // positive: counter-clockwise
}

static void the_shadow_of_a_mesh_keeps_its_hollows(void**) {
  // An L of three unit squares, standing at z = 5 and tilted so that no triangle faces the viewer squarely.
  carom::tools::Mesh mesh;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) mesh.points.emplace_back(x - 10, y + 4, 5 + 0.3 * x);
  for (std::uint32_t corner : {0u, 1u, 3u}) {
    mesh.faces.push_back({corner, corner + 1, corner + 4});
    mesh.faces.push_back({corner + 3, corner, corner + 4});  // the other way round: a shadow has no sides
  }
  const int cells = 64;
  const std::vector<Point> outline = shadow(mesh, cells);
  // Every point of the outline is within a cell of the true one, 8 m long, and there the thinning adds 0.75 of a cell.
  const double cell = 2.0 / cells;
  assert_true(std::fabs(area(outline) - 3) < 8 * 1.75 * cell);
  assert_true(area(hull(outline)) > 3.5 - 8 * 1.75 * cell);
  assert_true(outline.size() < 20);
  assert_true(shadow({}, 8).empty());
}

static void numbers_read_well(void**) {
  const struct {
    double value;
    const char* text;
  } cases[] = {{0, "0"},         {0.5, "0.500"},      {97.04, "97.0"},        {991, "991"},         {1234.4, "1,230"},
               {999.6, "1,000"}, {-20000, "-20,000"}, {1234567, "1,230,000"}, {0.00123, "0.00123"}, {100, "100"}};
  for (const auto& c : cases) assert_string_equal(number(c.value).c_str(), c.text);
  assert_string_equal(number(1234.5, 5).c_str(), "1,234.5");
  assert_string_equal(number(std::nan("")).c_str(), "n/a");
  assert_string_equal(short_number(64).c_str(), "64");
  assert_string_equal(short_number(0.1).c_str(), "0.1");
  assert_string_equal(short_number(2048).c_str(), "2,048");
  assert_string_equal(short_number(1e-6).c_str(), "1e-06");
}

static void a_page_is_well_formed_and_shows_every_cell(void**) {
  Page page("a <page>");
  page.heading("one & two");
  page.paragraph("\"quoted\"");
  page.table({"a < b", {"scene", "steps/s"}, {{"A", "991"}, {"short"}}});
  page.drawing("a.svg", "a > b");
  const XmlCheck html(page.document());
  assert_true(html.well_formed());
  std::string cells;
  for (const Element& e : html.elements())
    if (e.name == "td") cells += "[" + e.text + "]";
  assert_string_equal(cells.c_str(), "[A][991][short][]");
}

/// A cube of side 2 seen from (10, 10, 10), a ball before it and another behind the camera: three faces (those towards
/// the camera), one disc, the farther painted first, all within what a pinhole sees.
static void a_cube_shows_the_three_faces_that_look_at_the_camera(void**) {
  carom::tools::Engine engine;
  carom::tools::Stage stage(engine);
  const auto add = [&](const char* shape, std::vector<double> params, const carom::tools::Vec& at) {
    carom::tools::Actor actor;
    carom::tools::Part part;
    part.shape = shape, part.params = std::move(params);
    actor.name = actor.kind = shape;
    actor.position = at;
    actor.parts.push_back(part);
    stage.add(actor);
  };
  add("box", {1, 1, 1}, {0, 0, 0});
  add("sphere", {0.5}, {4, 4, 4});
  add("sphere", {0.5}, {14, 14, 14});
  stage.ground_half_width = 0;
  stage.camera_from = {10, 10, 10}, stage.camera_to = {0, 0, 0};
  const std::string text = perspective(stage, "a cube & a ball", "<caption>");
  const XmlCheck drawing(text);
  assert_true(drawing.well_formed());
  int faces = 0, discs = 0;
  double right = 0, disc_x = 0, disc_radius = 0;
  for (const Element& e : drawing.elements()) {
    if (e.name == "circle") {
      ++discs;
      assert_int_equal(faces, 3);  // the cube first: it is farther
      disc_x = value(e, "cx"), disc_radius = value(e, "r");
    }
    if (e.name != "polygon") continue;
    ++faces;
    double x, y;
    int corners = 0, used;
    for (const char* s = e.attributes.at("points").c_str(); std::sscanf(s, "%lf,%lf%n", &x, &y, &used) == 2; s += used)
      ++corners, right = std::max(right, x);
    assert_int_equal(corners, 4);
  }
  assert_int_equal(faces, 3);
  assert_int_equal(discs, 1);
  // 900 px are 1.7 wide at a distance of 1: the ball at sqrt(108) m, in the middle; the cube's corner (1, 1, -1)
  // stands 2 / sqrt 2 m to the right, at 10 sqrt 3 - 1 / sqrt 3 m.
  assert_true(std::fabs(disc_x - 450) < 0.06 && std::fabs(disc_radius - 0.5 * 900 / (1.7 * std::sqrt(108.0))) < 0.06);
  const double depth = 10 * std::sqrt(3.0) - 1 / std::sqrt(3.0);
  assert_true(std::fabs(right - (450 + std::sqrt(2.0) * 900 / (1.7 * depth))) < 0.06);
}

/// Whether some folder of PATH has the command.
static bool is_installed(const std::string& command) {
  std::stringstream folders(std::getenv("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (std::filesystem::exists(folder + "/" + command)) return true;
  return false;
}

// With rsvg-convert twice as wide and high as the drawing says; without it an error that names what is missing, and
// nothing is left behind.
static void a_png_is_the_drawing_at_twice_its_size(void**) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "carom test of drawings";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string path = (folder / "a 'plot'.png").string(), svg = draw(powers_of_two());
  const XmlCheck drawing(svg);
  const auto& elements = drawing.elements();
  const auto root = std::find_if(elements.begin(), elements.end(), [](const Element& e) { return e.name == "svg"; });
  assert_true(root != elements.end());
  if (is_installed("rsvg-convert")) {
    carom::tools::write_drawing(path, svg);
    const std::string png = carom::tools::read_file(path, "");
    assert_true(png.size() > 2000 && png.starts_with("\x89PNG\r\n\x1a\n"));
    const auto size_at = [&](std::size_t at) {
      unsigned n = 0;
      for (std::size_t k = at; k < at + 4; ++k) n = n << 8 | static_cast<unsigned char>(png[k]);
      return n;
    };
    assert_int_equal(size_at(16), std::lround(2 * value(*root, "width")));
    assert_int_equal(size_at(20), std::lround(2 * value(*root, "height")));
    std::filesystem::remove(path);
  }
  const std::string had = std::getenv("PATH");
  setenv("PATH", folder.c_str(), 1);
  std::string remedy;
  try {
    carom::tools::write_drawing(path, svg);
  } catch (const carom::tools::Error& error) {
    remedy = error.remedy;
  }
  setenv("PATH", had.c_str(), 1);
  assert_non_null(std::strstr(remedy.c_str(), "librsvg2-bin"));
  assert_true(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_png_is_the_drawing_at_twice_its_size),
      cmocka_unit_test(a_cube_shows_the_three_faces_that_look_at_the_camera),
      cmocka_unit_test(the_checker_itself_refuses_what_is_not_well_formed),
      cmocka_unit_test(a_linear_axis_covers_the_data_with_four_to_eleven_round_ticks),
      cmocka_unit_test(a_log_axis_gives_equal_ratios_equal_lengths),
      cmocka_unit_test(a_datum_on_a_tick_is_drawn_on_the_tick),
      cmocka_unit_test(a_reference_is_dashed_and_grey_and_labelled),
      cmocka_unit_test(labels_of_lines_that_end_together_do_not_touch),
      cmocka_unit_test(a_datum_that_is_not_finite_is_left_out),
      cmocka_unit_test(bars_have_the_length_of_their_value_and_the_mark_its_place),
      cmocka_unit_test(log_bars_grow_by_equal_lengths_for_equal_ratios),
      cmocka_unit_test(a_panel_shows_metres_in_true_proportion_with_up_upward),
      cmocka_unit_test(the_hull_keeps_the_corners_and_drops_the_rest),
      cmocka_unit_test(the_shadow_of_a_mesh_keeps_its_hollows),
      cmocka_unit_test(numbers_read_well),
      cmocka_unit_test(a_page_is_well_formed_and_shows_every_cell),
  };
  return cmocka_run_group_tests_name("tools/report", tests, nullptr, nullptr);
}

// Elements as text, and the one style sheet that all drawings share.
#include "report/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace carom::report {
namespace {

// Colours of one scheme. Text in a series colour keeps 4.5:1 against the ground; the six also differ in lightness, and
// every line is labelled where it ends, for those who see no red or green.
struct Scheme {
  const char *ground, *ink, *soft, *grid, *reference, *bad, *lost;
  const char* series[6];
  const char* held[4];  // cells of a map, from barely to well
};
constexpr Scheme kLight = {"#fcfcfa",
                           "#1f2328",
                           "#62666d",
                           "#e4e4df",
                           "#6f7278",
                           "#c11f2e",
                           "#fdecec",
                           {"#1f66d0", "#b4450b", "#117a55", "#7a3fd0", "#8a5d00", "#a8326e"},
                           {"#eaf1fb", "#cddff6", "#a9c8f0", "#84b0ea"}};
constexpr Scheme kDark = {"#16181d",
                          "#e8e8e4",
                          "#a2a6ad",
                          "#30343b",
                          "#9a9da3",
                          "#ff7079",
                          "#3a1d21",
                          {"#74aaff", "#ff9d66", "#4ec98f", "#bb99f7", "#e3b341", "#f086b8"},
                          {"#1c2636", "#223a59", "#27497a", "#2c5aa0"}};

// Plain rules and no CSS variables: many viewers of SVG files know none.
std::string colours(const Scheme& c) {
  const auto rule = [](const std::string& selector, const char* property, const char* colour) {
    return selector + "{" + property + ":" + colour + "}";
  };
  std::string css = rule("text", "fill", c.ink) + rule(".bg", "fill", c.ground) + rule(".soft", "fill", c.soft) +
                    rule(".reft", "fill", c.reference) + rule(".axis", "stroke", c.soft) +
                    rule(".grid", "stroke", c.grid) + rule(".ref", "stroke", c.reference) +
                    rule(".halo,.edge,.under", "stroke", c.ground) + rule(".bad", "stroke", c.bad) +
                    rule(".badf,.badt", "fill", c.bad) + rule(".cell", "stroke", c.ground) +
                    rule(".lost", "fill", c.lost) + rule(".none", "fill", c.ground) + rule(".ring", "stroke", c.ink);
  for (int i = 0; i < 4; ++i) css += rule(".held" + std::to_string(i), "fill", c.held[i]);
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i);
    css += "\n" + rule(".s" + n, "stroke", c.series[i]) + rule(".f" + n + ",.t" + n, "fill", c.series[i]);
  }
  return css + "\n";
}

}  // namespace

std::string light_style_sheet() {
  return "text{font:12px system-ui,sans-serif}.title{font-size:15px;font-weight:600}line,polyline{fill:none}"
         ".axis,.grid,.edge{stroke-width:1}.ref{stroke-width:1.6;stroke-dasharray:5 4}"
         ".halo{stroke-width:4;paint-order:stroke}.under{stroke-width:5}polyline{stroke-width:2;stroke-linejoin:round}."
         "ghost{fill-opacity:.3}polyline.thin{stroke-width:1.1;stroke-opacity:.55}polyline.bold{stroke-width:3.4}"
         ".bad{stroke-width:1.6}.ring{fill:none;stroke-width:1.6}.tiny{font-size:10px}.label{font-weight:600}"
         ".fell{stroke-width:1.4;stroke-opacity:.8}\n" +
         colours(kLight);
}

std::string dark_style_sheet() { return colours(kDark); }

std::string style_sheet() {
  return light_style_sheet() + "@media(prefers-color-scheme:dark){" + dark_style_sheet() + "}";
}

namespace {

std::string px(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string s = text;
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + px(value) + "\""; }

std::string class_attribute(const std::string& classes) { return " class=\"" + escape(classes) + "\""; }

}  // namespace

std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20) {
      out += c;
    }
  }
  return out;
}

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "n/a";
  if (value == 0) return "0";
  char rounded[32];
  std::snprintf(rounded, sizeof rounded, "%.*e", std::max(digits, 1) - 1, value);
  double exact = 0;
  std::sscanf(rounded, "%lf", &exact);
  const int exponent = static_cast<int>(std::floor(std::log10(std::fabs(exact)) + 1e-9));
  if (exponent >= 9 || exponent < -4) return rounded;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::max(0, digits - 1 - exponent), exact);
  std::string s = text;
  const auto dot = s.find('.');
  const int first = s[0] == '-' ? 1 : 0;
  for (int i = static_cast<int>(dot == std::string::npos ? s.size() : dot) - 3; i > first; i -= 3)
    s.insert(static_cast<std::size_t>(i), ",");
  return s;
}

std::string short_number(double value) {
  std::string s = number(value, 6);
  if (s.find('e') != std::string::npos) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
  }
  if (s.find('.') == std::string::npos) return s;
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s;
}

std::string power_of_ten(double value) {
  if (!(value > 0)) return short_number(value);
  const int exponent = static_cast<int>(std::lround(std::log10(value)));
  if (std::fabs(value / std::pow(10, exponent) - 1) > 1e-9 || std::abs(exponent) < 3) return short_number(value);
  const char* raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                          "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[digit - '0'];
  return text;
}

std::string series(char role, int colour) { return std::string(1, role) + std::to_string(colour); }

double text_width(const std::string& text, double size) {
  // Continuation bytes of UTF-8 take no width of their own.
  const auto glyphs = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.56 * size * static_cast<double>(glyphs);
}

Svg::Svg(double width, double height, const std::string& title) : width_(width), height_(height), title_(title) {
  rect({0, 0}, width, height, "bg");
}

void Svg::line(Point a, Point b, const std::string& classes) {
  body_ += "<line" + attribute("x1", a.x) + attribute("y1", a.y) + attribute("x2", b.x) + attribute("y2", b.y) +
           class_attribute(classes) + "/>\n";
}

void Svg::points(const char* element, const std::vector<Point>& list, const std::string& classes) {
  body_ += std::string("<") + element + " points=\"";
  for (std::size_t i = 0; i < list.size(); ++i) body_ += (i ? " " : "") + px(list[i].x) + "," + px(list[i].y);
  body_ += "\"" + class_attribute(classes) + "/>\n";
}

void Svg::polyline(const std::vector<Point>& list, const std::string& classes) { points("polyline", list, classes); }

void Svg::polygon(const std::vector<Point>& list, const std::string& classes) { points("polygon", list, classes); }

void Svg::rect(Point corner, double width, double height, const std::string& classes) {
  body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", width) +
           attribute("height", height) + class_attribute(classes) + "/>\n";
}

void Svg::circle(Point centre, double radius, const std::string& classes) {
  body_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) +
           class_attribute(classes) + "/>\n";
}

void Svg::mark(Mark shape, Point c, double r, const std::string& classes, const std::string& attributes) {
  const auto closed = [&](const std::vector<Point>& corners) {
    body_ += "<polygon points=\"";
    for (std::size_t i = 0; i < corners.size(); ++i)
      body_ += (i ? " " : "") + px(corners[i].x) + "," + px(corners[i].y);
    body_ += "\"" + class_attribute(classes) + attributes + "/>\n";
  };
  switch (shape) {
    case Mark::circle:
      body_ += "<circle" + attribute("cx", c.x) + attribute("cy", c.y) + attribute("r", r) + class_attribute(classes) +
               attributes + "/>\n";
      break;
    case Mark::square:
      closed({{c.x - r, c.y - r}, {c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}});
      break;
    case Mark::triangle:
      closed({{c.x, c.y - 1.3 * r}, {c.x + 1.2 * r, c.y + 0.9 * r}, {c.x - 1.2 * r, c.y + 0.9 * r}});
      break;
    case Mark::diamond:
      closed({{c.x, c.y - 1.4 * r}, {c.x + 1.4 * r, c.y}, {c.x, c.y + 1.4 * r}, {c.x - 1.4 * r, c.y}});
      break;
    case Mark::cross:
      body_ += "<path d=\"M" + px(c.x - r) + " " + px(c.y - r) + "l" + px(2 * r) + " " + px(2 * r) + "m0 " +
               px(-2 * r) + "l" + px(-2 * r) + " " + px(2 * r) + "\" fill=\"none\"" + class_attribute(classes) +
               attributes + "/>\n";
      break;
  }
}

void Svg::text(Point at, Anchor anchor, const std::string& classes, const std::string& text) {
  const char* names[] = {"start", "middle", "end"};
  body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + " text-anchor=\"" + names[static_cast<int>(anchor)] +
           "\"" + class_attribute(classes) + ">" + escape(text) + "</text>\n";
}

void Svg::text_upward(Point at, const std::string& classes, const std::string& text) {
  body_ += "<text transform=\"translate(" + px(at.x) + " " + px(at.y) + ") rotate(-90)\" text-anchor=\"middle\"" +
           class_attribute(classes) + ">" + escape(text) + "</text>\n";
}

void Svg::open_clip(Point corner, double width, double height) {
  const std::string id = "clip" + std::to_string(clips_++);
  body_ += "<clipPath id=\"" + id + "\"><rect" + attribute("x", corner.x) + attribute("y", corner.y) +
           attribute("width", width) + attribute("height", height) + "/></clipPath>\n<g clip-path=\"url(#" + id +
           ")\">\n";
}

void Svg::open_group(const std::string& classes, const std::string& attributes) {
  body_ += "<g" + class_attribute(classes) + attributes + ">\n";
}

void Svg::close() { body_ += "</g>\n"; }

std::string Svg::root(const std::string& style) const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(width_) + " " + px(height_) + "\" width=\"" +
         px(width_) + "\" height=\"" + px(height_) + "\" role=\"img\">\n<title>" + escape(title_) + "</title>\n" +
         style + body_ + "</svg>\n";
}

std::string Svg::document() const { return root("<style>" + style_sheet() + "</style>\n"); }

std::string Svg::inlined() const { return root(""); }

}  // namespace carom::report

// Writes one self-contained SVG drawing: no script, no font file, colours that follow the reader's light or dark
// scheme.
#pragma once

#include <string>
#include <vector>

namespace carom::report {

/// A point of the drawing: px, x to the right, y DOWN, as in SVG.
struct Point {
  double x = 0;
  double y = 0;
};

enum class Anchor { start, middle, end };

/// Text made safe for SVG and HTML: &, <, >, " are replaced, control characters dropped.
std::string escape(const std::string& text);

/// A number as a reader wants it: `digits` significant digits, thousands separated by commas, no exponent below 1e9;
/// "n/a" if it is not finite.
std::string number(double value, int digits = 3);

/// A number as a tick of an axis wants it: up to six significant digits, no trailing zeros.
std::string short_number(double value);

/// A power of ten with its exponent raised, from a thousand up and a thousandth down; else as short_number().
std::string power_of_ten(double value);

/// Class of series `colour` (0..5): role 's' strokes, 'f' fills, 't' colours text.
std::string series(char role, int colour);

/// Collects elements and gives the document. Looks come from classes in svg.cpp's one style sheet: "s0".."s5" stroke a
/// series, "f0".."f5" fill one, "t0".."t5" colour its text, "ref" is another author's figure (grey, dashed), "reft"
/// its text, "axis", "grid", "soft" (quiet text), "title", "halo" (text over lines), "edge" (fill set off from its
/// neighbour), "under" (ground beneath a line that crosses a fill), "ghost" (paler), "thin" and "bold" (strokes), "bad"
/// and "badt" (a stroke and a text that warn), "badf" (such a fill), "cell" with "held0".."held3", "lost" or "none" (of a
/// map), "ring", "tiny", "label", "bg".
class Svg {
 public:
  /// @param width, height  px, > 0   @param title  read aloud and shown on hover
  Svg(double width, double height, const std::string& title);

  void line(Point a, Point b, const std::string& classes);
  void polyline(const std::vector<Point>& points, const std::string& classes);
  void polygon(const std::vector<Point>& points, const std::string& classes);
  void rect(Point corner, double width, double height, const std::string& classes);
  void circle(Point centre, double radius, const std::string& classes);
  enum class Mark { circle, square, triangle, diamond, cross };
  /// @param attributes  more of them, as mark-up: " data-x=\"1\""; given to the element
  void mark(Mark shape, Point centre, double radius, const std::string& classes, const std::string& attributes = "");
  void text(Point at, Anchor anchor, const std::string& classes, const std::string& text);
  /// Text turned a quarter to the left about `at`: the label of a vertical axis.
  void text_upward(Point at, const std::string& classes, const std::string& text);
  /// What follows, until close(), shows only inside the rectangle.
  void open_clip(Point corner, double width, double height);
  /// Elements that belong together, until close().
  void open_group(const std::string& classes, const std::string& attributes = "");
  void close();

  /// The whole document.
  std::string document() const;
  /// The same for a page that holds style_sheet() once.
  std::string inlined() const;

 private:
  std::string root(const std::string& style) const;
  void points(const char* element, const std::vector<Point>& points, const std::string& classes);
  double width_, height_;
  std::string title_, body_;
  int clips_ = 0;
};

/// What the classes above mean: by light, and dark where the reader's system is.
std::string style_sheet();
/// The same in two parts, for a page whose reader may choose: what dark changes comes after.
std::string light_style_sheet();
std::string dark_style_sheet();

/// Width of a text in the drawing's font, px, to about 10 %: enough to keep labels apart.
double text_width(const std::string& text, double size = 12);

}  // namespace carom::report

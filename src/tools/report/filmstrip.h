// Frames of a motion seen from the side, one panel a moment: a picture of a run that needs no viewer.
#pragma once

#include <string>
#include <vector>

#include "report/svg.h"

namespace carom::report {

/// The silhouette of one convex shape: m, world x to the right, world y up.
struct Outline {
  std::vector<Point> points;
  int colour = 0;      ///< 0..5
  bool ghost = false;  ///< paler: what does not move
};

struct Panel {
  std::string caption;
  std::vector<Outline> outlines;  ///< later ones are drawn over earlier ones
};

struct Filmstrip {
  std::string title;
  double left = 0, right = 1, bottom = 0, top = 1;  ///< m: the window that every panel shows
  double ground = 0;                                ///< m: height of the line drawn for the ground
  int columns = 2;
  std::vector<Panel> panels;
  std::string note;
};

/// Draw the panels in rows, 900 px wide, equal scales on both axes; outlines are clipped to their panel.
std::string draw(const Filmstrip& strip);

/// The points of a set that lie on its convex hull, counter-clockwise; fewer than three points are returned as they
/// are.
std::vector<Point> hull(std::vector<Point> points);

}  // namespace carom::report

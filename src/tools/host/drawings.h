// Drawings as files: SVG as it is, PNG by way of librsvg's command, which draws it.
#pragma once

#include <string>

namespace carom::tools {

/// Can a drawing be written there? Asked before a run.   @param path  ends in .svg or .png   @throws Error
void check_drawing_path(const std::string& path);
/// @param path  a .png is drawn, two pixels for each of the drawing's; a .svg gets the SVG
/// @throws Error "cannot write PATH", with what is missing
void write_drawing(const std::string& path, const std::string& svg);

}  // namespace carom::tools

// Drawings as files: SVG as it is, PNG by way of librsvg's command, which draws it.
#pragma once

#include <string>

namespace carom::tools {

/// @param path  a .png is drawn, two pixels for each of the drawing's; whatever else gets the SVG
/// @throws Error "cannot write PATH", with what is missing
void write_drawing(const std::string& path, const std::string& svg);

}  // namespace carom::tools

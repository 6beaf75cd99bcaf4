// Text tables, bars and numbers for a terminal.
#pragma once

#include <string>
#include <vector>

namespace carom::tools {

std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

/// Rows of cells, columns aligned to their widest cell; the first row is the header, underlined.
/// @param right  columns to align right (numbers)
std::string table(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& right = {});

/// A bar of `width` cells filled to `share` in [0, 1].
std::string bar(double share, int width);

}  // namespace carom::tools

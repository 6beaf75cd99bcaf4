// Whole files, read and written, with an error that says what to do.
#pragma once

#include <string>

namespace carom::tools {

/// Every byte.   @param remedy  of the error   @throws Error "cannot read PATH"
std::string read_file(const std::string& path, const std::string& remedy);
/// Replaces it.   @throws Error "cannot write PATH"
void write_file(const std::string& path, const std::string& content);

}  // namespace carom::tools

// Whole files, read and written, with an error that says what to do.
//
// What is read may come from strangers. A file that the user named is read if it is a regular file and not larger than the
// limit. What such a file refers to is read below its own folder alone, and no symbolic link is followed on the way.
#pragma once

#include <cstddef>
#include <string>

namespace carom::tools {

/// How much reading may take. Options of the program raise it.
struct FileLimits {
  std::size_t largest = std::size_t(256) << 20;  ///< bytes, of one file
  std::size_t factor = 64;                       ///< bytes of memory for each byte that was read, beyond `always`
  std::size_t always = std::size_t(64) << 20;    ///< bytes of memory that any file may take
};
FileLimits& file_limits();

/// Every byte.   @param remedy  of the error   @throws Error "cannot read PATH": missing, no regular file, too large
std::string read_file(const std::string& path, const std::string& remedy);
/// The same of a file that another one names.
/// @param folder    of the file that names it; "" is the working folder
/// @param relative  "buffers/scene.bin": neither absolute nor upward, no links   @throws Error
std::string read_below(const std::string& folder, const std::string& relative, const std::string& remedy);
/// Can a file of that name be written? Asked before a run, since its result would be lost. Writes nothing.
/// @throws Error "cannot write PATH: ..." with what to type instead
void check_output(const std::string& path);
/// Replaces it.   @throws Error "cannot write PATH"
void write_file(const std::string& path, const std::string& content);

}  // namespace carom::tools

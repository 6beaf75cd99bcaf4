// Files made of bytes, read as the tools read them: by format, seeds that are whole files, and words that the format knows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace carom::fuzz {

enum class FileFormat { gltf, glb, obj, stl, ply, snapshot, recording, sweep, count };
inline constexpr std::size_t kFileFormats = static_cast<std::size_t>(FileFormat::count);
const char* name_of(FileFormat format);

/// What came of it.
struct FileHeard {
  bool read = false;      // it was taken
  std::string complaint;  // else why it was refused; empty and not read: never
  std::string violation;  // something that no file may bring about: another exception, an error without a cure
};
/// @param bytes  of the whole file; the checksum of a snapshot is mended first
FileHeard read_as(FileFormat format, std::string bytes);

/// Whole files, made by hand and by `carom export`, `--save`, `--record`; the same in every run.
const std::vector<std::string>& seeds_of(FileFormat format);
/// Words, keys and numbers that a mutation puts in.
const std::vector<std::string>& words_of(FileFormat format);

}  // namespace carom::fuzz

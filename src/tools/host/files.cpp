#include "host/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "host/host.h"
#include "host/system.h"

namespace carom::tools {
namespace {

[[noreturn]] void cannot(const std::string& path, const std::string& why, const std::string& remedy) {
  throw Error("cannot read " + path + ": " + why, remedy);
}

std::string read_all(const FileToRead& opened, const std::string& path, const std::string& remedy) {
  if (!opened.file) cannot(path, opened.why, remedy);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(opened.file, std::fclose);
  const std::size_t most = file_limits().largest;
  const auto too_large = [&] {
    cannot(path, "it is larger than " + std::to_string(most >> 20) + " MiB",
           "read something smaller, or raise the limit: --file-limit MIB");
  };
  if (opened.size > most) too_large();
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(opened.size));
  char some[1 << 16];
  while (const std::size_t n = std::fread(some, 1, sizeof some, file.get())) {
    if (bytes.size() + n > most) too_large();  // it grew meanwhile
    bytes.append(some, n);
  }
  if (std::ferror(file.get())) cannot(path, std::strerror(errno), remedy);
  return bytes;
}

}  // namespace

FileLimits& file_limits() {
  static FileLimits limits;
  return limits;
}

std::string read_file(const std::string& path, const std::string& remedy) {
  return read_all(open_to_read(path), path, remedy);
}

std::string read_below(const std::string& folder, const std::string& relative, const std::string& remedy) {
  namespace fs = std::filesystem;
  const fs::path inner(relative);
  const std::string path = (fs::path(folder) / inner).string();
  std::vector<std::string> names;
  for (const fs::path& part : inner) names.push_back(part.string());
  for (const std::string& name : names)
    if (inner.has_root_path() || name == ".." || name.find('\0') != std::string::npos)
      cannot(path, "only what lies below its folder is read", remedy);
  if (names.empty()) cannot(path, "only what lies below its folder is read", remedy);
  if (names.back().empty()) cannot(path, "it has no name", remedy);
  return read_all(open_below(folder.empty() ? "." : folder, names), path, remedy);
}

void check_output(const std::string& path) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    throw Error("cannot write " + path + ": " + why, remedy);
  };
  std::error_code failed;
  if (fs::is_directory(path, failed))
    refuse("it is a folder", "add the name of a file: " + (fs::path(path) / "NAME").string());
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::exists(folder, failed))
    refuse("there is no folder " + folder.string(), "make it: mkdir -p " + folder.string() + ", or name another");
  if (!fs::is_directory(folder, failed))
    refuse(folder.string() + " is no folder", "name a file in a folder that exists");
  const bool exists = fs::exists(path, failed);
  if (const std::string why = why_not_written(exists ? path : folder.string()); !why.empty())
    refuse(why, "name a file in a folder that you may write to");
}

void write_file(const std::string& path, const std::string& content) {
  check_output(path);
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw Error("cannot write " + path, "check that the disk has space");
}

}  // namespace carom::tools

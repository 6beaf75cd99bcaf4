#include "host/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "host/host.h"

namespace carom::tools {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  Descriptor(Descriptor&& o) noexcept : fd_(std::exchange(o.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& o) noexcept {
    std::swap(fd_, o.fd_);
    return *this;
  }
  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }

 private:
  int fd_;
};

// O_NONBLOCK: opening a FIFO does not wait for somebody who writes to it.
constexpr int kReading = O_RDONLY | O_NONBLOCK | O_CLOEXEC;

[[noreturn]] void cannot(const std::string& path, const std::string& why, const std::string& remedy) {
  throw Error("cannot read " + path + why, remedy);
}

std::string read_all(const Descriptor& file, const std::string& path, const std::string& remedy) {
  if (!file)
    cannot(path, errno == ELOOP ? ": it is a symbolic link" : std::string(": ") + std::strerror(errno), remedy);
  struct stat about {};
  if (fstat(file.get(), &about) != 0 || !S_ISREG(about.st_mode)) cannot(path, ": it is no regular file", remedy);
  const std::size_t most = file_limits().largest;
  const auto too_large = [&] {
    cannot(path, ": it is larger than " + std::to_string(most >> 20) + " MiB",
           "read something smaller, or raise the limit: --file-limit MIB");
  };
  if (about.st_size < 0 || static_cast<std::uint64_t>(about.st_size) > most) too_large();
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(about.st_size));
  char some[1 << 16];
  for (;;) {
    const ssize_t n = read(file.get(), some, sizeof some);
    if (n == 0) return bytes;
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) cannot(path, std::string(": ") + std::strerror(errno), remedy);
    if (bytes.size() + static_cast<std::size_t>(n) > most) too_large();  // it grew meanwhile
    bytes.append(some, static_cast<std::size_t>(n));
  }
}

}  // namespace

FileLimits& file_limits() {
  static FileLimits limits;
  return limits;
}

std::string read_file(const std::string& path, const std::string& remedy) {
  return read_all(Descriptor(open(path.c_str(), kReading)), path, remedy);
}

std::string read_below(const std::string& folder, const std::string& relative, const std::string& remedy) {
  namespace fs = std::filesystem;
  const fs::path inner(relative);
  const std::string path = (fs::path(folder) / inner).string();
  if (inner.empty() || inner.is_absolute()) cannot(path, ": only what lies below its folder is read", remedy);
  Descriptor at(open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!at) cannot(folder, std::string(": ") + std::strerror(errno), remedy);
  for (auto part = inner.begin(); part != inner.end();) {
    const std::string name = part->string();
    if (name == ".." || name.find('\0') != std::string::npos)
      cannot(path, ": only what lies below its folder is read", remedy);
    const bool last = ++part == inner.end();
    Descriptor next(openat(at.get(), name.c_str(), kReading | O_NOFOLLOW | (last ? 0 : O_DIRECTORY)));
    if (last) return read_all(next, path, remedy);
    if (!next)
      cannot(path,
             errno == ELOOP || errno == ENOTDIR ? ": a folder on the way is a link, or none"
                                                : std::string(": ") + std::strerror(errno),
             remedy);
    at = std::move(next);
  }
  cannot(path, ": it has no name", remedy);
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
  if (access(exists ? path.c_str() : folder.c_str(), W_OK) != 0)
    refuse(std::strerror(errno), "name a file in a folder that you may write to");
}

void write_file(const std::string& path, const std::string& content) {
  check_output(path);
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw Error("cannot write " + path, "check that the disk has space");
}

}  // namespace carom::tools

// Linux, macOS and other systems with fork(), and WebAssembly, where its calls fail.
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/auxv.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "host/host.h"
#include "host/system.h"

extern char** environ;

namespace carom::tools {
namespace {

std::vector<char*> as_line(std::vector<std::string>& words) {
  std::vector<char*> line;
  for (std::string& word : words) line.push_back(word.data());
  line.push_back(nullptr);
  return line;
}

/// @return what went wrong, 0: nothing
int spawn(pid_t& child, std::vector<std::string> words) {
  posix_spawnattr_t attributes;  // a child hears the signals that a server keeps from its threads
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setsigmask(&attributes, &none);
  const int failed = posix_spawnp(&child, words[0].c_str(), nullptr, &attributes, as_line(words).data(), environ);
  posix_spawnattr_destroy(&attributes);
  return failed;
}

// O_NONBLOCK: opening a FIFO does not wait for somebody who writes to it.
constexpr int kReading = O_RDONLY | O_NONBLOCK | O_CLOEXEC;

/// @param fd  closed in any case   @param why  if it is negative
FileToRead regular_file(int fd, std::string why) {
  FileToRead opened;
  struct stat about {};
  if (fd < 0)
    opened.why = std::move(why);
  else if (fstat(fd, &about) != 0 || !S_ISREG(about.st_mode))
    opened.why = "it is no regular file";
  else if (opened.file = fdopen(fd, "rb"); !opened.file)
    opened.why = std::strerror(errno);
  opened.size = static_cast<std::uint64_t>(about.st_size);
  if (!opened.file && fd >= 0) close(fd);
  return opened;
}

[[noreturn]] void be_child(const ChildWork& work, const std::vector<std::string>& words, unsigned cpu_seconds,
                           void* shared) {
  const rlimit cpu = {cpu_seconds, cpu_seconds + 1};
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CPU, &cpu);
  setrlimit(RLIMIT_CORE, &no_core);
  int status = kChildThrew;
  try {
    status = work.run(shared, words);
  } catch (...) {  // or it would go on as a second parent
  }
  std::fflush(nullptr);
  _exit(status);  // no destructors of the parent's copies
}

}  // namespace

const char* const kPluginEnding = ".so";
const char kBetweenFolders = ':';

std::string own_program(const char* link) {
  namespace fs = std::filesystem;
  std::error_code failed;
#if defined(__APPLE__)
  char path[4096];
  std::uint32_t size = sizeof path;
  const fs::path started = _NSGetExecutablePath(path, &size) == 0 ? path : "";
  (void)link;
#else
  const fs::path kernels = fs::read_symlink(link, failed);
  if (!failed) return kernels.string();
#if defined(__linux__)
  const auto* name = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  const fs::path started = name ? name : "";
#else
  const fs::path started;
#endif
#endif
  const fs::path own = started.empty() ? fs::path() : fs::canonical(started, failed);
  return failed ? "" : own.string();
}

bool errors_are_seen() { return isatty(STDERR_FILENO); }

FileToRead open_to_read(const std::string& path) {
  const int fd = open(path.c_str(), kReading);
  return regular_file(fd, fd < 0 ? std::strerror(errno) : "");
}

FileToRead open_below(const std::string& folder, const std::vector<std::string>& names) {
  int at = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  std::string why = at < 0 ? folder + ": " + std::strerror(errno) : "";
  for (std::size_t i = 0; i < names.size() && at >= 0; ++i) {
    const bool last = i + 1 == names.size();
    const int next = openat(at, names[i].c_str(), kReading | O_NOFOLLOW | (last ? 0 : O_DIRECTORY));
    if (next < 0)
      why = last && errno == ELOOP                          ? "it is a symbolic link"
            : !last && (errno == ELOOP || errno == ENOTDIR) ? "a folder on the way is a link, or none"
                                                            : std::strerror(errno);
    close(at);
    at = next;
  }
  return regular_file(at, why);
}

std::string why_not_written(const std::string& path) {
  return access(path.c_str(), W_OK) == 0 ? "" : std::strerror(errno);
}

const void* load_symbol(const std::string& path, const char* symbol, std::string& why) {
  void* object = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* found = object ? dlsym(object, symbol) : nullptr;
  const char* said = found ? nullptr : dlerror();
  why = said ? said : "";
  return found;
}

int run_program(const std::vector<std::string>& line) {
  pid_t child = 0;
  const int failed = spawn(child, line);
  if (failed) return failed == ENOENT ? kNoProgram : kProgramFailed;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return kProgramFailed;
  if (!WIFEXITED(status)) return kProgramFailed;
  return WEXITSTATUS(status) == 127 ? kNoProgram : WEXITSTATUS(status);
}

bool open_in_browser(const std::string& address) {
  pid_t child = 0;
#if defined(__APPLE__)
  return spawn(child, {"open", address}) == 0;
#else
  return spawn(child, {"xdg-open", address}) == 0;
#endif
}

std::string signal_text(int signal) { return strsignal(signal); }

SharedMemory::SharedMemory(std::size_t size) : size_(size) {
  void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error("no memory for a child process", "free some memory and try again");
  data_ = memory;
}

SharedMemory::~SharedMemory() { munmap(data_, size_); }

ChildEnd run_in_child(const ChildWork& work, const std::vector<std::string>& words, unsigned cpu_seconds,
                      SharedMemory& shared) {
  std::fflush(nullptr);  // or the child would print our pending text again
  const pid_t child = fork();
  if (child < 0) throw Error("cannot start a child process", "the limit of processes may be reached; try again later");
  if (child == 0) be_child(work, words, cpu_seconds, shared.data());
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(2 * cpu_seconds + 5);  // for one that sleeps
  ChildEnd end;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (Clock::now() > deadline && !end.out_of_time) {
      end.out_of_time = true;
      kill(child, SIGKILL);
    }
    usleep(2000);
  }
  if (WIFSIGNALED(status)) {
    end.signal = WTERMSIG(status);
    end.out_of_time = end.out_of_time || end.signal == SIGXCPU;
  } else {
    end.status = WEXITSTATUS(status);
    end.left = true;
  }
  return end;
}

int child_main(int, char**, const std::vector<ChildWork>&) { return -1; }

}  // namespace carom::tools

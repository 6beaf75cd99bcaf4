// What the command asks of the system beside files: processes, terminals, shared objects. Of system_*.cpp one is compiled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace carom::tools {

extern const char* const kPluginEnding;  ///< ".so"; on Windows ".dll"
extern const char kBetweenFolders;       ///< in a list of them: ':'; on Windows ';'

/// This program's file; "" where nothing says it.
/// @param link  the kernel's, where there is one; else the name by which the program was started counts
std::string own_program(const char* link = "/proc/self/exe");

/// Whether errors are printed to a person who sees lines change.
bool errors_are_seen();

struct FileToRead {
  std::FILE* file = nullptr;  ///< the caller closes it; null: `why` says the reason
  std::uint64_t size = 0;
  std::string why;
};
/// A regular file. Who might write to something else is not waited for.
FileToRead open_to_read(const std::string& path);
/// The same below a folder, where no name on the way may be a link.   @param names  folders, then the file
FileToRead open_below(const std::string& folder, const std::vector<std::string>& names);
/// Whether a file or a folder may be written to.   @return "", or why not
std::string why_not_written(const std::string& path);

/// The address of a symbol in a shared object, which stays loaded.
/// @param why  out: what the system says if there is none
const void* load_symbol(const std::string& path, const char* symbol, std::string& why);

/// Run a program of the search path and wait for its end.
/// @return its exit status; kNoProgram: it is not there; kProgramFailed: it could not be run, or was ended
inline constexpr int kNoProgram = -1, kProgramFailed = -2;
int run_program(const std::vector<std::string>& line);
/// Show an address in a browser.   @return false: there is no program that does
bool open_in_browser(const std::string& address);

/// How a child ended.
struct ChildEnd {
  bool left = false;         ///< by itself, with `status`
  bool out_of_time = false;  ///< CPU or wall-clock limit
  int signal = 0;            ///< that ended it, or 0
  int status = 0;
};
/// "Segmentation fault".
std::string signal_text(int signal);

/// Memory that a child writes and its parent reads, zeroed.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t size);  ///< @throws Error
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  void* data() const { return data_; }
  std::size_t size() const { return size_; }
  void* handle() const { return handle_; }  ///< the system's, where it has one

 private:
  void* data_ = nullptr;
  void* handle_ = nullptr;
  std::size_t size_;
};

/// Work for a process of its own. It has a name since where a process can't be copied, the program is started anew.
struct ChildWork {
  const char* name;
  /// @return exit status   @param shared  of the parent's SharedMemory
  int (*run)(void* shared, const std::vector<std::string>& words);
};
/// Have it done under a CPU limit, and a wall-clock limit of twice that and 5 s. What throws there exits with kChildThrew.
/// @param cpu_seconds  whole seconds, >= 1   @throws Error if no process can be made
inline constexpr int kChildThrew = 125;
ChildEnd run_in_child(const ChildWork& work, const std::vector<std::string>& words, unsigned cpu_seconds,
                      SharedMemory& shared);

/// First of all in main(): where this program was started as somebody's child, do the work.
/// @return exit status, or -1: it was not
int child_main(int argc, char** argv, const std::vector<ChildWork>& works);

}  // namespace carom::tools

// Windows: no process is copied there, so a child is this program once more, which child_main() tells.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// after it
#include <io.h>
#include <shellapi.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "host/host.h"
#include "host/system.h"

namespace carom::tools {
namespace {

constexpr const char* kChildMark = "--carom-child";  // then: name of the work, handle and size of its memory, words

std::wstring wide(const std::string& text) {
  const int letters = MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0);
  std::wstring made(static_cast<std::size_t>(letters), L' ');
  MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), made.data(), letters);
  return made;
}

std::string error_text(DWORD error) {
  char text[256] = {0};
  FormatMessageA(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, error, 0, text, 255, nullptr);
  std::string said = text;
  while (!said.empty() && static_cast<unsigned char>(said.back()) <= ' ') said.pop_back();
  return said.empty() ? "Windows error " + std::to_string(error) : said;
}

/// One line, quoted so that the program's C library takes it apart into the same words.
std::wstring as_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "\"" : " \"";
    std::size_t backslashes = 0;
    for (const char c : word) {
      if (c == '"') line.append(backslashes + 1, '\\');  // each before a quote is doubled
      backslashes = c == '\\' ? backslashes + 1 : 0;
      line += c;
    }
    line.append(backslashes, '\\');
    line += '"';
  }
  return wide(line);
}

class Handle {
 public:
  explicit Handle(HANDLE handle) : handle_(handle) {}
  ~Handle() {
    if (handle_) CloseHandle(handle_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  HANDLE get() const { return handle_; }

 private:
  HANDLE handle_;
};

/// @return its process, or null
HANDLE start(const std::vector<std::string>& words, const wchar_t* program, HANDLE job) {
  STARTUPINFOW how{};
  how.cb = sizeof how;
  PROCESS_INFORMATION made{};
  std::wstring line = as_line(words);
  if (!CreateProcessW(program, line.data(), nullptr, nullptr, TRUE, job ? CREATE_SUSPENDED : 0, nullptr, nullptr, &how,
                      &made))
    return nullptr;
  if (job) {
    AssignProcessToJobObject(job, made.hProcess);
    ResumeThread(made.hThread);
  }
  CloseHandle(made.hThread);
  return made.hProcess;
}

double cpu_seconds_of(HANDLE process) {
  FILETIME made, ended, kernel, user;
  if (!GetProcessTimes(process, &made, &ended, &kernel, &user)) return 0;
  const auto ticks = [](FILETIME t) { return static_cast<double>(t.dwHighDateTime) * 0x1p32 + t.dwLowDateTime; };
  return 1e-7 * (ticks(kernel) + ticks(user));
}

/// The signal that a POSIX system would send for what ended a process, or 0.
int signal_of(DWORD status) {
  switch (status) {
    case EXCEPTION_ACCESS_VIOLATION:
    case EXCEPTION_STACK_OVERFLOW:
    case EXCEPTION_IN_PAGE_ERROR:
    case EXCEPTION_DATATYPE_MISALIGNMENT:
    case EXCEPTION_ARRAY_BOUNDS_EXCEEDED:
      return SIGSEGV;
    case EXCEPTION_ILLEGAL_INSTRUCTION:
    case EXCEPTION_PRIV_INSTRUCTION:
      return SIGILL;
    case EXCEPTION_INT_DIVIDE_BY_ZERO:
    case EXCEPTION_FLT_INVALID_OPERATION:
      return SIGFPE;
    case 3:           // abort() of the C library
    case 0xC0000409:  // and its newer way
      return SIGABRT;
    default:
      return status >= 0xC0000000 ? SIGSEGV : 0;
  }
}

}  // namespace

const char* const kPluginEnding = ".dll";
const char kBetweenFolders = ';';

std::string own_program(const char*) {
  wchar_t path[4096];
  const DWORD length = GetModuleFileNameW(nullptr, path, 4096);
  return length == 0 || length == 4096 ? "" : std::filesystem::path(path).string();
}

bool errors_are_seen() { return _isatty(_fileno(stderr)); }

FileToRead open_to_read(const std::string& path) {
  FileToRead opened;
  std::error_code failed;
  const std::filesystem::path file = wide(path);
  if (!std::filesystem::exists(file, failed))
    opened.why = "there is no such file";
  else if (!std::filesystem::is_regular_file(file, failed))
    opened.why = "it is no regular file";
  else if (opened.file = _wfopen(file.c_str(), L"rb"); !opened.file)
    opened.why = std::strerror(errno);
  else
    opened.size = std::filesystem::file_size(file, failed);
  return opened;
}

/// Links are junctions there, too. Who may change a folder meanwhile may read what it leads to anyway: making a link takes
/// an administrator.
FileToRead open_below(const std::string& folder, const std::vector<std::string>& names) {
  std::filesystem::path path = wide(folder);
  for (const std::string& name : names) {
    path /= wide(name);
    const DWORD about = GetFileAttributesW(path.c_str());
    if (about != INVALID_FILE_ATTRIBUTES && about & FILE_ATTRIBUTE_REPARSE_POINT)
      return {nullptr, 0, "it, or a folder on the way, is a link"};
  }
  return open_to_read(path.string());
}

std::string why_not_written(const std::string& path) {
  return _waccess(wide(path).c_str(), 2) == 0 ? "" : "permission denied";
}

const void* load_symbol(const std::string& path, const char* symbol, std::string& why) {
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);  // no windows
  HMODULE object = LoadLibraryExW(wide(path).c_str(), nullptr, LOAD_WITH_ALTERED_SEARCH_PATH);
  const auto found = object ? reinterpret_cast<const void*>(GetProcAddress(object, symbol)) : nullptr;
  if (!found) why = path + ": " + error_text(GetLastError());
  return found;
}

int run_program(const std::vector<std::string>& line) {
  const Handle process(start(line, nullptr, nullptr));
  if (!process.get()) return GetLastError() == ERROR_FILE_NOT_FOUND ? kNoProgram : kProgramFailed;
  DWORD status = 0;
  WaitForSingleObject(process.get(), INFINITE);
  return GetExitCodeProcess(process.get(), &status) && status < 0xC0000000 ? static_cast<int>(status) : kProgramFailed;
}

bool open_in_browser(const std::string& address) {
  return reinterpret_cast<std::intptr_t>(
             ShellExecuteW(nullptr, L"open", wide(address).c_str(), nullptr, nullptr, SW_SHOWNORMAL)) > 32;
}

std::string signal_text(int signal) {
  return signal == SIGSEGV   ? "access to memory that it has not"
         : signal == SIGABRT ? "abort()"
         : signal == SIGFPE  ? "division by zero"
                             : "an instruction that there is not";
}

SharedMemory::SharedMemory(std::size_t size) : size_(size) {
  SECURITY_ATTRIBUTES inherited = {sizeof inherited, nullptr, TRUE};
  handle_ = CreateFileMappingW(INVALID_HANDLE_VALUE, &inherited, PAGE_READWRITE, 0, static_cast<DWORD>(size), nullptr);
  data_ = handle_ ? MapViewOfFile(handle_, FILE_MAP_ALL_ACCESS, 0, 0, size) : nullptr;
  if (!data_) throw Error("no memory for a child process", "free some memory and try again");
}

SharedMemory::~SharedMemory() {
  UnmapViewOfFile(data_);
  CloseHandle(handle_);
}

ChildEnd run_in_child(const ChildWork& work, const std::vector<std::string>& words, unsigned cpu_seconds,
                      SharedMemory& shared) {
  std::fflush(nullptr);
  std::vector<std::string> line = {own_program(), kChildMark, work.name,
                                   std::to_string(reinterpret_cast<std::uintptr_t>(shared.handle())),
                                   std::to_string(shared.size())};
  line.insert(line.end(), words.begin(), words.end());
  const Handle job(CreateJobObjectW(nullptr, nullptr));  // what the child starts ends with it
  const Handle process(start(line, wide(line[0]).c_str(), job.get()));
  if (!process.get())
    throw Error("cannot start a child process", "the limit of processes may be reached; try again later");
  ChildEnd end;
  const ULONGLONG deadline = GetTickCount64() + 1000 * (2 * cpu_seconds + 5);  // for one that sleeps
  while (WaitForSingleObject(process.get(), 20) == WAIT_TIMEOUT)
    if (!end.out_of_time && (cpu_seconds_of(process.get()) > cpu_seconds || GetTickCount64() > deadline)) {
      end.out_of_time = true;
      TerminateJobObject(job.get(), 1);
      TerminateProcess(process.get(), 1);
    }
  DWORD status = 0;
  GetExitCodeProcess(process.get(), &status);
  end.signal = end.out_of_time ? SIGTERM : signal_of(status);
  end.left = !end.signal;
  end.status = end.left ? static_cast<int>(status) : 0;
  return end;
}

int child_main(int argc, char** argv, const std::vector<ChildWork>& works) {
  if (argc < 5 || std::strcmp(argv[1], kChildMark) != 0) return -1;
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);  // no windows
  const auto handle = reinterpret_cast<HANDLE>(static_cast<std::uintptr_t>(std::strtoull(argv[3], nullptr, 10)));
  void* shared = MapViewOfFile(handle, FILE_MAP_ALL_ACCESS, 0, 0, std::strtoull(argv[4], nullptr, 10));
  if (!shared) return kChildThrew;
  for (const ChildWork& work : works) {
    if (std::strcmp(work.name, argv[2]) != 0) continue;
    int status = kChildThrew;
    try {
      status = work.run(shared, std::vector<std::string>(argv + 5, argv + argc));
    } catch (...) {
    }
    std::fflush(nullptr);
    std::_Exit(status);
  }
  return kChildThrew;
}

}  // namespace carom::tools

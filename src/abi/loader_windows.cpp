// Shared objects of Windows. The only file of the library that knows that system.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <cctype>
#include <cstdio>
#include <cstring>

#include "abi/loader.h"

namespace carom::abi::system {
namespace {

constexpr int kLongest = 4096;  // letters of a path

/// A path of UTF-8 as the system wants it.
struct Wide {
  explicit Wide(const char* path) {
    if (!MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, text, kLongest)) text[0] = 0;
  }
  wchar_t text[kLongest];
};

void say_last_error(char* why, std::size_t size) {
  const DWORD error = GetLastError();
  wchar_t text[256] = {0};
  FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, error,
                 MAKELANGID(LANG_ENGLISH, SUBLANG_ENGLISH_US), text, 255, nullptr);
  char narrow[512] = {0};
  WideCharToMultiByte(CP_UTF8, 0, text, -1, narrow, sizeof narrow - 1, nullptr, nullptr);
  std::size_t length = std::strlen(narrow);
  while (length && std::isspace(static_cast<unsigned char>(narrow[length - 1]))) narrow[--length] = 0;
  std::snprintf(why, size, "%s%s (Windows error %lu)", narrow[0] ? narrow : "it can't be loaded",
                error == ERROR_MOD_NOT_FOUND ? " A library that it needs is missing." : "", error);
}

}  // namespace

const char* const kEnding = ".dll";
const char* const kOpenCl = "OpenCL.dll";
const char kBetween = ';';
const char* const kSlashes = "/\\";

bool is_absolute(std::string_view path) {  // C:\ or \\server\share
  const auto slash = [&](std::size_t at) { return path[at] == '/' || path[at] == '\\'; };
  return path.size() >= 3 && ((path[1] == ':' && slash(2)) || (slash(0) && slash(1)));
}

bool is_file(const char* path) {
  const DWORD about = GetFileAttributesW(Wide(path).text);
  return about != INVALID_FILE_ATTRIBUTES && !(about & FILE_ATTRIBUTE_DIRECTORY);
}

const char* variable(const char* name, char* space, std::size_t size) {
  wchar_t value[kLongest];
  const DWORD length = GetEnvironmentVariableW(Wide(name).text, value, kLongest);
  if (length == 0 || length >= kLongest) return nullptr;
  return WideCharToMultiByte(CP_UTF8, 0, value, -1, space, static_cast<int>(size), nullptr, nullptr) ? space : nullptr;
}

void own_file(char* path, std::size_t size) {
  path[0] = 0;
  HMODULE self = nullptr;
  wchar_t text[kLongest];
  if (!GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                          reinterpret_cast<LPCWSTR>(&kEnding), &self))
    return;
  const DWORD length = GetModuleFileNameW(self, text, kLongest);
  if (length == 0 || length == kLongest ||
      !WideCharToMultiByte(CP_UTF8, 0, text, -1, path, static_cast<int>(size), nullptr, nullptr))
    path[0] = 0;
}

std::FILE* open_file(const char* path) { return _wfopen(Wide(path).text, L"rb"); }

Symbol load(const char* path, const char* symbol, char* why, std::size_t size) {
  Symbol found;
  DWORD mode = 0;
  SetThreadErrorMode(SEM_FAILCRITICALERRORS | SEM_NOOPENFILEERRORBOX, &mode);  // no window
  // What it needs may lie beside it.
  Wide wide(path);
  for (wchar_t* c = wide.text; *c; ++c)
    if (*c == L'/') *c = L'\\';
  HMODULE library = LoadLibraryExW(wide.text, nullptr, LOAD_WITH_ALTERED_SEARCH_PATH);
  if (library) GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_PIN, wide.text, &library);
  found.at = library ? reinterpret_cast<const void*>(GetProcAddress(library, symbol)) : nullptr;
  if (!found.at) {
    const DWORD error = GetLastError();
    if (library)
      std::snprintf(why, size, "it exports no %s", symbol);
    else
      SetLastError(error), say_last_error(why, size);
  }
  SetThreadErrorMode(mode, nullptr);
  MEMORY_BASIC_INFORMATION about;
  if (found.at && VirtualQuery(found.at, &about, sizeof about)) {
    constexpr DWORD kCode = PAGE_EXECUTE | PAGE_EXECUTE_READ | PAGE_EXECUTE_READWRITE | PAGE_EXECUTE_WRITECOPY;
    found.is_data = !(about.Protect & kCode);
    found.bytes = static_cast<std::size_t>(static_cast<const char*>(about.BaseAddress) + about.RegionSize -
                                           static_cast<const char*>(found.at));
  }
  return found;
}

}  // namespace carom::abi::system

// Shared objects by dlopen(): Linux with any C library, macOS, the BSDs. The only file that knows what they are inside.
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__APPLE__)
#include <mach-o/loader.h>
#include <mach/vm_prot.h>
#else
#include <link.h>
#endif

#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "abi/loader.h"

namespace carom::abi::system {
namespace {

/// @param symbol  its `at` is known; what lies there is filled in
#if defined(RTLD_DL_SYMENT)  // glibc says how large a symbol is
void measure(Symbol& symbol) {
  Dl_info info;
  const ElfW(Sym)* found = nullptr;
  if (!dladdr1(symbol.at, &info, const_cast<void**>(reinterpret_cast<const void**>(&found)), RTLD_DL_SYMENT) || !found)
    return;
  symbol.is_data = ELF64_ST_TYPE(found->st_info) == STT_OBJECT;
  symbol.bytes = found->st_size;
}
#elif defined(__APPLE__)
template <class Look>
void each_segment(const mach_header_64* header, Look&& look) {
  const char* next = reinterpret_cast<const char*>(header + 1);
  for (std::uint32_t i = 0; i < header->ncmds; ++i) {
    load_command command;
    std::memcpy(&command, next, sizeof command);
    segment_command_64 segment;
    if (command.cmd == LC_SEGMENT_64) std::memcpy(&segment, next, sizeof segment), look(segment);
    next += command.cmdsize;
  }
}
/// The rest of its segment. A description holds pointers, so it is never in the segment of code.
void measure(Symbol& symbol) {
  Dl_info info;
  if (!dladdr(symbol.at, &info) || !info.dli_fbase) return;
  const auto* header = static_cast<const mach_header_64*>(info.dli_fbase);
  const std::uintptr_t at = reinterpret_cast<std::uintptr_t>(symbol.at);
  std::uintptr_t moved = 0;  // from where the linker put it; the header begins the file
  each_segment(header, [&](const segment_command_64& s) {
    if (s.fileoff == 0 && s.filesize > 0) moved = reinterpret_cast<std::uintptr_t>(header) - s.vmaddr;
  });
  each_segment(header, [&](const segment_command_64& s) {
    if (const std::uintptr_t within = at - moved - s.vmaddr; within < s.vmsize)
      symbol.is_data = !(s.initprot & VM_PROT_EXECUTE), symbol.bytes = s.vmsize - within;
  });
}
#else
/// The rest of what was loaded together with it.
void measure(Symbol& symbol) {
  dl_iterate_phdr(
      [](dl_phdr_info* object, std::size_t, void* context) {
        auto& asked = *static_cast<Symbol*>(context);
        const auto at = reinterpret_cast<std::uintptr_t>(asked.at);
        for (int i = 0; i < object->dlpi_phnum; ++i) {
          const ElfW(Phdr)& part = object->dlpi_phdr[i];
          const std::uintptr_t within = at - object->dlpi_addr - part.p_vaddr;
          if (part.p_type != PT_LOAD || within >= part.p_memsz) continue;
          asked.is_data = !(part.p_flags & PF_X);
          asked.bytes = part.p_memsz - within;
          return 1;
        }
        return 0;
      },
      &symbol);
}
#endif

}  // namespace

const char* const kEnding = ".so";
const char kBetween = ':';
const char* const kSlashes = "/";
#if defined(__APPLE__)
const char* const kOpenCl = "/System/Library/Frameworks/OpenCL.framework/OpenCL";
#else
const char* const kOpenCl = "libOpenCL.so.1";
#endif

bool is_absolute(std::string_view path) { return path.starts_with('/'); }

bool is_file(const char* path) {
  struct stat status;
  return stat(path, &status) == 0 && S_ISREG(status.st_mode);
}

const char* variable(const char* name, char*, std::size_t) {
#if defined(__linux__)
  return secure_getenv(name);
#else
  return issetugid() ? nullptr : std::getenv(name);
#endif
}

void own_file(char* path, std::size_t size) {
  Dl_info here;
  char real[PATH_MAX];
  const bool known =
      dladdr(reinterpret_cast<const void*>(&carom_version), &here) && here.dli_fname && realpath(here.dli_fname, real);
  std::snprintf(path, size, "%s", known ? real : "");
}

std::FILE* open_file(const char* path) { return std::fopen(path, "rb"); }

Symbol load(const char* path, const char* symbol, char* why, std::size_t size) {
  Symbol found;
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  found.at = library ? dlsym(library, symbol) : nullptr;
  if (found.at) {
    measure(found);
  } else {
    const char* said = dlerror();
    std::snprintf(why, size, "%s", said ? said : "");
  }
  return found;
}

}  // namespace carom::abi::system

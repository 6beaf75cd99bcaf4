#include "abi/object_file.h"

#include <algorithm>
#include <cstring>

namespace carom::abi {
namespace {

constexpr const char* kElf = "Linux (ELF)";
constexpr const char* kMac = "macOS";
constexpr const char* kWindows = "Windows";
constexpr const char* kWasm = "WebAssembly";

struct Machine {
  std::uint32_t elf, mach, pe;  // its number in each format; 0: none
  const char* name;
};
constexpr Machine kMachines[] = {{62, 0x01000007, 0x8664, "x86-64"},
                                 {183, 0x0100000C, 0xAA64, "arm64"},
                                 {3, 7, 0x014C, "32-bit x86"},
                                 {40, 12, 0x01C4, "32-bit ARM"},
                                 {243, 0, 0x5064, "RISC-V"},
                                 {21, 0, 0, "64-bit PowerPC"},
                                 {22, 0, 0, "S/390"},
                                 {258, 0, 0x6264, "LoongArch"}};

const char* machine_of(std::uint32_t Machine::*format, std::uint64_t number) {
  for (const Machine& machine : kMachines)
    if (number && machine.*format == number) return machine.name;
  return "another processor";
}

struct Head {
  const unsigned char* bytes;
  std::size_t size;
  bool begins(const char* text, std::size_t count) const { return size >= count && !std::memcmp(bytes, text, count); }
  /// 0 beyond the end
  std::uint64_t number(std::uint64_t at, std::size_t count, bool big_first = false) const {
    std::uint64_t n = 0;
    for (std::size_t i = 0; i < count && at < size && size - at >= count; ++i)
      n = n << 8 | bytes[at + (big_first ? i : count - 1 - i)];
    return n;
  }
};

ObjectKind elf(const Head& head) {
  const bool wide = head.number(4, 1) == 2, big = head.number(5, 1) == 2;
  const std::size_t word = wide ? 8 : 4;
  const auto number = [&](std::uint64_t at, std::size_t count) { return head.number(at, count, big); };
  ObjectKind kind = {kElf, machine_of(&Machine::elf, number(18, 2))};
  const std::uint64_t first = number(wide ? 32 : 28, word), each = number(wide ? 54 : 42, 2),
                      count = number(wide ? 56 : 44, 2);
  kind.least = first + each * count;
  for (std::uint64_t i = 0; i < count; ++i) {  // what is loaded: where in the file, and how much of it
    const std::uint64_t part = first + i * each;
    if (number(part, 4) == 1)
      kind.least = std::max(kind.least, number(part + word, word) + number(part + 4 * word, word));
  }
  return kind;
}

}  // namespace

ObjectKind object_kind(const unsigned char* bytes, std::size_t size) {
  const Head head{bytes, size};
  if (head.begins("\177ELF", 4)) return elf(head);
  if (head.begins("\xCF\xFA\xED\xFE", 4) || head.begins("\xCE\xFA\xED\xFE", 4))
    return {kMac, machine_of(&Machine::mach, head.number(4, 4))};
  if (head.begins("\xCA\xFE\xBA\xBE", 4)) return {kMac, nullptr};  // several in one
  if (head.begins("MZ", 2)) return {kWindows, machine_of(&Machine::pe, head.number(head.number(0x3C, 4) + 4, 2))};
  if (head.begins("\0asm", 4)) return {kWasm, nullptr};
  return {};
}

ObjectKind own_kind() {
#if defined(_WIN32)
  const char* const system = kWindows;
#elif defined(__APPLE__)
  const char* const system = kMac;
#elif defined(__wasm__)
  const char* const system = kWasm;
#else
  const char* const system = kElf;
#endif
#if defined(__x86_64__) || defined(_M_X64)
  return {system, kMachines[0].name};
#elif defined(__aarch64__) || defined(_M_ARM64)
  return {system, kMachines[1].name};
#elif defined(__i386__)
  return {system, kMachines[2].name};
#elif defined(__arm__)
  return {system, kMachines[3].name};
#elif defined(__riscv)
  return {system, kMachines[4].name};
#else
  return {system, nullptr};
#endif
}

}  // namespace carom::abi

// For which system and processor a shared object is, by its first bytes: loaders say of a wrong one that it is not there,
// or no image.
#pragma once

#include <cstddef>
#include <cstdint>

namespace carom::abi {

struct ObjectKind {
  const char* system = nullptr;   // null: this is no program of any system
  const char* machine = nullptr;  // null: unknown, or any
  std::uint64_t least = 0;        // bytes that the file has at least: ELF's loaders crash where it breaks off
};
/// @param head  the first bytes of the file; 4 KiB are enough   @param size  how many there are
ObjectKind object_kind(const unsigned char* head, std::size_t size);
/// Those of this library.
ObjectKind own_kind();

}  // namespace carom::abi

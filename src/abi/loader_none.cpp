// Systems whose shared objects the library can't load. In WebAssembly the host brings a side module into memory and
// registers it by pointer: bindings/js/src/side_module.js.
#include "abi/loader.h"

namespace carom::abi::system {

const char* const kEnding = nullptr;
const char kBetween = ':';
const char* const kSlashes = "/";
const char* const kOpenCl = nullptr;

bool is_absolute(std::string_view) { return false; }
bool is_file(const char*) { return false; }
const char* variable(const char*, char*, std::size_t) { return nullptr; }
void own_file(char* path, std::size_t) { path[0] = 0; }
std::FILE* open_file(const char*) { return nullptr; }
Symbol load(const char*, const char*, char*, std::size_t) { return {}; }

}  // namespace carom::abi::system

// Exceptions of carom.threads.wasm, where the compiler is older than emscripten's library (clang 14 of Debian 12). With
// -pthread that library keeps what a landing pad says in a thread-local variable, and clang writes it into a global one
// until version 15: typed catches would find nothing. Here both use one global, and the library's file is not linked.
//
// Threads that catch at the same time share it. The one typed catch on the pool's threads is that of the narrow phase
// (no memory), where all of them write the same.
#if __clang_major__ < 15
#include <cstdint>

namespace {

/// What clang's code writes before it asks, and reads after.
struct LandingPad {
  std::uintptr_t index, table, selector;
};
/// The head of what __cxa_throw() makes.
struct Exception {
  std::uint64_t kind;
  void (*clean_up)(int reason, Exception* exception);
};

constexpr int kCleanupPhase = 2, kForeignCaught = 1;  // of the C++ ABI
constexpr int kSelectorRegister = 1;
constexpr std::uintptr_t kToAddress = 2;  // the personality takes one off, and counts call sites from 1

}  // namespace

extern "C" {

LandingPad __wasm_lpad_context;

int __gxx_personality_wasm0(int version, int actions, std::uint64_t kind, void* exception, LandingPad* context);

/// Called by a landing pad: which of its catches is it?
int _Unwind_CallPersonality(void* exception) {
  __wasm_lpad_context.selector = 0;
  const std::uint64_t kind = static_cast<Exception*>(exception)->kind;
  return __gxx_personality_wasm0(1, kCleanupPhase, kind, exception, &__wasm_lpad_context);
}

int _Unwind_RaiseException(void* exception) { __builtin_wasm_throw(0, exception); }

void _Unwind_DeleteException(Exception* exception) {
  if (exception->clean_up) exception->clean_up(kForeignCaught, exception);
}

void _Unwind_SetGR(LandingPad* context, int index, std::uintptr_t value) {
  if (index == kSelectorRegister) context->selector = value;
}
void _Unwind_SetIP(LandingPad*, std::uintptr_t) {}
std::uintptr_t _Unwind_GetIP(LandingPad* context) { return context->index + kToAddress; }
std::uintptr_t _Unwind_GetLanguageSpecificData(LandingPad* context) { return context->table; }
std::uintptr_t _Unwind_GetRegionStart(LandingPad*) { return 0; }

}  // extern "C"
#endif

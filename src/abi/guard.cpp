// How a failure reaches its caller, and the mark that tells a call from inside a callback.
#include "abi/guard.h"

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#if defined(__unix__) && !defined(__wasm__) && !defined(__ANDROID__)
#include <pthread.h>
#define CAROM_HAS_CANCELLATION 1
#endif

namespace carom::abi {
namespace {

// Not state of the library but of the thread's call stack: whether a carom_* call is under way on it.
struct Marks {
  bool inside = false, leaves = false;
};
constinit thread_local Marks thread_marks;

// Bytes of struct_size and code: less is not a carom_error.
constexpr std::uint32_t kSmallestError = 8;

}  // namespace

bool Call::fail(std::int32_t code, std::int32_t argument, const char* format, ...) {
  if (!ok()) return false;
  code_ = code;
  argument_ = argument;
  std::va_list args;
  va_start(args, format);
  std::vsnprintf(message_, sizeof message_, format, args);
  va_end(args);
  return false;
}

bool Call::advise(const char* remedy) {
  if (!remedy_) remedy_ = remedy;
  return false;
}

void Call::name_file(const char* path) {
  const std::size_t used = std::strlen(message_), length = std::strlen(path);
  constexpr std::size_t kAround = sizeof " (...)";
  if (ok() || message_[0] == '"' || std::strstr(message_, path) || used + kAround + 8 > sizeof message_) return;
  const std::size_t space = sizeof message_ - used - kAround, shown = std::min(length, space);
  std::snprintf(message_ + used, sizeof message_ - used, " (%s%s)", shown < length ? "..." : "",
                path + (length - shown));
}

void Call::witness(const double dir[3], const double out[3]) {
  has_witness_ = true;
  std::memcpy(dir_, dir, sizeof dir_);
  std::memcpy(out_, out, sizeof out_);
}

std::int32_t Call::finish() const {
  if (ok() || !error_ || error_->struct_size < kSmallestError) return code_;
  carom_error full = CAROM_ERROR_INIT;
  full.code = code_;
  full.argument = argument_;
  full.has_witness = has_witness_;
  std::memcpy(full.witness_dir, dir_, sizeof dir_);
  std::memcpy(full.witness_out, out_, sizeof out_);
  std::memcpy(full.message, message_, std::strlen(message_));
  std::snprintf(full.remedy, sizeof full.remedy, "%s", remedy_ ? remedy_ : carom_result_remedy(code_));

  const std::size_t skip = sizeof full.struct_size;  // the caller's own
  const std::size_t size = std::min<std::size_t>(error_->struct_size, sizeof full);
  auto* to = reinterpret_cast<char*>(error_);
  std::memcpy(to + skip, reinterpret_cast<const char*>(&full) + skip, size - skip);
  if (size > offsetof(carom_error, message) && size < sizeof full) to[size - 1] = '\0';
  return code_;
}

Inside::Inside(Call& call) {
  Marks& mine = thread_marks;
  if (mine.inside) {
    call.fail(CAROM_E_REENTRANT, 0,
              "called from inside a callback (support function, allocator, log or jobs) on this thread");
    return;
  }
  if (call.error_ && call.error_->struct_size < kSmallestError) {
    call.fail(CAROM_E_STRUCT_SIZE, 0, "error->struct_size is %u", call.error_->struct_size);
    return;
  }
  mine = {true, false};
  mark_ = &mine.inside;
}

InsideJob::InsideJob() : before_(thread_marks.inside) { thread_marks.inside = true; }
InsideJob::~InsideJob() { thread_marks.inside = before_; }
void mark_inside() {
  thread_marks.inside = true;
  hold_cancellation();
}

#ifdef CAROM_HAS_CANCELLATION
int hold_cancellation() {
  int before = PTHREAD_CANCEL_ENABLE;
  pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before);
  return before;
}
void give_cancellation(int before) {
  if (before == PTHREAD_CANCEL_DISABLE) return;
  pthread_setcancelstate(before, nullptr);
  pthread_testcancel();
}
#else
int hold_cancellation() { return 0; }
void give_cancellation(int) {}
#endif

void mark_leaving() { thread_marks.leaves = true; }
bool is_leaving() { return thread_marks.leaves; }

void note_exception(Call& call) {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    call.fail(CAROM_E_OUT_OF_MEMORY, 0, "the allocator had no memory for this call");
  } catch (const std::length_error&) {
    call.fail(CAROM_E_OUT_OF_MEMORY, 0, "this call asks for more memory than can be addressed");
  } catch (const core::CallbackLeft& e) {
    call.fail(CAROM_E_INTERNAL, 0, "%s", e.what());
    call.advise("let callbacks return; a step that one left is not finished, and the next begins where it ended");
  } catch (const std::exception& e) {
    call.fail(CAROM_E_INTERNAL, 0, "unexpected: %s", e.what());
  } catch (...) {
    call.fail(CAROM_E_INTERNAL, 0, "unexpected exception of unknown type; did a callback throw?");
  }
}

std::int32_t run_guarded(carom_error* error, CallBody body, void* work) {
  const int cancellation = hold_cancellation();
  Call call(error);
  run_call(call, [&](Call& it) { body(work, it); });
  const std::int32_t result = call.finish();
  give_cancellation(cancellation);
  return result;
}

}  // namespace carom::abi

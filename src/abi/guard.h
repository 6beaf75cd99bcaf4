// The one gate of the boundary: every call that can fail goes through guarded(), which lets no exception out, refuses
// calls from inside a callback, and turns what went wrong into a result and, where asked for, a carom_error. A thread that
// a callback ends unwinds through it; one that is cancelled from outside finishes its call first.
#pragma once

#include <carom/base.h>

#include <type_traits>

#include "core/jobs.h"
#include "core/leaving.h"

namespace carom::abi {

/// One call across the boundary, and what went wrong in it. Checks note the first failure and return false, so that
/// they chain with &&; what is noted reaches the caller when the call ends.
class Call {
 public:
  explicit Call(carom_error* error) : error_(error) { message_[0] = 0; }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// Note a failure; the first one stands.
  /// @param argument  1-based position in the C signature, 0: none in particular
  /// @param format    as printf: what is wrong, with the numbers
  /// @return false
  bool fail(std::int32_t code, std::int32_t argument, const char* format, ...) __attribute__((format(printf, 4, 5)));

  /// What to do about it, where the remedy of the result's code does not fit; after fail(). @param remedy  outlives the
  /// call
  /// @return false, so that it chains: check || call.fail(...) || call.advise(...)
  bool advise(const char* remedy);

  /// Say in which file it is, or the end of that name, unless the message does.
  void name_file(const char* path);

  /// Attach what a support function was given and gave back.
  void witness(const double dir[3], const double out[3]);

  bool ok() const { return code_ == CAROM_OK; }
  const char* message() const { return message_; }
  std::int32_t code() const { return code_; }
  const char* remedy() const { return remedy_; }  // null: of the code

  /// Hand the failure over (never past the size the caller's struct has). @return the result of the call
  std::int32_t finish() const;

 private:
  friend class Inside;
  carom_error* error_;
  std::int32_t code_ = CAROM_OK;
  std::int32_t argument_ = 0;
  const char* remedy_ = nullptr;  // null: of the code
  bool has_witness_ = false;
  double dir_[3] = {0, 0, 0};
  double out_[3] = {0, 0, 0};
  char message_[sizeof carom_error::message];  // up to its zero
};

/// Marks this thread as being inside the library. A second call on the same thread can then only come from a callback
/// (a support function, the allocator, the log), and is refused.
class Inside {
 public:
  explicit Inside(Call& call);
  ~Inside() {
    if (mark_) *mark_ = false;
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  explicit operator bool() const { return mark_; }

 private:
  bool* mark_ = nullptr;  // of this thread; null: refused
};

/// Marks a thread that does a part of another's step, so that a call from a callback there is refused as well.
class InsideJob {
 public:
  InsideJob();
  ~InsideJob();
  InsideJob(const InsideJob&) = delete;
  InsideJob& operator=(const InsideJob&) = delete;

 private:
  bool before_;  // the stepping thread does parts too
};
/// Likewise for good: a thread of our own, which is never cancelled.
void mark_inside();

/// Cancellation of this thread waits from here on. @return what to give back
int hold_cancellation();
/// As it was before. A thread that was cancelled meanwhile ends here.
void give_cancellation(int before);

/// A callback ends this thread: what is going on is not to be written down as done.
void mark_leaving();
bool is_leaving();

/// A function of the host's, which may end the thread.
template <class F>
auto call_host(F&& function) {
  try {
    return function();
  } catch (const core::ThreadExit&) {
    mark_leaving();
    throw;
  }
}

/// Note the exception that is being handled.
void note_exception(Call& call);

template <class Work>
void run_call(Call& call, Work&& work) {
  if (const Inside inside(call); inside) {
    try {
      work(call);
    } catch (const core::ThreadExit&) {
      throw;
    } catch (...) {
      note_exception(call);
    }
  }
}

/// A call's body behind a pointer, so that there is one gate for all.
using CallBody = void (*)(void* work, Call&);
std::int32_t run_guarded(carom_error* error, CallBody body, void* work);

/// Run the body of one C call: work(call). Only a thread that ends goes out of it otherwise than by returning.
template <class Work>
std::int32_t guarded(carom_error* error, Work&& work) {
  return run_guarded(
      error, [](void* it, Call& call) { (*static_cast<std::remove_reference_t<Work>*>(it))(call); }, &work);
}

/// Likewise, of a call that copies out a few numbers. It calls nothing of the host's, takes no memory and waits for nothing: there is
/// no point in it where a thread is cancelled, and no need to hold that off, which would take half as long as the call.
template <class Work>
std::int32_t glanced(carom_error* error, Work&& work) {
  Call call(error);
  run_call(call, work);
  return call.finish();
}

}  // namespace carom::abi

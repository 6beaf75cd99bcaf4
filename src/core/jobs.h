// Loops that several threads may share. Which thread takes which part is left to chance, so a part may write only what
// no other part reads or writes: then the outcome does not depend on threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>

#include "core/layers.h"

namespace carom::core {

/// A callback of the host's threw, or ended the thread, where that was not the thread of the call.
struct CallbackLeft : std::exception {
  const char* what() const noexcept override {
    return "a callback threw or ended a thread that shared a loop of this call";
  }
};

class Jobs {
 public:
  /// Do [begin, end) of a loop. Only what a callback of the host's throws goes out of it, or its end of the thread.
  using Task = void (*)(void* context, std::uint32_t begin, std::uint32_t end);

  virtual ~Jobs() = default;
  /// Do all of [0, count), in parts of `grain` or more, on the calling thread and others; return when all is done.
  /// @throws CallbackLeft if a part on another thread was not finished
  virtual void run(Task task, void* context, std::uint32_t count, std::uint32_t grain) = 0;
};

/// part(begin, end) over [0, count).
/// @param jobs   null: the calling thread alone, all at once
/// @param grain  a part should take some microseconds: loops that are shorter are not worth sharing
template <class Part>
void in_parts(Jobs* jobs, std::size_t count, std::size_t grain, const Part& part) {
  const auto n = static_cast<std::uint32_t>(count);
  if (n == 0) return;
  if (!jobs || count <= grain) return part(std::uint32_t(0), n);
  const auto task = [](void* context, std::uint32_t begin, std::uint32_t end) {
    (*static_cast<const Part*>(context))(begin, end);
  };
  jobs->run(task, const_cast<Part*>(&part), n, static_cast<std::uint32_t>(grain));
}

/// each(i) for all i of [0, count).
template <class Each>
void in_parallel(Jobs* jobs, std::size_t count, std::size_t grain, const Each& each) {
  in_parts(jobs, count, grain, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) each(i);
  });
}

}  // namespace carom::core

// Who is served: body slots as lists of runs, and what can be done with them at the cost of their runs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/jobs.h"
#include "core/memory.h"

namespace carom::dynamics {

/// Body slots as ascending runs [begin, end), so that loops over many neighbours are dense.
struct Participants {
  struct Run {
    std::uint32_t begin, end;
  };
  explicit Participants(Memory* m) : runs(m) {}

  Array<Run> runs;
  std::uint64_t count = 0;

  void clear() { runs.clear(), count = 0; }
  void add(std::uint32_t slot) {  // ascending
    if (!runs.empty() && runs.back().end == slot)
      ++runs.back().end;
    else
      runs.push_back({slot, slot + 1});
    ++count;
  }
  bool has(std::uint32_t slot) const {
    const auto r = std::partition_point(runs.begin(), runs.end(), [slot](const Run& run) { return run.end <= slot; });
    return r != runs.end() && r->begin <= slot;
  }
  template <class F>
  void each(F&& f) const {
    for (const Run& r : runs)
      for (std::uint32_t i = r.begin; i < r.end; ++i) f(i);
  }
  /// Likewise, shared by threads: f(i) writes nothing that f of another slot reads or writes.
  template <class F>
  void each(Jobs* jobs, F&& f) const {
    in_slots(jobs, [&](std::uint32_t from, std::uint32_t to) { each_within(from, to, f); });
  }
  /// Likewise f(slots, count) for up to four at a time, of those of which is_one(slot).
  template <class IsOne, class F>
  void each_four(Jobs* jobs, IsOne&& is_one, F&& f) const {
    in_slots(jobs, [&](std::uint32_t from, std::uint32_t to) {
      std::uint32_t four[4], held = 0;
      each_within(from, to, [&](std::uint32_t i) {
        if (!is_one(i)) return;
        four[held++] = i;
        if (held == 4) f(four, std::exchange(held, 0u));
      });
      if (held > 0) f(four, held);
    });
  }
  static constexpr std::size_t kSlotsAPart = 128;  // some microseconds of a loop

 private:
  /// f(from, to) for parts of all slots, which threads share.
  template <class F>
  void in_slots(Jobs* jobs, const F& f) const {
    if (runs.empty()) return;
    const std::uint32_t first = runs.front().begin;
    in_parts(jobs, runs.back().end - first, kSlotsAPart,
             [&](std::uint32_t begin, std::uint32_t end) { f(first + begin, first + end); });
  }
  template <class F>
  void each_within(std::uint32_t from, std::uint32_t to, const F& f) const {
    auto r = std::partition_point(runs.begin(), runs.end(), [&](const Run& run) { return run.end <= from; });
    for (; r != runs.end() && r->begin < to; ++r)
      for (std::uint32_t i = std::max(r->begin, from); i < std::min(r->end, to); ++i) f(i);
  }
};

/// Call f(slot) for who is in either of two lists that share none, ascending.
template <class F>
void each_of_both(const Participants& one, const Participants& other, F&& f) {
  const Participants::Run *a = one.runs.data(), *b = other.runs.data();
  const Participants::Run *const a_end = a + one.runs.size(), *const b_end = b + other.runs.size();
  while (a < a_end || b < b_end) {
    const Participants::Run& next = b == b_end || (a < a_end && a->begin < b->begin) ? *a++ : *b++;
    for (std::uint32_t i = next.begin; i < next.end; ++i) f(i);
  }
}

/// Who is in either list; in the first but not in the second. `out` is neither of them; it is written anew.
void unite(const Participants& one, const Participants& other, Participants& out);
void take_out(const Participants& from, const Participants& those, Participants& out);

}  // namespace carom::dynamics

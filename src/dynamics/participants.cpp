#include "dynamics/participants.h"

namespace carom::dynamics {
namespace {

void add_run(Participants& to, std::uint32_t begin, std::uint32_t end) {  // ascending
  if (begin == end) return;
  if (!to.runs.empty() && to.runs.back().end == begin)
    to.runs.back().end = end;
  else
    to.runs.push_back({begin, end});
  to.count += end - begin;
}

}  // namespace

void unite(const Participants& one, const Participants& other, Participants& out) {
  out.clear();
  const Participants::Run *a = one.runs.data(), *b = other.runs.data();
  const Participants::Run *const a_end = a + one.runs.size(), *const b_end = b + other.runs.size();
  std::uint32_t done = 0;  // all slots below it are listed, or in neither
  while (a < a_end || b < b_end) {
    const Participants::Run& next = b == b_end || (a < a_end && a->begin < b->begin) ? *a++ : *b++;
    const std::uint32_t begin = std::max(next.begin, done);
    if (next.end <= begin) continue;
    add_run(out, begin, next.end);
    done = next.end;
  }
}

void take_out(const Participants& from, const Participants& those, Participants& out) {
  out.clear();
  const Participants::Run* hole = those.runs.data();
  const Participants::Run* const end = hole + those.runs.size();
  for (const Participants::Run& run : from.runs) {
    std::uint32_t at = run.begin;
    while (hole < end && hole->end <= at) ++hole;
    for (const Participants::Run* h = hole; h < end && h->begin < run.end; ++h) {
      if (h->begin > at) add_run(out, at, h->begin);
      at = std::max(at, h->end);
    }
    if (at < run.end) add_run(out, at, run.end);
  }
}

}  // namespace carom::dynamics

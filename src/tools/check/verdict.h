// What a plugin check finds, in memory that a parent and its child share: it survives the child's crash.
#pragma once

#include <cstdint>

namespace carom::tools {

/// What is being done to the plugin; if the child dies, this is where it died.
enum class Phase : std::uint32_t { start, load, describe, sample, threads, shapes, engine_load, done };

/// One thing that can be wrong; each is reported once, with its first witness and how often it was seen.
enum class Lie : std::uint32_t {
  cannot_load,
  bad_description,
  bad_parameters,
  fault_returned,
  not_finite,
  not_repeatable,
  depends_on_length,
  not_convex,
  writes_input,
  changes_float_environment,
  not_thread_safe,
  refused_by_engine,
  count
};

inline constexpr std::uint32_t kParamsShown = 48;

/// The call that shows it.
struct Witness {
  std::uint64_t param_count = 0;  ///< may exceed kParamsShown; only so many are kept
  double params[kParamsShown] = {};
  double dir[3] = {}, out[3] = {};
};

struct Finding {
  std::uint64_t seen = 0;
  std::uint32_t has_witness = 0;
  Witness witness;
  char what[400] = {};
  char remedy[300] = {};
};

/// Lives in memory that processes share. The child writes, the parent reads after the child has ended.
struct Verdict {
  Phase phase = Phase::start;
  std::uint32_t complete = 0;  ///< 1: the child reached its end
  std::uint32_t threw = 0;     ///< 1: an exception came out of what the child did
  std::uint32_t usage = 0;     ///< 1: the parameters given do not fit the plugin; nothing was judged
  std::uint64_t calls = 0;
  std::uint64_t param_sets = 0, shapes = 0;
  double seconds_per_call = 0;  ///< s
  Witness current;              ///< the call in progress
  char id[80] = {};
  char usage_text[400] = {};
  Finding findings[static_cast<std::uint32_t>(Lie::count)];
};

/// Plain words for a phase: "sampling its support function".
const char* phase_text(Phase phase);

}  // namespace carom::tools

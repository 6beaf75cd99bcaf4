// Bytes become a sequence of calls of the ABI on three worlds of two engines, right ones and slightly wrong ones, each judged
// by a model of what lives. Sees include/ alone, as a host does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace carom::fuzz {

/// What a sequence was, and what is wrong with how it was answered; empty: nothing.
struct Heard {
  std::string complaint, trace;
  unsigned calls = 0, refused = 0, steps = 0, replayed = 0;
};

/// @param trace        whether to write down each call
/// @param to_the_edge  numbers that are good are often as large or small as they may be
Heard run_calls(const std::uint8_t* bytes, std::size_t size, bool trace, bool to_the_edge = false);

}  // namespace carom::fuzz

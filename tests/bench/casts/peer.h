// What a library under test is shown and asked about casts: plain data, no header of Carom's (see ../convex/peer.h).
#pragma once

#include "../convex/peer.h"

namespace carom::bench {

/// Two solids that go from one pose to another in unit time, turning about their origins at constant rates.
struct CastCase {
  const Solid *a, *b;  // a null: a ray, whose point goes from from_a.p to to_a.p
  Placement from_a, to_a, from_b, to_b;
};

enum class Task { ray, linear, turning };

class CastPeer {
 public:
  virtual ~CastPeer() = default;
  virtual const char* name() const = 0;
  /// What the library lacks to be asked this about such a solid, in words; null: nothing.
  virtual const char* lacks(Task task, const Solid& solid) const = 0;
  /// Build the library's own shapes and poses, off the clock. The cases outlive the answers.
  virtual void prepare(Task task, const CastCase* cases, std::size_t count) = 0;
  /// Time of first contact in [0, 1]; negative: none.
  virtual double ask(std::size_t i) = 0;
};

/// What a shared object exports as `carom_bench_cast_peer`: the i-th of its libraries, null past the last.
using CastPeerModule = CastPeer* (*)(int i);

}  // namespace carom::bench

// What a bulk call goes through: those of an array of handles, or all, by ascending slot.
#pragma once

#include "abi/check.h"

namespace carom::abi {

class Selection {
 public:
  /// For messages: what all of them are called, what one of the array is.
  struct Words {
    const char* all;
    const char* one;
  };
  /// @param handles  null: all
  Selection(const SlotPool& pool, const std::uint64_t* handles, const Words& words)
      : pool_(pool), handles_(handles), words_(words) {}

  /// Argument 4 are the handles, argument 5 is how many there are.
  bool check(Call& call, std::uint64_t n) const {
    if (!handles_)
      return n == pool_.alive_count() || call.fail(CAROM_E_OUT_OF_RANGE, 5, "n is %llu, the world has %u %s",
                                                   static_cast<unsigned long long>(n), pool_.alive_count(), words_.all);
    if (!spans(call, 5, 5, n, sizeof *handles_, sizeof *handles_)) return false;
    for (std::uint64_t i = 0; i < n; ++i)
      if (!resolve(call, 4, words_.one, pool_, handles_[i])) return false;
    return true;
  }

  /// @param visit (slot, index), for 0 <= index < n; returns false to stop
  template <class Visit>
  void for_each(std::uint64_t n, Visit&& visit) const {
    if (handles_) {
      for (std::uint64_t i = 0; i < n; ++i)
        if (!visit(handle_slot(handles_[i]), i)) return;
      return;
    }
    std::uint64_t i = 0;
    for (std::uint32_t slot = 0; slot < pool_.slots(); ++slot)
      if (pool_.alive(slot) && !visit(slot, i++)) return;
  }

 private:
  const SlotPool& pool_;
  const std::uint64_t* handles_;
  const Words words_;
};

}  // namespace carom::abi

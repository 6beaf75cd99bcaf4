// Substeps within a budget of time: what a step costs is learnt from the last ones.
#pragma once

#include <algorithm>
#include <cstdint>

namespace carom::abi {

/// A step costs about `fixed + each * substeps`. Both are held at their peaks and forgotten slowly, so that one quick
/// step among slow ones promises nothing.
class Budget {
 public:
  /// @param seconds  a step
  Budget(double seconds_, std::uint32_t fewest_, std::uint32_t most_)
      : seconds(seconds_), fewest(fewest_), most(most_) {}
  const double seconds;
  const std::uint32_t fewest, most;

  /// How many substeps the next step takes. One more only where there is clearly time to spare, so that a scene at the
  /// edge does not change its mind in every step; as many fewer as needed at once.
  std::uint32_t choose(std::uint32_t now) const {
    constexpr double kSpare = 0.85, kFull = 0.95;
    const std::uint32_t within = std::clamp(now, fewest, most);
    if (!(each_ > 0)) return within;
    if (fixed_ + each_ * (within + 1) <= kSpare * seconds) return std::min(within + 1, most);
    if (fixed_ + each_ * within <= seconds) return within;
    const double fits = (kFull * seconds - fixed_) / each_;
    return fits < fewest ? fewest : std::min(within, static_cast<std::uint32_t>(fits));
  }

  /// @param all, in_substeps  s, of the last step; the second is the part of the first that each substep has its share
  /// in
  void learn(double all, double in_substeps, std::uint32_t substeps) {
    if (substeps == 0) return;
    const auto hold = [](double& known, double seen) { known = std::max(seen, known + kForget * (seen - known)); };
    hold(each_, in_substeps / substeps);
    hold(fixed_, all - in_substeps);
  }

 private:
  static constexpr double kForget = 0.1;  // a step
  double fixed_ = 0, each_ = 0;           // s
};

}  // namespace carom::abi

// The pairs that every library is asked about: families of random solids apart and deep, and pairs in slow motion.
#pragma once

#include <deque>
#include <string>

#include "solid.h"

namespace carom::bench {

struct Set {
  std::string family, kind;  // kind: apart, deep, coherent
  std::vector<Query> queries;
};

inline constexpr const char* kBenchFamilies[] = {"box",       "capsule",  "hull32", "hull1000",
                                                 "ellipsoid", "cylinder", "cone"};

/// The solids of one family, which its sets share as the bodies of a world share shapes, and its sets.
class Family {
 public:
  /// @param name   one of kBenchFamilies
  /// @param pairs  of each set; gaps uniform in (0, 1) m if apart, in (-0.3, 0) m if deep, solids of about 1 m
  Family(const std::string& name, int pairs);

  /// 50 pairs in 400 frames, turning by 0.25 to 1 mrad and sliding by about 0.2 mm a frame.
  Set coherent(bool deep) const;

  Set apart, deep;

 private:
  std::deque<OwnedSolid> solids_;
};

}  // namespace carom::bench

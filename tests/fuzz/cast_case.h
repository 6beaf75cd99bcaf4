// One question about a motion: a pair, how it moves, and when contact counts.
#pragma once

#include "judge.h"

namespace carom::fuzz {

enum class CastKind { linear, ray, turning, overlap, count };

struct CastCase {
  PairCase pair;
  CastKind kind = CastKind::linear;
  Vec3 motion = Vec3::zero();                         // m (turning: m/s) of A, in its own frame; a ray's direction
  Vec3 turn_a = Vec3::zero(), turn_b = Vec3::zero();  // rad/s, about the shapes' origins
  Real target = 0, tolerance = 1e-6;
  int cap = 128;
};

void decode(const std::uint8_t* bytes, std::size_t size, CastCase& out);
std::string to_text(const CastCase& c);
bool from_text(const std::string& text, CastCase& out);
Verdict judge(const CastCase& c);

}  // namespace carom::fuzz

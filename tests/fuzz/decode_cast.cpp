// Bytes to a motion: the last 64 of them tell how the pair of the others moves.
#include <algorithm>
#include <cstdlib>

#include "bytes.h"
#include "cast_case.h"
#include "collision/narrow/pair.h"

namespace carom::fuzz {
namespace {

Vec3 direction(Bytes& in) {
  const Vec3 v(in.both_signs(), in.both_signs(), in.both_signs());
  const int axis = in.below(8);
  if (axis < 3) return Vec3::unit(axis) * (v[axis] < 0 ? -1 : 1);
  return v.norm() > 0 ? Vec3(v.normalized()) : Vec3(Vec3::unit_x());
}

Vec3 turn(Bytes& in, Real fastest) {
  return in.below(3) == 0 ? Vec3(Vec3::zero()) : Vec3(fastest * in.unit() * direction(in));
}

}  // namespace

void decode(const std::uint8_t* bytes, std::size_t size, CastCase& out) {
  const std::size_t pair_size = size > 64 ? size - 64 : 0;
  decode(bytes, pair_size, out.pair);
  Bytes in(bytes + pair_size, size - pair_size);
  PairCase& p = out.pair;
  p.a.lie = p.b.lie = Lie::none;
  if (!usable(p.b_in_a)) p.b_in_a = Frame();
  const Shape a = make(p.a), b = make(p.b);
  const Real reach = a.bounding_radius + b.bounding_radius, least = std::min(a.bounding_radius, reach);
  out.kind = static_cast<CastKind>(in.below(static_cast<int>(CastKind::count)));
  // From a way off, towards B or past it by little; or from where the pair stands, anywhere.
  const Vec3 way = direction(in);
  const unsigned style = in.byte();
  const Real far = reach * in.any_order(-2, style & 8 ? 20 : 3);
  if (style & 1) p.b_in_a.p += far * way;
  out.motion = style & 1 ? Vec3((1 + in.both_signs()) * far * way) : Vec3(reach * in.any_order(-12, 6) * direction(in));
  if (style & 2) out.motion += reach * in.any_order(-40, 0) * direction(in);
  if (style % 64 == 4) out.motion.set_zero();
  out.turn_a = turn(in, 6);
  out.turn_b = p.b.kind == Kind::half_space ? Vec3(Vec3::zero()) : turn(in, 6);
  out.target = in.below(4) == 0 ? least * in.any_order(-20, 1) : 0;
  out.tolerance = in.below(3) == 0 ? in.any_order(-45, -2) : 1e-6;
  out.cap = in.below(8) == 0 ? 1 + in.below(40) : 128;
}

std::string to_text(const CastCase& c) {
  std::string t = to_text(c.pair) + " | " + std::to_string(static_cast<int>(c.kind)) + ' ' + std::to_string(c.cap);
  char number[40];
  for (const Vec3* v : {&c.motion, &c.turn_a, &c.turn_b})
    for (int i = 0; i < 3; ++i) std::snprintf(number, sizeof number, " %a", (*v)[i]), t += number;
  for (const Real x : {c.target, c.tolerance}) std::snprintf(number, sizeof number, " %a", x), t += number;
  return t;
}

bool from_text(const std::string& text, CastCase& out) {
  const std::size_t bar = text.find(" | ");
  if (bar == std::string::npos || !from_text(text.substr(0, bar), out.pair)) return false;
  const char* at = text.c_str() + bar + 3;
  double numbers[13];
  for (double& x : numbers) {
    char* end = nullptr;
    x = std::strtod(at, &end);
    if (end == at) return false;
    at = end;
  }
  if (!(numbers[0] >= 0 && numbers[0] < static_cast<int>(CastKind::count) && numbers[1] >= 0 && numbers[1] < 1e6))
    return false;
  out.kind = static_cast<CastKind>(static_cast<int>(numbers[0]));
  out.cap = static_cast<int>(numbers[1]);
  out.motion = Vec3(numbers[2], numbers[3], numbers[4]);
  out.turn_a = Vec3(numbers[5], numbers[6], numbers[7]);
  out.turn_b = Vec3(numbers[8], numbers[9], numbers[10]);
  out.target = numbers[11];
  out.tolerance = numbers[12];
  return *at == 0;
}

}  // namespace carom::fuzz

// One question for the narrow phase as plain numbers: made from bytes, printed as text, read back, turned into shapes.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "collision/narrow/query.h"

namespace carom::fuzz {

enum class Kind { sphere, capsule, box, cylinder, cone, ellipsoid, hull, top, half_space, count };

/// What an invalid support function does now and then. `single` works in float: valid, but sloppy.
enum class Lie { none, error, not_a_number, outside, inside, single, count };

struct ShapeSpec {
  Kind kind = Kind::sphere;
  Real swell = 0;              // m, added all around as core radius; no closed form is declared then
  bool declared = true;        // whether the engine is told the closed form
  Lie lie = Lie::none;         // of a box only
  std::vector<double> params;  // as the plugin's; half-space: unit normal, offset
};

/// What else is asked about the pair, beside the question itself. Every further answer is judged like the first.
enum class Twist { none, swapped, other_simplex, other_tolerance, other_path, warm, warm_far, count };

struct PairCase {
  ShapeSpec a, b;
  Frame b_in_a;
  Frame next;  // B's frame in the second question of a warm pair
  QuerySettings settings;
  Twist twist = Twist::none;
  std::uint32_t sweep = 0;  // which directions the judge looks along; every 128th number: all of them
};

/// Bytes long enough that no field of a case is cut off.
inline constexpr std::size_t kCaseBytes = 224;

/// Any bytes are a case; what is missing is read as zeros. Same bytes, same case, everywhere.
void decode(const std::uint8_t* bytes, std::size_t size, PairCase& out);

/// One line, numbers in hexadecimal: nothing is lost, and it outlives changes of decode().
std::string to_text(const PairCase& c);
/// @return false if the text is no case
bool from_text(const std::string& text, PairCase& out);

/// The shape with the support function of its plugin.
Shape make(const ShapeSpec& spec);

}  // namespace carom::fuzz

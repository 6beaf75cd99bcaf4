// Snapshots: the state of a world as bytes, and back. @see README.md
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/memory.h"

namespace carom::collision {
struct Shape;
}

namespace carom::dynamics {

class World;

/// Why bytes are refused. Then nothing of the world has changed.
struct SnapshotFault {
  enum Kind { none, corrupt, newer, mismatch, missing } kind = none;
  char text[240] = {0};
};

/// Whose bytes they are: those that never left the library need no checksum.
enum class Origin { host, own };

/// All that a step reads and that is not structure, and what a host can set without changing structure. May be called
/// by several threads at once, while nothing changes the world.
/// @param to  [capacity] filled if it is large enough
/// @return    bytes that it takes
std::uint64_t save_state(const World& world, std::byte* to, std::uint64_t capacity, Origin origin = Origin::host);

/// Put back what save_state() took from this world, or from another of the same structure. From here on both go on
/// alike, bit for bit. Lists and residuals of the last step are empty until the next one.
/// @throw std::bad_alloc  then nothing has changed
bool restore_state(World& world, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault,
                   Origin origin = Origin::host);

/// A section of own bytes, for who keeps them in another form.
struct SectionBytes {
  std::uint32_t tag = 0;
  const std::byte* begin = nullptr;
  std::uint64_t size = 0;  // up to a multiple of 8 zeros follow
};
/// @param at  0 to begin with; goes on behind the section   @return  false: there is no other
bool next_section(const std::byte* bytes, std::uint64_t n, std::uint64_t& at, SectionBytes& out);
/// The reverse: what stands before the first section, of own bytes that will be n in all, and before each section.
/// @return  bytes written
std::uint64_t put_header(std::byte* to, std::uint64_t n);
std::uint64_t put_section_header(std::byte* to, std::uint32_t tag, std::uint64_t size);

/// What of a world is not as a snapshot of its structure says.
struct Difference {
  char sections[240] = {0};             // by name, most telling first; empty: none
  std::uint64_t first = 0, second = 0;  // handles of what differs first, where it has any
};
bool compare_state(const World& world, const std::byte* bytes, std::uint64_t n, Difference& out, SnapshotFault& fault);

// ---- whole worlds ----

/// What a shape is made of, by names and numbers that mean the same elsewhere.
struct ShapeImage {
  enum Kind : std::uint8_t { of_plugin, half_space, mesh, height_field, known, hull_of, count } kind = of_plugin;
  std::string_view plugin;          // of_plugin: its id
  std::uint32_t version = 0;        // likewise
  std::span<const double> numbers;  // parameters; normal and offset; vertices, m; heights, m
  std::span<const std::uint32_t> corners;
  std::span<const Shape* const> parts;  // hull_of: numbers as HullOf::numbers
  std::uint32_t columns = 0, rows = 0, dropped = 0;
  double spacing_x = 1, spacing_z = 1;  // m
  bool two_sided = false;
};
/// Who knows what shapes are called.
class ShapeNames {
 public:
  virtual ~ShapeNames() = default;
  /// @return  false: whoever reads this knows the shape by its number
  virtual bool name(const Shape& shape, std::string_view& plugin, std::uint32_t& version) const = 0;
};
/// Who has shapes, or makes them. They stay at least until the maker goes.
class ShapeMaker {
 public:
  virtual ~ShapeMaker() = default;
  /// @return  null: there is none such, and fault says why
  virtual const Shape* make(std::size_t number, const ShapeImage& image, SnapshotFault& fault) = 0;
};

/// The state, and all that it takes to build such a world. Otherwise as save_state().
std::uint64_t save_world(const World& world, const ShapeNames& names, std::byte* to, std::uint64_t capacity);
/// The shapes of a world in the order of their numbers in a snapshot: parts of a hull of shapes before it.
Array<const Shape*> shapes_of(const World& world, Memory* memory);
/// Nothing was ever made in this world, so no handle of it is about.
bool is_untouched(const World& world);
bool is_whole(const std::byte* bytes, std::uint64_t n);
/// Make a world in which nothing was ever made, and which only the caller knows, one that was saved whole.
/// @return false: refused; then, and if it throws, the world is of no more use
bool build_world(World& world, const std::byte* bytes, std::uint64_t n, ShapeMaker& shapes, SnapshotFault& fault);

}  // namespace carom::dynamics

// Pairs of shapes in arrays of the host's: what is checked of them, and what is read.
#pragma once

#include <carom/pairs.h>

#include "abi/columns.h"
#include "abi/engine.h"

namespace carom::abi {

/// The shapes of a call, by slot. None of them can be destroyed as long as this lives.
class ShapeTable {
 public:
  explicit ShapeTable(carom_engine& engine) : engine_(engine), shapes_(&engine.memory) {}
  ~ShapeTable();
  ShapeTable(const ShapeTable&) = delete;
  ShapeTable& operator=(const ShapeTable&) = delete;

  /// Add what handles [begin, end) of a column name.
  /// @param name  "shape_a": a message adds which pair
  bool add(Call& call, int argument, const char* name, const Column& handles, std::uint64_t begin, std::uint64_t end);
  const Shape& operator[](carom_shape handle) const { return *shapes_[handle_slot(handle)]; }
  std::size_t slots() const { return shapes_.size(); }
  const Shape* at(std::size_t slot) const { return shapes_[slot]; }  // null: not of this call

 private:
  carom_engine& engine_;
  Array<const Shape*> shapes_;
};

/// Some pairs, checked.
class PairColumns {
 public:
  explicit PairColumns(carom_engine& engine) : shapes_(engine) {}

  /// What a call of carom_pairs_distance() is given: arguments 2 to 5.
  bool read_all(Call& call, const carom_pairs* given, const carom_distance_desc* desc, carom_distance_desc& known_desc,
                const carom_distance* dst, std::uint64_t stride);
  /// Take in arrays and look at all that is in them. They stay as they are during the call.
  bool read(Call& call, int argument, const carom_pairs* given);
  /// Each pair has a distance.
  bool have_distances(Call& call, int argument) const;

  std::uint64_t count() const { return count_; }
  const ShapeTable& shapes() const { return shapes_; }
  /// @param side  0: A, 1: B
  const Shape& shape(int side, std::uint64_t i) const { return shapes_[handle(side, i)]; }
  /// @param pose  [7] position, orientation
  void pose(int side, std::uint64_t i, double pose[7]) const {
    load<3>(positions_[side], CAROM_SCALAR_F64, i, pose);
    load<4>(orientations_[side], CAROM_SCALAR_F64, i, pose + 3);
  }
  Frame frame(int side, std::uint64_t i) const {
    double at[7];
    pose(side, i, at);
    return Frame(Pose{to_quat(at + 3), to_vec3(at)});
  }

 private:
  carom_shape handle(int side, std::uint64_t i) const {
    carom_shape h;
    std::memcpy(&h, handles_[side].at + i * handles_[side].stride, sizeof h);
    return h;
  }
  bool check_poses(Call& call, int argument, int side) const;

  std::uint64_t count_ = 0;
  Column handles_[2], positions_[2], orientations_[2];
  ShapeTable shapes_;
};

}  // namespace carom::abi

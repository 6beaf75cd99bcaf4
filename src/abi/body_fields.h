// The fields of bodies that go in bulk: what a record of each has, how it is read, checked and written.
#pragma once

#include "abi/check.h"
#include "dynamics/world.h"

namespace carom::abi {

struct BodyField {
  const char* name;
  int scalars;
  bool writable;
  int orientation_at;  // index of a unit quaternion in the record; -1: none
  bool velocity;       // must be zero for static bodies
  void (*read)(const World& world, std::uint32_t body, double record[]);
  void (*write)(World& world, std::uint32_t body, const double record[]);
};

/// @param field  CAROM_FIELD_*, known
const BodyField& body_field(std::uint32_t field);
/// Of a body, the i-th of those listed; argument 6.
bool check_record(Call& call, const World& world, const BodyField& field, std::uint32_t body, std::uint64_t i,
                  const double* record);

}  // namespace carom::abi

// The fields of joints that go in bulk, for who has their records: how they are read, checked and written.
#pragma once

#include <span>

#include "abi/check.h"
#include "dynamics/world.h"

namespace carom::abi {

/// Whether joints have a field, and, to be written, may be given it; argument 4.
/// @param field  CAROM_JOINT_BULK_*, known   @param joints  [n] handles of the world's
bool have_joint_field(Call& call, const World& world, std::uint32_t field, const std::uint64_t* joints, std::uint64_t n,
                      bool writes);
/// Whether writing it moves bodies, which their state may forbid.
bool moves_joints(std::uint32_t field);
bool is_read_only(std::uint32_t field);
void read_joint(const World& world, std::uint32_t field, std::uint32_t slot, double* record);
/// Of a joint, the i-th of those listed; argument 6.
bool check_joint(Call& call, const World& world, std::uint32_t field, std::uint32_t slot, std::uint64_t i,
                 const double* record);
/// Of records that were checked, one after the other. @return false: joints can't be moved so, argument 4 or 6
bool write_joints(Call& call, World& world, std::uint32_t field, std::span<const std::uint32_t> slots,
                  const double* records, Memory* memory);

}  // namespace carom::abi

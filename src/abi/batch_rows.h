// The columns of a batch: what of a world stands in a row, and what a host may write there.
#pragma once

#include <carom/batch.h>

#include "abi/check.h"
#include "batch/world_batch.h"

namespace carom::abi {

/// Of a checked descriptor's source, field, handles and rays.
/// @param model  a world of the structure   @return null: refused, noted in the call as argument 2
Owned<batch::Rows> make_rows(Call& call, const carom_batch_column& desc, const World& model, Memory* memory);
/// Whether rows of this kind can be written, and before each step.
bool is_writable(const carom_batch_column& desc);
bool may_be_refused(const carom_batch_column& desc);

}  // namespace carom::abi

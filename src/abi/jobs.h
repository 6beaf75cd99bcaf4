// Who shares the loops of an engine's steps: a host's threads, by its callback, or a pool of our own.
#pragma once

#include <carom/engine.h>

#include "abi/check.h"
#include "core/jobs.h"
#include "core/memory.h"

namespace carom::abi {

/// What a checked descriptor asks for; null: none.
/// @return false if the system has no more threads, noted in the call
bool make_jobs(Call& call, const carom_jobs_desc& desc, Memory* memory, Owned<Jobs>& jobs);

}  // namespace carom::abi

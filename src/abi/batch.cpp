// Many worlds at once: what stands behind carom_batch*, and its calls.
#include <carom/batch.h>

#include "abi/batch_rows.h"
#include "abi/body_fields.h"
#include "abi/copy_out.h"
#include "abi/record_calls.h"
#include "abi/records.h"
#include "abi/snapshot_shapes.h"
#include "abi/world.h"
#include "core/float_scope.h"
#include "core/keyed_random.h"

struct carom_batch {
  explicit carom_batch(carom_engine& owner) : engine(owner), inner(&owner.memory, owner.jobs.get()) {}

  carom_engine& engine;
  carom::abi::Gate gate;
  carom::batch::Batch inner;
};

namespace carom::abi {
namespace {

constexpr std::uint64_t kMostWorlds = std::uint64_t(1) << 24;
constexpr std::size_t kMostStructures = 256, kMostColumns = 4096;
constexpr std::uint32_t kMostSteps = 1000000;

/// The batch of a call, argument 1, closed to everybody else until the end of the scope.
class ChangingBatch {
 public:
  ChangingBatch(Call& call, carom_batch* batch) {
    if (!present(call, 1, "batch", batch)) return;
    if (!batch->gate.enter_alone())
      call.fail(CAROM_E_BUSY, 1, "another thread uses this batch");
    else
      batch_ = batch;
  }
  ~ChangingBatch() {
    if (batch_) batch_->gate.leave_alone();
  }
  ChangingBatch(const ChangingBatch&) = delete;
  ChangingBatch& operator=(const ChangingBatch&) = delete;
  explicit operator bool() const { return batch_; }
  batch::Batch& operator*() const { return batch_->inner; }
  batch::Batch* operator->() const { return &batch_->inner; }
  carom_engine& engine() const { return batch_->engine; }

 private:
  carom_batch* batch_ = nullptr;
};

/// @param argument  that the batch does not take more of
bool is_world(Call& call, int argument, const batch::Batch& batch, std::uint64_t world) {
  return world < batch.size() ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "world is %llu, the batch has %llu",
                   static_cast<unsigned long long>(world), static_cast<unsigned long long>(batch.size()));
}
bool is_count(Call& call, int argument, const batch::Batch& batch, std::uint64_t n) {
  return n == batch.size() ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "n is %llu, the batch has %llu worlds",
                   static_cast<unsigned long long>(n), static_cast<unsigned long long>(batch.size()));
}

/// A refusal with the world and column that it is about.
void refuse(Call& call, int argument, const batch::Why& why, std::uint64_t world, std::uint32_t column) {
  call.fail(why.code, argument, "world %llu, column %u: %.180s", static_cast<unsigned long long>(world), column,
            why.text);
  if (why.remedy) call.advise(why.remedy);
}

void create(Call& call, carom_engine* engine, carom_batch** batch) {
  if (!present(call, 1, "engine", engine) || !present(call, 2, "batch", batch)) return;
  {
    const std::lock_guard lock(engine->mutex);  // from here on the engine's jobs stay
    engine->worlds.fetch_add(1, std::memory_order_relaxed);
  }
  try {
    *batch = make_on<carom_batch>(&engine->memory, *engine);
  } catch (...) {
    engine->worlds.fetch_sub(1, std::memory_order_release);
    throw;
  }
}

void destroy(carom_batch* batch) {
  carom_engine& engine = batch->engine;
  for (std::uint32_t s = 0; s < batch->inner.structures(); ++s) {
    const Colliders& c = batch->inner.model(s).scene.colliders;
    for (const std::uint32_t slot : c.live) unuse_shape(engine, *c.shape[slot]);
  }
  destroy_on(&engine.memory, batch);
  engine.worlds.fetch_sub(1, std::memory_order_release);  // last: the engine may be destroyed from now on
}

void add_worlds(Call& call, const ChangingBatch& batch, carom_world* given, std::uint64_t n, std::uint64_t* first) {
  if (!present(call, 2, "world", given) || !present(call, 4, "first", first)) return;
  Call reads(nullptr);
  const Reading world(reads, given);
  if (!world) {
    call.fail(reads.code(), 2, "%s", reads.message());
    return;
  }
  if (&world.engine() != &batch.engine()) {
    call.fail(CAROM_E_WRONG_WORLD, 2, "the world is of another engine than the batch");
    return;
  }
  if (n == 0 || n > kMostWorlds - batch->size()) {
    call.fail(CAROM_E_OUT_OF_RANGE, 3, "n is %llu, must be from 1 to %llu", static_cast<unsigned long long>(n),
              static_cast<unsigned long long>(kMostWorlds - batch->size()));
    return;
  }
  if (batch->structures() == kMostStructures) {
    call.fail(CAROM_E_LIMIT, 1, "the batch has %zu structures", kMostStructures);
    return;
  }
  const FloatScope scope;
  *first = batch->add_worlds(*world, n);
  wear_shapes(batch.engine(), batch->model(static_cast<std::uint32_t>(batch->structures() - 1)));
}

/// Source and what belongs to it.
bool check_source(Call& call, const carom_batch_column& d) {
  const bool lists = d.source != CAROM_COLUMN_GRAVITY && d.source != CAROM_COLUMN_TIME;
  const bool casts = d.source == CAROM_COLUMN_RAYS;
  if (!known(call, 2, "desc->source", d.source, CAROM_COLUMN_COUNT)) return false;
  const std::uint32_t fields = d.source == CAROM_COLUMN_BODIES   ? CAROM_FIELD_COUNT
                               : d.source == CAROM_COLUMN_JOINTS ? CAROM_JOINT_BULK_COUNT
                                                                 : 1;
  if (!known(call, 2, "desc->field", d.field, fields) || !known(call, 2, "desc->when", d.when, CAROM_WHEN_COUNT) ||
      !known(call, 2, "desc->scalar", d.scalar, CAROM_SCALAR_F64 + 1) ||
      !only_bits(call, 2, "desc->reserved", d.reserved, 0) || !present(call, 2, "desc->data", d.data) ||
      (lists && !present(call, 2, "desc->handles", d.handles)) || (casts && !present(call, 2, "desc->rays", d.rays)))
    return false;
  if (d.n < 1 || d.n > (lists ? kMaxSlots : 1))
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->n is %llu, must be %s", static_cast<unsigned long long>(d.n),
                     lists ? "how many things the column lists" : "1: a world has one");
  if ((!lists && d.handles) || (!casts && d.rays))
    return call.fail(CAROM_E_UNSUPPORTED, 2, "desc->%s belongs to another source",
                     casts || !d.rays ? "handles" : "rays");
  return true;
}

void add_column(Call& call, const ChangingBatch& batch, const carom_batch_column* given, std::uint32_t* column) {
  carom_batch_column d;
  carom_batch_column_init(&d, sizeof d);
  if (!read_struct(call, 2, "desc", given, d) || !check_source(call, d)) return;
  if (!is_world(call, 2, *batch, d.world)) return;
  if (batch->columns().size() == kMostColumns) {
    call.fail(CAROM_E_LIMIT, 1, "the batch has %zu columns", kMostColumns);
    return;
  }
  if (d.when == CAROM_WHEN_BEFORE_STEP && (!is_writable(d) || may_be_refused(d))) {
    call.fail(CAROM_E_UNSUPPORTED, 2,
              is_writable(d) ? "desc->field moves joints: it can't be written before each step"
                             : "the column is read only: it can't be written before each step");
    call.advise("let it be ON_CALL or AFTER_STEP; targets, efforts, forces and poses go before steps");
    return;
  }
  batch::Column made;
  made.structure = batch->structure_of(d.world);
  made.rows = make_rows(call, d, batch->model(made.structure), &batch.engine().memory);
  if (!made.rows) return;
  made.when = static_cast<batch::When>(d.when);
  made.in_floats = d.scalar == CAROM_SCALAR_F32;
  made.writable = is_writable(d);
  made.data = static_cast<std::byte*>(d.data);
  const std::uint64_t row = made.rows->width() * (made.in_floats ? sizeof(float) : sizeof(double));
  made.stride = d.stride ? d.stride : row;
  if (!spans(call, 2, 2, batch->count_of(made.structure), made.stride, row)) return;
  if (made.stride < row) {
    call.fail(CAROM_E_BUFFER_TOO_SMALL, 2, "desc->stride is %llu, a row has %llu bytes",
              static_cast<unsigned long long>(made.stride), static_cast<unsigned long long>(row));
    return;
  }
  const std::uint32_t number = batch->add_column(std::move(made));
  if (column) *column = number;
}

bool are_columns(Call& call, const batch::Batch& batch, const std::uint32_t* columns, std::uint64_t count) {
  if (count && !present(call, 2, "columns", columns)) return false;
  if (!spans(call, 3, 3, count, sizeof *columns, sizeof *columns)) return false;
  for (std::uint64_t i = 0; i < count; ++i)
    if (columns[i] >= batch.columns().size())
      return call.fail(CAROM_E_OUT_OF_RANGE, 2, "columns[%llu] is %u, the batch has %zu",
                       static_cast<unsigned long long>(i), columns[i], batch.columns().size());
  return true;
}

void step(Call& call, const ChangingBatch& batch, const std::uint8_t* mask, double dt, std::uint32_t steps,
          std::uint64_t* stopped) {
  if (!is_step(call, 3, dt)) return;
  if (steps < 1 || steps > kMostSteps) {
    call.fail(CAROM_E_OUT_OF_RANGE, 4, "steps is %u, must be from 1 to %u", steps, kMostSteps);
    return;
  }
  const FloatScope scope;
  batch::Why why;
  std::uint64_t world = 0;
  std::uint32_t column = 0;
  if (!batch->check(batch->before(), mask, true, world, column, why)) return refuse(call, 0, why, world, column);
  batch->step(dt, steps, mask);
  if (stopped) *stopped = batch->stopped_count();
}

void write(Call& call, const ChangingBatch& batch, const std::uint32_t* columns, std::uint64_t count,
           const std::uint8_t* mask) {
  if (!are_columns(call, *batch, columns, count)) return;
  const FloatScope scope;
  const std::span<const std::uint32_t> listed(columns, count);
  batch::Why why;
  std::uint64_t world = 0;
  std::uint32_t column = 0;
  for (const std::uint32_t number : listed)
    if (!batch->columns()[number].writable) {
      call.fail(CAROM_E_UNSUPPORTED, 2, "column %u can be read, not written", number);
      return;
    }
  if (!batch->check(listed, mask, false, world, column, why) || !batch->write(listed, mask, world, column, why))
    refuse(call, 2, why, world, column);
}

void reset(Call& call, const ChangingBatch& batch, const std::uint8_t* mask, const std::uint32_t* starts) {
  if (starts)
    for (std::uint64_t k = 0; k < batch->size(); ++k) {
      const std::size_t known = batch->starts_of(batch->structure_of(k));
      if ((mask && !mask[k]) || starts[k] < known) continue;
      call.fail(CAROM_E_OUT_OF_RANGE, 3, "starts[%llu] is %u, its structure has %zu",
                static_cast<unsigned long long>(k), starts[k], known);
      return;
    }
  const FloatScope scope;
  batch->reset(mask, starts);
}

void save(Call& call, const ChangingBatch& batch, std::uint64_t number, void* buffer, std::uint64_t capacity,
          std::uint64_t* needed) {
  if (!is_world(call, 2, *batch, number) || (capacity && !present(call, 3, "buffer", buffer)) ||
      !present(call, 5, "needed", needed))
    return;
  const FloatScope scope;
  const World& world = batch->look_at(number);
  const std::uint64_t size = save_state(world, nullptr, 0);
  *needed = size;
  if (!buffer) return;
  if (size > capacity)
    call.fail(CAROM_E_BUFFER_TOO_SMALL, 4, "the snapshot takes %llu bytes, capacity is %llu",
              static_cast<unsigned long long>(size), static_cast<unsigned long long>(capacity));
  else
    save_state(world, static_cast<std::byte*>(buffer), capacity);
}

void fill_random(std::uint32_t kind, const std::uint64_t* keys, std::uint64_t n, std::uint64_t width, double* dst) {
  for (std::uint64_t i = 0; i < n; ++i) {
    const RandomKey key{keys[3 * i], keys[3 * i + 1], keys[3 * i + 2]};
    for (std::uint64_t k = 0; k < width; k += 2) {
      const auto two = kind == CAROM_RANDOM_NORMAL ? normal_pair(key, k / 2) : uniform_pair(key, k / 2);
      std::copy_n(two.begin(), std::min<std::uint64_t>(2, width - k), dst + width * i + k);
    }
  }
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_batch_column_init(carom_batch_column* column, uint32_t struct_size) {
  return init_struct(column, struct_size, [](carom_batch_column& c) { c.scalar = CAROM_SCALAR_F64; });
}

int32_t carom_batch_create(carom_engine* engine, carom_batch** batch, carom_error* error) {
  return guarded(error, [&](Call& call) { create(call, engine, batch); });
}

int32_t carom_batch_destroy(carom_batch* batch, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "batch", batch)) return;
    if (!batch->gate.enter_alone())  // never left: the batch is gone
      call.fail(CAROM_E_BUSY, 1, "another thread uses this batch");
    else
      destroy(batch);
  });
}

int32_t carom_batch_add_worlds(carom_batch* batch, carom_world* world, uint64_t n, uint64_t* first,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (changing) add_worlds(call, changing, world, n, first);
  });
}

int32_t carom_batch_add_column(carom_batch* batch, const carom_batch_column* desc, uint32_t* column,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (changing) add_column(call, changing, desc, column);
  });
}

int32_t carom_batch_step(carom_batch* batch, const uint8_t* mask, double dt, uint32_t steps, uint64_t* stopped,
                         carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (changing) step(call, changing, mask, dt, steps, stopped);
  });
}

int32_t carom_batch_read(carom_batch* batch, const uint32_t* columns, uint64_t count, const uint8_t* mask,
                         carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (!changing || !are_columns(call, *changing, columns, count)) return;
    const FloatScope scope;
    changing->read({columns, static_cast<std::size_t>(count)}, mask);
  });
}

int32_t carom_batch_write(carom_batch* batch, const uint32_t* columns, uint64_t count, const uint8_t* mask,
                          carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (changing) write(call, changing, columns, count, mask);
  });
}

int32_t carom_batch_add_start(carom_batch* batch, uint64_t world, const void* bytes, uint64_t size, uint32_t* start,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (!changing || !is_world(call, 2, *changing, world) || !present(call, 3, "bytes", bytes) ||
        !present(call, 5, "start", start))
      return;
    const FloatScope scope;
    SnapshotFault fault;
    const std::uint32_t made =
        changing->add_start(changing->structure_of(world), static_cast<const std::byte*>(bytes), size, fault);
    if (made)
      *start = made;
    else
      call.fail(code_of(fault), 3, "%.200s", fault.text);
  });
}

int32_t carom_batch_reset(carom_batch* batch, const uint8_t* mask, const uint32_t* starts, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (changing) reset(call, changing, mask, starts);
  });
}

int32_t carom_batch_save(carom_batch* batch, uint64_t world, void* buffer, uint64_t capacity, uint64_t* needed,
                         carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (changing) save(call, changing, world, buffer, capacity, needed);
  });
}

int32_t carom_batch_get_hashes(carom_batch* batch, uint64_t* hashes, uint64_t n, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (!changing || !is_count(call, 3, *changing, n) || (n && !present(call, 2, "hashes", hashes))) return;
    const FloatScope scope;
    changing->hashes(hashes);
  });
}

int32_t carom_batch_get_stopped(carom_batch* batch, uint32_t* stopped, uint64_t n, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (!changing || !is_count(call, 3, *changing, n) || (n && !present(call, 2, "stopped", stopped))) return;
    for (std::uint64_t k = 0; k < n; ++k) stopped[k] = static_cast<std::uint32_t>(changing->stopped(k));
  });
}

int32_t carom_batch_get_faults(carom_batch* batch, uint64_t world, carom_fault* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (!changing || !is_world(call, 2, *changing, world) || (capacity && !present(call, 3, "dst", dst)) ||
        !present(call, 6, "count", count) || (capacity && !element_stride<carom_fault>(call, 4, stride)))
      return;
    const FaultViews& faults = changing->faults(world);
    const World& model = changing->model(changing->structure_of(world));
    *count = faults.size();
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(capacity, faults.size()); ++i)
      write_element(fault_of(model, faults[i]), dst, i, stride);
  });
}

int32_t carom_batch_get_info(carom_batch* batch, carom_batch_info* info, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const ChangingBatch changing(call, batch);
    if (!changing || !fillable(call, 2, "info", info)) return;
    carom_batch_info full{};
    full.structures = static_cast<std::uint32_t>(changing->structures());
    full.worlds = changing->size(), full.stopped = changing->stopped_count();
    full.columns = changing->columns().size();
    full.real_worlds = changing->lanes() * changing->structures();
    full.state_bytes = changing->state_bytes();
    write_struct(full, info);
  });
}

int32_t carom_random_fill(uint32_t kind, const uint64_t* keys, uint64_t n, uint64_t width, double* dst,
                          carom_error* error) {
  return guarded(error, [&](Call& call) {
    const std::uint64_t row = sizeof(double) * std::min<std::uint64_t>(width, std::uint64_t(1) << 32);
    if (!known(call, 1, "kind", kind, CAROM_RANDOM_COUNT) || !present(call, 2, "keys", keys) ||
        !in_range(call, 4, "width", static_cast<double>(width), 0,
                  static_cast<double>(kLargestStride / sizeof(double))) ||
        !spans(call, 3, 3, n, std::max<std::uint64_t>(row, 3 * sizeof(std::uint64_t)), row) ||
        !present(call, 5, "dst", dst))
      return;
    const FloatScope scope;
    fill_random(kind, keys, n, width, dst);
  });
}

}  // extern "C"

// Many worlds of a few structures. A world is its state in few bytes (packed.h); there are as many real ones as threads
// work at once. A step unpacks a state into one of those, writes what a host gives, steps, reads what it asked for, and
// packs the state again: what a real world needs for its steps stays in the cache of its thread.
#pragma once

#include <mutex>
#include <span>

#include "batch/packed.h"
#include "core/jobs.h"
#include "dynamics/world.h"

namespace carom::batch {

/// Why numbers were refused. The code is of whoever refuses; text is empty where nothing was.
struct Why {
  std::int32_t code = 0;
  const char* remedy = nullptr;  // null: of the code
  char text[240] = {0};

  /// Always false.
  bool refuse(std::int32_t of, const char* format, ...) __attribute__((format(printf, 3, 4)));
};

/// Numbers of a world that stand in one row of a host's array: one field of some of its things.
class Rows {
 public:
  virtual ~Rows() = default;
  virtual std::size_t width() const = 0;
  /// @param dt  s, of the step before; 0: none was since the state was put in
  virtual void read(const World& world, Real dt, double* row) const = 0;
  /// Whether a world of this structure may have these numbers, as far as that does not depend on its state.
  virtual bool check(const World& model, const double* row, Why& why) const = 0;
  /// Of numbers that were checked. @return false: the state forbids it, and nothing is written
  virtual bool write(World& world, const double* row, Why& why) const = 0;
  /// Bodies whose masses these are: no state holds them, so a batch does.
  virtual std::span<const std::uint32_t> massed() const { return {}; }
};

enum class When : std::uint32_t { on_call, before_step, after_step, count };

/// Where the rows of a structure's worlds lie.
struct Column {
  Owned<Rows> rows;
  std::uint32_t structure = 0;
  When when = When::on_call;
  bool in_floats = false;
  bool writable = false;
  std::byte* data = nullptr;
  std::uint64_t stride = 0;  // bytes
};

enum class Stopped : std::uint32_t { no, fault, memory };

/// A host's mask over all worlds; null: every one.
using Mask = const std::uint8_t*;

/// Give a dynamic body a mass, its centre where it is and its inertia in proportion; the model's own where that is it.
void set_mass(World& world, const World& model, std::uint32_t body, Real mass);

class Batch {
 public:
  /// @param jobs  null: the calling thread alone
  Batch(Memory* memory, Jobs* jobs);
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  // Calls are made one at a time. One that throws has changed nothing, but for step().

  /// n worlds that are as this one is. @return the number of the first
  std::uint64_t add_worlds(const World& world, std::uint64_t n);
  std::uint64_t size() const { return members_.size(); }
  std::size_t structures() const { return structures_.size(); }
  std::uint32_t structure_of(std::uint64_t world) const { return members_[world].structure; }
  std::uint64_t first_of(std::uint32_t structure) const { return structures_[structure]->first; }
  std::uint64_t count_of(std::uint32_t structure) const { return structures_[structure]->n; }
  /// A real world of the structure, as it was given: for handles, kinds, checks.
  const World& model(std::uint32_t structure) const { return *structures_[structure]->model; }

  /// @return its number
  std::uint32_t add_column(Column column);
  const Array<Column>& columns() const { return columns_; }
  /// All that is to be written for these worlds. @param running  of those that are not stopped
  /// @param world, column  the first at fault
  bool check(std::span<const std::uint32_t> columns, Mask mask, bool running, std::uint64_t& world,
             std::uint32_t& column, Why& why);
  /// Columns that are written before each step.
  std::span<const std::uint32_t> before() const { return before_; }

  /// A state of a structure to begin from, by its snapshot. @return its number; 0, what worlds are made with: refused
  std::uint32_t add_start(std::uint32_t structure, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault);
  std::size_t starts_of(std::uint32_t structure) const { return structures_[structure]->starts.size(); }

  /// Those of the mask that are not stopped. What is written before steps was checked.
  void step(Real dt, std::uint32_t steps, Mask mask);
  /// Write columns, one after the other, into worlds of their structures. @return false: of `world` one was refused
  bool write(std::span<const std::uint32_t> columns, Mask mask, std::uint64_t& world, std::uint32_t& column, Why& why);
  void read(std::span<const std::uint32_t> columns, Mask mask);
  /// @param starts  [size()] or null: 0
  void reset(Mask mask, const std::uint32_t* starts);
  /// The state of a world, in a real one, until the next call.
  const World& look_at(std::uint64_t world);
  void hashes(std::uint64_t* to);

  Stopped stopped(std::uint64_t world) const { return members_[world].stopped; }
  const FaultViews& faults(std::uint64_t world) const { return members_[world].faults; }
  std::uint64_t stopped_count() const;
  std::uint64_t state_bytes() const;
  std::size_t lanes() const { return lanes_.size(); }

 private:
  struct Start {
    Array<std::byte> packed;
    Array<double> rows;       // of columns that are read after steps
    bool rows_known = false;  // since the last such column was added
  };
  struct Structure {
    Structure(Owned<World> its_model, Array<std::byte> its_whole, Array<const Shape*> its_shapes, PackingBase its_base,
              std::uint64_t its_first, std::uint64_t its_n, Memory* memory)
        : model(std::move(its_model)),
          whole(std::move(its_whole)),
          shapes(std::move(its_shapes)),
          base(std::move(its_base)),
          first(its_first),
          n(its_n),
          starts(memory),
          before(memory),
          after(memory),
          massed(memory) {}
    Owned<World> model;
    Array<std::byte> whole;      // a snapshot that real worlds are built of
    Array<const Shape*> shapes;  // by their numbers in it
    PackingBase base;
    std::uint64_t first, n;
    Array<Start> starts;
    Array<std::uint32_t> before, after;  // columns
    Array<std::uint32_t> massed;         // bodies whose masses a host may set
    bool on_host_thread = false;         // a support function may be called on the calling thread alone
  };
  struct Member {
    explicit Member(Memory* memory) : packed(memory), masses(memory), faults(memory) {}
    Array<std::byte> packed;
    Array<double> masses;  // kg, of the structure's massed bodies; empty: the model's
    FaultViews faults;     // of the step that stopped it
    std::uint32_t structure = 0;
    Stopped stopped = Stopped::no;
  };
  /// What one thread works with at a time.
  struct Lane {
    explicit Lane(Memory* memory) : worlds(memory), masses(memory), bytes(memory), packed(memory), row(memory) {}
    Array<Owned<World>> worlds;   // by structure; null until needed
    Array<Array<double>> masses;  // kg, that they have
    Array<std::byte> bytes, packed;
    Array<double> row;
  };
  class LaneUse;

  Lane* take_lane();
  void give_lane(Lane& lane);
  World& real_world(Lane& lane, std::uint32_t structure);
  void set_masses(Lane& lane, std::uint32_t structure, const Array<double>& masses);
  World& load(Lane& lane, std::uint32_t structure, const Array<std::byte>& packed, const Array<double>& masses);
  std::span<const std::byte> pack(Lane& lane, std::uint32_t structure, const World& world);
  static void keep(std::span<const std::byte> packed, Array<std::byte>& to);
  std::byte* place(const Column& column, std::uint64_t world) const;
  void fetch(const Column& column, std::uint64_t world, double* row) const;
  void store(const Column& column, std::uint64_t world, const double* row) const;
  void step_one(Lane& lane, std::uint64_t world, Real dt, std::uint32_t steps);
  void tell(Lane& lane, std::uint64_t world, const World& at, Real dt);
  Array<double> rows_after(Lane& lane, const Structure& of, const World& world) const;
  void store_after(std::uint64_t world, const Array<double>& rows) const;
  void learn_masses(Lane& lane, std::uint32_t structure, Array<double>& masses);
  template <class Each>
  void each(Mask mask, const Each& f);
  /// Likewise, to the end; @throws std::bad_alloc then, if one had no memory.
  template <class Each>
  void each_or_throw(Mask mask, const Each& f);
  template <class Each>
  void each_of(std::span<const std::uint32_t> columns, Mask mask, const Each& f);
  template <class Each>
  void share(Jobs* jobs, bool on_host_thread, Mask mask, const Each& f);

  Memory* memory_;
  Jobs* jobs_;
  Array<Owned<Structure>> structures_;
  Array<Member> members_;
  Array<Column> columns_;
  Array<std::uint32_t> before_;
  std::size_t widest_ = 0;
  std::mutex lanes_mutex_;
  Array<Owned<Lane>> lanes_;
  Array<Lane*> idle_;
};

}  // namespace carom::batch

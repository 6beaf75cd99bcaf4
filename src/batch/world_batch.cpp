#include "batch/world_batch.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace carom::batch {
namespace {

/// Shapes of a structure, which its model keeps alive.
class KnownShapes final : public ShapeMaker {
 public:
  explicit KnownShapes(const Array<const Shape*>& shapes) : shapes_(shapes) {}
  const Shape* make(std::size_t number, const ShapeImage&, SnapshotFault&) override {
    return number < shapes_.size() ? shapes_[number] : nullptr;
  }

 private:
  const Array<const Shape*>& shapes_;
};
class NoNames final : public ShapeNames {
 public:
  bool name(const Shape&, std::string_view&, std::uint32_t&) const override { return false; }
};

/// Parts of a loop over worlds: enough of them that threads end together, and none so small that taking it costs.
constexpr std::uint64_t kParts = 256, kLargestPart = 16;

Owned<World> build(const Array<std::byte>& whole, const Array<const Shape*>& shapes, std::uint32_t tag,
                   Memory* memory) {
  Owned<World> world = make_owned<World>(memory, tag, Vec3::zero(), std::size_t(0), memory);
  KnownShapes known(shapes);
  SnapshotFault fault;
  if (!build_world(*world, whole.data(), whole.size(), known, fault)) throw std::logic_error(fault.text);
  return world;
}

Array<std::byte> state_of(const World& world, Memory* memory) {
  Array<std::byte> bytes(save_state(world, nullptr, 0, Origin::own), std::byte(0), memory);
  save_state(world, bytes.data(), bytes.size(), Origin::own);
  return bytes;
}

}  // namespace

bool Why::refuse(std::int32_t of, const char* format, ...) {
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  code = of;
  return false;
}

void set_mass(World& world, const World& model, std::uint32_t body, Real mass) {
  if (world.scene.mass[body] == mass) return;
  const BodySettings& def = model.scene.def[body];
  MassGiven given{def.mass, def.has_center, def.has_inertia, def.center, def.inertia};
  if (!def.has_mass) given.mass = 0;
  const Real usual = model.scene.mass[body];
  if (mass != usual) given.mass = mass, given.inertia = def.inertia * (mass / usual);
  world.set_mass(body, given);
}

/// One thread's lane, for a part of a loop; false where there is no memory for another.
class Batch::LaneUse {
 public:
  explicit LaneUse(Batch& batch) : batch_(batch), lane_(batch.take_lane()) {}
  ~LaneUse() {
    if (lane_) batch_.give_lane(*lane_);
  }
  LaneUse(const LaneUse&) = delete;
  LaneUse& operator=(const LaneUse&) = delete;
  explicit operator bool() const { return lane_; }
  Lane& operator*() const { return *lane_; }
  /// Of a call that needs one.
  Lane& demand() const {
    if (!lane_) throw std::bad_alloc();
    return *lane_;
  }

 private:
  Batch& batch_;
  Lane* const lane_;
};

Batch::Batch(Memory* memory, Jobs* jobs)
    : memory_(memory),
      jobs_(jobs),
      structures_(memory),
      members_(memory),
      columns_(memory),
      before_(memory),
      lanes_(memory),
      idle_(memory) {}

Batch::~Batch() = default;

std::uint64_t Batch::add_worlds(const World& world, std::uint64_t n) {
  const NoNames names;
  Array<std::byte> whole(save_world(world, names, nullptr, 0), std::byte(0), memory_);
  save_world(world, names, whole.data(), whole.size());
  Array<const Shape*> shapes = shapes_of(world, memory_);
  Owned<World> model = build(whole, shapes, world.scene.bodies.tag(), memory_);
  PackingBase base(state_of(*model, memory_));
  const std::uint64_t first = members_.size();
  auto made = make_owned<Structure>(memory_, std::move(model), std::move(whole), std::move(shapes), std::move(base),
                                    first, n, memory_);
  const Colliders& c = made->model->scene.colliders;
  for (const std::uint32_t slot : c.live) made->on_host_thread |= c.shape[slot]->host_thread;
  const auto number = static_cast<std::uint32_t>(structures_.size());

  Array<Member> members(memory_);
  members.reserve(n);
  Array<std::byte> packed(memory_);
  {
    const Array<std::byte> state = state_of(*made->model, memory_);
    packed.resize(made->base.pack(state.data(), state.size(), nullptr, 0));
    made->base.pack(state.data(), state.size(), packed.data(), packed.size());
  }
  for (std::uint64_t k = 0; k < n; ++k) {
    members.emplace_back(memory_).structure = number;
    keep(packed, members.back().packed);
  }
  made->starts.push_back({Array<std::byte>(packed.begin(), packed.end(), memory_), Array<double>(memory_)});
  structures_.reserve(structures_.size() + 1);
  members_.reserve(members_.size() + n);
  structures_.push_back(std::move(made));
  for (Member& member : members) members_.push_back(std::move(member));
  return first;
}

std::uint32_t Batch::add_column(Column column) {
  Structure& of = *structures_[column.structure];
  const auto number = static_cast<std::uint32_t>(columns_.size());
  const std::size_t width = column.rows->width();
  Array<std::uint32_t> massed(of.massed, memory_);
  for (const std::uint32_t body : column.rows->massed())
    if (std::find(massed.begin(), massed.end(), body) == massed.end()) massed.push_back(body);
  for (Member& member : members_)  // masses that are known get their new neighbours, the model's
    if (!member.masses.empty()) member.masses.reserve(massed.size());
  for (const Owned<Lane>& lane : lanes_)
    if (column.structure < lane->masses.size()) lane->masses[column.structure].reserve(massed.size());
  const When when = column.when;
  columns_.reserve(columns_.size() + 1), before_.reserve(before_.size() + 1);
  of.before.reserve(of.before.size() + 1), of.after.reserve(of.after.size() + 1);

  const auto extend = [&](Array<double>& masses) {
    if (masses.empty()) return;
    for (std::size_t k = masses.size(); k < massed.size(); ++k) masses.push_back(of.model->scene.mass[massed[k]]);
  };
  for (std::uint64_t k = of.first; k < of.first + of.n; ++k) extend(members_[k].masses);
  for (const Owned<Lane>& lane : lanes_)
    if (column.structure < lane->masses.size()) extend(lane->masses[column.structure]);
  of.massed.swap(massed);
  columns_.push_back(std::move(column));
  widest_ = std::max(widest_, width);
  if (when == When::before_step) before_.push_back(number), of.before.push_back(number);
  if (when == When::after_step) {
    of.after.push_back(number);
    for (Start& start : of.starts) start.rows_known = false;
  }
  return number;
}

// ---- lanes ----

/// @return null: there is no memory for another
Batch::Lane* Batch::take_lane() {
  const std::lock_guard lock(lanes_mutex_);
  if (!idle_.empty()) {
    Lane* const lane = idle_.back();
    idle_.pop_back();
    return lane;
  }
  try {
    idle_.reserve(lanes_.size() + 1);
    lanes_.push_back(make_owned<Lane>(memory_, memory_));
    return lanes_.back().get();
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void Batch::give_lane(Lane& lane) {
  const std::lock_guard lock(lanes_mutex_);
  idle_.push_back(&lane);  // reserved for all
}

World& Batch::real_world(Lane& lane, std::uint32_t structure) {
  if (lane.worlds.size() < structures_.size()) {
    lane.masses.reserve(structures_.size());
    lane.worlds.resize(structures_.size());
    while (lane.masses.size() < structures_.size()) lane.masses.emplace_back();
  }
  Owned<World>& world = lane.worlds[structure];
  if (!world) {
    const Structure& of = *structures_[structure];
    world = build(of.whole, of.shapes, of.model->scene.bodies.tag(), memory_);
    lane.masses[structure].clear();
  }
  if (lane.row.size() < widest_) lane.row.resize(widest_);
  return *world;
}

void Batch::set_masses(Lane& lane, std::uint32_t structure, const Array<double>& masses) {
  Array<double>& now = lane.masses[structure];
  if (now == masses) return;
  const Structure& of = *structures_[structure];
  World& world = *lane.worlds[structure];
  now.reserve(of.massed.size());
  try {
    for (std::size_t k = 0; k < of.massed.size(); ++k)
      set_mass(world, *of.model, of.massed[k], masses.empty() ? of.model->scene.mass[of.massed[k]] : masses[k]);
  } catch (...) {  // some are set
    lane.worlds[structure].reset();
    throw;
  }
  now.assign(masses.begin(), masses.end());
}

/// What masses a world has after a host wrote some.
void Batch::learn_masses(Lane& lane, std::uint32_t structure, Array<double>& masses) {
  const Structure& of = *structures_[structure];
  const World& world = *lane.worlds[structure];
  masses.clear();
  bool usual = true;
  for (const std::uint32_t body : of.massed) {
    masses.push_back(world.scene.mass[body]);
    usual &= world.scene.mass[body] == of.model->scene.mass[body];
  }
  if (usual) masses.clear();
  lane.masses[structure] = masses;
}

World& Batch::load(Lane& lane, std::uint32_t structure, const Array<std::byte>& packed, const Array<double>& masses) {
  World& world = real_world(lane, structure);
  set_masses(lane, structure, masses);
  structures_[structure]->base.unpack(packed, lane.bytes);
  std::uint64_t n;
  std::memcpy(&n, packed.data(), sizeof n);
  SnapshotFault fault;
  if (!restore_state(world, lane.bytes.data(), n, fault, Origin::own)) throw std::logic_error(fault.text);
  return world;
}

std::span<const std::byte> Batch::pack(Lane& lane, std::uint32_t structure, const World& world) {
  std::uint64_t n = save_state(world, lane.bytes.data(), lane.bytes.size(), Origin::own);
  if (n > lane.bytes.size()) {
    remake(lane.bytes, n + n / 4);
    n = save_state(world, lane.bytes.data(), lane.bytes.size(), Origin::own);
  }
  const PackingBase& base = structures_[structure]->base;
  std::uint64_t size = base.pack(lane.bytes.data(), n, lane.packed.data(), lane.packed.size());
  if (size > lane.packed.size()) {
    remake(lane.packed, size + size / 4);
    size = base.pack(lane.bytes.data(), n, lane.packed.data(), lane.packed.size());
  }
  return {lane.packed.data(), static_cast<std::size_t>(size)};
}

/// @throws std::bad_alloc  then `to` is as it was
void Batch::keep(std::span<const std::byte> packed, Array<std::byte>& to) {
  const std::size_t size = packed.size();
  if (size > to.capacity() || 2 * size < to.capacity()) {
    Array<std::byte> fresh(to.get_allocator());
    fresh.reserve(size + size / 16);
    to.swap(fresh);
  }
  to.assign(packed.begin(), packed.end());
}

// ---- rows ----

std::byte* Batch::place(const Column& column, std::uint64_t world) const {
  return column.data + (world - structures_[column.structure]->first) * column.stride;
}

void Batch::fetch(const Column& column, std::uint64_t world, double* row) const {
  const std::byte* from = place(column, world);
  const std::size_t n = column.rows->width();
  if (!column.in_floats) {
    if (n > 0) std::memcpy(row, from, sizeof(double) * n);
    return;
  }
  for (std::size_t k = 0; k < n; ++k, from += sizeof(float)) {
    float number;
    std::memcpy(&number, from, sizeof number);
    row[k] = number;
  }
}

void Batch::store(const Column& column, std::uint64_t world, const double* row) const {
  std::byte* to = place(column, world);
  const std::size_t n = column.rows->width();
  if (!column.in_floats) {
    if (n > 0) std::memcpy(to, row, sizeof(double) * n);
    return;
  }
  for (std::size_t k = 0; k < n; ++k, to += sizeof(float)) {
    const auto number = static_cast<float>(row[k]);
    std::memcpy(to, &number, sizeof number);
  }
}

void Batch::tell(Lane& lane, std::uint64_t world, const World& at, Real dt) {
  for (const std::uint32_t number : structures_[members_[world].structure]->after) {
    columns_[number].rows->read(at, dt, lane.row.data());
    store(columns_[number], world, lane.row.data());
  }
}

bool Batch::check(std::span<const std::uint32_t> columns, Mask mask, bool running, std::uint64_t& world,
                  std::uint32_t& column, Why& why) {
  Array<double> row(widest_, 0, memory_);
  for (const std::uint32_t number : columns) {
    const Column& c = columns_[number];
    const Structure& of = *structures_[c.structure];
    for (std::uint64_t k = of.first; k < of.first + of.n; ++k) {
      if ((mask && !mask[k]) || (running && members_[k].stopped != Stopped::no)) continue;
      fetch(c, k, row.data());
      if (c.rows->check(*of.model, row.data(), why)) continue;
      world = k, column = number;
      return false;
    }
  }
  return true;
}

// ---- all of them ----

/// f(lane, world) for all of the mask, shared among threads. A part for which there is no lane is left to the calling
/// thread, which has one.   @throws std::bad_alloc  before anything is done
template <class Each>
void Batch::each(Mask mask, const Each& f) {
  bool any = false, all = true;
  for (const Owned<Structure>& of : structures_) any |= of->on_host_thread, all &= of->on_host_thread;
  if (any) share(nullptr, true, mask, f);
  if (!all) share(jobs_, false, mask, f);
}

template <class Each>
void Batch::share(Jobs* jobs, bool on_host_thread, Mask mask, const Each& f) {
  const std::uint64_t n = members_.size();
  const auto wanted = [&](std::uint64_t k) {
    return (!mask || mask[k]) && structures_[members_[k].structure]->on_host_thread == on_host_thread;
  };
  Array<std::uint8_t> left(n, 0, memory_);
  { LaneUse(*this).demand(); }
  in_parts(jobs, n, std::clamp<std::uint64_t>(n / kParts, 1, kLargestPart),
           [&](std::uint32_t begin, std::uint32_t end) {
             const LaneUse lane(*this);
             for (std::uint32_t k = begin; k < end; ++k)
               if (!lane)
                 left[k] = wanted(k);
               else if (wanted(k))
                 f(*lane, k);
           });
  const LaneUse lane(*this);
  for (std::uint64_t k = 0; k < n; ++k)
    if (left[k]) f(*lane, k);
}

template <class Each>
void Batch::each_or_throw(Mask mask, const Each& f) {
  bool out_of_memory = false;
  each(mask, [&](Lane& lane, std::uint64_t k) {
    try {
      f(lane, k);
    } catch (const std::bad_alloc&) {
      const std::lock_guard lock(lanes_mutex_);
      out_of_memory = true;
    }
  });
  if (out_of_memory) throw std::bad_alloc();
}

/// f(lane, world, structure) for all of the mask of which some of the columns are.
template <class Each>
void Batch::each_of(std::span<const std::uint32_t> columns, Mask mask, const Each& f) {
  each_or_throw(mask, [&](Lane& lane, std::uint64_t k) {
    const std::uint32_t structure = members_[k].structure;
    if (std::ranges::any_of(columns, [&](auto number) { return columns_[number].structure == structure; }))
      f(lane, k, structure);
  });
}

void Batch::step(Real dt, std::uint32_t steps, Mask mask) {
  each(mask, [&](Lane& lane, std::uint64_t k) {
    if (members_[k].stopped != Stopped::no) return;
    try {
      step_one(lane, k, dt, steps);
    } catch (const std::bad_alloc&) {
      members_[k].stopped = Stopped::memory;
    } catch (...) {  // a callback ended the thread, or threw: the real world is not at the end of a step
      const std::uint32_t structure = members_[k].structure;
      if (structure < lane.worlds.size() && lane.worlds[structure]) lane.worlds[structure]->abandon_step();
      throw;
    }
  });
}

void Batch::step_one(Lane& lane, std::uint64_t k, Real dt, std::uint32_t steps) {
  Member& member = members_[k];
  World& world = load(lane, member.structure, member.packed, member.masses);
  const Structure& of = *structures_[member.structure];
  Array<double> masses(memory_);
  bool wrote_masses = false;
  Why why;
  for (const std::uint32_t number : of.before) {
    const Column& column = columns_[number];
    fetch(column, k, lane.row.data());
    if (!column.rows->write(world, lane.row.data(), why)) throw std::logic_error(why.text);  // none that may refuse
    wrote_masses |= !column.rows->massed().empty();
  }
  if (wrote_masses) learn_masses(lane, member.structure, masses);
  Stopped stopped = Stopped::no;
  for (std::uint32_t s = 0; s < steps && stopped == Stopped::no; ++s) {
    world.step(dt);
    if (world.fault_views.empty()) continue;
    member.faults.assign(world.fault_views.begin(), world.fault_views.end());
    stopped = Stopped::fault;
  }
  keep(pack(lane, member.structure, world), member.packed);
  if (wrote_masses) member.masses.swap(masses);
  member.stopped = stopped;
  tell(lane, k, world, dt);
}

bool Batch::write(std::span<const std::uint32_t> columns, Mask mask, std::uint64_t& at_fault,
                  std::uint32_t& column_at_fault, Why& why) {
  struct Fresh {
    Array<std::byte> packed;
    Array<double> masses, rows;
    bool due = false;
  };
  Array<Fresh> fresh(memory_);
  fresh.reserve(members_.size());
  for (std::uint64_t k = 0; k < members_.size(); ++k)
    fresh.push_back({Array<std::byte>(memory_), Array<double>(memory_), Array<double>(memory_)});
  at_fault = members_.size();
  each_of(columns, mask, [&](Lane& lane, std::uint64_t k, std::uint32_t structure) {
    World& world = load(lane, structure, members_[k].packed, members_[k].masses);
    fresh[k].masses = members_[k].masses;
    for (const std::uint32_t number : columns) {
      const Column& column = columns_[number];
      if (column.structure != structure) continue;
      fetch(column, k, lane.row.data());
      Why refused;
      if (!column.rows->write(world, lane.row.data(), refused)) {
        const std::lock_guard lock(lanes_mutex_);
        if (k < at_fault) at_fault = k, column_at_fault = number, why = refused;  // the first, whoever finds it
        return;
      }
      if (!column.rows->massed().empty()) learn_masses(lane, structure, fresh[k].masses);
    }
    keep(pack(lane, structure, world), fresh[k].packed);
    fresh[k].rows = rows_after(lane, *structures_[structure], world);
    fresh[k].due = true;
  });
  if (at_fault < members_.size()) return false;
  for (std::uint64_t k = 0; k < members_.size(); ++k) {
    if (!fresh[k].due) continue;
    members_[k].packed.swap(fresh[k].packed), members_[k].masses.swap(fresh[k].masses);
    store_after(k, fresh[k].rows);
  }
  return true;
}

void Batch::read(std::span<const std::uint32_t> columns, Mask mask) {
  each_of(columns, mask, [&](Lane& lane, std::uint64_t k, std::uint32_t structure) {
    const World& world = load(lane, structure, members_[k].packed, members_[k].masses);
    for (const std::uint32_t number : columns) {
      if (columns_[number].structure != structure) continue;
      columns_[number].rows->read(world, 0, lane.row.data());
      store(columns_[number], k, lane.row.data());
    }
  });
}

std::uint32_t Batch::add_start(std::uint32_t structure, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault) {
  Structure& of = *structures_[structure];
  const LaneUse use(*this);
  Lane& lane = use.demand();
  World& world = real_world(lane, structure);
  set_masses(lane, structure, Array<double>(memory_));
  if (!restore_state(world, bytes, n, fault)) return 0;
  const std::span<const std::byte> packed = pack(lane, structure, world);
  of.starts.push_back({Array<std::byte>(packed.begin(), packed.end(), memory_), Array<double>(memory_)});
  return static_cast<std::uint32_t>(of.starts.size() - 1);
}

/// Rows of columns that are read after steps, one after the other.
Array<double> Batch::rows_after(Lane& lane, const Structure& of, const World& world) const {
  Array<double> rows(memory_);
  for (const std::uint32_t number : of.after) {
    const Rows& column = *columns_[number].rows;
    column.read(world, 0, lane.row.data());
    rows.insert(rows.end(), lane.row.begin(), lane.row.begin() + static_cast<std::ptrdiff_t>(column.width()));
  }
  return rows;
}

void Batch::store_after(std::uint64_t world, const Array<double>& rows) const {
  const double* row = rows.data();
  for (const std::uint32_t number : structures_[members_[world].structure]->after) {
    store(columns_[number], world, row);
    row += columns_[number].rows->width();
  }
}

void Batch::reset(Mask mask, const std::uint32_t* starts) {
  struct Own {  // of a world with masses of its own, which no start has
    Array<std::byte> packed;
    Array<double> rows;
  };
  const Array<double> usual(memory_);
  Array<Own> own(memory_);  // in the order of their worlds
  {
    // All that may fail comes first.
    const LaneUse use(*this);
    Lane& lane = use.demand();
    for (std::uint64_t k = 0; k < members_.size(); ++k) {
      if (mask && !mask[k]) continue;
      Member& member = members_[k];
      const Structure& of = *structures_[member.structure];
      Start& start = structures_[member.structure]->starts[starts ? starts[k] : 0];
      if (!member.masses.empty()) {
        World& world = load(lane, member.structure, start.packed, usual);
        set_masses(lane, member.structure, member.masses);
        const auto packed = pack(lane, member.structure, world);
        own.push_back({Array<std::byte>(packed.begin(), packed.end(), memory_), rows_after(lane, of, world)});
        continue;
      }
      if (start.packed.size() > member.packed.capacity()) {
        Array<std::byte> larger(memory_);
        larger.reserve(start.packed.size() + start.packed.size() / 16);
        larger.assign(member.packed.begin(), member.packed.end());
        member.packed.swap(larger);
      }
      if (start.rows_known) continue;
      start.rows = rows_after(lane, of, load(lane, member.structure, start.packed, usual));
      start.rows_known = true;
    }
  }
  std::size_t next = 0;
  for (std::uint64_t k = 0; k < members_.size(); ++k) {
    if (mask && !mask[k]) continue;
    Member& member = members_[k];
    const Start& start = structures_[member.structure]->starts[starts ? starts[k] : 0];
    if (member.masses.empty()) {
      member.packed.assign(start.packed.begin(), start.packed.end());
      store_after(k, start.rows);
    } else {
      member.packed.swap(own[next].packed);
      store_after(k, own[next++].rows);
    }
    member.stopped = Stopped::no;
    member.faults.clear();
  }
}

const World& Batch::look_at(std::uint64_t world) {
  const LaneUse lane(*this);
  return load(lane.demand(), members_[world].structure, members_[world].packed, members_[world].masses);
}

void Batch::hashes(std::uint64_t* to) {
  each_or_throw(nullptr, [&](Lane& lane, std::uint64_t k) {
    to[k] = load(lane, members_[k].structure, members_[k].packed, members_[k].masses).hash();
  });
}

std::uint64_t Batch::stopped_count() const {
  std::uint64_t n = 0;
  for (const Member& member : members_) n += member.stopped != Stopped::no;
  return n;
}

std::uint64_t Batch::state_bytes() const {
  std::uint64_t n = members_.capacity() * sizeof(Member);
  for (const Member& member : members_)
    n += member.packed.capacity() + sizeof(double) * member.masses.capacity() +
         sizeof(FaultView) * member.faults.capacity();
  return n;
}

}  // namespace carom::batch

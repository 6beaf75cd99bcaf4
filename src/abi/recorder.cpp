#include "abi/recorder.h"

#include <algorithm>

#include "abi/engine.h"
#include "abi/record_calls.h"
#include "abi/snapshot_shapes.h"
#include "dynamics/world.h"

namespace carom::abi {

void Serializer::put(const void* from, std::uint64_t n) {
  const auto* const bytes = static_cast<const std::byte*>(from);
  if (n > 0) recorder_.content_.insert(recorder_.content_.end(), bytes, bytes + n);
}

void Serializer::call(std::string_view name) { number(recorder_.number_of(name)); }

void Serializer::shape(std::uint64_t handle) { recorder_.tell(handle); }

void Serializer::records(const void* from, std::uint64_t n, std::uint32_t scalars, std::uint32_t scalar,
                         std::uint64_t stride) {
  const std::uint64_t size = scalars * (scalar == CAROM_SCALAR_F32 ? sizeof(float) : sizeof(double));
  number(std::uint64_t(from ? 1 : 0));
  if (!from) return;
  number(n * size);
  for (std::uint64_t i = 0; i < n; ++i) put(static_cast<const char*>(from) + i * (stride ? stride : size), size);
}

Recorder::Recorder(carom_engine& engine, std::uint32_t flags, carom_write_fn to_host, void* user)
    : engine_(engine),
      flags_(flags),
      write_(to_host),
      user_(user),
      names_(&engine.memory),
      shapes_(&engine.memory),
      content_(&engine.memory),
      record_(&engine.memory) {}

void Recorder::send(const void* bytes, std::uint64_t size) {
  if (code_ != CAROM_OK) return;
  if (call_host([&] { return write_(user_, bytes, size); }) != 0)
    code_ = CAROM_E_WRITE_FAILED;
  else
    written_ += size;
}

void Recorder::write(Kind kind, const Array<std::byte>& content) {
  const struct {
    std::uint32_t kind, reserved;
    std::uint64_t size;
  } header{kind, 0, content.size()};
  record_.assign(sizeof header + content.size() + (-content.size() % 8), std::byte(0));
  std::memcpy(record_.data(), &header, sizeof header);
  std::copy(content.begin(), content.end(), record_.begin() + sizeof header);
  send(record_.data(), record_.size());
}

void Recorder::begin(const World& world) {
  const struct {
    char magic[8];
    std::uint32_t format, version;
  } header{{'C', 'A', 'R', 'O', 'M', 'R', 'E', 'C'}, 1, CAROM_VERSION_MAJOR << 16 | CAROM_VERSION_MINOR};
  const EngineNames names(engine_);
  Array<std::byte> whole(save_world(world, names, nullptr, 0), std::byte(0), &engine_.memory);
  save_world(world, names, whole.data(), whole.size());
  // Shapes that its colliders wear are told with it, but a later collider names one by its handle.
  send(&header, sizeof header);
  write(kBegin, whole);
}

std::uint32_t Recorder::number_of(std::string_view name) {
  const auto at = std::ranges::find(names_, name);
  const auto number = static_cast<std::uint32_t>(at - names_.begin());
  if (at != names_.end()) return number;
  Array<std::byte> content(sizeof number + name.size(), std::byte(0), &engine_.memory);
  std::memcpy(content.data(), &number, sizeof number);
  std::memcpy(content.data() + sizeof number, name.data(), name.size());
  names_.push_back(name);
  write(kName, content);
  return number;
}

/// As a whole snapshot of a world in which one body wears it: what finds and makes the shapes of a snapshot does so here.
void Recorder::tell(std::uint64_t shape) {
  const auto at = std::ranges::lower_bound(shapes_, shape);
  if (at != shapes_.end() && *at == shape) return;
  const Shape* worn = nullptr;
  {
    const std::lock_guard lock(engine_.mutex);
    worn = engine_.shapes[handle_slot(shape)].shape;  // a collider wears it by now
  }
  World stand(0, Vec3::zero(), 1, &engine_.memory);
  BodyDef def;
  def.type = BodyType::fixed;
  stand.add_body(def);
  const Handle collider = stand.add_collider(0, worn, Pose(), 0, Colliders::kNoMaterial);
  const EngineNames names(engine_);
  constexpr std::uint64_t kHead = 2 * sizeof(std::uint64_t);
  Array<std::byte> content(kHead + save_world(stand, names, nullptr, 0), std::byte(0), &engine_.memory);
  std::memcpy(content.data(), &shape, sizeof shape);
  std::memcpy(content.data() + sizeof shape, &collider, sizeof collider);
  save_world(stand, names, content.data() + kHead, content.size() - kHead);
  shapes_.insert(at, shape);
  write(kShape, content);
}

Array<std::byte> Recorder::state_of(const World& world) const {
  Array<std::byte> state(save_state(world, nullptr, 0), std::byte(0), &engine_.memory);
  save_state(world, state.data(), state.size());
  return state;
}

void Recorder::stepped(const World& world) {
  guard([&] {
    const std::uint64_t after[2] = {world.report.steps, world.hash()};
    content_.resize(sizeof after);
    std::memcpy(content_.data(), after, sizeof after);
    write(kHash, content_);
    if (flags_ & CAROM_RECORD_STATES) write(kState, state_of(world));
  });
}

void Recorder::broke_off(const World& world) {
  guard([&] {
    const Array<std::byte> state = state_of(world);
    call(record::world_restore(state.data(), state.size()));
  });
}

void Recorder::end() {
  guard([&] {
    content_.clear();
    write(kEnd, content_);
  });
}

}  // namespace carom::abi

#include "replay/script.h"

namespace carom::tools::replay {

std::string name_of_handle(std::uint64_t handle) {
  static constexpr const char* kKinds[] = {"?",        "plugin",    "shape", "material",    "body",
                                           "collider", "particles", "joint", "force field", "spring"};
  if (handle == 0) return "none";
  const std::uint64_t kind = handle >> 60;
  return std::string(kind < std::size(kKinds) ? kKinds[kind] : "?") + " " + std::to_string(handle & 0xFFFFFF);
}

void Script::damaged() {
  throw Error("the recording is damaged: a call's arguments are not what they should be",
              "record the session anew, or take the file again from where it was written");
}

void Script::take(void* to, std::uint64_t n) {
  if (n > static_cast<std::uint64_t>(end_ - at_)) damaged();
  std::memcpy(to, at_, n);
  at_ += n;
}

Bytes* Script::block(std::uint64_t element, std::uint64_t& n) {
  std::uint64_t present;
  take(&present, sizeof present);
  if (present > 1) damaged();
  if (!present) return nullptr;
  take(&n, sizeof n);
  if (n > static_cast<std::uint64_t>(end_ - at_) / element) damaged();
  kept_.emplace_back(at_, at_ + n * element);
  at_ += n * element;
  kept_.back().reserve(1);  // of none, too, the address is not null
  return &kept_.back();
}

void Script::demand(const char* name, std::uint64_t elements) const {
  const auto read = lengths_.find(name);
  if (read != lengths_.end() && read->second != elements) damaged();
}

std::uint64_t Script::bytes_of(std::uint64_t n, std::uint64_t width, std::uint32_t scalar) {
  constexpr std::uint64_t kNone = ~std::uint64_t(0);
  const std::uint64_t each = width * (scalar == CAROM_SCALAR_F32 ? 4 : 8);
  return each == 0 || n > kNone / each ? kNone : n * each;
}

void Script::say(const std::string& name, const std::string& value) {
  text_ += (text_.empty() ? "" : ", ") + name + "=" + value;
}

std::uint64_t Script::own_handle(const char* name, std::uint64_t recorded) {
  say(name, name_of_handle(recorded));
  std::uint64_t own = 0;
  Call call;
  call.done(carom_world_translate_handles(world_, &recorded, 1, &own, call), "finding " + name_of_handle(recorded));
  return own;
}

std::uint64_t Script::own_shape(const char* name, std::uint64_t recorded) {
  say(name, name_of_handle(recorded));
  const auto known = shapes_.find(recorded);
  if (known == shapes_.end()) damaged();
  return known->second;
}

const std::uint64_t* Script::handles(const char* name) {
  std::uint64_t n = 0;
  Bytes* const bytes = block(sizeof(std::uint64_t), n);
  if (!bytes) return say(name, "NULL"), nullptr;
  auto* const own = reinterpret_cast<std::uint64_t*>(bytes->data());
  lengths_[name] = n;
  std::string shown;
  for (std::uint64_t i = 0; i < n && i < 4; ++i) shown += (i ? ", " : "") + name_of_handle(own[i]);
  say(name, "(" + shown + (n > 4 ? ", ... " + std::to_string(n) + " in all" : "") + ")");
  Call call;
  call.done(carom_world_translate_handles(world_, own, n, own, call), "finding handles of a call");
  return own;
}

}  // namespace carom::tools::replay

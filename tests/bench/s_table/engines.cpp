// Carom as one of the engines, and the loader of the others.
#include "engines.h"

#include <dlfcn.h>

#include "counted_memory.h"

namespace carom::bench {

static_assert(sizeof(BodyState) == 13 * sizeof(double), "the bulk reads below write into its middle");

CaromWorld::CaromWorld(tools::Engine& engine, const SceneChoice& choice, const std::vector<std::string>& dials)
    : stage_(engine) {
  tools::build(tools::find_scene(choice.scene), choice.settings, stage_);
  for (const std::string& dial : dials) stage_.world.set_dial(dial);
  for (const tools::Actor& actor : stage_.actors) handles_.push_back(actor.body);
}

void CaromWorld::read(BodyState* states) const {
  tools::Call call;
  for (const auto& [field, dst] :
       {std::pair{CAROM_FIELD_POSE, states->position}, {CAROM_FIELD_VELOCITY, states->velocity}})
    call.done(carom_world_read(stage_.world.get(), field, CAROM_SCALAR_F64, handles_.data(), handles_.size(), dst,
                               sizeof(BodyState), call),
              "reading the bodies");
}

carom_engine_desc counted_engine() {
  carom_engine_desc desc;
  tools::Call call;
  call.done(carom_engine_desc_init(&desc), "describing an engine");
  desc.alloc = [](void*, std::uint64_t size, std::uint64_t alignment) {
    return counted_aligned_alloc(size, alignment);
  };
  desc.free = [](void*, void* block, std::uint64_t, std::uint64_t) { counted_free(block); };
  return desc;
}

std::size_t carom_live_bytes() { return live_bytes; }

PeerEngine load_engine(const char* path) {
  const auto failed = [&] { return tools::Error(dlerror(), "build the target that makes " + std::string(path)); };
  void* const object = dlmopen(LM_ID_NEWLM, path, RTLD_NOW | RTLD_LOCAL);
  if (!object) throw failed();
  const auto module = reinterpret_cast<PeerModule>(dlsym(object, "carom_bench_engine"));
  if (!module) throw failed();
  return module();
}

}  // namespace carom::bench

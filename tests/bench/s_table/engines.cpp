// Carom as one of the engines, and the loader of the others.
#include "engines.h"

#include <dlfcn.h>

#include <algorithm>

#include "counted_memory.h"

namespace carom::bench {

CaromWorld::CaromWorld(tools::Engine& engine, const SceneChoice& choice, const std::vector<std::string>& dials)
    : stage_(engine) {
  tools::build(find_scene(choice.scene), choice.settings, stage_);
  for (const std::string& dial : dials) stage_.world.set_dial(dial);
}

void CaromWorld::read(BodyState* states) const {
  std::vector<double> poses, velocities;
  stage_.read(CAROM_FIELD_POSE, poses);
  stage_.read(CAROM_FIELD_VELOCITY, velocities);
  for (std::size_t i = 0; i < stage_.actors.size(); ++i) {
    std::copy_n(&poses[7 * i], 3, states[i].position);
    std::copy_n(&poses[7 * i + 3], 4, states[i].orientation);
    std::copy_n(&velocities[6 * i], 3, states[i].velocity);
    std::copy_n(&velocities[6 * i + 3], 3, states[i].omega);
  }
}

void CaromWorld::cast_rays(const double* ends, std::size_t n, double* fractions, std::uint32_t flags) {
  std::vector<double> ways(3 * n);
  std::vector<std::uint32_t> outcomes(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k) ways[3 * i + k] = ends[6 * i + 3 + k] - ends[6 * i + k];
  carom_rays rays{};
  rays.struct_size = sizeof rays;
  rays.scalar = CAROM_SCALAR_F64;
  rays.count = n;
  rays.origins = ends;
  rays.origin_stride = 6 * sizeof(double);
  rays.directions = ways.data();
  carom_world_hits hits{};
  hits.struct_size = sizeof hits;
  hits.scalar = CAROM_SCALAR_F64;
  hits.outcomes = outcomes.data();
  hits.times = fractions;
  carom_query_desc desc;
  tools::Call call;
  call.done(carom_query_desc_init(&desc, sizeof desc), "describing a query");
  desc.flags = flags;
  call.done(carom_world_cast_rays(stage_.world.get(), &rays, CAROM_WANT_FIRST, &desc, &hits, call), "casting rays");
  for (std::size_t i = 0; i < n; ++i)
    if (outcomes[i] == CAROM_CAST_MISS) fractions[i] = 2;
}

carom_engine_desc counted_engine() {
  carom_engine_desc desc;
  tools::Call call;
  call.done(carom_engine_desc_init(&desc, sizeof desc), "describing an engine");
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

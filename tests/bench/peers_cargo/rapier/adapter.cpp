// PeerWorld over functions that are written in Rust.
#include <type_traits>

#include "peer.h"

using namespace carom::bench;

extern "C" {
void* carom_rust_make(const WorldPlan* plan);
void carom_rust_free(void* world);
void carom_rust_step(void* world, double dt);
void carom_rust_push(void* world, std::size_t body, const double* force);
void carom_rust_read(const void* world, BodyState* states);
std::size_t carom_rust_contact_points(const void* world);
void carom_rust_cast_rays(void* world, const double* ends, std::size_t n, double* fractions);
std::size_t carom_rust_live_bytes();
const char* carom_rust_name();
std::size_t carom_rust_threads();
}

namespace {

// What plan/src/lib.rs takes for granted.
static_assert(sizeof(Solid) == 4 && sizeof(BodyState) == 13 * 8);
static_assert(std::is_standard_layout_v<BodyPlan> && offsetof(BodyPlan, is_static) == 40 && sizeof(BodyPlan) == 224);
static_assert(std::is_standard_layout_v<JointPlan> && sizeof(JointKind) == 4 && sizeof(JointPlan) == 176);
static_assert(std::is_standard_layout_v<WorldPlan> && offsetof(WorldPlan, gravity) == 32 &&
              offsetof(WorldPlan, sleeping) == 72 && offsetof(WorldPlan, threads) == 80);

class RustWorld final : public PeerWorld {
 public:
  explicit RustWorld(const WorldPlan& plan) : world_(carom_rust_make(&plan)) {}
  ~RustWorld() override { carom_rust_free(world_); }
  void step(double dt) override { carom_rust_step(world_, dt); }
  void push(std::size_t body, const double* force) override { carom_rust_push(world_, body, force); }
  void read(BodyState* states) const override { carom_rust_read(world_, states); }
  std::size_t contact_points() const override { return carom_rust_contact_points(world_); }
  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    carom_rust_cast_rays(world_, ends, n, fractions);
    return true;
  }

 private:
  void* world_;
};

}  // namespace

extern "C" PeerEngine carom_peer_engine() {
  return {carom_rust_name(), [](const WorldPlan& plan) -> PeerWorld* { return new RustWorld(plan); },
          carom_rust_live_bytes, carom_rust_threads()};
}

// Accuracy: asked for, and what came of it.
#include "dynamics/accuracy/accuracy.h"

#include <carom/accuracy.h>

#include "abi/copy_out.h"
#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/world.h"
#include "dynamics/accuracy/growth.h"

namespace carom::abi {
namespace {

static_assert(AccuracyView::kEstimated == CAROM_ISLAND_ESTIMATED && AccuracyView::kHitBound == CAROM_ISLAND_BOUND &&
              AccuracyView::kByJointsAlone == CAROM_ISLAND_JOINTS_ALONE &&
              AccuracyView::kStalled == CAROM_ISLAND_STALLED);

const DialRow& row_of(Dial dial) { return dial_table()[static_cast<std::size_t>(dial)]; }

bool read_accuracy(Call& call, const carom_accuracy* given, carom_accuracy& a) {
  carom_accuracy_init(&a, sizeof a);
  const DialRow &place = row_of(Dial::accuracy_place), &turn = row_of(Dial::accuracy_turn),
                &most = row_of(Dial::accuracy_substeps);
  if (!read_struct(call, 2, "accuracy", given, a) ||
      !in_range(call, 2, "accuracy->substeps", a.substeps, most.min, most.max) ||
      !in_range(call, 2, "accuracy->place", a.place, place.min, place.max) ||
      !in_range(call, 2, "accuracy->turn", a.turn, turn.min, turn.max))
    return false;
  if (a.place > 0 || a.turn > 0) return true;
  call.fail(CAROM_E_OUT_OF_RANGE, 2,
            "accuracy->place and accuracy->turn are both 0: give one a tolerance, or pass NULL to ask for none");
  return false;
}

carom_island island(const World& world, const AccuracyView& view) {
  const Dials& dials = world.scene.dials;
  carom_island i{};
  i.body = world.scene.bodies.alive(view.body) ? world.scene.bodies.handle(view.body) : CAROM_NULL_HANDLE;
  i.bodies = view.bodies, i.substeps = view.substeps, i.order = view.order, i.flags = view.flags;
  i.work = view.work;
  i.place = view.place * dials[Dial::accuracy_place], i.turn = view.turn * dials[Dial::accuracy_turn];
  i.share = view.share();
  return i;
}

constexpr std::uint32_t kMostGrowthSteps = 1000000;

/// A copy of a world, for as long as it is looked at.
class Copy {
 public:
  Copy(Call& call, const Reading& world) : world_(fork_world(call, world)) {}
  ~Copy() {
    if (world_) destroy_world(world_);
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  explicit operator bool() const { return world_; }
  World& operator*() const { return *world_->inner; }

 private:
  carom_world* world_;
};

bool measure_growth(Call& call, const Reading& world, double dt, std::uint32_t steps, carom_growth& told) {
  const Copy one(call, world), other(call, world);
  if (!one || !other) return false;
  const FloatScope scope;
  const accuracy::Growth growth = accuracy::measure_growth(*one, *other, dt, steps);
  told.body = growth.body == kInvalid ? CAROM_NULL_HANDLE : world->scene.bodies.handle(growth.body);
  told.steps = growth.steps, told.sensitive = growth.is_sensitive;
  told.factor = growth.factor, told.rate = growth.rate;
  return true;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_accuracy_init(carom_accuracy* accuracy, uint32_t struct_size) {
  return init_struct(accuracy, struct_size, [](carom_accuracy& a) {
    a.substeps = static_cast<uint32_t>(row_of(Dial::accuracy_substeps).initial);
    a.place = a.turn = 1e-3;
  });
}

int32_t carom_world_set_accuracy(carom_world* world, const carom_accuracy* accuracy, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_accuracy(accuracy));
    if (!changing) return;
    const FloatScope scope;
    carom_accuracy a{};
    if (accuracy && !read_accuracy(call, accuracy, a)) return;
    changing->set_dial(Dial::accuracy_place, a.place);
    changing->set_dial(Dial::accuracy_turn, a.turn);
    changing->set_dial(Dial::accuracy_substeps, accuracy ? a.substeps : row_of(Dial::accuracy_substeps).initial);
  });
}

int32_t carom_world_get_accuracy(carom_world* world, carom_accuracy* accuracy, uint32_t* there, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !fillable(call, 2, "accuracy", accuracy) || !present(call, 3, "present", there)) return;
    const Dials& dials = reading->scene.dials;
    *there = accuracy::is_on(dials);
    carom_accuracy full;
    carom_accuracy_init(&full, sizeof full);
    if (*there) {
      full.substeps = static_cast<uint32_t>(dials.whole(Dial::accuracy_substeps));
      full.place = dials[Dial::accuracy_place], full.turn = dials[Dial::accuracy_turn];
    }
    write_struct(full, accuracy);
  });
}

int32_t carom_world_get_islands(carom_world* world, carom_island* dst, uint64_t stride, uint64_t capacity,
                                uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const World& w = *reading;
    copy_elements<carom_island>(
        call, w.accuracy ? w.accuracy->views.size() : 0,
        [&](std::uint64_t i) { return island(w, w.accuracy->views[i]); }, dst, stride, capacity, count);
  });
}

int32_t carom_world_measure_growth(carom_world* world, double dt, uint32_t steps, carom_growth* growth,
                                   carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !is_step(call, 2, dt) || !in_range(call, 3, "steps", steps, 1, kMostGrowthSteps) ||
        !fillable(call, 4, "growth", growth))
      return;
    carom_growth full{};
    if (measure_growth(call, reading, dt, steps, full)) write_struct(full, growth);
  });
}

}  // extern "C"

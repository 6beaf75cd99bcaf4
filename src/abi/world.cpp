// The world root: making, destroying, stepping, its dials and gravity.
#include "abi/world.h"

#include <algorithm>
#include <cmath>

#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/tags.h"
#include "dynamics/presets.h"

namespace carom::abi {
namespace {

constexpr double kLargestGravity = 1e6;  // m/s^2

bool check_gravity(Call& call, int argument, const double gravity[3]) {
  return present(call, argument, "gravity", gravity) &&
         in_range(call, argument, "gravity[0]", gravity[0], -kLargestGravity, kLargestGravity) &&
         in_range(call, argument, "gravity[1]", gravity[1], -kLargestGravity, kLargestGravity) &&
         in_range(call, argument, "gravity[2]", gravity[2], -kLargestGravity, kLargestGravity);
}

void create(Call& call, carom_engine* engine, const carom_world_desc* given, carom_world** world) {
  carom_world_desc desc;
  carom_world_desc_init(&desc, sizeof desc);
  if (!present(call, 1, "engine", engine) || (given && !read_struct(call, 2, "desc", given, desc)) ||
      !only_bits(call, 2, "desc->reserved", desc.reserved, 0) || !check_gravity(call, 2, desc.gravity) ||
      !present(call, 3, "world", world))
    return;
  if (desc.body_capacity > kMaxSlots) {
    call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->body_capacity is %llu, a world holds %u bodies",
              static_cast<unsigned long long>(desc.body_capacity), kMaxSlots);
    return;
  }
  if (carom_world* const made = make_world(call, *engine, to_vec3(desc.gravity), desc.body_capacity)) *world = made;
}

/// A record has it as a dial that the host set: a replay does not measure time.
void set_substeps(const Changing& changing, const Budget& budget) {
  const auto now = static_cast<std::uint32_t>(changing->scene.dials[Dial::substeps]);
  const std::uint32_t chosen = budget.choose(now);
  if (chosen == now) return;
  if (Recorder* const recorder = changing.recorder())
    recorder->call(record::world_set_dial(CAROM_DIAL_SUBSTEPS, chosen));
  changing->set_dial(Dial::substeps, chosen);
}

void learn_costs(const World& world, Budget& budget) {
  const StepReport& report = world.report;
  double in_substeps = 0;
  for (const Stage stage : {Stage::integrate, Stage::solve, Stage::relax})
    in_substeps += report.stage_seconds[static_cast<std::size_t>(stage)];
  budget.learn(report.total_seconds, in_substeps, static_cast<std::uint32_t>(world.scene.dials[Dial::substeps]));
}

/// Faults are rare and each shape's comes once, so the log may have every one.
void log_faults(const carom_world& world) {
  for (const FaultView& fault : world.inner->fault_views)
    if (fault.particles != kInvalid)
      world.engine.log_message(CAROM_LOG_WARNING,
                               "particles of set slot %u left the world, number %u first: in quarantine",
                               fault.particles, fault.particle);
    else if (fault.support.kind == SupportFault::none)
      world.engine.log_message(CAROM_LOG_WARNING, "the state of body slot %u was not finite: body in quarantine",
                               fault.body);
    else
      world.engine.log_message(
          CAROM_LOG_WARNING, "support fault %u at dir (%g, %g, %g), point (%g, %g, %g): shape 0x%016llx in quarantine",
          static_cast<unsigned>(fault.support.kind), fault.support.dir[0], fault.support.dir[1], fault.support.dir[2],
          fault.support.out[0], fault.support.out[1], fault.support.out[2],
          static_cast<unsigned long long>(fault.support.shape->handle));
}

/// A step is told before it is taken: should it never end, the record says in which.
void step(const Changing& changing, double dt) {
  Recorder* const recorder = changing.recorder();
  if (recorder) recorder->call(record::world_step(dt));
  const FloatScope scope;
  try {
    changing->step(dt);
  } catch (const std::bad_alloc&) {
    if (recorder) recorder->broke_off(*changing);
    throw;
  } catch (...) {  // a callback ended the thread or threw, anywhere
    changing->abandon_step();
    if (recorder) recorder->broke_off(*changing);
    throw;
  }
  if (recorder) recorder->stepped(*changing);
}

bool check_dial(Call& call, std::uint32_t dial, double value) {
  if (!known(call, 2, "dial", dial, kDialCount)) return false;
  const DialRow& row = dial_table()[dial];
  if (!in_range(call, 3, row.name, value, row.min, row.max))
    return call.advise("pass a number within the bounds of the dial; carom_dial_get_info() gives them");
  return row.kind == DialRow::number || value == std::floor(value) ||
         call.fail(CAROM_E_OUT_OF_RANGE, 3, "%s is %.17g, must be a whole number", row.name, value);
}

/// Severity, the paper's solver, knows no joints and no locks.
bool knows_all(Call& call, const World& world, std::uint32_t dial, double value) {
  if (dial != CAROM_DIAL_SOLVER || value != CAROM_SOLVER_SEVERITY) return true;
  const auto locked = std::ranges::count_if(world.scene.locks, [](Locks locks) { return locks != 0; });
  if (locked > 0)
    return call.fail(CAROM_E_UNSUPPORTED, 3,
                     "solver severity knows no locks, and this world has %lld locked bodies; free them first",
                     static_cast<long long>(locked));
  if (world.joints.slots.alive_count() == 0) return true;
  return call.fail(CAROM_E_UNSUPPORTED, 3, "solver severity knows no joints, and this world has %u; destroy them first",
                   world.joints.slots.alive_count());
}

}  // namespace

carom_world* make_world(Call& call, carom_engine& engine, const Vec3& gravity, std::size_t body_capacity) {
  const std::uint32_t tag = take_tag();
  if (!tag) {
    call.fail(CAROM_E_LIMIT, 0, "65,535 engines and worlds are alive in this process");
    return nullptr;
  }
  {
    const std::lock_guard lock(engine.mutex);  // from here on the engine's jobs stay
    engine.worlds.fetch_add(1, std::memory_order_relaxed);
  }
  try {
    return make_on<carom_world>(&engine.memory, engine, tag, gravity, body_capacity);
  } catch (...) {
    release_tag(tag);
    engine.worlds.fetch_sub(1, std::memory_order_release);
    throw;
  }
}

void destroy_world(carom_world* world) {
  carom_engine& engine = world->engine;
  if (world->recorder) {
    try {
      world->recorder->end();
    } catch (const ThreadExit&) {
      world->gate.leave_alone();  // the host's function ended the thread: the world is as it was, and recorded no more
      throw;
    }
  }
  const Colliders& c = world->inner->scene.colliders;
  for (const std::uint32_t slot : c.live) unuse_shape(engine, *c.shape[slot]);
  const std::uint32_t tag = world->inner->scene.bodies.tag();
  destroy_on(&engine.memory, world);
  release_tag(tag);
  engine.worlds.fetch_sub(1, std::memory_order_release);  // last: the engine may be destroyed from now on
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_desc_init(carom_world_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_world_desc& d) { d.gravity[1] = -9.81; });
}

int32_t carom_world_create(carom_engine* engine, const carom_world_desc* desc, carom_world** world,
                           carom_error* error) {
  return guarded(error, [&](Call& call) { create(call, engine, desc, world); });
}

int32_t carom_world_destroy(carom_world* world, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "world", world)) return;
    if (!world->gate.enter_alone())  // never left: the world is gone
      call.fail(CAROM_E_BUSY, 1, "another thread is stepping, changing or reading this world");
    else
      destroy_world(world);
  });
}

int32_t carom_world_step(carom_world* world, double dt, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Changing changing(call, world);
    if (!changing || !is_step(call, 2, dt)) return;
    if (world->budget) set_substeps(changing, *world->budget);
    step(changing, dt);
    if (world->budget) learn_costs(*changing, *world->budget);
    log_faults(*world);
  });
}

int32_t carom_world_set_dial(carom_world* world, uint32_t dial, double value, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_dial(dial, value));
    if (changing && check_dial(call, dial, value) && knows_all(call, *changing, dial, value))
      changing->set_dial(static_cast<Dial>(dial), value);
  });
}

int32_t carom_world_get_dial(carom_world* world, uint32_t dial, double* value, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && known(call, 2, "dial", dial, kDialCount) && present(call, 3, "value", value))
      *value = reading->scene.dials[static_cast<Dial>(dial)];
  });
}

int32_t carom_world_set_preset(carom_world* world, uint32_t preset, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_preset(preset));
    if (!changing || !known(call, 2, "preset", preset, kPresetCount)) return;
    for (std::size_t dial = 0; dial < kDialCount; ++dial)  // none of them can be refused: no preset asks for severity
      if (const auto value = preset_value(static_cast<Preset>(preset), static_cast<Dial>(dial)))
        changing->set_dial(static_cast<Dial>(dial), *value);
  });
}

int32_t carom_world_set_gravity(carom_world* world, const double gravity[3], carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_gravity(gravity));
    if (changing && check_gravity(call, 2, gravity)) changing->set_gravity(to_vec3(gravity));
  });
}

int32_t carom_world_get_gravity(carom_world* world, double gravity[3], carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && present(call, 2, "gravity", gravity)) from_vec3(reading->scene.gravity, gravity);
  });
}

int32_t carom_world_hash(carom_world* world, uint64_t* hash, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && present(call, 2, "hash", hash)) *hash = reading->hash();
  });
}

}  // extern "C"

// What the last step did: stages, counts, residuals, contact points, faults.
#include "abi/copy_out.h"
#include "abi/world.h"
#include "dynamics/contact_views.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(Stage::refresh) == CAROM_STAGE_REFRESH &&
              static_cast<std::uint32_t>(Stage::broad) == CAROM_STAGE_BROAD &&
              static_cast<std::uint32_t>(Stage::narrow) == CAROM_STAGE_NARROW &&
              static_cast<std::uint32_t>(Stage::group) == CAROM_STAGE_GROUP &&
              static_cast<std::uint32_t>(Stage::integrate) == CAROM_STAGE_INTEGRATE &&
              static_cast<std::uint32_t>(Stage::solve) == CAROM_STAGE_SOLVE &&
              static_cast<std::uint32_t>(Stage::relax) == CAROM_STAGE_RELAX &&
              static_cast<std::uint32_t>(Stage::observe) == CAROM_STAGE_OBSERVE && kStageCount == CAROM_STAGE_COUNT);
static_assert(static_cast<std::uint32_t>(GroupReason::ordinary) == CAROM_REASON_ORDINARY &&
              static_cast<std::uint32_t>(GroupReason::mass_ratio) == CAROM_REASON_MASS_RATIO &&
              static_cast<std::uint32_t>(GroupReason::sink) == CAROM_REASON_SINK &&
              static_cast<std::uint32_t>(GroupReason::too_much) == CAROM_REASON_TOO_MUCH &&
              static_cast<std::uint32_t>(GroupReason::impact) == CAROM_REASON_IMPACT &&
              static_cast<std::uint32_t>(GroupReason::few) == CAROM_REASON_FEW);
static_assert(SupportFault::returned == CAROM_FAULT_RETURNED && SupportFault::not_finite == CAROM_FAULT_NOT_FINITE &&
              SupportFault::outside == CAROM_FAULT_OUTSIDE && SupportFault::not_support == CAROM_FAULT_NOT_SUPPORT);

void fill_report(const StepReport& from, carom_step_report& to) {
  to.stage_count = CAROM_STAGE_COUNT;
  for (std::size_t i = 0; i < kStageCount; ++i) to.stage_seconds[i] = from.stage_seconds[i];
  to.total_seconds = from.total_seconds;
  to.steps = from.steps;
  to.time = from.time;
  to.bodies = from.bodies;
  to.dynamic_bodies = from.dynamic_bodies;
  to.colliders = from.colliders;
  to.broad_pairs = from.broad_pairs;
  to.contact_pairs = from.contact_pairs;
  to.contact_points = from.contact_points;
  to.groups = from.groups;
  to.largest_group = from.largest_group;
  to.gjk_calls = from.narrow.gjk_calls;
  to.epa_calls = from.narrow.epa_calls;
  to.support_calls = from.narrow.support_calls;
  to.velocity_impulses = from.velocity_impulses;
  to.position_moves = from.position_moves;
  to.quarantined_bodies = from.quarantined_bodies;
  to.faults = from.faults;
  to.max_penetration = from.max_penetration;
  to.mean_penetration = from.mean_penetration;
  to.max_closing_speed = from.max_closing_speed;
  to.linear_energy = from.linear_energy;
  to.angular_energy = from.angular_energy;
  to.direct_groups = from.direct_groups;
  to.solver_residual = from.solver_residual;
  to.asleep_bodies = from.asleep_bodies;
  to.fell_asleep = from.fell_asleep;
  to.woke_up = from.woke_up;
  to.particles = from.particles;
  to.quarantined_particles = from.quarantined_particles;
  to.swept_bodies = from.swept_bodies;
  to.sweep_hits = from.sweep_hits;
  to.wedged_groups = from.wedged_groups;
  to.rejected_solutions = from.rejected_solutions;
  to.excess_energy = from.excess_energy;
}

carom_contact contact(const World& world, const ContactView& view) {
  const Scene& scene = world.scene;
  carom_contact c{};
  c.collider_a = scene.collider_slots.handle(view.collider_a);
  c.collider_b = scene.collider_slots.handle(view.collider_b);
  c.body_a = scene.bodies.handle(scene.colliders.body[view.collider_a]);
  c.body_b = scene.bodies.handle(scene.colliders.body[view.collider_b]);
  from_vec3(view.point, c.point);
  from_vec3(view.normal, c.normal);
  c.separation = view.separation;
  c.normal_impulse = view.normal_impulse;
  c.friction_impulse = view.friction_impulse;
  return c;
}

carom_group group(const World& world, const GroupView& view) {
  carom_group g{};
  g.body = world.scene.bodies.alive(view.body) ? world.scene.bodies.handle(view.body) : CAROM_NULL_HANDLE;
  g.bodies = view.bodies, g.points = view.points;
  g.solver = view.direct ? CAROM_SOLVER_DIRECT : CAROM_SOLVER_SOFT_STEP;
  g.reason = static_cast<std::uint32_t>(view.reason);
  g.mass_ratio = view.mass_ratio, g.sink = view.sink;
  return g;
}

}  // namespace

carom_fault fault_of(const World& world, const FaultView& view) {
  carom_fault f{};
  if (view.support.kind != SupportFault::none)
    f.kind = static_cast<std::uint32_t>(view.support.kind);
  else
    f.kind = view.particles == kInvalid ? CAROM_FAULT_BODY_STATE : CAROM_FAULT_PARTICLE_STATE;
  f.shape = view.support.shape ? view.support.shape->handle : CAROM_NULL_HANDLE;
  if (view.body != kInvalid) f.body = world.scene.bodies.handle(view.body);
  if (view.particles != kInvalid) f.particles = world.particles.slots.handle(view.particles);
  f.particle = view.particle;
  for (int i = 0; i < 3; ++i) f.dir[i] = view.support.dir[i], f.out[i] = view.support.out[i];
  return f;
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_get_report(carom_world* world, carom_step_report* report, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !fillable(call, 2, "report", report)) return;
    carom_step_report full{};
    fill_report(reading->report, full);
    write_struct(full, report);
  });
}

const char* carom_stage_name(uint32_t stage) {
  return stage < CAROM_STAGE_COUNT ? stage_name(static_cast<Stage>(stage)) : "?";
}

int32_t carom_world_get_contacts(carom_world* world, carom_contact* dst, uint64_t stride, uint64_t capacity,
                                 uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->contact_views(), contact, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_groups(carom_world* world, carom_group* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->group_views, group, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_faults(carom_world* world, carom_fault* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->fault_views, fault_of, dst, stride, capacity, count);
  });
}

}  // extern "C"

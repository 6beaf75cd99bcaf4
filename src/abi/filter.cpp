// Which colliders may touch: filters, ignored pairs, sensors.
#include <carom/filter.h>

#include "abi/record_calls.h"
#include "abi/world.h"

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_collider_set_filter(carom_world* world, carom_collider collider, uint64_t category, uint64_t mask,
                                  int32_t group, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_set_filter(collider, category, mask, group));
    if (!changing || !resolve(call, 2, "collider", changing->scene.collider_slots, collider)) return;
    changing->set_filter(handle_slot(collider), {category, mask, group});
  });
}

int32_t carom_collider_get_filter(carom_world* world, carom_collider collider, uint64_t* category, uint64_t* mask,
                                  int32_t* group, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve(call, 2, "collider", reading->scene.collider_slots, collider) ||
        !present(call, 3, "category", category) || !present(call, 4, "mask", mask) || !present(call, 5, "group", group))
      return;
    const Filter filter = reading->scene.colliders.filter_of(handle_slot(collider));
    *category = filter.category, *mask = filter.mask, *group = filter.group;
  });
}

int32_t carom_body_set_filter(carom_world* world, carom_body body, uint64_t category, uint64_t mask, int32_t group,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_filter(body, category, mask, group));
    if (!changing || !resolve(call, 2, "body", changing->scene.bodies, body)) return;
    changing->set_body_filter(handle_slot(body), {category, mask, group});
  });
}

int32_t carom_body_ignore_collision(carom_world* world, carom_body body_a, carom_body body_b, uint32_t ignored,
                                    carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_ignore_collision(body_a, body_b, ignored));
    if (!changing || !resolve(call, 2, "body_a", changing->scene.bodies, body_a) ||
        !resolve(call, 3, "body_b", changing->scene.bodies, body_b) || !in_range(call, 4, "ignored", ignored, 0, 1))
      return;
    if (body_a == body_b) {
      call.fail(CAROM_E_OUT_OF_RANGE, 3, "a body and itself: it never touches itself");
      return;
    }
    if (ignored)
      changing->ignore_collision(handle_slot(body_a), handle_slot(body_b));
    else
      changing->restore_collision(handle_slot(body_a), handle_slot(body_b));
  });
}

int32_t carom_collider_set_sensor(carom_world* world, carom_collider collider, uint32_t sensor, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_set_sensor(collider, sensor));
    if (changing && resolve(call, 2, "collider", changing->scene.collider_slots, collider) &&
        in_range(call, 3, "sensor", sensor, 0, 1))
      changing->set_sensor(handle_slot(collider), sensor != 0);
  });
}

int32_t carom_collider_is_sensor(carom_world* world, carom_collider collider, uint32_t* sensor, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve(call, 2, "collider", reading->scene.collider_slots, collider) &&
        present(call, 3, "sensor", sensor))
      *sensor = reading->scene.colliders.is_sensor(handle_slot(collider));
  });
}

}  // extern "C"

// Attributes of bodies: any of them by its number, those that have calls of their own, and what each is.
#include <carom/force.h>

#include "abi/body.h"
#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

static_assert(kMostNumbers == CAROM_ATTRIBUTE_NUMBERS && kAttributeCount == CAROM_ATTRIBUTE_COUNT);

/// What the attribute asks of the world and of the body, whatever its value, unless that is the usual one.
bool can_have(Call& call, const World& world, BodyType type, const AttributeRow& row, int argument) {
  if (row.of_dynamic && type != BodyType::dynamic)
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "%s are of dynamic bodies only; others move as their velocity says",
                     row.name);
  return row.id != AttributeId::locks || world.scene.dials.choice(Dial::solver) != CAROM_SOLVER_SEVERITY ||
         call.fail(CAROM_E_UNSUPPORTED, argument,
                   "solver severity knows no locks; set CAROM_DIAL_SOLVER to another before locking bodies");
}

/// @param names  of the numbers, as the caller knows them   @param first  argument, of the first number
bool is_value_of(Call& call, const AttributeRow& row, const AttributeValue& value, const char* const* names, int first,
                 bool one_argument) {
  using enum AttributeFault::Kind;
  const AttributeFault fault = fault_of(row, value);
  const std::uint32_t k = fault.number;
  const int argument = one_argument ? first : first + static_cast<int>(k);
  const char* const name = names[k];
  switch (fault.kind) {
    case none:
      return true;
    case not_finite:
      return call.fail(CAROM_E_NOT_FINITE, argument, "%s is %g", name, value[k]);
    case out_of_range:
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is %g, must be within [%g, %g] %s", name, value[k], row.min,
                       row.max, row.unit);
    case not_whole:
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is %g, must be a whole number", name, value[k]);
    case surplus:
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is %g, must be 0: %s has %u numbers", name, value[k],
                       row.name, row.numbers);
  }
  return false;
}

void set_attribute(Call& call, World& world, carom_body body, AttributeId id, const AttributeValue& value,
                   const char* const* names, int first, bool one_argument = false) {
  const AttributeRow& row = row_of(id);
  if (!resolve_body(call, world, body) || !is_value_of(call, row, value, names, first, one_argument)) return;
  if (value != row.usual && !can_have(call, world, world.scene.type[handle_slot(body)], row, first)) return;
  const FloatScope scope;
  world.set_attribute(handle_slot(body), id, value);
}

}  // namespace

bool may_have(Call& call, const World& world, BodyType type, AttributeId id, const AttributeValue& value,
              const char* const* names) {
  const AttributeRow& row = row_of(id);
  return is_value_of(call, row, value, names, 2, true) && (value == row.usual || can_have(call, world, type, row, 2));
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_attribute_get_info(uint32_t attribute, carom_attribute_info* info, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!known(call, 1, "attribute", attribute, CAROM_ATTRIBUTE_COUNT) || !fillable(call, 2, "info", info)) return;
    const AttributeRow& row = kAttributeTable[attribute];
    carom_attribute_info full{};
    full.attribute = attribute;
    full.numbers = row.numbers;
    full.is_whole = row.stored != StoredAs::real;
    full.name = row.name, full.unit = row.unit, full.summary = row.what;
    full.min = row.min, full.max = row.max;
    std::copy(row.usual.begin(), row.usual.end(), full.usual);
    full.effect = static_cast<std::uint32_t>(+row.effect);
    full.of_dynamic = row.of_dynamic;
    write_struct(full, info);
  });
}

int32_t carom_body_set_attribute(carom_world* world, carom_body body, uint32_t attribute, const double value[4],
                                 carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_attribute(body, attribute, value));
    if (!changing || !resolve_body(call, *changing, body) ||
        !known(call, 3, "attribute", attribute, CAROM_ATTRIBUTE_COUNT) || !present(call, 4, "value", value))
      return;
    static constexpr const char* kNames[] = {"value[0]", "value[1]", "value[2]", "value[3]"};
    set_attribute(call, *changing, body, static_cast<AttributeId>(attribute), {value[0], value[1], value[2], value[3]},
                  kNames, 4, true);
  });
}

int32_t carom_body_get_attribute(carom_world* world, carom_body body, uint32_t attribute, double value[4],
                                 carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body) ||
        !known(call, 3, "attribute", attribute, CAROM_ATTRIBUTE_COUNT) || !present(call, 4, "value", value))
      return;
    const AttributeValue now = reading->scene.attributes.of(static_cast<AttributeId>(attribute), handle_slot(body));
    std::copy(now.begin(), now.end(), value);
  });
}

int32_t carom_body_set_gravity_factor(carom_world* world, carom_body body, double factor, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_gravity_factor(body, factor));
    static constexpr const char* kName[] = {"factor"};
    if (changing) set_attribute(call, *changing, body, AttributeId::gravity_factor, {factor}, kName, 3);
  });
}

int32_t carom_body_get_gravity_factor(carom_world* world, carom_body body, double* factor, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "factor", factor))
      *factor = reading->scene.gravity_factor_of(handle_slot(body));
  });
}

int32_t carom_body_set_locks(carom_world* world, carom_body body, uint32_t locks, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_locks(body, locks));
    static constexpr const char* kName[] = {"locks"};
    if (changing && resolve_body(call, *changing, body) && only_bits(call, 3, "locks", locks, CAROM_LOCK_ALL))
      set_attribute(call, *changing, body, AttributeId::locks, {Real(locks)}, kName, 3);
  });
}

int32_t carom_body_get_locks(carom_world* world, carom_body body, uint32_t* locks, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "locks", locks))
      *locks = reading->scene.locks_of(handle_slot(body));
  });
}

int32_t carom_body_set_drag(carom_world* world, carom_body body, double linear, double quadratic, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_drag(body, linear, quadratic));
    static constexpr const char* kNames[] = {"linear", "quadratic"};
    if (changing) set_attribute(call, *changing, body, AttributeId::drag, {linear, quadratic}, kNames, 3);
  });
}

int32_t carom_body_get_drag(carom_world* world, carom_body body, double* linear, double* quadratic,
                            carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body) || !present(call, 3, "linear", linear) ||
        !present(call, 4, "quadratic", quadratic))
      return;
    const Drag drag = reading->scene.drag_of(handle_slot(body));
    *linear = drag.linear, *quadratic = drag.quadratic;
  });
}

int32_t carom_body_set_force_field_mask(carom_world* world, carom_body body, uint32_t mask, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_force_field_mask(body, mask));
    static constexpr const char* kName[] = {"mask"};
    if (changing) set_attribute(call, *changing, body, AttributeId::force_field_mask, {Real(mask)}, kName, 3);
  });
}

int32_t carom_body_get_force_field_mask(carom_world* world, carom_body body, uint32_t* mask, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "mask", mask))
      *mask = reading->scene.field_mask_of(handle_slot(body));
  });
}

}  // extern "C"

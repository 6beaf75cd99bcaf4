// Declarations of plugins, read and asked about.
#include "abi/forms.h"

#include <carom/plugin.h>

#include "core/float_scope.h"
#include "collision/verify.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(Form::sphere) == CAROM_FORM_SPHERE &&
              static_cast<std::uint32_t>(Form::capsule) == CAROM_FORM_CAPSULE &&
              static_cast<std::uint32_t>(Form::box) == CAROM_FORM_BOX &&
              static_cast<std::uint32_t>(Form::polytope) == CAROM_FORM_POLYTOPE &&
              static_cast<std::uint32_t>(Form::cylinder) == CAROM_FORM_CYLINDER &&
              static_cast<std::uint32_t>(Form::cone) == CAROM_FORM_CONE &&
              static_cast<std::uint32_t>(Form::ellipsoid) == CAROM_FORM_ELLIPSOID);

constexpr std::uint32_t kFormCount = CAROM_FORM_ELLIPSOID + 1;
constexpr int kFormArgs[kFormCount] = {0, 1, 2, 3, 1, 2, 2, 3};  // indices that each form uses

}  // namespace

bool form_args_exist(Call& call, const char* id, const char* what, std::uint32_t form, const std::uint32_t arg[4],
                     std::uint32_t count) {
  if (form >= kFormCount)
    return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: %s form %u is unknown to this library", id, what, form);
  for (int i = 0; i < kFormArgs[form]; ++i)
    if (arg[i] >= count)
      return call.fail(CAROM_E_PLUGIN_ABI, 2, "%s: %s_arg[%d] is %u of %u parameters", id, what, i, arg[i], count);
  return true;
}

bool read_form(Call& call, const char* id, std::uint32_t form, const std::uint32_t arg[4],
               std::span<const double> params, FormNumbers& numbers) {
  numbers.form = static_cast<Form>(form);
  if (numbers.form == Form::polytope) {
    numbers.vertices = params.subspan(arg[0]);
    return (!numbers.vertices.empty() && numbers.vertices.size() % 3 == 0) ||
           call.fail(CAROM_E_DECLARATION_FALSE, 2, "%s: a polytope of %zu coordinates, not x, y, z triples", id,
                     numbers.vertices.size());
  }
  Real value[3] = {0, 0, 0};
  for (int i = 0; i < kFormArgs[form]; ++i) {
    value[i] = params[arg[i]];
    if (value[i] < 0)
      return call.fail(CAROM_E_DECLARATION_FALSE, 2, "%s: parameter %u is declared a size, but is %g", id, arg[i],
                       value[i]);
  }
  if (numbers.form == Form::box || numbers.form == Form::ellipsoid) {
    numbers.half = Vec3(value[0], value[1], value[2]);
  } else {
    numbers.radius = value[0];
    numbers.half_height = value[1];
  }
  return true;
}

bool ask_valid(Call& call, const char* id, int argument, const Shape& shape) {
  const FloatScope scope;
  const Verdict verdict = verify_support(shape);
  if (verdict.valid && float_environment_is_default()) return true;
  call.witness(verdict.dir, verdict.out);
  return call.fail(CAROM_E_PLUGIN_INVALID, argument, "%s: %s; dir (%g, %g, %g) gave (%g, %g, %g)", id,
                   verdict.valid ? "the support function changes the floating-point environment" : verdict.reason,
                   verdict.dir[0], verdict.dir[1], verdict.dir[2], verdict.out[0], verdict.out[1], verdict.out[2]);
}

}  // namespace carom::abi

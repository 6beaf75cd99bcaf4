// Shapes: parameters checked against the plugin's bounds, the support function against convexity, declarations against
// the support function; bounds and mass derived. All before the shape exists; once made it never changes.
#include <carom/shape.h>

#include <cmath>

#include "abi/engine.h"
#include "abi/forms.h"
#include "abi/shape_draft.h"
#include "collision/hull_of.h"
#include "collision/verify.h"
#include "collision/volume.h"
#include "core/float_scope.h"

namespace carom::abi {
namespace {

constexpr Real kMassTolerance = 1e-3;  // relative width of the volume bracket at which deriving stops: 0.1 % of mass is
                                       // less than densities are known to; finer costs supports in proportion (1/N)
constexpr Real kSmallestSize = 5e-5;   // m, half across: contacts hold from there on, see tests/abi/test_sizes
constexpr int kMassSupports = 2000;    // and at most so many: about a millisecond

constexpr const char* kHullOf = "a hull of shapes";  // in messages

bool check_params(Call& call, const PluginRecord& plugin, const double* params, std::uint64_t count) {
  const carom_shape_plugin& d = plugin.description;
  const std::uint64_t named = d.param_count, group = d.param_tail_group;
  const std::uint64_t least = group ? named - group + group * std::max(d.param_tail_min, 1u) : named;
  if (group ? count < least || (count - least) % group : count != named)
    return call.fail(CAROM_E_OUT_OF_RANGE, 4, "count is %llu; %s takes %llu parameters%s",
                     static_cast<unsigned long long>(count), plugin.id.c_str(), static_cast<unsigned long long>(least),
                     group ? " or more, in whole groups" : "");
  if (count && !present(call, 3, "params", params)) return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    const carom_param& bound = plugin.bounds[i < named ? i : named - group + (i - named) % group];
    if (std::isfinite(params[i]) && params[i] >= bound.min && params[i] <= bound.max) continue;
    return call.fail(std::isfinite(params[i]) ? CAROM_E_OUT_OF_RANGE : CAROM_E_NOT_FINITE, 3,
                     "params[%llu] (%s of %s) is %.17g, outside [%g, %g]", static_cast<unsigned long long>(i),
                     bound.name, plugin.id.c_str(), params[i], bound.min, bound.max);
  }
  const carom_param_rule* const rule = broken_rule(plugin, params);
  return !rule || call.fail(CAROM_E_OUT_OF_RANGE, 3, "params of %s break its rule: %s", plugin.id.c_str(), rule->text);
}

bool invalid(Call& call, const char* id, const SupportFault& fault) {
  call.witness(fault.dir, fault.out);
  return call.fail(CAROM_E_PLUGIN_INVALID, 2, "%s: support failed (fault %u) at dir (%g, %g, %g)", id,
                   static_cast<unsigned>(fault.kind), fault.dir[0], fault.dir[1], fault.dir[2]);
}

bool declaration_false(Call& call, const char* id, const char* what, const Verdict& verdict) {
  call.witness(verdict.dir, verdict.out);
  return call.fail(CAROM_E_DECLARATION_FALSE, 2, "%s: declared %s is not so: %s; dir (%g, %g, %g) gave (%g, %g, %g)",
                   id, what, verdict.reason, verdict.dir[0], verdict.dir[1], verdict.dir[2], verdict.out[0],
                   verdict.out[1], verdict.out[2]);
}

/// The declared form, if any, is what the support function says.
bool settle_form(Call& call, const PluginRecord& plugin, Shape& shape) {
  const char* id = plugin.id.c_str();
  const carom_geometry& g = plugin.geometry;
  FormNumbers form;
  if (!read_form(call, id, g.form, g.form_arg, shape.params, form)) return false;
  shape.form = form.form;
  shape.radius = form.radius;
  shape.half_height = form.half_height;
  shape.half = form.half;
  shape.vertices = form.vertices;
  if (form.form == Form::none) return true;
  const Verdict verdict = verify_form(shape, form.form);
  if (!verdict.valid) return declaration_false(call, id, "form", verdict);
  make_faces(shape);
  return true;
}

/// Mass properties from the verified form, else from support alone.
bool derive_mass(Call& call, const char* id, Memory* memory, Shape& shape) {
  if (shape.form != Form::none) {
    shape.mass = mass_from_form(shape.form, shape.radius, shape.half_height, shape.half, shape.vertices, memory);
    return true;
  }
  SupportFault fault;
  shape.mass = mass_from_support(shape, kMassTolerance, kMassSupports, fault);
  return fault.kind == SupportFault::none || invalid(call, id, fault);
}

/// Those of a declaration of mass, verified, or derived.
bool settle_mass(Call& call, const PluginRecord& plugin, Memory* memory, Shape& shape) {
  const char* id = plugin.id.c_str();
  const carom_geometry& g = plugin.geometry;
  if (g.mass_form == CAROM_FORM_NONE) return derive_mass(call, id, memory, shape);
  FormNumbers m;
  if (!read_form(call, id, g.mass_form, g.mass_arg, shape.params, m)) return false;
  shape.mass = mass_from_form(m.form, m.radius, m.half_height, m.half, m.vertices, memory);
  const Verdict verdict = verify_mass(shape, shape.mass);
  return verdict.valid || declaration_false(call, id, "mass", verdict);
}

/// What the narrow phase looks up, and bounds: those of the form are exact.
bool derive_reach(Call& call, const char* id, Shape& shape) {
  if (shape.form == Form::polytope) shape.farthest.build(shape.vertices);
  SupportFault fault;
  return derive_bounds(shape, fault) || invalid(call, id, fault);
}

/// Everything that is known of a shape, each claim checked.
bool settle(Call& call, const PluginRecord& plugin, const double* params, std::uint64_t count, Memory* memory,
            Shape& shape) {
  const FloatScope scope;
  const char* id = plugin.id.c_str();
  shape.params.assign(params, params + count);
  shape.support = plugin.description.support, shape.user = plugin.description.user;
  shape.host_thread = plugin.description.flags & CAROM_PLUGIN_HOST_THREAD;
  if (plugin.geometry.core_radius_param != CAROM_NO_PARAM) {
    shape.core_radius = shape.params[plugin.geometry.core_radius_param];
    if (shape.core_radius < 0)
      return call.fail(CAROM_E_DECLARATION_FALSE, 2, "%s: parameter %u is declared the core radius, but is %g", id,
                       plugin.geometry.core_radius_param, shape.core_radius);
  }
  if (!ask_valid(call, id, 2, shape)) return false;
  if (!settle_form(call, plugin, shape) || !derive_reach(call, id, shape) || !settle_mass(call, plugin, memory, shape))
    return false;
  return float_environment_is_default() ||
         call.fail(CAROM_E_PLUGIN_INVALID, 2, "%s: the support function changes the floating-point environment", id);
}

void fill_info(const ShapeRecord& record, carom_shape_info& info) {
  const Shape& s = *record.shape;
  const bool half_space = s.form == Form::half_space, scenery = is_scenery(s);
  info.form = half_space || scenery ? CAROM_FORM_NONE : static_cast<std::uint32_t>(s.form);
  info.is_half_space = half_space;
  info.mass_exact = s.mass.exact;
  info.plugin = record.plugin_handle;
  info.param_count = s.params.size();
  info.core_radius = s.core_radius;
  info.bounding_radius = s.bounding_radius;
  from_vec3(s.bounds.lo, info.aabb_min);
  from_vec3(s.bounds.hi, info.aabb_max);
  info.volume = s.mass.volume;
  info.volume_min = s.mass.volume_min;
  info.volume_max = s.mass.volume_max;
  from_vec3(s.mass.centroid, info.centroid);
  info.centroid_error = s.mass.centroid_error;
  for (int i = 0; i < 9; ++i) info.inertia[i] = s.mass.inertia(i / 3, i % 3);
  info.inertia_error = s.mass.inertia_error;
  info.is_scenery = scenery;
}

/// Support point of the whole shape: the core's, and the core radius along the direction.
bool support(Call& call, const Shape& shape, const double* dir, double* out) {
  const Vec3 d = to_vec3(dir);
  const Real largest = d.abs().max_entry();  // scaled first: the square of 1e200 is not a number
  const std::int32_t result = shape.support(shape.user, shape.params.data(), shape.params.size(), dir, out);
  if (result != 0 || !carom::finite(to_vec3(out))) {
    call.witness(dir, out);
    return call.fail(CAROM_E_PLUGIN_INVALID, 2, "support returned %d with (%g, %g, %g)", result, out[0], out[1],
                     out[2]);
  }
  from_vec3(to_vec3(out) + shape.core_radius * (d / largest).normalized(), out);
  return true;
}

void supports(Call& call, const Shape& shape, const double* dirs, std::uint64_t n, double* points) {
  if (shape.form == Form::half_space) {
    call.fail(CAROM_E_UNSUPPORTED, 2, "a half-space is unbounded and has no support points");
    return;
  }
  for (std::uint64_t i = 0; i < n; ++i) {
    if (!finite(call, 3, "dirs", dirs + 3 * i, 3)) return;
    if (to_vec3(dirs + 3 * i).is_zero()) {
      call.fail(CAROM_E_OUT_OF_RANGE, 3, "direction %llu is zero", static_cast<unsigned long long>(i));
      return;
    }
  }
  const FloatScope scope;
  for (std::uint64_t i = 0; i < n; ++i)
    if (!support(call, shape, dirs + 3 * i, points + 3 * i)) return;
}

}  // namespace

PluginPin::~PluginPin() {
  if (!record_) return;
  const std::lock_guard lock(engine_.mutex);
  record_->uses -= 1;
}

bool PluginPin::take(Call& call, int argument, carom_plugin handle) {
  const std::lock_guard lock(engine_.mutex);
  if (!resolve(call, argument, "plugin", engine_.plugin_slots, handle)) return false;
  record_ = engine_.plugins[handle_slot(handle)];
  record_->uses += 1;
  return true;
}

bool draft_of_plugin(Call& call, const PluginRecord& plugin, const double* params, std::uint64_t count,
                     ShapeDraft& draft) {
  return check_params(call, plugin, params, count) && settle(call, plugin, params, count, draft.memory, *draft.shape);
}

bool draft_hull_of(Call& call, std::span<const Shape* const> parts, std::span<const double> numbers,
                   ShapeDraft& draft) {
  const FloatScope scope;
  Shape& shape = *draft.shape;
  make_hull_of(parts, numbers, draft.memory, shape);
  if (!ask_valid(call, kHullOf, 2, shape)) return false;
  make_faces(shape);
  return derive_reach(call, kHullOf, shape) && derive_mass(call, kHullOf, draft.memory, shape);
}

void draft_half_space(const Vec3& normal, double offset, ShapeDraft& draft) {
  Shape& s = *draft.shape;
  s.form = Form::half_space;
  s.normal = normal;
  s.offset = offset;
  s.bounding_radius = kInfinity;
  s.bounds.lo = Vec3::constant(-kInfinity);
  s.bounds.hi = Vec3::constant(kInfinity);
}

void remove_shape(carom_engine& engine, std::uint32_t slot) {
  ShapeRecord& record = engine.shapes[slot];
  if (record.plugin) record.plugin->uses -= 1;
  if (record.shape->hull_of)
    for (const HullOf::Part& part : record.shape->hull_of->parts)
      engine.shapes[handle_slot(part.shape->handle)].uses -= 1;
  destroy_on(&engine.memory, record.shape);
  record = {};
  engine.shape_slots.release(slot);
}

bool add_shape(Call& call, carom_engine& engine, ShapeDraft& draft, carom_shape* handle, PluginRecord* plugin,
               carom_plugin plugin_handle) {
  const std::lock_guard lock(engine.mutex);
  if (engine.shapes.size() == engine.shapes.capacity()) engine.shapes.reserve(2 * engine.shapes.size() + 8);
  const Handle h = engine.shape_slots.take();
  if (!h) return call.fail(CAROM_E_LIMIT, 0, "%u shapes are alive", kMaxSlots);
  if (handle_slot(h) == engine.shapes.size()) engine.shapes.emplace_back();
  draft.shape->handle = h;
  if (draft.shape->hull_of)  // which keeps its parts
    for (const HullOf::Part& part : draft.shape->hull_of->parts)
      engine.shapes[handle_slot(part.shape->handle)].uses += 1;
  engine.shapes[handle_slot(h)] = {draft.shape, plugin, plugin_handle, 0};
  draft.shape = nullptr;
  *handle = h;
  return true;
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_shape_create(carom_engine* engine, carom_plugin plugin, const double* params, uint64_t count,
                           carom_shape* shape, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 5, "shape", shape)) return;
    PluginPin pin(*engine);
    if (!pin.take(call, 2, plugin)) return;
    ShapeDraft draft(&engine->memory);
    if (!draft_of_plugin(call, *pin.get(), params, count, draft)) return;
    const Real across = (draft.shape->bounds.hi - draft.shape->bounds.lo).max_entry();
    if (!add_shape(call, *engine, draft, shape, pin.get(), plugin)) return;
    if (across < 2 * kSmallestSize)
      engine->log_message(
          CAROM_LOG_WARNING,
          "a shape of %s is %g m across: contacts of bodies smaller than %g m do not hold; scale the scene up",
          pin.get()->id.c_str(), across, 2 * kSmallestSize);
    pin.keep();
  });
}

int32_t carom_shape_create_half_space(carom_engine* engine, const double normal[3], double offset, carom_shape* shape,
                                      carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !unit(call, 2, "normal", normal, 3) ||
        !carom::abi::finite(call, 3, "offset", &offset, 1) || !present(call, 4, "shape", shape))
      return;
    ShapeDraft draft(&engine->memory);
    draft_half_space(to_vec3(normal).normalized(), offset, draft);
    add_shape(call, *engine, draft, shape);
  });
}

int32_t carom_shape_destroy(carom_engine* engine, carom_shape shape, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine)) return;
    const std::lock_guard lock(engine->mutex);
    if (!resolve(call, 2, "shape", engine->shape_slots, shape)) return;
    ShapeRecord& record = engine->shapes[handle_slot(shape)];
    if (record.uses) {
      call.fail(CAROM_E_IN_USE, 2, "%llu colliders, hulls of shapes or running queries refer to this shape",
                static_cast<unsigned long long>(record.uses));
      return;
    }
    remove_shape(*engine, handle_slot(shape));
  });
}

int32_t carom_shape_get_info(carom_engine* engine, carom_shape shape, carom_shape_info* info, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !fillable(call, 3, "info", info)) return;
    const std::lock_guard lock(engine->mutex);
    if (!resolve(call, 2, "shape", engine->shape_slots, shape)) return;
    carom_shape_info full{};
    fill_info(engine->shapes[handle_slot(shape)], full);
    write_struct(full, info);
  });
}

int32_t carom_shape_get_params(carom_engine* engine, carom_shape shape, double* params, uint64_t* count,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 4, "count", count)) return;
    const std::lock_guard lock(engine->mutex);
    if (!resolve(call, 2, "shape", engine->shape_slots, shape)) return;
    const Array<double>& own = engine->shapes[handle_slot(shape)].shape->params;
    const std::uint64_t capacity = *count;
    if (capacity < own.size()) {
      *count = own.size();
      call.fail(CAROM_E_BUFFER_TOO_SMALL, 4, "capacity for %llu parameters, the shape has %zu",
                static_cast<unsigned long long>(capacity), own.size());
      return;
    }
    if (!own.empty() && !present(call, 3, "params", params)) return;
    *count = own.size();
    std::copy(own.begin(), own.end(), params);
  });
}

int32_t carom_shape_support(carom_engine* engine, carom_shape shape, const double* dirs, uint64_t n, double* points,
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine)) return;
    ShapePin pin(*engine);
    if (!pin.take_convex(call, 2, "shape", shape)) return;
    if (n && (!present(call, 3, "dirs", dirs) || !present(call, 5, "points", points))) return;
    supports(call, *pin, dirs, n, points);
  });
}

}  // extern "C"

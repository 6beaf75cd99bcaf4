// Colliders: a shape on a body at a local pose. A collider keeps its shape alive.
#include "abi/collider.h"

#include <carom/body.h>

#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

constexpr double kLargestDensity = 1e9;  // kg/m^3
constexpr double kFastestSurface = 1e6;  // m/s, rad/s
// Below this share of the cube of its bounding radius a volume is rounding, and the inertia that follows from it noise.
constexpr Real kFlat = 1e-15;

bool is_flat(const Shape& shape) {
  const Real r = shape.bounding_radius;
  return shape.form != Form::half_space && !is_scenery(shape) && !(shape.mass.volume > kFlat * r * r * r);
}

bool check_desc(Call& call, const World& world, const carom_collider_desc& d) {
  return only_bits(call, 3, "desc->reserved", d.reserved, 0) &&
         (d.material == CAROM_NULL_HANDLE ||
          resolve(call, 3, "desc->material", world.scene.material_slots, d.material)) &&
         vector_in_range(call, 3, "desc->position", d.position, kMaxPosition) &&
         unit(call, 3, "desc->orientation", d.orientation, 4) &&
         in_range(call, 3, "desc->density", d.density, 0, kLargestDensity) &&
         in_range(call, 3, "desc->sensor", d.sensor, 0, 1) &&
         vector_in_range(call, 3, "desc->surface_linear", d.surface_linear, kFastestSurface) &&
         vector_in_range(call, 3, "desc->surface_angular", d.surface_angular, kFastestSurface);
}

void create(Call& call, const Changing& changing, carom_body body, const carom_collider_desc* given,
            carom_collider* collider) {
  carom_collider_desc d;
  carom_collider_desc_init(&d, sizeof d);
  World& world = *changing;
  ShapePin shape(changing.engine());
  if (!resolve(call, 2, "body", world.scene.bodies, body) || !read_struct(call, 3, "desc", given, d) ||
      !check_desc(call, world, d) || !shape.take(call, 3, "desc->shape", d.shape) ||
      !shape_fits(call, 3, world.scene.type[handle_slot(body)], world.scene.def[handle_slot(body)].has_mass, *shape,
                  d.density) ||
      !present(call, 4, "collider", collider))
    return;
  const FloatScope scope;
  const std::uint32_t material = d.material ? handle_slot(d.material) : Colliders::kNoMaterial;
  const Handle handle = world.add_collider(
      handle_slot(body), &*shape, {to_quat(d.orientation), to_vec3(d.position)}, d.density, material,
      {{d.category, d.mask, d.group}, d.sensor != 0, {to_vec3(d.surface_linear), to_vec3(d.surface_angular)}});
  if (!handle) {
    call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u colliders", kMaxSlots);
    return;
  }
  shape.keep();
  *collider = handle;
}

carom_collider_desc describe_collider(const World& world, std::uint32_t slot) {
  const Colliders& c = world.scene.colliders;
  carom_collider_desc d{};
  d.shape = c.shape[slot]->handle;
  d.material = c.material[slot] == Colliders::kNoMaterial ? CAROM_NULL_HANDLE
                                                          : world.scene.material_slots.handle(c.material[slot]);
  from_vec3(c.local[slot].p, d.position);
  from_quat(c.local[slot].q, d.orientation);
  d.density = c.density[slot];
  const Filter filter = c.filter_of(slot);
  d.category = filter.category, d.mask = filter.mask, d.group = filter.group;
  d.sensor = c.is_sensor(slot);
  const SurfaceVelocity surface = world.scene.surface_of(slot);
  from_vec3(surface.linear, d.surface_linear), from_vec3(surface.angular, d.surface_angular);
  return d;
}

}  // namespace

bool shape_fits(Call& call, int argument, BodyType type, bool has_mass, const Shape& shape, double density) {
  if (shape.form == Form::half_space && type != BodyType::fixed)
    return call.fail(CAROM_E_OUT_OF_RANGE, argument, "a half-space is unbounded: it fits static bodies only") ||
           call.advise("make the body static, or give it a box");
  if (is_scenery(shape) && type == BodyType::dynamic)
    return call.fail(
        CAROM_E_OUT_OF_RANGE, argument,
        "scenery has no volume: it fits static and kinematic bodies (a body that moves by forces takes convex shapes)");
  const bool weighs = type == BodyType::dynamic && density > 0 && !has_mass;
  return !(weighs && is_flat(shape)) ||
         call.fail(CAROM_E_NO_VOLUME, argument,
                   "the shape has volume %g m^3 within radius %g m: no mass follows from density %g", shape.mass.volume,
                   shape.bounding_radius, density);
}

void remove_collider(carom_engine& engine, World& world, std::uint32_t collider) {
  const Shape* shape = world.scene.colliders.shape[collider];
  world.remove_collider(collider);
  std::erase_if(world.fault_views, [&](const FaultView& v) { return v.support.shape == shape; });
  unuse_shape(engine, *shape);
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_collider_desc_init(carom_collider_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_collider_desc& d) {
    d.orientation[3] = 1;
    d.density = 1000;
    d.category = CAROM_FILTER_CATEGORY, d.mask = CAROM_FILTER_MASK;
  });
}

int32_t carom_collider_create(carom_world* world, carom_body body, const carom_collider_desc* desc,
                              carom_collider* collider, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (const Recorded changing(call, world, record::collider_create(body, desc)); changing)
      create(call, changing, body, desc, collider);
  });
}

int32_t carom_collider_destroy(carom_world* world, carom_collider collider, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_destroy(collider));
    if (!changing || !resolve(call, 2, "collider", changing->scene.collider_slots, collider)) return;
    const FloatScope scope;
    remove_collider(changing.engine(), *changing, handle_slot(collider));
  });
}

int32_t carom_collider_get(carom_world* world, carom_collider collider, carom_collider_desc* desc, carom_body* body,
                           carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve(call, 2, "collider", reading->scene.collider_slots, collider) ||
        !fillable(call, 3, "desc", desc) || !present(call, 4, "body", body))
      return;
    write_struct(describe_collider(*reading, handle_slot(collider)), desc);
    *body = reading->scene.bodies.handle(reading->scene.colliders.body[handle_slot(collider)]);
  });
}

int32_t carom_collider_set_material(carom_world* world, carom_collider collider, carom_material material,
                                    carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_set_material(collider, material));
    if (!changing || !resolve(call, 2, "collider", changing->scene.collider_slots, collider) ||
        (material != CAROM_NULL_HANDLE && !resolve(call, 3, "material", changing->scene.material_slots, material)))
      return;
    changing->set_collider_material(handle_slot(collider), material ? handle_slot(material) : Colliders::kNoMaterial);
  });
}

int32_t carom_collider_set_density(carom_world* world, carom_collider collider, double density, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_set_density(collider, density));
    if (!changing || !resolve(call, 2, "collider", changing->scene.collider_slots, collider) ||
        !in_range(call, 3, "density", density, 0, kLargestDensity))
      return;
    const dynamics::Scene& scene = changing->scene;
    const std::uint32_t slot = handle_slot(collider), body = scene.colliders.body[slot];
    if (!shape_fits(call, 3, scene.type[body], scene.def[body].has_mass, *scene.colliders.shape[slot], density)) return;
    const FloatScope scope;
    changing->set_density(slot, density);
  });
}

int32_t carom_collider_set_pose(carom_world* world, carom_collider collider, const double position[3],
                                const double orientation[4], carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_set_pose(collider, position, orientation));
    if (!changing || !resolve(call, 2, "collider", changing->scene.collider_slots, collider) ||
        !vector_in_range(call, 3, "position", position, kMaxPosition) || !unit(call, 4, "orientation", orientation, 4))
      return;
    const FloatScope scope;
    changing->set_local_pose(handle_slot(collider), {to_quat(orientation), to_vec3(position)});
  });
}

int32_t carom_collider_set_surface_velocity(carom_world* world, carom_collider collider, const double linear[3],
                                            const double angular[3], carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::collider_set_surface_velocity(collider, linear, angular));
    if (!changing || !resolve(call, 2, "collider", changing->scene.collider_slots, collider) ||
        !vector_in_range(call, 3, "linear", linear, kFastestSurface) ||
        !vector_in_range(call, 4, "angular", angular, kFastestSurface))
      return;
    changing->set_surface_velocity(handle_slot(collider), {to_vec3(linear), to_vec3(angular)});
  });
}

int32_t carom_collider_get_surface_velocity(carom_world* world, carom_collider collider, double linear[3],
                                            double angular[3], carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve(call, 2, "collider", reading->scene.collider_slots, collider) ||
        !present(call, 3, "linear", linear) || !present(call, 4, "angular", angular))
      return;
    const SurfaceVelocity surface = reading->scene.surface_of(handle_slot(collider));
    from_vec3(surface.linear, linear), from_vec3(surface.angular, angular);
  });
}

}  // extern "C"

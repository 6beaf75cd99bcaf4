// Scenes in which an effect has as many participants as asked for: points that fly, things that lie on the ground, hinges.
#include "effects/crowds.h"

#include "dynamics/events/events.h"
#include "scenery_builder.h"

namespace carom::bench {
namespace {

using namespace carom::test;
using Build = std::function<void(TestWorld&, std::uint32_t, std::uint32_t)>;

constexpr std::uint32_t kRow = 100;  // bodies side by side

Vec3 site(std::uint32_t i) { return Vec3(3.0 * (i % kRow), 50, 3.0 * (i / kRow)); }

/// Bodies without a shape, far from each other; nothing acts on them.
void fly(TestWorld& t, std::uint32_t bodies) {
  t.world.set_gravity(Vec3::zero());
  for (std::uint32_t i = 0; i < bodies; ++i) {
    BodyDef def;
    def.has_mass = def.has_inertia = true;
    def.mass = 2, def.inertia = Mat3::diagonal(Vec3::constant(0.3));
    def.pose.p = site(i);
    def.velocity = Vec3(0.1, 0.2, 0.3), def.omega = Vec3(0.3, 0.2, 0.1);
    t.world.add_body(def);
  }
}

/// Those that call for something are the last: they and the others are two runs of slots.
template <class F>
Build flying(F call) {
  return [call](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
    fly(t, bodies);
    for (std::uint32_t i = bodies - calling; i < bodies; ++i) call(t.world, i);
  };
}
template <class F, class S>
Build flying(F call, S scene) {
  return [call, scene](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
    flying(call)(t, bodies, calling);
    scene(t);
  };
}
Build flying_shapes(const Shape& shape, const std::function<void(World&, std::uint32_t)>& call = {},
                    const std::function<void(TestWorld&)>& scene = {}) {
  return [=](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
    const Shape* kept = t.keep(shape);
    flying([&](World& w, std::uint32_t i) {
      w.add_collider(i, kept, Pose{}, 500, Colliders::kNoMaterial);
      if (call) call(w, i);
    })(t, bodies, calling);
    if (scene) scene(t);
  };
}

/// Things that lie on the ground, a step's fall deep in it; all call.
Build lying(const Shape& shape, Real height, const Material& material,
            const std::function<void(World&, std::uint32_t)>& call = {}) {
  return [=](TestWorld& t, std::uint32_t bodies, std::uint32_t) {
    const std::uint32_t m = handle_slot(t.world.add_material(material));
    t.ground(m);
    const Shape* kept = t.keep(shape);
    for (std::uint32_t i = 0; i < bodies; ++i) {
      const Vec3 p = site(i);
      const std::uint32_t body =
          t.add(kept, Vec3(p.x(), height - 0.002, p.z()), BodyType::dynamic, Quat::identity(), m);
      if (call) call(t.world, body);
    }
  };
}

Build hinged(const JointDrive& drive) {
  return flying([drive](World& w, std::uint32_t i) {
    JointDef def;
    def.kind = JointKind::hinge;
    def.body_a = i;
    def.frame_a.p = Vec3(0.5, 0, 0);
    def.frame_b.p = w.pose(i).p + Vec3(0.5, 0, 0);
    const std::uint32_t joint = handle_slot(w.add_joint(def));
    if (drive.on()) w.set_joint_drive(joint, Coordinate::twist, drive);
  });
}

void damp(World& w, std::uint32_t i, Real linear, Real angular) {
  w.scene.def[i].linear_damping = linear, w.scene.def[i].angular_damping = angular;
  ++w.scene.revision;
}

Build in_field(FieldDef field) {
  field.mask = 2;
  return flying([](World& w, std::uint32_t i) { w.set_attribute(i, AttributeId::force_field_mask, {2}); },
                [field](TestWorld& t) { t.world.add_field(field); });
}

/// Half of each is in it. Without gravity it pushes nobody away, however long this takes.
void fill_in_water(TestWorld& t) {
  WaterDef water;
  water.level = 50, water.drag = 0.01;
  t.world.set_water(&water);
}

Material surface(Real friction, Real restitution, Real rolling, Real spinning) {
  Material m;
  m.friction = friction, m.restitution = restitution, m.rolling = rolling, m.spinning = spinning;
  return m;
}

}  // namespace

std::vector<Crowd> crowds() {
  const Shape ball = sphere(0.5), cube = box(Vec3::constant(0.5));
  FieldDef uniform, vortex;
  uniform.vector = Vec3(0, 1, 0);
  vortex.kind = FieldKind::vortex, vortex.strength = 1, vortex.pull = 1, vortex.core = 1, vortex.falloff = 1;
  JointDrive limit, motor;
  limit.limit.on = true, limit.limit.lower = -0.5, limit.limit.upper = 0.5;
  motor.motor.on = true, motor.motor.speed = 1, motor.motor.max_force = 5;
  const auto drag = [](World& w, std::uint32_t i) { w.set_attribute(i, AttributeId::drag, {0.1, 0.1}); };
  const auto push = [](const Vec3& force, const Vec3& torque) {
    return [=](TestWorld& t, std::uint32_t calling) {
      const std::uint32_t bodies = t.world.scene.bodies.slots();
      for (std::uint32_t i = bodies - calling; i < bodies; ++i) t.world.add_force(i, force, torque);
    };
  };
  const Material smooth = surface(0, 0, 0, 0), rough = surface(0.5, 0, 0, 0);
  return {
      {+EffectId::gyroscopic, "gyroscopic", 10000, true, flying([](World& w, std::uint32_t i) {
         w.scene.inertia[i] = Mat3::diagonal(Vec3(0.1, 0.2, 0.3));
         w.scene.inv_inertia[i] = w.scene.inertia[i].inverse();
       })},
      {+EffectId::linear_damping, "linear_damping", 10000, true,
       flying([](World& w, std::uint32_t i) { damp(w, i, 0.5, 0); })},
      {+EffectId::angular_damping, "angular_damping", 10000, true,
       flying([](World& w, std::uint32_t i) { damp(w, i, 0, 0.5); })},
      {+EffectId::gravity, "gravity", 10000, true,
       [](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
         fly(t, bodies);
         for (std::uint32_t i = 0; i < bodies - calling; ++i)
           t.world.set_attribute(i, AttributeId::gravity_factor, {0});
         t.world.set_gravity(Vec3(0, -9.81, 0));
       }},
      {+EffectId::user_force, "user_force", 10000, true, flying([](World&, std::uint32_t) {}),
       push({1, 2, 3}, Vec3::zero())},
      {+EffectId::user_torque, "user_torque", 10000, true, flying([](World&, std::uint32_t) {}),
       push(Vec3::zero(), {1, 2, 3})},
      {+EffectId::axis_locks, "axis_locks", 10000, true,
       flying([](World& w, std::uint32_t i) { w.set_attribute(i, AttributeId::locks, {1}); })},
      {+EffectId::drag, "drag", 10000, true, flying(drag)},
      {+EffectId::wind, "wind", 10000, true, flying(drag, [](TestWorld& t) { t.world.set_wind(Vec3(3, 0, 0)); })},
      {+EffectId::fields, "fields, uniform", 10000, true, in_field(uniform)},
      {+EffectId::fields, "fields, vortex", 10000, true, in_field(vortex)},
      {+EffectId::magnetism, "magnetism", 10000, true,
       flying(
           [](World& w, std::uint32_t i) {
             w.set_attribute(i, AttributeId::magnetic_moment, {1e-3, 0, 0});
           },
           [](TestWorld& t) {
             FieldDef f;
             f.kind = FieldKind::magnetic, f.vector = Vec3(0, 1, 0);
             t.world.add_field(f);
           })},
      {+EffectId::springs, "springs", 1000, true, flying([](World& w, std::uint32_t i) {
         SpringDef d;
         d.body_a = i, d.anchor_b = w.pose(i).p + Vec3(0, 2, 0), d.rest = 1, d.stiffness = 10, d.damping = 0.1;
         w.add_spring(d);
       })},
      {+EffectId::buoyancy, "buoyancy, balls", 10000, true, flying_shapes(ball, {}, fill_in_water)},
      {+EffectId::buoyancy, "buoyancy, boxes", 10000, true, flying_shapes(cube, {}, fill_in_water)},
      {+EffectId::particles, "particles", 10000, true,
       [](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
         if (calling < bodies) fly(t, bodies);
         t.world.particles.extend(handle_slot(t.world.particles.create({}, calling)), calling);
       }},
      {+EffectId::collision, "collision, far apart", 10000, false, flying_shapes(ball)},
      {+EffectId::filter, "filter", 10000, false,
       flying_shapes(ball,
                     [](World& w, std::uint32_t i) {
                       Filter f;
                       f.category = 2;
                       w.set_filter(w.scene.first_collider[i], f);
                     })},
      {+EffectId::continuous, "continuous", 10000, false,
       flying_shapes(ball, [](World& w, std::uint32_t i) { w.set_continuous(i, SweepMode::always); })},
      {+EffectId::sleep, "sleep, awake", 10000, false,
       flying([](World&, std::uint32_t) {}, [](TestWorld& t) { t.world.set_dial(Dial::sleep, 1); })},
      {+EffectId::response, "response, boxes", 1000, false, lying(cube, 0.5, smooth)},
      {+EffectId::friction, "friction, boxes", 1000, false, lying(cube, 0.5, rough)},
      {+EffectId::restitution, "restitution, balls", 1000, false, lying(ball, 0.5, surface(0, 0.5, 0, 0))},
      {+EffectId::rolling_resistance, "rolling_resistance", 1000, false, lying(ball, 0.5, surface(0.5, 0, 0.05, 0))},
      {+EffectId::spinning_resistance, "spinning_resistance", 1000, false, lying(ball, 0.5, surface(0.5, 0, 0, 0.05))},
      {+EffectId::surface_velocity, "surface_velocity", 1000, false,
       lying(cube, 0.5, rough,
             [](World& w, std::uint32_t i) {
               w.set_surface_velocity(w.scene.first_collider[i], {Vec3(0, 0, 0.1), Vec3::zero()});
             })},
      {+EffectId::sensor, "sensor", 1000, false,
       lying(ball, 0.5, rough,
             [](World& w, std::uint32_t i) {
               w.set_attribute(i, AttributeId::gravity_factor, {0});
               w.set_sensor(w.scene.first_collider[i], true);
             })},
      {+EffectId::scenery, "scenery, one under boxes", 1000, false,
       [=](TestWorld& t, std::uint32_t bodies, std::uint32_t) {
         const int along = static_cast<int>(3 * kRow), across = static_cast<int>(3 * (bodies / kRow + 1));
         t.add(t.keep(mesh(grid(along, across, 1, -1.5, -1.5, [](double, double) { return 0.0; }))), Vec3::zero(),
               BodyType::fixed);
         const Shape* kept = t.keep(cube);
         for (std::uint32_t i = 0; i < bodies; ++i) t.add(kept, Vec3(site(i).x(), 0.498, site(i).z()));
       }},
      {+EffectId::joints, "joints, hinges", 1000, true, hinged({})},
      {+EffectId::joint_limits, "joint_limits, hinges", 1000, true, hinged(limit)},
      {+EffectId::joint_motors, "joint_motors, hinges", 1000, true, hinged(motor)},
      {+EffectId::events, "events, of boxes", 1000, false,
       [=](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
         lying(cube, 0.5, rough)(t, bodies, calling);
         collect(t.world, Events::contact, 1);
       }},
      {+EffectId::ledger, "ledger, of boxes", 1000, false,
       [=](TestWorld& t, std::uint32_t bodies, std::uint32_t calling) {
         lying(cube, 0.5, rough)(t, bodies, calling);
         t.world.keep_ledger(true);
       }},
  };
}

}  // namespace carom::bench

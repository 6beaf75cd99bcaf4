// A world with something of every kind, and what else a hostile caller needs: handles of the dead, of other kinds, of other worlds.
#pragma once

#include <carom/carom.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace hostile {

enum Kind { kPlugin, kShape, kMaterial, kBody, kCollider, kParticles, kJoint, kField, kSpring, kKinds };

/// Where choices come from: a fuzzer's bytes, or always the first.
class Source {
 public:
  virtual ~Source() = default;
  virtual unsigned below(unsigned) { return 0; }
  /// In [0, 1).
  virtual double unit() { return 0.25; }
};

struct Owned {
  uint64_t handle;
  uint64_t owner[2];  // bodies, or joints of a coupling, that take it along when they go; 0: none
};

/// An engine and a world of it, with the handles that live there as far as the caller knows.
struct Stage {
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;
  std::vector<Owned> live[kKinds];
  std::vector<uint64_t> stale[kKinds];

  void born(int kind, uint64_t handle, uint64_t owner = 0, uint64_t other_owner = 0) {
    live[kind].push_back({handle, {owner, other_owner}});
  }
  void dies(int kind, uint64_t handle) {
    if (kind == kBody)
      for (const int with : {kCollider, kJoint, kSpring})
        for (std::size_t i = live[with].size(); i-- > 0;)
          if (i < live[with].size() && (live[with][i].owner[0] == handle || live[with][i].owner[1] == handle))
            dies(with, live[with][i].handle);
    if (kind == kJoint)
      for (std::size_t i = live[kJoint].size(); i-- > 0;)
        if (live[kJoint][i].owner[0] == handle || live[kJoint][i].owner[1] == handle)
          return dies(kJoint, live[kJoint][i].handle), dies(kind, handle);
    for (std::size_t i = 0; i < live[kind].size(); ++i)
      if (live[kind][i].handle == handle) {
        live[kind].erase(live[kind].begin() + static_cast<std::ptrdiff_t>(i));
        stale[kind].push_back(handle);
        return;
      }
  }
};

inline int32_t point(void* user, const double*, uint64_t, const double[3], double out[3]) {
  (void)user;
  out[0] = out[1] = out[2] = 0;
  return 0;
}
inline int32_t box(void* user, const double* p, uint64_t, const double dir[3], double out[3]) {
  (void)user;
  for (int i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -p[i] : p[i];
  return 0;
}
inline const carom_param kRadius[] = {{"radius", "m", 0.01, 100}};
inline const carom_param kHalf[] = {{"x", "m", 0.01, 100}, {"y", "m", 0.01, 100}, {"z", "m", 0.01, 100}};
inline const carom_geometry kSphereGeometry = {sizeof(carom_geometry),
                                               CAROM_FORM_SPHERE,
                                               {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
                                               0,
                                               CAROM_FORM_SPHERE,
                                               {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM}};
inline const carom_geometry kBoxGeometry = {sizeof(carom_geometry), CAROM_FORM_BOX, {0, 1, 2, CAROM_NO_PARAM},
                                            CAROM_NO_PARAM,         CAROM_FORM_BOX, {0, 1, 2, CAROM_NO_PARAM}};

inline carom_shape_plugin plugin_of(const char* id, const carom_param* params, uint32_t count,
                                    const carom_geometry* geometry, carom_support_fn support) {
  carom_shape_plugin p = {};
  p.struct_size = sizeof p;
  p.abi_major = CAROM_PLUGIN_ABI_MAJOR, p.abi_minor = CAROM_PLUGIN_ABI_MINOR;
  p.id = id, p.version = 1, p.params = params, p.param_count = count, p.geometry = geometry, p.support = support;
  return p;
}
// In the order in which they are registered: live[kPlugin][0..2].
inline const carom_shape_plugin kBall = plugin_of("hostile.ball", kRadius, 1, &kSphereGeometry, point);
inline const carom_shape_plugin kCrate = plugin_of("hostile.crate", kHalf, 3, &kBoxGeometry, box);
inline const carom_shape_plugin kLump = plugin_of("hostile.lump", kHalf, 3, nullptr, box);  // nothing declared

/// Registered plugins, and shapes: two balls, a crate, a lump, a half-space, a mesh.
inline bool make_engine(Stage& s, const carom_engine_desc* desc = nullptr) {
  if (carom_engine_create(desc, &s.engine, nullptr) != CAROM_OK) return false;
  bool good = true;
  for (const carom_shape_plugin* p : {&kBall, &kCrate, &kLump}) {
    carom_plugin h = 0;
    good = good && carom_plugin_register(s.engine, p, &h, nullptr) == CAROM_OK;
    s.born(kPlugin, h);
  }
  const double half[3] = {0.5, 0.25, 0.75}, small = 0.3, up[3] = {0, 1, 0};
  const double corners[] = {-9, -2, -9, -9, -2, 9, 9, -2, 9, 9, -2, -9};
  const uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
  carom_shape shapes[6] = {};
  carom_mesh_desc mesh;
  carom_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertices = corners, mesh.vertex_count = 4, mesh.triangles = triangles, mesh.triangle_count = 2;
  carom_engine* e = s.engine;
  good = good && carom_shape_create(e, s.live[kPlugin][0].handle, half, 1, &shapes[0], nullptr) == CAROM_OK &&
         carom_shape_create(e, s.live[kPlugin][0].handle, &small, 1, &shapes[1], nullptr) == CAROM_OK &&
         carom_shape_create(e, s.live[kPlugin][1].handle, half, 3, &shapes[2], nullptr) == CAROM_OK &&
         carom_shape_create(e, s.live[kPlugin][2].handle, half, 3, &shapes[3], nullptr) == CAROM_OK &&
         carom_shape_create_half_space(e, up, 0, &shapes[4], nullptr) == CAROM_OK &&
         carom_shape_create_mesh(e, &mesh, &shapes[5], nullptr) == CAROM_OK;
  for (const carom_shape h : shapes) s.born(kShape, h);
  return good;
}

inline carom_body add_body(Stage& s, uint32_t type, int shape, double x, double y, double z) {
  carom_body_desc d;
  carom_body_desc_init(&d, sizeof d);
  d.type = type, d.position[0] = x, d.position[1] = y, d.position[2] = z;
  carom_body body = 0;
  if (carom_body_create(s.world, &d, &body, nullptr) != CAROM_OK) return 0;
  s.born(kBody, body);
  carom_collider_desc part;
  carom_collider_desc_init(&part, sizeof part);
  part.shape = s.live[kShape][static_cast<std::size_t>(shape)].handle;
  if (!s.live[kMaterial].empty()) part.material = s.live[kMaterial][0].handle;
  carom_collider collider = 0;
  if (carom_collider_create(s.world, body, &part, &collider, nullptr) != CAROM_OK) return 0;
  s.born(kCollider, collider, body);
  return body;
}

/// A world on the stage's engine: a few bodies that touch, and something of each kind. Body 0 is dynamic, of one collider.
inline bool make_world(Stage& s) {
  for (const int k : {kMaterial, kBody, kCollider, kParticles, kJoint, kField, kSpring})
    s.live[k].clear(), s.stale[k].clear();
  if (carom_world_create(s.engine, nullptr, &s.world, nullptr) != CAROM_OK) return false;
  carom_material_desc md;
  carom_material_desc_init(&md, sizeof md);
  md.restitution = 0.25;
  carom_material material = 0;
  bool good = carom_material_create(s.world, &md, &material, nullptr) == CAROM_OK;
  s.born(kMaterial, material);
  const carom_body a = add_body(s, CAROM_BODY_DYNAMIC, 0, 0, 0.49, 0),
                   b = add_body(s, CAROM_BODY_DYNAMIC, 2, 0.1, 1.2, 0),
                   c = add_body(s, CAROM_BODY_DYNAMIC, 3, 3, 0.24, 0),
                   d = add_body(s, CAROM_BODY_DYNAMIC, 1, 3, 0.9, 0.5),
                   k = add_body(s, CAROM_BODY_KINEMATIC, 2, -4, 1, 0),
                   ground = add_body(s, CAROM_BODY_STATIC, 4, 0, 0, 0);
  good = good && a && b && c && d && k && ground;
  carom_particles set = 0;
  const double x[9] = {0, 5, 0, 1, 5, 0, 2, 5, 0};
  good = good && carom_particles_create(s.world, nullptr, &set, nullptr) == CAROM_OK &&
         carom_particles_add(s.world, set, 3, CAROM_SCALAR_F64, x, 0, nullptr, 0, nullptr) == CAROM_OK;
  s.born(kParticles, set);
  carom_joint_desc jd;
  carom_joint_desc_init(&jd, sizeof jd);
  jd.kind = CAROM_JOINT_HINGE, jd.fields = CAROM_JOINT_WORLD_FRAME, jd.body_a = c, jd.body_b = d;
  jd.position_a[0] = 3, jd.position_a[1] = 0.6;
  carom_joint joint = 0;
  good = good && carom_joint_create(s.world, &jd, &joint, nullptr) == CAROM_OK;
  s.born(kJoint, joint, c, d);
  carom_force_field_desc fd;
  carom_force_field_desc_init(&fd, sizeof fd);
  fd.kind = CAROM_FORCE_FIELD_VORTEX, fd.strength = 0.5, fd.position[0] = 2;
  carom_force_field field = 0;
  good = good && carom_force_field_create(s.world, &fd, &field, nullptr) == CAROM_OK;
  s.born(kField, field);
  carom_spring_desc sd;
  carom_spring_desc_init(&sd, sizeof sd);
  sd.body_b = b, sd.anchor_a[1] = 3, sd.rest = 1, sd.stiffness = 10;
  carom_spring spring = 0;
  good = good && carom_spring_create(s.world, &sd, &spring, nullptr) == CAROM_OK;
  s.born(kSpring, spring, b);
  good = good && carom_world_collect_events(s.world, 31, 1, nullptr) == CAROM_OK;
  for (int i = 0; i < 3; ++i) good = good && carom_world_step(s.world, 1. / 64, nullptr) == CAROM_OK;
  return good;
}

/// Everything that can be read of a world, as bytes.
class Digest {
 public:
  explicit Digest(const Stage& s) : world_(s.world) {
    uint64_t n = 0;
    uint64_t hash = 0;
    keep(carom_world_hash(world_, &hash, nullptr), hash);
    double v[3] = {};
    keep(carom_world_get_gravity(world_, v, nullptr), v);
    keep(carom_world_get_wind(world_, v, nullptr), v);
    carom_water water = {};
    water.struct_size = sizeof water;
    uint32_t u = 0;
    keep(carom_world_get_water(world_, &water, &u, nullptr), water);
    keep(0, u);
    for (uint32_t i = 0; i < CAROM_DIAL_COUNT; ++i) keep(carom_world_get_dial(world_, i, v, nullptr), v);
    for (uint32_t i = 0; i < CAROM_EFFECT_COUNT; ++i) keep(carom_world_get_effect(world_, i, &u, nullptr), u);
    carom_step_report report = {};
    report.struct_size = sizeof report;
    keep(carom_world_get_report(world_, &report, nullptr), report);
    carom_ledger_state ledger = {};
    ledger.struct_size = sizeof ledger;
    keep(carom_world_get_ledger_state(world_, &ledger, nullptr), ledger);
    carom_residuals residuals = {};
    residuals.struct_size = sizeof residuals;
    keep(carom_world_get_residuals(world_, &residuals, nullptr), residuals);
    double seconds = 0;
    uint32_t fewest = 0, most = 0;
    keep(carom_world_get_budget(world_, &seconds, &fewest, &most, nullptr), seconds);
    keep(fewest, most);
    carom_contact contacts[32] = {};
    keep(carom_world_get_contacts(world_, contacts, sizeof *contacts, 32, &n, nullptr), n);
    keep(0, contacts);
    uint64_t list[64] = {};
    keep(carom_world_get_bodies(world_, list, 64, &n, nullptr), n);
    for (uint64_t i = 0; i < n && i < 64; ++i) body(list[i]);
    keep(carom_world_get_joints(world_, list, 64, &n, nullptr), n);
    for (uint64_t i = 0; i < n && i < 64; ++i) joint(list[i]);
    keep(carom_world_get_particles(world_, list, 64, &n, nullptr), n);
    for (uint64_t i = 0; i < n && i < 64; ++i) {
      carom_particles_desc d = {};
      d.struct_size = sizeof d;
      const int32_t r = carom_particles_get(world_, list[i], &d, nullptr);
      d.capacity = 0;  // memory that was got before more of it was refused may stay
      keep(r, d);
      keep(carom_particles_get_count(world_, list[i], &n, nullptr), n);
    }
    for (const Owned& c : s.live[kCollider]) collider(c.handle);
    for (const Owned& m : s.live[kMaterial]) {
      double w = 0;
      keep(carom_material_get_resistance(world_, m.handle, v, &w, nullptr), v);
      keep(0, w);
    }
    for (const Owned& f : s.live[kField]) {
      carom_force_field_desc d = {};
      d.struct_size = sizeof d;
      keep(carom_force_field_get(world_, f.handle, &d, nullptr), d);
    }
    for (const Owned& f : s.live[kSpring]) {
      carom_spring_desc d = {};
      d.struct_size = sizeof d;
      keep(carom_spring_get(world_, f.handle, &d, nullptr), d);
    }
  }
  bool operator==(const Digest&) const = default;

 private:
  template <class T>
  void keep(int32_t result, const T& value) {
    const auto* from = reinterpret_cast<const char*>(&value);
    bytes_.push_back(static_cast<char>(result));
    bytes_.insert(bytes_.end(), from, from + sizeof value);
  }
  void body(carom_body b) {
    carom_body_desc d = {};
    d.struct_size = sizeof d;
    keep(carom_body_get(world_, b, &d, nullptr), d);
    double x = 0, y = 0, force[6] = {};
    uint32_t u = 0;
    keep(carom_world_read(world_, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, &b, 1, force, 0, nullptr), force);
    keep(carom_body_get_gravity_factor(world_, b, &x, nullptr), x);
    keep(carom_body_get_locks(world_, b, &u, nullptr), u);
    keep(carom_body_get_continuous(world_, b, &u, nullptr), u);
    keep(carom_body_get_drag(world_, b, &x, &y, nullptr), x);
    keep(0, y);
    keep(carom_body_get_force_field_mask(world_, b, &u, nullptr), u);
    keep(carom_body_is_asleep(world_, b, &u, nullptr), u);
    for (uint32_t i = 0; i < CAROM_EFFECT_COUNT; ++i) keep(carom_body_get_effect(world_, b, i, &u, nullptr), u);
  }
  void joint(carom_joint j) {
    carom_joint_desc d = {};
    d.struct_size = sizeof d;
    keep(carom_joint_get(world_, j, &d, nullptr), d);
    carom_joint_transmission transmission = {};
    transmission.struct_size = sizeof transmission;
    keep(carom_joint_get_transmission(world_, j, &transmission, nullptr), transmission);
    carom_joint_coupling coupling = {};
    coupling.struct_size = sizeof coupling;
    keep(carom_joint_get_coupling(world_, j, &coupling, nullptr), coupling);
    carom_joint_orientation_drive drive = {};
    drive.struct_size = sizeof drive;
    keep(carom_joint_get_orientation_drive(world_, j, &drive, nullptr), drive);
    for (uint32_t i = 0; i < CAROM_AXIS_COUNT; ++i) {
      carom_joint_axis axis = {};
      axis.struct_size = sizeof axis;
      keep(carom_joint_get_axis(world_, j, i, &axis, nullptr), axis);
    }
    for (uint32_t i = 0; i < CAROM_COORDINATE_COUNT; ++i) {
      carom_joint_limit limit = {};
      carom_joint_motor motor = {};
      carom_joint_spring spring = {};
      limit.struct_size = sizeof limit, motor.struct_size = sizeof motor, spring.struct_size = sizeof spring;
      keep(carom_joint_get_limit(world_, j, i, &limit, nullptr), limit);
      keep(carom_joint_get_motor(world_, j, i, &motor, nullptr), motor);
      keep(carom_joint_get_spring(world_, j, i, &spring, nullptr), spring);
    }
  }
  void collider(carom_collider c) {
    carom_collider_desc d = {};
    d.struct_size = sizeof d;
    carom_body b = 0;
    keep(carom_collider_get(world_, c, &d, &b, nullptr), d);
    uint64_t category = 0, mask = 0;
    int32_t group = 0;
    uint32_t sensor = 0;
    double v[3] = {}, w[3] = {};
    keep(carom_collider_get_filter(world_, c, &category, &mask, &group, nullptr), category);
    keep(group, mask);
    keep(carom_collider_is_sensor(world_, c, &sensor, nullptr), sensor);
    keep(carom_collider_get_surface_velocity(world_, c, v, w, nullptr), v);
    keep(0, w);
  }

  carom_world* world_;
  std::vector<char> bytes_;
};

/// What of the bodies' and particles' poses and velocities is not finite, in words; empty: nothing.
inline std::string not_finite(carom_world* world) {
  const auto find = [](const char* what, const std::vector<double>& values, std::size_t width) -> std::string {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        return std::string(what) + " " + std::to_string(i % width) + " of number " + std::to_string(i / width) +
               " is not finite";
    return "";
  };
  uint64_t n = 0;
  if (carom_world_get_bodies(world, nullptr, 0, &n, nullptr) != CAROM_OK) return "bodies cannot be counted";
  for (const auto& [what, field, width] :
       {std::tuple("pose", CAROM_FIELD_POSE, 7u), std::tuple("velocity", CAROM_FIELD_VELOCITY, 6u)}) {
    std::vector<double> values(n * width);
    if (n && carom_world_read(world, field, CAROM_SCALAR_F64, nullptr, n, values.data(), 0, nullptr) != CAROM_OK)
      return "bodies cannot be read";
    if (std::string bad = find(what, values, width); !bad.empty()) return bad;
  }
  carom_particles sets[64];
  uint64_t count = 0;
  if (carom_world_get_particles(world, sets, 64, &count, nullptr) != CAROM_OK) return "sets cannot be counted";
  for (uint64_t i = 0; i < count && i < 64; ++i) {
    if (carom_particles_get_count(world, sets[i], &n, nullptr) != CAROM_OK) return "particles cannot be counted";
    for (const uint32_t field : {CAROM_FIELD_POSITION, CAROM_FIELD_LINEAR_VELOCITY}) {
      std::vector<double> values(3 * n);
      if (n && carom_particles_read(world, sets[i], field, CAROM_SCALAR_F64, nullptr, n, values.data(), 0, nullptr) !=
                   CAROM_OK)
        return "particles cannot be read";
      if (std::string bad = find("particles' field", values, 3); !bad.empty()) return bad;
    }
  }
  return "";
}

}  // namespace hostile

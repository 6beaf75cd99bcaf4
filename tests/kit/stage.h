// A world to walk in, by the public interface: boxes, slopes, meshes, height fields; and one who walks.
#pragma once

#include <carom/carom.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "carom_test.h"

namespace kit {

using V = std::array<double, 3>;
using Q = std::array<double, 4>;  // x, y, z, w

inline constexpr double kPi = 3.14159265358979323846;
inline Q about(const V& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {axis[0] * s, axis[1] * s, axis[2] * s, std::cos(angle / 2)};
}
inline Q about_z(double angle) { return about({0, 0, 1}, angle); }

#define GOOD(call) assert_int_equal(call, CAROM_OK)

struct Stage {
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;

  Stage() {
    GOOD(carom_engine_create(nullptr, &engine, nullptr));
    for (const char* name : {"box", "capsule", "sphere", "cylinder"}) {
      carom_plugin plugin;
      GOOD(carom_plugin_load(engine, (std::string(CAROM_PLUGIN_DIR "/") + name + ".so").c_str(), &plugin, nullptr));
    }
    GOOD(carom_world_create(engine, nullptr, &world, nullptr));
  }
  ~Stage() {
    carom_world_destroy(world, nullptr);
    carom_engine_destroy(engine, nullptr);
  }
  Stage(const Stage&) = delete;

  carom_shape shape(const char* name, std::vector<double> params) {
    carom_shape made;
    GOOD(carom_shape_create_named(engine, name, params.data(), params.size(), &made, nullptr));
    return made;
  }
  carom_body body(uint32_t type, carom_shape of, const V& at, const Q& turn = {0, 0, 0, 1}, double density = 1000,
                  double friction = 0.5) {
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    d.type = type;
    std::memcpy(d.position, at.data(), sizeof d.position);
    std::memcpy(d.orientation, turn.data(), sizeof d.orientation);
    carom_body made;
    GOOD(carom_body_create(world, &d, &made, nullptr));
    carom_material_desc m;
    carom_material_desc_init(&m, sizeof m);
    m.friction = friction;
    carom_material material;
    GOOD(carom_material_create(world, &m, &material, nullptr));
    carom_collider_desc c;
    carom_collider_desc_init(&c, sizeof c);
    c.shape = of, c.density = density, c.material = material;
    carom_collider collider;
    GOOD(carom_collider_create(world, made, &c, &collider, nullptr));
    return made;
  }
  /// A static box by its corners.
  carom_body box(const V& low, const V& high) {
    return body(CAROM_BODY_STATIC,
                shape("box", {(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2}),
                {(high[0] + low[0]) / 2, (high[1] + low[1]) / 2, (high[2] + low[2]) / 2});
  }
  /// Static ground whose top passes through the origin, and rises along x at `slope`.
  carom_body ground(double slope = 0) {
    carom_shape plane;
    const double up[3] = {0, 1, 0};
    GOOD(carom_shape_create_half_space(engine, up, 0, &plane, nullptr));
    return body(CAROM_BODY_STATIC, plane, {0, 0, 0}, about_z(slope));
  }
  carom_shape mesh(const std::vector<double>& vertices, const std::vector<uint32_t>& triangles) {
    carom_mesh_desc d;
    carom_mesh_desc_init(&d, sizeof d);
    d.vertices = vertices.data(), d.vertex_count = vertices.size() / 3;
    d.triangles = triangles.data(), d.triangle_count = triangles.size() / 3;
    carom_shape made;
    GOOD(carom_shape_create_mesh(engine, &d, &made, nullptr));
    return made;
  }
  template <class Height>
  carom_shape field(uint32_t columns, uint32_t rows, double spacing, Height height) {
    std::vector<double> heights;
    for (uint32_t r = 0; r < rows; ++r)
      for (uint32_t c = 0; c < columns; ++c) heights.push_back(height(c * spacing, r * spacing));
    carom_height_field_desc d;
    carom_height_field_desc_init(&d, sizeof d);
    d.columns = columns, d.rows = rows, d.heights = heights.data();
    d.spacing[0] = d.spacing[1] = spacing;
    carom_shape made;
    GOOD(carom_shape_create_height_field(engine, &d, &made, nullptr));
    return made;
  }
  void step(double dt) { GOOD(carom_world_step(world, dt, nullptr)); }
  V place(carom_body of) {
    V p;
    GOOD(carom_body_get_pose(world, of, p.data(), nullptr, nullptr));
    return p;
  }
};

/// A capsule of radius 0.3 m, 1.8 m tall, that walks.
struct Walker : carom_character {
  static constexpr double kRadius = 0.3, kHalf = 0.6, kFoot = kRadius + kHalf;
  /// What it stands off the ground.
  static constexpr double kGap = 0.01 * 1.02;

  Stage& stage;
  carom_character_desc desc;

  /// @param feet  m, where it stands, a gap above
  Walker(Stage& s, const V& feet, carom_shape other = CAROM_NULL_HANDLE) : stage(s) {
    GOOD(carom_character_init(this, sizeof(carom_character)));
    GOOD(carom_character_desc_init(&desc, sizeof desc));
    position[0] = feet[0], position[1] = feet[1] + kFoot + kGap, position[2] = feet[2];
    give(other ? other : s.shape("capsule", {kRadius, kHalf}));
    move({0, 0, 0}, 0);  // it looks for ground
  }
  void give(carom_shape to) {
    GOOD(carom_character_set_shape(stage.engine, stage.world, &desc, this, to, nullptr, nullptr));
  }
  void move(const V& walk, double dt, double jump = 0) {
    carom_error e = CAROM_ERROR_INIT;
    const int32_t result = carom_character_move(stage.world, &desc, this, walk.data(), jump, dt, &e);
    if (result != CAROM_OK) print_error("%s\n", e.message);
    GOOD(result);
  }
  /// A frame: the world steps, it moves, it pushes.
  void frame(const V& walk, double dt, double jump = 0) {
    stage.step(dt);
    move(walk, dt, jump);
    GOOD(carom_character_push(stage.world, &desc, this, dt, nullptr));
  }
  void moves(const V& walk, double dt, int n) {
    for (int i = 0; i < n; ++i) move(walk, dt);
  }
  double feet() const { return position[1] - foot - kGap; }
  bool firm() const { return ground == CAROM_GROUND_FIRM; }
};

inline bool near_to(double x, double y, double error) {
  if (std::fabs(x - y) <= error) return true;
  print_error("%.9g is %.3g off %.9g, allowed %.3g\n", x, x - y, y, error);
  return false;
}

}  // namespace kit

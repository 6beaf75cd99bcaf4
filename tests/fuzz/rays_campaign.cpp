// Rays where rounding decides: at seams, edges and corners, in the plane of a side, from a surface, up to 1e8 m out. By
// a host that sees include/ alone.
//
//   fuzz_rays_campaign --count N [--from K]
//   fuzz_rays_campaign --show K
//
// What each owes:
//   - a ray cast by the engine at each shape alone, turned as it was given or as the world says, by the world, and in a
//     batch of each is the same to the bit;
//   - none is undecided, and a hit has a bracket around its time and a unit normal against the ray;
//   - through a seam of flush shapes, or between triangles, it hits where the surface is;
//   - within the plane of a side it hits where that side begins;
//   - from a surface outwards or along it does not hit, inwards at once.
#include <carom/carom.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

constexpr double kOut[] = {0, 1000, 12345, 16384, 1e5, 1234567.8, 1e7, 1e8};
constexpr int kOuts = static_cast<int>(std::size(kOut));
constexpr int kAcross = 6;  // tiles, and cells of a mesh or field

class Random {
 public:
  explicit Random(std::uint64_t index) : state_(index * 0xD1342543DE82EF95ull + 1) {}
  double unit() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  int below(int n) { return static_cast<int>(unit() * n); }

 private:
  std::uint64_t state_;
};

struct V {
  double x[3];
};
V operator+(const V& a, const V& b) { return {a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}; }
V operator*(double s, const V& a) { return {s * a.x[0], s * a.x[1], s * a.x[2]}; }
double dot(const V& a, const V& b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
V scaled_to_one(const V& a) { return (1 / std::sqrt(dot(a, a))) * a; }
V any_direction(Random& r) {
  for (;;) {
    const V v{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)};
    if (dot(v, v) < 1 && dot(v, v) > 0.01) return scaled_to_one(v);
  }
}

void must(int32_t result, const carom_error& error) {
  if (result == CAROM_OK) return;
  std::fprintf(stderr, "%s\n", error.message);
  std::exit(2);
}

/// A shape and where it stands.
struct Standing {
  carom_shape shape;
  V at;
  double turned[4];
};

struct Place {
  carom_world* world = nullptr;
  std::vector<Standing> all, all_as_read;  // turned as given, and as the world says
};

constexpr double kUpright[4] = {0, 0, 0, 1};
/// Of a length that is off by as much as a host may be, or by rounding.
void any_turn(Random& r, double to[4]) {
  double sum = 0;
  do {
    sum = 0;
    for (int i = 0; i < 4; ++i) to[i] = r.between(-1, 1), sum += to[i] * to[i];
  } while (sum > 1 || sum < 0.01);
  const double length = (r.below(2) ? 1 : 1 + r.between(-9e-7, 9e-7)) / std::sqrt(sum);
  for (int i = 0; i < 4; ++i) to[i] *= length;
}

class Stage {
 public:
  Stage() {
    carom_error e = CAROM_ERROR_INIT;
    must(carom_engine_create(nullptr, &engine_, &e), e);
    for (const char* name : {"sphere", "capsule", "box", "cylinder", "cone", "ellipsoid", "hull"}) {
      carom_plugin plugin;
      must(carom_plugin_load(engine_, (std::string(CAROM_PLUGIN_DIR "/") + name + ".so").c_str(), &plugin, &e), e);
    }
    const double half[] = {0.5, 0.25, 0.5}, round[] = {0.5, 0.25}, ball[] = {0.5}, radii[] = {0.5, 0.25, 0.75};
    std::vector<double> corners;
    for (int k = 0; k < 8; ++k)
      for (int i = 0; i < 3; ++i) corners.push_back(k >> i & 1 ? half[i] : -half[i]);
    box = named("box", half, 3), hull = named("hull", corners.data(), 24), cylinder = named("cylinder", round, 2);
    cone = named("cone", round, 2), capsule = named("capsule", round, 2), sphere = named("sphere", ball, 1);
    ellipsoid = named("ellipsoid", radii, 3);
    cube = mesh_cube(half);
    for (const bool wavy : {false, true}) {
      field[wavy] = make_field(wavy);
      mesh[wavy] = make_mesh(wavy);
    }
    Random random(7);
    for (int o = 0; o < kOuts; ++o) {
      const double out = kOut[o];
      int k = 0;
      for (const carom_shape tile : {box, hull, cylinder, cube}) fill_tiles(tiles[o][k++], tile, out);
      k = 0;
      for (const carom_shape s : {mesh[0], mesh[1], field[0], field[1]}) {
        // Two chunks side by side: the border is a seam, too.
        for (const double x : {0.0, double(kAcross)}) stand(surfaces[o][k], s, {{out + x, 0, out}}, kUpright);
        ++k;
      }
      k = 0;
      for (const carom_shape s : {box, hull, cylinder, cone, capsule, sphere, ellipsoid, cube}) {
        stand(alone[o][0][k], s, {{out, out, -out}}, kUpright);
        double tilted[4];
        any_turn(random, tilted);
        stand(alone[o][1][k++], s, {{out, out, -out}}, tilted);
      }
    }
  }
  ~Stage() {
    const auto drop = [](Place& p) { carom_world_destroy(p.world, nullptr); };
    for (int o = 0; o < kOuts; ++o) {
      for (Place& p : tiles[o]) drop(p);
      for (Place& p : surfaces[o]) drop(p);
      for (auto& both : alone[o])
        for (Place& p : both) drop(p);
    }
    carom_engine_destroy(engine_, nullptr);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  static double height(bool wavy, int x, int z) {
    return wavy ? 0.3 * std::sin(1.0471975511965976 * (x % kAcross)) * std::cos(1.3 * z) : 0;  // two chunks go on
  }
  /// By the triangles themselves: cells are divided from corner to opposite corner.
  static double height_at(bool wavy, double x, double z) {
    const int i = std::min(static_cast<int>(x), kAcross - 1), k = std::min(static_cast<int>(z), kAcross - 1);
    const double u = x - i, v = z - k, h = height(wavy, i, k), far = height(wavy, i + 1, k + 1);
    return u > v ? h + (u - v) * (height(wavy, i + 1, k) - h) + v * (far - h)
                 : h + (v - u) * (height(wavy, i, k + 1) - h) + u * (far - h);
  }

  carom_engine* engine() const { return engine_; }
  carom_shape box, hull, cylinder, cone, capsule, sphere, ellipsoid, cube, mesh[2], field[2];
  Place tiles[kOuts][4], surfaces[kOuts][4], alone[kOuts][2][8];

 private:
  carom_shape named(const char* name, const double* params, std::uint64_t n) {
    carom_shape shape;
    carom_error e = CAROM_ERROR_INIT;
    must(carom_shape_create_named(engine_, name, params, n, &shape, &e), e);
    return shape;
  }
  carom_shape mesh_of(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles) {
    carom_mesh_desc d;
    carom_mesh_desc_init(&d, sizeof d);
    d.vertices = xyz.data(), d.vertex_count = xyz.size() / 3;
    d.triangles = triangles.data(), d.triangle_count = triangles.size() / 3;
    carom_shape shape;
    carom_error e = CAROM_ERROR_INIT;
    must(carom_shape_create_mesh(engine_, &d, &shape, &e), e);
    return shape;
  }
  carom_shape mesh_cube(const double half[3]) {
    std::vector<double> xyz;
    for (int k = 0; k < 8; ++k)
      for (int i = 0; i < 3; ++i) xyz.push_back(k >> i & 1 ? half[i] : -half[i]);
    return mesh_of(xyz, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                         2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
  }
  carom_shape make_mesh(bool wavy) {
    std::vector<double> xyz;
    std::vector<std::uint32_t> triangles;
    const auto n = std::uint32_t(kAcross + 1);
    for (int z = 0; z <= kAcross; ++z)
      for (int x = 0; x <= kAcross; ++x) xyz.insert(xyz.end(), {double(x), height(wavy, x, z), double(z)});
    for (std::uint32_t z = 0; z + 1 < n; ++z)
      for (std::uint32_t x = 0; x + 1 < n; ++x) {
        const std::uint32_t a = z * n + x;
        triangles.insert(triangles.end(), {a, a + n, a + n + 1, a, a + n + 1, a + 1});
      }
    return mesh_of(xyz, triangles);
  }
  carom_shape make_field(bool wavy) {
    std::vector<double> heights;
    for (int z = 0; z <= kAcross; ++z)
      for (int x = 0; x <= kAcross; ++x) heights.push_back(height(wavy, x, z));
    carom_height_field_desc d;
    carom_height_field_desc_init(&d, sizeof d);
    d.columns = d.rows = kAcross + 1, d.heights = heights.data();
    carom_shape shape;
    carom_error e = CAROM_ERROR_INIT;
    must(carom_shape_create_height_field(engine_, &d, &shape, &e), e);
    return shape;
  }
  void fill_tiles(Place& place, carom_shape tile, double out) {
    for (int x = 0; x < kAcross; ++x)
      for (int z = 0; z < kAcross; ++z) stand(place, tile, {{out + x + 0.5, -0.25, out + z + 0.5}}, kUpright);
  }
  void stand(Place& place, carom_shape shape, const V& at, const double turned[4]) {
    carom_error e = CAROM_ERROR_INIT;
    if (!place.world) must(carom_world_create(engine_, nullptr, &place.world, &e), e);
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    d.type = CAROM_BODY_STATIC;
    std::memcpy(d.position, at.x, sizeof d.position);
    std::memcpy(d.orientation, turned, sizeof d.orientation);
    carom_body body;
    must(carom_body_create(place.world, &d, &body, &e), e);
    carom_collider_desc c;
    carom_collider_desc_init(&c, sizeof c);
    c.shape = shape;
    carom_collider collider;
    must(carom_collider_create(place.world, body, &c, &collider, &e), e);
    Standing s{shape, at, {}};
    std::memcpy(s.turned, turned, sizeof s.turned);
    place.all.push_back(s);
    const carom_body* one = &body;
    must(carom_world_read(place.world, CAROM_FIELD_ORIENTATION, CAROM_SCALAR_F64, one, 1, s.turned, 0, &e), e);
    place.all_as_read.push_back(s);
  }

  carom_engine* engine_ = nullptr;
};

struct Case {
  const Place* place = nullptr;
  V origin, direction;
  double max = INFINITY;
  enum { any, hit, no_hit } want = any;
  double time = 0, within = 0;  // of a hit that is wanted
  char what[80];
};

V turn(const double q[4], const V& v) {
  const V u{q[0], q[1], q[2]};
  const auto cross = [](const V& a, const V& b) {
    return V{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]};
  };
  const V t = 2 * cross(u, v);
  return v + q[3] * t + cross(u, t);
}

/// At a place of a tiled floor: on a seam, at a corner where four tiles meet.
void aim_at_tiles(const Stage& stage, Random& r, Case& c) {
  const int o = r.below(kOuts), kind = r.below(4);
  c.place = &stage.tiles[o][kind];
  const double out = kOut[o], length = r.between(1, 20);
  const bool round = kind == 2;  // cylinders touch each other in the middle of their sides alone
  double x = 1 + r.below(kAcross - 1), z = r.below(kAcross) + 0.5;
  if (!round) z = r.below(2) ? 1 + r.below(kAcross - 1) : r.between(0.1, kAcross - 0.1);
  if (r.below(2)) std::swap(x, z);
  V down{{0, -1, 0}};
  // Slanted within the plane of the seam, or any way: into one tile or the other.
  const int slant = r.below(3);
  if (!round && slant == 1) {
    const double aside = r.between(-1, 1);
    down = scaled_to_one(x == std::floor(x) ? V{{0, -1, aside}} : V{{aside, -1, 0}});
  }
  if (!round && slant == 2) down = scaled_to_one({{r.between(-1, 1), -1, r.between(-1, 1)}});
  c.direction = down;
  const V top{{out + x, 0, out + z}};
  c.origin = top + -length * down;
  // The start's own place is rounded to where it is, and the tile's.
  c.want = Case::hit, c.time = length;
  c.within = (1e-9 + 8 * 0x1p-53 * (out + length)) / -down.x[1];
  std::snprintf(c.what, sizeof c.what, "tiles %d at %g", kind, out);
}

/// Between triangles of a mesh or field, and at the border of two of them.
void aim_at_surface(const Stage& stage, Random& r, Case& c) {
  const int o = r.below(kOuts), kind = r.below(4);
  const bool wavy = kind % 2;
  c.place = &stage.surfaces[o][kind];
  const double out = kOut[o], length = r.between(2, 20);
  double x = r.below(kAcross + 1), z = r.between(0.1, kAcross - 0.1);
  switch (r.below(4)) {
    case 0:
      std::swap(x, z);
      z = std::min(std::max(z, 1.0), kAcross - 1.0);
      break;
    case 1:
      z = 1 + r.below(kAcross - 1);
      break;
    case 2:  // on a diagonal
      x = z;
      break;
  }
  x = std::max(x, 0.05);
  V down{{0, -1, 0}};
  if (r.below(2)) down = scaled_to_one({{r.between(-0.3, 0.3), -1, r.between(-0.3, 0.3)}});
  // Far out what is given is rounded: no more than the place itself is known by.
  const V at{{out + x, Stage::height_at(wavy, x, z), out + z}};
  c.direction = down;
  c.origin = at + -length * down;
  c.want = Case::hit, c.time = length;
  // Slopes are below 1, so that a place off by so much aside is as much off along.
  c.within = 4 * (1e-9 + 8 * 0x1p-53 * (out + length));
  std::snprintf(c.what, sizeof c.what, "surface %d at %g", kind, out);
}

constexpr const char* kAloneNames[] = {"box",     "hull",   "cylinder",  "cone",
                                       "capsule", "sphere", "ellipsoid", "mesh cube"};

/// A point of the surface, and a normal of it there, in the shape's frame. @return false: it has several (an edge)
bool surface_point(int kind, Random& r, V& p, V& n) {
  const auto sign = [&] { return r.below(2) ? 1.0 : -1.0; };
  const double turned = r.between(0, 6.283185307179586), c = std::cos(turned), s = std::sin(turned);
  const double half[3] = {0.5, 0.25, 0.5};
  switch (kind) {
    case 0:
    case 1:
    case 7: {
      const int axis = r.below(3);
      n = {{0, 0, 0}};
      n.x[axis] = sign();
      for (int i = 0; i < 3; ++i) p.x[i] = i == axis ? n.x[i] * half[i] : r.between(-0.9, 0.9) * half[i];
      return true;
    }
    case 2:
      if (r.below(2)) return p = {{0.5 * c, r.between(-0.2, 0.2), 0.5 * s}}, n = {{c, 0, s}}, true;
      return n = {{0, sign(), 0}}, p = {{0.4 * c * r.unit(), 0.25 * n.x[1], 0.4 * s * r.unit()}}, true;
    case 3: {
      if (r.below(3) == 0) return n = {{0, -1, 0}}, p = {{0.4 * c, -0.25, 0.4 * s}}, true;
      const double share = r.between(0.1, 0.9);
      p = {{0.5 * share * c, 0.25 - 0.5 * share, 0.5 * share * s}};
      return n = scaled_to_one({{c, 1, s}}), true;
    }
    case 4:
      if (r.below(2)) return p = {{0.5 * c, r.between(-0.25, 0.25), 0.5 * s}}, n = {{c, 0, s}}, true;
      n = any_direction(r);
      return p = 0.5 * n + V{{0, n.x[1] < 0 ? -0.25 : 0.25, 0}}, true;
    case 5:
      n = any_direction(r);
      return p = 0.5 * n, true;
    default: {
      const V d = any_direction(r);
      const double radii[3] = {0.5, 0.25, 0.75};
      V out;
      for (int i = 0; i < 3; ++i) p.x[i] = radii[i] * d.x[i], out.x[i] = d.x[i] / radii[i];
      n = scaled_to_one(out);
      return true;
    }
  }
}

/// At edges, corners and tips, along sides, and from a surface out, in and along.
void aim_at_one(const Stage& stage, Random& r, Case& c) {
  const int o = r.below(kOuts), tilted = r.below(2), kind = r.below(8);
  c.place = &stage.alone[o][tilted][kind];
  const Standing& it = c.place->all_as_read[0];
  const double out = kOut[o], length = r.between(1, 10);
  const double blur = 64 * 0x1p-53 * (1 + 2 * out);  // m: of places out there, turned
  V p, n;
  surface_point(kind, r, p, n);
  const int way = r.below(6);
  V from = p, along = any_direction(r);
  if (way < 3) {
    const bool edged = kind != 5 && kind != 6 && kind != 4;
    if (way == 0 && edged) {  // to an edge or corner
      const double turned = r.between(0, 6.283185307179586);
      if (kind == 2 || kind == 3) {
        p = {{0.5 * std::cos(turned), kind == 3 || r.below(2) ? -0.25 : 0.25, 0.5 * std::sin(turned)}};
        if (kind == 3 && r.below(3) == 0) p = {{0, 0.25, 0}};
      } else {
        p = {{r.below(2) ? 0.5 : -0.5, r.below(2) ? 0.25 : -0.25, r.below(2) ? 0.5 : r.between(-0.5, 0.5)}};
      }
    } else if (way == 1 && (kind < 3 || kind == 7)) {  // straight down a side, at a tile's place
      const double turned = r.between(0, 6.283185307179586);
      p = kind == 2 ? V{{0.5, 0.25, 0}} : V{{0.5, 0.25, r.between(-0.5, 0.5)}};
      if (kind == 2 && r.below(2)) p = {{0.5 * std::cos(turned), 0.25, 0.5 * std::sin(turned)}};
      if (kind != 2 && r.below(4) == 0) p.x[2] = 0.5;
      along = {{0, -1, 0}};
      // Off by rounding it may pass a round side, or a turned one; a flat one that stands straight it meets.
      if (!tilted && (kind != 2 || p.x[2] == 0)) c.want = Case::hit, c.time = length, c.within = 1e-9 + blur;
    } else if (way == 2) {  // a tangent
      const double across = dot(along, n);
      along = scaled_to_one(along + -across * n);
    }
    from = p + -length * along;
    std::snprintf(c.what, sizeof c.what, "%s%s at %g, edge or side %d", tilted ? "turned " : "", kAloneNames[kind], out,
                  way);
  } else {
    const double across = dot(along, n);
    if (way == 3) {  // outwards
      if (std::fabs(across) < 0.05) along = n;
      if (across < 0) along = along + -2 * across * n;
      along = scaled_to_one(along);
      c.want = Case::no_hit;
    } else if (way == 4) {  // inwards
      if (std::fabs(across) < 0.2) along = -1.0 * n;
      if (across > 0) along = along + -2 * across * n;
      along = scaled_to_one(along);
      c.want = Case::hit, c.time = 0, c.within = 8 * blur + 1e-12;  // three times slack over the sine of the angle, 0.2
    } else {  // along: where the surface is flat it must not be met; and a round one curves away
      along = scaled_to_one(along + -across * n);
      if (!tilted) c.want = Case::no_hit;
      if (kind == 3 || kind == 4 || kind == 2) c.want = Case::any;  // straight lines of what is round: off by rounding
      if (kind < 2 || kind == 7) {
        for (int i = 0; i < 3; ++i)
          if (n.x[i] != 0) along.x[i] = 0;
        along = scaled_to_one(along);
      }
    }
    std::snprintf(c.what, sizeof c.what, "%s%s at %g, from the surface %d", tilted ? "turned " : "", kAloneNames[kind],
                  out, way);
  }
  c.origin = it.at + turn(it.turned, from);
  c.direction = turn(it.turned, along);
}

/// @return  what is wrong; empty: nothing
std::string judge(const Stage& stage, const Case& c, bool show) {
  char text[400];
  const auto say = [&](const char* what, double a, double b) {
    std::snprintf(text, sizeof text, "%s: %s: %.17g, %.17g", c.what, what, a, b);
    return std::string(text);
  };
  carom_error e = CAROM_ERROR_INIT;
  carom_world_hit hit, batch;
  must(carom_world_cast_ray(c.place->world, c.origin.x, c.direction.x, c.max, nullptr, &hit, sizeof hit, &e), e);
  if (show) {
    const auto three = [](const char* name, const double* x) {
      std::printf("%s %.17g %.17g %.17g\n", name, x[0], x[1], x[2]);
    };
    three("from", c.origin.x), three("along", c.direction.x), three("normal", hit.normal);
    std::printf("%s: outcome %u at %.17g in [%.17g, %.17g]; wanted %d at %.17g\n", c.what, hit.outcome, hit.time,
                hit.lower, hit.upper, int(c.want), c.time);
  }
  // Each alone: the first of them is what the world says.
  for (const std::vector<Standing>* standing : {&c.place->all, &c.place->all_as_read}) {
    carom_cast best = {};
    best.time = best.lower = c.max, best.upper = INFINITY;
    for (const Standing& s : *standing) {
      carom_cast one = {};
      one.struct_size = sizeof one;
      must(carom_ray_cast(stage.engine(), s.shape, s.at.x, s.turned, c.origin.x, c.direction.x, c.max, nullptr, &one,
                          &e),
           e);
      if (one.outcome == CAROM_CAST_UNDECIDED) return say("undecided alone", one.time, one.upper);
      if (one.outcome != CAROM_CAST_MISS && (best.outcome == CAROM_CAST_MISS || one.time < best.time)) best = one;
    }
    if (hit.outcome != best.outcome || hit.time != best.time || hit.lower != best.lower || hit.upper != best.upper ||
        std::memcmp(hit.normal, best.normal, sizeof hit.normal) != 0 ||
        std::memcmp(hit.point, best.point_b, sizeof hit.point) != 0)
      return say("engine and world differ", best.time, hit.time);
  }
  carom_rays rays = {};
  rays.struct_size = sizeof rays, rays.scalar = CAROM_SCALAR_F64, rays.count = 1;
  rays.origins = c.origin.x, rays.directions = c.direction.x, rays.max = &c.max;
  carom_world_hits hits = {};
  hits.struct_size = sizeof hits, hits.scalar = CAROM_SCALAR_F64, hits.records = &batch;
  must(carom_world_cast_rays(c.place->world, &rays, CAROM_WANT_FIRST, nullptr, &hits, &e), e);
  if (std::memcmp(&hit, &batch, sizeof hit) != 0) return say("a batch differs", hit.time, batch.time);
  std::uint32_t outcome = 0;
  carom_world_hits few = {};
  few.struct_size = sizeof few, few.scalar = CAROM_SCALAR_F64, few.outcomes = &outcome;
  must(carom_world_cast_rays(c.place->world, &rays, CAROM_WANT_ANY, nullptr, &few, &e), e);
  if ((outcome != CAROM_CAST_MISS) != (hit.outcome != CAROM_CAST_MISS)) return say("any differs", outcome, hit.outcome);

  if (hit.outcome != CAROM_CAST_MISS) {
    const V n{{hit.normal[0], hit.normal[1], hit.normal[2]}};
    if (!(hit.lower <= hit.time && hit.time <= hit.upper && hit.lower >= 0))
      return say("bracket", hit.lower, hit.upper);
    if (!(std::fabs(dot(n, n) - 1) < 1e-12)) return say("normal", dot(n, n), 1);
    if (!(dot(n, c.direction) >= -1e-7)) return say("normal along the ray", dot(n, c.direction), 0);
    if (!std::isfinite(hit.upper)) return say("no upper end", hit.time, hit.upper);
  }
  if (c.want == Case::no_hit && hit.outcome != CAROM_CAST_MISS) return say("hit", hit.outcome, hit.time);
  if (c.want != Case::hit) return "";
  if (hit.outcome == CAROM_CAST_MISS) return say("missed", c.time, hit.time);
  if (!(std::fabs(hit.time - c.time) <= c.within)) return say("time", hit.time, c.time);
  return "";
}

std::string try_one(const Stage& stage, std::uint64_t index, bool show) {
  Random r(index);
  Case c;
  switch (r.below(3)) {
    case 0:
      aim_at_tiles(stage, r, c);
      break;
    case 1:
      aim_at_surface(stage, r, c);
      break;
    default:
      aim_at_one(stage, r, c);
  }
  return judge(stage, c, show);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t from = 0, count = 0;
  const Stage stage;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string key = argv[i];
    const std::uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (key == "--count") count = value;
    if (key == "--from") from = value;
    if (key == "--show") return std::printf("%s\n", try_one(stage, value, true).c_str()), 0;
  }
  if (count == 0) {
    std::fprintf(stderr, "usage: fuzz_rays_campaign --count N [--from K] | --show K\n");
    return 2;
  }
  std::uint64_t bad = 0;
  for (std::uint64_t i = from; i < from + count && bad < 20; ++i) {
    const std::string complaint = try_one(stage, i, false);
    if (complaint.empty()) continue;
    ++bad;
    std::fprintf(stderr, "VIOLATION in ray %llu: %s\n", static_cast<unsigned long long>(i), complaint.c_str());
  }
  std::printf("%llu rays: %s\n", static_cast<unsigned long long>(count), bad ? "VIOLATIONS" : "no violation");
  return bad ? 1 : 0;
}

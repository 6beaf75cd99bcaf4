// Rays, moving shapes, times of impact and overlap at given poses, without a world.
#include <carom/cast.h>
#include <carom/dial.h>

#include <optional>

#include "abi/columns.h"
#include "abi/engine.h"
#include "core/float_scope.h"
#include "collision/cast/overlap.h"
#include "collision/cast/ray.h"
#include "collision/cast/rounding.h"
#include "collision/cast/shape_cast.h"
#include "collision/cast/time_of_impact.h"
#include "collision/scenery/ask.h"
#include "dynamics/dials.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(CastOutcome::miss) == CAROM_CAST_MISS &&
              static_cast<std::uint32_t>(CastOutcome::hit) == CAROM_CAST_HIT &&
              static_cast<std::uint32_t>(CastOutcome::overlap) == CAROM_CAST_OVERLAP &&
              static_cast<std::uint32_t>(CastOutcome::undecided) == CAROM_CAST_UNDECIDED);
static_assert(static_cast<std::uint32_t>(Overlap::apart) == CAROM_OVERLAP_APART &&
              static_cast<std::uint32_t>(Overlap::overlapping) == CAROM_OVERLAP_OVERLAPPING &&
              static_cast<std::uint32_t>(Overlap::touching) == CAROM_OVERLAP_TOUCHING &&
              static_cast<std::uint32_t>(Overlap::fault) == CAROM_OVERLAP_FAULT);

/// Take in a descriptor, or the defaults.
bool read_desc(Call& call, int argument, const carom_cast_desc* given, CastSettings& settings) {
  carom_cast_desc d;
  carom_cast_desc_init(&d, sizeof d);
  if ((given && !read_struct(call, argument, "desc", given, d)) ||
      !only_bits(call, argument, "desc->flags", d.flags, CAROM_ASK_GENERIC | CAROM_ASK_IGNORE_TOUCHED) ||
      !only_bits(call, argument, "desc->reserved", d.reserved, 0) ||
      !take_settings(call, argument, d.iterations, d.tolerance, d.target, settings))
    return false;
  settings.routines = !(d.flags & CAROM_ASK_GENERIC);
  settings.ignore_touched = d.flags & CAROM_ASK_IGNORE_TOUCHED;
  return true;
}

/// A shape and where it stands, as arguments of a call.
bool take_placed(Call& call, ShapePin& pin, int argument, const char* const names[3], carom_shape shape,
                 const double* position, const double* orientation, bool convex = false) {
  return (convex ? pin.take_convex(call, argument, names[0], shape) : pin.take(call, argument, names[0], shape)) &&
         finite(call, argument + 1, names[1], position, 3) && unit(call, argument + 2, names[2], orientation, 4);
}
constexpr const char* kOne[3] = {"shape", "position", "orientation"};
constexpr const char* kA[3] = {"shape_a", "position_a", "orientation_a"};
constexpr const char* kB[3] = {"shape_b", "position_b", "orientation_b"};

bool flat(const Shape& s) { return s.form == Form::half_space; }

bool one_is_solid(Call& call, int argument, const Shape& a, const Shape& b) {
  if (!one_is_convex(call, argument, a, b)) return false;
  return !flat(a) || !flat(b) ||
         call.fail(CAROM_E_UNSUPPORTED, argument, "two half-spaces: unless parallel they overlap without end");
}

Frame frame_of(const double position[3], const double orientation[4]) {
  return Frame(Pose{to_quat(orientation), to_vec3(position)});
}

void write_cast(const CastResult& r, carom_cast* result) {
  carom_cast out{};
  out.outcome = static_cast<std::uint32_t>(r.outcome);
  out.status = static_cast<std::uint32_t>(r.status);
  out.iterations = static_cast<std::uint32_t>(r.iterations);
  out.time = r.time;
  out.lower = r.lower;
  out.upper = r.upper;
  out.separation = r.separation;
  out.slack = r.slack;
  write_finite(r.normal, out.normal);
  write_finite(r.point_a, out.point_a);
  write_finite(r.point_b, out.point_b);
  out.support_calls = static_cast<std::uint32_t>(r.support_calls);
  write_struct(out, result);
}

bool read_motion(Call& call, int argument, const char* name, const carom_motion* given, const Shape& shape,
                 RigidMotion& motion) {
  carom_motion m;
  carom_motion_init(&m, sizeof m);
  if (!read_struct(call, argument, name, given, m) || !only_bits(call, argument, name, m.reserved, 0) ||
      !finite(call, argument, name, m.position, 3) || !unit(call, argument, name, m.orientation, 4) ||
      !finite(call, argument, name, m.center, 3) || !finite(call, argument, name, m.linear_velocity, 3) ||
      !finite(call, argument, name, m.angular_velocity, 3))
    return false;
  motion.at = {to_quat(m.orientation), to_vec3(m.position)};
  motion.centre = motion.at.apply(to_vec3(m.center));
  motion.velocity = to_vec3(m.linear_velocity);
  motion.omega = to_vec3(m.angular_velocity);
  return !flat(shape) || motion.omega.is_zero() ||
         call.fail(CAROM_E_UNSUPPORTED, argument, "%s turns a half-space: it sweeps over everything", name);
}

/// Shapes that cannot be destroyed as long as this lives.
class Pins {
 public:
  explicit Pins(carom_engine& engine) : engine_(engine), placed_(&engine.memory) {}
  ~Pins() {
    for (const Placed& p : placed_) unuse_shape(engine_, *p.shape);
  }
  Pins(const Pins&) = delete;
  Pins& operator=(const Pins&) = delete;

  bool take(Call& call, const carom_shape* shapes, const double* positions, const double* orientations,
            std::uint64_t n) {
    if (n >= CAROM_NO_SHAPE) return call.fail(CAROM_E_LIMIT, 5, "%llu shapes", static_cast<unsigned long long>(n));
    placed_.reserve(n);
    for (std::uint64_t i = 0; i < n; ++i) {
      ShapePin pin(engine_);
      if (!finite(call, 3, "a position of positions", positions + 3 * i, 3) ||
          !unit(call, 4, "an orientation of orientations", orientations + 4 * i, 4) ||
          !pin.take_convex(call, 2, "a shape of shapes", shapes[i]))
        return false;
      placed_.push_back({&*pin, frame_of(positions + 3 * i, orientations + 4 * i)});
      pin.keep();
    }
    return true;
  }
  std::span<const Placed> get() const { return placed_; }

 private:
  carom_engine& engine_;
  Array<Placed> placed_;
};

/// The arrays of a batch.
struct Batch {
  RayColumns rays;
  std::uint32_t scalar_out = 0;
  Column records, outcomes, shapes, times, normals, points;

  bool read(Call& call, const carom_ray_hits* given) {
    carom_ray_hits h{};
    if (!read_struct(call, 8, "hits", given, h) || !known(call, 8, "hits->scalar", h.scalar, CAROM_SCALAR_F64 + 1))
      return false;
    scalar_out = h.scalar;
    const std::uint64_t one = bytes(scalar_out);
    // A record may be cut short: an older header's.
    if (!h.record_stride) h.record_stride = sizeof(carom_ray_hit);
    return make_column(call, 8, "hits->records", h.records, h.record_stride, kSmallestStruct, rays.count, records) &&
           make_column(call, 8, "hits->outcomes", h.outcomes, h.outcome_stride, 4, rays.count, outcomes) &&
           make_column(call, 8, "hits->shapes", h.shapes, h.shape_stride, 4, rays.count, shapes) &&
           make_column(call, 8, "hits->times", h.times, h.time_stride, one, rays.count, times) &&
           make_column(call, 8, "hits->normals", h.normals, h.normal_stride, 3 * one, rays.count, normals) &&
           make_column(call, 8, "hits->points", h.points, h.point_stride, 3 * one, rays.count, points);
  }

  void write(std::uint64_t i, const carom_ray_hit& hit) const {
    if (records.at) write_element(hit, records.at, i, records.stride);
    outcomes.put(i, &hit.outcome, 4);
    shapes.put(i, &hit.shape, 4);
    if (times.at) store<1>(times, scalar_out, i, &hit.time);
    if (normals.at) store<3>(normals, scalar_out, i, hit.normal);
    if (points.at) store<3>(points, scalar_out, i, hit.point);
  }
};

carom_ray_hit cast_one(const Batch& batch, std::uint64_t i, std::span<const Placed> shapes,
                       const CastSettings& settings) {
  carom_ray_hit hit{};
  hit.shape = CAROM_NO_SHAPE;
  Ray ray;
  if (!batch.rays.get(i, ray)) {
    hit.outcome = CAROM_CAST_BAD_RAY;
    return hit;
  }
  CastResult r;
  SupportFault fault;
  const int met = cast_ray(ray, shapes, settings, r, fault);
  hit.outcome = static_cast<std::uint32_t>(r.outcome);
  hit.status = static_cast<std::uint32_t>(r.status);
  if (met >= 0) hit.shape = static_cast<std::uint32_t>(met);
  hit.time = r.time;
  hit.lower = r.lower;
  hit.upper = r.upper;
  if (met >= 0) {
    write_finite(r.normal, hit.normal);
    write_finite(r.point_b, hit.point);
  }
  return hit;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_cast_desc_init(carom_cast_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_cast_desc& d) {
    d.iterations = static_cast<std::uint32_t>(CastSettings().cap);
    d.tolerance = CastSettings().tolerance;
  });
}

int32_t carom_motion_init(carom_motion* motion, uint32_t struct_size) {
  return init_struct(motion, struct_size, [](carom_motion& d) { d.orientation[3] = 1; });
}

int32_t carom_ray_cast(carom_engine* engine, carom_shape shape, const double position[3], const double orientation[4],
                       const double origin[3], const double direction[3], double max, const carom_cast_desc* desc,
                       carom_cast* result, carom_error* error) {
  return guarded(error, [&](Call& call) {
    CastSettings settings;
    if (!present(call, 1, "engine", engine)) return;
    ShapePin pin(*engine);
    if (!take_placed(call, pin, 2, kOne, shape, position, orientation) ||
        !carom::abi::finite(call, 5, "origin", origin, 3) || !carom::abi::finite(call, 6, "direction", direction, 3) ||
        !not_negative(call, 7, "max", max) || !read_desc(call, 8, desc, settings) ||
        !fillable(call, 9, "result", result))
      return;
    const FloatScope scope;
    CastResult found;
    SupportFault fault;
    any_shape::cast_ray(Ray{to_vec3(origin), to_vec3(direction), max}, *pin, frame_of(position, orientation), settings,
                        found, fault);
    write_cast(found, result);
  });
}

int32_t carom_shape_cast(carom_engine* engine, carom_shape shape_a, const double position_a[3],
                         const double orientation_a[4], const double motion[3], carom_shape shape_b,
                         const double position_b[3], const double orientation_b[4], const carom_cast_desc* desc,
                         carom_cast* result, carom_error* error) {
  return guarded(error, [&](Call& call) {
    CastSettings settings;
    if (!present(call, 1, "engine", engine)) return;
    ShapePin a(*engine), b(*engine);
    if (!take_placed(call, a, 2, kA, shape_a, position_a, orientation_a, true) ||
        !carom::abi::finite(call, 5, "motion", motion, 3) ||
        !take_placed(call, b, 6, kB, shape_b, position_b, orientation_b) || !one_is_solid(call, 6, *a, *b) ||
        !read_desc(call, 9, desc, settings) || !fillable(call, 10, "result", result))
      return;
    const FloatScope scope;
    CastResult found;
    SupportFault fault;
    any_shape::cast_shape(*a, frame_of(position_a, orientation_a), to_vec3(motion), *b,
                          frame_of(position_b, orientation_b), settings, found, fault);
    write_cast(found, result);
  });
}

int32_t carom_shape_time_of_impact(carom_engine* engine, carom_shape shape_a, const carom_motion* motion_a,
                                   carom_shape shape_b, const carom_motion* motion_b, double duration,
                                   const carom_cast_desc* desc, carom_cast* result, carom_error* error) {
  return guarded(error, [&](Call& call) {
    CastSettings settings;
    RigidMotion of_a, of_b;
    if (!present(call, 1, "engine", engine)) return;
    ShapePin a(*engine), b(*engine);
    const FloatScope scope;
    if (!a.take_convex(call, 2, "shape_a", shape_a) || !read_motion(call, 3, "motion_a", motion_a, *a, of_a) ||
        !b.take(call, 4, "shape_b", shape_b) || !read_motion(call, 5, "motion_b", motion_b, *b, of_b) ||
        !one_is_solid(call, 4, *a, *b) || !in_range(call, 6, "duration", duration, 0, kLongest) ||
        !read_desc(call, 7, desc, settings) || !fillable(call, 8, "result", result))
      return;
    CastResult found;
    SupportFault fault;
    any_shape::time_of_impact(*a, of_a, *b, of_b, duration, settings, found, fault);
    write_cast(found, result);
  });
}

int32_t carom_shape_overlap(carom_engine* engine, carom_shape shape_a, const double position_a[3],
                            const double orientation_a[4], carom_shape shape_b, const double position_b[3],
                            const double orientation_b[4], const carom_cast_desc* desc, carom_overlap* result,
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    CastSettings settings;
    if (!present(call, 1, "engine", engine)) return;
    ShapePin a(*engine), b(*engine);
    if (!take_placed(call, a, 2, kA, shape_a, position_a, orientation_a) ||
        !take_placed(call, b, 5, kB, shape_b, position_b, orientation_b) || !one_is_solid(call, 5, *a, *b) ||
        !read_desc(call, 8, desc, settings) || !fillable(call, 9, "result", result))
      return;
    const FloatScope scope;
    const Frame frame_a = frame_of(position_a, orientation_a), frame_b = frame_of(position_b, orientation_b);
    SupportFault fault;
    const OverlapResult found = any_shape::overlap(*a, *b, relative(frame_a, frame_b), settings.target,
                                                   kPoseRounding * kUnitRoundoff, settings.cap, fault);
    carom_overlap out{};
    out.outcome = static_cast<std::uint32_t>(found.outcome);
    out.separation_bound = found.separation_bound;
    write_finite(frame_a.rotate(found.normal), out.normal);
    write_finite(frame_a.apply(found.point), out.point);
    out.slack = found.slack;
    out.support_calls = static_cast<std::uint32_t>(found.support_calls);
    write_struct(out, result);
  });
}

int32_t carom_rays_cast(carom_engine* engine, const carom_shape* shapes, const double* positions,
                        const double* orientations, uint64_t shape_count, const carom_rays* rays,
                        const carom_cast_desc* desc, const carom_ray_hits* hits, carom_error* error) {
  return guarded(error, [&](Call& call) {
    CastSettings settings;
    Batch batch;
    if (!present(call, 1, "engine", engine)) return;
    if (shape_count && (!present(call, 2, "shapes", shapes) || !present(call, 3, "positions", positions) ||
                        !present(call, 4, "orientations", orientations)))
      return;
    if (!batch.rays.read(call, 6, rays) || !read_desc(call, 7, desc, settings) || !batch.read(call, hits)) return;
    const FloatScope scope;
    Pins pins(*engine);
    if (!pins.take(call, shapes, positions, orientations, shape_count)) return;
    for (std::uint64_t i = 0; i < batch.rays.count; ++i) batch.write(i, cast_one(batch, i, pins.get(), settings));
  });
}

}  // extern "C"

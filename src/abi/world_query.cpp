// Questions to a world: rays, moving shapes, overlap, nearest; one by one or in batches.
#include <carom/world_query.h>

#include "abi/columns.h"
#include "core/float_scope.h"
#include "abi/world.h"
#include "dynamics/query/index.h"
#include "dynamics/query/query.h"

namespace carom::abi {
namespace {

/// Take in a descriptor, or the defaults.
bool read_desc(Call& call, int argument, const World& world, const carom_query_desc* given, QueryOptions& options) {
  carom_query_desc d;
  carom_query_desc_init(&d, sizeof d);
  if ((given && !read_struct(call, argument, "desc", given, d)) ||
      !only_bits(call, argument, "desc->flags", d.flags,
                 CAROM_ASK_GENERIC | CAROM_ASK_SENSORS | CAROM_ASK_IGNORE_TOUCHED) ||
      !only_bits(call, argument, "desc->reserved", d.reserved, 0) ||
      (d.ignore != CAROM_NULL_HANDLE && !resolve(call, argument, "desc->ignore", world.scene.bodies, d.ignore)) ||
      !take_settings(call, argument, d.iterations, d.tolerance, d.target, options.cast))
    return false;
  options.cast.routines = !(d.flags & CAROM_ASK_GENERIC);
  options.cast.ignore_touched = d.flags & CAROM_ASK_IGNORE_TOUCHED;
  options.filter.sensors = d.flags & CAROM_ASK_SENSORS;
  options.filter.category = d.category;
  options.filter.mask = d.mask;
  if (d.ignore != CAROM_NULL_HANDLE) options.filter.ignore = handle_slot(d.ignore);
  return true;
}

carom_world_hit hit_of(const World& world, std::uint64_t query, const WorldHit& hit) {
  const CastResult& r = hit.cast;
  carom_world_hit out{};
  out.outcome = static_cast<std::uint32_t>(r.outcome);
  out.status = static_cast<std::uint32_t>(r.status);
  out.query = query;
  if (hit.collider != kInvalid) {
    out.collider = world.scene.collider_slots.handle(hit.collider);
    out.body = world.scene.bodies.handle(world.scene.colliders.body[hit.collider]);
  }
  out.time = r.time;
  out.lower = r.lower;
  out.upper = r.upper;
  out.separation = r.separation;
  if (r.status == QueryStatus::fault) return out;
  write_finite(r.normal, out.normal);
  write_finite(r.point_b, out.point);
  write_finite(r.point_a, out.point_own);
  return out;
}

carom_world_hit bad_ray(std::uint64_t query) {
  carom_world_hit out{};
  out.outcome = CAROM_CAST_BAD_RAY;
  out.query = query;
  return out;
}

carom_world_hit cast_one(const World& world, const RayColumns& rays, std::uint64_t i, std::uint32_t want,
                         const QueryOptions& options) {
  Ray ray;
  if (!rays.get(i, ray)) return bad_ray(i);
  return hit_of(
      world, i,
      want == CAROM_WANT_FIRST ? cast_ray(world, ray, options) : WorldHit{kInvalid, any_on_ray(world, ray, options)});
}

/// Where the one result of each ray goes.
struct HitColumns {
  std::uint32_t scalar = 0;
  Column records, outcomes, colliders, times, normals, points;

  bool read(Call& call, int argument, const carom_world_hits* given, std::uint64_t n) {
    carom_world_hits h{};
    if (!read_struct(call, argument, "hits", given, h) ||
        !known(call, argument, "hits->scalar", h.scalar, CAROM_SCALAR_F64 + 1))
      return false;
    scalar = h.scalar;
    const std::uint64_t one = bytes(scalar);
    if (!h.record_stride) h.record_stride = sizeof(carom_world_hit);  // a shorter one gets a prefix
    return make_column(call, argument, "hits->records", h.records, h.record_stride, kSmallestStruct, n, records) &&
           make_column(call, argument, "hits->outcomes", h.outcomes, h.outcome_stride, 4, n, outcomes) &&
           make_column(call, argument, "hits->colliders", h.colliders, h.collider_stride, 8, n, colliders) &&
           make_column(call, argument, "hits->times", h.times, h.time_stride, one, n, times) &&
           make_column(call, argument, "hits->normals", h.normals, h.normal_stride, 3 * one, n, normals) &&
           make_column(call, argument, "hits->points", h.points, h.point_stride, 3 * one, n, points);
  }

  void write(std::uint64_t i, const carom_world_hit& hit) const {
    if (records.at) write_element(hit, records.at, i, records.stride);
    outcomes.put(i, &hit.outcome, 4);
    colliders.put(i, &hit.collider, 8);
    if (times.at) store<1>(times, scalar, i, &hit.time);
    if (normals.at) store<3>(normals, scalar, i, hit.normal);
    if (points.at) store<3>(points, scalar, i, hit.point);
  }
};

/// Where all results go: as many as fit are written, all are counted.
class HitList {
 public:
  HitList(carom_world_hit* dst, std::uint64_t stride, std::uint64_t capacity)
      : dst_(dst), stride_(stride), capacity_(capacity) {}

  /// @param first  1-based position of dst; stride and capacity follow
  bool check(Call& call, int first, const std::uint64_t* count) const {
    if ((capacity_ && !present(call, first, "dst", dst_)) || !present(call, first + 3, "count", count)) return false;
    return !capacity_ || element_stride<carom_world_hit>(call, first + 1, stride_);
  }
  void add(const carom_world_hit& hit) {
    if (count_ < capacity_) write_element(hit, dst_, count_, stride_);
    ++count_;
  }
  std::uint64_t count() const { return count_; }

 private:
  carom_world_hit* dst_;
  std::uint64_t stride_, capacity_, count_ = 0;
};

/// One result each into an array of records. A stride of 0 becomes a record's size.
bool check_records(Call& call, int argument, std::uint64_t n, const carom_world_hit* dst, std::uint64_t& stride) {
  if (n && !present(call, argument, "dst", dst)) return false;
  if (!stride) stride = sizeof(carom_world_hit);
  return element_stride<carom_world_hit>(call, argument + 1, stride) &&
         spans(call, argument + 1, 2, n, stride, kSmallestStruct);
}

std::int32_t point_support(void*, const double*, std::uint64_t, const double*, double* out) {
  out[0] = out[1] = out[2] = 0;
  return 0;
}

/// The shapes that ask, which cannot be destroyed as long as this lives.
class QueryShapes {
 public:
  explicit QueryShapes(carom_engine& engine)
      : engine_(engine),
        dot_(&engine.memory),
        pinned_(&engine.memory),
        query_shapes_(&engine.memory),
        motions_(&engine.memory) {
    dot_.form = Form::sphere;
    dot_.support = point_support;
    dot_.bounds = {Vec3::zero(), Vec3::zero()};
  }
  ~QueryShapes() {
    for (const Shape* shape : pinned_) unuse_shape(engine_, *shape);
  }
  QueryShapes(const QueryShapes&) = delete;
  QueryShapes& operator=(const QueryShapes&) = delete;

  /// @param moving  motions are wanted
  bool take(Call& call, const carom_query_shapes* given, bool moving) {
    carom_query_shapes s{};
    Column shapes, positions, orientations, motions;
    if (!read_struct(call, 2, "shapes", given, s) ||
        !known(call, 2, "shapes->scalar", s.scalar, CAROM_SCALAR_F64 + 1) ||
        (s.count && (!present(call, 2, "shapes->positions", s.positions) ||
                     (moving && !present(call, 2, "shapes->motions", s.motions)))))
      return false;
    const std::uint64_t one = bytes(s.scalar);
    if (!make_column(call, 2, "shapes->shapes", s.shapes, s.shape_stride, 8, s.count, shapes) ||
        !make_column(call, 2, "shapes->positions", s.positions, s.position_stride, 3 * one, s.count, positions) ||
        !make_column(call, 2, "shapes->orientations", s.orientations, s.orientation_stride, 4 * one, s.count,
                     orientations) ||
        !make_column(call, 2, "shapes->motions", s.motions, s.motion_stride, 3 * one, s.count, motions))
      return false;
    query_shapes_.reserve(s.count);
    if (moving) motions_.reserve(s.count);
    carom_shape last = CAROM_NULL_HANDLE;
    const Shape* shape = &dot_;
    for (std::uint64_t i = 0; i < s.count; ++i) {
      double position[3], orientation[4] = {0, 0, 0, 1}, motion[3];
      load<3>(positions, s.scalar, i, position);
      if (orientations.at) load<4>(orientations, s.scalar, i, orientation);
      if (!finite(call, 2, "a position of shapes", position, 3) ||
          !unit(call, 2, "an orientation of shapes", orientation, 4))
        return false;
      carom_shape handle = CAROM_NULL_HANDLE;
      if (shapes.at) std::memcpy(&handle, shapes.at + i * shapes.stride, sizeof handle);
      if (handle != last && !pin(call, handle, shape)) return false;
      last = handle;
      query_shapes_.push_back({shape, Frame(Pose{to_quat(orientation), to_vec3(position)})});
      if (!moving) continue;
      load<3>(motions, s.scalar, i, motion);
      if (!finite(call, 2, "a motion of shapes", motion, 3)) return false;
      motions_.push_back(to_vec3(motion));
    }
    return true;
  }
  std::uint64_t size() const { return query_shapes_.size(); }
  const QueryShape& operator[](std::uint64_t i) const { return query_shapes_[i]; }
  const Vec3& motion(std::uint64_t i) const { return motions_[i]; }

 private:
  bool pin(Call& call, carom_shape handle, const Shape*& shape) {
    if (handle == CAROM_NULL_HANDLE) {
      shape = &dot_;
      return true;
    }
    pinned_.reserve(pinned_.size() + 1);  // so that what is pinned is also noted
    ShapePin pin(engine_);
    if (!pin.take_convex(call, 2, "a shape of shapes", handle)) return false;
    if (pin->form == Form::half_space)
      return call.fail(CAROM_E_UNSUPPORTED, 2, "a half-space asks: it can be met, not cast or placed");
    pinned_.push_back(&*pin);
    pin.keep();
    shape = pinned_.back();
    return true;
  }

  carom_engine& engine_;
  Shape dot_;
  Array<const Shape*> pinned_;
  Array<QueryShape> query_shapes_;
  Array<Vec3> motions_;
};

/// Questions with any number of results each: ask(i, hits) for all i. Whatever memory that takes is taken before the
/// first result is written.
template <class Ask>
void list_all(const Reading& world, std::uint64_t n, HitList& list, Ask&& ask) {
  Array<WorldHit> hits(&world.engine().memory);
  hits.reserve(world->scene.colliders.live.size() + 1);
  world->queries->bring_up_to_date(*world);
  for (std::uint64_t i = 0; i < n; ++i) {
    hits.clear();
    if (!ask(i, hits)) list.add(bad_ray(i));
    for (const WorldHit& hit : hits) list.add(hit_of(*world, i, hit));
  }
}

/// A whole call of that kind, of shapes: ask(world, query shapes, i, options, hits).
/// @param moving  shapes have motions
template <class Ask>
std::int32_t list_of_shapes(carom_world* world, const carom_query_shapes* shapes, bool moving,
                            const carom_query_desc* desc, HitList list, std::uint64_t* count, carom_error* error,
                            Ask&& ask) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    QueryOptions options;
    QueryShapes query_shapes(reading.engine());
    if (!query_shapes.take(call, shapes, moving) || !read_desc(call, 3, *reading, desc, options) ||
        !list.check(call, 4, count))
      return;
    list_all(reading, query_shapes.size(), list, [&](std::uint64_t i, Array<WorldHit>& found) {
      ask(*reading, query_shapes, i, options, found);
      return true;
    });
    *count = list.count();
  });
}

/// Questions of shapes with one result each: ask(i).
template <class Ask>
void query_each(const Reading& world, std::uint64_t n, carom_world_hit* dst, std::uint64_t stride, Ask&& ask) {
  world->queries->bring_up_to_date(*world);
  for (std::uint64_t i = 0; i < n; ++i) write_element(hit_of(*world, i, ask(i)), dst, i, stride);
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_query_desc_init(carom_query_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_query_desc& d) {
    d.category = d.mask = ~std::uint64_t(0);
    d.tolerance = CastSettings().tolerance;
    d.iterations = static_cast<std::uint32_t>(CastSettings().cap);
  });
}

int32_t carom_world_cast_ray(carom_world* world, const double origin[3], const double direction[3], double max,
                             const carom_query_desc* desc, carom_world_hit* hit, uint64_t size, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    QueryOptions options;
    if (!reading || !carom::abi::finite(call, 2, "origin", origin, 3) ||
        !carom::abi::finite(call, 3, "direction", direction, 3) || !not_negative(call, 4, "max", max) ||
        !read_desc(call, 5, *reading, desc, options) || !check_records(call, 6, 1, hit, size))
      return;
    const FloatScope scope;
    const WorldHit found = cast_ray(*reading, Ray{to_vec3(origin), to_vec3(direction), max}, options);
    write_element(hit_of(*reading, 0, found), hit, 0, size);
  });
}

int32_t carom_world_cast_rays(carom_world* world, const carom_rays* rays, uint32_t want, const carom_query_desc* desc,
                              const carom_world_hits* hits, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    QueryOptions options;
    RayColumns in;
    HitColumns out;
    if (!reading || !in.read(call, 2, rays) || !known(call, 3, "want", want, CAROM_WANT_ANY + 1) ||
        !read_desc(call, 4, *reading, desc, options) || !out.read(call, 5, hits, in.count))
      return;
    const FloatScope scope;
    reading->queries->bring_up_to_date(*reading);
    for (std::uint64_t i = 0; i < in.count; ++i) out.write(i, cast_one(*reading, in, i, want, options));
  });
}

int32_t carom_world_cast_rays_all(carom_world* world, const carom_rays* rays, const carom_query_desc* desc,
                                  carom_world_hit* dst, uint64_t stride, uint64_t capacity, uint64_t* count,
                                  carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    QueryOptions options;
    RayColumns in;
    HitList list(dst, stride, capacity);
    if (!reading || !in.read(call, 2, rays) || !read_desc(call, 3, *reading, desc, options) ||
        !list.check(call, 4, count))
      return;
    const FloatScope scope;
    list_all(reading, in.count, list, [&](std::uint64_t i, Array<WorldHit>& found) {
      Ray ray;
      if (!in.get(i, ray)) return false;
      cast_ray_all(*reading, ray, options, found);
      return true;
    });
    *count = list.count();
  });
}

int32_t carom_world_cast_shapes(carom_world* world, const carom_query_shapes* shapes, uint32_t want,
                                const carom_query_desc* desc, carom_world_hit* dst, uint64_t stride,
                                carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    QueryOptions options;
    QueryShapes query_shapes(reading.engine());
    if (!query_shapes.take(call, shapes, true) || !known(call, 3, "want", want, CAROM_WANT_ANY + 1) ||
        !read_desc(call, 4, *reading, desc, options) || !check_records(call, 5, query_shapes.size(), dst, stride))
      return;
    query_each(reading, query_shapes.size(), dst, stride, [&](std::uint64_t i) {
      return want == CAROM_WANT_FIRST
                 ? cast_shape(*reading, query_shapes[i], query_shapes.motion(i), options)
                 : WorldHit{kInvalid, any_on_way(*reading, query_shapes[i], query_shapes.motion(i), options)};
    });
  });
}

int32_t carom_world_cast_shapes_all(carom_world* world, const carom_query_shapes* shapes, const carom_query_desc* desc,
                                    carom_world_hit* dst, uint64_t stride, uint64_t capacity, uint64_t* count,
                                    carom_error* error) {
  return list_of_shapes(
      world, shapes, true, desc, {dst, stride, capacity}, count, error,
      [](const World& in, const QueryShapes& query_shapes, std::uint64_t i, const QueryOptions& options,
         Array<WorldHit>& found) { cast_shape_all(in, query_shapes[i], query_shapes.motion(i), options, found); });
}

int32_t carom_world_overlap_shapes(carom_world* world, const carom_query_shapes* shapes, const carom_query_desc* desc,
                                   carom_world_hit* dst, uint64_t stride, uint64_t capacity, uint64_t* count,
                                   carom_error* error) {
  return list_of_shapes(
      world, shapes, false, desc, {dst, stride, capacity}, count, error,
      [](const World& in, const QueryShapes& query_shapes, std::uint64_t i, const QueryOptions& options,
         Array<WorldHit>& found) { find_overlaps(in, query_shapes[i], options, found); });
}

int32_t carom_world_find_nearest(carom_world* world, const carom_query_shapes* shapes, double reach,
                                 const carom_query_desc* desc, carom_world_hit* dst, uint64_t stride,
                                 carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    QueryOptions options;
    QueryShapes query_shapes(reading.engine());
    if (!query_shapes.take(call, shapes, false) || !not_negative(call, 3, "reach", reach) ||
        !read_desc(call, 4, *reading, desc, options) || !check_records(call, 5, query_shapes.size(), dst, stride))
      return;
    query_each(reading, query_shapes.size(), dst, stride,
               [&](std::uint64_t i) { return find_nearest(*reading, query_shapes[i], reach, options); });
  });
}

}  // extern "C"

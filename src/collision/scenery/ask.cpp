#include "collision/scenery/ask.h"

#include <algorithm>
#include <cstddef>
#include <new>

#include "collision/cast/heading.h"
#include "collision/cast/shape_cast.h"
#include "collision/core.h"
#include "collision/scenery/ray_triangle.h"
#include "collision/volume.h"

namespace carom::collision {
namespace {

/// Memory within the object itself; what does not fit is bad_alloc. (std::pmr::monotonic_buffer_resource would do, where the standard
/// library has it.)
class TriangleMemory final : public Memory {
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    const std::size_t at = (used_ + alignment - 1) & ~(alignment - 1);
    if (alignment > alignof(std::max_align_t) || at > sizeof bytes_ || bytes > sizeof bytes_ - at)
      throw std::bad_alloc();
    used_ = at + bytes;
    return bytes_ + at;
  }
  void do_deallocate(void*, std::size_t, std::size_t) override {}
  bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }

  alignas(std::max_align_t) std::byte bytes_[1024];
  std::size_t used_ = 0;
};

/// A triangle as a shape, on the stack: threads ask side by side, and none of them allocates.
struct OneTriangle {
  TriangleMemory memory;
  TriangleShape shape{&memory};

  /// Scenery -> outside becomes triangle -> outside.
  Frame place(const Frame& scenery) const { return Frame(scenery.r, scenery.apply(shape.origin())); }
};

/// Of two results the one that comes first, of two that touch at the start the deeper one; a fault before all.
bool comes_before(const CastResult& a, const CastResult& b) {
  if (b.outcome == CastOutcome::miss) return a.outcome != CastOutcome::miss;
  if (a.outcome == CastOutcome::overlap && b.outcome == CastOutcome::overlap) return a.separation < b.separation;
  return a.outcome != CastOutcome::miss && a.time < b.time;
}

/// The first of the results of several triangles. Where a corner or an edge of a shape meets those of triangles, several come first at
/// one moment: the one whose normal is its triangle's says which way the surface looks, and the others nothing.
class First {
 public:
  /// @param moment  of time: what differs by less comes at once
  First(CastResult& result, Real moment) : result_(result), moment_(moment) {}

  /// @param triangle  facing the shape   @param normal  of `one`, in the frame of the triangle
  void take(const CastResult& one, const Triangle& triangle, const Vec3& normal) {
    const Real squareness = -triangle.normal.dot(normal);
    if (at_one_moment(one) && std::fabs(squareness - squareness_) > kAsSquare) {
      if (squareness < squareness_) return;
      const Real lower = std::min(one.lower, result_.lower);
      result_ = one, result_.lower = lower;
    } else if (comes_before(one, result_)) {
      result_ = one;
    } else {
      return;
    }
    squareness_ = squareness;
  }
  /// s or a fraction of the motion: what comes later is none.
  Real end(Real duration) const {
    return result_.outcome == CastOutcome::miss ? duration : std::min(result_.upper + moment_, duration);
  }

 private:
  static constexpr Real kAsSquare = 1e-6;
  bool at_one_moment(const CastResult& one) const {
    return one.outcome == CastOutcome::hit && result_.outcome == CastOutcome::hit &&
           one.lower <= result_.upper + moment_ && result_.lower <= one.upper + moment_;
  }
  CastResult& result_;
  Real moment_, squareness_ = 0;
};

void miss(Real end, CastResult& result) {
  result = CastResult();
  result.time = result.lower = end;
}

Aabb grown(Aabb box, Real by) {
  box.lo -= Vec3::constant(by), box.hi += Vec3::constant(by);
  return box;
}

/// Counts what several questions cost.
class Sum {
 public:
  void add(const CastResult& one) { calls_ += one.support_calls, iterations_ += one.iterations; }
  void write(CastResult& result) const { result.support_calls = calls_, result.iterations = iterations_; }

 private:
  int calls_ = 0, iterations_ = 0;
};

/// m; nothing, where nothing moves or no time passes
Real way(Real speed, Real time) { return speed > 0 && time > 0 ? speed * time : 0; }

/// Whether a shape is farther above the plane of a triangle than some distance: it is so from the triangle then, too.
/// @param frame  A -> scenery
bool is_above(const Shape& a, const Frame& frame, const Triangle& triangle, Real distance) {
  if (!finite(distance)) return false;
  Vec3 p;
  Core core(a);
  if (!core.support(-frame.rotate_inverse(triangle.normal), p)) return false;  // whoever asks for the distance says so
  const Vec3& corner = triangle.corner[0];
  const Vec3 lowest = frame.apply(p);
  const Real rounding = kPoseRounding * kUnitRoundoff * (lowest.norm() + corner.norm() + a.bounding_radius);
  return triangle.normal.dot(lowest - corner) - a.core_radius > distance + rounding;
}

/// In which a shape moves by what a bracket may be wide.
Real time_of(const CastSettings& settings, const Shape& a, Real speed) {
  return speed > 0 ? settings.tolerance * a.bounding_radius / speed : 0;
}

/// Ask the triangles along a way that a box about a point goes; ask(triangle, one) gives the result for one of them.
/// @param from, heading, extent  in the scenery's frame   @param end  of time
/// @param moment    of time: hits that differ by less come at once
/// @param by_proof  of two hits the one that is proven first, by the upper ends: one that runs nearly along a triangle
///                  says badly when
/// @param frame     of the scenery, if the results' normals are outside; else of itself
template <class Ask>
void first_along(const Scenery& scenery, const Vec3& from, const Heading& heading, const Aabb& extent, Real end,
                 Real moment, bool by_proof, const Frame& frame, CastResult& result, Ask&& ask) {
  miss(end, result);
  First first(result, moment);
  Sum sum;
  const auto one = [&](std::uint32_t index) {
    Triangle triangle;
    CastResult found;
    if (scenery.triangle(index, triangle) && ask(triangle, found)) {
      sum.add(found);
      const Real lower = std::min(found.lower, result.lower);
      if (found.outcome == CastOutcome::hit && result.outcome == CastOutcome::hit && by_proof) {
        if (found.upper < result.upper) result = found;
        result.lower = lower;
      } else {
        first.take(found, triangle, frame.rotate_inverse(found.normal));
      }
    }
    // Brackets are as wide as the tolerance times the size of a triangle; what is farther by more comes later.
    return result.outcome == CastOutcome::miss ? kInfinity : way(heading.speed, result.upper);
  };
  scenery.each_along(from, heading.unit, extent, way(heading.speed, end), one);
  sum.write(result);
}

/// A result in the scenery's frame becomes one outside.
void put_outside(const Frame& frame, CastResult& result) {
  if (result.outcome == CastOutcome::miss) return;
  result.normal = frame.rotate(result.normal);
  result.point_a = frame.apply(result.point_a), result.point_b = frame.apply(result.point_b);
}

/// In the scenery's frame.
void write_crossing(const Ray& ray, const SceneryRay& line, const Triangle& triangle, const TriangleCrossing& at,
                    const CastSettings& settings, CastResult& result) {
  const auto time = [&](Real s) { return std::clamp(s / line.speed, Real(0), ray.max); };
  result.outcome = CastOutcome::hit;
  result.at_start = at.at_start;
  result.lower = time(at.s - at.blur);
  result.upper = std::max(time(at.s + at.blur), result.lower);
  result.time = std::clamp(time(at.s), result.lower, result.upper);
  result.slack = 3 * at.slack;
  const Vec3 longest = triangle.corner[1] - triangle.corner[0];
  if (!(2 * at.blur <= settings.tolerance * longest.norm())) result.status = QueryStatus::rounding;
  result.normal = triangle.normal.dot(line.u) < 0 ? Vec3(-triangle.normal) : triangle.normal;
  result.point_b = line.o + at.s * line.u;
}

}  // namespace

void cast_ray_at_triangles(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings,
                           CastResult& result, SupportFault& fault) {
  const Scenery& scenery = *shape.scenery;
  OneTriangle at;
  Aabb ball;
  ball.lo = Vec3::constant(-settings.target), ball.hi = Vec3::constant(settings.target);
  const Heading heading(frame, ray.direction);
  const SceneryRay line(ray, frame);
  const bool is_line = settings.target == 0 && line.usable();
  const Ray local{line.o, frame.rotate_inverse(ray.direction), ray.max};
  const bool inside = is_line || finite(local.direction);  // else asked outside: turned, the longest overflow
  first_along(scenery, line.o, heading, ball, ray.max, 0, is_line, inside ? Frame() : frame, result,
              [&](const Triangle& triangle, CastResult& one) {
                if (!scenery.two_sided && heading.speed > 0 && triangle.normal.dot(heading.unit) > 0) return false;
                if (!is_line) {
                  at.shape.set(triangle);
                  cast_ray(inside ? local : ray, at.shape.shape(), at.place(inside ? Frame() : frame), settings, one,
                           fault);
                  return true;
                }
                TriangleCrossing crossing;
                if (!cross_triangle(line, triangle, crossing) || (settings.ignore_touched && crossing.at_start))
                  return false;
                write_crossing(ray, line, triangle, crossing, settings, one);
                return true;
              });
  if (result.outcome == CastOutcome::miss) return;
  if (inside) put_outside(frame, result);
  if (is_line) result.point_a = ray.origin + result.time * ray.direction;
}

void cast_shape_at_triangles(const Shape& a, const Frame& frame_a, const Vec3& motion, const Shape& shape,
                             const Frame& frame, const CastSettings& settings, CastResult& result,
                             SupportFault& fault) {
  const Scenery& scenery = *shape.scenery;
  OneTriangle at;
  const Frame a_in_scenery = relative(frame, frame_a);
  const Aabb extent = grown(world_bounds(a, a_in_scenery.r, Vec3::zero(), fault), settings.target);
  if (fault.kind != SupportFault::none) {
    result = CastResult();
    result.outcome = CastOutcome::undecided, result.status = QueryStatus::fault;
    return;
  }
  // Who is in the surface already, and may be, gets no deeper by going along it or out of it: no triangle that it does
  // not go into counts then.
  constexpr Real kAlong = -1e-8;
  const Heading heading(frame, motion);
  const bool is_in =
      settings.ignore_touched && overlap_with_triangles(a, shape, relative(frame_a, frame), settings.target,
                                                        kCastRounding * kUnitRoundoff, settings.cap, fault)
                                         .outcome != Overlap::apart;
  const Vec3 centre = a_in_scenery.apply(a.mass.centroid), local = frame.rotate_inverse(motion);
  const bool inside = finite(local);  // else it is asked outside: turned, the longest motions overflow
  first_along(scenery, a_in_scenery.p, heading, extent, 1, time_of(settings, a, heading.speed), false,
              inside ? Frame() : frame, result, [&](Triangle& triangle, CastResult& one) {
                if (!face(scenery, centre, triangle) || (is_in && triangle.normal.dot(heading.unit) > kAlong))
                  return false;
                at.shape.set(triangle);
                if (inside)
                  cast_shape(a, a_in_scenery, local, at.shape.shape(), at.place(Frame()), settings, one, fault);
                else
                  cast_shape(a, frame_a, motion, at.shape.shape(), at.place(frame), settings, one, fault);
                return true;
              });
  if (inside) put_outside(frame, result);
}

void time_of_impact_at_triangles(const Shape& a, const RigidMotion& motion_a, const Shape& shape,
                                 const RigidMotion& motion, Real duration, const CastSettings& settings,
                                 CastResult& result, SupportFault& fault) {
  const Scenery& scenery = *shape.scenery;
  OneTriangle at;
  const Frame frame(motion.at), frame_a(motion_a.at);
  // All that A sweeps, seen from the scenery: balls about both ends of the way of the centre that it turns about, and
  // as much more as the scenery's own turning sweeps past.
  const Vec3 start = frame.apply_inverse(motion_a.centre);
  const Vec3 way = frame.rotate_inverse(motion_a.velocity - motion.velocity) * duration;
  const Real turn = std::min(motion.omega.norm() * duration, Real(2));
  const Real past = turn * ((motion_a.centre - motion.centre).norm() + way.norm());
  const Real arm = (frame_a.p - motion_a.centre).norm() + a.bounding_radius + settings.target + past;
  Aabb box;
  box.lo = grown(box, 0).lo.min(start).min(start + way), box.hi = box.hi.max(start).max(start + way);
  box = grown(box, arm);
  const Vec3 centre = frame.apply_inverse(frame_a.apply(a.mass.centroid));
  miss(duration, result);
  const Real speed = way.norm() / duration + arm * (motion_a.omega.norm() + motion.omega.norm());
  First first(result, time_of(settings, a, speed));
  Sum sum;
  scenery.each_near(box, [&](std::uint32_t index) {
    Triangle triangle;
    if (!scenery.triangle(index, triangle) || !face(scenery, centre, triangle)) return;
    at.shape.set(triangle);
    RigidMotion of_triangle = motion;
    of_triangle.at.p = motion.at.apply(at.shape.origin());
    CastResult one;
    // Later than the first so far is no matter: a shorter question is a cheaper one. Mostly A stays above the plane.
    Vec3 lowest;
    const Vec3 down = -frame.rotate(triangle.normal);
    if (is_kept_apart(a, motion_a, at.shape.shape(), of_triangle, first.end(duration), settings, down, lowest)) return;
    time_of_impact(a, motion_a, at.shape.shape(), of_triangle, first.end(duration), settings, one, fault);
    sum.add(one);
    if (one.outcome == CastOutcome::miss) return;
    first.take(one, triangle, motion.after(one.time).q.conjugate() * one.normal);
  });
  sum.write(result);
}

OverlapResult overlap_with_triangles(const Shape& a, const Shape& shape, const Frame& scenery_in_a, Real target,
                                     Real rounding, int cap, SupportFault& fault) {
  const Scenery& scenery = *shape.scenery;
  OneTriangle at;
  const Frame a_in_scenery = relative(scenery_in_a, Frame());
  const Aabb box = grown(world_bounds(a, a_in_scenery.r, a_in_scenery.p, fault), target);
  OverlapResult result;
  result.outcome = Overlap::apart, result.separation_bound = target;
  if (fault.kind != SupportFault::none) {
    result.outcome = Overlap::fault;
    return result;
  }
  int calls = 0;
  scenery.each_near(box, [&](std::uint32_t index) {
    Triangle triangle;
    if (result.outcome == Overlap::overlapping || result.outcome == Overlap::fault ||
        !scenery.triangle(index, triangle))
      return;
    at.shape.set(triangle);
    const OverlapResult one = overlap(a, at.shape.shape(), at.place(scenery_in_a), target, rounding, cap, fault);
    calls += one.support_calls;
    if (one.outcome != Overlap::apart) result = one;
  });
  result.support_calls = calls;
  return result;
}

void distance_to_triangles(const Shape& a, const Shape& shape, const Frame& scenery_in_a, const QuerySettings& settings,
                           QueryResult& result, SupportFault& fault) {
  const Scenery& scenery = *shape.scenery;
  OneTriangle at;
  const Frame a_in_scenery = relative(scenery_in_a, Frame());
  const Aabb box = world_bounds(a, a_in_scenery.r, a_in_scenery.p, fault);
  result = QueryResult();
  result.farther = true, result.separation = result.lower = result.upper = kInfinity;
  if (fault.kind != SupportFault::none) {
    result.status = QueryStatus::fault, result.farther = false, result.lower = -kInfinity;
    return;
  }
  bool any = false;
  int calls = 0, gjk = 0, epa = 0;
  QuerySettings own = settings;
  scenery.each_around(box, settings.max_distance, [&](std::uint32_t index) {
    Triangle triangle;
    if (result.status != QueryStatus::fault && scenery.triangle(index, triangle) &&
        !is_above(a, a_in_scenery, triangle, own.max_distance)) {
      at.shape.set(triangle);
      QueryResult one;
      const Frame frame = at.place(scenery_in_a);
      distance(a, at.shape.shape(), frame, own, nullptr, one, fault);
      calls += one.support_calls, gjk += one.gjk_iterations, epa += one.epa_iterations;
      if (one.status == QueryStatus::fault || (!one.farther && (!any || one.separation < result.separation))) {
        result = one;
        result.point_b += at.shape.origin();
        any = true;
        own.max_distance = std::max(one.upper, Real(0));
      }
    }
    return own.max_distance;
  });
  result.support_calls = calls, result.gjk_iterations = gjk, result.epa_iterations = epa;
}

namespace any_shape {

void cast_ray(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings, CastResult& result,
              SupportFault& fault) {
  if (is_scenery(shape)) return cast_ray_at_triangles(ray, shape, frame, settings, result, fault);
  carom::cast_ray(ray, shape, frame, settings, result, fault);
}

void cast_shape(const Shape& a, const Frame& frame_a, const Vec3& motion, const Shape& b, const Frame& frame_b,
                const CastSettings& settings, CastResult& result, SupportFault& fault) {
  if (a.bounding_radius == 0 && a.form != Form::half_space)  // a point: no seam lets it through
    return any_shape::cast_ray(Ray{frame_a.p, motion, 1}, b, frame_b, settings, result, fault);
  if (is_scenery(b)) return cast_shape_at_triangles(a, frame_a, motion, b, frame_b, settings, result, fault);
  carom::cast_shape(a, frame_a, motion, b, frame_b, settings, result, fault);
}

void time_of_impact(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b,
                    Real duration, const CastSettings& settings, CastResult& result, SupportFault& fault) {
  if (is_scenery(b)) return time_of_impact_at_triangles(a, motion_a, b, motion_b, duration, settings, result, fault);
  carom::time_of_impact(a, motion_a, b, motion_b, duration, settings, result, fault);
}

OverlapResult overlap(const Shape& a, const Shape& b, const Frame& b_in_a, Real target, Real rounding, int cap,
                      SupportFault& fault) {
  if (!usable(b_in_a)) return {};
  if (is_scenery(a) && is_scenery(b)) {  // surfaces enclose nothing that both could have
    OverlapResult none;
    none.outcome = Overlap::apart;
    return none;
  }
  if (is_scenery(b)) return overlap_with_triangles(a, b, b_in_a, target, rounding, cap, fault);
  if (!is_scenery(a)) return carom::overlap(a, b, b_in_a, target, rounding, cap, fault);
  OverlapResult result = overlap_with_triangles(b, a, relative(b_in_a, Frame()), target, rounding, cap, fault);
  result.normal = -b_in_a.rotate(result.normal), result.point = b_in_a.apply(result.point);
  return result;
}

void distance(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings, QueryMemory* memory,
              QueryResult& result, SupportFault& fault) {
  if (is_scenery(b)) return distance_to_triangles(a, b, b_in_a, settings, result, fault);
  if (!is_scenery(a)) return carom::distance(a, b, b_in_a, settings, memory, result, fault);
  distance_to_triangles(b, a, relative(b_in_a, Frame()), settings, result, fault);
  result.normal = -b_in_a.rotate(result.normal);
  std::swap(result.point_a, result.point_b);
}

}  // namespace any_shape

}  // namespace carom::collision

// Where a line enters a convex set that offers only its support function, swollen by a radius: the core of ray and
// shape casts.
//
// A linear programme (with a ball added) solved by column generation: any points of the set that the line passes
// between give a time by which it has entered, the plane they lie in gives the next direction to ask, and the support
// point there gives a time before which it has not. For a polytope that ends in finitely many steps, exactly.
#pragma once

#include "collision/cast/line_geometry.h"
#include "collision/cast/overlap.h"

namespace carom::collision::line {

struct Request {
  Real radius = 0;          // of the ball added to the set
  Real rounding = 0;        // error of a support value
  Real slack = 0;           // by more than this no valid support function contradicts itself
  Real start = -kInfinity;  // the stretch of the line that matters: elsewhere no narrow bracket is needed, only the
  Real stop = kInfinity;    // knowledge that it is elsewhere
  Real width = 0;           // of the bracket wanted
  int cap = 128;            // support evaluations
};

/// enters: a bracket was found. misses: the line is clear of the set up to `stop`. undecided: it comes so near that
/// neither could be shown (or the cap came first).
enum class End { enters, misses, undecided, fault };

template <class Point>
struct Entry {
  Real lower = -kInfinity, upper = kInfinity;  // where the line enters
  Real s = 0;                                  // best estimate
  Real touch = kInfinity;                      // where the points' hull is entered, swollen by the rounding more
  bool clear = false;                          // it goes through the middle of a face, or well into the ball: no graze
  bool settled = false;                        // the bracket is as narrow as asked
  Vec3 normal = Vec3::unit_z();                // unit, attains `lower`: into the set
  int count = 0;                               // of the points whose hull the line enters
  Point point[4];
  Real weight[3] = {1, 0, 0};
  int calls = 0;
};

/// Bookkeeping of a walk; the set is asked through Set::support(n, point, value), n unit in the line's coordinates.
template <class Set>
class Walk {
 public:
  using Point = typename Set::Point;
  Walk(Set& set, const Request& request, Entry<Point>& entry)
      : set_(set), ask_(request), entry_(entry), swollen_(request.radius + 2 * request.rounding) {}

  /// @param first  where to look first, across the line; any length, zero allowed
  End run(const Vec2& first) {
    const End found = come_near(first);
    return found == End::enters ? narrow() : found;
  }

 private:
  /// Until points are found between which (or so near to which) the line passes, or a plane along the line that keeps
  /// it clear of the set: GJK in the plane across the line.
  End come_near(const Vec2& first) {
    const Real length = first.norm();
    Vec2 n = length > 1e-150 ? Vec2(first / length) : Vec2(1, 0);
    Shadow shadow;
    for (;;) {
      const int fresh = entry_.count;
      Real value = 0;
      if (!look(Vec3(n.x(), n.y(), 0), fresh, value)) return End::fault;
      if (value > ask_.radius + ask_.rounding) {
        entry_.normal = Vec3(n.x(), n.y(), 0);
        return End::misses;
      }
      if (fresh > 0 && value * value > shadow.distance2 && value > std::sqrt(shadow.distance2) + ask_.slack)
        return blame(Vec3(n.x(), n.y(), 0), fresh);
      if (repeated(fresh)) return End::undecided;
      const Shadow next = nearest_shadow(y_, fresh + 1);
      if (!(next.distance2 < shadow.distance2)) return End::undecided;
      shadow = next;
      keep(shadow.index, shadow.count);
      if (shadow.distance2 <= swollen_ * swollen_) return End::enters;
      if (entry_.calls >= ask_.cap) return End::undecided;
      n = shadow.direction / shadow.direction.norm();
    }
  }

  /// From any points that the line passes between, to those where it enters.
  End narrow() {
    const Real rounding = ask_.rounding;
    Crossing at = first_crossing(y_, entry_.count, swollen_, false);
    if (at.count == 0) return End::undecided;
    adopt(at);
    int idle = 0;  // steps that brought the crossing no nearer
    while (entry_.calls < ask_.cap) {
      const Vec3 n = at.normal;
      const int fresh = entry_.count;
      Real value = 0;
      if (!look(n, fresh, value)) return End::fault;
      const Real touch = n.z() * at.s + swollen_, clear = value - ask_.radius - rounding;
      if (value > touch + ask_.slack) return blame(n, fresh);
      const Real lower = n.z() > 0 ? clear / n.z() : clear > 0 ? kInfinity : -kInfinity;
      if (lower > entry_.lower) {
        entry_.lower = lower;
        entry_.normal = n;
        if (lower > ask_.stop) return End::misses;
      }
      if (entry_.upper < ask_.start) return End::enters;
      entry_.settled = entry_.upper - entry_.lower <= ask_.width;
      const bool placed = entry_.lower >= ask_.start && entry_.upper <= ask_.stop;
      if ((entry_.settled && placed) || touch - value <= 4 * rounding || repeated(fresh)) return End::enters;
      const Crossing next = first_crossing(y_, fresh + 1, swollen_, true);
      if (next.count == 0) return End::enters;
      if (!(next.s < at.s) && (++idle > 8 || !(next.s <= at.s + 8 * rounding / next.normal.z()))) return End::enters;
      at = next;
      adopt(at);
    }
    return End::enters;
  }

  void adopt(const Crossing& at) {
    for (int i = 0; i < 3; ++i) entry_.weight[i] = at.weight[i];
    // The crossing is of the set swollen a little more than it is, so that the line cannot slip between features.
    const Real more = swollen_ - ask_.radius, slope = std::max(at.normal.z(), Real(1e-300));
    // Share of a face, and slope: a bracket of 1e-6 leaves a normal open by some 1e-3. What is not clear by them only
    // costs a second look.
    constexpr Real kMiddle = 1e-6, kSteep = 0.01;
    const Real least = std::min({at.weight[0], at.weight[1], at.weight[2]});
    entry_.clear = (at.count == 3 && least > kMiddle && slope > kSteep) || ask_.radius * slope * slope > 8 * more;
    entry_.touch = at.s;
    entry_.s = at.s + more / slope;
    entry_.upper = std::min(entry_.upper, at.s + (more + ask_.rounding) / slope);
    int index[3] = {at.index[0], at.index[1], at.index[2]};
    keep(index, at.count);
  }

  bool look(const Vec3& n, int to, Real& value) {
    ++entry_.calls;
    if (!set_.support(n, entry_.point[to])) return false;
    y_[to] = entry_.point[to].y;
    value = n.dot(y_[to]);
    return true;
  }

  /// A support point that lies beyond a point seen before: not a support function.
  End blame(const Vec3& n, int fresh) {
    int lowest = 0;
    for (int i = 1; i < fresh; ++i)
      if (n.dot(y_[i]) < n.dot(y_[lowest])) lowest = i;
    set_.blame(n, entry_.point[fresh], entry_.point[lowest]);
    return End::fault;
  }

  bool repeated(int fresh) const {
    for (int i = 0; i < fresh; ++i)
      if (y_[i] == y_[fresh]) return true;
    return false;
  }

  /// Indices come unordered (an edge of 2 and 0): sorted along with their weights, points move down in place.
  void keep(int* index, int count) {
    for (int i = 1; i < count; ++i)
      for (int j = i; j > 0 && index[j] < index[j - 1]; --j) {
        std::swap(index[j], index[j - 1]);
        std::swap(entry_.weight[j], entry_.weight[j - 1]);
      }
    for (int i = 0; i < count; ++i) {
      if (index[i] == i) continue;
      entry_.point[i] = entry_.point[index[i]];
      y_[i] = y_[index[i]];
    }
    entry_.count = count;
  }

  Set& set_;
  const Request& ask_;
  Entry<Point>& entry_;
  const Real swollen_;
  Vec3 y_[4];
};

template <class Set>
End enter(Set& set, const Request& request, const Vec2& first, Entry<typename Set::Point>& entry) {
  return Walk<Set>(set, request, entry).run(first);
}

/// Coordinates of a line: two perpendiculars of it, and its direction u, unit.
inline Mat3 axes_along(const Vec3& u) {
  const Vec3 across = any_perpendicular(u);
  return Mat3::columns(across, u.cross(across), u);
}

/// enters, misses: as above, from the start on. inside: it starts in the set. goes_in: it starts on the surface, and
/// goes in. (Along the surface, or away, it misses.)
enum class Contact { enters, misses, inside, goes_in, undecided, fault };

/// What a graze counts as: a point finds no gap, a body is not stopped.
enum class Graze : bool { misses, enters };

/// Whether a place along the line is in the set, @see overlap.h.
struct Within {
  Overlap outcome = Overlap::touching;
  Real slope = 0;       // of the normal along the line, where it touches
  bool capped = false;  // the cap came first: touching says nothing
};

/// How a line first meets a set from request.start on. Where it starts on the surface or may graze, the same walk from
/// the other side tells how far the set reaches, and the middle of that whether the line goes in at all.
/// @param axes    of the line
/// @param set_in  set_in(axes, side): the set in the coordinates of given axes, which are those of the line; side -1:
///                with the direction turned round
/// @param within  within(s): Within of the line's point s
/// @param entry   `normal` and `calls` are those of all walks; the rest is meant for Contact::enters
template <class SetIn, class Point, class IsWithin>
Contact meet(const Mat3& axes, const SetIn& set_in, const Request& request, const Vec2& first, Graze graze,
             const IsWithin& within, Entry<Point>& entry) {
  const auto said = [](End end) {
    return end == End::misses ? Contact::misses : end == End::fault ? Contact::fault : Contact::undecided;
  };
  auto set = set_in(axes, Real(1));
  const End there = enter(set, request, first, entry);
  if (there != End::enters) return said(there);
  bool starts = entry.touch <= request.start;
  if (starts) {
    const Within start = within(request.start);
    const Overlap at = start.outcome;
    if (at == Overlap::fault) return Contact::fault;
    if (start.capped) return Contact::undecided;
    if (at == Overlap::overlapping) return Contact::inside;
    if (at == Overlap::apart) {
      if (entry.upper < request.start) return Contact::misses;  // it has left
      starts = false;
    }
  }
  const bool may_end_before = !starts && entry.touch > request.stop;
  const Contact in_doubt = starts || may_end_before ? Contact::undecided : Contact::enters;
  if (!starts && (graze == Graze::enters || entry.clear)) return in_doubt;
  if (entry.calls >= request.cap) return in_doubt;

  Mat3 back = axes;
  back.set_col(2, -axes.col(2));
  auto behind = set_in(back, Real(-1));
  Request turned = request;
  turned.start = -kInfinity;
  turned.stop = starts ? -request.start : kInfinity;
  turned.cap -= entry.calls;
  Entry<Point> leave;
  const End here = enter(behind, turned, first, leave);
  entry.calls += leave.calls;
  if (here == End::fault || (here == End::misses && starts)) return said(here);
  if (here != End::enters) return in_doubt;
  // A line that goes in does so wherever the motion ends.
  const Real from = starts ? request.start : entry.touch;
  const Real to = starts ? std::min(-leave.touch, request.stop) : -leave.touch;
  const Within middle = within(from + 0.5 * std::max(to - from, Real(0)));
  // Through something flat (a plate, a point) the way within rounding of it is as long as its slope says. A way that is
  // longer goes along a surface. Of a slope that the root of rounding hides nothing follows: a round surface has it.
  const Real way = to - from, enough = 16 * request.rounding;
  const bool through =
      way <= enough || (middle.slope > 16 * std::sqrt(request.rounding) && way * middle.slope <= enough);
  if (middle.outcome == Overlap::fault) return Contact::fault;
  if (middle.capped) return in_doubt;
  const bool in = middle.outcome == Overlap::overlapping;
  if (starts) {
    // From an edge within the plane of a side: it would be met from farther off, too.
    const bool begins = graze == Graze::enters && entry.touch >= request.start - enough && way > enough;
    return in || begins ? Contact::goes_in : Contact::misses;
  }
  return in || (middle.outcome == Overlap::touching && through) ? in_doubt : Contact::misses;
}

}  // namespace carom::collision::line

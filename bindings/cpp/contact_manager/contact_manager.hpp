// A contact manager as planners of motion want one: links of shapes that are moved, a margin for each pair, the signed distance of
// those that are near, with its bracket; and the same of links that move from one pose to another.
#pragma once

#include <carom/carom.hpp>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace contacts {

using carom::Pose;
using carom::Quat;
using carom::Vec3;

struct Placed {
  carom_shape shape;
  Pose at;  // in the link's frame
};

struct Contact {
  std::string a, b;
  double separation, lower, upper;  // m; negative: depth. The truth is in [lower, upper]
  Vec3 normal;                      // unit, from a to b
  Vec3 point_a, point_b;            // m, on the surfaces
  double time = 0;                  // of a motion: 0 to 1, when the margin is reached
};

enum class Wanted {
  first,
  closest,
  all
};  // of each pair of links: until one is found, the nearest of its shapes, each

inline Vec3 turned(const Quat& q, const Vec3& v) {
  const Vec3 t = {2 * (q[1] * v[2] - q[2] * v[1]), 2 * (q[2] * v[0] - q[0] * v[2]), 2 * (q[0] * v[1] - q[1] * v[0])};
  return {v[0] + q[3] * t[0] + (q[1] * t[2] - q[2] * t[1]), v[1] + q[3] * t[1] + (q[2] * t[0] - q[0] * t[2]),
          v[2] + q[3] * t[2] + (q[0] * t[1] - q[1] * t[0])};
}
inline Pose operator*(const Pose& p, const Pose& o) {
  const Vec3 at = turned(p.orientation, o.position);
  const Quat &a = p.orientation, &b = o.orientation;
  return {
      {p.position[0] + at[0], p.position[1] + at[1], p.position[2] + at[2]},
      {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
       a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]}};
}

class Manager {
 public:
  explicit Manager(carom::Engine engine) : engine_(std::move(engine)) {}

  void add(const std::string& name, const std::vector<Placed>& shapes, bool active) {
    Link link{{}, shapes, {}, active, true};
    for (const Placed& placed : shapes) {
      auto info = carom::make<carom_shape_info>();
      engine_.call(carom_shape_get_info, placed.shape, &info);
      link.radius.push_back(info.bounding_radius);
    }
    links_[name] = std::move(link);
  }
  void remove(const std::string& name) { links_.erase(name); }
  void enable(const std::string& name, bool on) { links_.at(name).enabled = on; }
  void set_pose(const std::string& name, const Pose& pose) { links_.at(name).pose = pose; }

  /// m: pairs that are farther apart are no contacts
  void set_margin(double margin) { margin_ = margin; }
  void set_margin(const std::string& a, const std::string& b, double margin) { margins_[key(a, b)] = margin; }
  /// Pairs for which it says so are left out.
  void allow(std::function<bool(const std::string&, const std::string&)> touches) { allowed_ = std::move(touches); }

  /// Contacts of active links with all others, as they stand.
  std::vector<Contact> test(Wanted wanted = Wanted::closest) const {
    return each_pair(wanted, {}, [&](const Shape& a, const Shape& b, double margin, Contact& found) {
      if (apart(a.from, a.radius, b.from, b.radius) > margin) return false;
      auto result = carom::make<carom_distance>();
      auto desc = carom::make<carom_distance_desc>();
      desc.pair_routines = 1;  // the routine of two boxes, where they are boxes
      engine_.call(carom_shape_distance, a.shape, a.from.position.data(), a.from.orientation.data(), b.shape,
                   b.from.position.data(), b.from.orientation.data(), &desc, &result);
      if (result.separation > margin) return false;
      found.separation = result.separation, found.lower = result.lower, found.upper = result.upper;
      copy(result, found);
      return true;
    });
  }

  /// First contacts of active links that go from where they are to other poses, along a line and at an even turn. What comes nearer than
  /// its margin on the way is found: times are brackets of the true motion, not of poses in between.
  std::vector<Contact> test_motion(const std::map<std::string, Pose>& to, Wanted wanted = Wanted::closest) const {
    return each_pair(wanted, to, [&](const Shape& a, const Shape& b, double margin, Contact& found) {
      if (apart(a.from, a.radius + a.path(), b.from, b.radius + b.path()) > margin) return false;
      auto result = carom::make<carom_cast>();
      auto desc = carom::make<carom_cast_desc>();
      desc.target = std::max(margin, 0.0);
      const carom_motion motion_a = motion(a), motion_b = motion(b);
      engine_.call(carom_shape_time_of_impact, a.shape, &motion_a, b.shape, &motion_b, 1.0, &desc, &result);
      if (result.outcome == CAROM_CAST_MISS) return false;
      found.separation = result.separation, found.time = result.time;
      found.lower = result.lower, found.upper = result.upper;  // of the time
      copy(result, found);
      return true;
    });
  }

  /// The hull of a link's shape at two poses, as Bullet's "cast hull" has it: a shape for test(), of which the caller disposes.
  carom_shape swept(carom_shape shape, const Pose& from, const Pose& to) const {
    const carom_shape both[2] = {shape, shape};
    const double at[6] = {from.position[0], from.position[1], from.position[2],
                          to.position[0],   to.position[1],   to.position[2]};
    const Quat &p = from.orientation, &q = to.orientation;
    const double turn[8] = {p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3]};
    carom_shape made = CAROM_NULL_HANDLE;
    engine_.call(carom_shape_create_hull_of, both, std::uint64_t(2), at, turn, nullptr, 0.0, &made);
    return made;
  }

 private:
  struct Link {
    Pose pose;
    std::vector<Placed> shapes;
    std::vector<double> radius;  // m, of each shape about its origin
    bool active, enabled;
  };
  struct Shape {  // on its way
    carom_shape shape;
    Pose from, to;
    double radius;
    double path() const {
      return std::hypot(to.position[0] - from.position[0], to.position[1] - from.position[1],
                        to.position[2] - from.position[2]);
    }
  };
  using Names = std::pair<std::string, std::string>;

  static Names key(const std::string& a, const std::string& b) { return a < b ? Names(a, b) : Names(b, a); }
  static double apart(const Pose& a, double radius_a, const Pose& b, double radius_b) {
    return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1], a.position[2] - b.position[2]) -
           radius_a - radius_b;
  }
  template <class Result>
  static void copy(const Result& from, Contact& to) {
    std::copy_n(from.normal, 3, to.normal.begin());
    std::copy_n(from.point_a, 3, to.point_a.begin()), std::copy_n(from.point_b, 3, to.point_b.begin());
  }
  static carom_motion motion(const Shape& s) {
    auto m = carom::make<carom_motion>();
    std::copy_n(s.from.position.begin(), 3, m.position), std::copy_n(s.from.orientation.begin(), 4, m.orientation);
    for (int i = 0; i < 3; ++i) m.linear_velocity[i] = s.to.position[std::size_t(i)] - s.from.position[std::size_t(i)];
    const Quat& p = s.from.orientation;
    Quat turn = (Pose{{}, s.to.orientation} * Pose{{}, {-p[0], -p[1], -p[2], p[3]}}).orientation;
    if (turn[3] < 0)
      for (double& x : turn) x = -x;
    const double sine = std::hypot(turn[0], turn[1], turn[2]), angle = 2 * std::atan2(sine, turn[3]);
    for (int i = 0; sine > 0 && i < 3; ++i) m.angular_velocity[i] = turn[std::size_t(i)] / sine * angle;
    return m;
  }

  template <class Ask>
  std::vector<Contact> each_pair(Wanted wanted, const std::map<std::string, Pose>& to, const Ask& ask) const {
    std::vector<Contact> found;
    const auto goal = [&](const std::string& name, const Link& link) {
      const auto at = to.find(name);
      return at == to.end() ? link.pose : at->second;
    };
    for (auto a = links_.begin(); a != links_.end(); ++a)
      for (auto b = std::next(a); b != links_.end(); ++b) {
        if (!(a->second.active || b->second.active) || !a->second.enabled || !b->second.enabled) continue;
        if (allowed_ && allowed_(a->first, b->first)) continue;
        const auto own = margins_.find({a->first, b->first});
        const double margin = own == margins_.end() ? margin_ : own->second;
        const Pose goal_a = goal(a->first, a->second), goal_b = goal(b->first, b->second);
        const std::size_t before = found.size();
        for (std::size_t i = 0; i < a->second.shapes.size(); ++i)
          for (std::size_t k = 0; k < b->second.shapes.size(); ++k) {
            const Placed &one = a->second.shapes[i], &other = b->second.shapes[k];
            Contact contact{a->first, b->first, 0, 0, 0, {}, {}, {}};
            if (!ask({one.shape, a->second.pose * one.at, goal_a * one.at, a->second.radius[i]},
                     {other.shape, b->second.pose * other.at, goal_b * other.at, b->second.radius[k]}, margin, contact))
              continue;
            if (wanted == Wanted::first) return {contact};
            if (wanted == Wanted::all || found.size() == before)
              found.push_back(contact);
            else if (to.empty() ? contact.separation < found.back().separation : contact.time < found.back().time)
              found.back() = contact;
          }
      }
    return found;
  }

  carom::Engine engine_;
  std::map<std::string, Link> links_;
  std::map<Names, double> margins_;
  double margin_ = 0;
  std::function<bool(const std::string&, const std::string&)> allowed_;
};

}  // namespace contacts

// Distances of pairs by the exact query on its generic path, and of bodies to hills by their lowest points.
#include "jury/pairs.h"

#include <algorithm>
#include <cmath>

namespace carom::tools::jury {
namespace {

constexpr double kNear = 0.005;  // m: bodies so near may touch within a step though both stand still at its ends

Near distance(carom_engine* engine, const Case& c, std::size_t a, std::size_t b, const Frame& frame) {
  const State &sa = frame[a], &sb = frame[b];
  carom_distance result;
  result.struct_size = sizeof result;
  Call call;
  call.done(carom_shape_distance(engine, c.members[a].shape, sa.position.data(), sa.orientation.coeffs().data(),
                                 c.members[b].shape, sb.position.data(), sb.orientation.coeffs().data(), nullptr,
                                 &result, call),
            "measuring a pair");
  return {a, b, result.separation, Vec(result.point_a), Vec(result.point_b)};
}

/// Where a way from `start` along `way` meets a shape at the origin: its share of the way, 0 from within, -1 nowhere.
double meets(carom_engine* engine, carom_shape shape, const Vec& start, const Vec& way) {
  const Vec origin = Vec::Zero();
  const Quat straight = Quat::Identity();
  carom_cast result;
  result.struct_size = sizeof result;
  Call call;
  call.done(carom_ray_cast(engine, shape, origin.data(), straight.coeffs().data(), start.data(), way.data(), 1, nullptr,
                           &result, call),
            "measuring a way");
  if (result.outcome == CAROM_CAST_OVERLAP) return 0;
  return result.outcome == CAROM_CAST_HIT ? result.time : -1;
}

/// The centre of a in the frame of b.
Vec center_in(const Case& c, std::size_t a, std::size_t b, const Frame& frame) {
  return frame[b].orientation.conjugate() * (center_of(c.members[a], frame[a]) - frame[b].position);
}

}  // namespace

double reach_speed(const Member& member, const State& state) {
  return state.velocity.norm() + state.omega.norm() * (member.radius + member.center.norm());
}

Vec center_of(const Member& member, const State& state) { return state.position + state.orientation * member.center; }

std::vector<Near> near_pairs(carom_engine* engine, const Case& c, const Frame& frame, double dt) {
  std::vector<Near> pairs;
  std::vector<double> way;
  for (std::size_t i = 0; i < frame.size(); ++i)
    way.push_back(c.members[i].is_plane || c.members[i].is_heights ? 0 : reach_speed(c.members[i], frame[i]) * dt);
  for (std::size_t a = 0; a < frame.size(); ++a)
    for (std::size_t b = a + 1; b < frame.size(); ++b) {
      const Member &ma = c.members[a], &mb = c.members[b];
      if (!(ma.moves() || mb.moves()) || ma.is_heights || mb.is_heights) continue;
      if (!frame[a].is_there || !frame[b].is_there) continue;
      const double margin = kNear + way[a] + way[b];
      if (!ma.is_plane && !mb.is_plane &&
          (frame[a].position - frame[b].position).norm() > ma.radius + mb.radius + margin)
        continue;
      const Near near = distance(engine, c, a, b, frame);
      if (near.separation < margin) pairs.push_back(near);
    }
  return pairs;
}

UnderHills under_hills(carom_engine* engine, const Case& c, std::size_t body, const State& state) {
  UnderHills under;
  const Heights& hills = *c.heights;
  const Vec center = center_of(c.members[body], state);
  const auto middle = hills.at(center.x(), center.z());
  under.is_beyond = !middle;
  if (!middle) return under;
  under.is_through = center.y() < middle->height;
  if (center.y() - middle->height > 2 * c.members[body].radius + 0.5) return under;
  // Directions downwards: against the normal below the centre, and a ring of others.
  std::vector<double> dirs;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      const Vec local = state.orientation.conjugate() * Vec(-middle->normal + Vec(0.5 * i, 0, 0.5 * j));
      dirs.insert(dirs.end(), local.data(), local.data() + 3);
    }
  std::vector<double> points(dirs.size());
  Call call;
  call.done(carom_shape_support(engine, c.members[body].shape, dirs.data(), dirs.size() / 3, points.data(), call),
            "measuring a body");
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const Vec point = state.position + state.orientation * Vec(points.data() + i);
    const auto at = hills.at(point.x(), point.z());
    if (at) under.depth = std::max(under.depth, (at->height - point.y()) * at->normal.y());
  }
  return under;
}

bool is_within(carom_engine* engine, const Case& c, std::size_t a, std::size_t b, const Frame& frame) {
  const Member& thing = c.members[b];
  if (thing.is_plane) return center_of(c.members[a], frame[a]).y() < c.floor;
  return meets(engine, thing.shape, center_in(c, a, b, frame), Vec::Zero()) == 0;
}

bool went_through(carom_engine* engine, const Case& c, std::size_t a, std::size_t b, const Frame& before,
                  const Frame& now) {
  const Member& thing = c.members[b];
  if (thing.is_plane || thing.is_heights) return false;
  if (!before[a].is_there || !before[b].is_there || !now[a].is_there || !now[b].is_there) return false;
  const double moved = (now[a].position - before[a].position).norm() + (now[b].position - before[b].position).norm();
  const double apart = (center_of(c.members[a], now[a]) - now[b].position).norm();
  if (moved < 1e-3 * thing.thickness || apart > thing.radius + 2 * moved + c.members[a].radius) return false;
  const Quat turned = now[b].orientation * before[b].orientation.conjugate();
  if (std::fabs(turned.w()) < 0.97) return false;  // half a radian: no straight line in its frame
  const Vec from = center_in(c, a, b, before), to = center_in(c, a, b, now), way = to - from, back = -way;
  if (way.norm() < 1e-3 * thing.thickness) return false;
  return meets(engine, thing.shape, from, way) > 0 && meets(engine, thing.shape, to, back) > 0;
}

}  // namespace carom::tools::jury

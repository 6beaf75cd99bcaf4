// A plank that rocks on an axle by contact alone.
//   The plank's underside rests on top of a fixed cylinder; two cleats under it reach down either side of the cylinder.
//   Seen along the axle all three are tangent to one circle, so the plank turns about the axle's axis as on a hinge,
//   and cannot slide along x. Friction there is low, as in a bearing.
#include "scenes/lever.h"

#include <cmath>

namespace carom::tools {
namespace {

constexpr double kPlay = 0.004;       // m between cleats and axle: space for contact without wedging
constexpr double kClearance = 0.003;  // m between the low end and the ground at the start
constexpr double kBearingFriction = 0.05;
constexpr double kHalfSqrt2 = 0.70710678118654752440;

Part box(double hx, double hy, double hz, const Vec& at, double density, double friction) {
  Part part;
  part.shape = "box";
  part.params = {hx, hy, hz};
  part.position = at;
  part.density = density;
  part.friction = friction;
  return part;
}

}  // namespace

double Lever::cosine() const { return std::sqrt(1 - sine * sine); }

void Lever::place_on_ground() { axle.y() = left * sine - axle_radius * cosine() + kClearance; }

Quat Lever::tilt() const {  // half-angle formulas: no trigonometry
  return Quat(std::sqrt((1 + cosine()) / 2), 0, 0, std::sqrt((1 - cosine()) / 2));
}

Vec Lever::to_world(const Vec& local) const {
  return axle + Vec(cosine() * local.x() - sine * local.y(), sine * local.x() + cosine() * local.y(), local.z());
}

std::size_t Lever::add_to(Stage& stage) const {
  const double r = axle_radius, t = half_thickness;
  Actor fixed;
  fixed.name = "axle";
  fixed.kind = "axle";
  fixed.type = CAROM_BODY_STATIC;
  fixed.position = axle;
  Part rod;
  rod.shape = "cylinder";
  rod.params = {r, half_width + 0.25};
  rod.orientation = Quat(kHalfSqrt2, kHalfSqrt2, 0, 0);  // the plugin's axis is y; turn it to z
  rod.friction = kBearingFriction;
  fixed.parts.push_back(rod);
  for (double z : {half_width + 0.07, -half_width - 0.07 - 0.1}) {  // triangular stands, clear of the plank
    Part stand;
    stand.shape = "hull";
    for (double dz : {0.0, 0.1})
      for (const auto& [x, y] : {std::pair{-0.6 * axle.y(), -axle.y()}, {0.6 * axle.y(), -axle.y()}, {0.0, 0.0}})
        stand.params.insert(stand.params.end(), {x, y, z + dz});
    fixed.parts.push_back(std::move(stand));
  }
  stage.add(std::move(fixed));

  Actor plank;
  plank.name = "plank";
  plank.kind = "plank";
  plank.position = axle;
  plank.orientation = tilt();
  // Two boxes end to end: under the seat the wood is smooth, or friction would throw the load sideways when it rocks.
  const double smooth = 0.02, seat_end = -left + 2 * kWall + seat_length;
  plank.parts.push_back(
      box((seat_end + left) / 2, t, half_width, Vec((seat_end - left) / 2, r + t, 0), density, smooth));
  plank.parts.push_back(
      box((right - seat_end) / 2, t, half_width, Vec((right + seat_end) / 2, r + t, 0), density, 0.6));
  const double half_depth = 0.45 * r, half_cleat = 0.04;
  for (double side : {-1.0, 1.0})
    plank.parts.push_back(box(half_cleat, half_depth, half_width,
                              Vec(side * (r + kPlay + half_cleat), r - half_depth, 0), density, kBearingFriction));
  // The seat. Without it the load, which wants to fly straight on, would slide outward while the plank turns under it.
  const double up = top() + ledge / 2;
  plank.parts.push_back(box(kWall, ledge / 2, half_width, Vec(-left + kWall, up, 0), density, smooth));
  for (double side : {-1.0, 1.0})
    plank.parts.push_back(box(seat_length / 2, ledge / 2, kWall,
                              Vec(-left + 2 * kWall + seat_length / 2, up, side * (seat_half_width + kWall)), density,
                              smooth));
  // The plank box itself bears on the axle: its friction mixes with the rod's low one by geometric mean.
  return stage.add(std::move(plank));
}

}  // namespace carom::tools

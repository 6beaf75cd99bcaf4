// Faces of all shapes as they collide: turned to the camera, shaded, sorted, painted.
#include "report/perspective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include "report/svg.h"
#include "visual/tessellate.h"

namespace carom::report {
namespace {

using tools::Vec;

constexpr double kWidth = 900, kHeight = 540, kFoot = 30;  // px
constexpr double kOpening = 1.7;                           // width of what is seen at a distance of 1
constexpr double kNearest = 0.05;                          // m: what is nearer to the camera is not drawn
constexpr int kShades = 16;
constexpr int kGroundLines = 20;
constexpr std::array<std::array<int, 3>, 7> kColours = {{{76, 120, 168},
                                                         {230, 145, 56},
                                                         {84, 162, 75},
                                                         {214, 97, 96},
                                                         {178, 121, 162},
                                                         {157, 117, 93},
                                                         {150, 154, 160}}};  // the last: what does not move

/// Corners of one flat face, in order; its mesh's frame.
using Face = std::vector<Vec>;

/// Triangles of a convex mesh that lie in one plane are one face: nothing shows that they were divided.
std::vector<Face> faces_of(const tools::Mesh& mesh, bool convex) {
  std::vector<Face> faces;
  std::vector<bool> done(mesh.faces.size());
  const auto normal = [&](std::size_t f) {
    const auto& [a, b, c] = mesh.faces[f];
    return Vec((mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]));
  };
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Vec n = normal(i);
    if (done[i] || !(n.norm() > 0)) continue;
    std::vector<std::uint32_t> corners(mesh.faces[i].begin(), mesh.faces[i].end());
    for (std::size_t k = i + 1; convex && k < mesh.faces.size(); ++k) {
      if (done[k] || normal(k).dot(n) < (1 - 1e-9) * normal(k).norm() * n.norm()) continue;
      done[k] = true;
      corners.insert(corners.end(), mesh.faces[k].begin(), mesh.faces[k].end());
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    Face face;
    for (const std::uint32_t c : corners) face.push_back(mesh.points[c]);
    const Vec middle = std::accumulate(face.begin(), face.end(), Vec(Vec::Zero())) / static_cast<double>(face.size());
    const Vec u = (face[0] - middle).normalized(), v = n.normalized().cross(u);
    std::sort(face.begin(), face.end(), [&](const Vec& p, const Vec& q) {
      return std::atan2(v.dot(p - middle), u.dot(p - middle)) < std::atan2(v.dot(q - middle), u.dot(q - middle));
    });
    faces.push_back(std::move(face));
  }
  return faces;
}

class Camera {
 public:
  Camera(const Vec& from, const Vec& to) : from_(from) {
    ahead_ = (to - from).norm() > 0 ? Vec((to - from).normalized()) : Vec(-Vec::UnitZ());
    right_ = ahead_.cross(Vec::UnitY());
    right_ = right_.norm() > 1e-6 ? Vec(right_.normalized()) : Vec(Vec::UnitX());
    up_ = right_.cross(ahead_);
  }
  double depth(const Vec& p) const { return ahead_.dot(p - from_); }
  Point place(const Vec& p) const {
    const double s = kWidth / (kOpening * depth(p));
    return {kWidth / 2 + s * right_.dot(p - from_), kHeight / 2 - s * up_.dot(p - from_)};
  }
  const Vec& from() const { return from_; }

 private:
  Vec from_, ahead_, right_, up_;
};

/// What of a flat polygon lies where a plane's height h(point) is not negative.
template <class Height>
Face cut(const Face& face, const Height& h) {
  Face kept;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec &a = face[i], &b = face[(i + 1) % face.size()];
    const double ha = h(a), hb = h(b);
    if (ha >= 0) kept.push_back(a);
    if ((ha >= 0) != (hb >= 0)) kept.push_back(a + ha / (ha - hb) * (b - a));
  }
  return kept;
}

/// A face as it is painted.
struct Painted {
  double far = 0;  // m
  int colour = 0, shade = 0;
  std::vector<Point> points;  // two: a line
  double radius = 0;          // px, of a particle: one point
  bool under = false;         // the water
};

class Picture {
 public:
  explicit Picture(tools::Stage& stage) : stage_(stage), camera_(stage.camera_from, stage.camera_to) {}

  void look() {
    std::vector<double> poses;
    stage_.read(CAROM_FIELD_POSE, poses);
    std::vector<std::string> kinds;
    for (std::size_t i = 0; i < stage_.actors.size(); ++i) {
      const tools::Actor& actor = stage_.actors[i];
      const double* const p = &poses[7 * i];
      const Vec at(p[0], p[1], p[2]);
      const tools::Quat turn(p[6], p[3], p[4], p[5]);
      if (!at.allFinite()) continue;
      int colour = static_cast<int>(kColours.size()) - 1;
      if (actor.type == CAROM_BODY_DYNAMIC) {
        const auto known = std::find(kinds.begin(), kinds.end(), actor.kind);
        colour = static_cast<int>(known - kinds.begin()) % (static_cast<int>(kColours.size()) - 1);
        if (known == kinds.end()) kinds.push_back(actor.kind);
      }
      if (actor.parts.empty()) particle(at, colour);
      for (const tools::Part& part : actor.parts) {
        if (part.shape == "sphere" && !is_cut_by_water(at + turn * part.position, part.params.at(0)))
          ball(at + turn * part.position, part.params.at(0), colour);
        else if (part.shape != "half_space")
          solid(part, at + turn * part.position, turn * part.orientation, colour);
      }
    }
    for (const tools::Bungee& bungee : stage_.bungees)
      line(end_of(bungee.a, bungee.at_a, poses), end_of(bungee.b, bungee.at_b, poses));
    std::stable_sort(painted_.begin(), painted_.end(),
                     [](const Painted& a, const Painted& b) { return a.under != b.under ? a.under : a.far > b.far; });
  }

  std::string document(const std::string& title, const std::string& caption) const {
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 570\" role=\"img\"><title>" +
                      escape(title) + "</title>\n<style>polygon{stroke-width:.5;stroke-linejoin:round}";
    for (std::size_t c = 0; c < kColours.size(); ++c)
      for (int s = 0; s < kShades; ++s) out += style(static_cast<int>(c), s);
    out += "</style>\n" + round_shades() + "<rect width=\"900\" height=\"570\" fill=\"#f4f3ef\"/>\n";
    out += "<svg width=\"900\" height=\"540\" viewBox=\"" + window() + "\">\n" + (stage_.water_level ? "" : ground());
    const auto surface = std::find_if(painted_.begin(), painted_.end(), [](const Painted& p) { return !p.under; });
    for (auto p = painted_.begin(); p != surface; ++p) out += element(*p);
    out += water();
    for (auto p = surface; p != painted_.end(); ++p) out += element(*p);
    return out + "</svg>\n<text x=\"12\" y=\"" + std::to_string(static_cast<int>(kHeight + kFoot - 10)) +
           "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#444\">" + escape(caption) + "</text>\n</svg>\n";
  }

 private:
  /// What of the picture is shown: all that moves, not larger than three times.
  std::string window() const {
    double left = kWidth, right = 0, top = kHeight, bottom = 0;
    for (const Painted& p : painted_) {
      if (p.colour == static_cast<int>(kColours.size()) - 1) continue;
      for (const Point& at : p.points) {
        left = std::min(left, at.x - p.radius), right = std::max(right, at.x + p.radius);
        top = std::min(top, at.y - p.radius), bottom = std::max(bottom, at.y + p.radius);
      }
    }
    left = std::max(left, 0.0), right = std::min(right, kWidth);
    top = std::max(top, 0.0), bottom = std::min(bottom, kHeight);
    const double shown = std::clamp(1.15 * std::max((right - left) / kWidth, (bottom - top) / kHeight), 1 / 3.0, 1.0);
    const double x = std::clamp((left + right - shown * kWidth) / 2, 0.0, (1 - shown) * kWidth);
    const double y = std::clamp((top + bottom - shown * kHeight) / 2, 0.0, (1 - shown) * kHeight);
    char text[80];
    std::snprintf(text, sizeof text, "%.1f %.1f %.1f %.1f", x, y, shown * kWidth, shown * kHeight);
    return text;
  }
  static std::string name(int colour, int shade) {
    return {static_cast<char>('a' + colour), static_cast<char>('a' + shade)};
  }
  /// Light from above and beside; edges a little darker than their face.
  static std::string style(int colour, int shade) {
    char text[80];
    std::array<int, 6> rgb{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double light = 0.5 + 0.6 * shade / (kShades - 1);
      rgb[k] = std::min(255, static_cast<int>(kColours[static_cast<std::size_t>(colour)][k] * light));
      rgb[k + 3] = static_cast<int>(0.8 * rgb[k]);
    }
    std::snprintf(text, sizeof text, ".%s{fill:#%02x%02x%02x;stroke:#%02x%02x%02x}\n", name(colour, shade).c_str(),
                  rgb[0], rgb[1], rgb[2], rgb[3], rgb[4], rgb[5]);
    return text;
  }
  /// Of balls: lit where the light comes from.
  static std::string round_shades() {
    std::string out = "<defs>";
    for (std::size_t c = 0; c < kColours.size(); ++c) {
      char text[240];
      const auto& k = kColours[c];
      std::snprintf(text, sizeof text,
                    "<radialGradient id=\"%c\" cx=\".4\" cy=\".3\" r=\".75\"><stop stop-color=\"rgb(%d,%d,%d)\"/>"
                    "<stop offset=\"1\" stop-color=\"rgb(%d,%d,%d)\"/></radialGradient>\n",
                    static_cast<char>('a' + c), std::min(255, k[0] * 11 / 10), std::min(255, k[1] * 11 / 10),
                    std::min(255, k[2] * 11 / 10), k[0] / 2, k[1] / 2, k[2] / 2);
      out += text;
    }
    return out + "</defs>\n";
  }
  static std::string coordinates(Point p) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1f,%.1f", p.x, p.y);
    return text;
  }
  static std::string element(const Painted& p) {
    char text[80];
    if (p.radius > 0) {
      std::snprintf(text, sizeof text, "<circle fill=\"url(#%c)\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n",
                    static_cast<char>('a' + p.colour), p.points[0].x, p.points[0].y, p.radius);
      return text;
    }
    if (p.points.size() == 2)
      return "<path d=\"M" + coordinates(p.points[0]) + "L" + coordinates(p.points[1]) + "\" stroke=\"#777\"/>\n";
    std::string out = "<polygon class=\"" + name(p.colour, p.shade) + "\" points=\"";
    for (const Point& at : p.points) out += (out.back() == '"' ? "" : " ") + coordinates(at);
    return out + "\"/>\n";
  }
  bool in_sight(const std::vector<Point>& points) const {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Point& p : points) {
      left = std::min(left, p.x), right = std::max(right, p.x);
      top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    return right > 0 && left < kWidth && bottom > 0 && top < kHeight;
  }

  bool is_cut_by_water(const Vec& at, double radius) const {
    return stage_.water_level && std::fabs(at.y() - *stage_.water_level) < radius;
  }
  bool is_under_water(const Vec& at) const { return stage_.water_level && at.y() < *stage_.water_level; }

  static Vec end_of(std::size_t actor, const Vec& at, const std::vector<double>& poses) {
    if (actor == tools::Bungee::kWorld) return at;
    const double* const p = &poses[7 * actor];
    return Vec(p[0], p[1], p[2]) + tools::Quat(p[6], p[3], p[4], p[5]) * at;
  }
  void line(const Vec& a, const Vec& b) {
    if (!(std::min(camera_.depth(a), camera_.depth(b)) > kNearest)) return;
    Painted p{(camera_.depth(a) + camera_.depth(b)) / 2, 0, 0,
              {camera_.place(a), camera_.place(b)},      0, is_under_water((a + b) / 2)};
    p.colour = static_cast<int>(kColours.size()) - 1;
    if (in_sight(p.points)) painted_.push_back(std::move(p));
  }

  void particle(const Vec& at, int colour) { ball(at, 0.03, colour); }

  /// Seen from anywhere it is a disc, but for a stretch near the edge of the picture. Its shade runs across it.
  void ball(const Vec& at, double radius, int colour) {
    const double depth = camera_.depth(at);
    if (!(depth > kNearest + radius)) return;
    Painted p{
        depth, colour, 0, {camera_.place(at)}, std::max(1.0, radius * kWidth / (kOpening * depth)), is_under_water(at)};
    if (in_sight(p.points)) painted_.push_back(std::move(p));
  }

  const std::vector<Face>& faces(const tools::Part& part) {
    const auto key = std::make_pair(part.shape, part.params);
    const auto found = known_.find(key);
    return found != known_.end() ? found->second
                                 : known_[key] = faces_of(tools::tessellate(stage_.engine(), part), !part.is_ground());
  }

  void solid(const tools::Part& part, const Vec& at, const tools::Quat& turn, int colour) {
    static const Vec kLight = Vec(0.45, 0.8, 0.4).normalized();
    for (const Face& face : faces(part)) {
      std::vector<Vec> corners;
      for (const Vec& c : face) corners.push_back(at + turn * c);
      const Vec normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
      if (!(normal.dot(corners[0] - camera_.from()) < 0)) continue;
      const int shade = static_cast<int>((0.5 + 0.5 * normal.dot(kLight)) * (kShades - 1) + 0.5);
      if (!stage_.water_level) {
        polygon(corners, colour, shade, false);
        continue;
      }
      const auto height = [&](const Vec& p) { return p.y() - *stage_.water_level; };
      polygon(cut(corners, height), colour, shade, false);
      polygon(cut(corners, [&](const Vec& p) { return -height(p); }), colour, shade, true);
    }
  }
  void polygon(const Face& corners, int colour, int shade, bool under) {
    if (corners.size() < 3) return;
    Painted p{0, colour, shade, {}, 0, under};
    bool ahead = true;
    for (const Vec& c : corners) {
      ahead &= camera_.depth(c) > kNearest;
      p.far += camera_.depth(c) / static_cast<double>(corners.size());
      p.points.push_back(camera_.place(c));
    }
    if (ahead && in_sight(p.points)) painted_.push_back(std::move(p));
  }

  /// The surface, through which is seen what is under it; as wide as the floor that viewers draw.
  std::string water() const {
    if (!stage_.water_level) return "";
    const double w = stage_.ground_half_width, y = *stage_.water_level;
    const Face square =
        cut(Face{{-w, y, -w}, {-w, y, w}, {w, y, w}, {w, y, -w}}, [&](const Vec& p) { return camera_.depth(p) - 0.5; });
    std::string out = "<polygon fill=\"#6fa3c8\" fill-opacity=\".62\" points=\"";
    for (const Vec& p : square) out += (out.back() == '"' ? "" : " ") + coordinates(camera_.place(p));
    return out + "\"/>\n";
  }

  /// The floor that viewers draw, as a grid at height 0; lines are cut where they pass the camera.
  std::string ground() const {
    std::string out;
    const double w = stage_.ground_half_width;
    if (!(w > 0)) return out;
    const auto line = [&](Vec a, Vec b) {
      const double near = 0.5;  // m
      if (camera_.depth(a) < near) std::swap(a, b);
      if (camera_.depth(a) < near) return;
      if (camera_.depth(b) < near) b = a + (camera_.depth(a) - near) / (camera_.depth(a) - camera_.depth(b)) * (b - a);
      const Point p = camera_.place(a), q = camera_.place(b);
      char text[120];
      std::snprintf(text, sizeof text, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#d3d0c8\"/>\n", p.x, p.y, q.x, q.y);
      out += text;
    };
    for (int i = 0; i <= kGroundLines; ++i) {
      const double x = w * (2.0 * i / kGroundLines - 1);
      line({x, 0, -w}, {x, 0, w});
      line({-w, 0, x}, {w, 0, x});
    }
    return out;
  }

  tools::Stage& stage_;
  Camera camera_;
  std::vector<Painted> painted_;
  std::map<std::pair<std::string, std::vector<double>>, std::vector<Face>> known_;
};

}  // namespace

std::string perspective(tools::Stage& stage, const std::string& title, const std::string& caption) {
  Picture picture(stage);
  picture.look();
  return picture.document(title, caption);
}

}  // namespace carom::report

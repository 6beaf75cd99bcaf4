// A scene out of a seed: ground, paddle, bodies by themselves and bodies that joints hold together.
#include <algorithm>

#include "jury/drawing.h"

namespace carom::tools::jury {
namespace {

/// A body that has been thought of, but not placed.
struct Planned {
  Part part;
  std::string name;
  std::uint32_t type = CAROM_BODY_DYNAMIC;
  Vec position = Vec::Zero();
  Quat orientation = Quat::Identity();
};

/// A joint between two of a cluster.
struct PlannedLink {
  std::uint32_t kind;
  std::size_t a, b;
  Vec at;
  Quat axes;
};

struct Cluster {
  std::vector<Planned> bodies;
  std::vector<PlannedLink> links;
  bool hangs = false;  ///< from a post: its first body is static
};

Planned plan_body(Drawing& d, std::size_t number) {
  Planned body;
  const Solid solid = d.solid();
  body.part = d.part(solid);
  body.name = (solid.form == "lump" ? "" : solid.form + " ") + solid.plugin + " " + std::to_string(number);
  body.orientation = d.random.rotation();
  return body;
}

Planned plan_post() {
  Planned post;
  post.part.shape = "box";
  post.part.params = {0.03, 0.03, 0.03};
  post.type = CAROM_BODY_STATIC;
  return post;
}

/// Whether a body keeps clear of all of its cluster but the one that it is joined to.
bool keeps_clear(Drawing& d, const Cluster& cluster, const Planned& body, std::size_t parent) {
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    if (i == parent) continue;
    const Planned& other = cluster.bodies[i];
    carom_distance result;
    result.struct_size = sizeof result;
    Call call;
    Engine& engine = d.stage().engine();
    call.done(carom_shape_distance(engine.get(), engine.shape(body.part.shape, body.part.params), body.position.data(),
                                   body.orientation.coeffs().data(), engine.shape(other.part.shape, other.part.params),
                                   other.position.data(), other.orientation.coeffs().data(), nullptr, &result, call),
              "placing a body");
    if (result.lower < kGap) return false;
  }
  return true;
}

/// Put a body beside one of the cluster, surface to surface, and a joint between the two.
bool attach(Drawing& d, Cluster& cluster, Planned body) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const std::size_t parent = d.pick(cluster.bodies.size());
    const Planned& root = cluster.bodies[parent];
    const Vec way = d.random.direction();
    body.orientation = d.random.rotation();
    const Vec here = root.position + d.support(root.part, root.orientation, way);
    body.position = here + kGap * way - d.support(body.part, body.orientation, -way);
    if (!keeps_clear(d, cluster, body, parent)) continue;
    static constexpr std::uint32_t kKinds[] = {CAROM_JOINT_BALL, CAROM_JOINT_HINGE, CAROM_JOINT_SLIDER,
                                               CAROM_JOINT_WELD};
    const std::uint32_t kind = kKinds[d.pick(4)];
    const Quat axes = kind == CAROM_JOINT_SLIDER ? turn_between(Vec::UnitX(), way) : d.random.rotation();
    cluster.links.push_back({kind, parent, cluster.bodies.size(), here + kGap / 2 * way, axes});
    cluster.bodies.push_back(std::move(body));
    return true;
  }
  return false;
}

/// Where a cluster's frame stands, so that all of it is free; higher with each attempt.
void place(Drawing& d, Cluster& cluster) {
  for (int attempt = 0;; ++attempt) {
    const double wide = kPlace + 0.02 * attempt;
    const Vec origin = d.random.within(Vec(-wide, 0.1, -wide), Vec(wide, 2.2 + 0.05 * attempt, wide));
    const Quat turned = cluster.bodies.size() > 1 ? d.random.rotation() : Quat::Identity();
    const bool is_free = std::all_of(cluster.bodies.begin(), cluster.bodies.end(), [&](const Planned& body) {
      return d.is_free(body.part, origin + turned * body.position, turned * body.orientation, kGap);
    });
    if (!is_free) continue;
    for (Planned& body : cluster.bodies) {
      body.position = origin + turned * body.position;
      body.orientation = (turned * body.orientation).normalized();
    }
    for (PlannedLink& link : cluster.links) {
      link.at = origin + turned * link.at;
      link.axes = (turned * link.axes).normalized();
    }
    return;
  }
}

void limit(Drawing& d, Link& link, carom_joint joint) {
  const bool slides = link.kind == CAROM_JOINT_SLIDER;
  if (!slides && (link.kind != CAROM_JOINT_HINGE || d.chance(0.5))) return;
  link.limited = true;
  link.lower = slides ? -d.random.between(0.02, 0.3) : -d.random.between(0.2, 1.5);
  link.upper = slides ? d.random.between(0.02, 0.3) : d.random.between(0.2, 1.5);
  carom_joint_limit limit;
  Call call;
  call.done(carom_joint_limit_init(&limit, sizeof limit), "limiting a joint");
  limit.enabled = 1;
  limit.lower = link.lower, limit.upper = link.upper;
  call.done(carom_joint_set_limit(d.stage().world.get(), joint,
                                  slides ? CAROM_COORDINATE_SLIDE : CAROM_COORDINATE_TWIST, &limit, call),
            "limiting a joint");
}

void add_link(Drawing& d, const PlannedLink& planned, std::size_t first) {
  Link link;
  link.kind = planned.kind;
  link.a = first + planned.a, link.b = first + planned.b;
  const carom_joint joint = d.stage().join(link.kind, link.a, link.b, planned.at, planned.axes);
  carom_joint_desc desc;
  Call call;
  call.done(carom_joint_desc_init(&desc, sizeof desc), "asking for a joint");
  call.done(carom_joint_get(d.stage().world.get(), joint, &desc, call), "asking for a joint");
  link.at_a = Vec(desc.position_a), link.at_b = Vec(desc.position_b);
  link.axes_a = Quat(Eigen::Vector4d(desc.orientation_a)), link.axes_b = Quat(Eigen::Vector4d(desc.orientation_b));
  limit(d, link, joint);
  d.scene.links.push_back(link);
}

/// Bodies of a cluster move as one: what joints hold is not torn apart at the start.
void add_cluster(Drawing& d, const Cluster& cluster) {
  const bool thrown = !cluster.hangs && d.chance(d.lively), spun = !cluster.hangs && d.chance(d.lively);
  const auto up_to = [&](double most) {
    const Vec way = d.random.direction();
    return Vec(d.random.between(0, most) * way);
  };
  const Vec velocity = thrown ? up_to(6) : Vec(Vec::Zero());
  const double turns = cluster.bodies.size() > 1 ? 4 : 15;
  const Vec spin = spun ? up_to(turns) : Vec(Vec::Zero());
  const std::size_t first = d.scene.members.size();
  for (const Planned& body : cluster.bodies) {
    Actor actor;
    actor.kind = body.part.shape;
    actor.name = body.type == CAROM_BODY_STATIC ? "post " + std::to_string(first) : body.name;
    actor.type = body.type;
    actor.position = body.position;
    actor.orientation = body.orientation;
    actor.parts.push_back(body.part);
    d.add(std::move(actor));
  }
  const State start{d.stage().actors[first].position, {}, {}, {}};
  for (std::size_t i = first; !cluster.hangs && i < d.scene.members.size(); ++i) {
    Actor& actor = d.stage().actors[i];
    const Vec center = actor.position + actor.orientation * d.scene.members[i].center;
    actor.linear_velocity = velocity + spin.cross(center - start.position);
    actor.angular_velocity = spin;
    Call call;
    call.done(
        carom_body_set_velocity(d.stage().world.get(), actor.body, actor.linear_velocity.data(), spin.data(), call),
        "throwing a body");
  }
  for (const PlannedLink& link : cluster.links) add_link(d, link, first);
}

}  // namespace

void draw_bodies(Drawing& d, std::size_t count, bool joined) {
  std::size_t drawn = 0;
  while (drawn < count) {
    const bool together = joined && (drawn == 0 || d.chance(0.3));
    const std::size_t size = std::min(together ? 2 + d.pick(5) : 1, count - drawn);
    Cluster cluster;
    cluster.hangs = size > 1 && d.chance(0.25);
    cluster.bodies.push_back(cluster.hangs ? plan_post() : plan_body(d, drawn++));
    for (std::size_t i = cluster.hangs ? 0 : 1; i < size; ++i)
      if (attach(d, cluster, plan_body(d, drawn))) ++drawn;
    if (cluster.hangs && cluster.bodies.size() == 1) continue;
    place(d, cluster);
    add_cluster(d, cluster);
  }
}

Case draw(std::uint64_t seed, Stage& stage) {
  Drawing d(seed, stage);
  d.scene.seed = seed;
  const std::string ground = draw_ground(d);
  const bool stirred = d.chance(0.25), joined = d.chance(0.5);
  if (stirred) draw_paddle(d);
  const std::size_t count = 3 + d.pick(38);
  draw_bodies(d, count, joined);
  d.scene.summary = std::string(d.thin > 0 ? d.thin > 0.3 ? "many thin of " : "some thin of " : "") +
                    std::to_string(count) + " bodies on " + ground +
                    (d.lively > 0 ? d.lively > 0.3 ? ", lively" : ", some thrown" : "");
  if (!d.scene.links.empty()) d.scene.summary += ", " + std::to_string(d.scene.links.size()) + " joints";
  if (stirred) d.scene.summary += ", a paddle";
  return std::move(d.scene);
}

}  // namespace carom::tools::jury

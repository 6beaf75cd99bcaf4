// A scene file on its way into a stage.
#pragma once

#include <map>

#include "scenefile/document.h"
#include "scenes/scene.h"

namespace carom::tools::scenefile {

/// Where a node is in another frame: x -> p + q (s x), s along the node's own axes.
struct Place {
  Vec p = Vec::Zero();  // m
  Quat q = Quat::Identity();
  Vec s = Vec::Ones();

  bool is_identity() const { return p.isZero(0) && q.coeffs() == Quat::Identity().coeffs() && s == Vec::Ones(); }
  /// This frame in that of `parent`. Exact where one of the two is the identity. Shear (a turned child of a node whose
  /// scale differs by axis) is left out.
  Place in(const Place& parent) const {
    if (parent.is_identity()) return *this;
    if (is_identity()) return parent;
    return {parent.p + parent.q * Vec(parent.s.cwiseProduct(p)), parent.q * q, parent.s.cwiseProduct(s)};
  }
};

Place place_of(const Value& node);  ///< in its parent   @throws Error

class Reader {
 public:
  Reader(const std::string& path, Stage& stage) : doc_(path), stage_(stage) {}
  void run();

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Node {
    Place local, world, in_body;
    std::size_t parent = kNone, body = kNone;  // body: a node; kNone: the world
    bool is_body = false;
  };
  struct Particle {
    std::size_t index, set;
    double mass;
    Actor actor;
  };

  // read.cpp: the world, nodes, bodies
  void read_world();
  void read_fields_and_springs();
  void find_nodes();
  void demand_trees() const;
  void walk(std::size_t node, std::size_t parent, std::size_t depth);
  void make_bodies();
  Actor actor_of(std::size_t node);
  void make_particles();
  Value node(std::size_t i) const { return doc_.section("nodes", i); }
  Maybe own(const Value& of) const { return Document::extension(of, "CAROM_physics"); }
  /// What a node says of physics: OMI_physics_body has the same structure, and is asked where there is no KHR extension.
  Maybe khr(const Value& of) const {
    const Maybe first = Document::extension(of, "KHR_physics_rigid_bodies");
    return first ? first : Document::extension(of, "OMI_physics_body");
  }
  /// Materials, filters and joints of the extension that a value stands in.
  Maybe of_document(const Value& of) const;
  void remark(const std::string& text);  ///< what is left out
  void note(const std::string& text);    ///< what is read as something near it
  void tell(const std::string& kind, const std::string& text);

  // motion.cpp
  void read_motion(const Value& node, const Node& at, Actor& actor);
  void read_mass(const Value& motion, const Node& at, Actor& actor);
  void read_inertia(const Value& motion, const Node& at, Actor& actor);
  void finish_body(std::size_t node, std::size_t actor);
  void name_what_locks_stop(const Value& motion, std::uint32_t locks);

  // geometry.cpp: what colliders are made of
  using Hulls = std::vector<std::vector<double>>;  // parameters of the hull plugin
  std::vector<Value> colliders_of(const Value& node) const;
  std::vector<Part> parts_of(const Value& collider, const Node& at, bool moves);
  void read_shape(const Value& shape, const Vec& scale, Part& part);
  void read_own_shape(const Value& shapes, std::size_t which, int depth, std::string& name,
                      std::vector<double>& params);
  void read_surface(const Value& collider, Part& part);
  void finish_collider(const Value& collider, bool sensor, const Part& part);
  std::uint64_t system_bit(const Value& name);

  // meshes.cpp: meshes as colliders
  Mesh mesh_of(const Value& geometry, const Vec& scale);
  void collide_as(Mesh mesh, const Value& at, bool convex, bool moves, Part& part, Hulls& hulls);
  bool take_into_hulls(const Mesh& mesh, const Value& at, Hulls& hulls);

  // omi.cpp: what OMI_physics_body, _shape, _joint and _gravity say otherwise
  static bool is_omi(const Value& value) { return value.place().find("/extensions/OMI_physics_") != std::string::npos; }
  static Maybe omi_index(const Value& of, const char* key);  ///< nothing where it is -1
  Maybe omi_details(const Value& shape);
  void read_omi_radius(const Value& shape, double& bottom, double& top, double& height);
  void read_omi_shape(const Value& which, const Vec& scale, bool moves, Part& part, Hulls& hulls);
  void read_omi_gravity();
  void make_gravity_volumes();
  struct GravityVolume;
  void find_volume(GravityVolume& volume);
  bool make_gravity_volume(const GravityVolume& volume, bool stops);
  void name_what_is_not_read();
  void name_how_materials_mix();

  // joints.cpp
  void make_joints();
  void make_joint(std::size_t node, const Value& joint);
  /// @param last  joints that it names and that are not made yet never will be   @return whether it is made
  bool make_coupling(std::size_t number, const Value& own, bool last);
  bool read_own_joint(const Value& own, carom_joint_desc& desc) const;
  struct Plan;
  bool plan_joint(const Value& joint, Plan& plan);
  bool fits(const Value& drive, const Plan& plan) const;
  bool wants_axes(const Value& joint);
  bool make_soft_distance(std::size_t node, std::size_t other, const Value& joint);
  void drive_joint(const Value& joint, const Plan& plan, carom_joint handle, const carom_joint_desc& desc);

  Document doc_;
  Stage& stage_;
  std::size_t told_ = 0;  // remarks, those beyond the most that are kept too
  std::vector<Node> nodes_;
  std::vector<std::size_t> actor_of_node_;
  std::vector<Particle> particles_;
  std::map<std::string, std::uint64_t> systems_;
  std::map<std::string, int> names_;
  std::vector<std::pair<Mesh, Hulls>> taken_apart_;
  std::map<std::size_t, carom_joint> joint_of_;  // by number in physicsJoints
  struct LateCoupling {
    std::size_t number;
    Value own;
  };
  std::vector<LateCoupling> late_couplings_;
};

}  // namespace carom::tools::scenefile

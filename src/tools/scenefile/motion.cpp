// What a scene file says of how bodies move: type, velocities, mass, inertia, locks.
#include <cmath>

#include "scenefile/attributes.h"
#include "scenefile/reader.h"

namespace carom::tools::scenefile {
namespace {

std::uint32_t type_named(const Value& text) {
  const std::string& type = text.text();
  if (type == "static") return CAROM_BODY_STATIC;
  if (type == "kinematic") return CAROM_BODY_KINEMATIC;
  if (type != "dynamic") text.fail("is '" + type.substr(0, 80) + "'", "write static, kinematic or dynamic");
  return CAROM_BODY_DYNAMIC;
}

/// The two turns that an inertia which is infinite about two axes forbids, as locks. They forbid them for good if the
/// third axis lies along one of the world's: no turn about an axis moves it.   @return 0: locks do not say it
std::uint32_t locks_of_turns(const Value& motion, const Quat& world) {
  const Vec moments = motion["inertiaDiagonal"].vector();
  int third = 0;
  if ((moments.array() > 0).count() != 1 || !(moments.maxCoeff(&third) > 0)) return 0;
  const Vec axis = world * (motion.rotation_or("inertiaOrientation") * Vec::Unit(third));
  int along = 0;
  if (1 - axis.cwiseAbs().maxCoeff(&along) > 1e-12) return 0;
  const Vec spin = world * motion.vector_or("angularVelocity", Vec::Zero());
  if ((spin - spin[along] * Vec::Unit(along)).norm() > 0) return 0;  // which nothing would stop
  return 0x38u & ~(8u << along);
}

/// An infinite moment that locks do not say is so much times the largest other. Not more: a step takes an impact with
/// the moments as they lay when it began, so some h w^2 of it goes about the axis that hardly turns, and that times a
/// very large moment makes a gyroscope of the body.
constexpr double kHardly = 100;

}  // namespace

void Reader::read_inertia(const Value& motion, const Node& n, Actor& actor) {
  const auto given = motion.get("inertiaDiagonal");
  if (!given) return;
  Vec moments = given->vector();
  if (!(moments.minCoeff() >= 0)) given->fail("is negative", "give moments of inertia, kg m^2");
  const bool some = moments.minCoeff() == 0 && moments.maxCoeff() > 0;
  if (is_omi(motion) && moments.minCoeff() == 0) {
    if (some) note(given->place() + ": a moment of 0; all are taken from the colliders");
    return;
  }
  if (moments == Vec::Zero()) {
    moments.setOnes();  // infinite: locked, @see finish_body()
  } else if (some && locks_of_turns(motion, n.world.q)) {
    moments.setConstant(moments.maxCoeff());
  } else if (some) {
    moments = (moments.array() == 0).select(kHardly * moments.maxCoeff(), moments);
    note(given->place() +
         ": infinite about some axes; a hundred times the largest other, as locks hold turns about the world's axes "
         "alone");
  } else if (2 * moments.maxCoeff() > moments.sum() * (1 + 1e-6)) {
    stage_.remarks.push_back("as given: " + given->place() +
                             " is of no body: one moment is larger than the two others together");
  }
  const Eigen::Matrix3d axes = motion.rotation_or("inertiaOrientation").toRotationMatrix();
  const Eigen::Matrix3d inertia = axes * moments.asDiagonal() * axes.transpose();
  actor.inertia = 0.5 * (inertia + inertia.transpose());
}

/// What a motion says of mass, where CAROM_physics does not say how it was come by.
void Reader::read_mass(const Value& motion, const Node& n, Actor& actor) {
  const bool omi = is_omi(motion);
  if (omi && actor.type != CAROM_BODY_DYNAMIC) return;
  actor.mass = motion.number_or("mass", omi ? 1 : 0, 0, 1e30);
  const bool is_zero = motion.has("mass") && actor.mass == 0;
  if (is_zero || omi) actor.mass = is_zero ? 1 : actor.mass;  // infinite: locked, @see finish_body()
  if (is_zero && omi) note(motion.place() + "/mass is 0; 1 kg");
  if (actor.mass == 0) {
    for (const char* key : {"centerOfMass", "inertiaDiagonal"})
      if (motion.has(key)) remark(motion.place() + "/" + key + " without a mass; it follows from the colliders");
    return;
  }
  if (omi || motion.has("centerOfMass"))
    actor.center = n.world.s.cwiseAbs().cwiseProduct(motion.vector_or("centerOfMass", Vec::Zero()));
  read_inertia(motion, n, actor);
}

void Reader::read_motion(const Value& at, const Node& n, Actor& actor) {
  const auto extension = khr(at);
  const auto mine = own(at);
  const auto motion = extension ? extension->get("motion") : std::nullopt;
  actor.type = CAROM_BODY_DYNAMIC;
  if (motion) {
    if (motion->has("isKinematic") && (*motion)["isKinematic"].boolean()) actor.type = CAROM_BODY_KINEMATIC;
    if (is_omi(*motion)) {
      if (const auto type = motion->get("type"))
        actor.type = type_named(*type);
      else
        note(motion->place() + " has no type; dynamic");
    }
    actor.linear_velocity = n.world.q * motion->vector_or("linearVelocity", Vec::Zero());
    actor.angular_velocity = n.world.q * motion->vector_or("angularVelocity", Vec::Zero());
    if (!mine) read_mass(*motion, n, actor);
  }
  if (!mine) return;
  if (const auto body = mine->get("body")) actor.type = type_named(*body);
  actor.linear_velocity = mine->vector_or("linearVelocity", actor.linear_velocity);
  actor.angular_velocity = mine->vector_or("angularVelocity", actor.angular_velocity);
  actor.mass = mine->number_or("mass", 0, 0, 1e30);
  if (mine->has("center")) actor.center = (*mine)["center"].vector();
  if (const auto inertia = mine->get("inertia")) {
    const std::vector<double> x = inertia->numbers(9);
    actor.inertia.emplace();
    for (int k = 0; k < 9; ++k) (*actor.inertia)(k / 3, k % 3) = x[static_cast<std::size_t>(k)];
  }
  if (const auto damping = mine->get("damping"))
    actor.linear_damping = damping->at(0).number(), actor.angular_damping = damping->at(1).number();
}

void Reader::finish_body(std::size_t i, std::size_t a) {
  const Value at = node(i);
  const Actor& actor = stage_.actors[a];
  const auto extension = khr(at);
  const auto mine = own(at);
  const auto motion = extension ? extension->get("motion") : std::nullopt;
  carom_world* const world = stage_.world.get();
  Call call;
  if (actor.type == CAROM_BODY_DYNAMIC) {
    std::uint32_t locks = 0;
    if (motion && !mine && !is_omi(*motion)) {
      if (motion->has("mass") && motion->number_or("mass", 1) == 0) locks |= 0x7;
      if (motion->has("inertiaDiagonal") && motion->has("mass"))
        locks |=
            (*motion)["inertiaDiagonal"].vector() == Vec::Zero() ? 0x38 : locks_of_turns(*motion, nodes_[i].world.q);
      name_what_locks_stop(*motion, locks);
    }
    if (locks) call.done(carom_body_set_locks(world, actor.body, locks, call), at.place() + "/locks");
    if (motion && motion->has("gravityFactor")) stage_.set_gravity_factor(a, (*motion)["gravityFactor"].number());
    if (mine) read_attributes(*mine, world, actor.body);
  }
  if (mine && mine->has("continuous"))
    call.done(carom_body_set_continuous(world, actor.body,
                                        checked<std::uint32_t>((*mine)["continuous"].index(3, "modes")), call),
              at.place());
}

void Reader::name_what_locks_stop(const Value& motion, std::uint32_t locks) {
  if ((locks & 0x7) && !motion.vector_or("linearVelocity", Vec::Zero()).isZero(0))
    remark(motion.place() + "/linearVelocity of an infinite mass: it stays where it is");
  if ((locks & 0x38) == 0x38 && !motion.vector_or("angularVelocity", Vec::Zero()).isZero(0))
    remark(motion.place() + "/angularVelocity of an infinite inertia: it does not turn");
}

}  // namespace carom::tools::scenefile

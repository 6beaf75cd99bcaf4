// Tables of settings and scenes.
#include "settings.h"

#include <algorithm>

namespace carom::bench {
namespace {

bool is_one_of(const std::string& scene, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return scene == name; });
}
bool something_touches(const std::string& scene) { return !is_of_joints_alone(scene); }
bool something_bounces(const std::string& scene) {
  return is_one_of(scene, {"bouncing", "bounce05", "cradle", "cannon", "elastic666"});
}
/// No friction, and no bounce that loses a share.
bool is_smooth(const std::string& scene) {
  return is_of_joints_alone(scene) || (something_bounces(scene) && scene != "bounce05");
}
/// Something that Drake takes for a polyhedron, unless it is told to take a point a pair.
bool has_round_patches(const std::string& scene) { return is_one_of(scene, {"wheel", "ladder", "grip"}); }
bool has_boxes(const std::string& scene) {
  return something_touches(scene) && !something_bounces(scene) && scene != "pack666" && scene != "skid";
}

}  // namespace

std::vector<PeerSetting> settings_of(const std::string& engine) {
  if (engine.starts_with("ODE"))
    return {{"QuickStep, 20 iterations (as it comes)", {}},
            {"QuickStep, 100 iterations", {{"iterations", 100}}},
            {"QuickStep, 400 iterations", {{"iterations", 400}}},
            {"QuickStep, 4 substeps", {{"substeps", 4}}},
            {"QuickStep, 16 substeps", {{"substeps", 16}}},
            {"exact LCP", {{"stepper", 1}}},
            {"exact LCP, 4 substeps", {{"stepper", 1}, {"substeps", 4}}},
            {"exact LCP, erp 0.8", {{"stepper", 1}, {"erp", 0.8}}}};
  if (engine.starts_with("Rapier"))
    return {{"4 iterations (as it comes)", {}},
            {"1 iteration", {{"iterations", 1}}},
            {"16 iterations", {{"iterations", 16}}},
            {"64 iterations", {{"iterations", 64}}},
            {"16 iterations, contacts of 120 Hz", {{"iterations", 16}, {"frequency", 120}}}};
  if (engine.starts_with("MuJoCo"))
    return {{"Newton, solref 20 ms (as it comes)", {}},
            {"solref two steps", {{"solref", 0}}},
            {"solref two steps, 4 substeps", {{"solref", 0}, {"substeps", 4}}},
            {"solref two steps, 16 substeps", {{"solref", 0}, {"substeps", 16}}},
            {"solref two steps, impratio 10", {{"solref", 0}, {"impratio", 10}}},
            {"solref two steps, 10 no-slip rounds", {{"solref", 0}, {"noslip", 10}}},
            {"4 substeps", {{"substeps", 4}}},
            {"16 substeps", {{"substeps", 16}}},
            {"Runge-Kutta 4", {{"integrator", 1}}, is_of_joints_alone},
            {"Runge-Kutta 4, 4 substeps", {{"integrator", 1}, {"substeps", 4}}, is_of_joints_alone}};
  if (engine.starts_with("Drake"))
    return {{"lagged (as it comes)", {}},
            {"lagged, 4 substeps", {{"substeps", 4}}},
            {"lagged, 16 substeps", {{"substeps", 16}}},
            {"lagged, stiff", {{"modulus", 1e15}, {"stiffness", 1e12}}, something_touches},
            {"lagged, round shapes by points", {{"resolution", 0}}, has_round_patches},
            {"lagged, stiff, round shapes by points",
             {{"modulus", 1e15}, {"stiffness", 1e12}, {"resolution", 0}},
             has_round_patches},
            {"lagged, stiff, 4 substeps", {{"modulus", 1e12}, {"stiffness", 1e12}, {"substeps", 4}}, something_touches},
            {"similar, boxes of 1 GPa", {{"approximation", 1}, {"modulus", 1e9}}, has_boxes},
            {"SAP", {{"approximation", 2}}, something_touches},
            {"SAP, stiff, no relaxation",
             {{"approximation", 2}, {"modulus", 1e15}, {"stiffness", 1e12}, {"threshold", 0}, {"relaxation", 0}},
             something_touches},
            {"TAMSI, stiff", {{"approximation", 3}, {"modulus", 1e15}, {"stiffness", 1e12}}, something_touches},
            {"lagged, bounces of 40 steps", {{"bounce_steps", 40}}, something_bounces},
            {"lagged, bounces of 200 steps", {{"bounce_steps", 200}}, something_bounces},
            {"CENIC, accuracy 1e-3", {{"integrator", 1}, {"accuracy", 1e-3}, {"bounce_time", 0.01}}},
            {"CENIC, accuracy 1e-5, stiff",
             {{"integrator", 1}, {"accuracy", 1e-5}, {"modulus", 1e12}, {"stiffness", 1e12}, {"bounce_time", 0.01}}},
            {"CENIC, accuracy 1e-5, 1 GPa, sticks below 10 nm/s",
             {{"integrator", 1}, {"accuracy", 1e-5}, {"modulus", 1e9}, {"stiffness", 1e9}, {"stiction", 1e-8}},
             has_boxes},
            {"implicit Euler, accuracy 1e-3", {{"integrator", 2}, {"accuracy", 1e-3}}, is_smooth},
            {"Radau 3, accuracy 1e-6", {{"integrator", 3}, {"accuracy", 1e-6}}, is_of_joints_alone},
            {"Runge-Kutta 3, accuracy 1e-6", {{"integrator", 4}, {"accuracy", 1e-6}}, is_smooth},
            {"Runge-Kutta 5, accuracy 1e-6", {{"integrator", 5}, {"accuracy", 1e-6}}, is_smooth},
            {"Runge-Kutta 5, accuracy 1e-12", {{"integrator", 5}, {"accuracy", 1e-12}}, is_smooth}};
  return {{"10 iterations (as it comes)", {}},
          {"50 iterations", {{"iterations", 50}}},
          {"200 iterations", {{"iterations", 200}}},
          {"4 substeps", {{"substeps", 4}}},
          {"16 substeps", {{"substeps", 16}}},
          {"50 iterations, erp 0", {{"iterations", 50}, {"erp", 0}}},
          {"conjugate gradients, 20", {{"solver", 1}, {"iterations", 20}}},
          {"direct (Dantzig)", {{"solver", 2}}},
          {"50 iterations, bounces from 1 cm/s on", {{"iterations", 50}, {"bounce_speed", 0.01}}}};
}

std::string note_on(const std::string& engine) {
  if (engine.starts_with("ODE"))
    return "Debian's libode-dev; sweep-and-prune space, four points a pair, friction in proportion to the normal force "
           "(dContactApprox1), bounces from 0.25 m/s on; springs as stops that give";
  if (engine.starts_with("MuJoCo"))
    return std::string(engine.starts_with("MuJoCo 2") ? "Debian's libmujoco-dev"
                                                      : "the C library of the Python wheel mujoco-core") +
           "; joints as trees of ball and slide joints in reduced coordinates, loops as equality constraints; a motor "
           "as a force and its joint's damping; elliptic cones, no collision of joined bodies; friction and "
           "restitution of each contact set to the comparison's (a bounce is a spring and damper over 20 steps)";
  if (engine.starts_with("Drake"))
    return "the Python wheel drake, a process of its own that tells its CPU time; joints as trees of ball and "
           "prismatic joints in reduced coordinates, a motor as a force and its joint's damping; boxes, capsules and "
           "cylinders by hydroelastic patches, balls by points; friction the comparison's; restitution by a spring and "
           "damper (SAP) over 10 steps; where an integrator has its own steps by a spring alone, over 1 ms "
           "(CENIC: 10 ms), and none but 0 and 1";
  if (engine.starts_with("Rapier"))
    return "the crate rapier3d-f64; a wide box in the place of a half-space, no sleeping, impulse joints, "
           "motors that hold their speed up to their force, frictions by their geometric mean, the larger restitution";
  return "Debian's; stepSimulation(dt, 0), no sleeping, gyroscopic term as it comes, restitution the larger of both";
}

const std::vector<std::string>& scenes_for_peers() {
  static const std::vector<std::string> names = {
      "pendulum",     "chain1",       "chain100",     "chain1e4",     "wrecking",     "bouncing", "bounce05",
      "cradle",       "cannon",       "elastic666",   "pack666",      "slide",        "slip",     "stick",
      "rolling",      "skid",         "stack10",      "stack20",      "stack50",      "cards",    "tower100",
      "massratio1e2", "massratio1e3", "massratio1e4", "massratio1e5", "massratio1e6", "wheel",    "cone",
      "ladder",       "grip",         "shake"};
  return names;
}

bool is_of_joints_alone(const std::string& scene) {
  return scene == "pendulum" || scene == "wrecking" || scene.starts_with("chain");
}

}  // namespace carom::bench

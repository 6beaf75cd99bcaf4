// A robot's arm by inverse dynamics: two links of 2 kg move to a pose and stay there, against gravity.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto rod = engine.shape("box", {0.5, 0.05, 0.05});
  const double center[3] = {0, 0, 0}, inertia[9] = {0.01, 0, 0, 0, 0.17, 0, 0, 0, 0.17};
  carom_body link = CAROM_NULL_HANDLE;
  carom_joint joint[2];
  for (int i = 0; i < 2; i++) {  // links along x, hinges about z
    const auto next = world.body(rod, {.position = {i + 0.5, 0, 0}});
    next.call(carom_body_set_mass, 2, center, inertia);
    auto desc = carom::make<carom_joint_desc>();
    desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.position_a[0] = i;
    desc.orientation_a[1] = -std::sqrt(0.5), desc.orientation_a[3] = std::sqrt(0.5);
    desc.body_a = link, desc.body_b = link = next.handle();
    joint[i] = world.make<carom_joint>(carom_joint_create, &desc);
  }
  const double still[2] = {0, 0}, goal[2] = {0.5, -0.5};  // rad
  double level[2], angle[2], speed[2], wanted[2], torque[2];
  world.call(carom_tree_get_forces, link, still, nullptr, level, 2);  // what bears the weight in the first pose
  const auto scalar = CAROM_SCALAR_F64;
  for (int step = 0; step < 120; step++) {
    world.call(carom_world_read_joints, CAROM_JOINT_BULK_POSITION, scalar, joint, 2, angle, 0);
    world.call(carom_world_read_joints, CAROM_JOINT_BULK_VELOCITY, scalar, joint, 2, speed, 0);
    for (int i = 0; i < 2; i++) wanted[i] = 400 * (goal[i] - angle[i]) - 40 * speed[i];  // rad/s^2
    world.call(carom_tree_get_forces, link, nullptr, wanted, torque, 2);
    world.call(carom_world_write_joints, CAROM_JOINT_BULK_TARGET_EFFORT, scalar, joint, 2, torque, 0);
    world.step(1.0 / 60);
  }
  std::printf("%.2f and %.2f N m hold it level; after 2 s it is at %.2f and %.2f rad\n", level[0], level[1], angle[0],
              angle[1]);
  const bool good = std::abs(level[0] - 4 * 9.81) < 1e-9 && std::abs(level[1] - 9.81) < 1e-9 &&
                    std::abs(angle[0] - 0.5) < 0.005 && std::abs(angle[1] + 0.5) < 0.005;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}

"""A robot's arm by inverse dynamics: two links of 2 kg move to a pose and stay there, against gravity."""
import carom

with carom.Engine() as engine, engine.world() as world:
    rod, before = engine.box(0.5, 0.05, 0.05), None
    for i in range(2):  # links along x, hinges about z
        link = world.body(rod, position=(i + 0.5, 0, 0), mass=2, center=(0, 0, 0), inertia=(0.01, 0, 0, 0, 0.17, 0, 0, 0, 0.17))
        world.joint("hinge", before, link, position=(i, 0, 0), axis=(0, 0, 1))
        before = link
    arm, goal = world.tree(link), (0.5, -0.5)  # rad
    level = arm.forces(speeds=[0, 0])  # what bears the weight in the first pose
    for _ in range(120):
        angle, speed = world.read_joints("position")[:, 0], world.read_joints("velocity")[:, 0]
        wanted = [400 * (goal[i] - angle[i]) - 40 * speed[i] for i in range(2)]  # rad/s^2
        world.write_joints("target_effort", arm.forces(wanted))
        world.step(1 / 60)
    print(f"{level[0]:.2f} and {level[1]:.2f} N m hold it level; after 2 s it is at {angle[0]:.2f} and {angle[1]:.2f} rad")
    assert abs(level[0] - 4 * 9.81) < 1e-9 and abs(level[1] - 9.81) < 1e-9
    assert abs(angle[0] - 0.5) < 0.005 and abs(angle[1] + 0.5) < 0.005

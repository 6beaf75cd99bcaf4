"""Joints and a motor: a motor turns a hinge at 1 rad/s, and a limit stops it at 1 rad."""
import carom

with carom.Engine() as engine, engine.world() as world:
    rod = world.body(engine.box(0.5, 0.05, 0.05), position=(0.5, 0, 0))
    hinge = world.joint("hinge", None, rod, position=(0, 0, 0), axis=(0, 0, 1))
    hinge.motor("twist", speed=1, max_force=200)  # rad/s, N m
    hinge.limit("twist", lower=-1, upper=1)  # rad
    angle = []
    for _ in range(2):
        for _ in range(30 + 90 * len(angle)):
            world.step(1 / 60)
        angle.append(hinge.state.coordinate["twist"])
    print(f"{angle[0]:.2f} rad after 0.5 s, {angle[1]:.2f} rad after 2.5 s, at the limit")
    assert abs(angle[0] - 0.5) < 0.02 and abs(angle[1] - 1) < 0.01

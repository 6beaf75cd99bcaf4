"""Bulk arrays: velocities of 1000 balls are set in one call, their positions read in one."""
import carom
import numpy as np

with carom.Engine() as engine, engine.world() as world:
    n = 10
    begin = np.array([(2 * i, 5 + 2 * j, 2 * k) for i in range(n) for j in range(n) for k in range(n)], dtype=float)
    balls = world.create_bodies(begin, engine.sphere(0.5))  # handles
    up = np.tile((0, 9.81 / 2, 0), (len(balls), 1))
    world.write("linear_velocity", up, balls)
    height = [begin[:, 1].mean()]
    for _ in range(2):
        for _ in range(30):
            world.step(1 / 60)
        height.append(world.read("position", balls)[:, 1].mean())
    print(f"{len(balls)} balls rise by {height[1] - height[0]:.3f} m and are back after 1 s, {abs(height[2] - height[0]):.3f} m off")
    assert abs(height[1] - height[0] - 9.81 / 8) < 1e-9 and abs(height[2] - height[0]) < 1e-9

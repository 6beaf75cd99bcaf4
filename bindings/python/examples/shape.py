"""A shape of your own: a support function is all of it. An elliptic cylinder, its axis upright."""
import math

import carom


def support(params, direction):
    """The farthest point of the shape along a direction."""
    a, h, b = params
    x, y, z = direction
    length = math.hypot(a * x, b * z)
    return (a * a * x / length if length else 0, math.copysign(h, y), b * b * z / length if length else 0)


with carom.Engine() as engine, engine.world() as world:
    world.ground()
    half = [(name, "m", 1e-6, 1e3) for name in ("a", "h", "b")]
    kind = engine.support_plugin(support, "example.elliptic_cylinder", params=half)
    body = world.body(kind(0.6, 0.2, 0.3), position=(0, 1, 0))  # 1000 kg/m^3
    for _ in range(120):
        world.step(1 / 60)
    print(f"it weighs {body.mass:.0f} kg and lies at y = {body.position[1]:.2f} m")
    assert abs(body.mass / (1000 * math.pi * 0.6 * 0.3 * 0.4) - 1) < 0.005 and abs(body.position[1] - 0.2) < 0.005

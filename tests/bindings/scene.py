"""The scene of scene.c, by way of the Python package."""
import math

import carom

TOP_PARAMS = [("radius", "m", 1e-9, 1e8), ("half_height", "m", 1e-9, 1e8)]


def top_support(params, direction):
    """plugins/template/template.c, operation by operation: a double cone."""
    r, h = params
    x, y, z = direction
    side = max(abs(x), abs(z))
    largest = max(side, abs(y))
    length = 0.0
    if side > 0:
        x, z = x / side, z / side
        length = math.sqrt(x * x + z * z)
        x, z = x / length, z / length
    if h * (abs(y) / largest) > r * (length * (side / largest)):
        return 0.0, h if y >= 0 else -h, 0.0
    return r * x, 0.0, r * z


def hashes(engine, top):
    """@param top  the double cone: a Shape   @return hashes of the world after 1, 2 and 3 s"""
    shapes = [engine.sphere(0.3), engine.box(0.4, 0.25, 0.3), top]
    ground = engine.half_space((0, 1, 0), 0)
    found = []
    with engine.world(substeps=5) as world:
        world.wind = 1.5, 0, 0.5
        surface = world.material(friction=0.6, restitution=0.3)
        world.body(ground, type="static", material=surface)
        for i in range(1, 19):
            thing = world.body(shapes[i % 3], position=((i % 3) * 0.5, 0.6 + i * 0.55, (i % 2) * 0.4),
                               angular_velocity=(0.5 * i, 0, 1), density=400 + 50 * i, material=surface)
            thing.drag = 0.1, 0.02
        door = world.body(shapes[1], position=(4.5, 3, 0))
        world.joint("hinge", None, door, position=(4, 3, 0), orientation=(0, -0.6, 0, 0.8))
        for _ in range(3):
            for _ in range(60):
                world.step(1 / 60)
            found.append(f"{world.hash:016x}")
    return found


if __name__ == "__main__":
    with carom.Engine() as engine:
        print("\n".join(hashes(engine, engine.shape("carom.template", (0.35, 0.4)))))

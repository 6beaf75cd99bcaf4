"""Ground of a height field, in whose valley a ball comes to rest, and of triangles, down which a crate slides."""
import math

import carom

with carom.Engine() as engine, engine.world() as world:
    valley = [[0.25 * max(0, math.hypot(x, z) - 1) for x in range(-4, 5)] for z in range(-4, 5)]  # m, rows along z
    world.body(engine.height_field(valley, spacing=(1, 1)), position=(-4, 0, -4), type="static")  # of its corner
    ball = world.body(engine.sphere(0.5), position=(3, 2, 1), linear_damping=0.5, angular_damping=0.5)
    tilt = math.radians(30)
    fall, along = 9 * math.sin(tilt), 9 * math.cos(tilt)
    corners = [(x, y, z) for x, y in ((6, 4), (6 + along, 4 - fall), (6 + along, 7 - fall)) for z in (-2, 2)]  # a wall at its end
    world.body(engine.mesh(corners, [(0, 1, 2), (2, 1, 3), (2, 3, 4), (4, 3, 5)]), type="static")
    about = (0, 0, -math.sin(tilt / 2), math.cos(tilt / 2))  # the ramp's tilt
    start = (6 + math.cos(tilt) + 0.5 * math.sin(tilt), 4 - math.sin(tilt) + 0.5 * math.cos(tilt), 0)  # 1 m down
    crate = world.body(engine.box(0.5, 0.5, 0.5), position=start, orientation=about, material=world.material(friction=0))
    for _ in range(60):
        world.step(1 / 60)
    way = math.dist(crate.position, start)
    for _ in range(600):
        world.step(1 / 60)
    print(f"the crate slides by {way:.2f} m in 1 s, and the ball lies at y = {ball.position[1]:.2f} m")
    assert abs(way - 9.81 * math.sin(tilt) / 2) < 0.01 and abs(ball.position[1] - 0.5) < 0.005 and abs(ball.position[0]) < 2

"""Casts and overlaps: how far a crate can be moved before it touches, and what a blast of 2 m reaches."""
import carom

with carom.Engine() as engine, engine.world() as world:
    world.ground()
    wall = world.body(engine.box(0.5, 2, 2), position=(5, 2, 0), type="static")
    ball = engine.sphere(0.5)
    balls = [world.body(ball, position=(0, 6, z)) for z in (1, -2, 4)]
    for _ in range(120):
        world.step(1 / 60)  # they fall to the ground
    crate = engine.box(0.5, 0.5, 0.5)  # of no body: it only asks
    hit = world.cast(crate, (0, 1, 0), (8, 0, 0))  # time is a fraction of the way
    found = world.overlaps(engine.sphere(2), (0, 0.5, 0))
    reached = [one.body for one in found if one.body in balls]
    print(f"{8 * hit.time:.2f} m to the wall, and {len(reached)} of {len(balls)} balls lie within 2 m")
    assert hit.body == wall and abs(8 * hit.time - 4) < 1e-4 and reached == balls[:2]

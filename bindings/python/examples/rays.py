"""Rays: what is below a point, how far, and that beside it lies the ground."""
import carom

with carom.Engine() as engine, engine.world() as world:
    ground = world.ground()
    ball = world.body(engine.sphere(0.5), position=(0, 2, 0))
    for _ in range(120):
        world.step(1 / 60)
    hit = world.ray((0, 5, 0), (0, -1, 0))  # from, direction; time counts in lengths of the direction
    beside = world.ray((3, 5, 0), (0, -1, 0))
    above = world.ray((0, 5, 0), (0, 1, 0))
    print(f"{hit.time:.2f} m down lies the ball, beside it {beside.time:.2f} m down the ground, above it nothing")
    assert hit.body == ball and abs(hit.time - 4) < 0.01
    assert beside.body == ground and abs(beside.time - 5) < 1e-6 and above is None

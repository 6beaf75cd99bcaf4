"""Bodies and stacks: ten boxes stand on each other, to a millimetre a box."""
import carom

with carom.Engine() as engine, engine.world() as world:
    world.ground()
    box = engine.box(0.5, 0.5, 0.5)  # half extents, m; of 1000 kg/m^3, where nothing else is said
    boxes = [world.body(box, position=(0, 0.52 + 1.02 * i, 0)) for i in range(10)]
    for _ in range(180):
        world.step(1 / 60)
    x, y, z = boxes[9].position
    print(f"10 boxes of {boxes[0].mass:.0f} kg stand for 3 s, the top one at y = {y:.2f} m")
    assert abs(y - 9.5) < 0.01 and abs(x) < 0.01 and abs(z) < 0.01

"""A character walks over three steps of 0.2 m, and pushes a crate that stands there."""
import carom

with carom.Engine() as engine, engine.world() as world:
    world.ground()
    for i in range(3):
        world.body(engine.box(2, 0.1, 2), position=(3 + 0.5 * i, 0.1 + 0.2 * i, 0), type="static")
    crate = world.body(engine.box(0.2, 0.2, 0.2), position=(3, 0.8, 0))
    walker = carom.Character(world, engine.capsule(0.3, 0.6), position=(0, 1, 0), step_up=0.25)
    for _ in range(180):
        world.step(1 / 60)
        walker.move((1.5, 0, 0), 1 / 60)
        walker.push(1 / 60)
    feet, pushed = walker.position[1] - walker.foot, crate.position[0] - 3
    print(f"after 3 s it stands on {walker.ground} ground, {feet:.2f} m up, and has pushed a crate by {pushed:.1f} m")
    assert walker.ground == "firm" and abs(feet - 0.6 - 0.0102) < 1e-4  # a skin of 0.01 m and 2 % lies between
    assert 1 < pushed < 2 and crate in [contact.body for contact in walker.contacts]

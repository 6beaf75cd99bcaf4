"""Saving and loading: a world as bytes, for a file, goes on in another engine with the same bits."""
import carom

with carom.Engine() as engine, engine.world() as world:
    world.ground()
    for i in range(5):
        world.body(engine.box(0.5, 0.5, 0.5), position=(0.1 * i, 0.5 + 1.1 * i, 0))
    for _ in range(60):
        world.step(1 / 60)
    saved = world.save(whole=True)  # with bodies and shapes: open("five.world", "wb").write(saved)
    with carom.Engine() as other, other.world() as copy:
        other.plugin("carom.box")  # the shapes of what is loaded
        copy.restore(saved)  # into a world in which nothing was made yet
        for _ in range(60):
            world.step(1 / 60)
            copy.step(1 / 60)
        same = world.hash == copy.hash
        top = copy.bodies[-1].position[1]
        print(f"{len(copy.bodies)} bodies went on, the last one is at y = {top:.2f} m; the same bits: {'yes' if same else 'no'}")
        assert same and abs(top - 4.5) < 0.01

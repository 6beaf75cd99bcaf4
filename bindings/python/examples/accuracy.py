"""An accuracy that is asked for: a pendulum is off by no more than a micrometre per second of motion."""
import carom

with carom.Engine() as engine, engine.world() as world:
    ball = world.body(engine.sphere(0.1), position=(1, 0, 0))
    world.joint("ball", None, ball, position=(0, 0, 0))
    world.set_accuracy(place=1e-6, turn=1e-6)  # m and rad per second
    for _ in range(120):
        world.step(1 / 60)
    worst = world.islands()[0]
    print(f"after 2 s at x = {ball.position[0]:.5f} m; the error is within what was asked: {'yes' if worst.share <= 1 else 'no'}")
    assert abs(ball.position[0] - 0.785070) < 5e-6 and worst.share <= 1  # by its equation of motion

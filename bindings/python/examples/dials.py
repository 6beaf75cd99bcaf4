"""Dials: a pendulum of a preset for crowds, and the same with one dial turned."""
import carom


def error(*dials):
    """m, after 2 s; where the ball should be follows from the equation of motion."""
    with carom.Engine() as engine, engine.world() as world:
        world.set_preset("fast")
        for name, value in dials:
            world.dials[name] = value
        ball = world.body(engine.sphere(0.1), position=(1, 0, 0))
        world.joint("ball", None, ball, position=(0, 0, 0))
        for _ in range(120):
            world.step(1 / 60)
        return abs(ball.position[0] - 0.7850683)


fast, finer, exact = error(), error(("substeps", 8)), error(("substeps", 8), ("joint_order", 4))
print(f"off by {1e3 * fast:.2f} mm; with 8 substeps by {1e3 * finer:.3f} mm; of order 4 by less than 1 um: {'yes' if exact < 1e-6 else 'no'}")
assert fast > 1e-3 > 10 * finer and exact < 1e-6

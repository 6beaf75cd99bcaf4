"""Snapshots and rollback: a guess about a player was wrong, so 30 steps are made again with what was really done."""
import carom


def play(world, ball, pushes, steps):
    for step in steps:
        if step in pushes:
            ball.linear_velocity = pushes[step]  # m/s
        world.step(1 / 60)


with carom.Engine() as engine, engine.world() as world:
    world.ground()
    ball = world.body(engine.sphere(0.5), position=(0, 0.5, 0))
    play(world, ball, {}, range(60))
    truth = world.fork()  # a world in which nothing is guessed
    saved = world.save()
    play(world, ball, {}, range(60, 90))  # the guess: no push
    guess = ball.position[0]
    world.restore(saved)
    done = {70: (2, 0, 0)}
    play(world, ball, done, range(60, 90))
    play(truth, truth.counterpart(ball), done, range(60, 90))
    same = world.hash == truth.hash
    print(f"guessed x = {guess:.2f} m, it was {ball.position[0]:.2f} m; the same bits as without a guess: {'yes' if same else 'no'}")
    assert same and abs(guess) < 1e-6 and ball.position[0] > 0.4
    truth.close()

"""Ten mistakes, each marked: mypy finds these and no others. Read by tests/bindings/test_typed.py, never run."""
import carom

with carom.Engine() as engine, engine.world() as world:
    ball = world.body(engine.sphere(0.5))
    engine.sphere("0.5")  # mistake: a number is no text
    world.body(engine.sphere(1), position=3)  # mistake: a position has three numbers
    world.body(type="dynamical")  # mistake: no such type of bodies
    world.body(engine)  # mistake: an engine is no shape
    world.joint("hinge", ball).limit("twist", low=0)  # mistake: it is called lower
    engine.world(substep=8)  # mistake: no such dial
    ball.center = (0, 1, 0)  # mistake: the centre follows from the mass; set_mass() takes one
    print(world.contacts()[0].seperation)  # mistake: misspelt
    print(world.ray((0, 9, 0), (0, -1, 0)).point)  # mistake: it may have met nothing
    print(world.read("position") + "m")  # mistake: an array plus text

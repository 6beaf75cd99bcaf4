"""Scenes whose answer is known, for test_measure.py: draws a scene of a kind from a seed, with the question, its parameters, and the truth.

A truth is a closed form where there is one; else the equation of motion, integrated here by a Runge-Kutta method of fourth order at steps
that leave 1e-11; else the engine's own finer run.
"""
import math
import random

G = 9.81
SLOPE = 1e-4  # relative width of difference quotients of a truth


class Scene:
    """question(trial, **parameters), and truth(**parameters) -> number, or None."""

    def __init__(self, kind, question, parameters, truth=None):
        self.kind, self.question, self.parameters, self.truth = kind, question, parameters, truth

    def slope(self, name):
        """Of the truth, by a difference quotient of fourth order."""
        width = SLOPE * abs(self.parameters[name]) * 20

        def at(steps):
            return self.truth(**{**self.parameters, name: self.parameters[name] + steps * width})

        return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * width)


def follow(rates, state, seconds, steps):
    """The state at the end of an equation of motion."""
    h, y = seconds / steps, list(state)
    for _ in range(steps):
        a = rates(y)
        b = rates([u + h / 2 * v for u, v in zip(y, a)])
        c = rates([u + h / 2 * v for u, v in zip(y, b)])
        d = rates([u + h * v for u, v in zip(y, c)])
        y = [u + h / 6 * (p + 2 * q + 2 * r + s) for u, p, q, r, s in zip(y, a, b, c, d)]
    return y


def turned(angle):
    """About z."""
    return 0, 0, math.sin(angle / 2), math.cos(angle / 2)


# ---- kinds ----


def throw(draw):
    """When a thrown ball lands, and where."""
    def question(trial, speed, height):
        world = trial.world()
        world.ground()
        ball = world.body(trial.engine.sphere(0.1), position=(0, height + 0.1, 0), linear_velocity=(2, speed, 0))
        return trial.until(world, lambda w: trial.touches(w, ball), most=10)

    return question, {"speed": draw(1, 6), "height": draw(0.5, 3)}, lambda speed, height: (speed + math.sqrt(speed**2 + 2 * G * height)) / G


def slide(draw):
    """Where a sliding box stops."""
    turn = draw(0, 3)

    def question(trial, friction, speed):
        world = trial.world()
        wood = world.material(friction=friction)
        world.ground(material=wood)
        box = world.body(trial.engine.box(0.5, 0.2, 0.4), position=(0, 0.2, 0), material=wood,
                         linear_velocity=(speed * math.cos(turn), 0, speed * math.sin(turn)))
        trial.run(world, seconds=speed / friction / 4)
        return math.hypot(box.position[0], box.position[2])

    return question, {"friction": draw(0.2, 0.7), "speed": draw(1, 4)}, lambda friction, speed: speed**2 / (2 * friction * G)


def incline(draw):
    """How far a box slides down a slope."""
    angle, seconds = draw(0.5, 0.9), draw(0.5, 1.5)

    def question(trial, friction):
        world = trial.world()
        wood = world.material(friction=friction)
        up = (-math.sin(angle), math.cos(angle), 0)
        world.ground(normal=up, material=wood)
        box = world.body(trial.engine.box(0.3, 0.1, 0.3), position=[0.1 * x for x in up], orientation=turned(angle), material=wood)
        trial.run(world, seconds)
        return math.dist(box.position, [0.1 * x for x in up])

    def truth(friction):
        return 0.5 * G * (math.sin(angle) - friction * math.cos(angle)) * seconds**2

    return question, {"friction": draw(0.05, 0.4)}, truth


def pendulum(draw):
    """Where a rod on a hinge is after a while."""
    start, seconds = draw(0.5, 2.5), draw(1, 3)

    def question(trial, length):
        world = trial.world()
        rod = world.body(trial.engine.box(0.02, length / 2, 0.02), position=(length / 2 * math.sin(start), -length / 2 * math.cos(start), 0),
                         orientation=turned(start), mass=1, inertia=(length**2 / 12, 0, 0, 0, 1e-3, 0, 0, 0, length**2 / 12))
        world.joint("hinge", None, rod, position=(0, 0, 0), axis=(0, 0, 1))
        trial.run(world, seconds)
        return rod.position[0]

    def truth(length):
        angle, _ = follow(lambda y: (y[1], -1.5 * G / length * math.sin(y[0])), (start, 0), seconds, 4000)
        return length / 2 * math.sin(angle)

    return question, {"length": draw(0.5, 1.5)}, truth


def double_pendulum(draw):
    """Where the second of two balls on rods is, before chaos."""
    first, second, seconds = draw(0.3, 1.2), draw(-1, 1), draw(0.8, 2)

    def question(trial, ratio):
        world = trial.world()
        x1, y1 = math.sin(first), -math.cos(first)
        x2, y2 = x1 + math.sin(second), y1 - math.cos(second)
        a = world.body(trial.engine.sphere(0.01), position=(x1, y1, 0), mass=1, inertia=(1e-9, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9), center=(0, 0, 0))
        b = world.body(trial.engine.sphere(0.01), position=(x2, y2, 0), mass=ratio, inertia=(1e-9, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9), center=(0, 0, 0))
        world.joint("ball", None, a, position=(0, 0, 0))
        world.joint("ball", a, b, position=(x1, y1, 0))
        trial.run(world, seconds)
        return b.position[0]

    def truth(ratio):
        def rates(y):
            a, b, u, v = y
            m, c, s = ratio, math.cos(a - b), math.sin(a - b)
            # [1 + m, m c; m c, m] [u' v'] = [-m s v^2 - (1 + m) g sin a, m s u^2 - m g sin b]
            p, q = -m * s * v * v - (1 + m) * G * math.sin(a), m * s * u * u - m * G * math.sin(b)
            i, j = 1 + m + 1e-9, m + 1e-9  # with what the balls' own inertia adds
            det = i * j - m * m * c * c
            return u, v, (j * p - m * c * q) / det, (i * q - m * c * p) / det

        a, b, _, _ = follow(rates, (first, second, 0, 0), seconds, 4000)
        return math.sin(a) + math.sin(b)

    return question, {"ratio": draw(0.3, 2)}, truth


def skid(draw):
    """How far a ball that starts without spin has come when it has rolled for a while."""
    seconds = draw(1.5, 2.5)

    def question(trial, friction, speed):
        world = trial.world()
        wood = world.material(friction=friction)
        world.ground(material=wood)
        ball = world.body(trial.engine.sphere(0.2), position=(0, 0.2, 0), linear_velocity=(speed, 0, 0), material=wood)
        trial.run(world, seconds)
        return ball.position[0]

    def truth(friction, speed):
        until = 2 * speed / (7 * friction * G)
        return speed * until - 0.5 * friction * G * until**2 + 5 / 7 * speed * (seconds - until)

    return question, {"friction": draw(0.2, 0.6), "speed": draw(1, 5)}, truth


def bounce(draw):
    """When a ball hits the ground for the third time."""
    radius = draw(0.05, 0.2)

    def question(trial, restitution, height):
        world = trial.world()
        rubber = world.material(restitution=restitution, friction=0)
        world.ground(material=rubber)
        ball = world.body(trial.engine.sphere(radius), position=(0, height + radius, 0), material=rubber)
        time = trial.until(world, lambda w: trial.touches(w, ball), most=5)
        for _ in range(2):
            time += trial.run(world, 0.05)  # in the air
            time += trial.until(world, lambda w: trial.touches(w, ball), most=5)
        return time

    def truth(restitution, height):
        return math.sqrt(2 * height / G) * (1 + 2 * restitution + 2 * restitution**2)

    return question, {"restitution": draw(0.5, 0.9), "height": draw(0.5, 2)}, truth


def spring(draw):
    """Where a weight on a damped spring is."""
    mass, seconds = draw(0.5, 2), draw(1, 3)

    def question(trial, stiffness, damping):
        world = trial.world(gravity=(0, 0, 0))
        ball = world.body(trial.engine.sphere(0.1), position=(1.5, 0, 0), mass=mass)
        world.spring(None, ball, rest=1, stiffness=stiffness, damping=damping)
        trial.run(world, seconds)
        return ball.position[0]

    def truth(stiffness, damping):
        slows = damping / mass / 2
        swing = math.sqrt(stiffness / mass - slows**2)
        return 1 + 0.5 * math.exp(-slows * seconds) * (math.cos(swing * seconds) + slows / swing * math.sin(swing * seconds))

    return question, {"stiffness": draw(10, 60), "damping": draw(0.1, 1)}, truth


def damped(draw):
    """How far a ball comes that the air slows down."""
    seconds = draw(0.5, 2)

    def question(trial, damping, speed):
        world = trial.world(gravity=(0, 0, 0))
        ball = world.body(trial.engine.sphere(0.1), linear_velocity=(speed, 0, 0), linear_damping=damping)
        trial.run(world, seconds)
        return ball.position[0]

    return question, {"damping": draw(0.2, 3), "speed": draw(1, 9)}, lambda damping, speed: speed * (1 - math.exp(-damping * seconds)) / damping


def top(draw):
    """Which way an axis of a free box points."""
    spin, seconds = (draw(0.5, 3), draw(1, 4), draw(0.5, 3)), draw(1, 2)

    def question(trial, faster):
        world = trial.world(gravity=(0, 0, 0))
        box = world.body(trial.engine.box(0.1, 0.2, 0.3), mass=1, inertia=(0.13 / 3, 0, 0, 0, 0.1 / 3, 0, 0, 0, 0.05 / 3), center=(0, 0, 0),
                         angular_velocity=[faster * w for w in spin])
        trial.run(world, seconds)
        x, y, z, w = box.orientation
        return 2 * (x * y + w * z)  # height of its x axis

    def truth(faster):
        inertia = (0.13 / 3, 0.1 / 3, 0.05 / 3)

        def rates(s):
            (i, j, k), (a, b, c), (x, y, z, w) = inertia, s[:3], s[3:]
            return ((j - k) / i * b * c, (k - i) / j * c * a, (i - j) / k * a * b,
                    (w * a + y * c - z * b) / 2, (w * b + z * a - x * c) / 2, (w * c + x * b - y * a) / 2, -(x * a + y * b + z * c) / 2)

        *_, x, y, z, w = follow(rates, [faster * s for s in spin] + [0, 0, 0, 1], seconds, 4000)
        return 2 * (x * y + w * z)

    return question, {"faster": draw(0.8, 1.5)}, truth


def collision(draw):
    """How fast a ball is that another one hit."""
    def question(trial, mass, restitution):
        world = trial.world(gravity=(0, 0, 0))
        ivory = world.material(restitution=restitution, friction=0)
        ball = trial.engine.sphere(0.1)
        world.body(ball, linear_velocity=(3, 0, 0), mass=1, material=ivory)
        other = world.body(ball, position=(1, 0, 0), mass=mass, material=ivory)
        trial.run(world, seconds=1)
        return other.linear_velocity[0]

    return question, {"mass": draw(0.3, 3), "restitution": draw(0.2, 1)}, lambda mass, restitution: 3 * (1 + restitution) / (1 + mass)


def rolls_down(draw):
    """How far a ball rolls down a slope."""
    seconds = draw(0.5, 2)

    def question(trial, angle):
        world = trial.world()
        wood = world.material(friction=0.9)
        up = (-math.sin(angle), math.cos(angle), 0)
        world.ground(normal=up, material=wood)
        ball = world.body(trial.engine.sphere(0.2), position=[0.2 * x for x in up], material=wood)
        trial.run(world, seconds)
        return math.dist(ball.position, [0.2 * x for x in up])

    return question, {"angle": draw(0.1, 0.6)}, lambda angle: 0.5 * 5 / 7 * G * math.sin(angle) * seconds**2


def off_a_ball(draw):
    """At which angle from the top a ball without friction leaves a large one."""
    start, radius = draw(0.2, 0.4), draw(0.05, 0.2)

    def question(trial, size):
        world = trial.world()
        ice = world.material(friction=0)
        world.body(trial.engine.sphere(size), type="static", material=ice)
        way = size + radius
        ball = world.body(trial.engine.sphere(radius), position=(way * math.sin(start), way * math.cos(start), 0), material=ice)
        trial.until(world, lambda w: ball.position[1] < 0, most=5)
        return ball.linear_velocity[0]

    def truth(size):  # it leaves at cos = 2/3 cos(start), with v^2 = g way cos
        cos = 2 / 3 * math.cos(start)
        return math.sqrt(G * (size + radius) * cos) * cos

    return question, {"size": draw(0.5, 1.5)}, truth


def motor(draw):
    """How far a motor of limited torque has turned a wheel until it is fast, and on."""
    inertia, seconds = draw(0.5, 2), draw(1, 2)

    def question(trial, torque, speed):
        world = trial.world(gravity=(0, 0, 0))
        wheel = world.body(trial.engine.sphere(0.1), mass=1, inertia=(inertia, 0, 0, 0, inertia, 0, 0, 0, inertia), center=(0, 0, 0))
        hinge = world.joint("hinge", None, wheel, position=(0, 0, 0), axis=(0, 0, 1))
        hinge.motor("twist", speed=speed, max_force=torque)
        trial.run(world, seconds)
        x, y, z, w = wheel.orientation
        return math.sin(2 * math.atan2(z, w))

    def truth(torque, speed):
        until = speed * inertia / torque
        turn = 0.5 * torque / inertia * seconds**2 if until > seconds else speed * seconds - 0.5 * speed * until
        return math.sin(turn)

    return question, {"torque": draw(1, 4), "speed": draw(0.5, 1.5)}, truth


def pulley(draw):
    """How far the heavier of two weights on a rope sinks."""
    seconds = draw(0.3, 0.8)

    def question(trial, heavy):
        world = trial.world()
        ball = trial.engine.sphere(0.1)
        a = world.body(ball, position=(-1, 0, 0), mass=1)
        b = world.body(ball, position=(1, 0, 0), mass=heavy)
        rope = world.joint("pulley", a, b)
        rope.transmission(ratio=1, anchor_a=(-1, 4, 0), anchor_b=(1, 4, 0))
        trial.run(world, seconds)
        return b.position[1]

    return question, {"heavy": draw(1.2, 3)}, lambda heavy: -0.5 * G * (heavy - 1) / (heavy + 1) * seconds**2


def board(draw):
    """How far a board has come that a block is thrown onto, when both go on together."""
    seconds = draw(1, 2)

    def question(trial, friction, ratio):
        world = trial.world()
        ice, wood = world.material(friction=0, friction_mix="maximum"), world.material(friction=friction, friction_mix="maximum")
        world.ground(material=ice)
        plank = world.body(trial.engine.box(2, 0.1, 0.5), position=(0, 0.1, 0), mass=ratio, material=ice)
        world.body(trial.engine.box(0.2, 0.1, 0.2), position=(-1, 0.3, 0), mass=1, linear_velocity=(2, 0, 0), material=wood)
        trial.run(world, seconds)
        return plank.position[0]

    def truth(friction, ratio):
        push = friction * G / ratio
        until = 2 / (friction * G + push)
        return 0.5 * push * until**2 + push * until * (seconds - until)

    return question, {"friction": draw(0.3, 0.6), "ratio": draw(1, 4)}, truth


def tips(draw):
    """When a box that leans over its edge has fallen on its side."""
    half = draw(0.3, 0.6)

    def question(trial, lean):
        world = trial.world()
        rough = world.material(friction=2)
        world.ground(material=rough)
        # About its lower right edge, at the origin; the middle is above the edge at the angle atan(0.15 / half).
        middle = (-0.15 * math.cos(lean) + half * math.sin(lean), half * math.cos(lean) + 0.15 * math.sin(lean), 0)
        box = world.body(trial.engine.box(0.15, half, 0.3), position=middle, orientation=turned(-lean), material=rough)
        return trial.until(world, lambda w: 2 * math.atan2(box.orientation[2], box.orientation[3]) + lean < -0.6, most=5)

    def truth(lean):
        first, way = lean - math.atan2(0.15, half), math.hypot(0.15, half)
        pull, inertia = G * way, way**2 + (0.15**2 + half**2) / 3

        def fallen(seconds):
            return follow(lambda y: (y[1], pull / inertia * math.sin(y[0])), (first, 0), seconds, 600)[0] - first - 0.6

        low, high = 0.0, 3.0
        while high - low > 1e-12:
            middle = (low + high) / 2
            low, high = (low, middle) if fallen(middle) > 0 else (middle, high)
        return low

    return question, {"lean": math.atan2(0.15, half) + draw(0.05, 0.3)}, truth


def belt(draw):
    """How far a parcel has come that was put on a moving belt."""
    seconds = draw(1, 2)

    def question(trial, friction, speed):
        world = trial.world()
        wood = world.material(friction=friction)
        world.body(trial.engine.box(50, 0.5, 1), position=(0, -0.5, 0), type="kinematic", linear_velocity=(speed, 0, 0), material=wood)
        box = world.body(trial.engine.box(0.2, 0.1, 0.2), position=(0, 0.1, 0), material=wood)
        trial.run(world, seconds)
        return box.position[0]

    def truth(friction, speed):
        until = min(speed / (friction * G), seconds)
        return 0.5 * friction * G * until**2 + speed * (seconds - until)

    return question, {"friction": draw(0.2, 0.6), "speed": draw(0.5, 2)}, truth


def stone(draw):
    """When a thrown lump lands: a hull that turns."""
    corners = [(draw(-0.3, 0.3), draw(-0.3, 0.3), draw(-0.3, 0.3)) for _ in range(12)]
    spin = [draw(-4, 4) for _ in range(3)]

    def question(trial, speed):
        world = trial.world()
        world.ground()
        lump = world.body(trial.engine.hull(corners), position=(0, 1, 0), linear_velocity=(1, speed, 0), angular_velocity=spin)
        return trial.until(world, lambda w: trial.touches(w, lump), most=5)

    return question, {"speed": draw(1, 5)}, None


def skittle(draw):
    """How far a box is pushed that a ball hits off its middle."""
    off = draw(0.02, 0.15)

    def question(trial, speed):
        world = trial.world()
        wood = world.material(friction=0.5, restitution=0.3)
        world.ground(material=wood)
        world.body(trial.engine.sphere(0.15), position=(-1, 0.2, off), linear_velocity=(speed, 0, 0), mass=2, material=wood)
        box = world.body(trial.engine.box(0.2, 0.2, 0.2), position=(0, 0.2, 0), mass=2, material=wood)
        trial.run(world, seconds=1.5)
        return box.position[0]

    return question, {"speed": draw(2, 4)}, None


def leaning(draw):
    """How far a pole has slipped down a wall that it leans on; both without friction."""
    seconds = draw(0.2, 0.3)

    def question(trial, angle):
        world = trial.world()
        ice = world.material(friction=0)
        world.ground(material=ice)
        world.ground(normal=(1, 0, 0), material=ice)
        pole = world.body(trial.engine.capsule(0.02, 0.5), material=ice, orientation=turned(angle),
                          position=(0.02 + 0.5 * math.sin(angle), 0.02 + 0.5 * math.cos(angle), 0))
        trial.run(world, seconds)
        return pole.position[0]

    def truth(angle):
        # Of a capsule: 1 m long between its ends' middles, radius 0.02 m.
        rod, ball = math.pi * 0.02**2, 4 / 3 * math.pi * 0.02**3
        turns = rod * (0.02**2 / 4 + 1 / 12) + ball * (2 / 5 * 0.02**2 + 0.5**2 + 2 * 3 / 8 * 0.02 * 0.5)
        inertia = turns / (rod + ball) + 0.25
        end, _ = follow(lambda y: (y[1], 0.5 * G * math.sin(y[0]) / inertia), (angle, 0), seconds, 1000)
        return 0.02 + 0.5 * math.sin(end)

    return question, {"angle": draw(0.3, 0.5)}, truth


def rolls_off(draw):
    """How fast a ball is, to the side, that rolled off a large one."""
    start, radius = draw(0.2, 0.4), draw(0.05, 0.2)

    def question(trial, size):
        world = trial.world()
        rubber = world.material(friction=0.9)
        world.body(trial.engine.sphere(size), type="static", material=rubber)
        way = size + radius
        ball = world.body(trial.engine.sphere(radius), position=(way * math.sin(start), way * math.cos(start), 0), material=rubber)
        trial.until(world, lambda w: ball.position[1] < 0, most=5)
        return ball.linear_velocity[0]

    def truth(size):
        """It rolls, from some angle on it slips, and leaves where nothing presses it on; its speed to the side stays then."""
        way, friction = size + radius, 0.9

        def squared(angle):  # of the speed, while it rolls
            return 10 / 7 * G * way * (math.cos(start) - math.cos(angle))

        low, high = start, 1.5
        while high - low > 1e-14:
            angle = (low + high) / 2
            rolls = 2 / 7 * math.sin(angle) < friction * (math.cos(angle) - squared(angle) / (G * way))
            low, high = (angle, high) if rolls else (low, angle)

        def presses(angle, rate):
            return G * math.cos(angle) - way * rate * rate

        def rates(y):
            return y[1], (G * math.sin(y[0]) - friction * presses(*y)) / way

        y, step = [low, math.sqrt(squared(low)) / way], 1e-4
        while presses(*y) > 0:
            before, y = y, follow(rates, y, step, 1)
        last = presses(*before) / (presses(*before) - presses(*y))
        angle, rate = follow(rates, before, last * step, 1)
        return rate * way * math.cos(angle)

    return question, {"size": draw(0.5, 1.5)}, truth


def wedge(draw):
    """How far a wedge is pushed aside by a block that slides down it; all without friction."""
    angle, seconds = draw(0.3, 0.7), draw(0.3, 0.5)

    def question(trial, heavy):
        world = trial.world()
        ice = world.material(friction=0)
        world.ground(material=ice)
        high = 3 * math.tan(angle)
        corners = [(x, y, z) for x, y in ((-1.5, 0), (1.5, 0), (-1.5, high)) for z in (-0.5, 0.5)]
        slope = world.body(trial.engine.hull(corners), mass=heavy, material=ice)
        along, up = (math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))
        at = [-1.5 + 0.4 * along[0] + 0.1 * up[0], high + 0.4 * along[1] + 0.1 * up[1], 0]
        world.body(trial.engine.box(0.2, 0.1, 0.2), position=at, orientation=turned(-angle), mass=1, material=ice)
        trial.run(world, seconds)
        return slope.position[0]

    def truth(heavy):
        return -0.5 * G * math.sin(angle) * math.cos(angle) / (heavy + math.sin(angle) ** 2) * seconds**2

    return question, {"heavy": draw(1, 5)}, truth


def gears(draw):
    """How far a motor has turned a wheel that drives another one."""
    seconds = draw(1, 2)

    def question(trial, torque, ratio):
        world = trial.world(gravity=(0, 0, 0))
        ball, wheels, hinges = trial.engine.sphere(0.1), [], []
        for x in (0, 1):
            wheels.append(world.body(ball, position=(x, 0, 0), mass=1, inertia=(1, 0, 0, 0, 1, 0, 0, 0, 1), center=(0, 0, 0)))
            hinges.append(world.joint("hinge", None, wheels[-1], position=(x, 0, 0), axis=(0, 0, 1)))
        teeth = world.joint("gear", wheels[0], wheels[1], position=(0, 0, 0), axis=(0, 0, 1))
        teeth.transmission(ratio=ratio)
        hinges[0].motor("twist", speed=100, max_force=torque)
        trial.run(world, seconds)
        x, y, z, w = wheels[0].orientation
        return math.sin(2 * math.atan2(z, w))

    return question, {"torque": draw(0.5, 3), "ratio": draw(0.5, 2)}, None


def arm(draw):
    """Where the hand of an arm of two driven joints is."""
    seconds, fast = draw(0.5, 1.5), draw(0.5, 2)

    def question(trial, torque):
        world = trial.world()
        bar, parts, last = trial.engine.box(0.5, 0.03, 0.03), [], None
        for k in range(2):
            parts.append(world.body(bar, position=(0.5 + k, 0, 0), mass=1))
            hinge = world.joint("hinge", last, parts[-1], position=(k, 0, 0), axis=(0, 0, 1))
            hinge.motor("twist", speed=fast, max_force=torque)
            last = parts[-1]
        trial.run(world, seconds)
        return parts[1].position[1]

    return question, {"torque": draw(5, 40)}, None


def egg(draw):
    """Where an egg that rocks on the floor has rolled."""
    seconds, lean = draw(0.5, 1.5), draw(0.3, 1.0)

    def question(trial, friction):
        world = trial.world()
        wood = world.material(friction=friction)
        world.ground(material=wood)
        high = math.hypot(0.2 * math.cos(lean), 0.3 * math.sin(lean))
        shell = world.body(trial.engine.ellipsoid(0.3, 0.2, 0.2), position=(0, high, 0), orientation=turned(lean), material=wood)
        trial.run(world, seconds)
        return shell.position[0]

    return question, {"friction": draw(0.6, 0.9)}, None


KINDS = (throw, slide, incline, pendulum, double_pendulum, skid, bounce, spring, damped, top, collision, rolls_down, off_a_ball, motor, pulley, board,
         tips, belt, stone, skittle, leaning, rolls_off, wedge,
         gears, arm, egg)


def scene(kind, seed):
    """The same for the same two, on any machine."""
    dice = random.Random(f"{kind.__name__} {seed}")
    question, parameters, truth = kind(dice.uniform)
    return Scene(kind.__name__, question, parameters, truth)

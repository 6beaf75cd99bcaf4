"""Carom by its Python package: one step a frame, at its default dials, but for those that $STRANGERS_DIALS names."""
import os

import carom

from scene import FRAME, Clock, Refused

ENGINE = carom.Engine()
DIALS = dict(dial.split("=") for dial in os.environ.get("STRANGERS_DIALS", "").split())


def version():
    return carom.__version__


def shape_of(shape):
    """The shape, and where its origin is in the frame of scene.py."""
    word, *numbers = shape
    if word == "plane":
        return ENGINE.half_space(), (0, 0, 0)
    if word == "field":
        rows, spacing = numbers
        return (ENGINE.height_field(rows, spacing=(spacing, spacing)),
                (-spacing * (len(rows[0]) - 1) / 2, 0, -spacing * (len(rows) - 1) / 2))
    return getattr(ENGINE, word)(*numbers), (0, 0, 0)


class World:
    def __init__(self, scene):
        self.world, self.clock, self.scene, self.time = ENGINE.world(gravity=(0, -scene.gravity, 0), **DIALS), Clock(), scene, 0.0
        material = self.world.material(friction=scene.friction, restitution=scene.restitution)
        made, self.bodies = {}, []
        for body in scene.bodies:
            b = self.world.body(position=body.position, orientation=body.orientation, type=body.kind)
            for shape, position, orientation in body.pieces():
                if id(shape) not in made:
                    made[id(shape)] = shape_of(shape)
                form, origin = made[id(shape)]
                b.collider(form, position=tuple(p + o for p, o in zip(position, origin)), orientation=orientation, material=material,
                           density=body.density)
            b.linear_velocity, b.angular_velocity = body.velocity, body.spin
            self.bodies.append(b)
        self.joints = []
        for hinge in scene.hinges:
            a = None if hinge.a is None else self.bodies[hinge.a]
            joint = self.world.joint("hinge", a, self.bodies[hinge.b], position=hinge.at, axis=hinge.axis)
            if hinge.lower is not None:
                try:
                    joint.limit("twist", lower=hinge.lower, upper=hinge.upper)
                except carom.errors.CaromError:
                    raise Refused("refuses such a stop")
        self.driven = [(b, body.drive) for b, body in zip(self.bodies, scene.bodies) if body.drive]

    def step(self):
        for body, drive in self.driven:
            body.linear_velocity = drive(self.time)
        for hinge in self.scene.hinges:
            if hinge.torque:
                push = [hinge.torque * x for x in hinge.axis]
                self.bodies[hinge.b].add_force((0, 0, 0), push)
                if hinge.a is not None:
                    self.bodies[hinge.a].add_force((0, 0, 0), [-x for x in push])
        with self.clock:
            self.world.step(FRAME)
        self.time += FRAME

    def pose(self, i):
        return self.bodies[i].position, self.bodies[i].orientation

    def velocity(self, i):
        return self.bodies[i].linear_velocity, self.bodies[i].angular_velocity

    def rays(self, origins, directions, far):
        try:
            import numpy
        except ImportError:  # one by one: a call costs ten times the ray
            with self.clock:
                hits = [self.world.ray(origin, direction, far) for origin, direction in zip(origins, directions)]
            return [hit.time if hit else None for hit in hits]
        origins, directions = numpy.array(origins), numpy.array(directions)
        with self.clock:
            hits = self.world.rays(origins, directions, far)
        return [time if outcome else None for outcome, time in zip(hits.outcomes, hits.times)]

    def close(self):
        self.world.close()

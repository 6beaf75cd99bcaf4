"""Carom, a rigid-body physics engine: bodies, joints and shapes with their contacts, the same bits on every machine.

    import carom
    with carom.Engine() as engine, engine.world() as world:
        world.ground()
        ball = world.body(engine.sphere(0.5), position=(0, 3, 0))
        carom.run(world, seconds=3)
        print(ball.position)

SI units, radians, right-handed frames, quaternions x, y, z, w. `carom.raw` is the C interface under its own names.
"""
from . import errors, jobs, raw, records
from ._c import VERSION as __version__
from .attributes import Attributes, attribute_infos
from .batch import Batch, Column
from .body import Body, Collider, Material
from .device import Device
from .dials import dial_infos
from .engine import Engine
from .errors import CaromError, Closed
from .force import ForceField, Spring, Water
from .host import share
from .joint import Joint
from .kit import Character, Vehicle, Wheel
from .measure import Chaotic, Measured, Slope, Trial, measure
from .notebook import Film, Picture, film
from .particles import Particles
from .report import effects
from .run import run
from .shape import Shape
from .support import SupportPlugin
from .tree import JointTree
from .tune import Tuned, tune
from .world import World

__all__ = ["Attributes", "Batch", "Body", "CaromError", "Chaotic", "Character", "Closed", "Collider", "Column", "Device", "Engine", "Film", "ForceField", "Joint",
           "JointTree", "Material", "Measured", "Particles", "Picture", "Shape", "Slope", "Spring", "SupportPlugin", "Trial", "Tuned", "Vehicle", "Water", "Wheel", "World",
           "attribute_infos", "dial_infos", "effects", "errors", "film", "jobs", "measure", "raw", "records", "run", "share", "tune", "__version__"]

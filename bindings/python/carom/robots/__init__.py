"""Robots from MJCF and URDF, by MuJoCo's own reader (pip install 'carom[robots]').

    import carom.robots

    with carom.robots.load("go2.xml") as robot:
        robot.reset("home")
        robot.step(500)
        print(robot.qpos["FL_calf_joint"], robot.left_out)

SI units, z up as the model has it. What the world does not get of a model stands in `left_out`, with the reason; strict=True
refuses such a model. Contacts, limits and friction are hard here: solref, solimp and what else tells MuJoCo's solver how soft they
are has no counterpart.
"""
from __future__ import annotations

import math
import os
from typing import TYPE_CHECKING, Any, Sequence

from .._values import need_numpy, number
from ..engine import Engine

numpy: Any = need_numpy("carom.robots")

from .bodies import Disabled  # noqa: E402
from .problems import LeftOut, ModelError, Problems  # noqa: E402
from .read import compiled, spec  # noqa: E402
from .robot import Keyframe, Robot, Vector  # noqa: E402
from .sensors import Sensor  # noqa: E402
from .tendons import Tendon, have_chains  # noqa: E402

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ..records import DialKeywords
    from ..world import World

__all__ = ["Keyframe", "LeftOut", "ModelError", "Robot", "Sensor", "Tendon", "Vector", "load", "spec"]

LONGEST_SUBSTEP = 2.5e-3  # s: robots at MuJoCo's usual step of 2 ms take one


def load(source: str | os.PathLike[str] | Any, world: World | None = None, *, strict: bool = False, floating: bool = False, dt: float | None = None,
         root: str | os.PathLike[str] | None = None, packages: Sequence[str | os.PathLike[str]] = (), **dials: Unpack[DialKeywords]) -> Robot:
    """A robot of a file of MJCF or URDF, or of a mujoco.MjSpec.
    @param world     one that you have: its gravity and dials stay; None: one of its own, with the model's gravity
    @param strict    raise ModelError where anything is left out
    @param floating  what stands on the world without a joint flies: of URDF the base
    @param dt        s, of Robot.step(); None: the model's timestep
    @param root      the folder that files named by the model may lie in; None: the model's own
    @param packages  folders that have those of package://NAME/ in them; folders above the file are looked in, too
    @param dials     of the world that is made: substeps=2, solver="direct"
    @raise ModelError  the model can't be read; it says where and what to do, and nothing was made"""
    problems = Problems()
    model = compiled(source, root, packages, bool(floating), problems)
    step = float(model.opt.timestep) if dt is None else number(dt, "dt")
    if not 1e-9 <= step <= 1:
        raise ValueError(f"dt takes seconds from 1e-9 to 1, got {step!r}")
    place = str(source) if isinstance(source, (str, os.PathLike)) else "the MjSpec"
    if not _finite(model):
        raise ModelError(place, "it has numbers that are not finite", "mend the model there")
    if world is not None and dials:
        raise ValueError(f"a world that is given keeps its dials: set {', '.join(dials)} there")
    owned = Engine() if world is None else None
    bodies = set() if world is None else set(map(int, world.body_handles()))
    made: list[Any] = []  # shapes and materials
    try:
        if owned is not None:
            gravity = (0.0, 0.0, 0.0) if _gravity_is_off(model) else tuple(float(x) for x in model.opt.gravity)
            chosen: Any = {"substeps": max(1, math.ceil(step / LONGEST_SUBSTEP - 1e-9)), **dials}
            if any(model.body_jntnum > 1) or any((model.body_mass == 0) & (model.body_dofnum > 0)) or have_chains(model):  # nodes that weigh nothing are for the direct solver alone
                chosen.setdefault("solver", "direct")
            world = owned.world(gravity=gravity, **chosen)
        assert world is not None
        robot = Robot(model, world, owned, step, int(world.dials["substeps"]), problems, made)
        if strict and robot.left_out:
            raise ModelError(place, "; ".join(map(str, robot.left_out)), "load it without strict=True if you can do without")
        return robot
    except BaseException:
        if owned is not None:
            owned.close()
        elif world is not None:
            for body in world.bodies:
                if body.handle not in bodies:
                    body.destroy()
            for thing in reversed(made):  # hulls before what they are made of
                thing.destroy()
        raise


def _gravity_is_off(model: Any) -> bool:
    return Disabled(model).gravity


def _finite(model: Any) -> bool:
    return all(numpy.isfinite(getattr(model, name)).all() for name in (
        "body_mass", "body_inertia", "body_pos", "body_quat", "body_ipos", "body_iquat", "jnt_pos", "jnt_axis", "jnt_range", "geom_size",
        "geom_pos", "geom_quat", "geom_friction", "mesh_vert", "hfield_data", "qpos0", "dof_armature", "dof_damping", "dof_frictionloss",
        "key_qpos", "key_qvel", "key_ctrl", "actuator_gear", "actuator_gainprm"))

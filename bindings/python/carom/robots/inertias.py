"""Moments of inertia that MuJoCo does not take. What a link weighs counts in the end, with all that is fixed to it: where that can be
a body's, the link has the file's own numbers, whatever those of its parts are."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import turns
from .problems import ModelError, Problems

if TYPE_CHECKING:
    from .turns import Array

LEAST_INERTIA = 1e-15  # kg m^2: MuJoCo takes no less
LEAST_SHARE = 1e-9     # of the largest moment of inertia: less than that is 0
BALL = 4e-5            # m^2: the moments of inertia of a ball of 1 cm over its mass
LEAST_MASS, LEAST_TURN = 1e-6, 1e-9  # kg, kg m^2: of a link that has none
THOUSANDTH = "a moment of inertia is not above 0: a thousandth of its largest stands in"
BALL_STANDS_IN = "its moments of inertia are 0: those of a ball of its mass and 1 cm stand in"
NOTHING = f"it moves and nothing that it carries weighs anything: {LEAST_MASS:g} kg and {LEAST_TURN:g} kg m^2 stand in"


def tensor(body: Any) -> Array:
    """kg m^2, about its centre, axes of a mujoco.MjsBody"""
    full = np.array(body.fullinertia, float)
    if np.isnan(full[0]) and not full[1:].any():  # not said
        own = np.diag(body.inertia)
    else:
        xx, yy, zz, xy, xz, yz = full
        own = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    axes = turns.matrix(turns.from_mujoco(body.iquat))
    return axes @ own @ axes.T


def is_a_body(moments: Any) -> bool:
    """@param moments  ascending"""
    return bool(moments[0] > LEAST_SHARE * moments[2] and moments[0] > LEAST_INERTIA)


class Said:
    """What a file says of bodies for which something stands in while MuJoCo compiles."""

    def __init__(self, spec: Any, place: str) -> None:
        self.of: list[tuple[Any, float, Array, Array]] = []  # body, mass, centre, tensor
        for body in spec.bodies:
            if body.explicitinertial:
                self._look(body, place)

    def _look(self, body: Any, place: str) -> None:
        said = tensor(body)
        if not np.isfinite([body.mass, *said.ravel(), *(body.ipos if body.mass else ())]).all():
            raise ModelError(place, f"body {body.name!r} has an inertia that is no number", "mend the model there")
        if body.mass < 0 or min(np.diag(said)) < 0 and np.isnan(body.fullinertia[0]):
            raise ModelError(place, f"body {body.name!r} has a mass or a moment of inertia below 0", "mend the model there")
        moments = np.linalg.eigvalsh(said)
        if is_a_body(moments) and moments[0] + moments[1] >= moments[2] or not (body.mass or moments.any()):
            return
        self.stand_in(body, body.mass, max(float(moments[2]), BALL * body.mass, LEAST_TURN))

    def stand_in(self, body: Any, mass: float, moment: float) -> None:
        """Let a body have three equal moments of inertia, kg m^2, until settle()."""
        center = np.array(body.ipos, float) if body.explicitinertial and body.mass else np.zeros(3)
        own = (float(body.mass), center, tensor(body)) if body.explicitinertial else (0.0, center, np.zeros((3, 3)))
        self.of.append((body, *own))
        body.mass, body.ipos, body.iquat, body.explicitinertial = mass, center, [1, 0, 0, 0], True
        body.inertia, body.fullinertia = [moment] * 3, [float("nan")] + [0.0] * 5

    def settle(self, model: Any, problems: Problems) -> None:
        """Give a compiled model what the file says, or, where no body can have it, what is nearest, and tell of that."""
        if not self.of:
            return
        from .read import need_mujoco
        mujoco = need_mujoco()
        for body, mass, center, said in self.of:
            write(model, body.id, mass, center, said)
        from .links import Links
        bodies = {body.id: body.name for body, *_ in self.of}
        links = Links(model)
        for k, link in enumerate(links.links):
            members = [body for body in range(model.nbody) if links.of_body[body] == k]
            among = [body for body in members if body in bodies]
            if among and not link.is_static and link.mocap < 0 and not link.is_a_body:
                heaviest = max(among, key=lambda body: float(model.body_mass[body]))
                self._mend(model, heaviest, members, *weigh(model, members), bodies[heaviest], problems)
        mujoco.mj_setConst(model, mujoco.MjData(model))

    def _mend(self, model: Any, body: int, members: list[int], mass: float, moments: Any, name: str, problems: Problems) -> None:
        if mass <= LEAST_INERTIA:
            write(model, body, LEAST_MASS, np.zeros(3), LEAST_TURN * np.eye(3))
            problems.add("body", name, NOTHING)
        elif moments[2] < 1e-12 * mass:
            axes = turns.matrix(turns.from_mujoco(model.body_iquat[body]))
            own = axes @ np.diag(model.body_inertia[body]) @ axes.T
            write(model, body, float(model.body_mass[body]), np.array(model.body_ipos[body]), own + BALL * mass * np.eye(3))
            problems.add("body", name, BALL_STANDS_IN)
        else:
            for k in members:
                least = 1e-3 * float(np.abs(model.body_inertia[k]).max())
                model.body_inertia[k] = np.maximum(model.body_inertia[k], least)
            if not is_a_body(weigh(model, members)[1]):
                model.body_inertia[body] += 1e-3 * float(moments[2])
            problems.add("body", name, THOUSANDTH)


def write(model: Any, body: int, mass: float, center: Array, said: Array) -> None:
    moments, axes = np.linalg.eigh(said)
    if np.linalg.det(axes) < 0:
        axes[:, 0] *= -1
    model.body_mass[body], model.body_ipos[body], model.body_inertia[body] = mass, center, moments
    model.body_iquat[body] = turns.to_mujoco(turns.of_matrix(axes))


def weigh(model: Any, members: list[int]) -> tuple[float, Any]:
    """@return kg and moments of inertia, kg m^2, ascending, of bodies that are one"""
    poses: dict[int, turns.Pose] = {}
    for body in members:
        own = np.array(model.body_pos[body], float), turns.from_mujoco(model.body_quat[body])
        parent = int(model.body_parentid[body])
        poses[body] = turns.on(poses[parent], own) if parent in poses else (np.zeros(3), turns.NONE)
    parts = []
    for body in members:
        center, turn = turns.on(poses[body], (np.array(model.body_ipos[body]), turns.from_mujoco(model.body_iquat[body])))
        axes = turns.matrix(turn)
        parts.append((float(model.body_mass[body]), center, axes @ np.diag(model.body_inertia[body]) @ axes.T))
    mass = sum(part[0] for part in parts)
    middle = sum((part[0] * part[1] for part in parts), np.zeros(3)) / mass if mass else np.zeros(3)
    whole = sum((inertia + m * ((at - middle) @ (at - middle) * np.eye(3) - np.outer(at - middle, at - middle))
                 for m, at, inertia in parts), np.zeros((3, 3)))
    return mass, np.linalg.eigvalsh(whole)

"""A robot as files that need no MuJoCo: a whole snapshot, which C, Rust and the page restore, and its names beside it."""
from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .links import name_of

if TYPE_CHECKING:
    from .robot import Robot


def names(robot: Robot) -> dict[str, Any]:
    """Where things are: bodies and joints by their place in carom_world_get_bodies() and carom_world_get_joints()."""
    bodies = {handle: k for k, handle in enumerate(map(int, robot.world.body_handles()))}
    joints = {handle: k for k, handle in enumerate(map(int, robot.world.joint_handles()))}
    links = robot._links
    moves = {move.name: {"kind": move.kind, "qpos": move.q, "qvel": move.v, "zero": move.zero,
                         "joint": None if move.kind == "free" else joints[robot.joints[move.name].handle]}
             for move in links.moves if move.kind != "weld"}
    by_index = {move.index: move.name for move in links.moves}
    tendons = {name: {"shares": {move.name: float(share) for move, share in zip(chain.moves, chain.shares)}, "end": joints[chain.end.handle],
                      "sliders": [joints[slider.handle] for slider in chain.sliders]} for name, chain in robot._tendons.chains.items()}
    actuators = {a.name: {"ctrl": a.control, "act": a.state, "pulls": {by_index[joint]: share for joint, share in a.pulls.items()}, "gain": a.gain,
                          "bias": a.bias, "ctrlrange": a.bounds, "forcerange": a.force, "dynamics": a.dynamics, "lag": a.lag,
                          "in_world": a.servo is not None} for a in robot._actuators.all}
    return {
        "dt": robot.dt,
        "bodies": {name: bodies[body.handle] for name, body in robot.bodies.items()},
        "joints": moves,
        "loops": {name: joints[joint.handle] for name, joint in robot._loops.items()},
        "actuators": actuators,
        "springs_of_the_host": {by_index[joint]: stiffness for joint, stiffness in robot._bodies.by_host.items()},
        "tendons": tendons,
        "ropes": {name: joints[joint.handle] for name, joint in robot._tendons.ropes.items()},
        "springs_of_tendons": [{"shares": {by_index[joint]: share for joint, share in robot._tendons.shares.get(spring.tendon, {}).items()},
                                "tendon": name_of(robot._model, "tendon", spring.tendon), "stiffness": spring.stiffness, "damping": spring.damping,
                                "springlength": (spring.low, spring.high)} for spring in robot._tendons.springs],
        "friction_of_turns": {by_index[joint]: friction for joint, friction in robot._bodies.turning.items()},
        "fluid": {"density": robot._fluid.density, "viscosity": robot._fluid.viscosity, "wind": robot._fluid.wind.tolist()} if robot._fluid.acts else None,
        "keyframes": {key.name: {"qpos": key.qpos.tolist(), "qvel": key.qvel.tolist(), "ctrl": key.ctrl.tolist()}
                      for key in robot.keyframes.values()},
        "left_out": [{"kind": left.kind, "names": left.names, "reason": left.reason} for left in robot.left_out],
    }


def save(robot: Robot, path: str | os.PathLike[str]) -> tuple[Path, Path]:
    """Write PATH, a whole snapshot of the world as it is now, and PATH.json, names.   @return both"""
    snapshot = Path(path)
    beside = snapshot.with_name(snapshot.name + ".json")
    text = json.dumps(unbounded(names(robot)), indent=1)
    snapshot.write_bytes(robot.world.save(whole=True))
    beside.write_text(text + "\n", encoding="utf-8")
    return snapshot, beside


def unbounded(value: Any) -> Any:
    """JSON has no infinity: null stands for it."""
    if isinstance(value, dict):
        return {key: unbounded(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [unbounded(one) for one in value]
    return None if isinstance(value, float) and value in (float("inf"), float("-inf")) else value

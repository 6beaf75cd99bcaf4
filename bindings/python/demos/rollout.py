#!/usr/bin/env python3
"""A policy's rollout that ends alike on two platforms: here, and in WebAssembly by node.   usage: rollout.py [--steps N] [--picture FILE.svg]

A walker of eight hinges on the ground, pushed by a policy whose sums are the same sums on both. Needs bindings/js/dist/carom.wasm (preset
wasm) and node; exits with 77 where one is missing.
"""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import carom

HERE = Path(__file__).resolve().parent


def walker(engine, world):
    """A trunk on four legs of two hinges each."""
    world.ground(material=world.material(friction=1.0))
    trunk = world.body(engine.box(0.3, 0.06, 0.15), position=(0, 0.6, 0), density=600)
    thigh, shin = engine.box(0.03, 0.13, 0.03), engine.box(0.025, 0.13, 0.025)
    for x in (-0.25, 0.25):
        for z in (-0.2, 0.2):
            upper = world.body(thigh, position=(x, 0.45, z), density=600)
            lower = world.body(shin, position=(x, 0.19, z), density=600)
            for parent, child, y in ((trunk, upper, 0.58), (upper, lower, 0.32)):
                joint = world.joint("hinge", parent, child, position=(x, y, z), axis=(0, 0, 1))
                joint.axis("turn_x", mode="limited", lower=-1, upper=1, spring_gains="force", spring_stiffness=40, spring_damping=1, armature=0.01)


def policy(rows, columns):
    """Numbers of a row of remainders: any policy would do."""
    state, found = 12345, []
    for _ in range(rows * columns):
        state = (1103515245 * state + 12345) % 2**31
        found.append((state / 2**31 - 0.5) / 4)
    return [found[columns * row:columns * (row + 1)] for row in range(rows)]


def main():
    parser = argparse.ArgumentParser(description="A rollout on two platforms.")
    parser.add_argument("--steps", type=int, default=2400)
    parser.add_argument("--picture", metavar="FILE.svg")
    given = parser.parse_args()
    missing = [what for what, there in (("node", shutil.which("node")), ("bindings/js/dist/carom.wasm", (HERE / "../../js/dist/carom.wasm").exists())) if not there]
    if missing:
        print(f"skipped: {' and '.join(missing)} missing")
        sys.exit(77)
    told = {"steps": given.steps, "dt": 1 / 240, "strength": 30.0, "weights": policy(8, 16)}
    with carom.Engine() as engine, engine.world(substeps=2) as world, tempfile.TemporaryDirectory() as folder:
        walker(engine, world)
        start, rules = Path(folder) / "start.carom", Path(folder) / "policy.json"
        start.write_bytes(world.save(whole=True))
        rules.write_text(json.dumps(told), encoding="utf-8")
        for _ in range(told["steps"]):
            seen = [*world.read_joints("position")[:, 0].tolist(), *world.read_joints("velocity")[:, 0].tolist()]
            efforts = []
            for row in told["weights"]:
                total = 0.0
                for weight, value in zip(row, seen):
                    total += weight * value
                efforts.append(told["strength"] * min(1.0, max(-1.0, total)))
            world.write_joints("target_effort", efforts)
            world.step(told["dt"])
        mine = f"{world.hash:016x}"
        if given.picture:
            world.picture().save(given.picture)
        done = subprocess.run(["node", str(HERE / "rollout.mjs"), str(start), str(rules)], capture_output=True, text=True)
    theirs = done.stdout.strip() or done.stderr.strip()
    print(f"after {given.steps} steps: {mine} here, {theirs} in WebAssembly")
    if mine != theirs:
        raise SystemExit("they differ")


if __name__ == "__main__":
    main()

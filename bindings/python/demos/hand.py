#!/usr/bin/env python3
"""A hand of four fingers holds a ball by friction alone.   usage: hand.py [--seconds S] [--solver WORD] [--picture FILE.svg]"""
import argparse
import math

import carom


def hand(engine, world):
    """@return ball, joints. Fingers hang from a palm, and servos press their tips against the ball above its middle: they push it down, and
    friction alone bears it."""
    grip = world.material(friction=0.8)
    palm = world.body(engine.box(0.05, 0.01, 0.05), position=(0, 0.2, 0), type="static")
    ball = world.body(engine.sphere(0.04), position=(0, 0.09, 0), mass=0.1, material=grip, stays_awake=True)
    joints = []
    for k in range(4):
        angle = k * math.pi / 2
        out, side = (math.cos(angle), 0, math.sin(angle)), (-math.sin(angle), 0, math.cos(angle))
        turn = (0, math.sin(-angle / 2), 0, math.cos(angle / 2))

        def at(r, y):
            return (r * out[0], y, r * out[2])

        upper = world.body(engine.box(0.008, 0.025, 0.012), position=at(0.06, 0.165), orientation=turn, mass=0.03, material=grip)
        lower = world.body(engine.box(0.008, 0.025, 0.012), position=at(0.06, 0.115), orientation=turn, mass=0.03, material=grip)
        for parent, child, y, target in ((palm, upper, 0.19, 0.3), (upper, lower, 0.14, 0.2)):
            joint = world.joint("hinge", parent, child, position=at(0.06, y), axis=side)
            joint.axis("turn_x", drive="position", drive_gains="force", drive_stiffness=2, drive_damping=0.02, max_force=0.3, target=-target)
            joints.append(joint)
    return ball, joints


def main():
    parser = argparse.ArgumentParser(description="A hand holds a ball.")
    parser.add_argument("--seconds", type=float, default=3600)
    parser.add_argument("--solver", default="direct")
    parser.add_argument("--picture", metavar="FILE.svg")
    given = parser.parse_args()
    with carom.Engine() as engine, engine.world(substeps=1, solver=given.solver) as world:
        ball, _ = hand(engine, world)
        for _ in range(480):
            world.step(1 / 240)
        place, turn = ball.pose
        for _ in range(round(240 * given.seconds)):
            world.step(1 / 240)
        slip = math.dist(place, ball.position)
        turned = 2 * math.acos(min(1.0, abs(sum(a * b for a, b in zip(turn, ball.orientation)))))
        print(f"after {given.seconds:g} s the ball is {slip:.1e} m and {turned:.1e} rad from where it was grasped, at y = {ball.position[1]:.3f} m")
        if given.picture:
            world.picture().save(given.picture)
        if not (slip < 1e-6 and turned < 1e-6):
            raise SystemExit("it slips")


if __name__ == "__main__":
    main()

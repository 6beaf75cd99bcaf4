#!/usr/bin/env python3
"""Peaucellier's linkage: seven bars and ten pins, three loops of them, draw a straight line.   usage: linkage.py [--seconds S] [--picture FILE.svg]"""
import argparse
import math

import carom

LONG, SIDE, CRANK = 0.7, 0.35, 0.25  # m
LINE = (LONG**2 - SIDE**2) / (2 * CRANK)  # m: where the line is, by the inversion OP OQ = LONG^2 - SIDE^2


def corners(angle):
    """O, C, P, Q, A, B in the plane, for an angle of the crank CP."""
    p = (CRANK + CRANK * math.cos(angle), CRANK * math.sin(angle))
    far = math.hypot(*p)
    along = (p[0] / far, p[1] / far)
    way = (LONG**2 - SIDE**2) / far
    middle = (far + way) / 2
    half = math.sqrt(LONG**2 - middle**2)
    q = (way * along[0], way * along[1])
    a = (middle * along[0] - half * along[1], middle * along[1] + half * along[0])
    b = (middle * along[0] + half * along[1], middle * along[1] - half * along[0])
    return (0, 0), (CRANK, 0), p, q, a, b


def linkage(engine, world, angle=0.0):
    o, c, p, q, a, b = corners(angle)

    def bar(start, end, layer):
        turn = math.atan2(end[1] - start[1], end[0] - start[0])
        return world.body(engine.box(math.dist(start, end) / 2, 0.012, 0.006), position=((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, 0.02 * layer),
                          orientation=(0, 0, math.sin(turn / 2), math.cos(turn / 2)), density=2700)

    bars = {"oa": bar(o, a, 0), "ob": bar(o, b, 1), "ap": bar(a, p, 2), "bp": bar(b, p, 3), "aq": bar(a, q, 4), "bq": bar(b, q, 5), "cp": bar(c, p, 6)}
    pins = [(None, "cp", c), (None, "oa", o), (None, "ob", o), ("oa", "ap", a), ("oa", "aq", a), ("ob", "bp", b), ("ob", "bq", b),
            ("ap", "bp", p), ("ap", "cp", p), ("aq", "bq", q)]
    joints = [world.joint("hinge", bars.get(one), bars[other], position=(*at, 0), axis=(0, 0, 1)) for one, other, at in pins]
    names = list(bars)
    for k, one in enumerate(names):  # bars pass each other in layers
        for other in names[k + 1:]:
            bars[one].ignore_collision(bars[other])
    return bars, joints


def end(bars):
    """m: Q in the plane."""
    x, y, z, w = bars["aq"].orientation
    turn = 2 * math.atan2(z, w)
    at = bars["aq"].position
    return at[0] + SIDE / 2 * math.cos(turn), at[1] + SIDE / 2 * math.sin(turn)


def main():
    parser = argparse.ArgumentParser(description="A linkage draws a straight line.")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--picture", metavar="FILE.svg")
    given = parser.parse_args()
    with carom.Engine() as engine, engine.world(substeps=2) as world:
        bars, joints = linkage(engine, world)
        off, gap, low, high = 0.0, 0.0, 0.0, 0.0
        for step in range(round(240 * given.seconds)):
            target = math.sin(2 * math.pi * step / 480)  # rad: to and fro in 2 s
            joints[0].axis("turn_x", drive="position", drive_gains="force", drive_stiffness=400, drive_damping=40, target=target)
            world.step(1 / 240)
            x, y = end(bars)
            off, low, high = max(off, abs(x - LINE)), min(low, y), max(high, y)
            gap = max(gap, max(joint.state.gap for joint in joints[7:]))
        print(f"in {given.seconds:g} s its end went to and fro by {high - low:.3f} m, {off:.0e} m off the line at most; loops gaped by {gap:.0e} m at most")
        if given.picture:
            world.picture().save(given.picture)
        if not (off < 1e-6 and gap < 1e-6 and high - low > 0.5):
            raise SystemExit("it is no line")


if __name__ == "__main__":
    main()

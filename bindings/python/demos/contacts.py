#!/usr/bin/env python3
"""Balls fall into a pit: no number of contacts was asked for, and none is lost.   usage: contacts.py [--balls N] [--picture FILE.svg]"""
import argparse

import carom
import numpy as np

RADIUS, WIDE = 0.05, 0.6  # m


def section(balls):
    """An SVG: what a plane through the pit's middle cuts, seen along z."""
    scale, high = 400 / (2 * WIDE), float(balls[:, 1].max()) + 2 * RADIUS
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 440 {high * scale + 20:.0f}" role="img" aria-label="balls in a pit">',
           f'<path d="M20 0V{high * scale:.0f}H420V0" fill="#e3e8ee" stroke="#555" stroke-width="2"/>']
    for x, y, z in balls[np.abs(balls[:, 2]) < RADIUS]:
        seen = (RADIUS**2 - z * z) ** 0.5
        out.append(f'<circle cx="{20 + (x + WIDE) * scale:.1f}" cy="{(high - y) * scale:.1f}" r="{seen * scale:.1f}" fill="#4677a4" fill-opacity="0.8"/>')
    return "\n".join(out) + "\n</svg>\n"


def main():
    parser = argparse.ArgumentParser(description="Contacts without a limit.")
    parser.add_argument("--balls", type=int, default=2000)
    parser.add_argument("--picture", metavar="FILE.svg")
    given = parser.parse_args()
    with carom.Engine() as engine, engine.world() as world:
        world.ground()
        for axis in (0, 2):
            for sign in (-1, 1):
                place = [0.0, 10.0, 0.0]
                place[axis] = sign * (WIDE + 0.5)
                half = [WIDE + 1, 10, WIDE + 1]
                half[axis] = 0.5
                world.body(engine.box(*half), position=place, type="static")
        ball, side = engine.sphere(RADIUS), int(WIDE / (1.1 * RADIUS))
        for k in range(given.balls):
            x, z, y = k % side, k // side % side, k // side**2
            world.body(ball, position=(2.2 * RADIUS * (x - (side - 1) / 2) + 1e-3 * (y % 3), RADIUS + 2.2 * RADIUS * y, 2.2 * RADIUS * (z - (side - 1) / 2) + 1e-3 * (y % 2)))
        for _ in range(300):
            world.step(1 / 60)
        places = world.read("position")
        balls = places[5:]
        assert len(balls) == given.balls
        # every pair that overlaps, by a grid of cells as wide as a ball, beside the contacts that the world has
        cells = {}
        for k, cell in enumerate(map(tuple, np.floor(balls / (2 * RADIUS)).astype(int))):
            cells.setdefault(cell, []).append(k)
        pairs, deepest = 0, 0.0
        for (x, y, z), among in cells.items():
            near = [k for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1) for k in cells.get((x + dx, y + dy, z + dz), ())]
            for k in among:
                way = 2 * RADIUS - np.linalg.norm(balls[near] - balls[k], axis=1)
                touching = way[(np.array(near) > k) & (way > 0)]
                pairs, deepest = pairs + len(touching), max(deepest, touching.max(initial=0.0))
        contacts = len(world.contacts())
        print(f"{given.balls} balls lie on {contacts} contacts; {pairs} pairs of them overlap, by {1000 * deepest:.1f} mm at most; "
              f"the lowest is {1000 * (balls[:, 1].min() - RADIUS):.1f} mm above the ground")
        if given.picture:
            with open(given.picture, "w", encoding="utf-8") as file:
                file.write(section(balls))
        if contacts < pairs or deepest > 0.2 * RADIUS or np.abs(balls[:, 0::2]).max() > WIDE:
            raise SystemExit("contacts are missing")


if __name__ == "__main__":
    main()

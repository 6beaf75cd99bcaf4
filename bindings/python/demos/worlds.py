#!/usr/bin/env python3
"""A result that does not depend on a world's number, on its neighbours, or on threads.   usage: worlds.py [--worlds N] [--picture FILE.svg]"""
import argparse

import carom
import numpy as np


def main():
    parser = argparse.ArgumentParser(description="The same world at every number of a batch.")
    parser.add_argument("--worlds", type=int, default=256)
    parser.add_argument("--picture", metavar="FILE.svg")
    given = parser.parse_args()
    found = set()
    for threads, count in ((1, 1), (1, 7), (2, given.worlds), (4, given.worlds)):
        with carom.Engine(threads=threads) as engine, engine.world() as world:
            world.ground()
            boxes = [world.body(engine.box(0.1, 0.1, 0.1), position=(0.01 * (k % 3), 0.1 + 0.2 * k, 0)) for k in range(10)]
            ball = world.body(engine.sphere(0.15), position=(-2, 0.9, 0), density=3000)
            batch = carom.Batch(world, count)
            speed = batch.column("bodies", "linear_velocity", [ball])
            speed.array[:] = (8, 1, 0)
            others = np.arange(count) % 3 == 1  # a third of the worlds does something else, or stops by a fault
            speed.array[others] = (np.linspace(1, 1e12, int(others.sum()))[:, None, None] * (1, 0, 0))
            batch.write(speed)
            batch.step(1 / 120, 240)
            hashes = batch.hashes()[~others]
            found |= set(map(int, hashes))
            print(f"{threads} threads, {count} worlds: {len(hashes)} are alike, hash {int(hashes[0]):016x}; {int((batch.stopped() != 0).sum())} others stopped by a fault")
            if given.picture and count > 1:
                world.restore(batch.save(count - 1 if not others[count - 1] else count - 2))
                world.picture().save(given.picture)
            assert len(boxes) == 10
    if len(found) != 1:
        raise SystemExit(f"{len(found)} outcomes")


if __name__ == "__main__":
    main()

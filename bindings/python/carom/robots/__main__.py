"""python3 -m carom.robots MODEL [-o FILE]: say what of a model loads and what is left out; write it as a snapshot, and FILE.json, its names."""
from __future__ import annotations

import argparse
import sys

from . import ModelError, load


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m carom.robots", description="MJCF or URDF as a snapshot that needs no MuJoCo")
    parser.add_argument("model", help="a file of MJCF or URDF")
    parser.add_argument("-o", metavar="FILE", help="write a whole snapshot of the world, and FILE.json, its names")
    parser.add_argument("--keyframe", help="put it there first")
    parser.add_argument("--strict", action="store_true", help="refuse a model of which anything is left out")
    parser.add_argument("--floating", action="store_true", help="what stands on the world without a joint flies: of URDF the base")
    parser.add_argument("--root", help="the folder that files named by the model may lie in; default: its own")
    parser.add_argument("--package", action="append", default=[], help="a folder that has those of package://NAME/ in it")
    given = parser.parse_args()
    try:
        with load(given.model, strict=given.strict, floating=given.floating, root=given.root, packages=given.package) as robot:
            robot.reset(given.keyframe)
            print(repr(robot))
            for left in robot.left_out:
                print(f"left out: {left}")
            if given.o:
                print("wrote " + " and ".join(map(str, robot.save(given.o))))
    except (ModelError, KeyError, OSError) as why:
        print(why.args[0] if isinstance(why, KeyError) else why, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

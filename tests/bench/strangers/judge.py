"""How deep bodies are in each other, by Carom's distances of shapes: states alone count, for every engine by the same code."""
import math

import engine_carom


def reach(shape):
    word, *n = shape
    return math.inf if word in ("plane",) else max(math.hypot(*p) for p in n[0]) if word == "hull" else math.hypot(*n)


def deepest(world, bodies):
    """m, over all pairs with a dynamic body; bodies of one piece each."""
    shapes, poses = {}, []
    for i, body in enumerate(bodies):
        if id(body.shape) not in shapes:
            shapes[id(body.shape)] = engine_carom.shape_of(body.shape)[0]
        poses.append((shapes[id(body.shape)], reach(body.shape), *((body.position, body.orientation) if body.kind == "static" else world.pose(i))))
    worst = 0.0
    for i, (a, ra, pa, qa) in enumerate(poses):
        for k, (b, rb, pb, qb) in enumerate(poses[:i]):
            if (bodies[i].kind == "dynamic" or bodies[k].kind == "dynamic") and math.dist(pa, pb) < ra + rb:
                worst = max(worst, -engine_carom.ENGINE.distance(a, b, pa, pb, qa, qb).separation)
    return worst

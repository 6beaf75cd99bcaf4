"""What the comparison asks of a pair's surfaces, in the terms of Drake: drake_server.py builds worlds of it."""
from collections import Counter
from math import pi, sqrt


def law(a, b):
    """Of a pair: the geometric mean of frictions, the larger restitution."""
    return sqrt(a[0] * b[0]), max(a[1], b[1])


def surfaces_of(bodies):
    """How Drake, which takes the harmonic mean of frictions, is told of each kind of surface (friction, restitution).

    One law for all pairs that can touch: each surface has it. Else a surface has a geometry for each kind it meets.
    @param bodies  those with a shape
    @return  {kind: [(its law, kind that it is for or None)]}
    """
    moving = Counter(b.kind for b in bodies if not b.is_static)
    fixed = {b.kind for b in bodies if b.is_static}
    laws = {law(a, b) for a in moving for b in moving if a != b or moving[a] > 1}
    laws |= {law(a, b) for a in moving for b in fixed}
    kinds = sorted(set(moving) | fixed)
    if len(laws) <= 1:
        return {kind: [(next(iter(laws), (0.0, 0.0)), None)] for kind in kinds}
    return {a: [(law(a, b), b) for b in kinds] for a in kinds}


def returned(relaxation, steps):
    """Share of its speed with which a mass leaves a spring and damper, by SAP's implicit steps.

    @param relaxation  the damper's constant over the spring's, in steps   @param steps  half a period of the spring
    """
    pull, x, v = (pi / steps) ** 2, 0.0, -1.0
    while v < 1:
        force = -pull * (x + (1 + relaxation) * v) / (1 + pull * (1 + relaxation))
        if force <= 0:
            break
        v += force
        x += v
    return v


def relaxation_for(restitution, steps):
    """Where the steps themselves lose more than restitution leaves, there is no damper."""
    least, most = 0.0, 100.0 * steps
    if returned(least, steps) <= restitution:
        return least
    for _ in range(60):
        middle = (least + most) / 2
        least, most = (middle, most) if returned(middle, steps) > restitution else (least, middle)
    return least

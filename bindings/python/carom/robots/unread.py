"""What a model has that nothing else here looks at."""
from __future__ import annotations

from typing import Any

import numpy as np

from .links import name_of
from .problems import Problems


def note_unread(m: Any, problems: Problems) -> None:
    def some(values: Any) -> bool:
        return bool(np.any(values))

    def named(kind: str, values: Any, reason: str) -> None:
        names = [name_of(m, kind, k) for k in range(len(values)) if some(values[k])]
        if names:
            problems.add("joint" if kind == "jnt" else kind, names, reason)

    named("tendon", m.tendon_stiffnesspoly, "stiffnesspoly: springs here are straight")
    named("tendon", m.tendon_dampingpoly, "dampingpoly: dampers here are straight")
    named("tendon", m.tendon_springyield, "springyield: springs here do not yield")
    named("tendon", m.tendon_actfrclimited, "actuatorfrcrange: what pulls by it has its own forcerange alone")
    named("pair", m.pair_margin, "margin: contacts begin where those of its geoms do")
    named("jnt", m.jnt_stiffnesspoly, "stiffnesspoly: springs here are straight")
    named("jnt", m.jnt_springyield, "springyield: springs here do not yield")
    bent = [v for v in range(m.nv) if some(m.dof_dampingpoly[v])]
    if bent:
        problems.add("joint", [name_of(m, "jnt", int(m.dof_jntid[v])) for v in bent], "dampingpoly: dampers here are straight")
    for values, reason in ((m.geom_adhesion, "adhesion: contacts here do not pull"),
                           (m.geom_surfacevel, "surfacevel: the surface rests")):
        named("geom", values, reason)
    if m.nflex:
        problems.add("flex", [name_of(m, "flex", k) for k in range(m.nflex)], "the library has no soft bodies")
    if m.nplugin:
        problems.add("plugin", [name_of(m, "plugin", k) for k in range(m.nplugin)], "what a plugin of MuJoCo's does")
    if int(m.opt.disableactuator):
        problems.add("option", ["actuatorgroupdisable"], "all actuators act")

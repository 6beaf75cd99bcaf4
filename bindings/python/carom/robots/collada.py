"""Corners and triangles of a Collada file (.dae), as URDF has them: in metres, by the file's own unit, in its own axes; its <up_axis>
turns nothing, as in ROS. Of a file there counts what its scene shows: triangles, and polygons as fans."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Iterator, Union
from xml.etree.ElementTree import Element

import numpy as np

from . import turns

if TYPE_CHECKING:
    from .turns import Array

MOST_CORNERS = 1 << 24  # of all triangles: scenes may show one mesh over and over
DEEPEST = 64            # nodes in nodes


def triangles(root: Element) -> Union[Array, str]:
    """@return corners, m, three a triangle, or why they can't be told"""
    for element in root.iter():
        element.tag = element.tag.rpartition("}")[2]
    by_id = {element.get("id"): element for element in root.iter() if element.get("id")}
    try:
        unit = root.find("asset/unit")
        scale = float(unit.get("meter", "1")) if unit is not None else 1.0
        shown = root.find("scene/instance_visual_scene")
        scene = by_id.get(shown.get("url", "")[1:]) if shown is not None else root.find("library_visual_scenes/visual_scene")
        if scene is None:
            return "it shows no scene"
        found: list[Array] = []
        count = 0
        for part in _parts(scene, np.diag([scale, scale, scale, 1.0]), by_id, 0):
            found.append(part)
            count += len(part)
            if count > MOST_CORNERS:
                return f"it has more than {MOST_CORNERS} corners"
    except (ValueError, IndexError, KeyError, TypeError, AttributeError) as why:
        return f"it is no Collada that can be read ({why})"
    if not count:
        return "its scene shows no triangles"
    corners = np.concatenate(found)
    return corners if np.isfinite(corners).all() else "it has corners that are not finite"


def _parts(node: Element, above: Array, by_id: dict[Any, Element], depth: int) -> Iterator[Array]:
    if depth > DEEPEST:
        raise ValueError(f"nodes lie more than {DEEPEST} deep")
    place = above
    for child in node:
        if child.tag in ("matrix", "translate", "rotate", "scale"):
            place = place @ _step(child)
        elif child.tag in ("skew", "lookat", "instance_node", "instance_controller"):
            raise ValueError(f"<{child.tag}>")
    for child in node:
        if child.tag == "node":
            yield from _parts(child, place, by_id, depth + 1)
        elif child.tag == "instance_geometry":
            mesh = by_id[child.get("url", "")[1:]].find("mesh")
            if mesh is not None:
                yield _corners(mesh, by_id) @ place[:3, :3].T + place[:3, 3]


def _step(element: Element) -> Array:
    values = _floats(element)
    step = np.eye(4)
    if element.tag == "matrix":
        step = values.reshape(4, 4)
    elif element.tag == "translate":
        step[:3, 3] = values
    elif element.tag == "scale":
        step[:3, :3] = np.diag(values)
    else:
        axis, angle = values[:3], math.radians(values[3])
        step[:3, :3] = turns.matrix(turns.about(axis / np.linalg.norm(axis), angle))
    return step


def _corners(mesh: Element, by_id: dict[Any, Element]) -> Array:
    """(n, 3): three a triangle"""
    found = [np.zeros((0, 3))]
    for kind in ("triangles", "polylist"):
        for faces in mesh.iter(kind):
            inputs = [(one.get("semantic"), int(one.get("offset", "0")), by_id[one.get("source", "")[1:]]) for one in faces.iter("input")]
            wide = 1 + max(offset for _, offset, _ in inputs)
            offset, vertices = next((offset, source) for semantic, offset, source in inputs if semantic == "VERTEX")
            positions = next(by_id[one.get("source", "")[1:]] for one in vertices.iter("input") if one.get("semantic") == "POSITION")
            numbers = positions.find("float_array")
            points = _floats(numbers).reshape(-1, 3)  # type: ignore[arg-type]
            rows = np.concatenate([_integers(p) for p in faces.iter("p")] or [np.zeros(0, int)]).reshape(-1, wide)[:, offset]
            if len(rows) and not 0 <= rows.min() <= rows.max() < len(points):
                raise ValueError("an index that points at no corner")
            if kind == "polylist":
                rows = _fans(rows, _integers(faces.find("vcount")))
            found.append(points[rows])
    return np.concatenate(found)


def _fans(rows: Any, counts: Any) -> Any:
    """Indices of polygons as those of triangles."""
    if counts.sum() != len(rows):
        raise ValueError("<vcount> does not add up")
    out: list[Any] = []
    first = 0
    for count in counts:
        for k in range(1, count - 1):
            out += [rows[first], rows[first + k], rows[first + k + 1]]
        first += count
    return np.array(out, int)


def _floats(element: Element) -> Array:
    return np.array((element.text or "").split(), float)


def _integers(element: Element | None) -> Any:
    return np.array((element.text or "").split() if element is not None else [], int)

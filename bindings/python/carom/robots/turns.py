"""Turns as quaternions x, y, z, w, and poses (place, turn), as numpy arrays."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Pose = Tuple[Array, Array]

NONE: Any = np.array([0.0, 0.0, 0.0, 1.0])


def from_mujoco(q: Any) -> Array:
    """w, x, y, z, of any length, as x, y, z, w, unit."""
    w, x, y, z = (float(part) for part in q)
    length = math.sqrt(w * w + x * x + y * y + z * z)
    if not length:
        raise ValueError("a quaternion of zeros turns nowhere; type 1, 0, 0, 0 for no turn")
    return np.array([x, y, z, w]) / length


def to_mujoco(q: Any) -> Array:
    x, y, z, w = (float(part) for part in q)
    return np.array([w, x, y, z])


def multiply(q: Any, p: Any) -> Array:
    """First p, then q."""
    a, b, c, d = q
    x, y, z, w = p
    return np.array([d * x + a * w + b * z - c * y, d * y - a * z + b * w + c * x, d * z + a * y - b * x + c * w, d * w - a * x - b * y - c * z])


def inverse(q: Any) -> Array:
    return np.array([-q[0], -q[1], -q[2], q[3]])


def cross(u: Any, v: Any) -> Array:
    """Of two vectors; numpy's own takes twenty times as long."""
    a, b, c = u
    x, y, z = v
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


def rotate(q: Any, v: Any) -> Array:
    a, b, c, d = q
    x, y, z = v
    r, s, t = 2 * (b * z - c * y), 2 * (c * x - a * z), 2 * (a * y - b * x)
    return np.array([x + d * r + b * t - c * s, y + d * s + c * r - a * t, z + d * t + a * s - b * r])


def matrix(q: Any) -> Array:
    """Columns: where the axes go."""
    return np.stack([rotate(q, axis) for axis in np.eye(3)], axis=1)


def matrices(q: Any) -> Array:
    """(n, 4) as (n, 3, 3)"""
    x, y, z, w = np.asarray(q, float).T
    return np.stack([np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], axis=1),
                     np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], axis=1),
                     np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=1)], axis=1)


def about(axis: Any, angle: float) -> Array:
    """@param axis  unit   @param angle  rad"""
    s = math.sin(angle / 2)
    return np.array([s * axis[0], s * axis[1], s * axis[2], math.cos(angle / 2)])


def x_to(axis: Any) -> Array:
    """The shortest turn that brings the x axis to `axis`, unit."""
    x, y, z = (float(part) for part in axis)
    if x < -1 + 1e-12:
        return np.array([0.0, 0.0, 1.0, 0.0])
    w = math.sqrt((1 + x) / 2)
    return np.array([0.0, -z / (2 * w), y / (2 * w), w])


def on(pose: Pose, q: Pose) -> Pose:
    """The pose `q`, told in the frame `pose`, in that frame's own parent."""
    return pose[0] + rotate(pose[1], q[0]), multiply(pose[1], q[1])


def of_matrix(axes: Any) -> Array:
    """Of a rotation matrix: the largest part of the quaternion is found first, by a root."""
    m = np.asarray(axes, float)
    squares = [1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2], 1 - m[0, 0] - m[1, 1] + m[2, 2], 1 + m[0, 0] + m[1, 1] + m[2, 2]]
    k = int(np.argmax(squares))
    s = 2 * math.sqrt(squares[k])
    if k == 3:
        q = [(m[2, 1] - m[1, 2]) / s, (m[0, 2] - m[2, 0]) / s, (m[1, 0] - m[0, 1]) / s, s / 4]
    else:
        i, j = (k + 1) % 3, (k + 2) % 3
        q = [0.0, 0.0, 0.0, (m[j, i] - m[i, j]) / s]
        q[k], q[i], q[j] = s / 4, (m[i, k] + m[k, i]) / s, (m[j, k] + m[k, j]) / s
    found: Array = np.array(q) / np.linalg.norm(q)
    return found

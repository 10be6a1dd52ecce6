"""Rotation matrices [..., 3, 3] for column vectors, right-handed axes, radians."""

import numpy as np


def axis_angle(vector: np.ndarray) -> np.ndarray:
    """Rodrigues' formula: [..., 3] axis times angle → [..., 3, 3]."""
    vector = np.asarray(vector)
    angle = np.linalg.norm(vector, axis=-1)[..., None, None]
    x, y, z = np.moveaxis(vector / np.maximum(angle[..., 0], 1e-12), -1, 0)
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1)
    cross = cross.reshape(*vector.shape[:-1], 3, 3)
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)


def about(axis: str, angle: np.ndarray) -> np.ndarray:
    """Rotation about one coordinate axis, "x", "y" or "z": [...] → [..., 3, 3]."""
    angle = np.asarray(angle)
    matrix = np.zeros((*angle.shape, 3, 3), dtype=np.result_type(angle, np.float32))
    i = "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    matrix[..., i, i] = 1
    matrix[..., j, j] = matrix[..., k, k] = np.cos(angle)
    matrix[..., k, j] = np.sin(angle)
    matrix[..., j, k] = -matrix[..., k, j]
    return matrix


def euler(angles: np.ndarray, order: str) -> np.ndarray:
    """Product of rotations in the order written: "zyx" is Rz·Ry·Rx. [..., n] → [..., 3, 3]."""
    matrix = np.broadcast_to(np.eye(3), (*angles.shape[:-1], 3, 3))
    for i, axis in enumerate(order):
        matrix = matrix @ about(axis, angles[..., i])
    return matrix

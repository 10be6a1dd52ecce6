"""Turning poses about the vertical until the body faces one way, inside the graph."""

import torch
from torch import Tensor

from deciwatch.skeleton import INDEX, KEYPOINTS

LEFT = [INDEX["left_shoulder"], INDEX["left_hip"]]
RIGHT = [INDEX["right_shoulder"], INDEX["right_hip"]]
SHORTEST = 0.01  # net values


def facing(poses: Tensor) -> Tensor:
    """Horizontal direction from the body's right to its left, [B, L, K·3] → x and z, [B, L, 2].

    Of length 1; shorter only where there is hardly any (somebody lying on their side), so that
    turning by it never enlarges anything.
    """
    points = poses.unflatten(-1, (KEYPOINTS, 3))
    (left_shoulder, left_hip), (right_shoulder, right_hip) = LEFT, RIGHT
    across = points[:, :, left_shoulder] - points[:, :, right_shoulder]
    across = across + (points[:, :, left_hip] - points[:, :, right_hip])
    across = across[..., 0::2]
    length = torch.sqrt((across * across).sum(dim=-1, keepdim=True) + 1e-12)
    return across / torch.clamp(length, min=SHORTEST)


def turn(poses: Tensor, direction: Tensor, back: bool = False) -> Tensor:
    """Poses [B, L, K·3] about y until `direction` [B, L, 2] lies along x; `back` undoes it."""
    x, y, z = poses.unflatten(-1, (KEYPOINTS, 3)).unbind(-1)
    cosine, sine = direction[..., :1], direction[..., 1:]
    if back:
        sine = -sine
    return torch.stack([cosine * x + sine * z, y, cosine * z - sine * x], dim=-1).flatten(-2)

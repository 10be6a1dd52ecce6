"""Which clips are rendered: movement, avatar, frames, seed. The same plan for the same seed."""

from dataclasses import dataclass

import numpy as np

from deciwatch.motion.cmu import Bodies

LONGEST = 240  # frames of one clip
SHORTEST = 40
CLIPS_OF_A_SEQUENCE = (
    3  # in one pass over the movements, so that minutes of climbing do not prevail
)
STRIDES = (3, 4, 5, 5, 5)
DENSE_SHARE = 1 / 8  # of the training clips: every frame of a shorter piece
DENSE_LONGEST = 90


@dataclass(frozen=True)
class Clip:
    """`length` frames of a recorded sequence from `first`, every `stride`-th estimated."""

    name: str
    sequence: int
    first: int
    length: int
    stride: int
    avatar: str
    seed: int

    @property
    def estimated(self) -> np.ndarray:
        """Indices of the frames that are rendered and estimated, counted from `first`."""
        return np.arange(0, self.length, self.stride)


def plan(bodies: Bodies, avatars: list[str], frames: int, dense: bool, seed: int) -> list[Clip]:
    """Clips with at least `frames` estimated frames in all, pass after pass over the movements.

    `dense` estimates every frame of every clip.
    """
    rng = np.random.default_rng(seed)
    clips: list[Clip] = []
    planned = 0
    while planned < frames:
        pieces = [
            piece for i in rng.permutation(len(bodies.length)) for piece in _cut(rng, bodies, i)
        ]
        if dense:
            # One piece of each sequence first, so that a short plan still has all of them.
            pieces.sort(key=lambda piece: piece[3])
        for sequence, first, length, _ in pieces:
            if planned >= frames:
                break
            stride = 1 if dense else int(rng.choice(STRIDES))
            if not dense and rng.random() < DENSE_SHARE:
                stride, length = 1, min(length, DENSE_LONGEST)
            clip = Clip(
                name=f"{len(clips):05d}",
                sequence=sequence,
                first=first + (0 if dense else int(rng.integers(stride))),
                length=length - (0 if dense else stride),
                stride=stride,
                avatar=str(rng.choice(avatars)),
                seed=int(rng.integers(2**31)),
            )
            clips.append(clip)
            planned += len(clip.estimated)
    return clips


def _cut(rng: np.random.Generator, bodies: Bodies, index: int) -> list[tuple[int, int, int, int]]:
    """(sequence, first, length, how many before it) of the pieces of one sequence."""
    whole = int(bodies.length[index])
    count = int(np.clip(whole // LONGEST, 1, CLIPS_OF_A_SEQUENCE))
    pieces = []
    for place in range(count):
        length = int(min(rng.integers(min(120, whole), LONGEST + 1), whole))
        first = int(rng.integers(whole - length + 1))
        if length >= SHORTEST:
            pieces.append((int(index), first, length, place))
    return pieces

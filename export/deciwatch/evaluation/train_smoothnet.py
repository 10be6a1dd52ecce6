"""Training the SmoothNet-style baseline on the sequences that were estimated at every frame."""

import numpy as np
import torch

from deciwatch.errors import UserError
from deciwatch.evaluation.fit_baselines import dense_segments
from deciwatch.evaluation.pair_file import PairFile
from deciwatch.interpolate import interpolate
from deciwatch.metrics import mpjpe
from deciwatch.nets.smoothnet import WINDOW, SmoothNet, smooth_values
from deciwatch.normalise import frame_of, from_net, to_net

BATCH = 32  # windows
RATE = 1e-3


def train_smoothnet(files: list[PairFile], name: str, steps: int, seed: int) -> SmoothNet:
    """A net for one representation, in evaluation mode. Raises UserError without enough frames.

    The loss is SmoothNet's: mean absolute errors of positions and of accelerations, added.
    """
    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    tracks = _tracks(files, name)
    net = SmoothNet().train()
    optimiser = torch.optim.AdamW(net.parameters(), lr=RATE, weight_decay=0.01)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, RATE, total_steps=steps)
    for _ in range(steps):
        noisy, truth = _batch(rng, tracks)
        off = net(noisy) - truth
        loss = off.abs().mean() + off.diff(n=2, dim=-1).abs().mean()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        schedule.step()
    return net.eval()


def smoothnet_error(net: SmoothNet | None, files: list[PairFile], name: str) -> float:
    """MPJPE in metres or pixels on every dense sequence; of the estimates themselves without."""
    total, count = 0.0, 0
    for estimates, truth, frames, _ in dense_segments(files, name):
        poses = estimates
        if net is not None:
            frame = frame_of(estimates)
            poses = from_net(smooth_values(net, to_net(estimates, *frame), frames), *frame)
        total += mpjpe(poses, truth) * len(truth)
        count += len(truth)
    return total / count


def _tracks(files: list[PairFile], name: str) -> list[tuple[np.ndarray, np.ndarray]]:
    """Estimates and truths [L, C] in net values, L ≥ WINDOW, gaps filled by straight lines."""
    tracks = []
    for estimates, truth, frames, _ in dense_segments(files, name):
        steps = np.arange(frames[0], frames[-1] + 1)
        if len(steps) >= WINDOW:
            frame = frame_of(estimates)
            both = (to_net(poses, *frame) for poses in (estimates, truth))
            tracks.append(tuple(interpolate(frames, x, steps, "linear") for x in both))
    if not tracks:
        raise UserError(
            f"No training sequence has {WINDOW} frames in a row with somebody in view; SmoothNet "
            "needs longer ones that were estimated at every frame."
        )
    return tracks


def _batch(rng: np.random.Generator, tracks: list) -> tuple[torch.Tensor, torch.Tensor]:
    """Noisy and true tracks [BATCH, C, WINDOW], some backwards, some with their sign turned."""
    room = np.array([len(noisy) - WINDOW + 1 for noisy, _ in tracks], float)
    chosen = rng.choice(len(tracks), size=BATCH, p=room / room.sum())
    windows = []
    for index in chosen:
        first = rng.integers(int(room[index]))
        order = slice(None, None, rng.choice((-1, 1)))
        window = np.stack([track[first : first + WINDOW][order] for track in tracks[index]])
        windows.append(window * rng.choice((-1, 1), size=(1, 1, window.shape[2])))
    batch = torch.from_numpy(np.stack(windows).astype(np.float32)).transpose(2, 3)
    return batch[:, 0], batch[:, 1]

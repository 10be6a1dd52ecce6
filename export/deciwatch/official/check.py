"""The imported graphs against the net as its authors run it."""

import numpy as np
import torch
from torch import Tensor

from deciwatch.official.config import OfficialConfig
from deciwatch.official.reference import Reference
from deciwatch.onnx_export import NAMES, session

Arrays = dict[str, np.ndarray]


@torch.no_grad()
def reference_case(reference: Reference, seed: int) -> Arrays:
    """One window, with random estimates, through the reference: what goes into our two graphs and
    what must come out, by the graphs' names, float32, batch 1."""
    config, rng = reference.config, np.random.default_rng(seed)
    frames = config.last_frame + 1
    estimates = 0.5 * rng.standard_normal((1, frames, config.input_dim))
    estimates = torch.from_numpy(estimates.astype(np.float32))
    poses, clean, features = reference(estimates)
    times = np.arange(frames, dtype=np.float32)[None]
    outputs = {"clean": clean.numpy(), "features": features.numpy(), "poses": poses.numpy()}
    sampled = estimates[:, :: config.interval].numpy()
    return outputs | {
        "sampled": np.ascontiguousarray(sampled),
        "sample_times": np.ascontiguousarray(times[:, :: config.interval]),
        "frame_times": times,
    }


def difference_from_reference(
    weights: dict[str, Tensor], config: OfficialConfig, graphs: dict[str, bytes], seed: int = 0
) -> float:
    """Largest difference of any output of the graphs, run one after the other, on one window."""
    reference = Reference(config).eval()
    reference.load_state_dict(weights)
    expected = reference_case(reference, seed)
    known = {name: expected[name] for name in ("sampled", "sample_times", "frame_times")}
    for kind, (ins, outs) in NAMES.items():
        got = session(graphs[kind]).run(None, {name: known[name] for name in ins})
        known |= dict(zip(outs, got, strict=True))
    # np.max, unlike max, does not lose a NaN.
    worst = [np.abs(known[name] - expected[name]).max() for name in ("clean", "features", "poses")]
    return float(np.max(worst))

"""The training loss (the paper's equation 6)."""

from torch import Tensor

LAMBDA = 5.0
LITTLE = 0.0005  # net values


def loss(poses: Tensor, truth: Tensor, clean: Tensor, clean_truth: Tensor, lam: float) -> Tensor:
    """λ · L1 over all frames [B, T, K·D] plus L1 over the samples [B, S, K·D]; a scalar."""
    return lam * (poses - truth).abs().mean() + (clean - clean_truth).abs().mean()


def relative_loss(poses: Tensor, truth: Tensor, start: Tensor) -> Tensor:
    """L1 over all frames [B, T, K·D] as a share of that of `start`, the preliminary recovery.

    For true samples: between close ones W_PR errs by a millimetre, far apart by fifty, and each
    batch is to count. Below LITTLE it counts less, or the closest would silence all others.
    """
    return (poses - truth).abs().mean() / ((start - truth).abs().mean() + LITTLE)

"""The training loss (the paper's equation 6)."""

from torch import Tensor

LAMBDA = 5.0


def loss(poses: Tensor, truth: Tensor, clean: Tensor, clean_truth: Tensor, lam: float) -> Tensor:
    """λ · L1 over all frames [B, T, K·D] plus L1 over the samples [B, S, K·D]; a scalar."""
    return lam * (poses - truth).abs().mean() + (clean - clean_truth).abs().mean()

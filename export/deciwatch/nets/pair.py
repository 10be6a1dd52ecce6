"""DenoiseNet and RecoverNet together, as they are trained."""

from dataclasses import asdict, dataclass

from torch import Tensor, nn

from deciwatch.nets.blocks import DROPOUT
from deciwatch.nets.denoise import DenoiseNet
from deciwatch.nets.recover import RecoverNet
from deciwatch.skeleton import KEYPOINTS


@dataclass(frozen=True)
class PairConfig:
    """What it takes to build a pair again: D, C, M, W_PR's kind and dropout."""

    dims: int = 3
    width: int = 64
    blocks: int = 5
    preliminary: str = "cubic"
    dropout: float = DROPOUT

    @property
    def values(self) -> int:
        """K·D."""
        return KEYPOINTS * self.dims

    def as_dict(self) -> dict:
        """Plain values, for a checkpoint."""
        return asdict(self)


class Pair(nn.Module):
    """The whole of DeciWatch after the estimator."""

    def __init__(self, config: PairConfig) -> None:
        super().__init__()
        self.config = config
        sizes = (config.values, config.width, config.blocks, config.dropout)
        self.denoise = DenoiseNet(*sizes)
        self.recover = RecoverNet(*sizes, config.preliminary)

    def forward(
        self, sampled: Tensor, sample_times: Tensor, frame_times: Tensor
    ) -> tuple[Tensor, Tensor]:
        """sampled [B, S, K·D] → clean [B, S, K·D], poses [B, T, K·D]."""
        clean, features = self.denoise(sampled, sample_times)
        return clean, self.recover(clean, features, sample_times, frame_times)

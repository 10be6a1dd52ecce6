"""DenoiseNet and RecoverNet together, as they are trained."""

from dataclasses import asdict, dataclass

from torch import Tensor, nn

from deciwatch.nets.blocks import DROPOUT
from deciwatch.nets.denoise import DenoiseNet
from deciwatch.nets.recover import RecoverNet
from deciwatch.nets.recover_samples import SampleRecoverNet
from deciwatch.skeleton import KEYPOINTS

# Numbers for each keypoint: metres (net values), pixels (net values), the estimator's score 0 to 1.
INPUTS = {"3d": 3, "2d": 2, "scores": 1}
RECOVERERS = ("frames", "samples")


@dataclass(frozen=True)
class PairConfig:
    """What it takes to build a pair again: D, inputs, C, M, RecoverNet's and W_PR's kind, dropout.

    `inputs` are the channels of DenoiseNet's `sampled`, side by side in this order, of INPUTS; the
    first is the pair's own representation. `recover` is one of RECOVERERS. `feed_forward` is the
    hidden width of the blocks' feed-forward layers, 0 for what C suggests. Without `denoise` the
    samples are taken as they are (true poses: the labelling task).
    """

    dims: int = 3
    width: int = 64
    blocks: int = 5
    preliminary: str = "cubic"
    dropout: float = DROPOUT
    inputs: tuple[str, ...] = ()
    recover: str = "frames"
    feed_forward: int = 0
    denoise: bool = True

    def __post_init__(self) -> None:
        own = f"{self.dims}d"
        inputs = tuple(self.inputs) or (own,)
        if inputs[0] != own or not set(inputs) <= INPUTS.keys() or len(set(inputs)) < len(inputs):
            raise ValueError(f"inputs {inputs} must begin with {own} and be of {tuple(INPUTS)}")
        if self.recover not in RECOVERERS:
            raise ValueError(f"RecoverNet {self.recover!r} is none of {RECOVERERS}")
        object.__setattr__(self, "inputs", inputs)

    @property
    def channels(self) -> int:
        """Width I of DenoiseNet's `sampled`."""
        return KEYPOINTS * sum(INPUTS[name] for name in self.inputs)

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
        forward = config.feed_forward or None
        self.denoise = DenoiseNet(*sizes, config.channels, forward, config.denoise)
        if config.recover == "samples":
            self.recover: nn.Module = SampleRecoverNet(
                *sizes, config.preliminary, forward, solid=config.dims == 3
            )
        else:
            self.recover = RecoverNet(*sizes, config.preliminary, forward)

    def forward(
        self, sampled: Tensor, sample_times: Tensor, frame_times: Tensor
    ) -> tuple[Tensor, Tensor]:
        """sampled [B, S, I] → clean [B, S, K·D], poses [B, T, K·D]."""
        clean, features = self.denoise(sampled, sample_times)
        return clean, self.recover(clean, features, sample_times, frame_times)

"""The authors' two nets under our contract, with the weights of a checkpoint."""

from torch import Tensor, nn

from deciwatch.official.config import OfficialConfig
from deciwatch.official.denoise import OfficialDenoiseNet
from deciwatch.official.recover import OfficialRecoverNet


class OfficialPair(nn.Module):
    """As deciwatch.nets.pair.Pair: what exports one exports the other."""

    def __init__(self, config: OfficialConfig) -> None:
        super().__init__()
        self.config = config
        self.denoise, self.recover = OfficialDenoiseNet(config), OfficialRecoverNet(config)

    def forward(
        self, sampled: Tensor, sample_times: Tensor, frame_times: Tensor
    ) -> tuple[Tensor, Tensor]:
        """sampled [B, S, K·D] → clean [B, S, K·D], poses [B, T, K·D]."""
        clean, features = self.denoise(sampled, sample_times)
        return clean, self.recover(clean, features, sample_times, frame_times)


def pair_of(weights: dict[str, Tensor], config: OfficialConfig) -> OfficialPair:
    """The pair with the weights of the authors' `transformer`, in evaluation mode.

    `weights` must fit `config` (see deciwatch.official.fit). torch keeps the query's, key's and
    value's matrices of its attention in one, `in_proj`, which is cut in three here.
    """
    ours: dict[str, Tensor] = {}
    for key, weight in weights.items():
        if ".in_proj_" in key:
            for part, piece in zip(("query", "key", "value"), weight.chunk(3), strict=True):
                ours[key.replace(".in_proj_", f".{part}.")] = piece
        else:
            ours[key] = weight
    pair = OfficialPair(config)
    for net, beginning in ((pair.denoise, "encoder"), (pair.recover, "decoder")):
        net.load_state_dict({key: w for key, w in ours.items() if key.startswith(beginning)})
    return pair.eval()

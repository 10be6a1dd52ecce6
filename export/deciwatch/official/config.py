"""What a checkpoint of the authors' format does not say of itself."""

from dataclasses import dataclass

from deciwatch.errors import UserError


@dataclass(frozen=True)
class OfficialConfig:
    """Sizes of the authors' nets; the defaults are those of their Human3.6M configuration.

    `input_dim` is K·D, `hidden` C, `interval` N, `window_q` Q. Raises UserError where sizes do not
    go together.
    """

    input_dim: int
    interval: int = 10
    window_q: int = 10
    hidden: int = 128
    heads: int = 4
    feed_forward: int = 256
    encoder_layers: int = 5
    decoder_layers: int = 5
    pre_norm: bool = True
    dims: int = 3

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if name != "pre_norm" and value < 1:
                option = "sample-interval" if name == "interval" else name.replace("_", "-")
                raise UserError(f"--{option} {value} makes no net; give 1 or more.")
        if self.input_dim % self.dims:
            raise UserError(
                f"--input-dim {self.input_dim} is not a whole number of {self.dims}D keypoints; "
                f"give keypoints × --dims."
            )
        if self.hidden % self.heads or self.hidden % 2:
            raise UserError(
                f"--hidden {self.hidden} must be even and a multiple of --heads {self.heads}; "
                f"give those that the checkpoint was trained with."
            )

    @property
    def keypoints(self) -> int:
        """K."""
        return self.input_dim // self.dims

    @property
    def last_frame(self) -> int:
        """Index N·Q of the last frame of the window that the nets were trained on."""
        return self.interval * self.window_q

    @property
    def shaping_options(self) -> list[str]:
        """The command's options that decide a checkpoint's keys and shapes."""
        return [
            f"--input-dim {self.input_dim}",
            f"--hidden {self.hidden}",
            f"--feed-forward {self.feed_forward}",
            f"--encoder-layers {self.encoder_layers}",
            f"--decoder-layers {self.decoder_layers}",
            f"--{'pre' if self.pre_norm else 'post'}-norm",
        ]

    # Under the names that PairConfig has, so that export and manifest take either.
    @property
    def channels(self) -> int:
        """Width of DenoiseNet's `sampled`."""
        return self.input_dim

    @property
    def width(self) -> int:
        """C."""
        return self.hidden

    @property
    def blocks(self) -> int:
        """M, of DenoiseNet."""
        return self.encoder_layers

    @property
    def inputs(self) -> tuple[str, ...]:
        """The only input is the pair's own representation."""
        return (f"{self.dims}d",)

    @property
    def recover(self) -> str:
        """RecoverNet's tokens are the frames."""
        return "frames"

    @property
    def preliminary(self) -> str:
        """Straight lines are what W_PR starts as; evaluation without RecoverNet leaves it there."""
        return "linear"

"""`deciwatch import-official`: a checkpoint of DeciWatch's authors as nets that the page loads."""

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from deciwatch.official.config import OfficialConfig

PAGE_WINDOW = 10  # WINDOW_INTERVALS in web/sampling/windows.ts


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("checkpoint", metavar="CHECKPOINT", help="their checkpoint.pth.tar")
    parser.add_argument("--out", metavar="DIR", required=True)
    for option, meaning in (
        ("--input-dim", "keypoints × dimensions, 99 for the page's 33 in 3D"),
        ("--sample-interval", "N that it was trained with"),
        ("--window-q", "Q that it was trained with"),
        ("--hidden", "embedding dimension C"),
    ):
        parser.add_argument(option, type=int, required=True, metavar="NUMBER", help=meaning)
    for option, usual in (
        ("--heads", 4),
        ("--feed-forward", 256),
        ("--encoder-layers", 5),
        ("--decoder-layers", 5),
    ):
        parser.add_argument(
            option, type=int, default=usual, metavar="NUMBER", help=f"default {usual}"
        )
    norm = parser.add_mutually_exclusive_group()
    norm.add_argument("--pre-norm", action="store_true", default=None, dest="pre_norm")
    norm.add_argument(
        "--post-norm",
        action="store_false",
        dest="pre_norm",
        help="default: pre-norm if the encoder ends with a norm",
    )
    parser.add_argument("--dims", type=int, choices=(2, 3), default=3)
    parser.add_argument(
        "--scale", type=float, metavar="METRES", help="that are 1 to the nets in 3D; default 1.0"
    )


def run(args: argparse.Namespace) -> int:
    """Read, check against the authors' way of running it, write, and say what to look out for."""
    from deciwatch import manifest
    from deciwatch.errors import UserError
    from deciwatch.official.config import OfficialConfig
    from deciwatch.official.convert import write_pair
    from deciwatch.official.fit import has_encoder_norm
    from deciwatch.official.read import read_state

    path, folder = Path(args.checkpoint), Path(args.out)
    if args.scale is not None and (args.dims == 2 or not 0 < args.scale < float("inf")):
        raise UserError(
            f"--scale {args.scale:g} is no size of 3D nets; give metres, and none with --dims 2."
        )
    if (folder / "manifest.json").exists():
        manifest.read(folder)
    given = read_state(path)
    config = OfficialConfig(
        input_dim=args.input_dim,
        interval=args.sample_interval,
        window_q=args.window_q,
        hidden=args.hidden,
        heads=args.heads,
        feed_forward=args.feed_forward,
        encoder_layers=args.encoder_layers,
        decoder_layers=args.decoder_layers,
        pre_norm=has_encoder_norm(given) if args.pre_norm is None else args.pre_norm,
        dims=args.dims,
    )
    worst = write_pair(given, config, path, args.scale or 1.0, folder)
    norm = "pre" if config.pre_norm else "post"
    print(f"{config.dims}D nets, {norm}-norm, in {folder}, within {worst:.1e} of the authors' way")
    for line in _remarks(config, folder):
        print(line)
    return 0


def _remarks(config: "OfficialConfig", folder: Path) -> Iterator[str]:
    """What the user should know; copies the pair that is not imported on the way."""
    from deciwatch.official.convert import complete
    from deciwatch.skeleton import KEYPOINTS

    if config.keypoints != KEYPOINTS:
        yield (
            f"The page cannot use them: its estimator gives {KEYPOINTS} keypoints, and these nets "
            f"take {config.keypoints}."
        )
        return
    other = 5 - config.dims
    if complete(folder, other):
        yield f"The {other}D nets beside them are copied from public/models."
    yield f"They know one frame in {config.interval} at 30 frames a second: choose that interval."
    if config.window_q < PAGE_WINDOW:
        yield (
            f"The page cuts windows of {PAGE_WINDOW} intervals, longer than the {config.window_q} "
            f"that they were trained on: expect poor poses."
        )
    if config.dims == 2:
        yield "The page gives them positions relative to the window's box, not to the picture."

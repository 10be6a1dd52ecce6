"""Which methods can be run on a file, and, in a sentence each, why the others cannot."""

from collections.abc import Callable

from deciwatch.evaluation.baselines_file import Baselines
from deciwatch.evaluation.classical import every_frame, interpolated
from deciwatch.evaluation.counted_nets import CountedNets, without_denoise, without_recover
from deciwatch.evaluation.method import CLASSICAL, RECOVERED, Method
from deciwatch.evaluation.pair_file import PairFile
from deciwatch.evaluation.recovered import recovered
from deciwatch.evaluation.smoothing import calibrated, one_euro_method, smoothnet_method
from deciwatch.skeleton import KEYPOINTS

VARIANTS: dict[str, Callable[[CountedNets], CountedNets]] = {
    "no_denoise": without_denoise,
    "no_recover": without_recover,
    "deciwatch": lambda pair: pair,
}


def available_methods(
    file: PairFile,
    wanted: tuple[str, ...],
    pairs: dict[str, CountedNets],
    baselines: Baselines,
    say: Callable[[str], None],
) -> dict[str, Method]:
    """The wanted methods that `file` can be scored with, in the order wanted.

    pairs: the nets by representation. `say` gets a sentence for whatever is left out.
    """
    methods: dict[str, Method] = {"every_frame": every_frame}
    methods |= {kind: interpolated(kind) for kind in CLASSICAL}
    methods |= _fitted(file, wanted, baselines, say)
    if set(wanted) & set(RECOVERED):
        fitting = _fitting(file, pairs, say)
        if fitting:
            methods |= {
                name: recovered({key: vary(pair) for key, pair in fitting.items()})
                for name, vary in VARIANTS.items()
            }
    return {name: methods[name] for name in wanted if name in methods}


def _fitted(
    file: PairFile,
    wanted: tuple[str, ...],
    baselines: Baselines,
    say: Callable[[str], None],
) -> dict[str, Method]:
    """The methods that need `deciwatch baselines` to have been run."""
    methods: dict[str, Method] = {}
    maps = baselines.calibration.get(file.estimator, {})
    if any(len(maps[name]) == file.keypoints for name in maps.keys() & file.estimates.keys()):
        methods["every_frame_calibrated"] = calibrated(maps)
    if baselines.one_euro.keys() & file.estimates.keys():
        methods["one_euro"] = one_euro_method(baselines.one_euro)
    if baselines.smoothnet.keys() & file.estimates.keys():
        methods["smoothnet"] = smoothnet_method(_smoothnets(baselines))
    for name in ("every_frame_calibrated", "one_euro", "smoothnet"):
        if name in wanted and name not in methods:
            say(
                f"{name} is left out for {file.estimator}: the baselines file has nothing fitted "
                "for it; run `deciwatch baselines`."
            )
    return methods


def _smoothnets(baselines: Baselines) -> dict:
    import torch

    from deciwatch.nets.smoothnet import SmoothNet

    nets = {}
    for name, weights in baselines.smoothnet.items():
        nets[name] = SmoothNet().eval()
        nets[name].load_state_dict({key: torch.from_numpy(x) for key, x in weights.items()})
    return nets


def _fitting(
    file: PairFile, pairs: dict[str, CountedNets], say: Callable[[str], None]
) -> dict[str, CountedNets]:
    """The nets whose inputs the file has."""
    if file.keypoints != KEYPOINTS:
        say(
            f"The nets are left out for {file.estimator}: they know {KEYPOINTS} keypoints, and "
            f"{file.path} has {file.keypoints}."
        )
        return {}
    has = set(file.estimates) | ({"scores"} if file.scores is not None else set())
    fitting = {}
    for name, pair in pairs.items():
        lacking = [part for part in pair.nets.inputs if part not in has]
        if lacking:
            say(
                f"The {name.upper()} nets are left out for {file.estimator}: they need "
                f"{' and '.join(lacking)}, which {file.path} does not hold."
            )
        else:
            fitting[name] = pair
    return fitting

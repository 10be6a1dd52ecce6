"""What methods, estimators and joint groups are called, and which colour each method has."""

METHODS = {
    "every_frame": "every frame",
    "every_frame_calibrated": "every frame, calibrated",
    "one_euro": "1€ on every frame",
    "smoothnet": "SmoothNet on every frame",
    "nearest": "nearest",
    "linear": "linear",
    "quadratic": "quadratic",
    "cubic": "cubic",
    "no_denoise": "without DenoiseNet",
    "no_recover": "without RecoverNet",
    "deciwatch": "DeciWatch",
}
IN_PROSE = {
    "every_frame": "the estimator on every frame",
    "every_frame_calibrated": "the calibrated estimator on every frame",
    "one_euro": "the 1€ filter on every frame",
    "smoothnet": "SmoothNet on every frame",
    "nearest": "the nearest sample",
    "linear": "linear interpolation",
    "quadratic": "quadratic interpolation",
    "cubic": "cubic interpolation",
    "no_denoise": "what is left without DenoiseNet",
    "no_recover": "what is left without RecoverNet",
    "deciwatch": "DeciWatch",
}
WATCH_ALL = ("every_frame", "every_frame_calibrated", "one_euro", "smoothnet")
CLASSICAL = ("nearest", "linear", "quadratic", "cubic")
# After Okabe and Ito, legible also to the colour-blind: https://jfly.uni-koeln.de/color/
OURS, BLACK, GREY = "#0072B2", "#222222", "#777777"
COLOURS = {
    "every_frame": BLACK,
    "every_frame_calibrated": "#8A6D00",
    "one_euro": "#B0407F",
    "smoothnet": "#00785A",
    "nearest": "#AAAAAA",
    "linear": "#D55E00",
    "quadratic": "#999999",
    "cubic": "#C98500",
    "no_denoise": "#D55E00",
    "no_recover": "#00785A",
    "deciwatch": OURS,
}
ESTIMATOR_COLOURS = {"lite": "#C98500", "full": OURS, "heavy": "#B0407F"}
SCHEMES = {
    "uniform": "uniform",
    "uniform_2": "uniform, in twos",
    "uniform_3": "uniform, in threes",
    "half_random": "half uniform, half random",
    "random": "random",
}
ESTIMATOR_ORDER = ("lite", "full", "heavy")
# The estimator whose pairs the nets are trained on.
TRAINED_ON = "mediapipe-full"


def estimator(name: str) -> str:
    """ "mediapipe-full" → "full"."""
    return name.removeprefix("mediapipe-")


def in_order(names: list[str]) -> list[str]:
    """Estimators from the lightest to the heaviest, unknown ones last."""
    order = {name: place for place, name in enumerate(ESTIMATOR_ORDER)}
    return sorted(names, key=lambda name: order.get(estimator(name), len(order)))

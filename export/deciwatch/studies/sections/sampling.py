"""Which frames are watched, at the same number of looks: uniform, in groups, at random."""

from deciwatch.studies.labels import COLOURS, METHODS, SCHEMES
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.words import against, lowest, mm, number

SHOWN = ("deciwatch", "linear", "cubic")
HEAD = ("watched frames", "MPJPE, mm", "Accel, mm/frame²", "linear: MPJPE, mm", "longest gap")


def write(sampling: Measured) -> Content:
    """The section."""
    names = [name for name in SCHEMES if sampling.where(scheme=name, method="deciwatch")]
    if "uniform" not in names or len(names) < 2:
        raise Lacking("sampling.json has no uniform scheme and another to compare it with")
    means = {name: _mean(sampling, name, "deciwatch") for name in names}
    rows = []
    for name in names:
        gaps = [row["longest_gap"] for row in sampling.where(scheme=name, method="deciwatch")]
        lines = sampling.where(scheme=name, method="linear")
        rows.append(
            (
                SCHEMES[name],
                number(means[name]["mpjpe_mm"]) + _spread(sampling, name),
                number(means[name]["accel_mm"]),
                number(_mean(sampling, name, "linear")["mpjpe_mm"] if lines else None),
                f"{max(gaps)} frames",
            )
        )
    return Content([_sentence(means)], HEAD, rows, [_plot(sampling, names)], _notes(sampling))


def _mean(sampling: Measured, scheme: str, method: str) -> dict:
    """Over the draws of a scheme that leaves something to chance."""
    rows = sampling.where(scheme=scheme, method=method)
    keys = ("mpjpe_mm", "accel_mm")
    return {key: sum(row[key] for row in rows) / len(rows) for key in keys} | {"scheme": scheme}


def _spread(sampling: Measured, scheme: str) -> str:
    values = [row["mpjpe_mm"] for row in sampling.where(scheme=scheme, method="deciwatch")]
    return f" ± {(max(values) - min(values)) / 2:.1f}" if len(values) > 1 else ""


def _sentence(means: dict[str, dict]) -> str:
    uniform = means["uniform"]["mpjpe_mm"]
    best = lowest([row for name, row in means.items() if name != "uniform"], "mpjpe_mm")
    worst = max(means.values(), key=lambda row: row["mpjpe_mm"])
    verdict = "the best" if uniform < best["mpjpe_mm"] else "not the best"
    return (
        f"Uniform sampling is {verdict}: MPJPE {mm(uniform)}, "
        f"{against(uniform, best['mpjpe_mm'])} the best of the others "
        f"({SCHEMES[best['scheme']]}, {mm(best['mpjpe_mm'])}); the highest is "
        f"{mm(worst['mpjpe_mm'])} ({SCHEMES[worst['scheme']]})."
    )


def _notes(sampling: Measured) -> list[str]:
    draws = len(sampling.values("draw"))
    return [
        f"As many looks as one frame in {sampling.about.get('interval')} takes, the first and the "
        f"last frame always among them. Random ones are means of {draws} draws, ± half their "
        "spread. The nets are the shipped ones, which know evenly and unevenly spaced samples."
    ]


def _plot(sampling: Measured, names: list[str]) -> Plot:
    def draw():
        from deciwatch.studies.charts.dots import DotPanel, Series, dot_chart

        def series(method: str, key: str) -> Series:
            values = [
                _mean(sampling, name, method)[key]
                if sampling.where(scheme=name, method=method)
                else None
                for name in names
            ]
            return Series(METHODS[method], values, COLOURS[method], method == "deciwatch")

        panels = [
            DotPanel(title, [series(method, key) for method in SHOWN])
            for title, key in (("MPJPE, mm", "mpjpe_mm"), ("Accel, mm/frame²", "accel_mm"))
        ]
        return dot_chart([SCHEMES[name] for name in names], panels, left=0.3)

    return Plot("sampling", "MPJPE and Accel by sampling scheme", draw)

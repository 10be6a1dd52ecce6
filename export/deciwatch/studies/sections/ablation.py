"""What each of the two nets is worth: the pair without the one and without the other."""

from deciwatch.studies.labels import COLOURS, METHODS
from deciwatch.studies.measured import Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.sections.common import N, at, intervals, usual
from deciwatch.studies.words import against, listed, mm, number

WITHOUT = {"no_denoise": "DenoiseNet", "no_recover": "RecoverNet"}
HEAD = ("N", "DeciWatch: MPJPE / Accel", "without DenoiseNet", "without RecoverNet")


def write(pairs: Measured) -> Content:
    """The section."""
    name = usual(pairs)
    steps = [n for n in intervals(pairs, name) if n > 1]
    table = {
        method: {n: at(pairs, method, n, name) for n in steps} for method in ("deciwatch", *WITHOUT)
    }
    rows = [
        (
            str(n),
            *(
                f"{number(of[n]['mpjpe_mm'])} / {number(of[n]['accel_mm'])}"
                for of in table.values()
            ),
        )
        for n in steps
    ]
    at(pairs, "deciwatch", N, name)  # the sentences are about it
    sentences = [
        _sentence(net, table["deciwatch"], table[method]) for method, net in WITHOUT.items()
    ]
    return Content(sentences, HEAD, rows, [_plot(table, steps)])


def _sentence(net: str, ours: dict[int, dict], without: dict[int, dict]) -> str:
    error, whole = without[N]["mpjpe_mm"], ours[N]["mpjpe_mm"]
    verdict = "worse" if error > whole else "no worse"
    accel = against(without[N]["accel_mm"], ours[N]["accel_mm"])
    text = (
        f"Without {net} it is {verdict} at N = {N}: MPJPE {mm(error)}, "
        f"{against(error, whole)} the whole ({mm(whole)}), Accel {accel} it"
    )
    useless = [str(n) for n in ours if without[n]["mpjpe_mm"] <= ours[n]["mpjpe_mm"]]
    if useless:
        return f"{text}; {net} does not lower MPJPE at N = {listed(useless)}."
    return f"{text}; it lowers MPJPE at every N above 1 that was measured."


def _plot(table: dict[str, dict[int, dict]], steps: list[int]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Line, Panel, line_chart

        panels = []
        for title, key in (("MPJPE, mm", "mpjpe_mm"), ("Accel, mm/frame²", "accel_mm")):
            lines = [
                Line(
                    METHODS[method],
                    steps,
                    [of[n][key] for n in steps],
                    COLOURS[method],
                    method == "deciwatch",
                )
                for method, of in table.items()
            ]
            panels.append(Panel(title, lines))
        return line_chart(panels, "N: one frame in N is watched", steps)

    return Plot("ablation", "MPJPE and Accel against N with either net taken out", draw)

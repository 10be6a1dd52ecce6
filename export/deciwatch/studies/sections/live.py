"""Live playback: what is on screen against the truth of that moment, and how late it is."""

from deciwatch.studies.labels import BLACK, OURS
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.section import Content, Plot
from deciwatch.studies.words import against, mm, number

N = 10
FPS = 30
NAMES = {
    "every_frame": "every frame, shown when it is answered",
    "every_frame_now": "every frame, taken for the present",
    "one_euro": "1€ on every frame, taken for the present",
    "hold": "the last look held",
    "linear": "on from two looks in a straight line",
    "smooth": "DeciWatch, smooth",
    "now": "DeciWatch, now",
}
COLOURS = {
    "every_frame": BLACK,
    "every_frame_now": BLACK,
    "one_euro": "#B0407F",
    "hold": "#AAAAAA",
    "linear": "#D55E00",
    "smooth": OURS,
    "now": "#00785A",
}
HEAD = ("shown", "N", "delay, ms", "MPJPE, mm", "PA-MPJPE, mm", "Accel, mm/frame²", "2D, px")


def write(live: Measured) -> Content:
    """The section."""
    late = max(live.values("late"))
    rows = [row for row in live.rows if row["late"] == late]
    if not rows:
        raise Lacking("live.json has no rows")
    notes = [
        "Delay: from a frame's capture to its skeleton on screen, without the camera's own and the "
        f"screen's. A look is answered {_ms(late)} ms after it, on every row; those that watch "
        "every frame would need a device that can look thirty times a second. MPJPE is against "
        "the truth of the moment that a pose is shown for."
    ]
    return Content(
        _sentences(live, late), HEAD, [_cells(row) for row in rows], [_plot(rows)], notes
    )


def _sentences(live: Measured, late: int) -> list[str]:
    def row(method: str, at: int = late) -> dict:
        return live.one(method=method, interval=N, late=at)

    smooth, now = row("smooth"), row("now")
    hold, linear = row("hold"), row("linear")
    every = live.one(method="every_frame", late=late)
    at_once, held, straight = row("now", 0), row("hold", 0), row("linear", 0)
    ratio = now["accel_mm"] / hold["accel_mm"]
    return [
        f"At N = {N}, smooth shows poses {_ms(smooth['delay_frames'])} ms late and is at "
        f"{mm(smooth['mpjpe_mm'])}, {against(smooth['mpjpe_mm'], every['mpjpe_mm'])} the estimator "
        f"on every frame ({mm(every['mpjpe_mm'])}). Now shows them at once and is at "
        f"{mm(now['mpjpe_mm'])}, {against(now['mpjpe_mm'], hold['mpjpe_mm'])} holding the last "
        f"look ({mm(hold['mpjpe_mm'])}) and {against(now['mpjpe_mm'], linear['mpjpe_mm'])} going "
        f"on in a straight line ({mm(linear['mpjpe_mm'])}); its Accel is {ratio:.0%} of the held "
        "look's. Were a look answered at once, it would be "
        f"{against(at_once['mpjpe_mm'], held['mpjpe_mm'])} holding and "
        f"{against(at_once['mpjpe_mm'], straight['mpjpe_mm'])} the straight line. What cannot be "
        "known cannot be foreseen: a dancer's next step is not in the last one, and now loses to "
        "smooth by what happens in a third of a second."
    ]


def _cells(row: dict) -> tuple[str, ...]:
    return (
        NAMES[row["method"]],
        str(row["interval"]),
        f"{_ms(row['delay_frames'])}",
        number(row["mpjpe_mm"]),
        number(row.get("pa_mpjpe_mm")),
        number(row["accel_mm"]),
        number(row.get("mpjpe_px")),
    )


def _ms(frames: int) -> int:
    return round(1000 * frames / FPS)


def _plot(rows: list[dict]) -> Plot:
    def draw():
        from deciwatch.studies.charts.lines import Level, Line, Panel, line_chart

        def panel(title: str, key: str) -> Panel:
            lines, levels = [], []
            for method, name in NAMES.items():
                own = sorted((x for x in rows if x["method"] == method), key=_interval)
                if len(own) > 1:
                    places, values = [x["interval"] for x in own], [x[key] for x in own]
                    strong = method in ("smooth", "now")
                    lines.append(Line(name, places, values, COLOURS[method], strong))
                elif own:
                    levels.append(Level(name, own[0][key], COLOURS[method]))
            return Panel(title, lines, levels, logarithmic=key == "accel_mm")

        steps = sorted({row["interval"] for row in rows} - {1})
        panels = [panel("MPJPE, mm", "mpjpe_mm"), panel("Accel, mm/frame²", "accel_mm")]
        return line_chart(panels, "N: one frame in N is watched", steps)

    return Plot("live", "MPJPE and Accel of what is on screen, against N", draw)


def _interval(row: dict) -> int:
    return row["interval"]

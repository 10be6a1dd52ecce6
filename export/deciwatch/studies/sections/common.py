"""What several sections ask of pairs.json."""

from deciwatch.studies.labels import CLASSICAL, IN_PROSE, TRAINED_ON, WATCH_ALL, estimator
from deciwatch.studies.measured import Lacking, Measured
from deciwatch.studies.words import listed, lowest

N = 10


def usual(pairs: Measured) -> str:
    """The estimator that most sections are about: the one that the nets were trained on."""
    names = pairs.values("estimator", method="deciwatch")
    if not names:
        raise Lacking(f"{pairs.name}.json has no row of the method deciwatch")
    return TRAINED_ON if TRAINED_ON in names else names[0]


def at(pairs: Measured, method: str, interval: int, estimator: str) -> dict:
    """A row; methods that watch every frame have the same one at every interval."""
    place = 1 if method in WATCH_ALL else interval
    return pairs.one(method=method, interval=place, estimator=estimator)


def there(pairs: Measured, methods: tuple[str, ...], interval: int, estimator: str) -> list[dict]:
    """Rows of those of the methods that were measured."""
    found = []
    for method in methods:
        place = 1 if method in WATCH_ALL else interval
        found += pairs.where(method=method, interval=place, estimator=estimator)[:1]
    return found


def best_classical(pairs: Measured, interval: int, estimator: str) -> dict:
    """The interpolation with the least MPJPE. Raises Lacking where none was measured."""
    rows = there(pairs, CLASSICAL, interval, estimator)
    if not rows:
        raise Lacking(f"{pairs.name}.json has no interpolation at N = {interval}")
    return lowest(rows, "mpjpe_mm")


def intervals(pairs: Measured, estimator: str) -> list[int]:
    """The N that DeciWatch was measured at, ascending."""
    return sorted(pairs.values("interval", method="deciwatch", estimator=estimator))


def name_of(row: dict) -> str:
    """What a row's method is called in a sentence."""
    return IN_PROSE[row["method"]]


def uneven_clips(pairs: Measured, names: list[str]) -> list[str]:
    """A note where the estimators' files hold different clips, else none."""
    frames = {pairs.one(method="deciwatch", estimator=name).get("frames") for name in names}
    if len(frames) < 2:
        return []
    parts = [
        f"{estimator(name)} on {pairs.one(method='deciwatch', estimator=name)['frames']:,} frames"
        for name in names
    ]
    return [f"Not all on the same clips: {listed(parts)}; compare only those of as many frames."]

"""Options that the kinds of evaluation share."""

from deciwatch.data.batches import INTERVALS
from deciwatch.errors import UserError


def intervals_of(given: str | None, default: tuple[int, ...]) -> list[int]:
    """The intervals of --every, such as "1,3,10", ascending. Raises UserError."""
    if given is None:
        return list(default)
    low, high = INTERVALS
    intervals = set()
    for word in given.split(","):
        try:
            interval = int(word)
        except ValueError:
            raise UserError(
                f"--every {given} is no list of whole numbers; give one such as 1,3,10."
            ) from None
        if not low <= interval <= high:
            raise UserError(f"--every {interval} is out of range; the nets know {low} to {high}.")
        intervals.add(interval)
    return sorted(intervals)

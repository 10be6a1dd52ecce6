"""Where things lie: the repository, the motion data, the committed checkpoints."""

import os
from pathlib import Path

from deciwatch.errors import UserError

REPOSITORY = Path(__file__).resolve().parents[2]
CHECKPOINTS = REPOSITORY / "export" / "checkpoints"
BASELINES = CHECKPOINTS / "baselines.npz"
MODELS = REPOSITORY / "public" / "models"
ESTIMATORS = REPOSITORY / "public" / "estimators" / "manifest.json"
FIXTURES = REPOSITORY / "tests" / "fixtures"
RUNS = REPOSITORY / "runs"


def data_directory(given: str | None = None) -> Path:
    """The motion folder: --data, else $DECIWATCH_DATA, else ../shared/data/cmu.

    Raises UserError if there is no such folder.
    """
    path = Path(
        given or os.environ.get("DECIWATCH_DATA") or REPOSITORY.parent / "shared/data/cmu"
    ).resolve()
    if not path.is_dir():
        raise UserError(
            f"There is no motion data folder at {path}; give one with --data DIR or DECIWATCH_DATA."
        )
    return path

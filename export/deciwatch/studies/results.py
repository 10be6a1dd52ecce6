"""`deciwatch results`: docs/results.md and its plots, from the JSON of what was measured."""

import argparse
import os
from pathlib import Path

from deciwatch.paths import REPOSITORY

DOCS = REPOSITORY / "docs"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "--from", metavar="DIR", dest="folder", default=str(DOCS / "results"), help="the JSON files"
    )
    parser.add_argument("--out", metavar="FILE", default=str(DOCS / "results.md"))


def run(args: argparse.Namespace) -> int:
    """Write the page, and the plots beside the JSON."""
    from deciwatch.atomic import write_text
    from deciwatch.errors import UserError
    from deciwatch.studies.measured import read_measured
    from deciwatch.studies.page import write_page

    folder, page = Path(args.folder).resolve(), Path(args.out).resolve()
    measured = read_measured(folder)
    link = Path(os.path.relpath(folder, page.parent)).as_posix()
    text, plots = write_page(measured, link)
    try:
        from deciwatch.studies.charts.style import save_svg, styled
    except ImportError as error:
        raise UserError(
            f"The plots need {error.name}; install it by `pip install -e 'export[results]'`."
        ) from error
    with styled():
        for plot in plots:
            save_svg(plot.draw(), folder / f"{plot.name}.svg")
    write_text(page, text)
    print(f"{page}: {len(plots)} plots from {', '.join(measured) or 'nothing'}")
    return 0

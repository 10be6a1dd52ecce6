"""`python -m deciwatch COMMAND`: see COMMANDS. Bad input ends with one sentence and exit code 2."""

import argparse
import importlib
import sys

from deciwatch.errors import UserError

# Modules are imported only when their command is asked for: torch alone takes seconds.
COMMANDS: dict[str, tuple[str, str]] = {
    "train": ("deciwatch.train", "train a pair of nets on recorded motion"),
    "train-forecast": (
        "deciwatch.train_forecast",
        "train the net that live playback looks ahead with",
    ),
    "export": ("deciwatch.export", "write a pair as ONNX files and a manifest"),
    "import-official": ("deciwatch.official.command", "run a checkpoint of DeciWatch's authors"),
    "evaluate": ("deciwatch.evaluate", "score the nets, interpolations and filters"),
    "baselines": ("deciwatch.baselines", "fit what the nets are compared with on pair files"),
    "study": ("deciwatch.studies.study", "run the paper's studies on pairs"),
    "results": ("deciwatch.studies.results", "write docs/results.md from what was measured"),
    "fit-noise": ("deciwatch.fit_noise", "fit the model of an estimator's errors to pairs"),
    "fixtures": ("deciwatch.fixtures", "write the numbers that the web tests check against"),
    "bundles": ("deciwatch.bundles", "build MediaPipe's estimator bundles"),
    "pairs": ("deciwatch.pairs.command", "render avatars and estimate them, for training and test"),
    "sample": ("deciwatch.sample", "make the bundled sample video"),
}


def usage() -> str:
    """The list of commands."""
    lines = [f"  {name:15} {purpose}" for name, (_, purpose) in COMMANDS.items()]
    return "\n".join(["usage: python -m deciwatch COMMAND [--help]", "", "commands:", *lines])


def main(arguments: list[str] | None = None) -> int:
    """Run one command; returns its exit code."""
    arguments = sys.argv[1:] if arguments is None else arguments
    if not arguments or arguments[0] in ("-h", "--help"):
        print(usage())
        return 0 if arguments else 2
    name, *rest = arguments
    if name not in COMMANDS:
        print(f"deciwatch has no command {name!r}; it has {', '.join(COMMANDS)}.", file=sys.stderr)
        return 2
    module_name, purpose = COMMANDS[name]
    module = importlib.import_module(module_name)
    parser = argparse.ArgumentParser(prog=f"deciwatch {name}", description=purpose)
    module.add_arguments(parser)
    try:
        return module.run(parser.parse_args(rest))
    except UserError as error:
        print(error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())

"""`deciwatch pairs`: render avatars, estimate their poses, keep estimate and truth side by side."""

import argparse
import hashlib
import queue
import threading
import time
from pathlib import Path

from deciwatch.paths import REPOSITORY, RUNS, data_directory

AVATARS = REPOSITORY.parent / "shared" / "avatars"
SPLITS = ("val", "test", "train")
FRAMES = {"train": 62000, "val": 3000, "test": 8300}
TRUTH_FRAMES = 400_000
TRUTH_SEED = 1000  # added: its cameras are others than those of the rendered clips
SEEDS = {"train": 1, "val": 2, "test": 3}
# One clip in so many is shown to the other estimators too.
OTHERS_EVERY = {"train": 16, "val": 16, "test": 2}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument("--split", choices=SPLITS, action="append", help="default: all three")
    parser.add_argument("--frames", type=int, help="estimated frames at least, of each split")
    parser.add_argument("--estimators", default="full,lite,heavy")
    parser.add_argument("--processes", type=int, default=2, help="browsers at once (default 2)")
    parser.add_argument("--data", metavar="DIR", help="motion folder (else $DECIWATCH_DATA)")
    parser.add_argument("--avatars", metavar="DIR", default=str(AVATARS))
    parser.add_argument("--out", metavar="DIR", default=str(RUNS / "pairs"))
    parser.add_argument(
        "--assemble-only", action="store_true", help="render nothing, gather what is there"
    )
    parser.add_argument(
        "--truth-only",
        action="store_true",
        help="render nothing: write SPLIT-truth.npz, other clips' truth for training on made noise",
    )
    parser.add_argument("--sheet", metavar="FILE", help="draw a contact sheet (PNG) instead")


def run(args: argparse.Namespace) -> int:
    """Render what is not there yet, then write SPLIT-ESTIMATOR.npz. Stop it and run it again."""
    from deciwatch.errors import UserError
    from deciwatch.motion.cmu import read_shard
    from deciwatch.pairs.plan import plan

    names = args.estimators.split(",")
    if not names or not set(names) <= {"full", "lite", "heavy"}:
        raise UserError(f"--estimators {args.estimators} must be of full, lite and heavy.")
    if args.processes < 1 or (args.frames is not None and args.frames < 1):
        raise UserError("--processes and --frames must be 1 or more.")
    directory = data_directory(args.data)
    for split in args.split or SPLITS:
        # Test avatars are seen in no training; validation has training avatars in new movements.
        folder = Path(args.avatars) / ("test" if split == "test" else "train")
        avatars = sorted(path.name for path in folder.glob("*.glb"))
        if not avatars:
            raise UserError(f"{folder} has no avatars (.glb); point --avatars at the right folder.")
        bodies = read_shard(directory, split)
        frames = args.frames or FRAMES[split]
        clips = plan(bodies, avatars, frames, split == "test", SEEDS[split])
        out = Path(args.out) / split
        if args.truth_only:
            frames = args.frames or TRUTH_FRAMES
            clips = plan(bodies, avatars, frames, True, SEEDS[split] + TRUTH_SEED)
            _write_truth(bodies, clips, folder, Path(args.out) / f"{split}-truth.npz")
            continue
        if args.sheet:
            from deciwatch.pairs.sheet import draw_sheet

            draw_sheet(Path(args.sheet), bodies, clips, folder, Path(args.out) / "work", names)
            return 0
        if not args.assemble_only:
            _render(bodies, clips, folder, out, names, args.processes, split)
        _assemble(out, clips, names, bodies.names, split, Path(args.out))
    return 0


def _wanted(place: int, split: str, names: list[str]) -> list[str]:
    """The estimators that look at a clip: all of them at one in so many, else the first alone."""
    return names if place % OTHERS_EVERY[split] == 0 else names[:1]


def _render(bodies, clips, avatars: Path, out: Path, names: list, processes: int, split) -> None:
    from deciwatch.pairs.renderer import Renderer
    from deciwatch.pairs.scenes import stage
    from deciwatch.pairs.store import save_clip

    out.mkdir(parents=True, exist_ok=True)
    waiting: queue.SimpleQueue = queue.SimpleQueue()
    missing = [(i, clip) for i, clip in enumerate(clips) if not (out / _file(clip)).exists()]
    for item in missing:
        waiting.put(item)
    total = sum(len(clip.estimated) for _, clip in missing)
    print(f"{split}: {len(clips) - len(missing)} clips there, {len(missing)} to do", flush=True)
    done, begun, failure = [0], time.monotonic(), []

    def work(number: int) -> None:
        try:
            with Renderer(avatars, out.parent / "work" / f"{split}-{number}") as renderer:
                while not failure:
                    try:
                        place, clip = waiting.get_nowait()
                    except queue.Empty:
                        return
                    scene = stage(bodies, clip, avatars)
                    found, _ = renderer.draw(scene, _wanted(place, split, names), [])
                    save_clip(out / _file(clip), scene, found)
                    done[0] += len(clip.estimated)
                    rate = done[0] / (time.monotonic() - begun)
                    left = (total - done[0]) / rate / 60
                    print(
                        f"{split} {done[0]:6d} of {total} frames, {rate:.1f} a second, "
                        f"{left:.0f} min left",
                        flush=True,
                    )
        except BaseException as error:
            failure.append(error)

    workers = [threading.Thread(target=work, args=(i,)) for i in range(processes)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    if failure:
        raise failure[0]


def _file(clip) -> str:
    """Name of a clip's file; says what is in it, so that another plan finds none of its own."""
    about = f"{clip.sequence} {clip.first} {clip.length} {clip.stride} {clip.avatar} {clip.seed}"
    return f"{clip.name}-{hashlib.sha256(about.encode()).hexdigest()[:8]}.npz"


def _assemble(out: Path, clips, names, movements, split: str, folder: Path) -> None:
    from deciwatch.atomic import write_npz
    from deciwatch.pairs.store import assemble

    there = [path for clip in clips if (path := out / _file(clip)).exists()]
    for name in names:
        content = assemble(there, name, movements)
        if content is None:
            continue
        target = folder / f"{split}-{name}.npz"
        write_npz(target, content)
        seen = int((content["scores"][:, 0] >= 0).sum())
        print(
            f"{target}: {int(content['estimated'].sum())} estimated frames (seen in {seen}) of "
            f"{len(content['gt'])} in {len(content['length'])} clips"
        )


def _write_truth(bodies, clips, avatars: Path, target: Path) -> None:
    from deciwatch.atomic import write_npz
    from deciwatch.pairs.scenes import stage
    from deciwatch.pairs.store import truth_alone

    content = truth_alone(
        [stage(bodies, clip, avatars, varied=True) for clip in clips], bodies.names
    )
    write_npz(target, content)
    print(f"{target}: {len(content['gt'])} frames in {len(clips)} clips")

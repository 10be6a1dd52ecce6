"""The renderer: a process of headless Chromium that draws clips and shows them to MediaPipe."""

import base64
import json
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deciwatch.errors import UserError
from deciwatch.pairs.scenes import Scene
from deciwatch.paths import REPOSITORY
from deciwatch.skeleton import KEYPOINTS

ANSWER_SIZE = KEYPOINTS * 6 + 1  # of export/render/job.ts


@dataclass(frozen=True)
class Estimates:
    """What one estimator saw in E frames: NaN where nobody.

    poses_3d [E, 33, 3] metres, poses_2d [E, 33, 2] pixels, scores [E, 33], ms [E].
    """

    poses_3d: np.ndarray
    poses_2d: np.ndarray
    scores: np.ndarray
    ms: np.ndarray


class Renderer:
    """One Chromium page; draws one clip at a time. Close it, or use it as a context."""

    def __init__(self, avatars: Path, work: Path) -> None:
        if not (REPOSITORY / "node_modules").is_dir() or shutil.which("npx") is None:
            raise UserError("The renderer needs the page's packages; run `npm ci` first.")
        work.mkdir(parents=True, exist_ok=True)
        self.work = work
        self.process = subprocess.Popen(
            ["npx", "tsx", "export/render/drive.ts", str(avatars.resolve()), str(work.resolve())],
            cwd=REPOSITORY,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._expect("ready")

    def __enter__(self) -> "Renderer":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End the process and remove what it was given."""
        if self.process.stdin and not self.process.stdin.closed:
            self.process.stdin.close()
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
        shutil.rmtree(self.work, ignore_errors=True)

    def _expect(self, line: str) -> None:
        got = self.process.stdout.readline().strip()
        if got != line:
            raise RuntimeError(f"the renderer stopped (it said {got!r}, not {line!r})")

    def draw(
        self, scene: Scene, estimators: list[str], pictures: list[int]
    ) -> tuple[dict[str, Estimates], list[bytes]]:
        """The estimates of each estimator on the clip's estimated frames, and JPEG pictures.

        `pictures` are places among the estimated frames.
        """
        name, chosen = scene.clip.name, scene.clip.estimated
        matrices = np.concatenate(
            [scene.camera.matrices()[chosen, None], scene.matrices[chosen]], axis=1
        )
        (self.work / f"{name}.bin").write_bytes(
            matrices.transpose(0, 1, 3, 2).astype("<f4").tobytes()
        )
        job = {
            "avatar": f"/avatars/{scene.clip.avatar}",
            "estimators": estimators,
            "data": f"/jobs/{name}.bin",
            "frames": len(chosen),
            "nodes": scene.nodes,
            "width": int(scene.camera.width),
            "height": int(scene.camera.height),
            "fieldOfView": scene.camera.field_of_view,
            "surroundings": scene.surroundings,
            "pictures": pictures,
        }
        (self.work / f"{name}.json").write_text(json.dumps(job))
        self.process.stdin.write(f"{name}\n")
        self.process.stdin.flush()
        self._expect(f"done {name}")
        answer = json.loads((self.work / f"{name}.answer.json").read_text())
        for path in self.work.glob(f"{name}.*"):
            path.unlink()
        found = {
            estimator: _parse(base64.b64decode(text))
            for estimator, text in zip(estimators, answer["estimates"], strict=True)
        }
        return found, [base64.b64decode(url.split(",", 1)[1]) for url in answer["pictures"]]


def _parse(content: bytes) -> Estimates:
    numbers = np.frombuffer(content, "<f4").reshape(-1, ANSWER_SIZE)
    shape = (len(numbers), KEYPOINTS)
    three, two = KEYPOINTS * 3, KEYPOINTS * 5
    return Estimates(
        numbers[:, :three].reshape(*shape, 3),
        numbers[:, three:two].reshape(*shape, 2),
        numbers[:, two : two + KEYPOINTS],
        numbers[:, -1],
    )

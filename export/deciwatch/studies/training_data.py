"""What the variants are trained on: real pairs, the noise model on staged clips, or both."""

from dataclasses import dataclass
from pathlib import Path

from deciwatch.data.noise_file import load_noise
from deciwatch.data.residuals import ResidualNoise
from deciwatch.data.sources import Sources
from deciwatch.data.staged import load_staged
from deciwatch.data.training_pairs import Pairs, load_pairs
from deciwatch.studies.variants import VALUES, Settings

# Share of the batches that are real pairs.
SHARES = {"pairs": 1.0, "noise": 0.0, "both": 0.6}
EVERY_INPUT = max(VALUES["inputs"], key=len)


@dataclass(frozen=True)
class Material:
    """Real pairs, the truth of staged clips, and the noise that makes estimates of the latter."""

    pairs: Pairs
    staged: Pairs
    noise: ResidualNoise

    def sources(self, settings: Settings) -> Sources:
        """Where the batches of one variant come from."""
        return Sources(
            None,
            settings.config.inputs,
            self.noise,
            few=settings.config.recover == "samples",
            pairs=self.pairs,
            share=SHARES[settings.data],
            staged=self.staged,
        )


def load_material(pairs: list[Path], truth: Path, noise: Path) -> Material:
    """All of it, for every variant. Raises UserError, one sentence, where a file is unfit."""
    return Material(load_pairs(pairs, EVERY_INPUT), load_staged(truth), load_noise(noise))

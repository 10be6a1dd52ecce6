"""Training goes on exactly from where it stopped, and gets somewhere."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
import torch

from deciwatch import checkpoint
from deciwatch.data.batches import training_batch
from deciwatch.data.noise import NONE
from deciwatch.data.sources import Sources
from deciwatch.errors import UserError
from deciwatch.loss import LITTLE
from deciwatch.nets.pair import PairConfig
from deciwatch.nets.preliminary import preliminary_recovery
from deciwatch.trainer import Recipe, Trainer

CONFIG = PairConfig(dims=2, width=16, blocks=1)


def trainer(motions, steps: int = 4, config: PairConfig = CONFIG, **options) -> Trainer:
    batch = partial(training_batch, motions=motions, inputs=("2d",), budget=200)
    return Trainer(config, Recipe(steps=steps, **options), batch)


def test_two_steps_and_two_steps_are_four_steps(motions, tmp_path):
    whole = trainer(motions)
    losses = [whole.step() for _ in range(4)]
    half = trainer(motions)
    first = [half.step() for _ in range(2)]
    half.save(tmp_path / "last.pt", {})
    torch.manual_seed(12345)
    rest = trainer(motions, seed=99)
    rest.resume(tmp_path / "last.pt")
    assert rest.progress == 0.5
    assert first + [rest.step() for _ in range(2)] == losses
    for ours, theirs in ((rest.pair, whole.pair), (rest.averaged, whole.averaged)):
        for name, weight in theirs.state_dict().items():
            assert torch.equal(ours.state_dict()[name], weight), name


def test_training_lowers_the_loss(motions):
    run = trainer(motions, steps=60, rate=4e-3, denoise_first=0.0)
    losses = [run.step() for _ in range(60)]
    assert sum(losses[-15:]) < 0.9 * sum(losses[:15])


def test_on_true_samples_only_the_frames_between_are_learnt(motions):
    config = PairConfig(dims=2, width=32, blocks=1, recover="samples", denoise=False)
    batch = Sources(motions, config.inputs, NONE, few=True)(np.random.default_rng(3))
    recipe = Recipe(steps=60, rate=4e-3, denoise_first=0.5)
    run = Trainer(config, recipe, lambda rng, sparse: batch)
    losses = [run.step() for _ in range(60)]
    # As a share of W_PR's error, so that every batch counts alike, whatever its interval.
    given = map(torch.from_numpy, (batch.clean, batch.sample_times, batch.frame_times))
    off = (preliminary_recovery(*given, "cubic") - torch.from_numpy(batch.poses)).abs().mean()
    assert losses[0] == pytest.approx((off / (off + LITTLE)).item(), rel=1e-4)
    assert sum(losses[-5:]) < 0.7 * sum(losses[:5])


def test_the_rate_warms_up_and_comes_down(motions):
    run = trainer(motions, steps=1000)
    rates = []
    for run.done in (0, 30, 500, 1000):
        rates.append(run.rate())
    assert rates[0] < rates[1] and rates[1] > rates[2] > rates[3] > 0
    assert max(rates) == pytest.approx(run.recipe.rate, rel=0.01)


def test_a_shared_checkpoint_cannot_be_resumed_but_started_from(motions, tmp_path):
    run = trainer(motions)
    run.step()
    checkpoint.save(tmp_path / "shared.pt", CONFIG, run.averaged.state_dict(), {"steps": 1})
    with pytest.raises(UserError, match="not a running training"):
        run.resume(tmp_path / "shared.pt")
    other = trainer(motions, seed=5)
    assert other.start_from(tmp_path / "shared.pt") == {"steps": 1}
    wider = Trainer(PairConfig(dims=2, width=20, blocks=1), run.recipe, run.make_batch)
    with pytest.raises(UserError, match="another make"):
        wider.start_from(tmp_path / "shared.pt")
    assert torch.equal(other.pair.denoise.embed.weight, run.averaged.denoise.embed.weight)


def test_a_recover_net_is_taken_over_without_what_it_made_of_other_features(motions, tmp_path):
    config = PairConfig(dims=2, width=16, blocks=1, recover="samples", denoise=False)
    one = Trainer(config, Recipe(steps=4), Sources(motions, ("2d",), NONE, few=True))
    for _ in range(3):
        one.step()
    one.share(tmp_path / "label.pt", {})
    other = trainer(motions, config=replace(config, denoise=True))
    other.recover_from(tmp_path / "label.pt")
    for net in (other.pair, other.averaged):
        assert torch.equal(net.recover.decode.weight, one.averaged.recover.decode.weight)
        assert not net.recover.adapt.weight.any() and one.averaged.recover.adapt.weight.any()
    with pytest.raises(UserError, match="RecoverNet of another make"):
        trainer(motions).recover_from(tmp_path / "label.pt")


def test_training_begins_with_the_best_linear_correction(motions):
    """Estimates that are the truth seen crookedly: a matrix and an offset undo that."""
    generator = np.random.default_rng(2)
    crooked = np.eye(66) + generator.normal(0, 0.05, (66, 66))

    def make(rng, sparse):
        batch = training_batch(rng, motions, ("2d",), sparse=sparse, budget=200)
        values = (batch.clean @ crooked + 0.1).astype(np.float32)
        return replace(batch, sampled=values)

    run = Trainer(CONFIG, Recipe(steps=4), make)
    run.start_linearly()
    batch = make(generator, True)
    clean = torch.from_numpy(batch.clean)
    with torch.no_grad():
        given = torch.from_numpy(batch.sampled), torch.from_numpy(batch.sample_times)
        got, _ = run.averaged.denoise(*given)
    assert (got - clean).abs().mean() < 0.1 * (given[0] - clean).abs().mean()


def test_damaged_checkpoints_are_named(tmp_path, motions):
    run = trainer(motions)
    run.save(tmp_path / "whole.pt", {})
    whole = (tmp_path / "whole.pt").read_bytes()
    (tmp_path / "half.pt").write_bytes(whole[: len(whole) // 2])
    (tmp_path / "empty.pt").write_bytes(b"")
    torch.save({"format": "another"}, tmp_path / "other.pt")
    checkpoint.save(tmp_path / "mixed.pt", PairConfig(dims=3), run.pair.state_dict(), {})
    for name in ("half", "empty", "other", "mixed", "none"):
        with pytest.raises(UserError) as caught:
            checkpoint.load_pair(tmp_path / f"{name}.pt")
        assert f"{name}.pt" in str(caught.value) and "\n" not in str(caught.value)
    assert sorted(p.name for p in tmp_path.iterdir() if p.name.startswith(".")) == []

import math

import numpy as np
import pytest
import torch

from iconnet import data, denoiser, diffuse, split
from iconnet.words import EMBED, NOTHING


def test_times_are_those_of_the_published_formula():
    left = denoiser.alpha_bar().double()
    level = lambda t: math.cos((t / 1000 + 0.008) / 1.008 * math.pi / 2) ** 2
    assert left.shape == (1000,)
    for t in (0, 1, 499, 900, 998):
        assert left[t].item() == pytest.approx(level(t + 1) / level(0), rel=1e-4)
    # The last beta would be one.
    assert left[999].item() == pytest.approx(left[998].item() * 0.001, rel=1e-3)


def test_eps_and_v_are_two_sayings_of_one_thing():
    random = torch.Generator().manual_seed(0)
    picture, noise = torch.rand(3, 1, 64, 64, generator=random) * 2 - 1, torch.randn(3, 1, 64, 64, generator=random)
    t = torch.tensor([10, 500, 990])
    x_t, v = denoiser.noised(picture, t, noise)

    class Knows(torch.nn.Module):
        def forward(self, _x_t, _t, _word):
            return v

    eps = denoiser.Eps(Knows())(x_t, t.float(), torch.zeros(3, 1, EMBED))
    assert torch.allclose(eps, noise, atol=1e-4)


def test_the_denoiser_is_small_and_hears_time_and_word():
    network = denoiser.seeded(0).eval()
    assert sum(p.numel() for p in network.parameters()) < 1.9e6
    torch.nn.init.normal_(network.unfold[-1].weight, std=0.1, generator=torch.Generator().manual_seed(0))
    random = torch.Generator().manual_seed(0)
    x, words = torch.randn(2, 1, 64, 64, generator=random), torch.nn.functional.normalize(
        torch.randn(2, EMBED, generator=random)
    )
    with torch.no_grad():
        found = network(x, torch.tensor([100.0, 100.0]), words)
        later = network(x, torch.tensor([900.0, 100.0]), words)
        other = network(x, torch.tensor([100.0, 100.0]), words.flip(0))
    assert found.shape == x.shape
    assert (later - found)[0].abs().max() > 1e-3 and torch.allclose(later[1], found[1], atol=1e-5)
    assert (other - found).abs().amax((1, 2, 3)).min() > 1e-3


@pytest.fixture(scope="module")
def trainer(places):
    """After a short training on the made-up icons."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(diffuse, "BATCH", 32)
        patch.setattr(diffuse, "REMEMBER", 0.9)
        found = diffuse.Trainer(places, diffuse.Plan(wires=0.0), resume=False)
        losses = []
        for step in range(150):
            found.step(step / 300)
            losses.append(float(found.seen[-1][1].mean()))
    found.losses = losses
    return found


def test_training_lowers_the_loss_and_the_averaged_weights_follow(trainer):
    assert np.mean(trainer.losses[-10:]) < 0.6 * np.mean(trainer.losses[:5])
    own, _, _ = trainer.held_out()
    assert own < trainer.losses[0]


def test_no_tested_icon_and_no_held_out_word_is_shown(trainer):
    assert not any(split.held_out(name) for name in [*trainer.names, *(tag for tags in trainer.tags for tag in tags)])
    assert not any(trainer.icons.sources[i] == "openmoji" for i in trainer.rows)
    assert all(split.reader(trainer.icons.sources[i], trainer.icons.names[i]) == "guide" for i in trainer.rows)


def test_things_are_what_emoji_are_called():
    icons = data.Icons(
        [diffuse.EMOJI, "bi", "bi", "bi"], ["v"] * 4, ["tabby", "cat", "tabby", "tab"], [["cat"], [], [], ["cat"]], None, None
    )
    assert diffuse.things(icons).tolist() == [True, True, True, False]


def test_words_are_left_out_as_often_as_the_plan_says(trainer):
    told = trainer._told(np.zeros(2000, int))
    nothing = (told == torch.from_numpy(NOTHING)).all(1).float().mean()
    assert 0.09 < nothing < 0.15


def test_checkpoints_are_gone_on_with(trainer, places):
    trainer.save()
    again = diffuse.Trainer(places, diffuse.Plan(), resume=True)
    assert again.steps == trainer.steps
    assert all(torch.equal(a, b) for a, b in zip(again.slow.parameters(), trainer.slow.parameters()))


def test_what_is_drawn_is_a_picture_and_the_seed_says_which(trainer, places):
    rows = torch.from_numpy(np.stack(list(data.texts(places).values())[:2]))
    pictures = [diffuse.draw(trainer.slow, rows, 2.0, steps=4, seed=seed) for seed in (0, 0, 1)]
    assert pictures[0].shape == (2, 1, 64, 64) and pictures[0].abs().max() <= 1.001
    assert torch.equal(pictures[0], pictures[1]) and not torch.equal(pictures[0], pictures[2])

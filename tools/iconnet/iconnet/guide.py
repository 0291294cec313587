"""A trial of guidance: one closed curve pulled by a word through the guiding networks, and ranked by the judge.

The judge has seen other icons, and is never asked for a gradient. Its rank of the word over all held-out and OpenMoji names is
the measure: a curve that only fools the guides is a mess to the judge.
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch.nn import functional as F

from . import curves, evaluate
from .data import Icons
from .errors import WordError
from .words import unit


@dataclass(frozen=True)
class Settings:
    """Of one trial. `controls` points move by Adam with `rate` (of the half picture, falling to a fifth) for `steps`; each step
    sees `views` random affine views; lines are `width` pixels; `smooth` weighs the curve's roughness."""

    controls: int = 56
    steps: int = 200
    rate: float = 0.015
    views: int = 8
    width: float = 1.6
    smooth: float = 0.3
    start: str = "ring"
    starts: int = 1
    seed: int = 0


@dataclass(frozen=True)
class Outcome:
    """`ink` uint8 [64,64]; the guides' mean cosine; the judge's `rank` of `of` names, and the names that it puts first."""

    word: str
    ink: np.ndarray
    cosine: float
    rank: int
    of: int
    first: list[str]


class Judge:
    """Ranks a word among all names of both tests for a picture; embeddings are centred over wires of the tests' icons."""

    def __init__(self, network, icons: Icons, words: dict[str, np.ndarray]):
        self.network, self.words = network, words
        which = np.concatenate([evaluate.rows(icons, test) for test in evaluate.TESTS])
        self.names = sorted({icons.names[i] for i in which})
        text = np.stack([words[name] for name in self.names])
        self.centre = text.mean(0)
        self.text = unit(text - self.centre)
        self.usual = evaluate.embeddings(network, icons.wires[which, 0]).mean(0)

    def __call__(self, ink: torch.Tensor, word: str) -> tuple[int, list[str]]:
        """Of one picture [1,1,64,64]: the word's rank from 1, whether it is one of the names or not, and the first four names."""
        self.network.eval()
        with torch.no_grad():
            seen = F.normalize(self.network(ink), dim=1)[0].numpy() - self.usual
        score, own = self.text @ seen, float(unit(self.words[word] - self.centre) @ seen)
        others = np.array([name != word for name in self.names])
        return int((score[others] > own).sum()) + 1, [self.names[i] for i in np.argsort(-score)[:4]]


def test_words(icons: Icons, n: int = 20, seed: int = 0) -> list[str]:
    """`n` of the held-out names, drawn by `seed`."""
    names = sorted({icons.names[i] for i in evaluate.rows(icons, "held-out")})
    return sorted(np.random.default_rng(seed).choice(names, n, replace=False).tolist())


def guide(networks: list, row: np.ndarray, settings: Settings) -> tuple[torch.Tensor, float]:
    """Ink [1,1,64,64] of the best of `starts` curves for the unit row [EMBED], and its mean cosine over networks and views."""
    for network in networks:
        network.eval().requires_grad_(False)
    random = torch.Generator().manual_seed(settings.seed)
    target, s = torch.from_numpy(row), settings
    make = curves.ring_controls if s.start == "ring" else curves.random_controls
    controls = make(s.starts, s.controls, random).requires_grad_(True)
    basis = curves.basis(s.controls, 8 * s.controls)
    optimiser = torch.optim.Adam([controls], lr=s.rate, betas=(0.9, 0.99))

    def cosines(points):  # [starts * views]
        width = s.width * (0.8 + 0.5 * torch.rand(len(points), generator=random))
        ink = curves.draw(points, width)
        return torch.stack([F.normalize(network(ink), dim=1) @ target for network in networks]).mean(0)

    for step in range(s.steps):
        optimiser.param_groups[0]["lr"] = s.rate * (1 - 0.8 * step / s.steps)
        points = curves.turned((basis @ controls).repeat_interleave(s.views, 0), random)
        bow = controls - (controls.roll(1, 1) + controls.roll(-1, 1)) / 2
        rough = (bow - (bow.roll(1, 1) + bow.roll(-1, 1)) / 2).square().sum((1, 2))
        loss = (-cosines(points).view(s.starts, s.views).mean(1) + s.smooth * rough).sum()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        with torch.no_grad():
            controls.clamp_(-0.92, 0.92)
    with torch.no_grad():
        found = cosines(curves.turned((basis @ controls).repeat_interleave(32, 0), random)).view(s.starts, 32).mean(1)
        best = int(found.argmax())
        return curves.draw(basis @ controls[best : best + 1], torch.tensor([s.width])), float(found[best])


def trial(guides: list, judge: Judge, words: list[str], rows: dict[str, np.ndarray], settings: Settings) -> list[Outcome]:
    """One Outcome a word. Raises WordError for a word that no icon bears as its name or tag."""
    outcomes = []
    for word in words:
        if word not in rows:
            raise WordError(f"{word!r} is neither a name nor a tag of any icon. Try a plainer word for it.")
        ink, cosine = guide(guides, rows[word], settings)
        rank, first = judge(ink, word)
        picture = (ink[0, 0] * 255).round().byte().numpy()
        outcomes.append(Outcome(word, picture, cosine, rank, len(judge.names), first))
    return outcomes

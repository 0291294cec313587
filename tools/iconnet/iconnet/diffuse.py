"""Trains the denoiser on the guides' icons, mostly as wires, and draws with it.

A picture is told by its name, by one of its tags, or by *nothing*; so the network learns what words have to do with pictures, and
what all pictures have in common.
"""

import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch

from . import data, denoiser, evaluate, pace, split, views
from .networks import SIZE
from .places import Places, need
from .words import NOTHING

NAME = "denoiser"


@dataclass(frozen=True)
class Plan:
    """How the denoiser is trained. `wires` is the share of pictures shown as wires, `nothing` that of pictures without a word, and
    `tagged` that of the others told by a tag; `things` is how much oftener things are shown than other icons."""

    seed: int = 4
    wires: float = 0.7
    nothing: float = 0.12
    tagged: float = 0.35
    things: float = 8.0


BATCH = 64
RATE, WARM, DECAY = 1.2e-3, 0.02, 0.01
MOST_SNR = 5.0  # signal to noise beyond which a time counts no more: details are then plain to see
REMEMBER = 0.999  # of the averaged weights, a step
LEAST = 0.02  # of RATE, at the end
REPORTS = 20
EMOJI = "fluent-emoji-high-contrast"


def train(places: Places, steps: int, minutes: float = math.inf, resume=False, plan: Plan | None = None, say=print) -> Path:
    """Writes the denoiser's checkpoint, like `train.train` those of the other networks."""
    trainer = Trainer(places, plan or Plan(), resume)
    say(f"{NAME}: {len(trainer.rows)} icons, {trainer.things.sum()} of things; {trainer.tests} tests")
    pace.to_the_end(trainer, NAME, steps, minutes, REPORTS, say)
    return trainer.file


class Trainer:
    """The denoiser on its way, `step` by step."""

    def __init__(self, places: Places, plan: Plan, resume: bool):
        self.icons, self.words = data.icons(places), data.texts(places)
        lesson = data.lesson(self.icons, self.words, "guide")
        self.rows, self.names = lesson.rows, [self.icons.names[i] for i in lesson.rows]
        self.tags = [[tag for tag in self.icons.tags[i] if not split.held_out(tag)] for i in lesson.rows]
        self.things = things(self.icons)[lesson.rows]
        odds = lesson.odds * np.where(self.things, plan.things, 1)
        self.odds = odds / odds.sum()
        self.file, self.plan, self.steps = places.checkpoint(NAME), plan, 0
        self.network, self.slow = denoiser.seeded(plan.seed), denoiser.seeded(plan.seed).requires_grad_(False).eval()
        if resume:
            kept = torch.load(need(self.file, f"train {NAME}"), weights_only=True)
            self.network.load_state_dict(kept["quick"])
            self.slow.load_state_dict(kept["weights"])
            self.steps = kept["steps"]
        self.optimiser = torch.optim.AdamW(self.network.parameters(), lr=RATE, betas=(0.9, 0.99), weight_decay=DECAY)
        seed = plan.seed + self.steps
        self.draws, self.random = np.random.default_rng(seed), torch.Generator().manual_seed(seed)
        self.seen: list[tuple[torch.Tensor, torch.Tensor]] = []
        which = evaluate.rows(self.icons, "held-out")[:256]
        self.tests = len(which)
        self.test = 1 - 2 * views.plain(torch.from_numpy(np.ascontiguousarray(self.icons.wires[which, 0])))
        self.test_words = torch.from_numpy(np.stack([self.words[self.icons.names[i]] for i in which]))

    def step(self, done: float) -> None:
        """`done` is the share of the training that is over."""
        fallen = LEAST + (1 - LEAST) * (0.5 + 0.5 * math.cos(math.pi * (done - WARM) / (1 - WARM)))
        for group in self.optimiser.param_groups:
            group["lr"] = RATE * (done / WARM if done < WARM else fallen)
        chosen = self.draws.choice(len(self.rows), BATCH, p=self.odds)
        picture, word = self._shown(chosen), self._told(chosen)
        # Times spread evenly over the batch: the losses of early and of late ones differ much.
        share = (torch.rand((), generator=self.random) + torch.arange(BATCH) / BATCH) % 1
        t = (share * denoiser.STEPS).long()
        x_t, v = denoiser.noised(picture, t, torch.randn(picture.shape, generator=self.random))
        with torch.autocast("cpu", torch.bfloat16):
            found = self.network(x_t, t.float(), word)
        every = (found.float() - v).square().mean((1, 2, 3))
        self.optimiser.zero_grad(set_to_none=True)
        (weight(t) * every).mean().backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimiser.step()
        self.steps += 1
        remember = min(REMEMBER, (1 + self.steps) / (10 + self.steps))
        for slow, quick in zip(self.slow.parameters(), self.network.parameters()):
            slow.lerp_(quick.detach(), 1 - remember)
        self.seen.append((t, every.detach()))

    def progress(self) -> str:
        """Mean losses since the last call, of early, middle and late times; and, on held-out icons as wires, the loss at a
        time with much noise with their own names, without a word, and with others' names."""
        t, every = (torch.cat(parts) for parts in zip(*self.seen))
        self.seen = []
        thirds = " ".join(f"{float(every[t * 3 // denoiser.STEPS == third].mean()):.4f}" for third in range(3))
        own, none, other = self.held_out()
        return f"loss {thirds}; held-out: own word {own:.4f}, nothing {none:.4f}, another {other:.4f}"

    def held_out(self, at: int = 800) -> tuple[float, float, float]:
        """Losses of v at one time, by the averaged weights, always with the same noise."""
        nothing = torch.from_numpy(NOTHING).expand_as(self.test_words)
        t = torch.full((self.tests,), at)
        x_t, v = denoiser.noised(self.test, t, torch.randn(self.test.shape, generator=torch.Generator().manual_seed(0)))
        with torch.inference_mode():
            loss = lambda words: float((self.slow(x_t, t.float(), words) - v).square().mean())
            return loss(self.test_words), loss(nothing), loss(self.test_words.roll(self.tests // 2, 0))

    def save(self) -> None:
        """Whole or not at all, so that whoever looks meanwhile finds a checkpoint."""
        self.file.parent.mkdir(parents=True, exist_ok=True)
        kept = {
            "weights": self.slow.state_dict(),
            "quick": self.network.state_dict(),
            "steps": self.steps,
            "seed": self.plan.seed,
        }
        part = self.file.with_suffix(".part")
        torch.save(kept, part)
        os.replace(part, self.file)

    def _shown(self, chosen: np.ndarray) -> torch.Tensor:
        """Pictures [n,1,64,64] of the chosen icons, paper 1 and ink -1, most as wires."""
        wired = self.draws.random(len(chosen)) < self.plan.wires
        which = self.draws.integers(self.icons.wires.shape[1], size=len(chosen))
        rows = self.rows[chosen]
        pictures = [self.icons.wires[i, k] if w else self.icons.pictures[i] for i, k, w in zip(rows, which, wired)]
        return 1 - 2 * views.affine(torch.from_numpy(np.stack(pictures)), self.random)

    def _told(self, chosen: np.ndarray) -> torch.Tensor:
        """Words [n,EMBED] of the chosen icons."""
        rows = []
        for i in chosen:
            nothing, tagged = self.draws.random(2) < (self.plan.nothing, self.plan.tagged)
            word = self.draws.choice(self.tags[i]) if tagged and self.tags[i] else self.names[i]
            rows.append(NOTHING if nothing else self.words[word])
        return torch.from_numpy(np.stack(rows))


def weight(t: torch.Tensor) -> torch.Tensor:
    """Of the loss of v at times `t`: one, and at times with little noise less (min-SNR, Hang et al. 2023, but for a floor: times with
    much noise are those at which words matter)."""
    left = denoiser.alpha_bar()[t]
    return ((MOST_SNR + 1) * (1 - left)).clamp(max=1)


def things(icons: data.Icons) -> np.ndarray:
    """True for icons whose name an emoji bears as its name or tag, bool [n]: those are things, where most other icons are parts of
    screens."""
    emoji: set[str] = set()
    for source, name, tags in zip(icons.sources, icons.names, icons.tags):
        if source == EMOJI:
            emoji |= {name, *tags}
    return np.array([name in emoji for name in icons.names])


def draw(network: denoiser.Denoiser, rows: torch.Tensor, scale: float, steps: int = 50, seed: int = 0) -> torch.Tensor:
    """Pictures [n,1,64,64], paper 1 and ink -1, of words [n,EMBED] out of noise: DDIM (Song et al. 2021) with guidance `scale`."""
    random = torch.Generator().manual_seed(seed)
    x = torch.randn(len(rows), 1, SIZE, SIZE, generator=random)
    nothing = torch.from_numpy(NOTHING).expand_as(rows)
    times = torch.linspace(denoiser.STEPS - 1, 0, steps + 1).round().long()
    left = torch.cat([denoiser.alpha_bar()[times[:-1]], torch.ones(1)])
    with torch.inference_mode():
        for i, t in enumerate(times[:-1]):
            both = network(x.repeat(2, 1, 1, 1), t.float().expand(2 * len(rows)), torch.cat([nothing, rows]))
            none, asked = both.chunk(2)
            v = none + scale * (asked - none)
            mine, other = left[i].sqrt(), (1 - left[i]).sqrt()
            # Pictures lie in -1..1, and guidance would leave it.
            picture = (mine * x - other * v).clamp(-1, 1)
            noise = (x - mine * picture) / other
            x = left[i + 1].sqrt() * picture + (1 - left[i + 1]).sqrt() * noise
    return x

"""Trains one network: pictures and wires towards their words, curves that show nothing towards nothing.

Each step shows every picture once as it is seen and a part of them once more, changed where it hurts most (one step up the loss,
of a given length): networks trained so have gradients that look like things. Random curves, and those of `adversaries`, are shown
as nothing.
"""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch.nn import functional as F

from . import curves, data, evaluate, networks, pace, views
from .adversaries import CONTROLS, POINTS, Adversaries
from .places import Places, need


@dataclass(frozen=True)
class Plan:
    """How one network is trained. `reader` says on which icons; `wires` is the share of pictures shown as wires;
    `hurt` the length of the change for the worse, in ink; `bend` how far lines are bent."""

    reader: str
    seed: int
    wires: float = 0.5
    hurt: float = 1.5
    bend: float = 1.0


PLANS = {
    "a": Plan("guide", 1),
    "b": Plan("guide", 2, wires=0.4, hurt=2.0, bend=1.5),
    "judge": Plan("judge", 3),
}
BATCH, AGAIN = 96, 32  # pictures a step, and how many of them are shown changed as well
OTHERS = 4096  # words a step that pictures are told from, besides those of the pictures themselves
TANGLES, FOES, POOL = 4, 8, 32  # random and climbing curves a step, and climbing ones at a time
PAUSE = 2  # steps from one turn of the climbing ones to the next
EASY = 0.5  # of the training, before pictures are changed for the worse
RATE, WARM, DECAY = 2.5e-3, 0.05, 0.03
SCALE, MOST_SCALE = 11.0, 40.0  # of cosines before the softmax, to begin with and at most
WEIGH_NOTHING, WEIGH_WORSE = 0.15, 0.5  # beside the loss of pictures as they are
REPORTS = 10


def train(places: Places, name: str, steps: int, minutes: float = math.inf, resume=False, plan: Plan | None = None, say=print) -> Path:
    """Writes the checkpoint of `name`. Stops early, its rate brought down in time, where `minutes` are over before `steps`.
    With `resume` it goes on from the last checkpoint's weights, with a schedule of its own."""
    trainer = Trainer(places, name, plan or PLANS[name], resume)
    say(f"{name}: {len(trainer.lesson.rows)} icons, {len(trainer.lesson.vocabulary) - 1} words")

    def recalls() -> None:
        for test in evaluate.TESTS:
            say(f"  {test}: {trainer.recall(test)}")

    pace.to_the_end(trainer, name, steps, minutes, REPORTS, say, recalls)
    return places.checkpoint(name)


class Trainer:
    """A network on its way: `step` by step, with what the step needs."""

    def __init__(self, places: Places, name: str, plan: Plan, resume: bool):
        self.icons, self.words = data.icons(places), data.texts(places)
        self.lesson = data.lesson(self.icons, self.words, plan.reader)
        self.file, self.plan, self.steps = places.checkpoint(name), plan, 0
        self.network = networks.seeded(name, plan.seed).to(memory_format=torch.channels_last)
        if resume:
            kept = torch.load(need(self.file, f"train {name}"), weights_only=True)
            self.network.load_state_dict(kept["weights"])
            self.steps = kept["steps"]
        self.scale = torch.nn.Parameter(torch.tensor(math.log(SCALE)))
        matrices = [p for p in self.network.parameters() if p.ndim > 1]
        others = [p for p in self.network.parameters() if p.ndim <= 1] + [self.scale]
        groups = [{"params": matrices, "weight_decay": DECAY}, {"params": others, "weight_decay": 0.0}]
        self.optimiser = torch.optim.AdamW(groups, lr=RATE, fused=True)
        # Not the first run's numbers once more after a resume.
        self.random = torch.Generator().manual_seed(plan.seed + self.steps)
        self.draws = np.random.default_rng(plan.seed + self.steps)
        self.foes = Adversaries(POOL, self.lesson.vocabulary[:-1], self.random)
        self.climbed = None
        self.seen: dict[str, list[float]] = {"loss": [], "foes": []}

    def step(self, done: float) -> None:
        """One batch; `done` is the share of the training that is over."""
        for group in self.optimiser.param_groups:
            group["lr"] = RATE * (done / WARM if done < WARM else 0.5 + 0.5 * math.cos(math.pi * (done - WARM) / (1 - WARM)))
        chosen = self.draws.choice(len(self.lesson.rows), BATCH, p=self.lesson.odds)
        answer, told = self.lesson.answer[chosen], _told(self.lesson, chosen, self.random)
        ink, negatives = self._shown(chosen), self._negatives()
        nothing = self.lesson.vocabulary[-1:].expand(len(negatives), -1)

        self.network.train()
        self.optimiser.zero_grad(set_to_none=True)
        ink.requires_grad_(done >= EASY)
        every = self._loss(torch.cat([ink, negatives]), torch.cat([answer, nothing]), *told)
        (every[:BATCH].mean() + WEIGH_NOTHING * every[BATCH:].mean()).backward()
        if done >= EASY:
            worse = _worse(ink.detach()[:AGAIN], ink.grad[:AGAIN], self.plan.hurt, self.random)
            (WEIGH_WORSE * self._loss(worse, answer[:AGAIN], *told).mean()).backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 5.0)
        self.optimiser.step()
        self.scale.data.clamp_(max=math.log(MOST_SCALE))
        self.steps += 1
        self.seen["loss"].append(float(every[:BATCH].detach().mean()))

    def progress(self) -> str:
        """Means since the last call: the loss of pictures, and the cosine that climbing curves reach."""
        means = " ".join(f"{key} {np.mean(values):.3f}" for key, values in self.seen.items() if values)
        self.seen = {key: [] for key in self.seen}
        return f"scale {float(self.scale.detach().exp()):.1f} {means}"

    def recall(self, test: str) -> evaluate.Recall:
        """Of icons, not of wires."""
        which = evaluate.rows(self.icons, test)
        names = [self.icons.names[i] for i in which]
        rank = evaluate.ranks(evaluate.embeddings(self.network, self.icons.pictures[which]), names, self.words)
        return evaluate.recall(rank, len(set(names)))

    def save(self) -> None:
        self.file.parent.mkdir(parents=True, exist_ok=True)
        torch.save({"weights": self.network.state_dict(), "steps": self.steps, "seed": self.plan.seed}, self.file)

    def _loss(self, ink, answer, words, more) -> torch.Tensor:
        """Softmax cross-entropy [n] of cosines with `words`, `more` added to the logits."""
        z = F.normalize(self.network(ink), dim=1)
        size = self.scale.exp()
        return (size * z @ words.T + more).logsumexp(1) - size * (z * answer).sum(1)

    def _shown(self, chosen: np.ndarray) -> torch.Tensor:
        """Views [n,1,64,64] of the chosen icons, some as wires."""
        wired = self.draws.random(len(chosen)) < self.plan.wires
        which = self.draws.integers(self.icons.wires.shape[1], size=len(chosen))
        rows = self.lesson.rows[chosen]
        pictures = [self.icons.wires[i, k] if w else self.icons.pictures[i] for i, k, w in zip(rows, which, wired)]
        return views.views(torch.from_numpy(np.stack(pictures)), self.random, self.plan.bend)

    def _negatives(self) -> torch.Tensor:
        """Ink of climbing and of random curves, the latter with few control points or with many."""
        if self.climbed is None or self.steps % PAUSE == 0:
            self.climbed, reached = self.foes.turn(self.network, FOES)
            self.seen["foes"].append(reached)
        controls = int(torch.randint(8, CONTROLS + 1, (), generator=self.random))
        points = curves.basis(controls, POINTS) @ curves.random_controls(TANGLES, controls, self.random)
        return torch.cat([self.climbed, curves.draw(points, 1 + 2.5 * torch.rand(TANGLES, generator=self.random))])


def _told(lesson, chosen, random) -> tuple[torch.Tensor, torch.Tensor]:
    """The words [k,EMBED] of one step's softmax, and what is added to each logit: a random few stand for all others."""
    count = len(lesson.vocabulary) - 1
    few = torch.randint(0, count, (min(OTHERS, count),), generator=random)
    own = lesson.name[chosen].unique()
    words = torch.cat([lesson.vocabulary[few], lesson.vocabulary[own], lesson.vocabulary[-1:]])
    more = torch.zeros(len(words))
    more[: len(few)] = math.log(count / len(few))
    return words, more


def _worse(ink: torch.Tensor, slope: torch.Tensor, most: float, random: torch.Generator) -> torch.Tensor:
    """`ink` [n,1,64,64], each changed up its loss's `slope` by a length of up to `most`."""
    length = slope.flatten(1).norm(dim=1).clamp(min=1e-12).view(-1, 1, 1, 1)
    return (ink + most * torch.rand(len(ink), 1, 1, 1, generator=random) * slope / length).clamp(0, 1)

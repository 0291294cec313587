"""Trains one network: pictures and wires towards their words, curves that show nothing towards nothing.

Each step shows every picture once as it is seen and a part of them once more, changed where it hurts most (one step up the loss,
of a given length): networks trained so have gradients that look like things. Random curves, and those of `adversaries`, are shown
as nothing.
"""

import math
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch.nn import functional as F

from . import curves, data, evaluate, networks, views
from .adversaries import CONTROLS, POINTS, Adversaries
from .places import Places


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
TANGLES, FOES, POOL = 4, 8, 64  # random and climbing curves a step, and climbing ones at a time
PAUSE = 2  # steps from one turn of the climbing ones to the next
EASY = 0.25  # of the training, before pictures are changed for the worse
RATE, WARM, DECAY = 2.5e-3, 0.05, 0.03
SCALE = 14.0  # of cosines before the softmax, to begin with
REPORTS = 10


def train(places: Places, name: str, steps: int, minutes: float = math.inf, plan: Plan | None = None, say=print) -> Path:
    """Writes the checkpoint of `name`. Stops early, its rate brought down in time, where `minutes` are over before `steps`."""
    plan = plan or PLANS[name]
    icons, words = data.icons(places), data.texts(places)
    lesson = data.lesson(icons, words, plan.reader)
    say(f"{name}: {len(lesson.rows)} icons, {len(lesson.vocabulary) - 1} words")
    network = networks.seeded(name, plan.seed).to(memory_format=torch.channels_last)
    scale = torch.nn.Parameter(torch.tensor(math.log(SCALE)))
    matrices = [p for p in network.parameters() if p.ndim > 1]
    others = [p for p in network.parameters() if p.ndim <= 1]
    optimiser = torch.optim.AdamW(
        [{"params": matrices, "weight_decay": DECAY}, {"params": [*others, scale], "weight_decay": 0.0}], lr=RATE, fused=True
    )
    random, draws = torch.Generator().manual_seed(plan.seed), np.random.default_rng(plan.seed)
    foes = Adversaries(POOL, lesson.vocabulary[:-1], random)
    nothing = lesson.vocabulary[-1:].expand(TANGLES + FOES, -1)

    def loss(ink, answer):
        z = F.normalize(network(ink), dim=1)
        size = scale.exp()
        return (size * z @ lesson.vocabulary.T).logsumexp(1) - size * (z * answer).sum(1)

    began, step, done, seen = time.monotonic(), 0, 0.0, {"loss": [], "foes": []}
    report = 1
    while done < 1:
        rate = RATE * (done / WARM if done < WARM else 0.5 + 0.5 * math.cos(math.pi * (done - WARM) / (1 - WARM)))
        for group in optimiser.param_groups:
            group["lr"] = rate
        chosen = draws.choice(len(lesson.rows), BATCH, p=lesson.odds)
        ink, answer = _shown(icons, lesson, chosen, plan, draws, random), lesson.answer[chosen]
        if step % PAUSE == 0:
            climbed, reached = foes.turn(network, FOES)
        negatives = torch.cat([climbed, _tangles(random)])

        network.train()
        optimiser.zero_grad(set_to_none=True)
        ink.requires_grad_(done >= EASY)
        every = loss(torch.cat([ink, negatives]), torch.cat([answer, nothing]))
        (every[:BATCH].mean() + 0.15 * every[BATCH:].mean()).backward()
        if done >= EASY:
            worse = _worse(ink.detach()[:AGAIN], ink.grad[:AGAIN], plan.hurt, random)
            (0.5 * loss(worse, answer[:AGAIN]).mean()).backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 5.0)
        optimiser.step()
        scale.data.clamp_(max=math.log(40))

        step += 1
        seen["loss"].append(float(every[:BATCH].detach().mean()))
        seen["foes"].append(reached)
        done = max(step / steps, (time.monotonic() - began) / 60 / minutes)
        if done >= report / REPORTS or step in (20, 200):
            report += done >= report / REPORTS
            say(f"{name} step {step} ({done:.0%}, {time.monotonic() - began:.0f} s) scale {float(scale.detach().exp()):.1f} "
                + " ".join(f"{k} {np.mean(v):.3f}" for k, v in seen.items()))  # fmt: skip
            seen = {k: [] for k in seen}
            if step > 200:
                for test in evaluate.TESTS:
                    which = evaluate.rows(icons, test)
                    names = [icons.names[i] for i in which]
                    rank = evaluate.ranks(evaluate.embeddings(network, icons.pictures[which]), names, words)
                    say(f"  {test}: {evaluate.recall(rank, len(set(names)))}")
                _save(places, name, network, step, plan)
    _save(places, name, network, step, plan)
    return places.checkpoint(name)


def _shown(icons, lesson, chosen, plan, draws, random) -> torch.Tensor:
    """Views [n,1,64,64] of the chosen icons, some as wires."""
    wired = draws.random(len(chosen)) < plan.wires
    which = draws.integers(icons.wires.shape[1], size=len(chosen))
    rows = lesson.rows[chosen]
    pictures = np.stack([icons.wires[i, k] if w else icons.pictures[i] for i, k, w in zip(rows, which, wired)])
    return views.views(torch.from_numpy(pictures), random, plan.bend)


def _worse(ink: torch.Tensor, slope: torch.Tensor, most: float, random: torch.Generator) -> torch.Tensor:
    """`ink` [n,1,64,64], each changed up its loss's `slope` by a length of up to `most`."""
    length = slope.flatten(1).norm(dim=1).clamp(min=1e-12).view(-1, 1, 1, 1)
    return (ink + most * torch.rand(len(ink), 1, 1, 1, generator=random) * slope / length).clamp(0, 1)


def _tangles(random: torch.Generator) -> torch.Tensor:
    """Ink of TANGLES random curves, some with few control points and some with many."""
    controls = int(torch.randint(8, CONTROLS + 1, (), generator=random))
    points = curves.basis(controls, POINTS) @ curves.random_controls(TANGLES, controls, random)
    return curves.draw(points, 1 + 2.5 * torch.rand(TANGLES, generator=random))


def _save(places: Places, name: str, network, step: int, plan: Plan) -> None:
    places.runs.mkdir(parents=True, exist_ok=True)
    torch.save({"weights": network.state_dict(), "steps": step, "seed": plan.seed}, places.checkpoint(name))

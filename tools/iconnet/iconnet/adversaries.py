"""A pool of curves that try to pass for words, each a little further at every turn, and are then shown as nothing.

Curves start at random and climb the current network's cosine with a random word. After LIFE turns a curve is given up and another
starts, so the network meets both clumsy and finished attempts.
"""

import torch
from torch.nn import functional as F

from . import curves

CONTROLS, POINTS = 48, 384
LIFE = 24  # turns
CLIMBS = 2  # steps a turn
STEP = 0.03  # of the half picture, by Adam
BETAS = 0.9, 0.98


class Adversaries:
    def __init__(self, size: int, words: torch.Tensor, random: torch.Generator):
        """`words` [k,EMBED] are unit rows to aim at."""
        self.words, self.random = words, random
        self.controls = torch.zeros(size, CONTROLS, 2)
        self.first, self.second = torch.zeros_like(self.controls), torch.zeros_like(self.controls)
        self.target = torch.zeros(size, words.shape[1])
        self.width = torch.ones(size)
        self.age = torch.randint(0, LIFE, (size,), generator=random)
        self._start(torch.arange(size))

    def _start(self, which: torch.Tensor) -> None:
        n = len(which)
        rings = torch.rand(n, 1, 1, generator=self.random) < 0.4
        self.controls[which] = torch.where(
            rings,
            curves.ring_controls(n, CONTROLS, self.random),
            curves.random_controls(n, CONTROLS, self.random),
        )
        self.first[which], self.second[which] = 0, 0
        self.target[which] = self.words[torch.randint(0, len(self.words), (n,), generator=self.random)]
        self.width[which] = 1 + 2 * torch.rand(n, generator=self.random)

    def turn(self, network, n: int) -> tuple[torch.Tensor, float]:
        """Lets `n` curves climb, and returns their ink [n,1,64,64] and the mean cosine that they had reached."""
        which = torch.randperm(len(self.controls), generator=self.random)[:n]
        old = which[self.age[which] >= LIFE]
        if len(old):
            self._start(old)
            self.age[old] = 0
        network.eval()
        basis = curves.basis(CONTROLS, POINTS)
        for _ in range(CLIMBS):
            controls = self.controls[which].requires_grad_(True)
            ink = curves.draw(curves.turned(basis @ controls, self.random), self.width[which])
            cosine = (F.normalize(network(ink), dim=1) * self.target[which]).sum(1)
            (slope,) = torch.autograd.grad(cosine.sum(), controls)
            first = self.first[which].lerp(slope, 1 - BETAS[0])
            second = self.second[which].lerp(slope.square(), 1 - BETAS[1])
            self.first[which], self.second[which] = first, second
            with torch.no_grad():
                self.controls[which] = (controls + STEP * first / (second.sqrt() + 1e-8)).clamp(-0.95, 0.95)
        network.train()
        self.age[which] += 1
        with torch.no_grad():
            ink = curves.draw(curves.turned(basis @ self.controls[which], self.random), self.width[which])
        return ink, float(cosine.detach().mean())

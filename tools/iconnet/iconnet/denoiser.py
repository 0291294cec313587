"""The denoiser: what a noised picture of 64 x 64 pixels was, given a word's row.

A small U-Net. It sees squares of 4 x 4 pixels as channels, so its widest layers work on 16 x 16 places and not on 4096: that is
what makes it quick enough for a processor. Time and word scale and shift the channels of every block, and a word has a map of its own
at the coarsest level, where it says what goes where: with scales alone that takes far longer to learn. Smooth throughout.
"""

import functools
import math

import torch
from torch import nn
from torch.nn import functional as F

from .words import EMBED

STEPS = 1000
FOLD = 4  # pixels a side of the squares that become channels
WIDTHS = 64, 128, 160  # channels at 16, 8 and 4 places a side
DOWN, UP = (1, 1, 1), (2, 1)  # blocks at each, on the way down and up again
TOLD = 128  # numbers that say time and word
WAVES = 32  # of the time
COARSEST = 4  # places a side
GROUPS = 8


@functools.lru_cache
def alpha_bar() -> torch.Tensor:
    """What is left of a picture's variance after each of STEPS steps, float32 [STEPS]: a squared cosine (Nichol and Dhariwal 2021,
    eq. 17), with betas of .999 at most."""
    level = torch.cos((torch.arange(STEPS + 1, dtype=torch.float64) / STEPS + 0.008) / 1.008 * math.pi / 2).square()
    return (level[1:] / level[:-1]).clamp(min=0.001).cumprod(0).float()


class Block(nn.Module):
    """Two convolutions beside the way through, scaled and shifted by what it is told."""

    def __init__(self, width: int):
        super().__init__()
        self.before, self.first = nn.GroupNorm(GROUPS, width), nn.Conv2d(width, width, 3, padding=1)
        self.between, self.second = nn.GroupNorm(GROUPS, width), nn.Conv2d(width, width, 3, padding=1)
        self.told = nn.Linear(TOLD, 2 * width)

    def forward(self, x, told):
        scale, shift = self.told(told)[:, :, None, None].chunk(2, 1)
        inner = self.between(self.first(F.silu(self.before(x))))
        return x + self.second(F.silu(inner * (1 + scale) + shift))


class Denoiser(nn.Module):
    """x_t [n,1,64,64] (paper 1, ink -1, noised), t [n] (0 to 999) and words [n,EMBED] to v [n,1,64,64] = sqrt(alpha_bar) noise -
    sqrt(1 - alpha_bar) picture (Salimans and Ho 2022), which has about the same size at every time."""

    def __init__(self):
        super().__init__()
        levels = lambda blocks: nn.ModuleList(nn.ModuleList(Block(width) for _ in range(n)) for width, n in zip(WIDTHS, blocks))
        self.tell = nn.Sequential(nn.Linear(EMBED + 2 * WAVES, TOLD), nn.SiLU(), nn.Linear(TOLD, TOLD), nn.SiLU())
        self.map = nn.Linear(EMBED, WIDTHS[-1] * COARSEST**2)
        self.fold = nn.Conv2d(FOLD * FOLD, WIDTHS[0], 3, padding=1)
        self.down, self.up = levels(DOWN), levels(UP)
        self.coarser = nn.ModuleList(nn.Conv2d(fine, coarse, 2, stride=2) for fine, coarse in zip(WIDTHS, WIDTHS[1:]))
        self.finer = nn.ModuleList(nn.Conv2d(coarse, fine, 1) for fine, coarse in zip(WIDTHS, WIDTHS[1:]))
        self.unfold = nn.Sequential(nn.GroupNorm(GROUPS, WIDTHS[0]), nn.SiLU(), nn.Conv2d(WIDTHS[0], FOLD * FOLD, 3, padding=1))
        nn.init.zeros_(self.unfold[-1].weight)

    def forward(self, x_t, t, word):
        # Rows of unit length have numbers of about a tenth, and waves of about one.
        word = EMBED**0.5 * word
        told = self.tell(torch.cat([word, _waves(t)], 1))
        x, kept = self.fold(F.pixel_unshuffle(x_t, FOLD)), []
        for level, blocks in enumerate(self.down):
            if level == len(self.coarser):
                x = x + self.map(word).view(-1, WIDTHS[-1], COARSEST, COARSEST)
            for block in blocks:
                x = block(x, told)
            if level < len(self.coarser):
                kept.append(x)
                x = self.coarser[level](x)
        for level in reversed(range(len(self.finer))):
            x = F.interpolate(self.finer[level](x), scale_factor=2.0) + kept[level]
            for block in self.up[level]:
                x = block(x, told)
        return F.pixel_shuffle(self.unfold(x), FOLD)


class Eps(nn.Module):
    """A denoiser as eps-v1 has it: (x_t, t [n], context [n,1,EMBED]) to the noise in x_t."""

    def __init__(self, network: Denoiser):
        super().__init__()
        self.network = network
        self.register_buffer("alpha_bar", alpha_bar().clone())

    def forward(self, x_t, t, context):
        left = self.alpha_bar[t.round().clamp(0, STEPS - 1).long()].view(-1, 1, 1, 1)
        return (1 - left).sqrt() * x_t + left.sqrt() * self.network(x_t, t, context[:, 0])


def noised(picture: torch.Tensor, t: torch.Tensor, noise: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """x_t and v of pictures [n,1,64,64] at times t [n], whole numbers from 0."""
    left = alpha_bar()[t].view(-1, 1, 1, 1)
    mine, other = left.sqrt(), (1 - left).sqrt()
    return mine * picture + other * noise, mine * noise - other * picture


def seeded(seed: int) -> Denoiser:
    """With random weights, always the same for one seed."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        return Denoiser()


def _waves(t: torch.Tensor) -> torch.Tensor:
    """[n] to [n,2 WAVES]: sines and cosines, from a quarter of all times to some 100 times as fine."""
    angle = t[:, None] * torch.exp(torch.linspace(math.log(2 * math.pi / STEPS), math.log(0.3), WAVES))
    return torch.cat([angle.sin(), angle.cos()], 1)

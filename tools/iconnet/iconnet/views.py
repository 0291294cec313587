"""Random views of a picture, so that what counts is what is shown and not how."""

import functools
import math

import torch
from torch.nn import functional as F

from .networks import SIZE

KNOTS = 6  # along a side: how fine lines are bent


def views(pictures: torch.Tensor, random: torch.Generator, bend: float = 1.0) -> torch.Tensor:
    """uint8 [n,S,S] of ink to float32 [n,1,64,64] of ink in 0..1, each turned, scaled, sheared, shifted, mirrored, bent, its lines
    fattened or blurred, faded, partly erased. `bend` scales how far lines are bent."""
    n = len(pictures)
    uniform = lambda low, high, *shape: low + (high - low) * torch.rand(n, *shape, generator=random)
    chance = lambda p: (torch.rand(n, 1, 1, 1, generator=random) < p).float()
    ink = F.grid_sample(pictures[:, None].float() / 255, _grid(n, random, bend), align_corners=False)
    # Every fourth is fattened and every third blurred: pools over all of them would cost more than the rest.
    fat, blurred = ink[::4], ink[1::3]
    fat.lerp_(F.max_pool2d(fat, 3, 1, 1), uniform(0, 1, 1, 1, 1)[: len(fat)])
    blurred.lerp_((F.avg_pool2d(blurred, 3, 1, 1) * 1.5).clamp_(max=1), uniform(0, 1, 1, 1, 1)[: len(blurred)])
    ink = ink * (1 - chance(0.3) * uniform(0, 0.6, 1, 1, 1))
    return ink * (1 - chance(0.3) * _patch(n, random))


def plain(pictures: torch.Tensor) -> torch.Tensor:
    """uint8 [n,S,S] to float32 [n,1,64,64] as it is."""
    return F.interpolate(pictures[:, None].float() / 255, size=(SIZE, SIZE), mode="bilinear", antialias=True)


def affine(pictures: torch.Tensor, random: torch.Generator) -> torch.Tensor:
    """As `views`, but only turned, scaled, sheared, shifted and mirrored."""
    return F.grid_sample(pictures[:, None].float() / 255, _grid(len(pictures), random, 0.0), align_corners=False)


def _grid(n: int, random: torch.Generator, bend: float) -> torch.Tensor:
    """Where each pixel of a view comes from: [n,64,64,2] in -1..1."""
    normal = lambda *shape: torch.randn(n, *shape, generator=random)
    uniform = lambda low, high: low + (high - low) * torch.rand(n, generator=random)
    turn = uniform(-12, 12) * math.pi / 180 + normal() * 0.05
    scale, aspect, shear = 1 / uniform(0.7, 1.15), torch.exp(normal() * 0.1), normal() * 0.1
    mirror = torch.where(torch.rand(n, generator=random) < 0.5, -1.0, 1.0)
    cos, sin = torch.cos(turn), torch.sin(turn)
    rows = [
        torch.stack([scale * aspect * cos * mirror, scale * (shear - sin), normal() * 0.07], 1),
        torch.stack([scale * sin * mirror, scale / aspect * cos, normal() * 0.07], 1),
    ]
    grid = F.affine_grid(torch.stack(rows, 1), [n, 1, SIZE, SIZE], align_corners=False)
    far = bend * torch.rand(n, 1, 1, 1, generator=random)
    smooth = _between() @ (normal(2, KNOTS, KNOTS) * 0.055 * far) @ _between().T
    return grid + smooth.permute(0, 2, 3, 1)


@functools.lru_cache
def _between() -> torch.Tensor:
    """[64, KNOTS]: what each of KNOTS numbers along a side weighs at each pixel, smoothly (bicubic)."""
    knots = torch.eye(KNOTS)[None, None]
    return F.interpolate(knots, size=(SIZE, KNOTS), mode="bicubic", align_corners=True)[0, 0]


def _patch(n: int, random: torch.Generator) -> torch.Tensor:
    """One on a random rectangle of up to a third of each side: [n,1,64,64]."""
    along = torch.arange(SIZE)
    sides = []
    for _ in range(2):
        start = torch.rand(n, 1, generator=random) * SIZE
        length = (0.1 + 0.23 * torch.rand(n, 1, generator=random)) * SIZE
        sides.append(((along >= start) & (along < start + length)).float())
    return (sides[0][:, :, None] * sides[1][:, None, :])[:, None]

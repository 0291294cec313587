"""A trial of score distillation: one closed curve pulled by a word through the denoiser, and ranked by the judge.

A view of the curve is noised, and the denoiser says what the noise was, told the word and told nothing. What it would take away beyond
the noise that was added is the pull on the picture: `w(t) (eps_hat - eps)`, `eps_hat = u + scale (c - u)` (Poole et al. 2022; Ho and
Salimans 2022). Formulas and weights are those of the app, so that settings found here say something there.
"""

from dataclasses import dataclass

import torch
from torch.nn import functional as F

from . import curves, denoiser
from .denoiser import STEPS
from .words import NOTHING


@dataclass(frozen=True)
class Settings:
    """Of one trial. Curves as in `guide.Settings`, and `length` weighs their length; each step sees `views` of each curve, `turned` or as
    they are, and one time for all. `scale` is that of guidance. A time lies anywhere between `least` and `most`, shares of all times that
    change in straight lines from the first step's to the last's. The pull is smeared over squares of up to 2 ^ `levels` pixels (see
    `smeared`). `sds` and `cosine` weigh the pull and the mean cosine of the guiding networks."""

    controls: int = 56
    steps: int = 150
    rate: float = 0.02
    views: int = 2
    turned: bool = True
    width: float = 1.6
    smooth: float = 0.3
    length: float = 0.03
    start: str = "ring"
    seed: int = 0
    scale: float = 50.0
    least: tuple[float, float] = (0.3, 0.1)
    most: tuple[float, float] = (0.98, 0.5)
    levels: int = 0
    sds: float = 100.0
    cosine: float = 0.0


def distil(network, rows: torch.Tensor, settings: Settings, guides=()) -> torch.Tensor:
    """Ink [n,1,64,64] of a curve for each word of `rows` [n,EMBED]. `guides` are functions of ink [m,1,64,64] and targets [m,EMBED] that
    give cosines [m]."""
    s, n = settings, len(rows)
    random = torch.Generator().manual_seed(s.seed)
    make = curves.ring_controls if s.start == "ring" else curves.random_controls
    controls = make(n, s.controls, random).requires_grad_(True)
    basis = curves.basis(s.controls, 8 * s.controls)
    optimiser = torch.optim.Adam([controls], lr=s.rate, betas=(0.9, 0.99))
    target = rows.repeat_interleave(s.views, 0)
    for step in range(s.steps):
        optimiser.param_groups[0]["lr"] = s.rate * (1 - 0.8 * step / s.steps)
        points = (basis @ controls).repeat_interleave(s.views, 0)
        if s.turned:
            points = curves.turned(points, random)
        width = s.width * (0.8 + 0.5 * torch.rand(len(points), generator=random))
        ink = curves.draw(points, width)
        loss = s.smooth * roughness(controls).sum() + s.length * length(controls).sum()
        if s.sds:
            t = time(step / s.steps, s, random)
            d_ink = -2 * smeared(pull(network, 1 - 2 * ink.detach(), target, t, s.scale, random), s.levels)
            loss = loss + s.sds * (ink * d_ink).mean((1, 2, 3)).sum() / s.views
        if s.cosine:
            loss = loss - s.cosine * torch.stack([guide(ink, target) for guide in guides]).mean(0).sum() / s.views
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        with torch.no_grad():
            controls.clamp_(-0.92, 0.92)
    with torch.no_grad():
        return curves.draw(basis @ controls, torch.full((n,), s.width))


def pull(network, seen: torch.Tensor, rows: torch.Tensor, t: int, scale: float, random: torch.Generator) -> torch.Tensor:
    """`w(t) (eps_hat - eps)` with w = 1 - alpha_bar, for pictures [n,1,64,64] (paper 1, ink -1), words [n,EMBED] and a time from 0."""
    noise = torch.randn(seen.shape, generator=random)
    left = denoiser.alpha_bar()[t]
    mine, other = left.sqrt(), (1 - left).sqrt()
    x_t = mine * seen + other * noise
    nothing = torch.from_numpy(NOTHING).expand_as(rows)
    with torch.inference_mode():
        v = network(x_t.repeat(2, 1, 1, 1), torch.full((2 * len(rows),), float(t)), torch.cat([nothing, rows]))
    none, asked = (other * x_t.repeat(2, 1, 1, 1) + mine * v).chunk(2)
    return (1 - left) * (none + scale * (asked - none) - noise)


def smeared(pull: torch.Tensor, levels: int) -> torch.Tensor:
    """A thin line feels only the pull on its own pixels. So means over squares of 2, 4, .. pixels are added: what a multi-scale
    squared error, instead of a plain one, to what the denoiser expects would have for its gradient."""
    found = pull
    for level in range(1, levels + 1):
        found = found + F.interpolate(F.avg_pool2d(pull, 2**level), scale_factor=2.0**level)
    return found


def time(share: float, settings: Settings, random: torch.Generator) -> int:
    """From 0, when `share` of the steps is done."""
    least, most = (first + (last - first) * share for first, last in (settings.least, settings.most))
    found = least + (max(most, least) - least) * float(torch.rand((), generator=random))
    return min(max(round(found * STEPS), 1), STEPS) - 1


def length(controls: torch.Tensor) -> torch.Tensor:
    """[n]: of the control polygons [n,k,2]."""
    return (controls - controls.roll(1, 1)).square().sum(-1).add(1e-8).sqrt().sum(1)


def roughness(controls: torch.Tensor) -> torch.Tensor:
    """[n]: squared third differences, about, of control points [n,k,2]; as in `guide`."""
    bow = controls - (controls.roll(1, 1) + controls.roll(-1, 1)) / 2
    return (bow - (bow.roll(1, 1) + bow.roll(-1, 1)) / 2).square().sum((1, 2))

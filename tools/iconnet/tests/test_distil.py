import dataclasses

import pytest
import torch
from torch.nn import functional as F

from iconnet import curves, denoiser, distil
from iconnet.distil import Settings
from iconnet.places import WEIGHTS
from iconnet.shipped import Shipped
from iconnet.words import EMBED, NOTHING


class Best(torch.nn.Module):
    """The best denoiser there is where words show one picture, and nothing shows paper."""

    def __init__(self, picture: torch.Tensor):
        super().__init__()
        self.picture = picture

    def forward(self, x_t, t, word):
        picture = torch.where((word == torch.from_numpy(NOTHING)).all(1)[:, None, None, None], torch.ones(1), self.picture)
        left = denoiser.alpha_bar()[t.long()].view(-1, 1, 1, 1)
        noise = (x_t - left.sqrt() * picture) / (1 - left).sqrt()
        return left.sqrt() * noise - (1 - left).sqrt() * picture


def word() -> torch.Tensor:
    return F.normalize(torch.randn(1, EMBED, generator=torch.Generator().manual_seed(0)))


def test_the_pull_is_towards_what_the_word_shows():
    picture, seen = torch.rand(1, 1, 64, 64) * 2 - 1, torch.rand(1, 1, 64, 64) * 2 - 1
    t, random = 400, torch.Generator().manual_seed(0)
    left = denoiser.alpha_bar()[t]
    for scale in (0.0, 1.0, 5.0):
        # By hand: noise cancels out, and what is left is the difference of pictures.
        wanted = (1 - left) * (left / (1 - left)).sqrt() * (seen - (1 + scale * (picture - 1)))
        assert torch.allclose(distil.pull(Best(picture), seen, word(), t, scale, random), wanted, atol=1e-3)


def test_times_stay_between_their_bounds_and_fall():
    settings, random = Settings(least=(0.3, 0.1), most=(0.9, 0.4)), torch.Generator().manual_seed(0)
    for share, least, most in ((0.0, 300, 900), (0.5, 200, 650), (1.0, 100, 400)):
        found = [distil.time(share, settings, random) for _ in range(500)]
        assert least - 2 <= min(found) < least + 20 and most - 20 < max(found) <= most
    assert distil.time(0.0, Settings(least=(1.0, 1.0), most=(1.0, 1.0)), random) == denoiser.STEPS - 1


def test_a_curve_follows_a_denoiser_that_knows_one_picture():
    """A ring above the middle, which the curve does not start as."""
    there = curves.ring_controls(1, 40, torch.Generator().manual_seed(1), noise=0) * 0.5 + torch.tensor([0.3, -0.3])
    ink = curves.draw(curves.basis(40, 320) @ there, torch.tensor([1.6]))
    settings = Settings(controls=40, steps=80, views=1, turned=False, scale=1.0)
    found = distil.distil(Best(1 - 2 * ink), word(), settings)
    before = distil.distil(Best(1 - 2 * ink), word(), dataclasses.replace(settings, steps=0))
    off = lambda one: (F.avg_pool2d(one, 4) - F.avg_pool2d(ink, 4)).square().mean().sqrt()
    assert found.shape == (1, 1, 64, 64) and off(found) < 0.5 * off(before)


def test_smearing_is_the_gradient_of_a_multi_scale_error():
    off = torch.randn(1, 1, 64, 64, generator=torch.Generator().manual_seed(0)).requires_grad_(True)
    error = sum(4**level * F.avg_pool2d(off, 2**level).square().sum() / 2 for level in range(3))
    (slope,) = torch.autograd.grad(error, off)
    assert torch.allclose(distil.smeared(off.detach(), 2), slope, atol=1e-5)


def test_a_shipped_networks_cosine_has_the_gradient_of_finite_differences():
    network = Shipped(WEIGHTS, "a")
    ink = torch.rand(2, 1, 64, 64, generator=torch.Generator().manual_seed(0)).requires_grad_(True)
    target = F.normalize(torch.randn(2, EMBED, generator=torch.Generator().manual_seed(1)))
    cosine = network.cosines(ink, target)
    assert torch.allclose(cosine, (network(ink.detach()) * target).sum(1), atol=1e-3)
    (slope,) = torch.autograd.grad(cosine.sum(), ink)
    step = 0.02 * slope / slope.norm()
    with torch.no_grad():
        found = (network.cosines(ink + step, target) - network.cosines(ink - step, target)).sum() / 2
    assert float(found) == pytest.approx(float((slope * step).sum()), rel=2e-2)


def test_cosines_pull_too():
    network = Shipped(WEIGHTS, "a")
    settings = Settings(steps=15, views=2, controls=24, sds=0.0, cosine=1.0)
    reached = [
        float(network.cosines(distil.distil(None, word(), s, [network.cosines]), word()))
        for s in (settings, dataclasses.replace(settings, steps=0))
    ]
    assert reached[0] > reached[1] + 0.02

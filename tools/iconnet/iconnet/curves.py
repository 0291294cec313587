"""Closed curves: uniform cubic B-splines, drawn so softly that their ink has a gradient by their control points."""

import functools
import math

import torch

from .networks import SIZE

GAIN = 2.5  # ink along a line's middle is 1 - exp(-GAIN)


@functools.lru_cache
def basis(controls: int, points: int) -> torch.Tensor:
    """[points, controls]: a closed curve's points are `basis @ control points`."""
    at = torch.arange(points) * controls / points
    first, t = at.floor().long(), at - at.floor()
    weights = [(1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3]
    matrix = torch.zeros(points, controls)
    for j, weight in enumerate(weights):
        matrix[torch.arange(points), (first + j) % controls] += weight / 6
    return matrix


def draw(points: torch.Tensor, width: torch.Tensor) -> torch.Tensor:
    """Ink [n,1,64,64] in 0..1 of closed polylines `points` [n,m,2] (x, y in -1..1, densely spaced), `width` [n] in pixels.

    Each point lays a small Gaussian, as heavy as its share of the line is long. Cheap: it costs points times the Gaussian's pixels,
    and not pixels times points.
    """
    n, m, _ = points.shape
    place = (points + 1) * (SIZE / 2) - 0.5
    length = (place.roll(-1, 1) - place.roll(1, 1)).square().sum(-1).add(1e-12).sqrt() / 2
    sigma = (width / 2.5).view(n, 1, 1, 1)
    reach = int(math.ceil(2.5 * float(width.max()) / 2.5))
    offset = torch.arange(-reach, reach + 1)
    nearest = place.detach().round()
    pixel = nearest[..., None] + offset  # [n,m,2,k]
    bell = torch.exp(-(pixel - place[..., None]).square() / (2 * sigma**2))
    heavy = (length * GAIN)[..., None, None] / (sigma * math.sqrt(2 * math.pi))
    ink = heavy * bell[:, :, 1, :, None] * bell[:, :, 0, None, :]  # [n,m,k,k], rows by columns
    index = pixel.long().clamp(-1, SIZE) + 1  # a rim of one pixel takes what lies outside
    flat = index[:, :, 1, :, None] * (SIZE + 2) + index[:, :, 0, None, :]
    paper = ink.new_zeros(n, (SIZE + 2) ** 2).scatter_add(1, flat.flatten(1), ink.flatten(1))
    paper = paper.view(n, SIZE + 2, SIZE + 2)[:, 1:-1, 1:-1]
    return (1 - torch.exp(-paper))[:, None]


def random_controls(n: int, controls: int, random: torch.Generator) -> torch.Tensor:
    """Control points [n,controls,2] of curves that show nothing: wobbly rings, tangles, scribbles and wandering lines."""
    angle = torch.arange(controls) * 2 * math.pi / controls
    order = torch.arange(1, controls // 2)
    # Fourier series with random slopes: steep ones are blobs and rings, flat ones are tangles.
    slope = 0.5 + 2 * torch.rand(n, 1, 1, generator=random)
    sizes = torch.randn(n, 2, len(order), generator=random) / order**slope
    phases = torch.rand(n, 2, len(order), generator=random) * 2 * math.pi
    curve = (sizes[..., None] * torch.cos(order[:, None] * angle + phases[..., None])).sum(2).transpose(1, 2)
    curve = curve - curve.mean(1, keepdim=True)
    size = 0.45 + 0.45 * torch.rand(n, 1, 1, generator=random)
    return curve / curve.abs().amax((1, 2), keepdim=True) * size


def ring_controls(n: int, controls: int, random: torch.Generator, noise: float = 0.03) -> torch.Tensor:
    """Control points [n,controls,2] of a ring in the middle, a little disturbed: where a guided wire starts."""
    angle = torch.arange(controls) * 2 * math.pi / controls
    ring = 0.55 * torch.stack([torch.cos(angle), torch.sin(angle)], 1)
    return ring + noise * torch.randn(n, controls, 2, generator=random)


def turned(points: torch.Tensor, random: torch.Generator) -> torch.Tensor:
    """Each curve of [n,m,2] seen through a random affine view."""
    n = len(points)
    normal = lambda *shape: torch.randn(n, *shape, generator=random)
    turn, shear, aspect = normal() * 0.12, normal() * 0.08, torch.exp(normal() * 0.08)
    scale = 0.75 + 0.35 * torch.rand(n, generator=random)
    mirror = torch.where(torch.rand(n, generator=random) < 0.5, -1.0, 1.0)
    cos, sin = torch.cos(turn), torch.sin(turn)
    matrix = torch.stack(
        [
            torch.stack([scale * aspect * cos * mirror, scale * (shear - sin)], 1),
            torch.stack([scale * sin * mirror, scale / aspect * cos], 1),
        ],
        1,
    )
    return points @ matrix.transpose(1, 2) + normal(1, 2) * 0.05

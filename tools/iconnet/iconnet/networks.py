"""The networks: a few convolutions from 64 x 64 pixels of ink to EMBED numbers.

Smooth throughout (SiLU, strides, averages), since whoever follows the gradient meets each kink. Three forms, so that what
fools one need not fool the others.
"""

from dataclasses import dataclass

import torch
from torch import nn
from torch.nn import functional as F

from .words import EMBED

SIZE = 64


@dataclass(frozen=True)
class Form:
    """`kernel` and `stride` are the first layer's; `widths` its channels and those of the layers behind it, each of which halves the
    picture, down to 4 x 4; one residual layer follows. `pool` says what the last layer sees: `places`, each of the 16 places by
    itself, or `parts`, the average of all and of each quarter."""

    kernel: int
    stride: int
    widths: tuple[int, ...]
    pool: str


FORMS = {
    "a": Form(4, 2, (16, 48, 96, 192), "places"),
    "b": Form(8, 4, (48, 104, 208), "parts"),
    "judge": Form(5, 2, (16, 56, 112, 168), "places"),
}


class Layer(nn.Sequential):
    def __init__(self, before: int, after: int, kernel: int = 3, stride: int = 1):
        convolution = nn.Conv2d(before, after, kernel, stride, (kernel - stride + 1) // 2, bias=False)
        super().__init__(convolution, nn.BatchNorm2d(after), nn.SiLU())


class Residual(nn.Module):
    def __init__(self, width: int):
        super().__init__()
        self.layer = Layer(width, width)

    def forward(self, x):
        return x + self.layer(x)


class Network(nn.Module):
    """Ink [n,1,64,64] in 0..1 to embeddings [n,EMBED] of any length."""

    def __init__(self, form: Form):
        super().__init__()
        first, *others = form.widths
        layers, before = [Layer(1, first, form.kernel, form.stride)], first
        for width in others:
            layers.append(Layer(before, width, stride=2))
            before = width
        self.trunk = nn.Sequential(*layers, Residual(before))
        self.pool = form.pool
        self.head = nn.Linear(before * (16 if form.pool == "places" else 5), EMBED)

    def forward(self, ink):
        x = self.trunk(ink)
        if self.pool == "parts":
            quarters = F.avg_pool2d(x, 2)
            return self.head(torch.cat([x.mean((2, 3)), quarters.flatten(1)], 1))
        return self.head(x.flatten(1))


class OfPictures(nn.Module):
    """A network that takes what guidance-v1 does: [n,3,64,64] sRGB in 0..1, dark ink on white paper."""

    def __init__(self, network: nn.Module):
        super().__init__()
        self.network = network

    def forward(self, image):
        return self.network(1 - image.mean(1, keepdim=True))


def seeded(name: str, seed: int) -> Network:
    """The network of FORMS with random weights, always the same for one seed."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        return Network(FORMS[name])

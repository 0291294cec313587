"""The networks: a few convolutions from 64 x 64 pixels of ink to EMBED numbers.

Smooth throughout (SiLU, strides), since whoever follows the gradient meets each kink. Three forms, so that what
fools one need not fool the others.
"""

from dataclasses import dataclass

import torch
from torch import nn

from .words import EMBED

SIZE = 64


@dataclass(frozen=True)
class Form:
    """`kernel` is the first layer's, and `widths` are channels at 32, 16, 8 and 4 pixels a side; one residual layer follows, and the
    last layer sees each of the 16 places by itself."""

    kernel: int
    widths: tuple[int, int, int, int]


FORMS = {
    "a": Form(4, (16, 48, 96, 192)),
    "b": Form(6, (20, 56, 112, 160)),
    "judge": Form(5, (16, 56, 112, 168)),
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
        layers, before = [Layer(1, first, form.kernel, 2)], first
        for width in others:
            layers.append(Layer(before, width, stride=2))
            before = width
        self.trunk = nn.Sequential(*layers, Residual(before))
        self.head = nn.Linear(before * 16, EMBED)

    def forward(self, ink):
        return self.head(self.trunk(ink).flatten(1))


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

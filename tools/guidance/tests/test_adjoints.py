"""Single layers pulled back, against autograd."""

import pytest
import torch
from torch import nn
from torch.nn import functional as F

from guidance import contracts, graph, losses, noise
from guidance.errors import ModelError
from guidance.runtime import Session
from tests.conftest import off


class Layer(nn.Module):
    def __init__(self, call, module=None):
        super().__init__()
        self.call, self.module = call, module

    def forward(self, x):
        return self.call(x) if self.module is None else self.call(self.module(x))


def resize(**how):
    return Layer(lambda x: F.interpolate(x, **how))


def conv(*args, **how):
    return Layer(lambda x: x, nn.Conv2d(*args, **how))


LAYERS = {
    "strided": conv(3, 4, 3, 2, 1),
    "strided, last row unreached": conv(3, 4, 3, 2),
    "dilated": conv(3, 4, 3, 1, 2, dilation=2),
    "depthwise": conv(3, 3, 5, 2, 2, groups=3),
    "depthwise, several a channel": conv(3, 12, 2, 2, groups=3),
    "transposed": Layer(lambda x: x, nn.ConvTranspose2d(3, 4, 4, 2, 1)),
    "average pool": Layer(lambda x: F.avg_pool2d(x, 3, 2)),
    "max pool": Layer(lambda x: F.max_pool2d(x, 3, 2, 1)),
    "nearest": resize(scale_factor=2.0),
    "bilinear": resize(size=(17, 9), mode="bilinear", align_corners=False),
    "antialiased": resize(size=(7, 5), mode="bilinear", align_corners=False, antialias=True),
    "bicubic by scale": resize(scale_factor=(1.5, 0.5), mode="bicubic", align_corners=False),
    "hardswish": Layer(F.hardswish),
    "log-softmax": Layer(lambda x: F.log_softmax(x, 1)),
}


@pytest.mark.parametrize("layer", LAYERS)
def test_equals_autograd(layer):
    torch.manual_seed(3)
    network = LAYERS[layer]
    image = torch.from_numpy(noise.signed(1, (1, 3, 12, 10)))
    latent = network(image)
    function, contract = losses.vjp(network), contracts.vjp((12, 10), tuple(latent.shape[1:]))
    cotangent = torch.from_numpy(noise.signed(2, tuple(latent.shape)))
    session = Session(graph.build(function, contract).SerializeToString())
    answers = session.run({"image": image.numpy(), "cotangent": cotangent.numpy()})
    wanted = function(image, cotangent)
    assert off(answers["latent"], wanted[0]) < 1e-5
    assert off(answers["grad"], wanted[1]) < 1e-5


def test_what_has_no_rule_is_named():
    network = Layer(lambda x: F.max_pool2d(x, 3, 2, ceil_mode=True))
    with pytest.raises(ModelError, match="ceil_mode"):
        graph.build(losses.vjp(network), contracts.vjp((12, 10), (3, 6, 5)))


def test_weights_that_ask_for_gradients_are_refused():
    weight = torch.randn(4, 3, 3, 3, requires_grad=True)

    def run(image, cotangent):
        pixels = image.detach().requires_grad_(True)
        latent = F.conv2d(pixels, weight)
        grad, _ = torch.autograd.grad(latent, (pixels, weight), cotangent)
        return latent.detach(), grad

    with pytest.raises(ModelError, match="Freeze"):
        graph.build(run, contracts.vjp((12, 10), (4, 10, 8)))

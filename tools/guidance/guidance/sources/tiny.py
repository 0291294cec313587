"""The tiny networks of `networks`, seeded: to try the commands, and for tests."""

import numpy as np
import torch

from .. import export, networks, noise, tokens
from ..schedule import STABLE_DIFFUSION, Schedule

MEAN, STD = (0.48145466, 0.4578275, 0.40821073), (0.26862954, 0.26130258, 0.27577711)
CONTEXT = 16


def image(model: str, _checkpoint=None) -> export.ImageEncoder:
    """`vit` (default) or `conv`."""
    network = _seeded(networks.TinyConv if model == "conv" else networks.TinyVit)
    return export.ImageEncoder(network, network.size, network.embed, MEAN, STD)


def text(_model: str, _checkpoint=None) -> export.TextEncoder:
    """With a tokenizer of a few merges."""
    merges = [("w", "i"), ("wi", "r"), ("wir", "e</w>")]
    vocabulary = 512 + len(merges) + 2
    network = _seeded(lambda: networks.TinyText(vocabulary=vocabulary, context=CONTEXT))
    return export.TextEncoder(network, CONTEXT, network.embed, tokens.file_of(merges, CONTEXT))


def latent(model: str, _checkpoint=None) -> export.LatentEncoder:
    """32 x 48 pixels, rows by columns; `square` has 32 x 32, for the denoiser's latents."""
    columns = 32 if model == "square" else 48
    return export.LatentEncoder(_seeded(networks.TinyVae), (32, columns), (4, 8, columns // 4))


def denoiser(model: str, _checkpoint=None) -> export.Denoiser:
    """Of latents; `pixels` is one of grey pixels, with a row of the word table's length for context."""
    if model == "pixels":
        network = _seeded(lambda: networks.TinyUnet(context=96, channels=1))
        return export.Denoiser(network, (1, 16, 16), (1, 96), Schedule("cosine"), np.eye(96)[-1:])
    return export.Denoiser(_seeded(networks.TinyUnet), (4, 8, 8), (5, 16), STABLE_DIFFUSION, noise.signed(9, (5, 16)))


def _seeded(make) -> torch.nn.Module:
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(0)
        return make().eval()

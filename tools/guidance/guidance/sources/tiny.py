"""The tiny networks of `networks`, seeded: to try the commands, and for tests."""

import torch

from .. import export, networks, tokens

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


def latent(_model: str, _checkpoint=None) -> export.LatentEncoder:
    """32 x 48 pixels, rows by columns."""
    return export.LatentEncoder(_seeded(networks.TinyVae), (32, 48), (4, 8, 12))


def denoiser(_model: str, _checkpoint=None) -> export.Denoiser:
    return export.Denoiser(_seeded(networks.TinyUnet), (4, 8, 8), (5, 16))


def _seeded(make) -> torch.nn.Module:
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(0)
        return make().eval()

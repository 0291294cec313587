"""CLIP models in the form of transformers: a folder, or a name that transformers downloads. There is no `checkpoint`."""

import json
from pathlib import Path

import torch

from .. import export, tokens
from . import loaded, need
from .tiny import MEAN, STD


def image(model: str, _checkpoint=None) -> export.ImageEncoder:
    library = need("transformers")
    network = loaded(model, lambda: library.CLIPVisionModelWithProjection.from_pretrained(model))
    facts = loaded(f"the preprocessing of {model}", lambda: library.CLIPImageProcessor.get_image_processor_dict(model)[0])
    return image_of(network, facts.get("image_mean", MEAN), facts.get("image_std", STD))


def text(model: str, _checkpoint=None) -> export.TextEncoder:
    library = need("transformers")
    network = loaded(model, lambda: library.CLIPTextModelWithProjection.from_pretrained(model))
    tokenizer = loaded(f"the tokenizer of {model}", lambda: library.CLIPTokenizer.from_pretrained(model))
    return text_of(network, merges_of(tokenizer), int(tokenizer.pad_token_id))


def context(model: str, _checkpoint=None) -> export.ContextEncoder:
    """The states of a CLIPTextModel, as Stable Diffusion's UNet wants them. Its tokenizer lies in the same folder, or, as diffusers saves a
    model, in the folder `tokenizer` beside it."""
    library = need("transformers")
    network = loaded(model, lambda: library.CLIPTextModel.from_pretrained(model))
    beside = Path(model).parent / "tokenizer"
    where = str(beside) if beside.is_dir() else model
    tokenizer = loaded(f"the tokenizer of {model}", lambda: library.CLIPTokenizer.from_pretrained(where))
    return context_of(network, merges_of(tokenizer), int(tokenizer.pad_token_id))


def image_of(network: torch.nn.Module, mean=MEAN, std=STD) -> export.ImageEncoder:
    """A CLIPVisionModelWithProjection that is there already."""
    config = network.config
    return export.ImageEncoder(_Image(network), config.image_size, config.projection_dim, tuple(mean), tuple(std))


def text_of(network: torch.nn.Module, merges: list[tuple[str, str]], pad: int) -> export.TextEncoder:
    """A CLIPTextModelWithProjection that is there already."""
    context = network.config.max_position_embeddings
    return export.TextEncoder(_Text(network), context, network.config.projection_dim, tokens.file_of(merges, context, pad))


def context_of(network: torch.nn.Module, merges: list[tuple[str, str]], pad: int) -> export.ContextEncoder:
    """A CLIPTextModel that is there already."""
    length = network.config.max_position_embeddings
    shape = (length, network.config.hidden_size)
    return export.ContextEncoder(_States(network), length, shape, tokens.file_of(merges, length, pad))


def merges_of(tokenizer) -> list[tuple[str, str]]:
    """Of a CLIPTokenizer, in order."""
    found = json.loads(tokenizer.backend_tokenizer.to_str())["model"]["merges"]
    return [tuple(merge.split(" ")) if isinstance(merge, str) else tuple(merge) for merge in found]


class _Image(torch.nn.Module):
    def __init__(self, network):
        super().__init__()
        self.network = network

    def forward(self, image):
        return self.network(pixel_values=image).image_embeds


class _Text(torch.nn.Module):
    def __init__(self, network):
        super().__init__()
        self.network = network

    def forward(self, ids):
        return self.network(input_ids=ids).text_embeds


class _States(torch.nn.Module):
    def __init__(self, network):
        super().__init__()
        self.network = network

    def forward(self, ids):
        return self.network(input_ids=ids).last_hidden_state

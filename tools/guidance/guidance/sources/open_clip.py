"""open_clip's models (OpenAI's, LAION's, and anything trained with it, such as CLIP-AG).

`checkpoint` is a file, or the tag of weights that open_clip downloads.
"""

import difflib

import torch

from .. import export, tokens
from ..errors import SourceError
from . import loaded, need


def image(model: str, checkpoint: str | None) -> export.ImageEncoder:
    return image_of(_model(model, checkpoint))


def text(model: str, checkpoint: str | None) -> export.TextEncoder:
    return text_of(_model(model, checkpoint), _merges())


def image_of(clip: torch.nn.Module) -> export.ImageEncoder:
    """The image tower of a model that is there already."""
    visual = clip.visual
    size = visual.image_size
    rows, columns = (size, size) if isinstance(size, int) else size
    if rows != columns:
        raise SourceError(f"The model wants {rows} x {columns} pixels, and guidance gives squares.")
    mean = getattr(visual, "image_mean", None) or need("open_clip").OPENAI_DATASET_MEAN
    std = getattr(visual, "image_std", None) or need("open_clip").OPENAI_DATASET_STD
    with torch.no_grad():
        embed = int(visual.eval()(torch.zeros(1, 3, rows, rows)).shape[-1])
    return export.ImageEncoder(visual, rows, embed, tuple(mean), tuple(std))


def text_of(clip: torch.nn.Module, merges: list[tuple[str, str]]) -> export.TextEncoder:
    """The text tower, and CLIP's tokenizer with these merges."""
    context = int(clip.context_length)
    tower = _Text(clip)
    with torch.no_grad():
        embed = int(tower.eval()(torch.zeros(1, context, dtype=torch.int64)).shape[-1])
    return export.TextEncoder(tower, context, embed, tokens.file_of(merges, context))


class _Text(torch.nn.Module):
    def __init__(self, clip):
        super().__init__()
        self.clip = clip

    def forward(self, ids):
        return self.clip.encode_text(ids)


def _model(model: str, checkpoint: str | None) -> torch.nn.Module:
    library = need("open_clip")
    if model not in library.list_models():
        near = difflib.get_close_matches(model, library.list_models(), 4)
        raise SourceError(f"open_clip has no model {model!r}." + (f" It has {', '.join(near)}." if near else ""))
    if checkpoint is None:
        raise SourceError(f"Say which weights of {model}: --checkpoint FILE, or a tag that open_clip knows.")
    return loaded(f"{model} with {checkpoint!r}", lambda: library.create_model(model, pretrained=checkpoint))


def _merges() -> list[tuple[str, str]]:
    """In order, from the vocabulary that the package brings."""
    ranks = need("open_clip").tokenizer.SimpleTokenizer().bpe_ranks
    return sorted(ranks, key=ranks.get)

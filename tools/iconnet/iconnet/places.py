"""Where things lie. Nothing under `root` is committed; everything under `WEIGHTS` is."""

from pathlib import Path

from .errors import MissingStep

WEIGHTS = Path(__file__).resolve().parent.parent / "weights"


class Places:
    """One folder for packages, pictures, embeddings and checkpoints."""

    def __init__(self, root: Path):
        self.root = root
        self.packages = root / "packages"
        self.icons = root / "icons.json"  # what each picture shows, in the pictures' order
        self.pictures = root / "pictures.npy"  # uint8 [n, SIDE, SIDE], ink
        self.wires = root / "wires.npy"  # uint8 [n, WIRES, SIDE, SIDE], ink
        self.texts = root / "texts.npz"
        self.runs = root / "runs"

    def checkpoint(self, name: str) -> Path:
        return self.runs / f"{name}.pt"


def need(file: Path, command: str) -> Path:
    """`file`, or MissingStep with the command that makes it."""
    if not file.exists():
        raise MissingStep(f"{file.name} is missing. Run first: python -m iconnet {command}")
    return file

"""A yardstick of likeness put to the test: of two icons, which is the same thing as a third, drawn by another hand?

Icons of one name in two sets are pairs. Chance is .5; `first` is how often an icon's nearest of the whole other set is its own.
"""

from dataclasses import dataclass

import numpy as np
from PIL import Image

from . import split
from .data import Icons
from .words import unit

SETS = (("lucide", "tabler"), ("openmoji", "fluent-emoji-high-contrast"))


@dataclass(frozen=True)
class Choice:
    """Shares of right choices: between two, and of all."""

    pairs: int
    of_two: float
    first: float


def pairs(icons: Icons, left: str, right: str) -> tuple[np.ndarray, np.ndarray]:
    """Rows of the icons that both sets have under one name, in one order."""
    plain = lambda source, variant: source == "openmoji" or split.classic(source, variant)
    by_name = []
    for source in (left, right):
        rows = icons.rows(lambda s, variant, _name: s == source and plain(s, variant))
        by_name.append({icons.names[row]: row for row in rows})
    names = sorted(by_name[0].keys() & by_name[1].keys())
    return tuple(np.array([rows[name] for name in names]) for rows in by_name)


def choose(left: np.ndarray, right: np.ndarray) -> Choice:
    """Of embeddings [n,E] of pairs, by their cosines."""
    likeness = unit(left) @ unit(right).T
    own, count = np.diag(likeness)[:, None], len(likeness)
    return Choice(count, float((own > likeness).sum() / (count * (count - 1))), float((likeness.argmax(1) == np.arange(count)).mean()))


def seen(run, size: int, embed: int, pictures: np.ndarray, batch: int = 16) -> np.ndarray:
    """Embeddings of uint8 ink [n,S,S] by a guidance-v1 file that `run` computes; dark lines on white paper."""
    rows = []
    for i in range(0, len(pictures), batch):
        paper = [np.asarray(Image.fromarray(255 - ink).resize((size, size), Image.BILINEAR)) for ink in pictures[i : i + batch]]
        image = np.repeat(np.stack(paper)[:, None].astype(np.float32) / 255, 3, 1)
        none, one = np.zeros((len(image), embed), np.float32), np.eye(1, embed, dtype=np.float32).repeat(len(image), 0)
        rows.append(run({"image": image, "source": none, "target": one, "weight": np.zeros(len(image), np.float32)})["embedding"])
    return np.concatenate(rows)

"""How often a picture's own name is among the first that a network names.

Candidates are all names of a test set; each is centred over the candidates, and its score over the pictures, so that no word
is everybody's favourite (as in the first trial, whose figures these continue).
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch.nn import functional as F

from . import split, views
from .data import Icons
from .words import unit

TESTS = ("held-out", "openmoji")


@dataclass(frozen=True)
class Recall:
    """Shares of pictures whose own name is among the first 1, 5 and 10; the middle rank, from 1; and how many candidates."""

    first: float
    five: float
    ten: float
    middle: int
    candidates: int

    def __str__(self) -> str:
        return (
            f"R@1 {self.first:.3f}  R@5 {self.five:.3f}  R@10 {self.ten:.3f}  median {self.middle} of {self.candidates}"
        )


def rows(icons: Icons, test: str) -> np.ndarray:
    """The icons of a test of TESTS."""
    if test == "openmoji":
        return icons.rows(lambda source, _variant, _name: source == "openmoji")
    return icons.rows(lambda source, variant, name: split.held_out(name) and split.classic(source, variant))


def strange(icons: Icons, which: np.ndarray) -> np.ndarray:
    """True for those of `which` whose names share no word of three letters or more with any name that is trained on: a
    stricter test, since `heart broken` says much about `heart`."""
    part = lambda name: {word.rstrip("s") for word in name.split() if len(word) > 2}
    known = set()
    for source, name in zip(icons.sources, icons.names):
        if source != "openmoji" and not split.held_out(name):
            known |= part(name)
    return np.array([not (part(icons.names[i]) & known) for i in which])


def embeddings(network, pictures: np.ndarray, batch: int = 256) -> np.ndarray:
    """Unit rows [n,EMBED] of uint8 pictures [n,S,S]."""
    network.eval()
    with torch.inference_mode():
        parts = [
            F.normalize(network(views.plain(torch.from_numpy(np.ascontiguousarray(pictures[i : i + batch])))), dim=1)
            for i in range(0, len(pictures), batch)
        ]
    return torch.cat(parts).numpy()


def ranks(rows: np.ndarray, names: list[str], words: dict[str, np.ndarray]) -> np.ndarray:
    """For each picture's embedding in `rows` [n,EMBED] the rank of its own name, from 1."""
    candidates = sorted(set(names))
    text = np.stack([words[name] for name in candidates])
    score = rows @ unit(text - text.mean(0)).T
    score = score - score.mean(0)
    own = score[np.arange(len(names)), [candidates.index(name) for name in names]]
    return (score > own[:, None]).sum(1) + 1


def recall(rank: np.ndarray, candidates: int) -> Recall:
    share = lambda most: float((rank <= most).mean())
    return Recall(share(1), share(5), share(10), int(np.median(rank)), candidates)

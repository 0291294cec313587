"""The space that words and pictures share: EMBED numbers of unit length, fixed before any picture is seen.

MiniLM's 384 numbers say much that no picture can show. Names and tags of one icon are two sayings of one thing, so the
directions in which both agree over all icons (canonical correlation) are those worth having. The last number is zero for
every word: it is left for pictures that show nothing.
"""

from collections.abc import Iterable

import numpy as np

from . import split

EMBED = 96
NOTHING = np.eye(EMBED, dtype=np.float32)[-1]  # where a picture of nothing should be
RIDGE = 0.1  # of the covariance's mean, so that rare directions are not blown up
FEWEST_TAGS = 3


def unit(rows: np.ndarray) -> np.ndarray:
    return rows / np.maximum(np.linalg.norm(rows, axis=-1, keepdims=True), 1e-9)


def pairs(icons: Iterable[tuple[str, str, list[str]]]) -> dict[str, set[str]]:
    """For each name that may be trained on, its tags that may be: `icons` are (source, name, tags)."""
    found: dict[str, set[str]] = {}
    for source, name, tags in icons:
        if source != "openmoji" and not split.held_out(name):
            found.setdefault(name, set()).update(tag for tag in tags if not split.held_out(tag))
    return found


class Space:
    """From MiniLM's rows [n, 384] to the shared space: `unit((rows - centre) @ matrix)`, and a zero behind."""

    def __init__(self, centre: np.ndarray, matrix: np.ndarray):
        self.centre, self.matrix = centre, matrix

    @classmethod
    def fit(cls, rows: dict[str, np.ndarray], tagged: dict[str, set[str]]) -> "Space":
        """`rows` are MiniLM's by word; `tagged` as `pairs` gives it."""
        names = sorted(tagged)
        centre = np.mean([rows[name] for name in names], axis=0)
        row = lambda word: unit(rows[word] - centre)
        told = [name for name in names if len(tagged[name]) >= FEWEST_TAGS]
        name = np.stack([row(n) for n in told]).astype(np.float64)
        tags = unit(np.stack([np.mean([row(t) for t in sorted(tagged[n])], axis=0) for n in told])).astype(np.float64)
        both = (name.T @ name + tags.T @ tags) / (2 * len(told))
        across = name.T @ tags / len(told)
        value, vector = np.linalg.eigh(both + RIDGE * np.trace(both) / len(both) * np.eye(len(both)))
        whiten = (vector * value**-0.5) @ vector.T
        value, vector = np.linalg.eigh(whiten @ (across + across.T) @ whiten / 2)
        best = np.argsort(-value)[: EMBED - 1]
        matrix = whiten @ vector[:, best] * np.sqrt(np.maximum(value[best], 0))
        return cls(centre.astype(np.float32), matrix.astype(np.float32))

    def __call__(self, rows: np.ndarray) -> np.ndarray:
        """Unit rows [n, EMBED], float32."""
        found = unit(unit(rows - self.centre) @ self.matrix)
        return np.pad(found, ((0, 0), (0, 1))).astype(np.float32)

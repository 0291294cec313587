"""The prepared arrays, and who may learn what from them."""

import json
from dataclasses import dataclass

import numpy as np
import torch

from . import minilm, split
from .places import Places, need
from .words import NOTHING, Space, pairs

RARE = 3  # a tag that fewer icons bear is no word of the vocabulary
NAME, TAGS, NEAR = 0.5, 0.25, 0.25  # how a picture's answer is shared out
SHARPNESS = 20.0  # of likeness between words


@dataclass(frozen=True)
class Icons:
    """All icons, row by row: `pictures` uint8 [n,S,S] and `wires` uint8 [n,WIRES,S,S] are ink, mapped from files."""

    sources: list[str]
    variants: list[str]
    names: list[str]
    tags: list[list[str]]
    pictures: np.ndarray
    wires: np.ndarray

    def rows(self, wanted) -> np.ndarray:
        """Numbers of the icons for which `wanted(source, variant, name)`."""
        each = zip(self.sources, self.variants, self.names)
        return np.array([i for i, icon in enumerate(each) if wanted(*icon)])


def icons(places: Places) -> Icons:
    """Raises MissingStep before `prepare` has run."""
    rows = json.loads(need(places.icons, "prepare").read_text(encoding="utf-8"))
    sources, variants, names, tags = map(list, zip(*rows))
    pictures, wires = (np.load(need(file, "prepare"), mmap_mode="r") for file in (places.pictures, places.wires))
    return Icons(sources, variants, names, tags, pictures, wires)


def embed(places: Places) -> None:
    """Writes `texts`: every name and tag with its row in the shared space."""
    given = icons(places)
    words = sorted({*given.names, *(tag for tags in given.tags for tag in tags)})
    rows = minilm.encode(words)
    space = Space.fit(dict(zip(words, rows)), pairs(zip(given.sources, given.names, given.tags)))
    np.savez(places.texts, words=np.array(words), rows=space(rows))


def texts(places: Places) -> dict[str, np.ndarray]:
    """Rows of the shared space by word. Raises MissingStep before `prepare` has run."""
    with np.load(need(places.texts, "prepare")) as file:
        return dict(zip(file["words"].tolist(), file["rows"]))


@dataclass(frozen=True)
class Lesson:
    """What one reader trains on: icons `rows` with `odds`, for each its `name`'s number in the `vocabulary` [k,EMBED], whose last
    row is nothing, and the `answer` [n,EMBED]: a mean of vocabulary rows, which is all that a softmax's loss needs."""

    rows: np.ndarray
    odds: np.ndarray
    name: torch.Tensor
    answer: torch.Tensor
    vocabulary: torch.Tensor


def lesson(given: Icons, words: dict[str, np.ndarray], reader: str) -> Lesson:
    """For `guide` or `judge`: never a held-out name, neither as a picture nor as a word; never OpenMoji."""
    seen = lambda source, _variant, name: (
        source != "openmoji" and not split.held_out(name) and split.reader(source, name) == reader
    )
    rows = given.rows(seen)
    names = [given.names[i] for i in rows]
    tags = [[tag for tag in given.tags[i] if not split.held_out(tag)] for i in rows]
    times: dict[str, int] = {}
    for tag in (tag for some in tags for tag in some):
        times[tag] = times.get(tag, 0) + 1
    known = sorted({*names, *(tag for tag, count in times.items() if count >= RARE)})
    vocabulary = np.stack([words[word] for word in known])
    at = {word: i for i, word in enumerate(known)}

    unique = sorted(set(names))
    own = np.stack([words[name] for name in unique])
    near = np.concatenate([_mean_of_near(part, vocabulary) for part in np.array_split(own, len(own) // 1000 + 1)])
    some_tags = dict(zip(names, tags))
    told = [[words[tag] for tag in some_tags[name] if times[tag] >= RARE] or [words[name]] for name in unique]
    mean = np.stack([np.mean(rows, 0) for rows in told])
    answers = dict(zip(unique, NAME * own + TAGS * mean + NEAR * near))
    count: dict[str, int] = {}
    for name in names:
        count[name] = count.get(name, 0) + 1
    odds = np.array([count[name] ** -0.5 for name in names])
    return Lesson(
        rows,
        odds / odds.sum(),
        torch.tensor([at[name] for name in names]),
        torch.from_numpy(np.stack([answers[name] for name in names]).astype(np.float32)),
        torch.from_numpy(np.vstack([vocabulary, NOTHING]).astype(np.float32)),
    )


def _mean_of_near(rows: np.ndarray, vocabulary: np.ndarray) -> np.ndarray:
    """For each unit row the mean of the vocabulary, words weighed by how like the row they are."""
    weight = np.exp(SHARPNESS * (rows @ vocabulary.T - 1))
    return weight @ vocabulary / weight.sum(1, keepdims=True)

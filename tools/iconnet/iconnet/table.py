"""The word table that is shipped instead of a text network: `words.json` and `words.bin`.

`words.json` says kind, embed, licence, the sha256 of `words.bin`, and the words, sorted. `words.bin` holds one row of `embed` signed
bytes a word, in the same order. A row over its length is the word's embedding: the length is the scale, so none is stored.
"""

import hashlib
import json
from collections import Counter
from pathlib import Path

import numpy as np

from . import evaluate
from .data import Icons
from .errors import DataError, WordError

KIND = "word-table-v1"


def chosen(icons: Icons, most: int) -> list[str]:
    """The `most` words worth shipping: all names that tests ask for, then names and tags by how many icons bear them."""
    needed = {icons.names[i] for test in evaluate.TESTS for i in evaluate.rows(icons, test)}
    times: Counter[str] = Counter()
    # A set's styles of one icon count once. OpenMoji's tags are under another licence, and stay out.
    for source, name in sorted(set(zip(icons.sources, icons.names))):
        times[name] += source != "openmoji"
    for tags in {(s, n): t for s, n, t in zip(icons.sources, icons.names, icons.tags) if s != "openmoji"}.values():
        times.update(tags)
    # Between equals short words first: they are what people write.
    order = sorted((word for word in times if word not in needed), key=lambda word: (-times[word], len(word), word))
    return sorted(needed | set(order[: most - len(needed)]))


def write(words: dict[str, np.ndarray], folder: Path, licence: str) -> int:
    """Both files into `folder`, from unit rows [EMBED] by word. Returns their bytes."""
    known = sorted(words)
    rows = np.stack([words[word] for word in known])
    content = np.round(127 * rows / np.abs(rows).max(1, keepdims=True)).astype(np.int8).tobytes()
    facts = {
        "kind": KIND,
        "embed": rows.shape[1],
        "licence": licence,
        "sha256": hashlib.sha256(content).hexdigest(),
        "words": known,
    }
    text = "{\n" + ",\n".join(f" {json.dumps(k)}: {json.dumps(v, separators=(',', ':'))}" for k, v in facts.items()) + "\n}\n"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "words.bin").write_bytes(content)
    (folder / "words.json").write_text(text, encoding="utf-8")
    return len(content) + len(text)


class Table:
    """Unit rows by word, as an app reads them."""

    def __init__(self, folder: Path):
        """Raises DataError if the two files do not belong together."""
        facts = json.loads((folder / "words.json").read_text(encoding="utf-8"))
        content = (folder / "words.bin").read_bytes()
        if facts.get("kind") != KIND:
            raise DataError(f"words.json is no {KIND} but {facts.get('kind')!r}.")
        if hashlib.sha256(content).hexdigest() != facts["sha256"] or len(content) != len(facts["words"]) * facts["embed"]:
            raise DataError("words.bin is not the one that words.json was written with.")
        rows = np.frombuffer(content, np.int8).reshape(len(facts["words"]), facts["embed"]).astype(np.float32)
        self.rows = rows / np.linalg.norm(rows, axis=1, keepdims=True)
        self.words: list[str] = facts["words"]
        self._at = {word: i for i, word in enumerate(self.words)}

    def __contains__(self, word: str) -> bool:
        return word in self._at

    def __getitem__(self, word: str) -> np.ndarray:
        """Raises WordError if the table lacks the word."""
        if word not in self._at:
            raise WordError(f"{word!r} is not one of the {len(self.words)} words of the table. Try a plainer word for it.")
        return self.rows[self._at[word]]

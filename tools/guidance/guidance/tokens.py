"""CLIP's tokenizer: byte pairs, lower case, padded to a fixed length.

Its file `NAME.tokenizer.json` is small enough for a page and has all that is needed: {kind: "clip-bpe", context, pad, merges:
["i n", ...]}. The vocabulary follows from that: 256 bytes, the same at a word's end, one token a merge, start, end.
Texts are taken as they are: unlike OpenAI's, mojibake is not repaired.
"""

import html
from pathlib import Path

import numpy as np
import regex

from . import sidecar
from .errors import ContractError, SourceError

END = "</w>"
PIECES = regex.compile(r"'s|'t|'re|'ve|'m|'ll|'d|[\p{L}]+|[\p{N}]|[^\s\p{L}\p{N}]+", regex.IGNORECASE)


class Tokenizer:
    """Texts to ids. `file` is what a tokenizer's file holds."""

    def __init__(self, file: dict, name: str = "tokenizer"):
        if file.get("kind") != "clip-bpe":
            raise ContractError(name, [f"The kind {file.get('kind')!r} is unknown: this version reads clip-bpe."])
        self.context, self.pad = file["context"], file["pad"]
        merges = [tuple(merge.split(" ")) for merge in file["merges"]]
        self._letters = _letters()
        letters = list(self._letters.values())
        words = letters + [letter + END for letter in letters] + ["".join(merge) for merge in merges]
        self.start, self.end = len(words), len(words) + 1
        self._ids = {word: i for i, word in enumerate(words)}
        self._ranks = {merge: i for i, merge in enumerate(merges)}

    def __call__(self, texts: list[str]) -> np.ndarray:
        """int32 [n,context]: start, the text's tokens, end, padding. What is too long loses its last tokens."""
        rows = np.full((len(texts), self.context), self.pad, np.int32)
        for row, text in zip(rows, texts):
            ids = [self.start, *self.encode(text)[: self.context - 2], self.end]
            row[: len(ids)] = ids
        return rows

    def nothing(self) -> np.ndarray:
        """int32 [1,context] of an empty prompt."""
        return np.array([[self.start, self.end, *[self.pad] * (self.context - 2)]], np.int32)

    def encode(self, text: str) -> list[int]:
        """Ids without start and end, as many as it takes. Raises SourceError for a text without any."""
        text = " ".join(html.unescape(html.unescape(text)).split()).lower()
        ids = []
        for piece in PIECES.findall(text):
            letters = [self._letters[byte] for byte in piece.encode("utf-8")]
            ids += [self._ids[part] for part in self._merged(letters)]
        if not ids:
            raise SourceError("A prompt is empty. Say what the picture should look like.")
        return ids

    def _merged(self, letters: list[str]) -> list[str]:
        parts = letters[:-1] + [letters[-1] + END]
        while len(parts) > 1:
            pairs = list(zip(parts, parts[1:]))
            best = min(pairs, key=lambda pair: self._ranks.get(pair, len(self._ranks)))
            if best not in self._ranks:
                break
            joined, i = [], 0
            while i < len(parts):
                both = tuple(parts[i : i + 2]) == best
                joined.append("".join(best) if both else parts[i])
                i += 2 if both else 1
            parts = joined
        return parts


def read(file: Path) -> Tokenizer:
    """Raises ContractError where the file is missing or is no tokenizer."""
    found = sidecar.read(file)
    try:
        return Tokenizer(found, file.name)
    except (KeyError, TypeError, AttributeError) as error:
        raise ContractError(file.name, [f"It lacks context, pad or merges ({error}). Export the text encoder again."]) from None


def file_of(merges: list[tuple[str, str]], context: int, pad: int = 0) -> dict:
    """What a tokenizer's file holds."""
    return {"kind": "clip-bpe", "context": context, "pad": pad, "merges": [" ".join(merge) for merge in merges]}


def _letters() -> dict[int, str]:
    """A printable character for each byte, in the order of CLIP's vocabulary: printable Latin-1 first, the rest from U+0100."""
    shown = [*range(33, 127), *range(161, 173), *range(174, 256)]
    table = {byte: chr(byte) for byte in shown}
    for byte in range(256):
        if byte not in table:
            table[byte] = chr(256 + len(table) - len(shown))
    return table

"""Words to a denoiser's contexts, ahead of time: a program that has them needs no text encoder."""

import base64
from pathlib import Path

import numpy as np

from . import check, tokens
from .errors import ContractError, SourceError
from .runtime import Session


def encode(file: Path, prompts: list[str]) -> dict:
    """{kind: "contexts-v1", model, sha256, shape: [N, D], contexts: [{prompt, values}]} with a context-v1 `file`.

    `values` are N times D float32, little-endian, in base64. The empty prompt, which is nothing, always comes first. Raises
    ContractError if the file does not keep its contract or has no tokenizer, SourceError for a blank prompt.
    """
    facts = check.check(file)
    if facts["kind"] != "context-v1":
        raise ContractError(file.name, [f"It is of kind {facts['kind']}; contexts need a context-v1 file."])
    if "tokenizer" not in facts:
        raise ContractError(file.name, ["It has no tokenizer. Export the text encoder with one."])
    tokenizer = tokens.read(file.with_name(facts["tokenizer"]))
    if tokenizer.context != facts["tokens"]:
        raise ContractError(file.name, [f"Its tokenizer pads to {tokenizer.context} and it takes {facts['tokens']}."])
    asked = list(dict.fromkeys(prompt for prompt in prompts if prompt))
    if not asked:
        raise SourceError("There is no prompt. Give one or more after the file.")
    ids = np.concatenate([tokenizer.nothing(), tokenizer(asked)])
    session = Session(file)
    contexts = [
        {"prompt": p, "values": _packed(session.run({"ids": row[None]})["context"])} for p, row in zip(["", *asked], ids)
    ]
    return {
        "kind": "contexts-v1",
        "model": facts["name"],
        "sha256": facts["sha256"],
        "shape": facts["context"],
        "contexts": contexts,
    }


def unpacked(entry: dict, shape: list[int]) -> np.ndarray:
    """float32 [N,D] of one of `contexts`."""
    return np.frombuffer(base64.b64decode(entry["values"]), "<f4").reshape(shape)


def _packed(values: np.ndarray) -> str:
    return base64.b64encode(values.astype("<f4").tobytes()).decode("ascii")

"""Words to vectors, ahead of time: a page that has them needs no text encoder."""

from pathlib import Path

import numpy as np

from . import check, sidecar, tokens
from .errors import ContractError, SourceError
from .runtime import Session

PLAIN = ("{}",)


def embed(file: Path, prompts: list[str], templates: tuple[str, ...] = PLAIN) -> dict:
    """{kind: "prompts-v1", model, sha256, embed, templates, embeddings: [{prompt, vector}]} with a text-v1 `file`.

    Each template has one {}; a prompt's vector is the unit mean of its unit vectors. Raises ContractError if the file does
    not keep its contract or has no tokenizer, SourceError for a template without {} or an empty prompt.
    """
    facts = check.check(file)
    if facts["kind"] != "text-v1":
        raise ContractError(file.name, [f"It is of kind {facts['kind']}; prompts need a text-v1 file."])
    if "tokenizer" not in facts:
        raise ContractError(file.name, ["It has no tokenizer. Export the text encoder with one."])
    for template in templates:
        if template.count("{}") != 1:
            raise SourceError(f"The template {template!r} must have one {{}} where the prompt goes.")
    if not prompts:
        raise SourceError("There is no prompt. Give one or more after the file.")
    tokenizer = tokens.read(file.with_name(facts["tokenizer"]))
    if tokenizer.context != facts["context"]:
        raise ContractError(file.name, [f"Its tokenizer pads to {tokenizer.context} and it takes {facts['context']}."])
    session = Session(file)
    embeddings = []
    for prompt in prompts:
        texts = [template.replace("{}", prompt) for template in templates]
        rows = session.run({"ids": tokenizer(texts)})["embedding"].astype(np.float64)
        mean = rows.mean(0)
        vector = (mean / np.linalg.norm(mean)).astype(np.float32)
        embeddings.append({"prompt": prompt, "vector": [float(f"{v:.8g}") for v in vector]})
    return {
        "kind": "prompts-v1",
        "model": facts["name"],
        "sha256": facts["sha256"],
        "embed": facts["embed"],
        "templates": list(templates),
        "embeddings": embeddings,
    }


def read(file: Path) -> list[dict]:
    """The embeddings of a file that `embed` made. Raises ContractError where it is none."""
    found = sidecar.read(file)
    entries = found.get("embeddings")
    fine = found.get("kind") == "prompts-v1" and isinstance(entries, list) and entries
    if not fine or not all(isinstance(e, dict) and isinstance(e.get("vector"), list) and e.get("prompt") for e in entries):
        raise ContractError(file.name, ["It is no prompts-v1 file. Make it with `python -m guidance prompts`."])
    return entries

"""A network and its sizes become `NAME.onnx` and `NAME.json`, compared with torch before anything is written."""

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import torch

from . import contracts, graph, losses, selftest, sidecar, storage
from .contracts import Contract
from .errors import ModelError
from .runtime import Session
from .schedule import Schedule

AGREEMENT = {"fp32": 0.999999, "fp16": 0.9999, "int8": 0.98}  # least cosine of any output with torch's


@dataclass(frozen=True)
class ImageEncoder:
    """A network [n,3,size,size] -> [n,embed] that wants (image - mean) / std; its length does not matter."""

    network: torch.nn.Module
    size: int
    embed: int
    mean: tuple[float, float, float]
    std: tuple[float, float, float]


@dataclass(frozen=True)
class TextEncoder:
    """A network int64 [n,context] -> [n,embed], and a tokenizer's file as `tokens.Tokenizer` reads it."""

    network: torch.nn.Module
    context: int
    embed: int
    tokenizer: dict | None = None


@dataclass(frozen=True)
class ContextEncoder:
    """A network int64 [n,tokens] -> [n,*context], and a tokenizer's file."""

    network: torch.nn.Module
    tokens: int
    context: tuple[int, int]
    tokenizer: dict | None = None


@dataclass(frozen=True)
class LatentEncoder:
    """A network [1,3,height,width] in 0..1 -> [1,*latent], with the latent's scale inside."""

    network: torch.nn.Module
    image: tuple[int, int]
    latent: tuple[int, int, int]


@dataclass(frozen=True)
class Denoiser:
    """A network (x_t [n,*latent], t [n], context [n,*context]) -> eps like x_t. `schedule` says how its noise grows, and `nothing`,
    where no empty prompt gives it, the context of nothing. With `beside` it takes a fourth [n,*beside]: what vjp-v1 makes of a
    reference picture."""

    network: torch.nn.Module
    latent: tuple[int, int, int]
    context: tuple[int, int]
    schedule: Schedule | None = None
    nothing: np.ndarray | None = None
    beside: tuple[int, int, int] | None = None


@dataclass(frozen=True)
class PoseEncoder:
    """A network (image [1,3,size,size] in 0..1, pose [n,4]) -> [n,*context]: a picture, and from where else it is seen."""

    network: torch.nn.Module
    size: int
    context: tuple[int, int]


@dataclass(frozen=True)
class Label:
    """What a person should know of a file: its name, whose weights these are, and under which licence."""

    name: str
    origin: str
    licence: str


@dataclass(frozen=True)
class Report:
    """What was written, and how near each output is to torch's: the least cosine, and the most of |a - b| / |b|."""

    file: Path
    bytes: int
    cosine: dict[str, float] = field(default_factory=dict)
    error: dict[str, float] = field(default_factory=dict)


def image_encoder(given: ImageEncoder, label: Label, folder: Path, weights="fp32", embeddings: list[dict] | None = None):
    """guidance-v1. `embeddings` are prompts with their vectors, as `prompts` writes them. Returns a Report.

    Raises ModelError where the network cannot be exported, or the file does not compute what the network does.
    """
    if len(given.mean) != 3 or len(given.std) != 3 or not all(s > 0 for s in given.std):
        raise ModelError(f"mean and std must be three numbers each, std above 0, and they are {given.mean}, {given.std}.")
    for entry in embeddings or []:
        if len(entry["vector"]) != given.embed:
            raise ModelError(
                f"The embedding of {entry['prompt']!r} has {len(entry['vector'])} numbers and the image encoder {given.embed}: "
                "make it with the text encoder of the same model."
            )
    facts = {
        "size": given.size,
        "embed": given.embed,
        "batch": "dynamic",
        **_picture_facts(),
        "mean": list(given.mean),
        "std": list(given.std),
        "mean_std_inside": True,
        "direction_eps": losses.DIRECTION_EPS,
    }
    if embeddings:
        facts["embeddings"] = embeddings
    function = losses.guidance(given.network, given.mean, given.std)
    return _write(function, contracts.guidance(given.size, given.embed), facts, label, folder, weights)


def text_encoder(given: TextEncoder, label: Label, folder: Path, weights="fp32") -> Report:
    """text-v1, and `NAME.tokenizer.json` where the encoder brings a tokenizer. Errors as above."""
    facts = {"context": given.context, "embed": given.embed, "batch": "dynamic"}
    contract = contracts.text(given.context, given.embed)
    return _write_of_words(losses.text(given.network), contract, facts, given.tokenizer, label, folder, weights)


def context_encoder(given: ContextEncoder, label: Label, folder: Path, weights="fp32") -> Report:
    """context-v1, and a tokenizer as above. Errors as above."""
    facts = {"tokens": given.tokens, "context": list(given.context), "batch": "dynamic"}
    contract = contracts.context(given.tokens, given.context)
    return _write_of_words(losses.context(given.network), contract, facts, given.tokenizer, label, folder, weights)


def latent_encoder(given: LatentEncoder, label: Label, folder: Path, weights="fp32") -> Report:
    """vjp-v1. Errors as above."""
    facts = {"image": list(given.image), "latent": list(given.latent), "batch": 1, **_picture_facts()}
    return _write(losses.vjp(given.network), contracts.vjp(given.image, given.latent), facts, label, folder, weights)


def denoiser(given: Denoiser, label: Label, folder: Path, weights="fp32") -> Report:
    """eps-v1. Errors as above."""
    facts = {"latent": list(given.latent), "context": list(given.context), "batch": "dynamic"}
    if given.beside is not None:
        facts["beside"] = list(given.beside)
    if given.schedule is not None:
        facts["schedule"] = given.schedule.as_json()
    if given.nothing is not None:
        facts["nothing"] = [float(f"{value:.9g}") for value in np.ravel(given.nothing)]
        said = contracts.nothing_faults(facts)
        if said:
            raise ModelError(" ".join(said))
    return _write(
        losses.eps(given.network), contracts.eps(given.latent, given.context, given.beside), facts, label, folder, weights
    )


def pose_encoder(given: PoseEncoder, label: Label, folder: Path, weights="fp32") -> Report:
    """pose-v1. Errors as above."""
    facts = {"size": given.size, "context": list(given.context), "batch": "dynamic", **_picture_facts()}
    return _write(losses.pose(given.network), contracts.pose(given.size, given.context), facts, label, folder, weights)


def sight(what: str, network: torch.nn.Module, image: tuple[int, int], label: Label, folder: Path, weights="fp32") -> Report:
    """mask-v1 or depth-v1, as `what` says, of a network [1,3,H,W] in 0..1 -> [1,1,H,W]. Errors as above."""
    facts = {"image": list(image), "batch": 1, **_picture_facts()}
    return _write(losses.sight(network), contracts.sight(what, image), facts, label, folder, weights)


def _picture_facts() -> dict:
    return {"range": [0, 1], "layout": "NCHW", "colour": "sRGB"}


def _write_of_words(
    function, contract: Contract, facts: dict, tokenizer: dict | None, label: Label, folder: Path, weights: str
):
    if tokenizer is not None:
        facts["tokenizer"] = f"{label.name}.tokenizer.json"
    report = _write(function, contract, facts, label, folder, weights)
    if tokenizer is not None:
        sidecar.write(tokenizer, folder / facts["tokenizer"])
    return report


def _write(function: Callable, contract: Contract, facts: dict, label: Label, folder: Path, weights: str) -> Report:
    _try(function, contract)
    program = storage.store(graph.build(function, contract), weights)
    graph_bytes = graph.packed(program)
    run = Session(graph_bytes).run
    cosine, error = _compare(function, contract, run, weights)
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{label.name}.onnx"
    partial = file.with_suffix(".onnx.partial")
    partial.write_bytes(graph_bytes)
    os.replace(partial, file)
    written = {
        "kind": contract.kind,
        "name": label.name,
        **facts,
        "weights": weights,
        "origin": label.origin,
        "licence": label.licence,
        "bytes": len(graph_bytes),
        "sha256": sidecar.sha256(file),
        "io": contract.as_json(),
        "selftest": selftest.write(contract, run),
    }
    sidecar.write(written, sidecar.path_of(file))
    return Report(file, len(graph_bytes), cosine, error)


def _try(function, contract: Contract) -> None:
    """A wrong size and damaged weights are told here, in the contract's words, rather than by a tracer."""
    batch = selftest.BATCH if contract.dynamic else 1
    case = {"inputs": selftest.inputs(contract)[0][1]}
    feeds = selftest.feeds(case, contract, batch)
    try:
        answers = function(*(torch.from_numpy(feeds[p.name]) for p in contract.inputs))
    except Exception as error:
        raise ModelError(
            f"The network fails on {', '.join(map(str, contract.inputs))}: {type(error).__name__}: "
            f"{' '.join(str(error).split())[:300]}. Check the size that was given."
        ) from error
    for port, answer in zip(contract.outputs, answers):
        if not torch.isfinite(answer).all():
            raise ModelError(f"The network's {port.name} is not finite: its weights are damaged, or did not load.")
        if tuple(answer.shape) != port.sized(batch):
            raise ModelError(f"The network's {port.name} has shape {list(answer.shape)} and must be {list(port.sized(batch))}.")


def _compare(function, contract: Contract, run, weights: str) -> tuple[dict, dict]:
    """Each output of the graph with torch's, over all cases of the self-test and, where it is free, other batch sizes."""
    cosine = {port.name: 1.0 for port in contract.outputs}
    error = {port.name: 0.0 for port in contract.outputs}
    for name, how in selftest.inputs(contract):
        for batch in (1, 2, 3) if contract.dynamic else (1,):
            feeds = selftest.feeds({"inputs": how}, contract, batch)
            wanted = function(*(torch.from_numpy(feeds[p.name]) for p in contract.inputs))
            found = run(feeds)
            for port, want in zip(contract.outputs, wanted):
                want, have = want.numpy().astype(np.float64), found[port.name].astype(np.float64)
                if not np.isfinite(want).all() or not np.isfinite(have).all():
                    raise ModelError(f"'{port.name}' is not finite in the case '{name}'. Try fp32 weights.")
                if have.shape != want.shape:
                    shapes = f"{list(have.shape)} and torch's has {list(want.shape)}"
                    raise ModelError(f"'{port.name}' has shape {shapes}, batch {batch}: the network fixes the batch somewhere.")
                cosine[port.name] = min(cosine[port.name], selftest.cosine(have, want))
                off = np.linalg.norm(have - want) / max(np.linalg.norm(want), 1e-30)
                error[port.name] = max(error[port.name], float(off))
    # A scalar's or a few cosines' angle says nothing; what is derived from them is in the larger outputs.
    for port in contract.outputs:
        if len(port.shape) > 1 and cosine[port.name] < AGREEMENT[weights]:
            advice = "Store it as fp16 or fp32." if weights == "int8" else "An operator is exported wrongly: find its rule."
            found = f"'{port.name}' has cosine {cosine[port.name]:.6f} with torch's"
            raise ModelError(f"{found}, and {weights} asks for {AGREEMENT[weights]}. {advice}")
    return cosine, error

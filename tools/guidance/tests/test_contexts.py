"""Prompts to a denoiser's contexts."""

import json

import numpy as np
import pytest
import torch

from guidance import contexts, export, sources, tokens
from guidance.cli import main
from guidance.errors import ContractError, SourceError

LABEL = export.Label("states", "random numbers", "none")


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return export.context_encoder(sources.load("context", "tiny"), LABEL, tmp_path_factory.mktemp("states")).file


def test_contexts_are_the_networks_states(file):
    given = sources.load("context", "tiny")
    found = contexts.encode(file, ["wire", "", "a wire"])
    assert [entry["prompt"] for entry in found["contexts"]] == ["", "wire", "a wire"] and found["shape"] == [5, 16]
    tokenizer = tokens.Tokenizer(given.tokenizer)
    for ids, entry in zip(np.concatenate([tokenizer.nothing(), tokenizer(["wire", "a wire"])]), found["contexts"]):
        wanted = given.network(torch.from_numpy(ids[None]).long())[0].detach().numpy()
        assert np.abs(contexts.unpacked(entry, found["shape"]) - wanted).max() < 1e-5
    # Other words, other states; but a start is a start.
    nothing, wire, _ = (contexts.unpacked(entry, found["shape"]) for entry in found["contexts"])
    assert np.allclose(nothing[0], wire[0], atol=1e-6) and np.abs(nothing[1] - wire[1]).max() > 0.1


def test_they_are_what_the_tiny_denoiser_takes(file):
    eps = sources.load("denoiser", "tiny")
    assert contexts.encode(file, ["wire"])["shape"] == list(eps.context)


def test_nothing_is_start_and_end():
    tokenizer = tokens.Tokenizer(tokens.file_of([("w", "i")], 6, pad=3))
    assert tokenizer.nothing().tolist() == [[513, 514, 3, 3, 3, 3]]


def test_the_command_writes_them(file, tmp_path, capsys):
    assert main(["contexts", str(file), "wire", "--out", str(tmp_path / "c.json")]) == 0
    assert "2 contexts of 5 x 16 numbers" in capsys.readouterr().out
    assert json.loads((tmp_path / "c.json").read_text())["kind"] == "contexts-v1"


def test_what_gives_no_contexts(file, tmp_path):
    with pytest.raises(SourceError, match="no prompt"):
        contexts.encode(file, [""])
    with pytest.raises(SourceError, match="empty"):
        contexts.encode(file, ["  "])
    other = export.denoiser(sources.load("denoiser", "tiny"), LABEL, tmp_path).file
    with pytest.raises(ContractError, match="kind eps-v1"):
        contexts.encode(other, ["wire"])

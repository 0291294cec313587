"""Text encoders, the tokenizer and prompts."""

import numpy as np
import pytest
import torch

from guidance import export, losses, prompts, sidecar, sources, tokens
from guidance.check import check
from guidance.errors import ContractError, SourceError
from guidance.runtime import Session
from tests.conftest import FIXTURE, off

LABEL = export.Label("words", "random numbers", "none")
TEXTS = (
    "A continuous 3D wire drawing",
    "a photo of a   cat's face, isn't it?",
    "naïve café &amp; 日本語 … 42½ ¿qué? snake_case",
    "word " * 100,
    "🙂👩‍🚀!!",
)


@pytest.fixture(scope="module")
def words(tmp_path_factory):
    folder = tmp_path_factory.mktemp("words")
    return export.text_encoder(sources.load("text", "tiny"), LABEL, folder).file


def test_equals_torch(words):
    check(words)
    given = sources.load("text", "tiny")
    ids = tokens.read(words.with_name("words.tokenizer.json"))(["a wire", "something longer"])
    answers = Session(words).run({"ids": ids})["embedding"]
    assert off(answers, losses.text(given.network)(torch.from_numpy(ids))[0]) < 1e-5
    assert np.abs(np.linalg.norm(answers, axis=1) - 1).max() < 1e-5


def test_prompts(words, tmp_path):
    found = prompts.embed(words, ["a cat", "a wire"], ("{}", "a drawing of {}"))
    assert [e["prompt"] for e in found["embeddings"]] == ["a cat", "a wire"]
    for entry in found["embeddings"]:
        assert len(entry["vector"]) == found["embed"] == 16
        assert abs(np.linalg.norm(entry["vector"]) - 1) < 1e-6
    alone = prompts.embed(words, ["a wire"], ("{}", "a drawing of {}"))["embeddings"][0]
    assert off(alone["vector"], found["embeddings"][1]["vector"]) < 1e-6
    sidecar.write(found, tmp_path / "p.json")
    assert prompts.read(tmp_path / "p.json") == found["embeddings"]


def test_prompts_that_cannot_be(words, tmp_path):
    for given, said in (((words, [""]), "empty"), ((words, []), "no prompt"), ((words, ["x"], ("no place",)), "no place")):
        with pytest.raises(SourceError, match=said):
            prompts.embed(*given)
    with pytest.raises(ContractError, match="guidance-v1"):
        prompts.embed(FIXTURE / "vit-tiny.onnx", ["x"])
    sidecar.write({"kind": "prompts-v1"}, tmp_path / "p.json")
    with pytest.raises(ContractError, match="no prompts-v1 file"):
        prompts.read(tmp_path / "p.json")


def test_embeddings_must_fit_the_image_encoder(tmp_path):
    with pytest.raises(export.ModelError, match="'a cat' has 3 numbers and the image encoder 16"):
        export.image_encoder(sources.load("image", "tiny"), LABEL, tmp_path, embeddings=[{"prompt": "a cat", "vector": [1, 0, 0]}])


def test_tokenizer_pads_and_cuts():
    tokenizer = tokens.Tokenizer(tokens.file_of([("w", "i")], context=6))
    rows = tokenizer(["wi", "wire wire"])
    assert rows.dtype == np.int32 and rows.shape == (2, 6)
    assert rows[0].tolist()[0] == tokenizer.start == 513
    assert rows[0].tolist()[3:] == [tokenizer.end, 0, 0]
    assert rows[1].tolist()[-1] == tokenizer.end


def test_tokenizer_equals_open_clips():
    pytest.importorskip("open_clip")
    from open_clip.tokenizer import SimpleTokenizer

    from guidance.sources import open_clip

    theirs = SimpleTokenizer()
    ours = tokens.Tokenizer(tokens.file_of(open_clip._merges(), 77))
    assert (ours.start, ours.end) == (theirs.sot_token_id, theirs.eot_token_id)
    for text in TEXTS:
        assert ours([text]).tolist() == theirs([text]).tolist(), text

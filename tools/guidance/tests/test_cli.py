"""The command line, from outside."""

import shutil

import pytest

from guidance.cli import main
from guidance.sidecar import read
from tests.conftest import FIXTURE


def test_export_check_and_prompts(tmp_path, capsys):
    out = ["--licence", "none", "--out", str(tmp_path)]
    assert main(["export", "text", "tiny", "--name", "words", *out]) == 0
    vectors = str(tmp_path / "vectors.json")
    assert main(["prompts", str(tmp_path / "words.onnx"), "a cat", "a wire", "--out", vectors]) == 0
    small = ["--weights", "fp16", "--embeddings", vectors]
    assert main(["export", "image", "tiny", "--name", "picture", *small, *out]) == 0
    facts = read(tmp_path / "picture.json")
    assert [e["prompt"] for e in facts["embeddings"]] == ["a cat", "a wire"]
    assert (facts["weights"], facts["licence"], facts["origin"]) == ("fp16", "none", "tiny")
    capsys.readouterr()
    assert main(["check", str(tmp_path / "words.onnx"), str(tmp_path / "picture.onnx")]) == 0
    assert capsys.readouterr().out.count(": fine.") == 2


def test_check_goes_on_after_a_bad_file(tmp_path, capsys):
    shutil.copy(FIXTURE / "vit-tiny.onnx", tmp_path)
    assert main(["check", str(tmp_path / "vit-tiny.onnx"), str(FIXTURE / "vit-tiny.onnx")]) == 1
    said = capsys.readouterr()
    assert "sidecar is missing" in said.err and "fine" in said.out
    assert "Traceback" not in said.err


@pytest.mark.parametrize("name", ("../x", "a/b", "", "ä"))
def test_names_that_are_paths(name, tmp_path):
    with pytest.raises(SystemExit) as exit:
        main(["export", "image", "tiny", "--name", name, "--licence", "none", "--out", str(tmp_path)])
    assert exit.value.code == 2


def test_what_cannot_be_is_said_in_a_sentence(tmp_path, capsys):
    asked = ["export", "image", "keras:x", "--name", "x", "--licence", "none", "--out", str(tmp_path)]
    assert main(asked) == 1
    assert "names no library" in capsys.readouterr().err
    assert main(["export", "text", "tiny", "--embeddings", "x.json", *asked[3:]]) == 1

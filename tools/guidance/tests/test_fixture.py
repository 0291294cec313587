"""The committed fixture: what it answers, and that it can be made again."""

import json
import runpy
from pathlib import Path

import numpy as np
import pytest

from guidance import contracts, selftest, sidecar
from guidance.check import check
from guidance.runtime import Session
from tests.conftest import FIXTURE

SCRIPT = Path(__file__).resolve().parents[1] / "scripts/make_fixture.py"
FILE = FIXTURE / "vit-tiny.onnx"
OTHERS = ("vjp-tiny", "eps-tiny", "eps-pixels-tiny", "eps-views-tiny", "pose-tiny", "mask-tiny", "depth-tiny")


def test_answers_what_is_expected():
    facts, about = sidecar.read(FIXTURE / "vit-tiny.json"), json.loads((FIXTURE / "vit-tiny.expected.json").read_text())
    numbers = np.fromfile(FIXTURE / about["file"], "<f4")
    contract, session = contracts.of_sidecar(facts, "vit-tiny.json"), Session(FILE)
    cases = {case["name"]: case for case in facts["selftest"]["cases"]}
    assert len(about["arrays"]) == 8
    for array in about["arrays"]:
        answer = session.run(selftest.feeds(cases[array["case"]], contract, facts["selftest"]["batch"]))[array["output"]]
        wanted = numbers[array["at"] : array["at"] + answer.size].reshape(array["shape"])
        assert np.linalg.norm(answer - wanted) <= 1e-5 * np.linalg.norm(wanted)


@pytest.mark.parametrize("name", OTHERS)
def test_the_others_answer_what_is_expected(name):
    facts, wanted = check(FIXTURE / f"{name}.onnx"), json.loads((FIXTURE / f"{name}.expected.json").read_text())
    contract, (case,) = contracts.of_sidecar(facts, name), facts["selftest"]["cases"]
    found = Session(FIXTURE / f"{name}.onnx").run(selftest.feeds(case, contract, facts["selftest"]["batch"]))
    for port in contract.outputs:
        assert np.linalg.norm(found[port.name].ravel() - wanted[port.name]) <= 1e-5 * np.linalg.norm(wanted[port.name])


def test_the_two_halves_of_a_latent_model_fit():
    latent, eps = (sidecar.read(FIXTURE / f"{name}.json") for name in ("vjp-tiny", "eps-tiny"))
    assert latent["latent"] == eps["latent"]


def test_is_small():
    for name in OTHERS:
        assert (FIXTURE / f"{name}.onnx").stat().st_size < 60_000
    assert FILE.stat().st_size + sidecar.path_of(FILE).stat().st_size < 150_000


def test_can_be_made_again(tmp_path):
    runpy.run_path(str(SCRIPT))["make"](tmp_path)
    made = np.fromfile(tmp_path / "vit-tiny.expected.bin", "<f4")
    kept = np.fromfile(FIXTURE / "vit-tiny.expected.bin", "<f4")
    assert np.linalg.norm(made - kept) <= 1e-5 * np.linalg.norm(kept)
    # Byte-equal with the pinned exporter; another one may order its nodes otherwise, so only the contract is asked for.
    again, before = sidecar.read(tmp_path / "vit-tiny.json"), sidecar.read(FIXTURE / "vit-tiny.json")
    assert again["io"] == before["io"]
    for name in ("formulas.json", "text-tiny.tokenizer.json"):
        assert sidecar.read(tmp_path / name) == sidecar.read(FIXTURE / name)

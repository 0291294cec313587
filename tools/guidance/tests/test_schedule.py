"""How noise grows, and what is said of schedules that are none."""

import json
import math
import shutil

import numpy as np
import pytest

from guidance import export, schedule, sources
from guidance.check import check
from guidance.errors import ContractError, ModelError
from guidance.schedule import Schedule
from tests.conftest import FIXTURE


@pytest.mark.parametrize(
    "given, first, last",
    (
        (Schedule("linear", 1000, 1e-4, 0.02), 0.9999, 4.0358e-5),
        (schedule.STABLE_DIFFUSION, 0.99915, 4.6605e-3),
    ),
)
def test_alpha_bars_are_the_published_ones(given, first, last):
    found = given.alpha_bar()
    assert found.shape == (1000,) and (np.diff(found) < 0).all()
    assert found[0] == pytest.approx(first, rel=1e-4) and found[-1] == pytest.approx(last, rel=1e-3)


def test_a_cosine_is_one():
    found = Schedule("cosine").alpha_bar()
    level = lambda t: math.cos((t / 1000 + 0.008) / 1.008 * math.pi / 2) ** 2
    assert found[499] == pytest.approx(level(500) / level(0)) and 0 < found[-1] < 1e-7


def test_of_a_scheduler_of_diffusers():
    config = {"beta_schedule": "scaled_linear", "num_train_timesteps": 1000, "beta_start": 0.00085, "beta_end": 0.012}
    assert schedule.of_config(config) == schedule.STABLE_DIFFUSION
    assert schedule.of_config({"beta_schedule": "squaredcos_cap_v2"}) == Schedule("cosine")
    with pytest.raises(ModelError, match="sigmoid"):
        schedule.of_config({"beta_schedule": "sigmoid"})
    with pytest.raises(ModelError, match="v_prediction"):
        schedule.of_config(config | {"prediction_type": "v_prediction"})


@pytest.mark.parametrize(
    "given, said",
    (
        (("sigmoid",), "kind of cosine"),
        (("linear", 1000), "0 < from <= to < 1"),
        (("linear", 1000, 0.02, 1e-4), "0 < from <= to < 1"),
        (("cosine", 0), "'steps'"),
        (("cosine", 1000, 1e-4, 0.02), "neither"),
    ),
)
def test_no_schedule(given, said):
    with pytest.raises(ModelError, match=said):
        Schedule(*given)


@pytest.fixture
def file(tmp_path):
    for end in ("onnx", "json"):
        shutil.copy(FIXTURE / f"eps-tiny.{end}", tmp_path)
    return tmp_path / "eps-tiny.onnx"


def changed(file, **facts):
    there = json.loads(file.with_suffix(".json").read_text())
    there = {key: value for key, value in (there | facts).items() if value is not None}
    file.with_suffix(".json").write_text(json.dumps(there))
    return file


def test_a_sidecar_may_lack_both(file):
    assert check(file)["schedule"] == {"kind": "scaled-linear", "steps": 1000, "from": 0.00085, "to": 0.012}
    assert check(changed(file, schedule=None, nothing=None))["kind"] == "eps-v1"


def test_what_is_neither_is_told(file):
    with pytest.raises(ContractError, match="kind of cosine"):
        check(changed(file, schedule={"kind": "none"}))
    with pytest.raises(ContractError, match="'nothing' must be 80 finite numbers"):
        check(changed(file, schedule={"kind": "cosine", "steps": 1000}, nothing=[0.0] * 16))


def test_nothing_must_be_a_context(tmp_path):
    given = sources.load("denoiser", "tiny")
    wrong = export.Denoiser(given.network, given.latent, given.context, given.schedule, np.zeros(3))
    with pytest.raises(ModelError, match="80 finite numbers"):
        export.denoiser(wrong, export.Label("x", "random numbers", "none"), tmp_path)
    assert not list(tmp_path.iterdir())

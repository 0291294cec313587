"""The committed files keep their promises."""

import hashlib
import json

import numpy as np
import pytest
import torch

from iconnet import curves, denoiser, export
from iconnet.places import WEIGHTS
from iconnet.table import Table
from iconnet.words import EMBED, NOTHING

NAMES = ("a", "b", "judge")


@pytest.mark.parametrize("name", NAMES)
def test_a_network_is_small_and_passes_its_own_check(name):
    export.exporter()
    from guidance import check

    file = WEIGHTS / f"iconnet-{name}.onnx"
    facts = check.check(file)
    assert facts["kind"] == "guidance-v1" and facts["size"] == 64 and facts["embed"] == EMBED
    assert file.stat().st_size < 2_200_000


@pytest.mark.parametrize("name", NAMES)
def test_a_gradient_is_that_of_finite_differences(name):
    export.exporter()
    from guidance.runtime import Session

    session, table = Session(WEIGHTS / f"iconnet-{name}.onnx"), Table(WEIGHTS)
    random = np.random.default_rng(0)
    image = random.uniform(0.2, 0.8, (1, 3, 64, 64)).astype(np.float32)
    direction = random.normal(size=image.shape).astype(np.float32)
    direction /= np.linalg.norm(direction)

    def run(picture):
        nil = np.zeros((1, EMBED), np.float32)
        return session.run({"image": picture, "source": nil, "target": table["cat"][None], "weight": np.ones(1, np.float32)})

    grad = run(image)["grad"]
    along = grad / np.linalg.norm(grad)
    for towards in (along, 0.7 * along + 0.7 * direction):
        step = np.float32(0.05)
        found = (run(image + step * towards)["loss"] - run(image - step * towards)["loss"]) / (2 * step)
        assert float(found) == pytest.approx(float((grad * towards).sum()), rel=1e-2)


def test_the_word_table_is_small_and_knows_plain_words():
    size = sum((WEIGHTS / f"words.{end}").stat().st_size for end in ("json", "bin"))
    assert size < 700_000
    table = Table(WEIGHTS)
    assert table.words == sorted(set(table.words))
    for word in ("cat", "house", "tree", "fish", "sailboat", "umbrella"):
        assert word in table
    assert table["cat"] @ table["kitten"] > table["cat"] @ table["airplane"]
    facts = json.loads((WEIGHTS / "words.json").read_text(encoding="utf-8"))
    assert facts["sha256"] == hashlib.sha256((WEIGHTS / "words.bin").read_bytes()).hexdigest()


def test_the_denoiser_is_small_and_passes_its_own_check():
    export.exporter()
    from guidance import check

    file = WEIGHTS / "iconnet-denoiser.onnx"
    facts = check.check(file)
    assert (facts["kind"], facts["latent"], facts["context"]) == ("eps-v1", [1, 64, 64], [1, EMBED])
    assert facts["schedule"] == {"kind": "cosine", "steps": 1000} and facts["nothing"] == NOTHING.tolist()
    assert file.stat().st_size < 4_000_000


def test_the_denoiser_finds_a_lines_noise_and_hears_words():
    export.exporter()
    from guidance.runtime import Session

    session, table, random = Session(WEIGHTS / "iconnet-denoiser.onnx"), Table(WEIGHTS), np.random.default_rng(0)
    ring = curves.basis(32, 256) @ curves.ring_controls(1, 32, torch.Generator().manual_seed(0), noise=0)
    picture = 1 - 2 * curves.draw(ring, torch.tensor([1.8])).numpy()

    def eps(x_t, t, word):
        row = NOTHING if word is None else table[word]
        return session.run({"x_t": x_t, "t": np.array([t], np.float32), "context": row[None, None]})["eps"]

    for t, most in ((300, 0.2), (600, 0.15)):
        left = float(denoiser.alpha_bar()[t])
        noise = random.normal(size=picture.shape).astype(np.float32)
        x_t = left**0.5 * picture + (1 - left) ** 0.5 * noise
        assert float(((eps(x_t, t, None) - noise) ** 2).mean()) < most
    assert np.abs(eps(x_t, 900, "house") - eps(x_t, 900, "fish")).max() > 0.01

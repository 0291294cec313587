"""Latent encoders and denoisers: the halves of score distillation."""

import numpy as np
import pytest
import torch

from guidance import contracts, export, losses, noise, sources
from guidance.check import check
from guidance.errors import ModelError
from guidance.runtime import Session
from tests.conftest import off

LABEL = export.Label("half", "random numbers", "none")


def test_latent_equals_autograd(tmp_path):
    given = sources.load("latent", "tiny")
    file = export.latent_encoder(given, LABEL, tmp_path).file
    assert check(file)["latent"] == [4, 8, 12]
    image, cotangent = noise.uniform(1, (1, 3, 32, 48)), noise.signed(2, (1, 4, 8, 12))
    answers = Session(file).run({"image": image, "cotangent": cotangent})
    latent, grad = losses.vjp(given.network)(torch.from_numpy(image), torch.from_numpy(cotangent))
    assert off(answers["latent"], latent) < 1e-5 and off(answers["grad"], grad) < 1e-5


def test_latent_equals_finite_differences(tmp_path):
    given = sources.load("latent", "tiny")
    session = Session(export.latent_encoder(given, LABEL, tmp_path).file)
    image, cotangent, step = noise.uniform(1, (1, 3, 32, 48)), noise.signed(2, (1, 4, 8, 12)), noise.signed(3, (1, 3, 32, 48))
    grad = session.run({"image": image, "cotangent": cotangent})["grad"].astype(np.float64)
    network = sources.load("latent", "tiny").network.double()
    at = lambda h: (network(torch.from_numpy(image + h * step.astype(np.float64))) * torch.from_numpy(cotangent)).sum().item()
    slope = (at(1e-5) - at(-1e-5)) / 2e-5
    assert abs(float((grad * step).sum()) - slope) < 1e-3 * abs(slope)


@pytest.mark.parametrize("weights", ("fp32", "int8"))
def test_denoiser_equals_torch(tmp_path, weights):
    given = sources.load("denoiser", "tiny")
    file = export.denoiser(given, LABEL, tmp_path, weights).file
    contract = contracts.of_sidecar(check(file), "half.json")
    for batch in (1, 2, 5):
        arrays = [noise.signed(i, port.sized(batch)) for i, port in enumerate(contract.inputs)]
        arrays[1] = np.linspace(20, 980, batch, dtype=np.float32)
        answer = Session(file).run({port.name: a for port, a in zip(contract.inputs, arrays)})["eps"]
        assert off(answer, given.network(*map(torch.from_numpy, arrays)).detach()) < (1e-5 if weights == "fp32" else 0.1)


def test_sizes_that_do_not_fit(tmp_path):
    network = sources.load("latent", "tiny").network
    with pytest.raises(ModelError, match="fails on image.*Check the size"):
        export.latent_encoder(export.LatentEncoder(network, (32, 48), (4, 9, 12)), LABEL, tmp_path)
    vit = sources.load("image", "tiny")
    with pytest.raises(ModelError, match=r"fails on image\[batch, 3, 40, 40\]"):
        export.image_encoder(export.ImageEncoder(vit.network, 40, 16, vit.mean, vit.std), LABEL, tmp_path)


def test_damaged_weights(tmp_path):
    vit = sources.load("image", "tiny")
    with torch.no_grad():
        vit.network.project[0, 0] = float("nan")
    with pytest.raises(ModelError, match="not finite"):
        export.image_encoder(vit, LABEL, tmp_path)
    assert not list(tmp_path.iterdir())

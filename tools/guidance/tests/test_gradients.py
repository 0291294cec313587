"""The exported loss and gradient against torch's, and against finite differences."""

import copy

import numpy as np
import pytest
import torch

from guidance import contracts, graph, losses, networks, noise
from tests.conftest import exported, feeds, off, tensors

OUTPUTS = ("loss", "grad", "cos", "embedding")


@pytest.mark.parametrize("plain", (True, False), ids=("plain", "directional"))
@pytest.mark.parametrize("batch", (1, 2, 5))
@pytest.mark.parametrize("model", ("vit", "conv"))
def test_equals_torch(model, batch, plain):
    given, function, _, session = exported(model)
    arrays = feeds(given, batch, plain)
    answers = session.run(arrays)
    for name, wanted in zip(OUTPUTS, function(*tensors(arrays))):
        assert answers[name].shape == tuple(wanted.shape)
        assert off(answers[name], wanted) < 1e-5, name


@pytest.mark.parametrize("plain", (True, False), ids=("plain", "directional"))
@pytest.mark.parametrize("model", ("vit", "conv"))
def test_equals_finite_differences(model, plain):
    given, _, _, session = exported(model)
    arrays = feeds(given, 2, plain)
    grad = session.run(arrays)["grad"].astype(np.float64)
    network = copy.deepcopy(given.network).double()
    image, source, target, weight = (t.double() for t in tensors(arrays))
    mean, std = (torch.tensor(v, dtype=torch.float64).view(1, 3, 1, 1) for v in (given.mean, given.std))

    def loss(pixels):
        direction = losses.unit(losses.unit(network((pixels - mean) / std)) - source, losses.DIRECTION_EPS)
        return float((weight * (1 - (direction * target).sum(-1))).sum())

    # Along the gradient, and along steps that have nothing to do with it.
    steps = [grad / np.linalg.norm(grad)] + [noise.signed(seed, grad.shape) / 50 for seed in (21, 22, 23)]
    for step in steps:
        h = 1e-5
        with torch.no_grad():
            slope = (loss(image + h * torch.from_numpy(step)) - loss(image - h * torch.from_numpy(step))) / (2 * h)
        assert abs(float((grad * step).sum()) - slope) < 1e-3 * max(abs(slope), 1e-2 * np.linalg.norm(grad))


def test_a_row_of_no_weight_changes_nothing():
    given, _, _, session = exported("vit")
    arrays = feeds(given, 2, True)
    alone = session.run({name: a[:1] for name, a in arrays.items()})
    arrays["weight"][1] = 0
    padded = session.run(arrays)
    assert off(padded["loss"], alone["loss"]) < 1e-6
    assert off(padded["grad"][:1], alone["grad"]) < 1e-5
    assert not padded["grad"][1].any()


def test_an_image_that_is_its_own_source_has_a_finite_gradient():
    given, _, _, session = exported("vit")
    arrays = feeds(given, 2, True)
    ordinary = session.run(arrays)
    arrays["source"] = ordinary["embedding"]
    answers = session.run(arrays)
    assert np.isfinite(answers["grad"]).all()
    assert np.linalg.norm(answers["grad"]) < 2000 * np.linalg.norm(ordinary["grad"])


def test_only_standard_operators_and_no_traces():
    for model in ("vit", "conv"):
        _, _, program, _ = exported(model)
        assert {(o.domain, o.version) for o in program.opset_import} == {("", 18)}
        assert not any(n.domain or n.doc_string or n.metadata_props for n in program.graph.node)
        assert b".py" not in program.SerializeToString()


def test_weights_are_there_once():
    """torch's exporter folds transposes of up to 8192 numbers into second copies; weights that matter are larger."""
    network = networks.TinyVit(width=96, depth=1)
    program = graph.build(losses.guidance(network, (0.5,) * 3, (0.5,) * 3), contracts.guidance(32, 16))
    held = sum(int(np.prod(t.dims)) for t in program.graph.initializer)
    assert held < 1.1 * sum(p.numel() for p in network.parameters())

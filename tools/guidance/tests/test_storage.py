"""What smaller files cost in accuracy."""

import numpy as np
import pytest

from guidance import storage
from guidance.errors import ModelError
from guidance.runtime import Session
from guidance.selftest import cosine
from tests.conftest import exported, feeds, off


# Convolutions have few numbers a row, and want fp16.
BOUNDS = {
    ("vit", "fp16"): (3e-3, 0.99999),
    ("vit", "int8"): (5e-2, 0.9995),
    ("conv", "fp16"): (3e-3, 0.99999),
    ("conv", "int8"): (0.12, 0.995),
}


@pytest.mark.parametrize("model, mode", BOUNDS)
def test_gradient_stays(model, mode):
    most_off, least_cosine = BOUNDS[model, mode]
    given, _, program, session = exported(model)
    stored = Session(storage.store(program, mode).SerializeToString())
    arrays = feeds(given, 2, True)
    full, small = session.run(arrays), stored.run(arrays)
    assert off(small["grad"], full["grad"]) < most_off
    assert cosine(small["grad"], full["grad"]) > least_cosine
    assert off(small["loss"], full["loss"]) < most_off


def test_files_shrink():
    _, _, program, _ = exported("vit")
    weights = 4 * sum(int(np.prod(t.dims)) for t in program.graph.initializer)
    assert program.ByteSize() - storage.store(program, "fp16").ByteSize() > 0.4 * weights
    assert program.ByteSize() - storage.store(program, "int8").ByteSize() > 0.55 * weights


def test_fp32_changes_nothing():
    _, _, program, _ = exported("vit")
    assert storage.store(program, "fp32") == program


def test_refuses_what_it_cannot_store():
    _, _, program, _ = exported("vit")
    with pytest.raises(ModelError, match="int4.*fp32, fp16, int8"):
        storage.store(program, "int4")
    broken = type(program)()
    broken.CopyFrom(program)
    largest = max(broken.graph.initializer, key=lambda t: len(t.raw_data))
    values = np.frombuffer(largest.raw_data, np.float32).copy()
    values[0] = np.nan
    largest.raw_data = values.tobytes()
    for mode in ("fp16", "int8"):
        with pytest.raises(ModelError, match="not finite"):
            storage.store(broken, mode)

"""The formula, written once more with whole numbers."""

import numpy as np

from guidance import noise


def mixed(x: int) -> int:
    x ^= x >> 16
    x = x * 0x7FEB352D % 2**32
    x ^= x >> 15
    x = x * 0x846CA68B % 2**32
    return x ^ x >> 16


def test_uniform_is_the_formula():
    for seed in (0, 1, 77):
        wanted = [(mixed((i + seed * 0x9E3779B9) % 2**32) >> 8) / 2**24 for i in range(500)]
        assert noise.uniform(seed, (50, 10)).ravel().tolist() == wanted


def test_it_looks_like_noise():
    values = noise.uniform(1, (100_000,))
    assert 0 <= values.min() and values.max() < 1
    assert abs(values.mean() - 0.5) < 0.01 and abs(values.std() - 12**-0.5) < 0.01
    assert abs(np.corrcoef(values[1:], values[:-1])[0, 1]) < 0.02


def test_a_sketch_sees_what_changes():
    values = noise.signed(4, (3, 40, 40)).astype(np.float64)
    sketch = noise.sketch(values)
    for changed in (values[::-1], values.swapaxes(1, 2), -values, values * 1.1):
        assert np.linalg.norm(noise.sketch(changed) - sketch) > 0.05 * np.linalg.norm(sketch)
    assert noise.sketch(np.array([2.0])).shape == (1,)
